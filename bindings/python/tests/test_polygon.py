# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What polygons are made from, what they tell, and what they refuse."""

from __future__ import annotations

import copy
import json
import math
import pickle
from array import array
from collections.abc import Mapping
from ctypes import c_double
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from shapes import BOW_TIE, BUMPY, NOTCHED, SQUARE, U_SHAPE, points, scaled, star

import gcv

HOLE = [(0.25, 0.25), (0.25, 0.75), (0.75, 0.75), (0.75, 0.25)]
FLAT = array("d", [c for vertex in SQUARE for c in vertex])
ARRAY = np.array(SQUARE)
GEOMETRY = {"type": "Polygon", "coordinates": [[*SQUARE, SQUARE[0]], HOLE]}
FEATURE = {"type": "Feature", "properties": {}, "geometry": GEOMETRY}


class Geometry:
    """An object that knows nothing but its __geo_interface__."""

    def __init__(self, geometry: Mapping[str, Any]) -> None:
        self.__geo_interface__ = geometry


SOURCES: dict[str, Any] = {
    "lists": [list(vertex) for vertex in SQUARE],
    "iterator": (vertex for vertex in SQUARE),
    "fractions": [(Fraction(x), int(y)) for x, y in SQUARE],
    "clockwise and closed": [*SQUARE[::-1], SQUARE[-1]],
    "flat array": FLAT,
    "memoryview": memoryview(FLAT).cast("B").cast("d", [4, 2]),
    "ctypes array": (c_double * 8)(*FLAT),
    "numpy": ARRAY,
    "numpy columns": np.asfortranarray(ARRAY),
    "numpy reversed": ARRAY[::-1],
    "numpy every third": np.repeat(ARRAY, 3, axis=0)[1::3],
    "numpy two columns of seven": np.repeat(ARRAY, (3, 4), axis=1)[:, 1::4],
    "numpy swapped columns": ARRAY[:, ::-1],
    "numpy float32": ARRAY.astype(np.float32),
    "numpy integers": ARRAY.astype(np.uint8),
    "numpy other byte order": ARRAY.astype(ARRAY.dtype.newbyteorder()),
    "shapely": shapely.Polygon(SQUARE, [HOLE]),
    "shapely ring": shapely.LinearRing(SQUARE),
    "shapely with elevations": shapely.Polygon([(x, y, 7) for x, y in SQUARE]),
    "shapely of one part": shapely.MultiPolygon([shapely.Polygon(SQUARE)]),
    "geo interface": Geometry(GEOMETRY),
    "feature": Geometry(FEATURE),
    "collection": {"type": "FeatureCollection", "features": [FEATURE]},
    "mapping": GEOMETRY,
    "text": "Polygon((0 0, 1 0, 1 1, 0 1, 0 0), (.25 .25, .25 .75, .75 .75))",
    "text with elevations": "POLYGON Z((0 0 1, 1 0 -1e5, 1 1 nan, 0 1 7))",
    "text with measures": " polygonzm ( (0 0 1 2,1 0 1 2,1 1 3 4,0 1 7 0 ) )",
    "text of shapely": shapely.Polygon([(x, y, 7) for x, y in SQUARE]).wkt,
    "text of one part": "multipolygon ( ((0 0, 1 0, 1 1, 0 1) , (.2 .2, .2 .7, .7 .7)) ) ",
    "text of one part with elevations": "MULTIPOLYGON Z (((0 0 1, 1 0 1, 1 1 nan, 0 1 7)))",
    "bytes": b"POLYGON ((0 0, 1 0, 1 1, 0 1))",
    "GeoJSON": json.dumps(GEOMETRY),
    "GeoJSON bytes": b" " + json.dumps({"type": "Feature", "geometry": GEOMETRY}).encode(),
    "array without a mask": np.ma.masked_equal(SQUARE, 7),
    "polygon": gcv.Polygon(SQUARE),
    "outer face": gcv.minkowski_sum(ARRAY / 2, ARRAY / 2),
}


@pytest.mark.parametrize("name", SOURCES)
def test_source(name: str) -> None:
    polygon = gcv.Polygon(SOURCES[name])
    assert points(polygon) == SQUARE
    assert gcv.Polygon(polygon) == polygon
    assert pickle.loads(pickle.dumps(polygon)) == polygon


LINE = shapely.LineString(SQUARE)
HUGE_NUMBER = 10**5000


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        (5, "5 is not a polygon, and none can be made from it"),
        (None, "None is not a polygon, and none can be made from it"),
        (object(), "<object .*> is not a polygon, .*"),
        ([1, 2, 3], "vertex 0: 1 is not a pair of numbers"),
        ([(0, 0, 0)], r"vertex 0: \(0, 0, 0\) is not a pair of numbers"),
        (["ab", "cd", "ef"], "vertex 0: 'ab' is not a pair of numbers"),
        ([b"ab", b"cd", b"eg"], "vertex 0: b'ab' is not a pair of numbers"),
        ([(0, 0), (1, 0), bytearray(2)], "vertex 2: bytearray.* is not a pair of numbers"),
        ([(0, 0), None], "vertex 1: None is not a pair of numbers"),
        ([(0, 0), (10**400, 0)], r"vertex 1: \(100.*\) is not a number that a finite float .*"),
        ([(0, HUGE_NUMBER)], "vertex 0: an object of type tuple is not a number .*"),
        (array("d", [0, 0, 1]), r"a buffer of shape \(3,\) does not hold pairs of numbers"),
        (memoryview(bytes(96)).cast("d", [4, 3]), "a buffer of shape .* does not hold pairs .*"),
        (np.zeros((4, 2, 2)), "a buffer of shape .* does not hold pairs of numbers"),
        (np.float64(1), "a buffer of shape .* does not hold pairs of numbers"),
        (shapely.Point(1, 2), "a geometry of type 'Point' is not a polygon"),
        (LINE, "a geometry of type 'LineString' is not a polygon"),
        (
            shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(2, 0, 3, 1)]),
            "a MultiPolygon of 2 parts is not one polygon",
        ),
        (shapely.MultiPolygon(), "a MultiPolygon of 0 parts is not one polygon"),
        ({"coordinates": SQUARE}, "{'coordinates': .*} is not a geometry"),
        ({"type": "Polygon"}, "a Polygon without coordinates is not a polygon"),
        ({"type": "Polygon", "coordinates": [5]}, "5 is not a polygon, .*"),
        ({"type": "Polygon", "coordinates": [[5]]}, "vertex 0: 5 is not a pair of numbers"),
        (
            {"type": "Polygon", "coordinates": [SQUARE, [(0, 0), (1,)]]},
            r"vertex 1 of ring 1: \(1,\) is not a pair of numbers",
        ),
        ({"type": "Feature", "geometry": None}, "None is not a geometry"),
        (
            {"type": "FeatureCollection", "features": []},
            "a FeatureCollection of 0 parts is not one polygon",
        ),
        (
            "MULTIPOLYGON (((0 0, 1 0, 1 1)), ((2 0, 3 0, 3 1)))",
            "a MultiPolygon of 2 parts is not one polygon",
        ),
        ("MULTIPOLYGON EMPTY", "a MultiPolygon of 0 parts is not one polygon"),
        ("MULTIPOLYGON (((0 0, 1 0, 1 1))", "byte 31: expected .*"),
        ("MULTIPOLYGON ((0 0, 1 0, 1 1))", "a MultiPolygon of 0 parts is not one polygon"),
        ("MULTIPOLYGON", "byte 0: expected POLYGON, found 'MULTIPOLYGON'"),
        ('{"type": "Polygon"', "GeoJSON text: .*"),
        (b"\x01\x03\x00", "byte 0: expected POLYGON, found byte 0x01"),
        ("\ud800", r"byte 0: expected POLYGON, found '\?'"),
        ("POLYGON Z ((0 0 7, 1 0 7, 1 1 7 9))", "byte 30: expected .*"),
        ("POLYGON M ((0 0 7, 1 0 7), (1 1))", "byte 32: hole 1 has 1 vertices, .*"),
        (np.ma.masked_equal(SQUARE, 0), "some elements of the array are masked; .*"),
        (np.ma.masked_equal(np.array(SQUARE, int), 0), "some elements of the array are masked; .*"),
    ],
)
def test_not_a_polygon(source: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^polygon: {reason}$"):
        gcv.Polygon(source)


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        gcv.Polygon(tmp_path / "none.wkt")


def test_properties() -> None:
    polygon = gcv.Polygon([(2, 0), (2, 1), (0, 1), (0, 0), (1, 0), (2, 0)])
    assert points(polygon) == [(0, 0), (2, 0), (2, 1), (0, 1)]
    assert polygon.area == 2
    assert polygon.bounds == (0, 0, 2, 1)
    assert len(polygon) == 4
    assert repr(polygon) == "<gcv.Polygon of 4 vertices>"
    assert shapely.geometry.shape(polygon).equals(shapely.box(0, 0, 2, 1))


def test_vertices_are_never_copied_or_changed() -> None:
    polygon = gcv.Polygon(SQUARE)
    vertices = polygon.vertices
    assert vertices.dtype == np.float64
    assert np.shares_memory(vertices, polygon.vertices)
    assert np.shares_memory(vertices, np.asarray(polygon))
    with pytest.raises(ValueError, match="read-only"):
        vertices[0, 0] = 1
    del polygon
    assert vertices.tolist() == [list(vertex) for vertex in SQUARE]


def test_equality() -> None:
    polygon = gcv.Polygon(SQUARE)
    same = gcv.Polygon([(-0.0, 1), (1, 1), (1, 0.5), (1, 0), (0, -0.0)])
    assert polygon == same
    assert hash(polygon) == hash(same)
    assert polygon != gcv.Polygon(U_SHAPE)
    assert polygon != SQUARE
    assert len({polygon, same, gcv.Polygon(U_SHAPE)}) == 2


def test_copies() -> None:
    polygon = gcv.Polygon(SQUARE)
    assert copy.copy(polygon) is polygon
    assert copy.deepcopy([polygon])[0] is polygon


@pytest.mark.parametrize(
    "source",
    [NOTCHED[::-1], np.array(NOTCHED), "POLYGON((8 6,3 1 , 0 7,0 0,8 0, 8 6),(1 1,2 1,1 2))"],
)
def test_numbers_survive(source: Any) -> None:
    polygon = gcv.Polygon(source)
    sources = gcv.minkowski_sum(polygon, SQUARE).sources
    pickled = pickle.loads(pickle.dumps(polygon))
    assert gcv.minkowski_sum(pickled, SQUARE).sources == sources
    reflected = gcv.no_fit_polygon(SQUARE, polygon, (0, 0)).sources
    assert gcv.minkowski_sum(SQUARE, -polygon).sources == reflected


def test_negative() -> None:
    assert points(-gcv.Polygon(SQUARE)) == [(-1, -1), (0, -1), (0, 0), (-1, 0)]
    notched = gcv.Polygon(NOTCHED)
    reflected = -notched
    assert reflected != notched
    assert -reflected == notched


def test_simplified() -> None:
    polygon = gcv.Polygon(BUMPY)
    near, bound = polygon.simplified(0.2)
    assert points(near) == [(0, 0), (4, 0), (4, 4), (0, 4)]
    assert 0.125 <= bound < 0.125 + 1e-12
    assert polygon.simplified(0.01) == (polygon, 0)
    assert polygon.simplified(0) == (polygon, 0)


@pytest.mark.parametrize("tolerance", [1e-3, 0.05, np.float32(0.3), 1, 1e308])
def test_simplified_is_within_the_tolerance(tolerance: float) -> None:
    polygon = star(200, 1)
    near, bound = polygon.simplified(tolerance)
    around, bound_around = polygon.simplified(tolerance, rounding="outward")
    assert set(points(near)) <= set(points(polygon))
    before, after, outside = (shapely.geometry.shape(p) for p in (polygon, near, around))
    assert after.exterior.hausdorff_distance(before.exterior) <= bound + 1e-12
    assert outside.exterior.hausdorff_distance(before.exterior) <= bound_around + 1e-12
    assert max(bound, bound_around) <= tolerance
    assert outside.buffer(1e-12).contains(before)


def test_simplified_is_a_polygon_like_others() -> None:
    near = star(200, 1).simplified(0.3).polygon
    assert len(near) < 100
    again = pickle.loads(pickle.dumps(near))
    assert again == near == gcv.Polygon(near.vertices)
    assert (again + near).sources == (near + near).sources
    assert near + -near == gcv.no_fit_polygon(near, near, (0, 0))


@pytest.mark.parametrize("tolerance", [-1, math.nan, math.inf])
def test_simplified_refused(tolerance: float) -> None:
    polygon = gcv.Polygon(BUMPY)
    with pytest.raises(gcv.InputError, match="tolerance"):
        polygon.simplified(tolerance)
    with pytest.raises(ValueError, match="rounding is 'up'"):
        polygon.simplified(1, rounding="up")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("source", "name"),
    [
        ([(0, 0), (1, math.nan), (0, 1)], "GCV_ERR_NOT_FINITE"),
        ([(0, 0), (1, 0), (-math.inf, 1)], "GCV_ERR_NOT_FINITE"),
        ("POLYGON ((0 0, 1e999 0, 1 1))", "GCV_ERR_NOT_FINITE"),
        ([], "GCV_ERR_DEGENERATE"),
        ("POLYGON EMPTY", "GCV_ERR_DEGENERATE"),
        (shapely.Polygon(), "GCV_ERR_DEGENERATE"),
        ([(0, 0), (1, 1), (2, 2)], "GCV_ERR_DEGENERATE"),
        (BOW_TIE, "GCV_ERR_NOT_SIMPLE"),
        ("POLYGON ((0 0, 1 0", "GCV_ERR_PARSE"),
    ],
)
def test_refused(source: Any, name: str) -> None:
    with pytest.raises(gcv.InputError) as raised:
        gcv.Polygon(source)
    error = raised.value
    assert isinstance(error, ValueError)
    assert error.status_name == name
    assert str(error)
    duplicate = pickle.loads(pickle.dumps(error))
    assert (duplicate.status, str(duplicate)) == (error.status, str(error))


def test_area_out_of_range() -> None:
    huge = scaled(SQUARE, 1e200)
    with pytest.raises(gcv.Error, match="area") as raised:
        huge.area  # noqa: B018
    assert raised.value.status_name == "GCV_ERR_RANGE"


def test_marks_of_encodings(tmp_path: Path) -> None:
    file = tmp_path / "triangle.wkt"
    text = "POLYGON ((0 0, 4 0, 4 4, 0 0))"
    for source in (
        text,
        json.dumps({"type": "Polygon", "coordinates": [[(0, 0), (4, 0), (4, 4), (0, 0)]]}),
    ):
        file.write_text(source, encoding="utf-8-sig")
        assert gcv.Polygon(file).area == gcv.Polygon("\ufeff" + source).area == 8
        assert [polygon.area for polygon in gcv.Polygon.many(file)] == [8]
        file.write_text(source, encoding="utf-16")
        with pytest.raises(gcv.InputError, match=r"triangle\.wkt: text in UTF-16, not UTF-8"):
            gcv.Polygon(file)
        with pytest.raises(gcv.InputError, match="UTF-16"):
            gcv.Polygon.many(file)
    file.write_text(text[:-2])
    with pytest.raises(gcv.InputError, match=r"polygon: .*triangle\.wkt: byte "):
        gcv.Polygon(file)


def test_geometries_in_themselves() -> None:
    feature: dict[str, Any] = {"type": "Feature"}
    feature["geometry"] = feature
    with pytest.raises(gcv.InputError, match="a Feature that is in itself"):
        gcv.Polygon(feature)


def test_rings_in_place_of_points() -> None:
    with pytest.raises(gcv.InputError, match="is not a pair of numbers: it is a ring; pass holes"):
        gcv.Polygon([SQUARE, HOLE])  # type: ignore[list-item]

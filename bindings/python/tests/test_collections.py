# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Many polygons from one source that has several: a geometry, or text."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import shapely
from shapely.geometry import mapping
from shapes import BOW_TIE, FRAME, NOTCHED, ROOMS, SQUARE, TRIANGLE, box

import gcv

POLYGONS = [gcv.Polygon(NOTCHED), FRAME, gcv.Polygon(box(20, 0, 21, 1))]
WKT = " ".join(polygon.wkt for polygon in POLYGONS)
MULTI = shapely.MultiPolygon([shapely.geometry.shape(polygon) for polygon in POLYGONS])
POINT = {"type": "Point", "coordinates": [1, 2]}
GEOMETRIES = [dict(polygon.__geo_interface__) for polygon in POLYGONS]
FEATURES = [{"type": "Feature", "properties": {}, "geometry": one} for one in GEOMETRIES]
FEATURE_COLLECTION = {"type": "FeatureCollection", "features": FEATURES}
COLLECTION = {"type": "GeometryCollection", "geometries": [POINT, *GEOMETRIES]}


RINGS = [SQUARE, BOW_TIE, TRIANGLE]


class WithInterface:
    __geo_interface__ = FEATURE_COLLECTION


@pytest.mark.parametrize(
    "source",
    [
        FEATURE_COLLECTION,
        {"type": "FeatureCollection", "features": tuple(FEATURES)},
        COLLECTION,
        {"type": "Feature", "geometry": COLLECTION},
        {
            "type": "FeatureCollection",
            "features": [{"type": "Feature", "geometry": None}, *FEATURES[:1], *FEATURES[1:]],
        },
        mapping(MULTI),
        WithInterface(),
        MULTI,
        shapely.GeometryCollection([*MULTI.geoms, shapely.Point(1, 2)]),
        shapely.GeometryCollection([MULTI]),
        WKT,
        WKT.encode(),
        bytearray(WKT.encode()),
        MULTI.wkt,
        shapely.force_3d(MULTI, 7),
        shapely.GeometryCollection([*MULTI.geoms, shapely.LineString([(0, 0), (1, 1)])]).wkt,
        json.dumps(FEATURE_COLLECTION),
        json.dumps(COLLECTION).encode(),
    ],
)
def test_collections(tmp_path: Path, source: Any) -> None:
    made = gcv.Polygon.many(source)
    assert isinstance(made, gcv.ResultList)
    assert made == POLYGONS
    assert gcv.minkowski_sum_many(source, POLYGONS) == [one + one for one in POLYGONS]
    if isinstance(source, (str, bytes)):
        file = tmp_path / "file"
        file.write_bytes(source.encode() if isinstance(source, str) else source)
        assert gcv.Polygon.many(file) == POLYGONS


@pytest.mark.parametrize(
    "source",
    [
        POLYGONS[0],
        POLYGONS[0].wkt,
        GEOMETRIES[0],
        FEATURES[0],
        MULTI.geoms[0],
        gcv.Polygon(NOTCHED) + gcv.Polygon([(0, 0), (0.5, 0), (0, 0.5)]),
    ],
)
def test_collections_of_one(source: Any) -> None:
    assert gcv.Polygon.many(source) == [gcv.Polygon(source)]


@pytest.mark.parametrize(
    "source",
    [
        {"type": "FeatureCollection", "features": []},
        shapely.MultiPolygon(),
        shapely.GeometryCollection(),
        "MULTIPOLYGON EMPTY",
        "",
    ],
)
def test_collections_of_none(source: Any) -> None:
    assert gcv.Polygon.many(source) == []


def test_numbers_of_a_collection_are_those_as_passed() -> None:
    (polygon,) = gcv.Polygon.many({"type": "MultiPolygon", "coordinates": [[[*SQUARE, (0, 0.5)]]]})
    (contact, *_) = gcv.contacts(polygon, TRIANGLE, (0.5, 1))
    assert contact.a == 2
    (same,) = gcv.Polygon.many(polygon)
    assert same == polygon
    assert gcv.contacts(same, TRIANGLE, (0.5, 1))[0] == contact


def test_regions() -> None:
    region = gcv.no_fit_region(ROOMS, box(0, 0, 2, 2))
    assert gcv.Polygon.many(region) == list(region)
    assert gcv.Polygon.many(region.wkt) == list(region)
    assert gcv.Polygon.many(region.__geo_interface__) == list(region)


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        (f"{POLYGONS[0].wkt} {gcv.Polygon(SQUARE).wkt[:-3]}", r"polygon 1: byte \d+: expected"),
        ("GEOMETRYCOLLECTION (POINT (1 1)", "sources: byte 31: expected ',' or '[)]'"),
        ('{"type": ', "sources: GeoJSON text: "),
        ("{" + '"a":{' * 100000, "sources: GeoJSON text: "),
        (POINT, "polygon 0: a geometry of type 'Point' is not a polygon"),
        ({"a": 1}, r"polygon 0: {'a': 1} is not a geometry"),
        (
            {"type": "MultiPolygon"},
            "polygon 0: a MultiPolygon without coordinates is not a polygon",
        ),
        (
            {"type": "FeatureCollection"},
            "polygon 0: a FeatureCollection without features is not a polygon",
        ),
        (
            {"type": "MultiPolygon", "coordinates": [[SQUARE], [BOW_TIE]]},
            "polygon 1: edges 0 and 2 meet",
        ),
    ],
)
def test_what_is_wrong_is_named(source: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{reason}"):
        gcv.Polygon.many(source)


def test_errors_in_their_places() -> None:
    wrong = {"type": "MultiPolygon", "coordinates": [[ring] for ring in RINGS]}
    text = ", ".join(f"(({', '.join(f'{x} {y}' for x, y in r)}))" for r in RINGS)
    for source in (wrong, f"MULTIPOLYGON ({text})"):
        first, error, last = gcv.Polygon.many(source, return_errors=True)
        assert (first, last) == (gcv.Polygon(SQUARE), gcv.Polygon(TRIANGLE))
        assert isinstance(error, gcv.InputError)
        assert str(error).startswith("polygon 1: edges 0 and 2 meet")
    faces = gcv.minkowski_sum_many(wrong, [SQUARE] * 3, return_errors=True)
    assert str(faces[1]).startswith("a[1]: edges 0 and 2 meet")
    nested: Any = {"type": "GeometryCollection", "geometries": []}
    for _ in range(100000):
        nested = {"type": "GeometryCollection", "geometries": [nested]}
    with pytest.raises(gcv.InputError, match=r"^sources: this is nested too deeply$"):
        gcv.Polygon.many(nested)


EMPTY: Any = {"type": "Polygon", "coordinates": []}


@pytest.mark.parametrize(
    "source",
    [
        f"MULTIPOLYGON (EMPTY, {FRAME.wkt[8:]})",
        f"MultiPolygon Z (empty,EMPTY , {FRAME.wkt[8:]}, EMPTY,EMPTY ) ",
        f"GEOMETRYCOLLECTION (GEOMETRYCOLLECTION (MULTIPOLYGON ({FRAME.wkt[8:]}, EMPTY)))",
        shapely.from_wkt(f"MULTIPOLYGON (EMPTY, {FRAME.wkt[8:]})"),
        {"type": "MultiPolygon", "coordinates": [[], GEOMETRIES[1]["coordinates"], [[]]]},
    ],
)
def test_empty_parts_are_left_out(source: Any) -> None:
    assert gcv.Polygon(source) == FRAME
    assert gcv.Polygon.many(source) == [FRAME]


def test_empty_members_are_left_out() -> None:
    members = {"type": "GeometryCollection", "geometries": [EMPTY, GEOMETRIES[1], EMPTY]}
    assert gcv.Polygon.many(members) == [FRAME]
    (error,) = gcv.Polygon.many(EMPTY, return_errors=True)
    assert "at least 3 are needed" in str(error)


def test_collections_of_one_are_polygons() -> None:
    for collection in (
        f"GEOMETRYCOLLECTION ({FRAME.wkt})",
        f" GeometryCollection(GEOMETRYCOLLECTION ( {FRAME.wkt} ) ) ",
        shapely.GeometryCollection([MULTI.geoms[1]]),
        shapely.GeometryCollection([shapely.GeometryCollection([MULTI.geoms[1]])]),
        {"type": "GeometryCollection", "geometries": [GEOMETRIES[1]]},
        {
            "type": "Feature",
            "geometry": {"type": "GeometryCollection", "geometries": FEATURES[1:2]},
        },
    ):
        assert gcv.Polygon(collection) == FRAME


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        ({"type": "Polygon"}, "polygon: a Polygon without coordinates is not a polygon"),
        ({"type": "LinearRing"}, "polygon: a LinearRing without coordinates is not a polygon"),
        ({"type": "GeometryCollection"}, "polygon: a GeometryCollection without geometries is"),
        ({"type": "Polygon", "coordinates": None}, "polygon: None in a geometry is not a list"),
        ("MULTIPOLYGON (EMPTY, EMPTY)", "polygon: a MultiPolygon of 0 parts is not one polygon"),
        ("MULTIPOLYGON (EMPTY EMPTY, ((0 0, 1 0, 0 1)))", "polygon: byte 20: expected"),
        ("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1))", "polygon: byte 45: expected '[)]'"),
        ("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1))) x", "polygon: byte 47: .* found 'x'"),
        ("MULTIPOLYGON (((0 0, 1 0, 0 1))) x", "polygon: byte 33: .* found 'x'"),
        ("MULTIPOLYGON (((0 0, 1 0, 0 1))) )", "polygon: byte 31: .* found '[)]'"),
        ("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 a)))", "polygon: byte 42: expected"),
        (
            f"GEOMETRYCOLLECTION (POINT (1 1), {FRAME.wkt})",
            "polygon: a GeometryCollection of 1 POINT, 1 POLYGON is not one polygon; Polygon.many",
        ),
        (gcv.Scene(), "polygon: <gcv.Scene of 0 members> is not a polygon but a scene"),
    ],
)
def test_what_is_no_polygon(source: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{reason}"):
        gcv.Polygon(source)


def test_scenes_are_no_polygons() -> None:
    scene = gcv.Scene()
    scene.add(SQUARE)
    with pytest.raises(gcv.InputError, match=r"^container: <gcv.Scene of 1 member> is not a"):
        gcv.Scene(scene)  # type: ignore[arg-type]
    with pytest.raises(gcv.InputError, match=r"^b: <gcv.Scene of 1 member> is not a polygon but"):
        gcv.relation(SQUARE, scene)  # type: ignore[arg-type]

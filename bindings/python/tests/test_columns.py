# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Columns of polygons: of GeoPandas, and Arrow arrays in the manner of GeoArrow."""

from __future__ import annotations

import copy
import importlib.util
import json
import pickle
import subprocess
import sys
from typing import Any, Callable

import numpy as np
import pytest
from shapes import FRAME, NOTCHED, ROOMS, SQUARE, SQUARE_2, U_SHAPE

import gcv

geopandas = pytest.importorskip(
    "geopandas", reason="GeoPandas is not installed: no test of columns"
)
pyarrow = pytest.importorskip("pyarrow", reason="pyarrow is not installed: no test of columns")
shapely = pytest.importorskip("shapely", reason="shapely is not installed: no test of columns")

SOURCES: list[Any] = [FRAME, U_SHAPE, ROOMS]
POLYGONS = list(map(gcv.Polygon, SOURCES))
OTHERS = list(map(gcv.Polygon, (SQUARE, SQUARE_2, NOTCHED)))
CRS = "EPSG:25832"
FUNCTIONS = [
    *(gcv.minkowski_sum_many, gcv.no_fit_polygon_many),
    *(gcv.minkowski_sum_region_many, gcv.no_fit_region_many),
]


def series(polygons: list[Any], index: Any = None, crs: Any = CRS) -> Any:
    geometries = [
        p and (shapely.geometry.shape(p) if isinstance(p, gcv.Polygon) else p) for p in polygons
    ]
    return geopandas.GeoSeries(geometries, index=index, crs=crs)


A, B = series(POLYGONS, list("xyz")), series(OTHERS, list("xyz"))


def arrow(column: Any, encoding: str = "geoarrow", *, interleaved: bool = True) -> Any:
    return column.to_arrow(geometry_encoding=encoding, interleaved=interleaved)


@pytest.mark.parametrize("function", FUNCTIONS)
def test_geopandas(function: Callable[..., Any]) -> None:
    expected = function(POLYGONS, OTHERS)
    for a, b in ((A, B), (A.array, B), (A.to_frame("geometry"), B), (A, OTHERS), (POLYGONS, B)):
        results = function(a, b)
        assert results == expected
        made = results.to_geoseries()
        assert made.index.tolist() == list("xyz")
        assert made.crs == results.crs == CRS
        assert [gcv.Polygon(one) for one in made] == [gcv.Polygon(result.wkt) for result in results]
    results = function(A.array, B.array)
    assert results.labels is None
    assert results.to_geoseries().index.tolist() == [0, 1, 2]


def test_polygons_of_columns() -> None:
    for column in (A, A.array, A.to_frame("geometry"), arrow(A), arrow(A, "WKB")):
        made = gcv.Polygon.many(column)
        assert made == POLYGONS
        assert [polygon._given for polygon in made] == [gcv.Polygon(one)._given for one in A]
        assert made.to_geoseries().geom_equals(A.reset_index(drop=True), align=False).all()
    scene = gcv.Scene()
    assert scene.add(A, [(0, 0), (99, 0), (999, 0)]).tolist() == [2, 3, 4]
    assert scene.polygon(4) == POLYGONS[2]


def test_elevations_and_parts_of_one() -> None:
    parts = shapely.from_wkt(f"MULTIPOLYGON (EMPTY, {POLYGONS[2].wkt[8:]}, EMPTY)")
    column = series([shapely.force_3d(A.iloc[0], 7), parts])
    for one in (column, arrow(column, "WKB")):
        assert gcv.Polygon.many(one) == [POLYGONS[0], POLYGONS[2]]
    assert gcv.Polygon.many(arrow(column[:1])) == POLYGONS[:1]
    assert gcv.Polygon.many(arrow(column[:1], interleaved=False)) == POLYGONS[:1]


@pytest.mark.parametrize("interleaved", [True, False])
@pytest.mark.parametrize("encoding", ["geoarrow", "WKB"])
def test_arrow(encoding: str, interleaved: bool) -> None:
    a = arrow(A, encoding, interleaved=interleaved)
    results = gcv.minkowski_sum_many(a, B.array)
    assert results == gcv.minkowski_sum_many(POLYGONS, OTHERS)
    assert results.to_geoseries().crs == CRS
    array = pyarrow.array(a)
    chunks = pyarrow.chunked_array([array[1:], array[:1]])
    for some in (array, array[1:], array[2:], array[:0], chunks):
        many = gcv.Polygon.many(some)
        assert many == gcv.Polygon.many(geopandas.GeoSeries.from_wkb(_binaries(some)))


def _binaries(array: Any) -> Any:
    """An Arrow array as Well-Known Binary."""
    storage = array.type
    if pyarrow.types.is_binary(storage):
        return array.to_pylist()
    field = pyarrow.field("", storage, metadata={"ARROW:extension:name": "geoarrow.polygon"})
    chunks = array.chunks if isinstance(array, pyarrow.ChunkedArray) else [array]
    return [
        binary
        for chunk in chunks
        for binary in geopandas.GeoSeries.from_arrow(_Column(field, chunk)).to_wkb()
    ]


class _Column:
    """An array with a field, as others export it."""

    def __init__(self, field: Any, array: Any) -> None:
        self.field, self.array = field, array

    def __arrow_c_array__(self, requested_schema: object = None) -> Any:
        return self.field.__arrow_c_schema__(), self.array.__arrow_c_array__()[1]


def test_text_and_storage() -> None:
    texts = ["POLYGON ((0 0, 1 0, 1 1, 0 1))", None, "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "no"]
    for of in ("string", "large_string", "string_view"):
        first, *wrong, last = gcv.Polygon.many(pyarrow.array(texts[:3], of), return_errors=True)
        assert [first, last] == OTHERS[:2]
        assert str(wrong[0]).startswith("polygon 1: None is not a polygon")
    binaries = [*map(bytes, A.to_wkb()), None, b"no"]
    for of in ("binary", "large_binary", "binary_view"):
        made = gcv.Polygon.many(pyarrow.array(binaries, of), return_errors=True)
        assert made[:3] == POLYGONS
        assert str(made[3]).startswith("polygon 3: None is not a polygon")
        assert str(made[4]) == "polygon 4: this is no Well-Known Binary"


def test_registered_extension_types() -> None:
    if importlib.util.find_spec("geoarrow") is None:
        pytest.skip("geoarrow-pyarrow is not installed: its types are not tested")
    code = """if True:
        import geoarrow.pyarrow, pyarrow, geopandas, shapely, gcv
        boxes = geopandas.GeoSeries(shapely.box(0, 0, [1, 2], 1), crs=25832)
        for encoding in ("geoarrow", "WKB"):
            array = pyarrow.array(boxes.to_arrow(geometry_encoding=encoding))
            assert array.type.extension_name.startswith("geoarrow."), array.type
            for one in (array, pyarrow.chunked_array([array])):
                sums = gcv.minkowski_sum_many(one, one)
                assert sums.to_geoseries().crs == 25832
                assert pyarrow.array(sums).type.extension_name == "geoarrow.polygon"
                assert geoarrow.pyarrow.as_wkt(pyarrow.array(sums)).to_pylist()[1] == (
                    "POLYGON ((0 0, 4 0, 4 2, 0 2, 0 0))"
                )
    """
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("function", FUNCTIONS)
def test_arrow_out(function: Callable[..., Any]) -> None:
    is_region = "region" in function.__name__
    results = function(A, B)
    made = geopandas.GeoSeries.from_arrow(results)
    assert made.crs == CRS
    assert made.geom_equals(results.to_geoseries().reset_index(drop=True), align=False).all()
    assert set(made.geom_type) == {"MultiPolygon" if is_region else "Polygon"}
    assert gcv.Polygon.many(made) == gcv.Polygon.many([result.wkt for result in results])
    # What came from Arrow keeps its reference system.
    again = function(arrow(A), OTHERS)
    assert geopandas.GeoSeries.from_arrow(again).crs == CRS
    empty = pyarrow.array(function([], []))
    assert len(empty) == 0
    assert str(empty.type).startswith("list<polygons: " if is_region else "list<rings: ")
    assert len(function([], []).to_geoseries()) == 0


def test_regions_of_many_polygons() -> None:
    gap = [(0, 0), (9, 0), (9, 9), (0, 9)]
    regions = gcv.ResultList(
        [
            gcv.no_fit_region(ROOMS, SQUARE_2),
            gcv.offset([(0, 0), (4, 0), (4, 1), (6, 1), (6, 0), (9, 0), (9, 3), (0, 3)], -1, 0.1),
            gcv.offset(gap, -5, 0.1),
        ],
        of_regions=True,
    )
    for made in (regions.to_geoseries(), geopandas.GeoSeries.from_arrow(regions)):
        assert [one.wkt for one in made][2] == "MULTIPOLYGON EMPTY"
        assert [len(one.geoms) for one in made] == [len(region) for region in regions]
        assert [one.area for one in made] == pytest.approx([region.area for region in regions])


def test_missing_and_wrong_rows() -> None:
    box = shapely.box(0, 0, 1, 1)
    wrong = [
        *(None, shapely.Polygon(), shapely.Point(0, 0), shapely.MultiPolygon([box, A.iloc[0]])),
        *(shapely.MultiPolygon(), shapely.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)])),
    ]
    reasons = [
        *("None is not a polygon", "0 distinct", "a geometry of type 'Point' is not a polygon"),
        *("a MultiPolygon of 2 parts is", "a MultiPolygon of 0 parts is", "edges 0 and 2 meet"),
    ]
    column = series([box, *wrong], list("abcdefg"))
    results = gcv.minkowski_sum_many(column, [SQUARE] * 7, return_errors=True)
    for k, reason in enumerate(reasons, 1):
        assert isinstance(results[k], gcv.InputError)
        assert str(results[k]).startswith(f"a[{k}], index {'abcdefg'[k]!r}: {reason}")
        with pytest.raises(gcv.InputError, match=rf"^moving\[0\], index {k + 5}: "):
            gcv.no_fit_region_many([SQUARE], series([wrong[k - 1]], [k + 5]))
        with pytest.raises(gcv.InputError, match=r"^polygon 0: "):
            gcv.Polygon.many(series([wrong[k - 1]]))
    made = results.to_geoseries()
    assert made.isna().tolist() == geopandas.GeoSeries.from_arrow(results).isna().tolist()
    assert made.isna().tolist() == [False] + [True] * 6
    assert pyarrow.array(results).null_count == 6
    # Missing rows of Arrow arrays, and what can be read of them again.
    column = series([box, None, A.iloc[0]])
    for one in (arrow(column), arrow(column, interleaved=False), arrow(column, "WKB")):
        first, error, last = gcv.Polygon.many(one, return_errors=True)
        assert [first, last] == [gcv.Polygon(box), POLYGONS[0]]
        assert str(error).startswith("polygon 1: None is not a polygon")


XY = pyarrow.list_(pyarrow.field("xy", "double"), 2)
STRUCT = pyarrow.struct([("x", "double"), ("y", "double")])
CORNER: list[Any] = [[0, 0], [1, 0], [1, 1], [0, 1]]


@pytest.mark.parametrize("vertex", [XY, STRUCT])
@pytest.mark.parametrize(
    "rings",
    [
        [[[5, 5], None, [9, 5], [7, 9]]],
        [[[5, 5], [7, None], [9, 5], [7, 9]]],
        [[[None, 5], [7, 5], [9, 5], [7, 9]]],
        [CORNER, None],
        [None],
    ],
)
def test_nulls_inside_of_rows(vertex: Any, rings: Any) -> None:
    def laid_out(vertex_of_row: Any) -> Any:
        if vertex == XY or vertex_of_row is None:
            return vertex_of_row
        return dict(zip("xy", vertex_of_row))

    rows = [None, [CORNER], rings, [[]], [CORNER]]
    rows = [row and [ring and list(map(laid_out, ring)) for ring in row] for row in rows]
    polygons = pyarrow.array(rows, pyarrow.list_(pyarrow.list_(vertex)))
    parts = pyarrow.array([row and [row] for row in rows], pyarrow.list_(polygons.type))
    for column, first in ((polygons, 0), (parts, 0), (polygons[1:], 1), (parts[1:], 1)):
        made = gcv.Polygon.many(column, return_errors=True)
        assert [made[1 - first], made[4 - first]] == [gcv.Polygon(SQUARE)] * 2
        assert str(made[2 - first]) == (
            f"polygon {2 - first}: a ring, a vertex or a coordinate of it is null"
        )


def test_pairs_that_fail() -> None:
    huge = shapely.box(0, 0, 1e308, 1e308)
    with pytest.raises(gcv.Error, match=r"^pair 1, index 'y': "):
        gcv.minkowski_sum_many(
            series([A.iloc[0], huge], list("xy")),
            [SQUARE, POLYGONS[0].affine([1e300, 0, 0, 0, 1e307, 0])],
        )


def test_columns_that_do_not_fit() -> None:
    with pytest.raises(gcv.InputError, match=r"^a and b have different indexes: "):
        gcv.minkowski_sum_many(A, B.reset_index(drop=True))
    with pytest.raises(gcv.InputError, match=r"^fixed and moving have different coordinate ref"):
        gcv.no_fit_polygon_many(A, B.to_crs(4326))
    with pytest.raises(gcv.InputError, match=r"^a and b have different coordinate ref"):
        gcv.minkowski_sum_many(arrow(A), arrow(B.to_crs(4326)))
    assert gcv.minkowski_sum_many(A, B.set_crs(None, allow_override=True)).crs == CRS
    with pytest.raises(ValueError, match=r"^a has 3 polygons, b has 2$"):
        gcv.minkowski_sum_many(A, B.iloc[:2].array)


def test_other_arrow_arrays() -> None:
    points = arrow(series([shapely.Point(0, 0)]))
    with pytest.raises(
        gcv.InputError, match=r"^b: an Arrow array of geoarrow.point has no polygons$"
    ):
        gcv.minkowski_sum_many([SQUARE], points)
    for wrong in (pyarrow.array([1, 2]), pyarrow.table({"a": [1]}), pyarrow.array([[[1.0]]])):
        with pytest.raises(
            gcv.InputError, match=r"^sources: an Arrow array of type .* has no polyg"
        ):
            gcv.Polygon.many(wrong)
    metadata = {
        "ARROW:extension:name": "geoarrow.wkb",
        "ARROW:extension:metadata": '{"edges": "spherical"}',
    }
    column = _Column(pyarrow.field("", "binary", metadata=metadata), pyarrow.array([b""], "binary"))
    with pytest.raises(
        gcv.InputError, match=r"^sources: the edges of this Arrow array are spherical"
    ):
        gcv.Polygon.many(column)


def test_copies() -> None:
    results = gcv.minkowski_sum_many(A, B)
    again = pickle.loads(pickle.dumps(results))
    assert isinstance(again, gcv.ResultList)
    assert again == results
    for one in (again, copy.copy(results), copy.deepcopy(results)):
        assert one.to_geoseries().equals(results.to_geoseries())
    assert isinstance(results[:2], list)


@pytest.mark.parametrize(
    "change",
    [
        lambda results: results.sort(key=len),
        lambda results: results.reverse(),
        lambda results: results.append(results[0]),
        lambda results: results.insert(0, results[1]),
        lambda results: results.pop(),
        lambda results: results.__delitem__(0),
        lambda results: results.__setitem__(0, results[1]),
        lambda results: results.extend(results[:1]),
    ],
)
def test_changes_in_place_drop_the_index(change: Callable[[Any], object]) -> None:
    results = gcv.Polygon.many(A)
    change(results)
    assert results.labels is None
    assert results.crs is None
    assert len(results.to_geoseries()) == len(results)


def test_results_as_sources() -> None:
    faces = gcv.minkowski_sum_many(A, B)
    again = gcv.no_fit_polygon_many(faces, OTHERS)
    assert again == gcv.no_fit_polygon_many([face.polygon for face in faces], OTHERS)
    for results in (again, gcv.Polygon.many(faces)):
        assert results.labels.tolist() == list("xyz")
        assert results.crs == CRS
    with pytest.raises(gcv.InputError, match=r"^a and b have different indexes"):
        gcv.minkowski_sum_many(faces, B.reset_index(drop=True))


def test_text_of_metadata() -> None:
    schema, _ = gcv.minkowski_sum_many(A, B).__arrow_c_array__()
    field = pyarrow.field(_Schema(schema))
    assert field.metadata[b"ARROW:extension:name"] == b"geoarrow.polygon"
    metadata = json.loads(field.metadata[b"ARROW:extension:metadata"])
    assert metadata["crs_type"] == "projjson"
    assert metadata["crs"]["id"] == {"authority": "EPSG", "code": 25832}
    schema, _ = gcv.Polygon.many(np.array([SQUARE])).__arrow_c_array__()
    assert pyarrow.field(_Schema(schema)).metadata[b"ARROW:extension:metadata"] == b"{}"


class _Schema:
    def __init__(self, capsule: Any) -> None:
        self.capsule = capsule

    def __arrow_c_schema__(self) -> Any:
        return self.capsule

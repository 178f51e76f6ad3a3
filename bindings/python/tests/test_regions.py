# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Known regions, what they tell, and what is refused."""

from __future__ import annotations

import copy
import math
import pickle
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any, Union
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from matplotlib import pyplot
from shapes import (
    BOW_TIE,
    BUMPY,
    NOTCHED,
    SQUARE,
    SQUARE_2,
    TRIANGLE,
    U_SHAPE,
    Points,
    box,
    points,
    scaled,
    star,
)

import gcv

pyplot.switch_backend("Agg")

FRAME = gcv.Polygon(box(0, 0, 10, 10), [box(1, 1, 9, 9)])
ROOMS = gcv.Polygon(box(0, 0, 20, 9), [box(1, 1, 4, 4), box(6, 3, 8, 5), box(10, 3, 14, 5)])
"""A peg of 2 x 2 has room in the first, one place in the second, a way in the third."""
DUMB_BELL: Points = [
    *((0, 0), (4, 0), (4, 1), (6, 1), (6, 0), (10, 0)),
    *((10, 4), (6, 4), (6, 3), (4, 3), (4, 4), (0, 4)),
]
"""Two rooms, and a passage of height 2 between them."""
HUGE = scaled(SQUARE, 1e308)


def shown(ring: Any) -> Points:
    return [(float(x), float(y)) for x, y in ring]


def rings(region: gcv.Region) -> list[tuple[Points, list[Points]]]:
    return [(shown(outer), [shown(hole) for hole in holes]) for outer, holes in region.polygons]


def facts(region: gcv.Region) -> tuple[Any, ...]:
    return (
        *(region.parts, region.vertices.tolist(), region.exact_parts, region.exact),
        *(region.exact_indices.tolist(), region.sources, region.owners.tolist()),
        *(region.area, region.error_bound, region.stats, region.wkt, region.fits_wkt),
        *(rings(region), region.segments.tolist(), region.points.tolist(), list(region)),
    )


def test_frame() -> None:
    region = gcv.minkowski_sum_region(FRAME, SQUARE)
    outer, hole = box(0, 0, 11, 11), [(2, 2), (2, 9), (9, 9), (9, 2)]
    assert rings(region) == [(outer, [hole])]
    assert region.parts == [(gcv.PART_OUTER, 0, 0, 4), (gcv.PART_HOLE, 0, 4, 8)]
    assert region.exact_parts == region.parts
    assert region.exact == [(Fraction(x), Fraction(y)) for x, y in outer + hole]
    assert region.exact_indices.tolist() == list(range(8))
    assert shown(region.vertices) == outer + hole
    assert region.area == 121 - 49
    assert region.error_bound == 0
    assert region.bounds == (0, 0, 11, 11)
    assert region.stats.parts_dropped == region.stats.vertices_repaired == 0
    assert region.wkt == (
        "MULTIPOLYGON (((0 0, 11 0, 11 11, 0 11, 0 0), (2 2, 2 9, 9 9, 9 2, 2 2)))"
    )
    assert region.fits_wkt == "GEOMETRYCOLLECTION EMPTY"
    assert region.segments.shape == (0, 2, 2)
    assert region.points.shape == (0, 2)
    assert repr(region) == "<gcv.Region of 1 polygon, 1 hole>"
    # The hole is a translation of the hole's edges 4 to 7 by the corners of the square.
    corner = gcv.EDGE_TRANSLATED_CORNER
    assert region.sources[:4] == [(corner, k, k) for k in range(4)]
    assert [source[1] for source in region.sources[4:]] == [7, 6, 5, 4]
    assert region.owners.tolist() == [0] * 8


def test_outer_ring_is_the_outer_face() -> None:
    region = gcv.minkowski_sum_region(NOTCHED, TRIANGLE)
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    assert region.exact == face.exact
    assert shown(region.vertices) == points(face)
    assert region.sources == face.sources
    assert region.area == face.area
    assert region.bounds == face.bounds


def test_segment_of_exact_fit() -> None:
    region = gcv.no_fit_region(U_SHAPE, SQUARE_2)
    assert rings(region) == [(box(-2, -2, 6, 6), [])]
    assert region.segments.tolist() == [[[2, 2], [2, 6]]]
    assert region.points.tolist() == []
    assert region.parts[1] == (gcv.PART_SEGMENT, None, 4, 6)
    assert region.sources[5] == (0, 0, 0)
    assert region.sources[4] != (0, 0, 0)
    assert region.fits_wkt == "GEOMETRYCOLLECTION (LINESTRING (2 2, 2 6))"
    assert region.bounds == (-2, -2, 6, 6)
    assert repr(region) == "<gcv.Region of 1 polygon, 1 segment>"


def test_point_of_exact_fit() -> None:
    region = gcv.no_fit_region(gcv.Polygon(box(0, 0, 6, 6), [box(2, 2, 4, 4)]), SQUARE_2)
    assert rings(region) == [(box(-2, -2, 6, 6), [])]
    assert region.points.tolist() == [[2, 2]]
    assert region.parts[1] == (gcv.PART_POINT, None, 4, 5)
    assert region.sources[4] == (0, 0, 0)
    assert region.fits_wkt == "GEOMETRYCOLLECTION (POINT (2 2))"


def test_all_kinds_of_parts() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    assert rings(region) == [(box(-2, -2, 20, 9), [[(1, 1), (1, 2), (2, 2), (2, 1)]])]
    assert region.segments.tolist() == [[[10, 3], [12, 3]]]
    assert region.points.tolist() == [[6, 3]]
    assert [part.kind for part in region.parts] == [
        *(gcv.PART_OUTER, gcv.PART_HOLE, gcv.PART_SEGMENT, gcv.PART_POINT),
    ]
    assert [(part.start, part.stop) for part in region.parts] == [(0, 4), (4, 8), (8, 10), (10, 11)]
    assert repr(region) == "<gcv.Region of 1 polygon, 1 hole, 1 segment, 1 point>"


def test_reference() -> None:
    region = gcv.no_fit_region(U_SHAPE, SQUARE_2, (0.5, -2))
    assert rings(region) == [(box(-1.5, -4, 6.5, 4), [])]
    assert region.segments.tolist() == [[[2.5, 0], [2.5, 4]]]
    assert region == gcv.no_fit_region(U_SHAPE, SQUARE_2, reference=np.array([0.5, -2]))
    assert gcv.entrance_region(SQUARE_2, U_SHAPE, (0.5, -2)) == region
    assert gcv.entrance_region(SQUARE_2, U_SHAPE) == gcv.no_fit_region(U_SHAPE, SQUARE_2)


def test_sources_of_entrance_region() -> None:
    blocks = gcv.entrance_region(SQUARE_2, U_SHAPE).sources
    assert max(source.a for source in blocks) < 4 <= max(source.b for source in blocks)


@pytest.mark.parametrize(
    ("size", "expected"),
    [
        (5, "MULTIPOLYGON (((0 0, 3 0, 3 3, 0 3, 0 0)))"),
        (2, "GEOMETRYCOLLECTION (POINT (0 0))"),
        (1, "MULTIPOLYGON EMPTY"),
    ],
)
def test_inner_fit_in_a_box(size: float, expected: str) -> None:
    region = gcv.inner_fit_region(box(0, 0, size, size), SQUARE_2)
    assert region.shapely().wkt.replace(".0", "") == expected
    assert bool(region) == (size > 1)


def test_inner_fit_of_several_parts() -> None:
    region = gcv.inner_fit_region(DUMB_BELL, SQUARE_2, (1, 1))
    assert rings(region) == [(box(1, 1, 3, 3), []), (box(7, 1, 9, 3), [])]
    assert region.segments.tolist() == [[[3, 2], [7, 2]]]
    assert len(region) == 2
    assert region.area == 8
    assert [part.polygon for part in region.parts] == [0, 1, None]
    assert repr(region) == "<gcv.Region of 2 polygons, 1 segment>"


def test_inner_fit_with_a_solid_hole() -> None:
    region = gcv.inner_fit_region(gcv.Polygon(box(0, 0, 9, 9), [box(4, 4, 5, 5)]), SQUARE)
    assert rings(region) == [(box(0, 0, 8, 8), [[(3, 3), (3, 5), (5, 5), (5, 3)]])]


def test_empty_region() -> None:
    region = gcv.inner_fit_region(SQUARE, SQUARE_2)
    assert not region
    assert (len(region), list(region), region.polygons, region.parts) == (0, [], [], [])
    assert region.vertices.shape == (0, 2)
    assert region.segments.shape == (0, 2, 2)
    assert region.points.shape == (0, 2)
    assert region.exact == []
    assert region.sources == []
    assert region.exact_indices.shape == region.owners.shape == (0,)
    assert region.area == region.error_bound == 0
    assert all(map(math.isnan, region.bounds))
    assert region.wkt == "MULTIPOLYGON EMPTY"
    assert region.fits_wkt == "GEOMETRYCOLLECTION EMPTY"
    assert region.shapely().is_empty
    assert region.locate((0, 0)) is gcv.OUTSIDE
    assert repr(region) == "<gcv.Region of no parts>"
    assert pickle.loads(pickle.dumps(region)) == region == gcv.inner_fit_region(SQUARE, U_SHAPE)


def test_length_and_truth_differ() -> None:
    region = gcv.inner_fit_region(SQUARE_2, SQUARE_2)
    assert len(region) == 0
    assert region


def test_polygons_for_the_next_sum() -> None:
    region = gcv.minkowski_sum_region(FRAME, SQUARE)
    polygon = region.polygon(0)
    assert polygon == gcv.Polygon(box(0, 0, 11, 11), [box(2, 2, 9, 9)])
    assert list(region) == [polygon]
    assert gcv.Polygon(region) == gcv.Polygon(region.wkt) == polygon
    assert gcv.Polygon(*region.polygons[0]) == polygon
    assert gcv.minkowski_sum_region(region, SQUARE).area == 12**2 - 6**2
    rooms = gcv.inner_fit_region(DUMB_BELL, SQUARE_2)
    assert [room.area for room in rooms] == [4, 4]
    assert rooms.polygon(1).bounds == (6, 0, 8, 2)
    for number in (2, -1):
        with pytest.raises(gcv.InputError, match=f"^polygon is {number}, the region has 2 poly"):
            rooms.polygon(number)
    with pytest.raises(gcv.InputError, match="'GeometryCollection' is not a polygon"):
        gcv.Polygon(rooms)


PLACES = {
    (5, 5): gcv.INSIDE,  # overlaps
    (-2, 3): gcv.BOUNDARY,
    (1.5, 1.5): gcv.OUTSIDE,  # in a hole
    (1, 1.5): gcv.BOUNDARY,
    (11, 3): gcv.BOUNDARY,  # on the segment
    (11, math.nextafter(3, 4)): gcv.INSIDE,
    (10, 3): gcv.BOUNDARY,
    (6, 3): gcv.BOUNDARY,  # the point
    (6, math.nextafter(3, 0)): gcv.INSIDE,
    (-3, 3): gcv.OUTSIDE,
    (20, 9): gcv.BOUNDARY,
    (1e300, -1e300): gcv.OUTSIDE,
}


@pytest.mark.parametrize("pickled", [False, True])
def test_locate(pickled: bool) -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    if pickled:
        region = pickle.loads(pickle.dumps(region))
    for where, place in PLACES.items():
        assert region.locate(where) is place
        assert region.locate(list(where)) is place
        assert region.locate(np.array(where)) is place
    sources: list[Any] = [list(PLACES), np.array(list(PLACES)), iter(PLACES)]
    for source in sources:
        places = region.locate(source)
        assert places.dtype == np.int8
        assert places.tolist() == list(PLACES.values())
    assert region.locate(np.array([[5, 5], [6, 3]])).tolist() == [1, 0]
    assert (region.locate([(5, 5), (6, 3)]) == gcv.INSIDE).tolist() == [True, False]
    assert region.locate([]).shape == region.locate(np.empty((0, 2))).shape == (0,)
    assert region.locate(np.full((7, 9), 6.0)[::3, ::8]).tolist() == [1, 1, 1]


def test_locate_is_exact() -> None:
    region = gcv.minkowski_sum_region(NOTCHED, TRIANGLE)
    assert region.exact[4] == (Fraction(10, 3), Fraction(7, 3))
    # The lowest point of a notch. Both floats are rounded alike: they are on its right side.
    x, y = region.vertices[4].tolist()
    assert Fraction(x) - Fraction(10, 3) == Fraction(y) - Fraction(7, 3) > 0
    beside = [(x, y), (x, math.nextafter(y, 9)), (x, math.nextafter(y, 0))]
    for same in (region, pickle.loads(pickle.dumps(region))):
        assert same.locate(beside).tolist() == [gcv.BOUNDARY, gcv.OUTSIDE, gcv.INSIDE]


@pytest.mark.parametrize("pickled", [False, True])
@pytest.mark.parametrize(
    ("where", "reason"),
    [
        (None, "points: None is not a point, nor a sequence of points"),
        ((1, None), r"points: \(1, None\) is not a pair of numbers"),
        ((1, 10**400), "points: .* is not a number that a finite float"),
        ("12", r"points\[0\]: '1' is not a pair of numbers"),
        ([(0, 0), (1, 2, 3)], r"points\[1\]: \(1, 2, 3\) is not a pair of numbers"),
        ((1, 2, 3), r"points\[0\]: 1 is not a pair of numbers"),
        (np.zeros((2, 3)), r"points\[0\]: array.* is not a pair of numbers"),
        (np.ma.masked_equal(SQUARE, 1), "points: some elements of the array are masked"),
        (shapely.Point(0, 0), "points: <POINT .*> is not a point, nor"),
        ((0, math.nan), "points: the y coordinate of point 0 is nan"),
        ([(0, 0), (math.inf, 0)], "points: the x coordinate of point 1 is inf"),
    ],
)
def test_locate_refuses(where: Any, reason: str, pickled: bool) -> None:
    region = gcv.minkowski_sum_region(SQUARE, SQUARE)
    if pickled:
        region = pickle.loads(pickle.dumps(region))
    with pytest.raises(gcv.InputError, match=f"^{reason}"):
        region.locate(where)


def test_no_point_is_taken_for_a_polygon() -> None:
    with pytest.raises(TypeError):
        (1, 1) in gcv.minkowski_sum_region(SQUARE, SQUARE)  # type: ignore[operator] # noqa: B015


def test_shapely() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    geometry = region.shapely()
    polygon, line, point = geometry.geoms
    assert polygon.equals(shapely.from_wkt(region.wkt).geoms[0])
    assert shapely.from_wkt(region.fits_wkt).equals(shapely.GeometryCollection([line, point]))
    assert geometry.is_valid
    assert shapely.area(geometry) == region.area
    assert geometry.bounds == region.bounds
    frame = gcv.minkowski_sum_region(FRAME, SQUARE)
    assert frame.shapely().geom_type == "MultiPolygon"
    assert frame.shapely().equals(shapely.box(0, 0, 11, 11) - shapely.box(2, 2, 9, 9))
    assert gcv.minkowski_sum_region(frame.shapely(), SQUARE).area == 108


def test_leave_out() -> None:
    def some(**options: Any) -> list[gcv.Region]:
        return [
            gcv.no_fit_region(ROOMS, SQUARE_2, **options),
            gcv.minkowski_sum_region(ROOMS, scaled(SQUARE_2, -1), **options),
            gcv.entrance_region(SQUARE_2, ROOMS, **options),
            *gcv.minkowski_sum_region_many([ROOMS], [scaled(SQUARE_2, -1)], **options),
            *gcv.no_fit_region_many([ROOMS], [SQUARE_2], **options),
        ]

    def kinds(leave_out: object) -> list[int]:
        found = [[part.kind for part in r.exact_parts] for r in some(leave_out=leave_out)]
        assert all(k == found[0] for k in found)
        return found[0]

    assert kinds(()) == [1, 2, 3, 4]
    assert kinds("holes") == kinds(["holes"]) == [1, 3, 4]
    assert kinds("fits") == kinds({"fits": 1}) == [1, 2]
    assert kinds(("holes", "fits")) == kinds(["fits", "holes", "fits"]) == [1]
    inner = gcv.inner_fit_region(DUMB_BELL, SQUARE_2, leave_out="fits")
    assert repr(inner) == "<gcv.Region of 2 polygons>"


@pytest.mark.parametrize("leave_out", ["segments", "", None, 1, ["fits", 1], ("holes", "x")])
def test_wrong_leave_out(leave_out: Any) -> None:
    reason = "leave_out is .*, none of holes, fits$"
    if leave_out == "":
        reason = "leave_out is '', none of holes, fits$"
    with pytest.raises(ValueError, match=reason):
        gcv.minkowski_sum_region(SQUARE, SQUARE, leave_out=leave_out)


def test_inner_fits_refuse() -> None:
    with pytest.raises(gcv.InputError, match="GCV_LEAVE_OUT_HOLES"):
        gcv.inner_fit_region(FRAME, SQUARE, leave_out="holes")
    with pytest.raises(gcv.InputError, match=r"tolerance is 0\.5"):
        gcv.inner_fit_region(FRAME, SQUARE, tolerance=0.5)


@pytest.mark.parametrize(
    "option", [{"tolerance": -1}, {"tolerance": math.nan}, {"threads": -1}, {"rounding": "up"}]
)
def test_wrong_options(option: dict[str, Any]) -> None:
    (name,) = option
    calls: list[Any] = [
        lambda: gcv.minkowski_sum_region(SQUARE, SQUARE, **option),
        lambda: gcv.no_fit_region(SQUARE, SQUARE, **option),
        lambda: gcv.entrance_region(SQUARE, SQUARE, **option),
        lambda: gcv.inner_fit_region(SQUARE, SQUARE, **option),
        lambda: gcv.minkowski_sum_region_many([SQUARE], [SQUARE], **option),
        lambda: gcv.no_fit_region_many([SQUARE], [SQUARE], **option),
        lambda: gcv.no_fit_polygon_many([SQUARE], [SQUARE], **option),
    ]
    for call in calls:
        with pytest.raises(ValueError, match=name):
            call()


def test_rounding() -> None:
    tenth = (0.1, 0.0)
    nearest = gcv.no_fit_region(U_SHAPE, SQUARE_2, tenth)
    outward = gcv.no_fit_region(U_SHAPE, SQUARE_2, tenth, rounding="outward")
    assert nearest.exact == outward.exact
    assert nearest.segments.tolist() == [[[2.1, 2], [2.1, 6]]]
    assert nearest.error_bound > 0
    # No float is exactly 2 + 0.1: the segment cannot be shown, and is dropped.
    assert outward.segments.tolist() == []
    assert outward.stats.parts_dropped == 1
    assert len(outward.exact_parts) == 2
    left, right = outward.bounds[::2]
    assert Fraction(left) <= Fraction(0.1) - 2
    assert Fraction(right) >= Fraction(0.1) + 6
    assert nearest != outward
    inner = gcv.inner_fit_region(box(0, 0, 5, 5), SQUARE_2, tenth, rounding="outward")
    left, right = inner.bounds[::2]
    assert Fraction(left) >= Fraction(0.1)
    assert Fraction(right) <= Fraction(0.1) + 3


def test_vertices_that_fall_together() -> None:
    far = gcv.Polygon(box(1, 1, 2, 2))
    tiny = scaled(TRIANGLE, 2.0**-60)
    region, face = gcv.minkowski_sum_region(far, tiny), far + tiny
    assert len(region.exact) == 5
    assert shown(region.vertices) == points(face) == box(1, 1, 2, 2)
    assert region.exact_indices.tolist() == face.exact_indices.tolist() == [0, 1, 2, 4]
    assert [face.sources[k] for k in face.exact_indices] == [
        *((gcv.EDGE_TRANSLATED_CORNER, 0, 0), (gcv.EDGE_TRANSLATED, 1, 1)),
        *((gcv.EDGE_CORNER, 2, 1), (gcv.EDGE_TRANSLATED_CORNER, 3, 2)),
    ]


def test_tolerance() -> None:
    region = gcv.minkowski_sum_region(BUMPY, SQUARE, tolerance=0.4)
    assert rings(region) == [(box(0, 0, 5, 5), [])]
    assert 0.125 <= region.error_bound <= 0.125 + 1e-12


@pytest.mark.parametrize("threads", [0, 2])
def test_threads_of_the_library(threads: int) -> None:
    a = gcv.Polygon(star(120, 1), [0.4 * star(50, 3).vertices])
    b = scaled(points(star(40, 2)), 0.1)
    region = gcv.minkowski_sum_region(a, b, threads=threads)
    assert len(region.parts) == 2
    assert region == gcv.minkowski_sum_region(a, b)


def test_threads_of_the_caller() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    with ThreadPoolExecutor(4) as pool:
        places = list(pool.map(lambda _: region.locate(list(PLACES)).tolist(), range(50)))
    assert places == [list(PLACES.values())] * 50


def test_progress() -> None:
    reports: list[tuple[int, int]] = []
    region = gcv.no_fit_region(ROOMS, SQUARE_2, progress=lambda *steps: reports.append(steps))
    assert region == gcv.no_fit_region(ROOMS, SQUARE_2)
    assert len(reports) == 1


def test_out_of_range() -> None:
    for function in (gcv.minkowski_sum_region, gcv.no_fit_region, gcv.entrance_region):
        with pytest.raises(gcv.Error) as raised:
            function(HUGE, gcv.Polygon(HUGE if function is gcv.minkowski_sum_region else -HUGE))
        assert raised.value.status_name == "GCV_ERR_RANGE"


def test_reference_not_finite() -> None:
    for function in (gcv.no_fit_region, gcv.entrance_region, gcv.inner_fit_region):
        with pytest.raises(gcv.InputError) as raised:
            function(SQUARE, SQUARE, (0, math.nan))
        assert raised.value.status_name == "GCV_ERR_NOT_FINITE"
    with pytest.raises(gcv.InputError, match=r"^reference: \(1, 2, 3\) is not a pair"):
        gcv.no_fit_region(SQUARE, SQUARE, (1, 2, 3))


@pytest.mark.parametrize("wrong", [BOW_TIE, None, "POLYGON ((0 0", shapely.Point(0, 0)])
def test_errors_name_the_operand(wrong: Any) -> None:
    functions: list[tuple[Any, str, str]] = [
        (gcv.minkowski_sum_region, "a", "b"),
        (gcv.no_fit_region, "fixed", "moving"),
        (gcv.entrance_region, "a", "b"),
        (gcv.inner_fit_region, "container", "moving"),
        (lambda a, b: gcv.minkowski_sum_region_many([a], [b]), r"a\[0\]", r"b\[0\]"),
        (lambda a, b: gcv.no_fit_region_many([a], [b]), r"fixed\[0\]", r"moving\[0\]"),
        (lambda a, b: gcv.no_fit_polygon_many([a], [b]), r"fixed\[0\]", r"moving\[0\]"),
    ]
    for function, first, second in functions:
        with pytest.raises(gcv.InputError, match=f"^{first}: "):
            function(wrong, SQUARE)
        with pytest.raises(gcv.InputError, match=f"^{second}: "):
            function(SQUARE, wrong)


REFERENCES = [(0.0, 0.0), (0.5, -2.0), (0.1, 0.2)]


@pytest.mark.parametrize("threads", [1, 2])
def test_many(threads: int) -> None:
    fixed: list[Any] = [FRAME, U_SHAPE, ROOMS.wkt]
    moving: list[Any] = [SQUARE, SQUARE_2, np.array(SQUARE_2)]
    singles = [gcv.no_fit_region(*pair) for pair in zip(fixed, moving, REFERENCES)]
    for references in (REFERENCES, np.array(REFERENCES), map(list, REFERENCES)):
        many = gcv.no_fit_region_many(fixed, moving, references, threads=threads)
        assert [facts(region) for region in many] == [facts(region) for region in singles]
    faces = gcv.no_fit_polygon_many(fixed, moving, REFERENCES, threads=threads)
    assert faces == [gcv.no_fit_polygon(*pair) for pair in zip(fixed, moving, REFERENCES)]
    sums = gcv.minkowski_sum_region_many(fixed, moving, threads=threads, rounding="outward")
    assert sums == [
        gcv.minkowski_sum_region(a, b, rounding="outward") for a, b in zip(fixed, moving)
    ]


def test_many_without_references() -> None:
    assert gcv.no_fit_region_many([ROOMS], [SQUARE]) == [gcv.no_fit_region(ROOMS, SQUARE)]
    assert gcv.no_fit_polygon_many([ROOMS], [SQUARE]) == [gcv.no_fit_polygon(ROOMS, SQUARE)]
    assert gcv.no_fit_region_many([], []) == gcv.no_fit_polygon_many([], [], []) == []
    assert gcv.minkowski_sum_region_many([], []) == []


@pytest.mark.parametrize("function", [gcv.no_fit_region_many, gcv.no_fit_polygon_many])
def test_many_failures(function: Any) -> None:
    square = gcv.Polygon(SQUARE)
    fixed = [square, None, square, HUGE, square, square]
    moving = [square, square, square, -HUGE, BOW_TIE, square]
    references = [(0, 0), (0, 0), (1, None), (0, 0), (0, 0), (0, math.inf)]
    first, *errors = function(fixed, moving, references, return_errors=True)
    assert first == function([square], [square])[0]
    assert all(isinstance(error, gcv.Error) for error in errors)
    starts = ["fixed[1]: None", "references[2]: (1, None) is no", "pair 3: ", "moving[4]: edges 0"]
    for error, start in zip(errors, [*starts, "pair 5"]):
        assert str(error).startswith(start)
    assert [error.status_name[8:] for error in errors] == [
        *("INVALID_ARGUMENT", "INVALID_ARGUMENT", "RANGE", "NOT_SIMPLE", "NOT_FINITE"),
    ]
    with pytest.raises(gcv.Error, match=r"^pair 1: "):
        function([square, HUGE], [square, -HUGE])
    with pytest.raises(gcv.InputError, match=r"^pair 1: .*reference.*inf"):
        function([square] * 2, [square] * 2, [(0, 0), (math.inf, 0)])


def test_many_refused() -> None:
    with pytest.raises(ValueError, match="fixed has 2 polygons, moving has 1"):
        gcv.no_fit_region_many([SQUARE, SQUARE], [SQUARE])
    with pytest.raises(ValueError, match="fixed has 1 polygons, references has 2 points"):
        gcv.no_fit_polygon_many([SQUARE], [SQUARE], [(0, 0), (1, 1)])
    with pytest.raises(gcv.InputError, match=r"^references: 5 is not a sequence of pairs"):
        gcv.no_fit_region_many([SQUARE], [SQUARE], 5)  # type: ignore[call-overload]
    with pytest.raises(gcv.InputError, match=r"^references\[0\]: 0 is not a pair"):
        gcv.no_fit_region_many([SQUARE], [SQUARE], (0, 0))  # type: ignore[arg-type]
    with pytest.raises(gcv.InputError, match=r"^b: 5 is not a sequence of polygons"):
        gcv.minkowski_sum_region_many([SQUARE], 5)  # type: ignore[call-overload]


def test_pickle() -> None:
    for region in (gcv.no_fit_region(ROOMS, SQUARE_2), gcv.minkowski_sum_region(NOTCHED, TRIANGLE)):
        duplicate = pickle.loads(pickle.dumps(region))
        assert facts(duplicate) == facts(region)
        assert duplicate == region
        assert hash(duplicate) == hash(region)
        assert pickle.loads(pickle.dumps(duplicate)) == region
        assert copy.copy(region) is copy.deepcopy(region) is region


def test_without_area() -> None:
    large = gcv.minkowski_sum_region(*[scaled(SQUARE, 1e160)] * 2)
    for region in (large, pickle.loads(pickle.dumps(large))):
        with pytest.raises(gcv.Error, match="area") as raised:
            region.area  # noqa: B018
        assert raised.value.status_name == "GCV_ERR_RANGE"


def test_equality() -> None:
    region = gcv.no_fit_region(U_SHAPE, SQUARE_2)
    assert region == gcv.entrance_region(SQUARE_2, U_SHAPE)
    others: list[Union[gcv.Region, gcv.Polygon, gcv.OuterFace]] = [
        gcv.no_fit_region(U_SHAPE, SQUARE_2, leave_out="fits"),
        gcv.no_fit_region(box(0, 0, 6, 6), SQUARE_2),
        gcv.no_fit_polygon(U_SHAPE, SQUARE_2),
        region.polygon(0),
    ]
    assert all(region != other for other in others)
    assert others[0] == others[1]
    assert len({region, *others}) == 4
    # In floats the same, exactly not.
    tenth = gcv.no_fit_region(U_SHAPE, SQUARE_2, (0.1, 0), rounding="outward")
    bare = gcv.no_fit_region(U_SHAPE, SQUARE_2, (0.1, 0), rounding="outward", leave_out="fits")
    assert tenth.vertices.tolist() == bare.vertices.tolist()
    assert tenth != bare


def test_vertices_are_never_copied_or_changed() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    (polygon,) = region.polygons
    for array in (polygon.outer, *polygon.holes, region.segments, region.points):
        assert np.shares_memory(array, region.vertices)
        assert not array.flags.writeable
    assert not region.exact_indices.flags.writeable


def test_svg() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    polygon, segment, point = ElementTree.fromstring(region._repr_svg_())
    rings = polygon.attrib["d"].strip("MZ").split("ZM")
    assert polygon.attrib["fill-rule"] == "evenodd"
    assert [len(ring.split("L")) for ring in rings] == [4, 4]
    # 400 pixels for 22 units.
    assert segment.attrib["d"] == "M228.18 119.09L264.55 119.09"
    assert (point.attrib["cx"], point.attrib["cy"]) == ("155.45", "119.09")
    assert float(point.attrib["r"]) > 0


@pytest.mark.parametrize(("size", "count"), [(2, 1), (1, 0), (2e-300, 1)])
def test_svg_without_polygons(size: float, count: int) -> None:
    moving = scaled(SQUARE, 2 * size if count == 0 else size)
    region = gcv.inner_fit_region(box(0, 0, size, size), moving)
    picture = ElementTree.fromstring(region._repr_svg_())
    assert len(picture) == count
    assert picture.attrib["viewBox"] == "0 0 20.00 20.00"


def test_plot() -> None:
    _, ax = pyplot.subplots()
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    assert region.plot(ax, facecolor="red") is ax
    (patch,) = ax.patches
    assert patch.get_facecolor()[:3] == (1, 0, 0)
    assert patch.get_path().codes.tolist().count(1) == 2
    assert [line.get_xydata().tolist() for line in ax.lines] == [
        region.segments[0].tolist(),
        region.points.tolist(),
    ]
    pyplot.close("all")
    empty = gcv.inner_fit_region(SQUARE, SQUARE_2).plot()
    assert not empty.patches
    assert not empty.lines
    pyplot.close("all")

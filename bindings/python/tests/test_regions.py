# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Known regions, and what they tell."""

from __future__ import annotations

import math
import pickle
from fractions import Fraction
from typing import Union

import numpy as np
import pytest
from shapes import (
    DUMB_BELL,
    FRAME,
    NOTCHED,
    ROOMS,
    SQUARE,
    SQUARE_2,
    TRIANGLE,
    U_SHAPE,
    box,
    pairs,
    points,
    polygons_of,
    scaled,
)

import gcv


def test_frame() -> None:
    region = gcv.minkowski_sum_region(FRAME, SQUARE)
    outer, hole = box(0, 0, 11, 11), [(2, 2), (2, 9), (9, 9), (9, 2)]
    assert polygons_of(region) == [(outer, [hole])]
    assert region.parts == [(gcv.PART_OUTER, 0, 0, 4), (gcv.PART_HOLE, 0, 4, 8)]
    assert region.exact_parts == region.parts
    assert region.exact == [(Fraction(x), Fraction(y)) for x, y in outer + hole]
    assert region.exact_indices.tolist() == list(range(8))
    assert pairs(region.vertices) == outer + hole
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
    assert pairs(region.vertices) == points(face)
    assert region.sources == face.sources
    assert region.area == face.area
    assert region.bounds == face.bounds


def test_segment_of_exact_fit() -> None:
    region = gcv.no_fit_region(U_SHAPE, SQUARE_2)
    assert polygons_of(region) == [(box(-2, -2, 6, 6), [])]
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
    assert polygons_of(region) == [(box(-2, -2, 6, 6), [])]
    assert region.points.tolist() == [[2, 2]]
    assert region.parts[1] == (gcv.PART_POINT, None, 4, 5)
    assert region.sources[4] == (0, 0, 0)
    assert region.fits_wkt == "GEOMETRYCOLLECTION (POINT (2 2))"


def test_all_kinds_of_parts() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    assert polygons_of(region) == [(box(-2, -2, 20, 9), [[(1, 1), (1, 2), (2, 2), (2, 1)]])]
    assert region.segments.tolist() == [[[10, 3], [12, 3]]]
    assert region.points.tolist() == [[6, 3]]
    assert [part.kind for part in region.parts] == [
        *(gcv.PART_OUTER, gcv.PART_HOLE, gcv.PART_SEGMENT, gcv.PART_POINT),
    ]
    assert [(part.start, part.stop) for part in region.parts] == [(0, 4), (4, 8), (8, 10), (10, 11)]
    assert repr(region) == "<gcv.Region of 1 polygon, 1 hole, 1 segment, 1 point>"


def test_reference() -> None:
    region = gcv.no_fit_region(U_SHAPE, SQUARE_2, (0.5, -2))
    assert polygons_of(region) == [(box(-1.5, -4, 6.5, 4), [])]
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
    assert polygons_of(region) == [(box(1, 1, 3, 3), []), (box(7, 1, 9, 3), [])]
    assert region.segments.tolist() == [[[3, 2], [7, 2]]]
    assert len(region) == 2
    assert region.area == 8
    assert [part.polygon for part in region.parts] == [0, 1, None]
    assert repr(region) == "<gcv.Region of 2 polygons, 1 segment>"


def test_inner_fit_with_a_solid_hole() -> None:
    region = gcv.inner_fit_region(gcv.Polygon(box(0, 0, 9, 9), [box(4, 4, 5, 5)]), SQUARE)
    assert polygons_of(region) == [(box(0, 0, 8, 8), [[(3, 3), (3, 5), (5, 5), (5, 3)]])]


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


FAR = 2.0**56
LOBES = [
    *[(1408, 645), (1408, 512), (1792, 512), (1792, 896), (1408, 649), (1024, 1024), (504, 1024)],
    *[(792, 1504), (500, 1024), (488, 1024), (776, 1504), (484, 1024), (472, 1024), (760, 1504)],
    *[(468, 1024), (752, 1504), (460, 1024), (744, 1504), (452, 1024), (736, 1504), (388, 1024)],
]
ISLANDS = [
    *[(0, 0), (-28, -10), (-37, -2), (-40, -5), (-53, -3)],
    *[(-44, 15), (-40, 4), (-28, 11), (-16, 13), (-8, 10)],
]


@pytest.mark.parametrize(
    ("container", "part", "reference"),
    [
        # The lobe with the hole is cut off, and the hole has to go too.
        (
            gcv.Polygon(LOBES, holes=[[(1504, 608), (1696, 608), (1696, 800)]]),
            [(0, 0), (1, 0), (0, 1)],
            (FAR, FAR),
        ),
        # Two islands come to lie in each other.
        (gcv.Polygon(ISLANDS), [(-1, 3), (3, 0), (2, -3), (-2, -3)], (1.5 * FAR, 1.5 * FAR)),
    ],
)
def test_regions_of_a_few_units_are_valid(
    container: gcv.Polygon, part: list[tuple[float, float]], reference: tuple[float, float]
) -> None:
    region = gcv.inner_fit_region(container, part, reference)
    assert region.stats.parts_dropped == 1
    polygons = [region.polygon(k) for k in range(len(region))]
    assert region.shapely().is_valid
    assert region.area == sum(polygon.area for polygon in polygons)


def test_what_is_dropped_is_in_the_bound() -> None:
    plate = [(-102400, -102400), (102400, -102400), (102400, 102400), (-102400, 102400)]
    holed = gcv.Polygon(plate, holes=[[(-511, -511), (511, -511), (511, 511), (-511, 511)]])
    peg = [(0, 0), (-1, 0), (-1, -1), (0, -1)]
    region = gcv.no_fit_region(holed, peg, (1.5 * 2.0**62, 1.5 * 2.0**62))
    assert (len(region.exact_parts), region.stats.parts_dropped) == (2, 1)
    assert region.error_bound >= math.hypot(1021, 1021)

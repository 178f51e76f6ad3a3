# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Whether two polygons are apart, touch or overlap."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely.affinity import translate
from shapes import NOTCHED, ROOMS, SQUARE, SQUARE_2, TRIANGLE, U_SHAPE, box, star
from test_properties import polygons

import gcv

PLACES = {
    (5, 5): gcv.OVERLAPPING,
    (-2, 3): gcv.TOUCHING,
    (1.5, 1.5): gcv.APART,  # in a hole
    (1, 1.5): gcv.TOUCHING,
    (11, 3): gcv.TOUCHING,  # fits between two sides
    (11, math.nextafter(3, 4)): gcv.OVERLAPPING,
    (6, 3): gcv.TOUCHING,  # fits exactly
    (math.nextafter(6, 0), 3): gcv.OVERLAPPING,
    (-3, 3): gcv.APART,
    (20, 9): gcv.TOUCHING,  # at two corners
    (1e300, -1e300): gcv.APART,
    (-1.7e308, 1.7e308): gcv.APART,
}
"""Of ROOMS and a square of 2 x 2."""


def test_relation() -> None:
    for where, expected in PLACES.items():
        assert gcv.relation(ROOMS, SQUARE_2, where) is expected
        back = (-where[0], -where[1])
        assert gcv.relation(SQUARE_2, ROOMS, back) is expected
    relations = gcv.relation(ROOMS, SQUARE_2, list(PLACES))
    assert relations.dtype == np.int8
    assert relations.tolist() == list(PLACES.values())
    assert (relations == gcv.APART).sum() == 4


def test_without_a_translation() -> None:
    square = gcv.Polygon(SQUARE)
    assert gcv.relation(square, square) is gcv.OVERLAPPING
    assert gcv.relation(square, box(1, 0, 2, 1)) is gcv.TOUCHING
    assert gcv.relation(square, box(2, 0, 3, 1)) is gcv.APART


def test_whatever_polygons_are_made_from() -> None:
    plate = shapely.Polygon(box(0, 0, 9, 9), [box(2, 2, 7, 7)])
    for a in (plate, gcv.Polygon(plate), plate.wkt, shapely.geometry.mapping(plate)):
        for b in (SQUARE, np.array(SQUARE), gcv.minkowski_sum(SQUARE, SQUARE)):
            assert gcv.relation(a, b, (4, 4)) is gcv.APART
            assert gcv.relation(a, b, (2, 2)) is gcv.TOUCHING
            assert gcv.relation(a, b, (0, 0)) is gcv.OVERLAPPING


def test_sums_of_floats_are_exact() -> None:
    wall = box(0, 0, 0.1 + 0.2, 1)
    block = box(0.1, 0, 1, 1)
    # 0.1 + 0.2 is rounded up, and by that the block is in the wall.
    assert gcv.relation(wall, block, (0.2, 0)) is gcv.OVERLAPPING
    assert translate(shapely.Polygon(block), 0.2, 0).touches(shapely.Polygon(wall))
    more = math.nextafter(0.2, 1)
    assert gcv.relation(wall, block, (more, 0)) is gcv.TOUCHING
    assert gcv.relation(wall, block, (math.nextafter(more, 1), 0)) is gcv.APART

    far = 2.0**60
    wall, block = box(0, 0, far, 1), box(1, 0, 2, 1)
    assert gcv.relation(wall, block, (far, 0)) is gcv.APART
    assert gcv.relation(wall, block, (far - 256, 0)) is gcv.OVERLAPPING
    assert gcv.relation(box(0, 0, far, 1), box(0, 0, 2, 1), (far, 0)) is gcv.TOUCHING


def test_touching_beside_a_computed_point() -> None:
    region = gcv.no_fit_region(NOTCHED, [(-x, -y) for x, y in TRIANGLE])
    # The floats nearest to (10/3, 7/3), the lowest point of a notch, are on its right side.
    x, y = region.vertices[4].tolist()
    beside = [(x, y), (x, math.nextafter(y, 9)), (x, math.nextafter(y, 0))]
    relations = gcv.relation(NOTCHED, [(-x, -y) for x, y in TRIANGLE], beside)
    assert relations.tolist() == [gcv.TOUCHING, gcv.APART, gcv.OVERLAPPING]


@pytest.mark.parametrize("moving", [SQUARE, SQUARE_2, TRIANGLE, NOTCHED, ROOMS])
@pytest.mark.parametrize("fixed", [ROOMS, U_SHAPE])
def test_on_a_grid(fixed: gcv.PolygonLike, moving: gcv.PolygonLike) -> None:
    """All positions in halves: many of them touch."""
    xs, ys = np.meshgrid(np.arange(-21, 21, 0.5), np.arange(-10, 10, 0.5))
    grid = np.column_stack([xs.ravel(), ys.ravel()])
    relations = gcv.relation(fixed, moving, grid)
    assert (relations == -gcv.no_fit_region(fixed, moving).locate(grid)).all()
    assert set(relations) == {-1, 0, 1}


def test_at_the_vertices_of_a_region() -> None:
    """Positions in floats that are as near to the boundary as floats can be."""
    fixed, moving = star(60, 1), star(50, 2)
    region = gcv.no_fit_region(fixed, moving)
    places = np.concatenate([region.vertices, np.nextafter(region.vertices, 9)])
    assert (gcv.relation(fixed, moving, places) == -region.locate(places)).all()


@given(
    *(polygons(), polygons()),
    st.lists(st.tuples(*[st.integers(-24, 24).map(lambda n: n / 2)] * 2), min_size=1, max_size=9),
)
def test_as_in_the_region(
    a: gcv.Polygon, b: gcv.Polygon, translations: list[tuple[float, float]]
) -> None:
    relations = gcv.relation(a, b, translations)
    region = gcv.no_fit_region(a, b)
    assert (relations == -region.locate(translations)).all()
    back = [(-x, -y) for x, y in translations]
    assert gcv.relation(b, a, back).tolist() == relations.tolist()
    assert gcv.relation(-a, -b, back).tolist() == relations.tolist()

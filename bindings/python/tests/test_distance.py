# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""How far two polygons are from each other, and where."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely.affinity import translate
from shapes import FRAME, HUGE, NOTCHED, ROOMS, SQUARE, TRIANGLE, U_SHAPE, Points, box, star
from test_properties import polygons

import gcv

Exact = tuple[Fraction, Fraction]


def exactly(ring: Points, translation: tuple[float, float] = (0, 0)) -> list[Exact]:
    dx, dy = map(Fraction, translation)
    return [(Fraction(x) + dx, Fraction(y) + dy) for x, y in ring]


def squared(p: Exact, q: Exact) -> Fraction:
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def foot(p: Exact, start: Exact, end: Exact) -> Exact:
    """The point of an edge that is nearest to p."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    along = ((p[0] - start[0]) * dx + (p[1] - start[1]) * dy) / (dx * dx + dy * dy)
    along = min(max(along, Fraction(0)), Fraction(1))
    return start[0] + along * dx, start[1] + along * dy


def smallest_squared(a: list[Exact], b: list[Exact]) -> Fraction:
    """The square of the distance of two rings that are apart."""
    return min(
        squared(p, foot(p, start, end))
        for ring, other in ((a, b), (b, a))
        for p in ring
        for start, end in zip(other, other[1:] + other[:1])
    )


def is_nearest_root(root: float, square: Fraction) -> bool:
    """Whether the float is the one nearest to the root of the square."""
    below, above = (Fraction(math.nextafter(root, to)) for to in (0, math.inf))
    middle = Fraction(root)
    return ((below + middle) / 2) ** 2 <= square <= ((middle + above) / 2) ** 2


def test_edge_and_vertex() -> None:
    peak = [(0.0, 1.0), (0.5, 0.0), (1.0, 1.0)]
    separation = gcv.distance(SQUARE, peak, (0, 3))
    assert separation == gcv.Separation(
        distance=2.0,
        relation=gcv.APART,
        nearest=gcv.Contact(
            *(gcv.ContactKind.EDGE_VERTEX, 2, 1, 2.0),
            *((0.0, 1.0), (0.5, 1.0), (0.5, 3.0)),
        ),
    )
    back = gcv.distance(peak, SQUARE, (0, -3))
    assert back.nearest == gcv.Contact(
        *(gcv.ContactKind.VERTEX_EDGE, 1, 2, 2.0),
        *((0.0, -1.0), (0.5, 0.0), (0.5, -2.0)),
    )
    assert separation.nearest is not None
    assert separation.nearest.kind is gcv.ContactKind.EDGE_VERTEX


def test_two_vertices() -> None:
    separation = gcv.distance(SQUARE, SQUARE, (4, 5))
    assert separation.distance == 5
    assert separation.nearest == gcv.Contact(
        *(gcv.ContactKind.VERTEX_VERTEX, 2, 0, 5.0),
        *((0.6, 0.8), (1.0, 1.0), (4.0, 5.0)),
    )


def test_touching_and_overlapping() -> None:
    assert gcv.distance(SQUARE, SQUARE, (1, 1)) == (0, gcv.TOUCHING, None, 0)
    assert gcv.distance(SQUARE, SQUARE) == (0, gcv.OVERLAPPING, None, 0)


def test_in_a_hole() -> None:
    separation = gcv.distance(FRAME, SQUARE, (1.5, 6))
    assert separation.distance == 0.5
    assert separation.nearest is not None
    assert separation.nearest.normal == (1, 0)
    # Vertices and edges of all rings are counted, the outer one first.
    assert separation.nearest.a >= 4


def test_numbers_are_those_of_the_rings_as_passed() -> None:
    turned = SQUARE[2:] + SQUARE[:2]
    assert gcv.distance(turned, SQUARE[::-1], (4, 5)).nearest[1:3] == (0, 3)  # type: ignore[index]


def test_underflow() -> None:
    tiny = 5e-324
    assert gcv.distance(SQUARE, box(0, 0, 1, 1), (1 + 2**-52, 0)).distance == 2**-52
    corner = [(-1.0, 0.0), (0.0, -1.0), (tiny, tiny)]
    # Their distance is tiny / sqrt(2), about, of which half is the nearest float.
    separation = gcv.distance(corner, [(0.0, 2 * tiny), (2 * tiny, 0.0), (1.0, 1.0)])
    assert (separation.relation, separation.distance) == (gcv.TOUCHING, 0)
    slanted = [(0.0, tiny), (tiny, 0.0), (1.0, 1.0)]
    separation = gcv.distance([(-1.0, 0.0), (0.0, -1.0), (0.0, 0.0)], slanted)
    assert separation.relation is gcv.APART
    assert separation.distance == tiny  # of 0.7 tiny
    long, flat = [(0.0, 0.0), (4.0, tiny), (0.0, 1.0)], [(0.0, -1.0), (4.0, -1.0), (1.0, 0.0)]
    separation = gcv.distance(long, flat)
    assert separation.relation is gcv.APART
    assert separation.distance == 0  # of a quarter of tiny
    assert separation.nearest is not None


def test_beyond_the_largest_float() -> None:
    with pytest.raises(gcv.Error, match=r"^translation: number 1: ") as raised:
        gcv.distance(SQUARE, SQUARE, [(0, 0), (1.7e308, 1.7e308)])
    assert raised.value.status_name == "GCV_ERR_RANGE"
    assert gcv.relation(SQUARE, SQUARE, (1.7e308, 1.7e308)) is gcv.APART
    # Coordinates of the moved polygon may be.
    assert gcv.distance(HUGE, HUGE, (1.75e308, 0)).distance == 1.75e308 - 1e308


@pytest.mark.parametrize("fixed", [NOTCHED, U_SHAPE])
def test_correctly_rounded(fixed: Points) -> None:
    moves = np.random.default_rng(5).uniform(-15, 15, (60, 2))
    answers = gcv.distance(fixed, TRIANGLE, moves)
    for move, answer in zip(moves.tolist(), answers):
        if answer["relation"] != gcv.APART:
            assert answer["distance"] == 0
            continue
        square = smallest_squared(exactly(fixed), exactly(TRIANGLE, move))
        assert is_nearest_root(float(answer["distance"]), square)


@given(polygons(), polygons(), st.tuples(*[st.integers(-300, 300).map(float)] * 2))
def test_properties(a: gcv.Polygon, b: gcv.Polygon, move: tuple[float, float]) -> None:
    distance, relation, nearest, _ = gcv.distance(a, b, move)
    assert relation is gcv.relation(a, b, move)
    assert (nearest is None) == (relation is not gcv.APART)
    assert gcv.distance(b, a, (-move[0], -move[1])).distance == distance
    if nearest is None:
        assert distance == 0
        return
    assert distance == nearest.gap
    assert is_nearest_root(
        distance, smallest_squared(exactly(a.vertices.tolist()), exactly(b.vertices.tolist(), move))
    )
    assert math.isclose(math.dist(nearest.on_a, nearest.on_b), distance, rel_tol=1e-9)
    assert math.isclose(math.hypot(*nearest.normal), 1)
    x, y = nearest.normal
    (ax, ay), (bx, by) = nearest.on_a, nearest.on_b
    assert math.isclose(ax + distance * x, bx, abs_tol=1e-9)
    assert math.isclose(ay + distance * y, by, abs_tol=1e-9)


def test_as_in_shapely() -> None:
    a, b = star(200, 1), star(200, 2)
    moves = np.random.default_rng(6).uniform(-4, 4, (200, 2))
    others = [translate(shapely.geometry.shape(b), *move) for move in moves]
    expected = shapely.distance(shapely.geometry.shape(a), others)
    assert np.allclose(gcv.distance(a, b, moves)["distance"], expected, rtol=1e-12, atol=1e-15)
    inside = np.random.default_rng(7).uniform((0, 0), (16, 6), (200, 2))
    others = [translate(shapely.box(0, 0, 0.5, 0.5), *move) for move in inside]
    expected = shapely.distance(shapely.geometry.shape(ROOMS), others)
    answers = gcv.distance(ROOMS, box(0, 0, 0.5, 0.5), inside)["distance"]
    assert np.allclose(answers, expected, rtol=1e-12, atol=1e-15)

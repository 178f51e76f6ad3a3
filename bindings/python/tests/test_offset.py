# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Clearances, and their promise in fractions."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from shapes import DUMB_BELL, HUGE, NOTCHED, ROOMS, SQUARE, U_SHAPE, star

import gcv

Vertex = tuple[Fraction, Fraction]
Edge = tuple[Vertex, Vertex]

# Unit vectors without rounding.
DIRECTIONS = [
    (sign_x * Fraction(x, length), sign_y * Fraction(y, length))
    for x, y, length in [(1, 0, 1), (0, 1, 1), (3, 4, 5), (99, 20, 101)]
    for sign_x in (1, -1)
    for sign_y in (1, -1)
]
POLYGONS = [
    *map(gcv.Polygon, (NOTCHED, U_SHAPE, DUMB_BELL)),
    *(ROOMS, star(40, 1), ROOMS.affine([0.6, -0.8, 1000.1, 0.8, 0.6, -0.3])),
]
AMOUNTS = [(0.75, 0.5), (0.1, 1e-3), (1 / 3, 0.01)]


def edges_of(shape: Any) -> list[Edge]:
    """The edges of all rings, in fractions."""
    rings = [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for one in shape
        for ring in one._ring_points()
    ]
    return [edge for ring in rings for edge in zip(ring, ring[1:] + ring[:1])]


def contains(edges: list[Edge], at: Vertex) -> bool:
    """Whether a point is inside the rings or on them."""
    inside = False
    for (x0, y0), (x1, y1) in edges:
        turn = (x1 - x0) * (at[1] - y0) - (y1 - y0) * (at[0] - x0)
        if (
            turn == 0
            and min(x0, x1) <= at[0] <= max(x0, x1)
            and min(y0, y1) <= at[1] <= max(y0, y1)
        ):
            return True
        if (y0 <= at[1]) != (y1 <= at[1]) and (turn > 0) == (y1 > y0):
            inside = not inside
    return inside


def squared_distance(edges: list[Edge], at: Vertex) -> Fraction:
    """From the nearest point of the edges."""

    def from_edge(edge: Edge) -> Fraction:
        (x0, y0), (x1, y1) = edge
        x, y = x1 - x0, y1 - y0
        part = ((at[0] - x0) * x + (at[1] - y0) * y) / (x * x + y * y)
        part = min(max(part, Fraction(0)), Fraction(1))
        return (x0 + part * x - at[0]) ** 2 + (y0 + part * y - at[1]) ** 2

    return min(map(from_edge, edges))


def points_on(edges: list[Edge], count: int, seed: int) -> Iterator[Vertex]:
    """Some vertices, and a point on the edge of each."""
    generator = random.Random(seed)
    for (x0, y0), (x1, y1) in generator.sample(edges, min(count, len(edges))):
        yield x0, y0
        part = Fraction(generator.randrange(1, 16), 16)
        yield x0 + part * (x1 - x0), y0 + part * (y1 - y0)


@pytest.mark.parametrize("distance, tolerance", AMOUNTS)
@pytest.mark.parametrize("polygon", POLYGONS, ids=repr)
def test_outward(polygon: gcv.Polygon, distance: float, tolerance: float) -> None:
    region = gcv.offset(polygon, distance, tolerance)
    assert len(region) == 1
    given, grown = edges_of([polygon]), edges_of(region)
    for x, y in points_on(given, 5, 1):
        for a, b in DIRECTIONS:
            assert contains(grown, (x + Fraction(distance) * a, y + Fraction(distance) * b))
    most = (Fraction(distance) + Fraction(tolerance)) ** 2
    for at in points_on(grown, 12, 2):
        assert contains(given, at) or squared_distance(given, at) <= most


@pytest.mark.parametrize("distance, tolerance", AMOUNTS)
@pytest.mark.parametrize("polygon", POLYGONS, ids=repr)
def test_inward(polygon: gcv.Polygon, distance: float, tolerance: float) -> None:
    region = gcv.offset(polygon, -distance, tolerance)
    given, shrunk = edges_of([polygon]), edges_of(region)
    for at in points_on(shrunk, 12, 3):
        assert contains(given, at)
        assert squared_distance(given, at) >= Fraction(distance) ** 2
    deep = Fraction(distance) + Fraction(tolerance)
    # What is hardly deeper than that: along inward normals, but for the corners.
    for x, y in points_on(given, 5, 4):
        for a, b in DIRECTIONS:
            at = x + deep * Fraction(33, 32) * a, y + deep * Fraction(33, 32) * b
            if contains(given, at) and squared_distance(given, at) > deep**2:
                assert contains(shrunk, at)


def test_shapes() -> None:
    grown = gcv.offset(ROOMS, 0.5, 0.01)
    assert [len(rings) for rings in grown._ring_points()] == [4]
    assert gcv.offset(ROOMS, 2, 0.01).wkt.count("(") == 3  # the holes are full
    assert len(gcv.offset(DUMB_BELL, -1, 0.01)) == 2
    assert gcv.offset(SQUARE, 1, 1e-6).area == pytest.approx(5 + math.pi, abs=1e-5)
    assert not gcv.offset(SQUARE, -0.5, 0.01)
    assert not (len(grown.segments) or len(grown.points))
    assert gcv.offset(SQUARE, 1, 0.01, threads=2) == gcv.offset(gcv.Polygon(SQUARE), 1, 0.01)
    calls: list[tuple[int, int]] = []
    gcv.offset(star(500, 2), -0.01, 1e-4, progress=lambda *steps: calls.append(steps))
    assert calls


@pytest.mark.parametrize(
    "arguments, status, message",
    [
        ((0, 0.1), 2, "distance: 0.0 is not a finite number other than 0"),
        ((math.nan, 0.1), 3, "distance: nan is not a finite number"),
        ((None, 0.1), 2, "distance: None is not a number"),
        ((1, 0), 2, "tolerance: 0.0 is not a finite number above 0"),
        ((1, -1), 2, "tolerance: -1.0 is not a finite number above 0"),
        ((1, math.inf), 3, "tolerance: inf is not"),
        ((1, 1e-17), 2, "tolerance: 1e-17 is too small for the roundings"),
    ],
)
def test_failures(arguments: tuple[Any, Any], status: int, message: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{message}") as caught:
        gcv.offset(SQUARE, *arguments)
    assert caught.value.status == status


def test_failures_of_polygons() -> None:
    with pytest.raises(gcv.InputError, match=r"^polygon: None is not a polygon"):
        gcv.offset(None, 1, 0.1)  # type: ignore[arg-type]
    far = gcv.Polygon(SQUARE).translated((1e9, 0))
    with pytest.raises(gcv.InputError, match=r"^tolerance: 1e-07 is too small"):
        gcv.offset(far, 0.3, 1e-7)
    with pytest.raises(gcv.Error) as failure:
        gcv.offset(HUGE, 1.5e308, 1e300)
    assert failure.value.status_name == "GCV_ERR_RANGE"

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The shortest way out of an overlap."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapes import FRAME, ROOMS, SQUARE, SQUARE_2, U_SHAPE, box, star
from test_distance import is_nearest_root
from test_properties import polygons

import gcv


def test_way_out() -> None:
    escape = gcv.penetration(SQUARE, SQUARE, (0.75, 0.5))
    assert escape[:4] == (0.25, (0.25, 0.0), (1.0, 0.5), gcv.TOUCHING)
    assert escape.contact is not None
    assert escape.contact.gap == 0
    assert escape.contact.normal == (1, 0)
    # Of two ways that are equally short, the lexicographically smallest.
    assert gcv.penetration(SQUARE, SQUARE).translation == (-1, 0)


def test_no_overlap() -> None:
    for move, relation in (((1.0, 1.0), gcv.TOUCHING), ((3.0, 3.0), gcv.APART)):
        assert gcv.penetration(SQUARE, SQUARE, move) == (0, (0, 0), move, relation, None, 0)


def test_into_a_hole_or_not() -> None:
    escape = gcv.penetration(FRAME, SQUARE, (0.25, 4))
    assert escape[:3] == (0.75, (0.75, 0), (1, 4))
    escape = gcv.penetration(FRAME, SQUARE, (0.25, 4), leave_out="holes")
    assert escape[:3] == (1.25, (-1.25, 0), (-1, 4))


def test_into_an_exact_fit_or_not() -> None:
    assert gcv.penetration(U_SHAPE, SQUARE_2, (2.25, 3))[:3] == (0.25, (-0.25, 0), (2, 3))
    escape = gcv.penetration(U_SHAPE, SQUARE_2, (2.25, 3), leave_out="fits")
    assert escape[:3] == (3, (0, 3), (2.25, 6))
    assert gcv.penetration(ROOMS, SQUARE_2, (6.125, 3.0)).position == (6, 3)
    outside = gcv.penetration(ROOMS, SQUARE_2, (6.125, 3.0), leave_out=("holes", "fits"))
    assert outside.position == (6.125, -2)
    with pytest.raises(ValueError, match="leave_out is 'hole'"):
        gcv.penetration(SQUARE, SQUARE, leave_out="hole")  # type: ignore[arg-type]


@given(polygons(), polygons(), st.tuples(*[st.integers(-14, 14).map(lambda n: n / 2)] * 2))
def test_properties(a: gcv.Polygon, b: gcv.Polygon, move: tuple[float, float]) -> None:
    depth, way, position, relation, contact, id = gcv.penetration(a, b, move)
    overlaps = gcv.relation(a, b, move) is gcv.OVERLAPPING
    assert (depth > 0) == overlaps == (contact is not None)
    assert relation is gcv.relation(a, b, position)
    assert id == 0
    if not overlaps:
        return
    # No point of the exact boundary is nearer; ends of edges and feet on them are its points.
    region = gcv.no_fit_region(a, b)
    t = Fraction(move[0]), Fraction(move[1])
    assert is_nearest_root(depth, min(squares(region, t)))
    assert math.isclose(math.hypot(*way), depth, rel_tol=1e-12)
    assert all(math.isclose(t + w, p, abs_tol=1e-12) for t, w, p in zip(move, way, position))


def squares(region: gcv.Region, t: tuple[Fraction, Fraction]) -> list[Fraction]:
    """The squares of the distances of a point from the edges, segments and points."""
    found = []
    for part in region.exact_parts:
        ring = region.exact[part.start : part.stop]
        for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
            dx, dy = bx - ax, by - ay
            length = dx * dx + dy * dy
            along = ((t[0] - ax) * dx + (t[1] - ay) * dy) / length if length else Fraction(0)
            along = min(max(along, Fraction(0)), Fraction(1))
            found.append((t[0] - ax - along * dx) ** 2 + (t[1] - ay - along * dy) ** 2)
    return found


def test_positions_are_free() -> None:
    a, b = star(60, 1), star(50, 2)
    moves = np.random.default_rng(9).uniform(-1, 1, (200, 2))
    escapes = gcv.penetration(a, b, moves)
    assert (escapes["depth"] > 0).all()
    assert (escapes["relation"] == gcv.relation(a, b, escapes["position"])).all()
    assert (escapes["relation"] != gcv.OVERLAPPING).mean() > 0.9
    assert gcv.penetration(box(0, 0, 1, 1), SQUARE, moves)["depth"].max() <= 1

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""How far a motion leads before two polygons overlap."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapes import FRAME, HUGE, ROOMS, SQUARE, SQUARE_2, U_SHAPE, star
from test_properties import polygons

import gcv

VECTORS = st.tuples(*[st.integers(-20, 20).map(float)] * 2)


def test_hit() -> None:
    assert gcv.cast(SQUARE, SQUARE, (5, 0.5), (-8, 0)) == gcv.Impact(
        hit=True,
        relation=gcv.TOUCHING,
        time=0.5,
        position=(1.0, 0.5),
        contact=gcv.Contact(
            *(gcv.ContactKind.EDGE_VERTEX, 1, 0, 0.0),
            *((1.0, 0.0), (1.0, 0.5), (1.0, 0.5)),
        ),
    )


def test_no_hit() -> None:
    for start, motion in [
        ((5, 0), (0, 9)),
        ((5, 1), (-10, 0)),  # slides along a side
        ((5, 0), (-4, 0)),  # touches at the end
        ((1, 1), (0, 0)),
        ((1, 0), (5, 0)),  # leaves
    ]:
        impact = gcv.cast(SQUARE, SQUARE, start, motion)
        end = (start[0] + motion[0], start[1] + motion[1])
        assert impact == (False, gcv.relation(SQUARE, SQUARE, end), 1, end, None, 0)


def test_overlap_at_the_start() -> None:
    impact = gcv.cast(SQUARE, SQUARE, (0.5, 0), (9, 0))
    assert (impact.hit, impact.time, impact.contact) == (True, 0, None)


def test_touching_at_the_start() -> None:
    impact = gcv.cast(SQUARE, SQUARE, (1, 0.5), (-1, 0))
    assert impact[:4] == (True, gcv.TOUCHING, 0, (1, 0.5))
    assert impact.contact is not None
    assert impact.contact.normal == (1, 0)


def test_into_a_slot_of_its_own_width() -> None:
    impact = gcv.cast(U_SHAPE, SQUARE_2, (2, 20), (0, -30))
    assert impact[:4] == (True, gcv.TOUCHING, 0.6, (2, 2))
    beside = math.nextafter(2, 3)
    impact = gcv.cast(U_SHAPE, SQUARE_2, (beside, 20), (0, -28))
    assert impact[:4] == (True, gcv.TOUCHING, 0.5, (beside, 6))


def test_in_a_hole() -> None:
    impact = gcv.cast(FRAME, SQUARE, (4, 4), (16, 8))
    assert impact[:4] == (True, gcv.TOUCHING, 0.25, (8, 6))


def test_time_is_rounded_down() -> None:
    impact = gcv.cast(SQUARE, SQUARE, (3, 0.5), (-6, 0))
    assert Fraction(impact.time) < Fraction(1, 3) < Fraction(math.nextafter(impact.time, 1))
    assert impact.position == (1, 0.5)


def test_broadcasting() -> None:
    starts = [(5.0, 0.5), (5.0, 3.0), (0.0, -7.0)]
    motions = [(-8.0, 0.0), (-8.0, -5.0), (0.0, 9.0)]
    assert cast_all(starts, motions) == [cast_one(s, m) for s, m in zip(starts, motions)]
    assert cast_all(starts, np.array(motions)) == cast_all(np.array(starts), iter(motions))
    assert cast_all(starts, motions[0]) == [cast_one(s, motions[0]) for s in starts]
    assert cast_all(starts[0], motions) == [cast_one(starts[0], m) for m in motions]
    assert cast_all(np.array(starts[0]), motions[:1]) == [cast_one(starts[0], motions[0])]
    empties: list[Any] = [[], np.empty((0, 2))]
    for empty in empties:
        assert cast_all(starts[0], empty) == cast_all(empty, motions[0]) == []
        assert cast_all(empty, empty) == []


def cast_all(translation: Any, motion: Any) -> list[Any]:
    impacts = gcv.cast(SQUARE, SQUARE, translation, motion)
    assert impacts.dtype == gcv.IMPACT_DTYPE
    listed: list[Any] = impacts["position"].tolist()
    return list(zip(impacts["hit"], impacts["time"], listed))


def cast_one(translation: tuple[float, float], motion: tuple[float, float]) -> Any:
    impact = gcv.cast(SQUARE, SQUARE, translation, motion)
    return impact.hit, impact.time, list(impact.position)


@pytest.mark.parametrize(
    ("translation", "motion", "message"),
    [
        ([(0, 0)] * 3, [(0, 0)] * 2, "translation has 3 pairs and motion has 2 pairs"),
        ([], [(0, 0)], "translation has 0 pairs and motion has 1 pairs"),
        ((0, 0), None, "motion: None is not a pair of numbers, nor a sequence of pairs"),
        ((0, 0), (1, 2, 3), r"motion\[0\]: 1 is not a pair of numbers"),
        ([(0, 0)] * 2, [(0, 0), (1,)], r"motion\[1\]: \(1,\) is not a pair of numbers"),
        ((0, 0), (0, math.inf), r"motion\b.*\b0\b.*inf"),
        ((0, 0), [(0, 0), (math.nan, 0)], r"motion\b.*\b1\b.*nan"),
        ([(0, 0), (math.nan, 0)], (0, 0), r"translation\b.*\b1\b.*nan"),
    ],
)
def test_refused(translation: Any, motion: Any, message: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        gcv.cast(SQUARE, SQUARE, translation, motion)


def test_beyond_the_largest_float() -> None:
    with pytest.raises(gcv.Error, match=r"^translation: number 1: ") as raised:
        gcv.cast(HUGE, HUGE, (1e308, 0), [(7e307, 0), (1.7e308, 0)])
    assert raised.value.status_name == "GCV_ERR_RANGE"


@given(polygons(), polygons(), VECTORS, VECTORS)
def test_properties(
    a: gcv.Polygon, b: gcv.Polygon, start: tuple[float, float], motion: tuple[float, float]
) -> None:
    hit, relation, time, position, contact, _ = gcv.cast(a, b, start, motion)
    assert 0 <= time <= 1
    assert relation is gcv.relation(a, b, position)
    if gcv.relation(a, b, start) is gcv.OVERLAPPING:
        assert (hit, time, contact) == (True, 0, None)
        return
    exact = [Fraction(s) + Fraction(time) * Fraction(m) for s, m in zip(start, motion)]
    assert all(math.isclose(p, e, abs_tol=1e-13) for p, e in zip(position, exact))
    # The way up to the impact is free, and so is the exact place.
    region = gcv.no_fit_region(a, b)
    steps = [(start[0] + motion[0] * s, start[1] + motion[1] * s) for s in np.linspace(0, 1, 9)]
    free = [step for s, step in zip(np.linspace(0, 1, 9), steps) if s <= time]
    assert gcv.INSIDE not in region.locate(free)
    if hit:
        assert contact is not None
        assert contact.gap == 0
        # It is met from outside.
        assert contact.normal[0] * motion[0] + contact.normal[1] * motion[1] <= 1e-9
    else:
        assert (time, contact) == (1, None)
        assert relation is not gcv.OVERLAPPING


def test_position_is_within_two_ulps() -> None:
    a, b = star(100, 1), star(80, 2)
    generator = np.random.default_rng(8)
    angles = generator.uniform(0, 2 * math.pi, 300)
    starts = 3 * np.column_stack([np.cos(angles), np.sin(angles)])
    impacts = gcv.cast(a, b, starts, -starts + generator.uniform(-0.5, 0.5, (300, 2)))
    assert impacts["hit"].all()
    assert (impacts["relation"] != gcv.OVERLAPPING).all()
    assert (gcv.relation(a, b, impacts["position"]) == impacts["relation"]).all()


def test_rooms() -> None:
    """A peg goes through the rooms, and stops where a wall is."""
    starts = [(1.0, 1.0), (10.0, 3.0), (6.0, 3.0)]
    impacts = gcv.cast(ROOMS, SQUARE_2, starts, (16, 0))
    assert impacts["position"].tolist() == [[2, 1], [12, 3], [6, 3]]
    assert impacts["time"].tolist() == [1 / 16, 2 / 16, 0]
    assert impacts["hit"].all()

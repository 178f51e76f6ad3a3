# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where points lie in regions."""

from __future__ import annotations

import math
import pickle
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import shapely
from shapes import NOTCHED, NOWHERE, ROOMS, SQUARE, SQUARE_2, TRIANGLE

import gcv

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
        one: Any = np.array(where)
        assert region.locate(one) is place
    sources: list[Any] = [list(PLACES), np.array(list(PLACES)), iter(PLACES)]
    for source in sources:
        places = region.locate(source)
        assert places.dtype == np.int8
        assert places.tolist() == list(PLACES.values())
    assert region.locate(np.array([[5, 5], [6, 3]])).tolist() == [1, 0]
    assert (region.locate([(5, 5), (6, 3)]) == gcv.INSIDE).tolist() == [True, False]
    assert region.locate(NOWHERE).shape == region.locate(np.empty((0, 2))).shape == (0,)
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
        (shapely.MultiPoint([(0, 0)]), "points: <MULTIPOINT .*> is not a point, nor"),
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


def test_threads_of_the_caller() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    with ThreadPoolExecutor(4) as pool:
        places = list(pool.map(lambda _: region.locate(list(PLACES)).tolist(), range(50)))
    assert places == [list(PLACES.values())] * 50

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Many regions, and many no-fit polygons, in one call."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from shapes import BOW_TIE, FRAME, HUGE, ROOMS, SQUARE, SQUARE_2, U_SHAPE, facts

import gcv

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
    assert gcv.no_fit_region_many([], []) == []
    assert gcv.no_fit_polygon_many([], [], []) == []
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

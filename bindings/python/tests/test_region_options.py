# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Options of regions, and what is refused."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import pytest
import shapely
from shapes import (
    BOW_TIE,
    BUMPY,
    DUMB_BELL,
    FRAME,
    HUGE,
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
    star,
)

import gcv


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


@pytest.mark.parametrize(
    "leave_out", ["segments", "", None, 1, ["fits", 1], [["holes"]], ("holes", "x")]
)
def test_wrong_leave_out(leave_out: Any) -> None:
    reason = "leave_out is .*, none of holes, fits$"
    if leave_out == "":
        reason = "leave_out is '', none of holes, fits$"
    with pytest.raises(ValueError, match=reason):
        gcv.minkowski_sum_region(SQUARE, SQUARE, leave_out=leave_out)


def test_inner_fits_refuse() -> None:
    with pytest.raises(gcv.InputError, match=r"leave_out has 'holes'"):
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
    assert pairs(region.vertices) == points(face) == box(1, 1, 2, 2)
    assert region.exact_indices.tolist() == face.exact_indices.tolist() == [0, 1, 2, 4]
    assert [face.sources[k] for k in face.exact_indices] == [
        *((gcv.EDGE_TRANSLATED_CORNER, 0, 0), (gcv.EDGE_TRANSLATED, 1, 1)),
        *((gcv.EDGE_CORNER, 2, 1), (gcv.EDGE_TRANSLATED_CORNER, 3, 2)),
    ]


def test_tolerance() -> None:
    region = gcv.minkowski_sum_region(BUMPY, SQUARE, tolerance=0.4)
    assert polygons_of(region) == [(box(0, 0, 5, 5), [])]
    assert 0.125 <= region.error_bound <= 0.125 + 1e-12


@pytest.mark.parametrize("threads", [0, 2])
def test_threads_of_the_library(threads: int) -> None:
    a = gcv.Polygon(star(120, 1), [0.4 * star(50, 3).vertices])
    b = scaled(points(star(40, 2)), 0.1)
    region = gcv.minkowski_sum_region(a, b, threads=threads)
    assert len(region.parts) == 2
    assert region == gcv.minkowski_sum_region(a, b)


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


@pytest.mark.parametrize("rounding", ["nearest", "outward"])
def test_the_outer_ring_within_a_tolerance_is_the_outer_face(rounding: Any) -> None:
    """With holes, too: simplification keeps or drops vertices of the outer ring alike."""
    block = gcv.Polygon(
        [(6, 0), (7, 0), (2, 10), (2, 4), (1, 3), (0, 0)], [[(3, 5), (4, 6), (3, 3)]]
    )
    face = gcv.minkowski_sum(block, SQUARE_2, tolerance=1, rounding=rounding)
    region = gcv.minkowski_sum_region(block, SQUARE_2, tolerance=1, rounding=rounding)
    assert region.polygons[0].outer.tolist() == face.vertices.tolist()

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Known results of the functions, and what an outer face tells."""

from __future__ import annotations

import copy
import math
import pickle
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import shapely
from shapes import (
    BOW_TIE,
    BUMPY,
    HUGE,
    NOTCHED,
    SQUARE,
    SQUARE_2,
    SQUARE_3,
    TRIANGLE,
    U_NO_FIT,
    U_SHAPE,
    points,
    scaled,
    star,
)

import gcv


def test_squares() -> None:
    face = gcv.minkowski_sum(gcv.Polygon(SQUARE), gcv.Polygon(SQUARE_2))
    assert points(face) == SQUARE_3
    assert face.exact == [(Fraction(x), Fraction(y)) for x, y in SQUARE_3]
    assert face.area == 9
    assert face.bounds == (0, 0, 3, 3)
    assert face.error_bound == 0
    assert len(face) == 4
    assert repr(face) == "<gcv.OuterFace of 4 vertices>"
    assert face.wkt == "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"
    assert points(gcv.Polygon(face.wkt)) == SQUARE_3
    assert face.polygon.wkt == face.wkt
    assert face.sources == [(gcv.EDGE_TRANSLATED_CORNER, k, k) for k in range(4)]
    assert face.exact_indices.tolist() == [0, 1, 2, 3]
    assert shapely.geometry.shape(face).equals(shapely.box(0, 0, 3, 3))


def test_fractions() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    crossing = (Fraction(10, 3), Fraction(7, 3))
    assert face.exact == [(0, 0), (9, 0), (9, 6), (8, 7), crossing, (1, 7), (0, 8)]
    assert points(face)[4] == (10 / 3, 7 / 3)
    assert 0 < face.error_bound < 1e-15
    assert [source[0] for source in face.sources] == [3, 1, 2, 1, 1, 2, 3]
    assert [source[1:] for source in face.sources] == [
        *((0, 0), (1, 1), (2, 1), (2, 2), (3, 1), (4, 1), (4, 2)),
    ]
    assert face.stats.walk_steps >= 7
    assert face.stats.vertices_repaired == 0


def test_no_fit() -> None:
    face = gcv.no_fit_polygon(U_SHAPE, SQUARE, (0, 0))
    assert points(face) == U_NO_FIT
    assert face.area == 45
    assert gcv.no_fit_polygon(U_SHAPE, SQUARE) == face
    assert gcv.entrance_block(SQUARE, U_SHAPE) == face
    moved = gcv.no_fit_polygon(U_SHAPE, SQUARE, (0.5, -2))
    assert points(moved) == [(x + 0.5, y - 2) for x, y in U_NO_FIT]


def test_entrance_block() -> None:
    face = gcv.entrance_block(SQUARE, U_SHAPE, (1, 0))
    assert points(face) == [(x + 1, y) for x, y in U_NO_FIT]


def test_superset() -> None:
    edges = gcv.superset(SQUARE, SQUARE_2)
    for k, (start, end) in enumerate(zip(SQUARE_3, SQUARE_3[1:] + SQUARE_3[:1])):
        assert (start, end, (gcv.EDGE_TRANSLATED_CORNER, k, k)) in edges


def test_operators() -> None:
    a, b, c = gcv.Polygon(NOTCHED), gcv.Polygon(TRIANGLE), gcv.Polygon(SQUARE)
    assert a + b == gcv.minkowski_sum(a, b)
    assert a + -b == gcv.no_fit_polygon(a, b, (0, 0))
    assert a + b + c == gcv.minkowski_sum((a + b).polygon, c)
    assert c + (a + b) == a + b + c


def test_sum() -> None:
    a, b, c = gcv.Polygon(NOTCHED), gcv.Polygon(TRIANGLE), gcv.Polygon(SQUARE)
    assert sum([a, b, c]) == a + b + c
    assert sum([a]) is a
    assert sum([a + b, c]) == a + b + c


@pytest.mark.parametrize("other", [1, 0.0, None, SQUARE, np.array(SQUARE)])
def test_operands_of_other_types(other: Any) -> None:
    polygon = gcv.Polygon(NOTCHED)
    with pytest.raises(TypeError):
        polygon + other
    with pytest.raises(TypeError):
        other + polygon


def test_outlives_inputs() -> None:
    polygon = gcv.minkowski_sum(SQUARE, SQUARE_2).polygon
    assert gcv.minkowski_sum(polygon, polygon).area == 36


def test_vertices_are_never_copied_or_changed() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    assert np.shares_memory(face.vertices, face.vertices)
    assert np.shares_memory(face.vertices, np.asarray(face))
    assert not face.vertices.flags.writeable


def facts(face: gcv.OuterFace) -> tuple[Any, ...]:
    return (
        *(points(face), face.exact, face.sources, face.error_bound),
        *(face.area, face.wkt, face.stats, face.polygon),
    )


def test_pickle() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    duplicate = pickle.loads(pickle.dumps(face))
    assert facts(duplicate) == facts(face)
    assert duplicate == face
    assert hash(duplicate) == hash(face)
    assert copy.copy(face) is copy.deepcopy(face) is face


def test_pickle_of_an_earlier_version() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    _, (_, known) = face.__reduce__()
    known = {name: fact for name, fact in known.items() if name != "exact_indices"}
    known["stats"] = gcv.Stats(*face.stats[:6])
    earlier = gcv.OuterFace(None, known)
    for duplicate in (earlier, pickle.loads(pickle.dumps(earlier))):
        assert facts(duplicate) == facts(face)
        with pytest.raises(NotImplementedError, match="exact_indices: not in the pickle"):
            duplicate.exact_indices  # noqa: B018


def test_pickle_without_area() -> None:
    large = scaled(SQUARE, 1e160)
    for face in (large + large, pickle.loads(pickle.dumps(large + large))):
        for _ in range(2):
            with pytest.raises(gcv.Error, match="area") as raised:
                face.area  # noqa: B018
            assert raised.value.status_name == "GCV_ERR_RANGE"


def test_equality() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    outward = gcv.minkowski_sum(NOTCHED, TRIANGLE, rounding="outward")
    assert face == gcv.minkowski_sum(TRIANGLE, NOTCHED)
    assert face != outward
    assert face.exact == outward.exact
    assert face != face.polygon


def test_equality_is_exact() -> None:
    far = gcv.Polygon([(x + 1, y + 1) for x, y in SQUARE])
    one, other = far + scaled(SQUARE, 2.0**-60), far + scaled(SQUARE, 2.0**-61)
    assert points(one) == points(other)
    assert one != other


def test_outward_contains() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE, rounding="outward")
    x, y = (Fraction(c) for c in points(face)[4])
    assert y - x >= Fraction(7 - 10, 3)
    assert (x, y) != (Fraction(10, 3), Fraction(7, 3))


def test_tolerance() -> None:
    def some_within(tolerance: float) -> list[gcv.OuterFace]:
        return [
            gcv.minkowski_sum(BUMPY, SQUARE, tolerance=tolerance),
            gcv.no_fit_polygon(BUMPY, SQUARE, (1, 1), tolerance=tolerance),
            gcv.entrance_block(SQUARE, BUMPY, (1, 1), tolerance=tolerance),
            *gcv.minkowski_sum_many([BUMPY], [SQUARE], tolerance=tolerance),
        ]

    assert some_within(0.02) == some_within(0)
    for face in some_within(0.4):
        assert points(face) == [(0, 0), (5, 0), (5, 5), (0, 5)]
        assert 0.125 <= face.error_bound <= 0.125 + 1e-12
    face = gcv.minkowski_sum(BUMPY, SQUARE, tolerance=0.4)
    assert [source.a for source in face.sources] == [0, 4, 5, 9]


@pytest.mark.parametrize(
    "option", [{"tolerance": -1}, {"tolerance": math.nan}, {"threads": -1}, {"rounding": "up"}]
)
def test_wrong_options(option: dict[str, Any]) -> None:
    square = gcv.Polygon(SQUARE)
    (name,) = option
    with pytest.raises(ValueError, match=name):
        gcv.minkowski_sum(square, square, **option)
    with pytest.raises(ValueError, match=name):
        gcv.no_fit_polygon(square, square, (0, 0), **option)
    with pytest.raises(ValueError, match=name):
        gcv.entrance_block(square, square, (0, 0), **option)
    with pytest.raises(ValueError, match=name):
        gcv.minkowski_sum_many([square], [square], **option)


@pytest.mark.parametrize("threads", [0, 2, 7])
def test_threads_of_the_library(threads: int) -> None:
    a, b = star(120, 1), star(80, 2)
    assert gcv.minkowski_sum(a, b, threads=threads) == a + b


def test_threads_of_the_caller() -> None:
    polygon = gcv.Polygon(NOTCHED)
    with ThreadPoolExecutor(4) as pool:
        faces = set(pool.map(lambda _: gcv.minkowski_sum(polygon, TRIANGLE), range(100)))
    assert len(faces) == 1


def test_reference_not_finite() -> None:
    for function in (gcv.no_fit_polygon, gcv.entrance_block):
        for point in ((math.nan, 0), (0, math.inf)):
            with pytest.raises(gcv.InputError):
                function(SQUARE, SQUARE, point)


@pytest.mark.parametrize(
    ("point", "reason"),
    [
        (None, "None is not a pair of numbers"),
        (shapely.MultiPoint([(0, 0)]), "<MULTIPOINT .*> is not a pair of numbers"),
        ((1, 2, 3), r"\(1, 2, 3\) is not a pair of numbers"),
        ("12", "'12' is not a pair of numbers"),
        ((0, 10**400), ".* is not a number that a finite float can be near to"),
    ],
)
def test_wrong_reference(point: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^reference: {reason}$"):
        gcv.no_fit_polygon(SQUARE, SQUARE, point)
    with pytest.raises(gcv.InputError, match=f"^a0: {reason}$"):
        gcv.entrance_block(SQUARE, SQUARE, point)


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        (BOW_TIE, "edges 0 and 2 meet"),
        (None, "None is not a polygon"),
        ([(0, 0), (1, math.nan)], "the y coordinate of vertex 1 is nan"),
        ("POLYGON ((0 0", "byte 13: expected"),
        (shapely.Point(0, 0), "a geometry of type 'Point' is not a polygon"),
    ],
)
def test_errors_name_the_operand(wrong: Any, reason: str) -> None:
    functions: list[tuple[Any, str, str]] = [
        (gcv.minkowski_sum, "a", "b"),
        (gcv.superset, "a", "b"),
        (lambda a, b: gcv.no_fit_polygon(a, b, (0, 0)), "fixed", "moving"),
        (lambda a, b: gcv.entrance_block(a, b, (0, 0)), "a", "b"),
        (lambda a, b: gcv.minkowski_sum_many([SQUARE, a], [SQUARE, b]), r"a\[1\]", r"b\[1\]"),
    ]
    for function, a, b in functions:
        with pytest.raises(gcv.InputError, match=f"^{a}: {reason}"):
            function(wrong, SQUARE)
        with pytest.raises(gcv.InputError, match=f"^{b}: {reason}"):
            function(SQUARE, wrong)


def test_out_of_range() -> None:
    with pytest.raises(gcv.Error) as raised:
        gcv.minkowski_sum(HUGE, HUGE)
    assert not isinstance(raised.value, ValueError)
    assert raised.value.status_name == "GCV_ERR_RANGE"


@pytest.mark.parametrize("threads", [1, 2])
def test_many(threads: int) -> None:
    a = [star(count, count) for count in (3, 10, 40, 7)]
    b = [star(count, 2 * count) for count in (50, 4, 30, 5)]
    faces = gcv.minkowski_sum_many(a, b, threads=threads, rounding="outward")
    singles = [gcv.minkowski_sum(p, q, rounding="outward") for p, q in zip(a, b)]
    assert [facts(face) for face in faces] == [facts(face) for face in singles]


def test_many_from_other_sources() -> None:
    faces = gcv.minkowski_sum_many(iter([SQUARE, SQUARE]), [SQUARE_2, "POLYGON((0 0,1 0,0 1))"])
    assert [face.area for face in faces] == [9, 3.5]
    assert gcv.minkowski_sum_many([], []) == []


def test_many_failures() -> None:
    square = gcv.Polygon(SQUARE)
    ring = [square, HUGE, square, HUGE]
    with pytest.raises(gcv.Error, match="pair 1: ") as raised:
        gcv.minkowski_sum_many(ring, ring)
    assert raised.value.status_name == "GCV_ERR_RANGE"
    first, second, third, fourth = gcv.minkowski_sum_many(ring, ring, return_errors=True)
    assert first == third == square + square
    assert isinstance(second, gcv.Error)
    assert str(second) == str(raised.value)
    assert isinstance(fourth, gcv.Error)
    assert fourth.status == second.status
    assert "pair 3" in str(fourth)


def test_many_with_sources_that_are_no_polygons() -> None:
    first: list[Any] = [SQUARE, None, HUGE, SQUARE, BOW_TIE]
    second: list[Any] = [SQUARE_2, SQUARE, HUGE, BOW_TIE, None]
    faces = gcv.minkowski_sum_many(first, second, return_errors=True)
    assert faces[0] == gcv.minkowski_sum(SQUARE, SQUARE_2)
    texts = [str(error) for error in faces[1:]]
    assert texts[0].startswith("a[1]: None is not a polygon")
    assert texts[1].startswith("pair 2: ")
    assert texts[2].startswith("b[3]: edges 0 and 2 meet")
    assert texts[3].startswith("a[4]: edges 0 and 2 meet")


def test_many_refused() -> None:
    with pytest.raises(ValueError, match="2 polygons, b has 1"):
        gcv.minkowski_sum_many([SQUARE, SQUARE], [SQUARE])
    with pytest.raises(gcv.InputError):
        gcv.minkowski_sum_many([SQUARE], [BOW_TIE])


@pytest.mark.parametrize(
    "options, message",
    [
        ({"tolerance": "a"}, "tolerance: 'a' is not a number"),
        ({"tolerance": None}, "tolerance: None is not a number"),
        ({"tolerance": 10**400}, "tolerance: 1000+.* is not a number that a finite float"),
        ({"threads": 1.5}, "threads: 1.5 is not a whole number of 32 bits"),
        ({"threads": 2**32}, "threads: 4294967296 is not a whole number of 32 bits"),
        ({"rounding": "up"}, "rounding is 'up', none of"),
        ({"rounding": []}, r"rounding is \[\], none of"),
    ],
)
def test_options_of_other_types(options: dict[str, Any], message: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        gcv.minkowski_sum(SQUARE, SQUARE, **options)
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        gcv.no_fit_region_many([SQUARE], [SQUARE], **options)


def test_simplified_within_no_number() -> None:
    with pytest.raises(gcv.InputError, match=r"^tolerance: 'a' is not a number$"):
        gcv.Polygon(SQUARE).simplified("a")  # type: ignore[arg-type]

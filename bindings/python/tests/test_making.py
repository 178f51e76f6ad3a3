# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Many polygons in one call, discs, and affine maps."""

from __future__ import annotations

import math
import pickle
from fractions import Fraction
from operator import neg as negative
from typing import Any, Callable

import numpy as np
import pytest
import shapely
from hypothesis import assume, given
from hypothesis import strategies as st
from shapes import BOW_TIE, BUMPY, NOTCHED, SQUARE, TRIANGLE, Points, points
from test_properties import ExactPoint, exact_points, polygons

import gcv

HOLE: Points = [(0.25, 0.25), (0.75, 0.25), (0.5, 0.75)]
PLATE = gcv.Polygon(SQUARE, [HOLE])

# ------------------------------------------------------------------- many --


def turned(count: int) -> Any:
    """A shape at so many angles."""
    angles = np.linspace(0, 1, count)
    rotations = np.array([[np.cos(angles), -np.sin(angles)], [np.sin(angles), np.cos(angles)]])
    return np.einsum("ijn,kj->nki", rotations, np.array(NOTCHED))


@pytest.mark.parametrize(
    "layout",
    [
        lambda a: a,
        np.asfortranarray,
        lambda a: a.tolist(),
        list,
        iter,
        lambda a: [gcv.Polygon(ring) for ring in a],
        lambda a: [shapely.Polygon(ring) for ring in a],
        lambda a: [gcv.Polygon(ring).wkt for ring in a],
        lambda a: a.astype(np.longdouble),
    ],
)
def test_many(layout: Callable[[Any], Any]) -> None:
    array = turned(20)
    made = gcv.Polygon.many(layout(array))
    assert made == [gcv.Polygon(ring) for ring in array]
    assert pickle.loads(pickle.dumps(made)) == made


def test_many_keep_numbers() -> None:
    closed = np.array([[*NOTCHED[::-1], NOTCHED[-1]]])
    (polygon,) = gcv.Polygon.many(closed)
    expected = gcv.Polygon(closed[0])
    assert (polygon + PLATE).sources == (expected + PLATE).sources


def test_many_of_different_sizes_and_with_holes() -> None:
    sources = [SQUARE, NOTCHED, PLATE, shapely.Polygon(SQUARE, [HOLE]), PLATE.wkt, TRIANGLE]
    assert gcv.Polygon.many(sources) == [gcv.Polygon(source) for source in sources]


@pytest.mark.parametrize("nothing", [[], (), np.empty((0, 4, 2)), np.empty((0, 2))])
def test_none(nothing: Any) -> None:
    assert gcv.Polygon.many(nothing) == []


def test_many_failures() -> None:
    sources: list[Any] = [SQUARE, None, BOW_TIE, NOTCHED, "POLYGON ((0 0", BOW_TIE, [[0, 0]]]
    made = gcv.Polygon.many(sources, return_errors=True)
    assert [isinstance(p, gcv.Polygon) for p in made] == [True, *2 * [False], True, *3 * [False]]
    assert made[0] == gcv.Polygon(SQUARE)
    assert made[3] == gcv.Polygon(NOTCHED)
    for k, reason in {
        1: "None is not a polygon",
        2: "edges 0 and 2 meet",
        4: "byte 13: expected",
        5: "edges 0 and 2 meet",
        6: "",
    }.items():
        assert isinstance(made[k], gcv.InputError)
        assert str(made[k]).startswith(f"polygon {k}: {reason}")
    with pytest.raises(gcv.InputError, match="polygon 1: None is not a polygon"):
        gcv.Polygon.many(sources)
    with pytest.raises(gcv.InputError, match="polygon 0: edges 0 and 2 meet"):
        gcv.Polygon.many(np.array([BOW_TIE]))


@pytest.mark.parametrize("wrong", [None, 5])
def test_many_of_no_sequence(wrong: Any) -> None:
    with pytest.raises(gcv.InputError, match=f"^sources: {wrong} is not a sequence of polygons$"):
        gcv.Polygon.many(wrong)


def test_many_masked() -> None:
    with pytest.raises(gcv.InputError, match=r"^polygon: some elements of the array are masked"):
        gcv.Polygon.many(np.ma.masked_equal([SQUARE], 0))


@given(st.lists(polygons(), max_size=8))
def test_many_are_what_each_is(expected: list[gcv.Polygon]) -> None:
    assert gcv.Polygon.many([polygon.vertices for polygon in expected]) == expected


# ------------------------------------------------------------------- disc --

LENGTHS = st.floats(2.0**-30, 2.0**30)


def check_disc(
    disc: gcv.Polygon, centre: ExactPoint, radius: Fraction, tolerance: Fraction, inner: Fraction
) -> None:
    """Vertices are at most radius + tolerance away, edges at least inner, by squares.

    Convex, so nothing else of the boundary is further or nearer.
    """
    ring = [(x - centre[0], y - centre[1]) for x, y in exact_points(disc)]
    for p, q, r in zip(ring, ring[1:] + ring[:1], ring[2:] + ring[:2]):
        assert (q[0] - p[0]) * (r[1] - q[1]) > (q[1] - p[1]) * (r[0] - q[0])
        assert p[0] ** 2 + p[1] ** 2 <= (radius + tolerance) ** 2
        cross = p[0] * q[1] - p[1] * q[0]
        assert cross > 0
        length = (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2
        assert inner <= 0 or cross**2 >= inner**2 * length


@given(LENGTHS, st.floats(1e-5, 2), st.tuples(st.floats(-9, 9), st.floats(-9, 9)), st.booleans())
def test_disc(radius: float, share: float, offset: tuple[float, float], outward: bool) -> None:
    tolerance = radius * share
    centre = offset[0] * radius, offset[1] * radius
    disc = gcv.Polygon.disc(centre, radius, tolerance, rounding="outward" if outward else "nearest")
    exact = Fraction(centre[0]), Fraction(centre[1])
    r, t = Fraction(radius), Fraction(tolerance)
    check_disc(disc, exact, r, t, r if outward else r - t)
    most = 2 * max(4, (3.3 if outward else 2.3) * math.sqrt(1 / share) + 1)
    assert 4 <= len(disc) <= most


def test_disc_is_a_polygon_like_others() -> None:
    disc = gcv.Polygon.disc(np.array([1, 2]), 5, Fraction(1, 100))
    assert disc == gcv.Polygon(disc.vertices)
    again = pickle.loads(pickle.dumps(disc))
    assert (again + disc).sources == (disc + disc).sources
    about_origin = gcv.Polygon.disc((0, 0), 5, 0.01)
    assert about_origin.affine((0, -1, 0, 1, 0, 0)) == about_origin


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        ((None, 1, 1), "centre: None is not a pair of numbers"),
        ((shapely.MultiPoint([(1, 2)]), 1, 1), "centre: <MULTIPOINT .*> is not a pair of numbers"),
        (((0, 0), "1", 1), "radius: '1' is not a number"),
        (((0, 0), 1, None), "tolerance: None is not a number"),
        (((0, 0), 10**400, 1), "radius: 100.* is not a number that a finite float can be near to"),
        (((0, 0), -1, 1), ".*radius.*"),
        (((0, 0), 1, 0), ".*tolerance.*"),
        (((0, 0), 1, 1e-30), ".*tolerance.*"),
        (((math.nan, 0), 1, 1), ".*centre.*"),
    ],
)
def test_disc_refused(arguments: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{reason}$"):
        gcv.Polygon.disc(*arguments)


def test_disc_rounding_refused() -> None:
    with pytest.raises(ValueError, match="rounding is 'up'"):
        gcv.Polygon.disc((0, 0), 1, 0.1, rounding="up")  # type: ignore[arg-type]


# ----------------------------------------------------------------- affine --

IDENTITY = (1, 0, 0, 0, 1, 0)
QUARTER_TURN = (0, -1, 0, 1, 0, 0)
REFLECTION = (-1, 0, 0, 0, 1, 0)
NO_MATRIX = "is not 2 rows of 2 or 3 numbers, 3 rows of 3 that end with 0 0 1, or 6 numbers"
SHEAR = (1.1, 0.3, 7.0, -0.2, 0.9, -1 / 3)


def image(matrix: tuple[float, ...], point: tuple[float, float]) -> tuple[float, float]:
    a, b, c, d, e, f = map(Fraction, matrix)
    x, y = map(Fraction, point)
    return float(a * x + b * y + c), float(d * x + e * y + f)


def rings_of(polygon: gcv.Polygon) -> list[set[tuple[float, float]]]:
    return [{(float(x), float(y)) for x, y in ring} for ring in polygon.rings]


COEFFICIENTS = st.one_of(st.integers(-3, 3).map(float), st.floats(-4, 4))


@given(polygons(), st.tuples(*6 * [COEFFICIENTS]))
def test_affine(polygon: gcv.Polygon, matrix: tuple[float, ...]) -> None:
    a, b, _, d, e, _ = map(Fraction, matrix)
    expected = [image(matrix, vertex) for vertex in points(polygon)]
    try:
        ring = gcv.Polygon(expected)
    except gcv.InputError as error:
        with pytest.raises(gcv.InputError) as raised:
            polygon.affine(matrix)
        assert raised.value.status == error.status
        return
    assume(a * e != b * d)
    moved = polygon.affine(matrix)
    assert moved == ring
    assert pickle.loads(pickle.dumps(moved)) == moved


def test_affine_matrices() -> None:
    polygon = gcv.Polygon(NOTCHED)
    expected = polygon.affine(SHEAR)
    forms: list[Any] = [
        [SHEAR[:3], SHEAR[3:]],
        np.array(SHEAR),
        np.array(SHEAR).reshape(2, 3),
        np.array([*SHEAR, 0, 0, 1]).reshape(3, 3),
        [SHEAR[:3], SHEAR[3:], (0, 0, 1)],
        iter(SHEAR),
    ]
    for matrix in forms:
        assert polygon.affine(matrix) == expected
    turned = polygon.affine(QUARTER_TURN)
    assert polygon.affine([[0, -1], [1, 0]]) == turned
    assert polygon.affine(np.array([(0, -1), (1, 0)])) == turned


def test_affine_of_holes() -> None:
    assert rings_of(PLATE.affine(SHEAR)) == [
        {image(SHEAR, vertex) for vertex in ring} for ring in (SQUARE, HOLE)
    ]
    assert PLATE.affine(QUARTER_TURN).area == PLATE.affine(REFLECTION).area == PLATE.area
    assert PLATE.affine(IDENTITY) == PLATE
    assert PLATE.translated((3, 4)) == gcv.Polygon(
        shapely.affinity.translate(shapely.geometry.shape(PLATE), 3, 4)
    )


SOURCES: list[Any] = [
    NOTCHED,
    NOTCHED[::-1],
    [*NOTCHED, NOTCHED[0]],
    [*NOTCHED[2:], *NOTCHED[:2]],
    BUMPY,
    [(0, 0), (1, 0), (2, 0), (2, 0), (2, 2), (0, 2), (0, 1), (0, 0)],
    PLATE,
]


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("matrix", [SHEAR, QUARTER_TURN, REFLECTION])
def test_affine_keeps_numbers(source: Any, matrix: tuple[float, ...]) -> None:
    """Sources, the numbers of the polygon as passed, say where each exact edge lies."""
    passed = gcv.Polygon(source)
    if isinstance(source, gcv.Polygon):
        source = points(source)
    polygon = passed.affine(matrix)
    for same in (polygon, pickle.loads(pickle.dumps(polygon)), negative(negative(polygon))):
        face = gcv.minkowski_sum(same, TRIANGLE)
        assert face.sources == (polygon + gcv.Polygon(TRIANGLE)).sources
        corners = [image(matrix, vertex) for vertex in source]
        for vertex, where in zip(face.exact, face.sources):
            if where.kind == gcv.EDGE_CORNER:
                x, y = corners[where.a]
                ends = [(Fraction(x) + Fraction(u), Fraction(y) + Fraction(v)) for u, v in TRIANGLE]
                assert vertex in ends


def test_affine_again_and_again() -> None:
    for source in (NOTCHED, BUMPY[::-1], [(0, 0), (1, 0), (2, 0), (2, 2), (0, 2)], PLATE):
        polygon = start = gcv.Polygon(source)
        for _ in range(4):
            polygon = polygon.affine(QUARTER_TURN)
            assert pickle.loads(pickle.dumps(polygon)) == polygon
            assert gcv.Polygon(polygon) == polygon
        assert polygon == start
        assert len(pickle.dumps(polygon)) < 1000
        assert (polygon + PLATE).sources == (start + PLATE).sources
        assert (-polygon + PLATE).sources == (-start + PLATE).sources


def test_holes_can_be_added_after_maps() -> None:
    square = gcv.Polygon([(0, 0), (0.5, 0), (1, 0), (1, 1), (0, 1)]).affine(IDENTITY)
    assert gcv.Polygon(square, [HOLE]) == PLATE


@pytest.mark.parametrize(
    ("matrix", "reason"),
    [
        (None, f"matrix: None {NO_MATRIX}"),
        ([1, 2], rf"matrix: \[1, 2\] {NO_MATRIX}"),
        (np.ones((3, 3)), f"matrix: .* {NO_MATRIX}"),
        (np.eye(3)[:, :2], f"matrix: .* {NO_MATRIX}"),
        (np.zeros((2, 3, 2)), f"matrix: .* {NO_MATRIX}"),
        ([[1, 0], [0, 1, 0, 0]], f"matrix: .* {NO_MATRIX}"),
        ("abcdef", f"matrix: 'abcdef' {NO_MATRIX}"),
        ((1, 0, 0, 0, 10**400, 0), "matrix: .* is not a number that a finite float can be near to"),
        ((1, 0, math.nan, 0, 1, 0), "matrix: number 2 is nan, not finite"),
        ((1, 0, 0, 1, 0, 0), "the mapped polygon: .*"),
    ],
)
def test_affine_refused(matrix: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{reason}$"):
        PLATE.affine(matrix)


def test_affine_out_of_range() -> None:
    with pytest.raises(gcv.Error, match="beyond the largest double") as raised:
        PLATE.affine((1e308, 1e308, 0, 0, 1, 0))
    assert raised.value.status_name == "GCV_ERR_RANGE"
    with pytest.raises(gcv.InputError, match="vector: None is not a pair"):
        PLATE.translated(None)  # type: ignore[arg-type]

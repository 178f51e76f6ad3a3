# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What holds for all polygons."""

from __future__ import annotations

import pickle
from fractions import Fraction
from functools import cmp_to_key
from typing import Union

import numpy as np
from hypothesis import given, reject
from hypothesis import strategies as st

import gcv

ExactPoint = tuple[Fraction, Fraction]

# Small integers give many ties, the others few.
COORDINATES = st.one_of(
    st.integers(-6, 6).map(float),
    st.floats(-100, 100, allow_subnormal=False),
)


def half(p: tuple[float, float]) -> int:
    return 0 if p[1] > 0 or (p[1] == 0 and p[0] > 0) else 1


def turn(p: tuple[float, float], q: tuple[float, float]) -> int:
    if half(p) != half(q):
        return half(p) - half(q)
    cross = Fraction(p[0]) * Fraction(q[1]) - Fraction(p[1]) * Fraction(q[0])
    return -1 if cross > 0 else 1 if cross < 0 else 0


@st.composite
def polygons(draw: st.DrawFn) -> gcv.Polygon:
    """A polygon that sees the origin: points sorted by exact angle, one in each direction."""
    points = draw(st.lists(st.tuples(COORDINATES, COORDINATES), min_size=1, max_size=8))
    points += [(7.0, 0.0), (-5.0, 6.0), (-5.0, -7.0)]
    ring: list[tuple[float, float]] = []
    for point in sorted((p for p in points if p != (0, 0)), key=cmp_to_key(turn)):
        if not ring or turn(ring[-1], point) != 0:
            ring.append(point)
    return gcv.Polygon(ring)


def contains(ring: list[ExactPoint], p: ExactPoint) -> bool:
    """Whether p is in the ring or on it."""
    inside = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        cross = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
        between = min(ax, bx) <= p[0] <= max(ax, bx) and min(ay, by) <= p[1] <= max(ay, by)
        if cross == 0 and between:
            return True
        if (ay <= p[1]) != (by <= p[1]) and (cross > 0) == (by > ay):
            inside = not inside
    return inside


def exact_points(ring: Union[gcv.Polygon, gcv.OuterFace]) -> list[ExactPoint]:
    return [(Fraction(x), Fraction(y)) for x, y in ring.vertices.tolist()]


def canonical(ring: list[ExactPoint]) -> list[ExactPoint]:
    first = ring.index(min(ring))
    return ring[first:] + ring[:first]


@given(polygons(), polygons())
def test_commutes(a: gcv.Polygon, b: gcv.Polygon) -> None:
    assert a + b == b + a


@given(polygons(), polygons())
def test_reflects(a: gcv.Polygon, b: gcv.Polygon) -> None:
    reflected = canonical([(-x, -y) for x, y in (a + b).exact])
    assert (-a + -b).exact == reflected


@given(polygons(), polygons(), st.tuples(COORDINATES, COORDINATES))
def test_translates(a: gcv.Polygon, b: gcv.Polygon, by: tuple[float, float]) -> None:
    dx, dy = map(Fraction, by)
    moved = [(x + dx, y + dy) for x, y in (a + -b).exact]
    assert gcv.no_fit_polygon(a, b, by).exact == moved
    assert gcv.entrance_block(b, a, by).exact == moved


@given(polygons(), polygons())
def test_contains_every_sum_of_vertices(a: gcv.Polygon, b: gcv.Polygon) -> None:
    ring = (a + b).exact
    for ax, ay in exact_points(a):
        for bx, by in exact_points(b):
            assert contains(ring, (ax + bx, ay + by))


@given(polygons(), polygons())
def test_sources_tell_where_edges_lie(a: gcv.Polygon, b: gcv.Polygon) -> None:
    a, b = gcv.Polygon(a.vertices), gcv.Polygon(b.vertices)
    face = a + b
    p, q = exact_points(a), exact_points(b)
    ring = face.exact
    for start, end, source in zip(ring, ring[1:] + ring[:1], face.sources):
        if source.kind == gcv.EDGE_CORNER:
            along, edge, other, vertex = q, source.b, p, source.a
        else:
            along, edge, other, vertex = p, source.a, q, source.b
        (ux, uy), (vx, vy) = along[edge], along[(edge + 1) % len(along)]
        for x, y in (start, end):
            offset = x - other[vertex][0] - ux, y - other[vertex][1] - uy
            assert (vx - ux) * offset[1] == (vy - uy) * offset[0]


@given(polygons(), polygons())
def test_outward_contains_exact(a: gcv.Polygon, b: gcv.Polygon) -> None:
    face = gcv.minkowski_sum(a, b, rounding="outward")
    ring = exact_points(face)
    for vertex in face.exact:
        assert contains(ring, vertex)


@given(polygons(), polygons())
def test_nearest_is_within_the_bound(a: gcv.Polygon, b: gcv.Polygon) -> None:
    face = a + b
    bound = Fraction(face.error_bound)
    exact = face.exact
    for x, y in exact_points(face):
        assert min((x - u) ** 2 + (y - v) ** 2 for u, v in exact) <= bound**2


@given(polygons(), st.floats(0, 300))
def test_simplified(polygon: gcv.Polygon, tolerance: float) -> None:
    near, bound = polygon.simplified(tolerance)
    around, bound_around = polygon.simplified(tolerance, rounding="outward")
    assert 0 <= bound <= tolerance
    assert 0 <= bound_around <= tolerance
    assert set(exact_points(near)) <= set(exact_points(polygon))
    ring = exact_points(around)
    for vertex in exact_points(polygon):
        assert contains(ring, vertex)


@given(polygons(), polygons(), st.floats(0, 300))
def test_outward_within_a_tolerance(a: gcv.Polygon, b: gcv.Polygon, tolerance: float) -> None:
    face = gcv.minkowski_sum(a, b, rounding="outward", tolerance=tolerance)
    ring = exact_points(face)
    for vertex in (a + b).exact:
        assert contains(ring, vertex)


@given(st.lists(st.tuples(polygons(), polygons()), max_size=6), st.integers(0, 3))
def test_many_are_what_each_is(pairs: list[tuple[gcv.Polygon, gcv.Polygon]], threads: int) -> None:
    faces = gcv.minkowski_sum_many([a for a, _ in pairs], [b for _, b in pairs], threads=threads)
    assert faces == [a + b for a, b in pairs]


@st.composite
def frames(draw: st.DrawFn) -> gcv.Polygon:
    """A polygon with a hole of the same form, where rounding does not make these cross."""
    polygon = draw(polygons())
    hole = draw(st.sampled_from([0.5, 0.75])) * polygon.vertices
    try:
        return gcv.Polygon(polygon, [hole])
    except gcv.InputError:
        reject()


SMALL = st.builds(
    lambda polygon, factor: gcv.Polygon(factor * polygon.vertices),
    polygons(),
    st.sampled_from([0.03125, 0.25, 0.75]),
)


@given(frames(), SMALL)
def test_regions_begin_with_the_outer_face(a: gcv.Polygon, b: gcv.Polygon) -> None:
    region, face = gcv.minkowski_sum_region(a, b), a + b
    assert region.exact[: len(face.exact)] == face.exact
    assert region.polygons[0].outer.tolist() == face.vertices.tolist()
    assert region.area <= face.area
    assert len(region) == 1


@given(frames(), SMALL, st.lists(st.tuples(COORDINATES, COORDINATES), max_size=5))
def test_places_without_the_library(
    a: gcv.Polygon, b: gcv.Polygon, points: list[tuple[float, float]]
) -> None:
    for region in (gcv.no_fit_region(a, b), gcv.inner_fit_region(a, b)):
        duplicate = pickle.loads(pickle.dumps(region))
        assert duplicate == region
        points = points + [(x, y) for x, y in region.vertices.tolist()]
        assert region.locate(points).tolist() == duplicate.locate(points).tolist()
        for x, y in region.exact:
            if Fraction(float(x)) == x and Fraction(float(y)) == y:
                assert region.locate((float(x), float(y))) is gcv.BOUNDARY


@given(frames(), SMALL)
def test_outward_regions(a: gcv.Polygon, b: gcv.Polygon) -> None:
    """No corner of a no-fit region is inside the exact one, none of an inner fit outside."""
    outer = gcv.no_fit_region(a, b, rounding="outward")
    assert (outer.locate(outer.vertices) <= 0).all()
    inner = gcv.inner_fit_region(a, b, rounding="outward")
    assert (inner.locate(inner.vertices) >= 0).all()


@given(frames(), SMALL)
def test_inner_fits_are_free(a: gcv.Polygon, b: gcv.Polygon) -> None:
    """A part in the container, which is placed by it, does not overlap what is in its hole."""
    inner = gcv.inner_fit_region(a, b, rounding="outward")
    solid = gcv.no_fit_region(a.holes[0], b)
    assert (solid.locate(inner.vertices) <= 0).all()


@given(st.lists(st.tuples(frames(), SMALL), max_size=4), st.integers(0, 2))
def test_many_regions_are_what_each_is(
    pairs: list[tuple[gcv.Polygon, gcv.Polygon]], threads: int
) -> None:
    a, b = [a for a, _ in pairs], [b for _, b in pairs]
    regions = gcv.minkowski_sum_region_many(a, b, threads=threads)
    assert regions == [gcv.minkowski_sum_region(p, q) for p, q in pairs]
    centres = [p.vertices[0] for p in a]
    regions = gcv.no_fit_region_many(a, b, centres, threads=threads)
    assert regions == [gcv.no_fit_region(p, q, c) for p, q, c in zip(a, b, centres)]


@given(polygons(), polygons())
def test_pickles(a: gcv.Polygon, b: gcv.Polygon) -> None:
    a_copy, b_copy, face = pickle.loads(pickle.dumps((a, b, a + b)))
    assert (a_copy, b_copy) == (a, b)
    assert face == a + b
    assert face.sources == (a_copy + b_copy).sources
    assert face.polygon == (a + b).polygon


@given(polygons(), st.integers(0, 3), st.booleans())
def test_sources_of_any_layout(polygon: gcv.Polygon, gap: int, reverse: bool) -> None:
    table = np.full((len(polygon), 2 + gap), np.nan)
    table[:, [0, -1]] = polygon.vertices
    view = table[:, :: 1 + gap]
    assert gcv.Polygon(view[::-1] if reverse else view) == polygon
    assert gcv.Polygon(np.asfortranarray(view)) == polygon

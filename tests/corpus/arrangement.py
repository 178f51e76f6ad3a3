# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Points, segments, and the arrangement of segments, in fractions."""

from __future__ import annotations

from fractions import Fraction
from functools import cmp_to_key

Point = tuple[Fraction, Fraction]
Segment = tuple[Point, Point]


def cross(o: Point, a: Point, b: Point) -> Fraction:
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def area_twice(ring: list[Point]) -> Fraction:
    return sum((p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1])), Fraction(0))


def edges(ring: list[Point]) -> list[Segment]:
    return [(p, q) for p, q in zip(ring, ring[1:] + ring[:1]) if p != q]


def plus(p: Point, q: Point) -> Point:
    return (p[0] + q[0], p[1] + q[1])


def within(p: Point, start: Point, end: Point) -> bool:
    """Whether p, a point of the line through start and end, is between them."""
    return min(start, end) <= p <= max(start, end)


def are_apart(s: Segment, t: Segment) -> bool:
    """Whether a look at the coordinates tells that two segments do not meet."""
    return (
        max(s) < min(t)
        or max(t) < min(s)
        or max(s[0][1], s[1][1]) < min(t[0][1], t[1][1])
        or max(t[0][1], t[1][1]) < min(s[0][1], s[1][1])
    )


def meeting_points(s: Segment, t: Segment) -> list[Point]:
    """Where two segments meet: a point, or the ends of what they share."""
    if are_apart(s, t):
        return []
    a, b = cross(*t, s[0]), cross(*t, s[1])
    if a == b:
        if a != 0:
            return []
        return [p for p in t if within(p, *s)] + [p for p in s if within(p, *t)]
    at = a / (a - b)
    p = (s[0][0] + at * (s[1][0] - s[0][0]), s[0][1] + at * (s[1][1] - s[0][1]))
    return [p] if within(p, *s) and within(p, *t) else []


def arrangement(segments: set[Segment]) -> dict[Point, set[Point]]:
    """The neighbours of every vertex."""
    cuts = {(min(s), max(s)): set(s) for s in segments}
    ordered = sorted(cuts)
    for k, s in enumerate(ordered):
        for t in ordered[k + 1 :]:
            if t[0] > s[1]:
                break
            points = meeting_points(s, t)
            cuts[s].update(points)
            cuts[t].update(points)
    neighbours: dict[Point, set[Point]] = {}
    for points_of_one in cuts.values():
        chain = sorted(points_of_one)
        for p, q in zip(chain, chain[1:]):
            neighbours.setdefault(p, set()).add(q)
            neighbours.setdefault(q, set()).add(p)
    return neighbours


def direction(p: Point, q: Point) -> Point:
    return (q[0] - p[0], q[1] - p[1])


def is_before(u: Point, v: Point, start: Point) -> bool:
    """Whether, turning counter-clockwise from the direction `start`, u comes before v."""

    def half(w: Point) -> int:
        turn = start[0] * w[1] - start[1] * w[0]
        ahead = start[0] * w[0] + start[1] * w[1] > 0
        return (0 if ahead else 2) if turn == 0 else (1 if turn > 0 else 3)

    if half(u) != half(v):
        return half(u) < half(v)
    return u[0] * v[1] - u[1] * v[0] > 0


def around(p: Point, neighbours: set[Point]) -> list[Point]:
    """The neighbours of p, counter-clockwise."""
    east = (Fraction(1), Fraction(0))

    def order(q: Point, r: Point) -> int:
        u, v = direction(p, q), direction(p, r)
        return -1 if is_before(u, v, east) else 1 if is_before(v, u, east) else 0

    return sorted(neighbours, key=cmp_to_key(order))


def without_straight_angles(ring: list[Point]) -> list[Point]:
    return [
        q
        for p, q, r in zip(ring[-1:] + ring[:-1], ring, ring[1:] + ring[:1])
        if cross(p, q, r) != 0
    ]

# SPDX-License-Identifier: LGPL-3.0-or-later
"""What rings, segments and points are as a set of points, in fractions.

A ring may run along a segment to and fro, as those of orbiting methods do. So what is walked an odd
number of times is the boundary of a polygon, and what is walked an even number of times a segment.
Where rings begin, which way round they go, vertices at angles of 180 degrees, and which of several
rings has which part of the boundary do not matter.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import NamedTuple

Point = tuple[Fraction, Fraction]
Ring = list[Point]
Segment = tuple[Point, Point]


class PointSet(NamedTuple):
    """The longest pieces of the boundary, the longest segments, and points on neither of them."""

    boundary: frozenset[Segment]
    segments: frozenset[Segment]
    points: frozenset[Point]


def point_set(rings: Iterable[Ring]) -> PointSet:
    """Of closed rings; one of two points is a segment, one of one point is a point."""
    walks = list(rings)
    lines: dict[object, list[Segment]] = defaultdict(list)
    for walk in walks:
        for p, q in zip(walk, walk[1:] + walk[:1]):
            if p != q:
                lines[_line_through(p, q)].append((min(p, q), max(p, q)))
    boundary: set[Segment] = set()
    segments: set[Segment] = set()
    for pieces in lines.values():
        for is_boundary, piece in _longest(pieces):
            (boundary if is_boundary else segments).add(piece)
    points = {
        walk[0]
        for walk in walks
        if len(set(walk)) == 1 and not any(is_on(walk[0], s) for s in boundary | segments)
    }
    return PointSet(frozenset(boundary), frozenset(segments), frozenset(points))


def is_on(p: Point, segment: Segment) -> bool:
    a, b = segment
    cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    return cross == 0 and a <= p <= b


def _line_through(p: Point, q: Point) -> tuple[Fraction, Fraction] | Fraction:
    """Its slope and where it meets the y axis, or the x of a vertical one."""
    if p[0] == q[0]:
        return p[0]
    slope = (q[1] - p[1]) / (q[0] - p[0])
    return slope, p[1] - slope * p[0]


def _longest(pieces: list[Segment]) -> Iterator[tuple[bool, Segment]]:
    """The pieces of one line joined; whether they are walked an odd number of times."""
    changes: Counter[Point] = Counter()
    for p, q in pieces:
        changes[p] += 1
        changes[q] -= 1
    walked = 0
    start: Point | None = None
    for p in sorted(changes):
        before, walked = walked, walked + changes[p]
        if start is not None and (walked == 0 or walked % 2 != before % 2):
            yield before % 2 == 1, (start, p)
            start = None
        if start is None and walked > 0:
            start = p


def snapped(ring: Ring, exact: Iterable[Point], rounding: Fraction) -> Ring:
    """A rounded ring on exact vertices.

    Its vertices go to exact ones that are as near as the rounding. Others are left out where they
    are as near to the way from the one before to the one behind.
    """
    vertices = set(exact)
    walk = [p if p in vertices else _nearest(p, vertices, rounding) for p in ring]
    kept: list[Point] = []
    for k, p in enumerate(walk):
        before = kept[-1] if kept else walk[-1]
        behind = walk[(k + 1) % len(walk)]
        if p in vertices or not _is_near(p, before, behind, rounding):
            kept.append(p)
    return kept


def _nearest(p: Point, vertices: set[Point], rounding: Fraction) -> Point:
    near = [v for v in vertices if max(abs(v[0] - p[0]), abs(v[1] - p[1])) <= rounding]
    return min(near, key=lambda v: abs(v[0] - p[0]) + abs(v[1] - p[1]), default=p)


def _is_near(p: Point, a: Point, b: Point, rounding: Fraction) -> bool:
    """Whether p is between a and b, and no further from their line in x or y than the rounding."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    along = dx * (p[0] - a[0]) + dy * (p[1] - a[1])
    across = abs(dx * (p[1] - a[1]) - dy * (p[0] - a[0]))
    return 0 <= along <= dx * dx + dy * dy and across <= rounding * max(abs(dx), abs(dy))

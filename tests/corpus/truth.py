#!/usr/bin/env python3
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Recomputes every ring of the corpus in fractions, without the library.

truth.py FILE prints the file with the rings that it finds in place of those in it.
truth.py --check FILE prints the lines that come out otherwise than they went in, and
fails if there are any.

Every edge of A moved to every vertex of B, and the reverse, lies in A + B, and all of
the boundary of A + B lies on these segments. So the ring is the boundary of the
unbounded face of their arrangement, which is made here by cutting every segment at every
other, and walked from its smallest vertex, always turning right as far as possible.
"""

from __future__ import annotations

import re
import sys
from fractions import Fraction
from pathlib import Path

Point = tuple[Fraction, Fraction]


def ring_of(wkt: str) -> list[Point]:
    """The outer ring of a polygon; coordinates are the doubles nearest to the text."""
    text = re.search(r"\(\s*\(([^()]*)\)", wkt)
    assert text, wkt
    ring = [tuple(Fraction(float(c)) for c in pair.split()) for pair in text[1].split(",")]
    return [(x, y) for x, y in ring]


def cross(o: Point, a: Point, b: Point) -> Fraction:
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def edges(ring: list[Point]) -> list[tuple[Point, Point]]:
    return [(p, q) for p, q in zip(ring, ring[1:] + ring[:1]) if p != q]


def plus(p: Point, q: Point) -> Point:
    return (p[0] + q[0], p[1] + q[1])


def within(p: Point, start: Point, end: Point) -> bool:
    """Whether p, a point of the line through start and end, is between them."""
    return min(start, end) <= p <= max(start, end)


def meeting_points(s: tuple[Point, Point], t: tuple[Point, Point]) -> list[Point]:
    """Where two segments meet: a point, or the ends of what they share."""
    a, b = cross(*t, s[0]), cross(*t, s[1])
    if a == b:
        if a != 0:
            return []
        return [p for p in t if within(p, *s)] + [p for p in s if within(p, *t)]
    at = a / (a - b)
    p = (s[0][0] + at * (s[1][0] - s[0][0]), s[0][1] + at * (s[1][1] - s[0][1]))
    return [p] if within(p, *s) and within(p, *t) else []


def arrangement(segments: list[tuple[Point, Point]]) -> dict[Point, set[Point]]:
    """The neighbours of every vertex."""
    neighbours: dict[Point, set[Point]] = {}
    for s in segments:
        cuts = {p for t in segments for p in meeting_points(s, t)}
        chain = sorted(cuts)
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


def outer_face(a: list[Point], b: list[Point]) -> list[Point]:
    """The boundary of the unbounded face, from its smallest vertex, without straight angles."""
    segments = {(plus(p, v), plus(q, v)) for p, q in edges(a) for v in b}
    segments |= {(plus(p, v), plus(q, v)) for p, q in edges(b) for v in a}
    neighbours = arrangement(list(segments))
    start = min(neighbours)
    walk = [start]
    back = (Fraction(-1), Fraction(0))
    while True:
        here = walk[-1]
        following = None
        for candidate in neighbours[here]:
            towards = direction(here, candidate)
            if len(walk) > 1 and candidate == walk[-2]:
                continue
            if following is None or is_before(towards, direction(here, following), back):
                following = candidate
        assert following is not None
        if here == start and len(walk) > 1 and following == walk[1]:
            break
        walk.append(following)
        back = direction(following, here)
    walk.pop()
    return [
        q
        for p, q, r in zip(walk[-1:] + walk[:-1], walk, walk[1:] + walk[:1])
        if cross(p, q, r) != 0
    ]


def negative(ring: list[Point]) -> list[Point]:
    return [(-x, -y) for x, y in ring]


def shifted(ring: list[Point], words: list[str]) -> list[Point]:
    x, y = (Fraction(float(word)) for word in words)
    return [plus(p, (x, y)) for p in ring]


def text_of(ring: list[Point]) -> str:
    return ", ".join(
        f"{x.numerator}/{x.denominator} {y.numerator}/{y.denominator}" for x, y in ring
    )


def recomputed(lines: list[str]) -> list[str]:
    a: list[Point] = []
    b: list[Point] = []
    result = []
    for line in lines:
        key, _, rest = line.partition(" ")
        if key in ("a", "b"):
            a, b = (ring_of(rest), b) if key == "a" else (a, ring_of(rest))
        found = re.match(r"(sum|no_fit|entrance)(( \S+ \S+)?) GCV_OK", line)
        if found:
            point = found[2].split() or ["0", "0"]
            first, second = {
                "sum": (a, b),
                "no_fit": (a, negative(b)),
                "entrance": (negative(a), b),
            }[key]
            line = f"{found[0]} {text_of(outer_face(shifted(first, point), second))}"
        result.append(line)
    return result


def main(arguments: list[str]) -> int:
    lines = Path(arguments[-1]).read_text().splitlines()
    results = recomputed(lines)
    if arguments[:-1] != ["--check"]:
        print("\n".join(results))
        return 0
    wrong = [pair for pair in zip(lines, results) if pair[0] != pair[1]]
    for line, result in wrong:
        print(f"{line}\n  should be: {result}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

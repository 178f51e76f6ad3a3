#!/usr/bin/env python3
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Recomputes every ring, region and answer of the corpus in fractions, without the library.

truth.py FILE prints the file with the rings, regions and answers that it finds in place of those
in it.
truth.py --check FILE prints the lines that come out otherwise than they went in, and
fails if there are any.

Every edge of A moved to every vertex of B, and the reverse, lies in A + B, and all of
the boundary of A + B lies on these segments. So the ring is the boundary of the
unbounded face of their arrangement, which is made here by cutting every segment at every
other, and walked from its smallest vertex, always turning right as far as possible.
regions.py says how regions are found, questions.py how answers about two polygons are, and
scenes.py how answers about scenes are.
"""

from __future__ import annotations

import re
import sys
from fractions import Fraction
from pathlib import Path

import questions
import scenes
from arrangement import (
    Point,
    arrangement,
    direction,
    edges,
    is_before,
    plus,
    without_straight_angles,
)
from regions import Polygon, Solid, region, text_of_parts, text_of_ring
from scenes import CONTAINER, Scene


def rings_of(wkt: str) -> list[list[Point]]:
    """The rings of a polygon; coordinates are the doubles nearest to the text."""
    rings = []
    for text in re.findall(r"\(\s*([^()]+)\)", wkt):
        ring = [tuple(Fraction(float(c)) for c in pair.split()) for pair in text.split(",")]
        rings.append([(x, y) for x, y in ring])
    assert rings, wkt
    return rings


def outer_face(a: list[Point], b: list[Point]) -> list[Point]:
    """The boundary of the unbounded face, from its smallest vertex, without straight angles."""
    segments = {(plus(p, v), plus(q, v)) for p, q in edges(a) for v in b}
    segments |= {(plus(p, v), plus(q, v)) for p, q in edges(b) for v in a}
    neighbours = arrangement(segments)
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
    return without_straight_angles(walk)


def negative(polygon: Polygon) -> Polygon:
    return [[(-x, -y) for x, y in ring] for ring in polygon]


def shifted(polygon: Polygon, words: list[str]) -> Polygon:
    x, y = (Fraction(float(word)) for word in words)
    return [[plus(p, (x, y)) for p in ring] for ring in polygon]


def recomputed(lines: list[str]) -> list[str]:
    a: Polygon = []
    b: Polygon = []
    solids: dict[int, Solid] = {}
    scene: Scene | None = None
    result = []
    for line in lines:
        key, _, rest = line.partition(" ")
        if key == "case":
            solids, scene = {}, None
        elif key == "a":
            a = rings_of(rest)
        elif key == "b":
            b = rings_of(rest)
        elif key == "container":
            solids[CONTAINER] = Solid(rings_of(rest), is_outside=True)
        elif key == "member":
            polygon = shifted(rings_of(rest), rest.split()[:2])
            solids[max([CONTAINER, *solids]) + 1] = Solid(polygon)
        found = re.match(r"(sum|no_fit|entrance|inner_fit)(_region)?(( \S+ \S+)?) GCV_OK", line)
        if found:
            point = found[3].split() or ["0", "0"]
            first, second = {
                "sum": (a, b),
                "no_fit": (a, negative(b)),
                "entrance": (negative(a), b),
                "inner_fit": (a, negative(b)),
            }[found[1]]
            first = shifted(first, point)
            if found[2]:
                solid = Solid(first, is_outside=found[1] == "inner_fit")
                text = text_of_parts(region([solid], Solid(second)))
            else:
                text = text_of_ring(outer_face(first[0], second[0]))
            line = f"{found[0]} {text}"
        asked = re.match(r"(relation|distance|cast|penetration|contacts) (.*?) GCV_", line)
        if asked:
            text = questions.answer(Solid(a), Solid(b), asked[1], asked[2].split())
            line = f"{asked[1]} {asked[2]} {text}"
        asked = re.match(r"scene_(\w+)(.*?) GCV_", line)
        if asked:
            scene = scene or Scene(solids, Solid(b))
            text = scenes.answer(scene, asked[1], asked[2].split())
            line = f"scene_{asked[1]}{asked[2]} {text}"
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

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Cuts a square into pieces, and puts each of them back into its own place.

The pieces are the triangles of a jittered grid, joined at random. Neighbours have their
vertices in common, so the pieces tile the square exactly, in floats of 53 bits. A piece that is
taken out of the full square has one place in it, a single point, and overlaps something at the
next float beside it. With a neighbour out as well, it may have room to move, or have a way to
slide along. All of that is checked, and counted.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from math import ceil, nextafter, sqrt
from random import Random
from time import perf_counter
from typing import Optional

import gcv

Point = tuple[float, float]
Piece = dict[Point, Point]
"""For each vertex the next one, counter-clockwise."""

SIDE = 100.0
TRIANGLES_A_PIECE = 10
JITTER = 0.2  # of the width of a cell: with less than a quarter all triangles keep their turn
HERE = (0.0, 0.0)
HERE_EXACTLY = [(Fraction(0), Fraction(0))]
BESIDE = [(nextafter(0, x), nextafter(0, y)) for x in (-1, 0, 1) for y in (-1, 0, 1) if x or y]


def triangles(cells: int, random: Random) -> Iterator[Piece]:
    """Those of a grid of cells by cells, jittered but for the sides of the square."""

    def coordinate(k: int) -> float:
        jitter = 0 if k in (0, cells) else random.uniform(-JITTER, JITTER)
        return SIDE * (k + jitter) / cells

    columns = range(cells + 1)
    grid = [[(coordinate(i), coordinate(j)) for j in columns] for i in columns]
    for i in range(cells):
        for j in range(cells):
            quad = [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]]
            turn = random.randrange(2)
            a, b, c, d = quad[turn:] + quad[:turn]
            yield {a: b, b: c, c: a}
            yield {a: c, c: d, d: a}


def joined(piece: Piece, other: Piece) -> Optional[Piece]:
    """The two as one piece; None where that has a hole, or touches itself."""
    edges = [*piece.items(), *other.items()]
    inner = {(b, a) for a, b in edges}
    ring = dict(edge for edge in edges if edge not in inner)
    if len(ring) != sum(edge not in inner for edge in edges):
        return None
    return ring if len(outline(ring)) == len(ring) else None


def outline(piece: Piece) -> list[Point]:
    start = next(iter(piece))
    ring = [start]
    while piece[ring[-1]] != start:
        ring.append(piece[ring[-1]])
    return ring


def cut(count: int, random: Random) -> list[Piece]:
    """The square in so many pieces: each time a small one is joined to a neighbour."""
    pieces = list(triangles(ceil(sqrt(count * TRIANGLES_A_PIECE / 2)), random))
    while len(pieces) > count:
        random.shuffle(pieces)
        small, other, both = next(unions(pieces))
        pieces = [piece for piece in pieces if piece is not small and piece is not other]
        pieces.append(both)
    return pieces


def unions(pieces: list[Piece]) -> Iterator[tuple[Piece, Piece, Piece]]:
    """Two pieces that can be joined, and both as one; from the smallest piece on."""
    for small in sorted(pieces, key=len):
        for other in pieces:
            both = joined(small, other) if meet(small, other) else None
            if both is not None:
                yield small, other, both


def meet(piece: Piece, other: Piece) -> bool:
    """Whether they have an edge in common."""
    return any(other.get(b) == a for a, b in piece.items())


def kind_of_place(region: gcv.Region) -> str:
    """What of a region the origin lies on."""
    for part in region.exact_parts:
        corners = region.exact[part.start : part.stop]
        if part.kind == gcv.PART_POINT and corners == HERE_EXACTLY:
            return "a point"
        if part.kind == gcv.PART_SEGMENT and lies_between(*corners):
            return "on a segment"
    return "on a ring" if region.locate(HERE) is gcv.BOUNDARY else "not free"


def lies_between(start: tuple[Fraction, Fraction], end: tuple[Fraction, Fraction]) -> bool:
    """Whether the origin is on the segment."""
    (ax, ay), (bx, by) = start, end
    return ax * by == ay * bx and ax * bx + ay * by <= 0


def is_alone(scene: gcv.Scene, part: gcv.Polygon, id: int) -> bool:
    """Whether the part, taken out, fits at its own place, and nowhere else."""
    region = scene.free_region(part, ignore=id)
    return (
        scene.relation(part, HERE, ignore=id) is gcv.TOUCHING
        and set(scene.relation(part, BESIDE, ignore=id)) == {gcv.OVERLAPPING}
        and (region.exact, kind_of_place(region)) == (HERE_EXACTLY, "a point")
        and scene.best(part, (-1, 0), ignore=id) == HERE
        and not scene.free_region(part)
    )


def with_a_neighbour_out(scene: gcv.Scene, polygons: list[gcv.Polygon]) -> Counter[str]:
    """How the own place of the first of two pieces looks, over all pairs that touch."""
    kinds: Counter[str] = Counter()
    for pair in scene.pairs():
        if pair.a > 1:
            part = polygons[pair.a - 2]
            region = scene.free_region(part, ignore=[pair.a, pair.b])
            kinds[kind_of_place(region)] += 1
    return kinds


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pieces", type=int, default=60, metavar="N")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if options.pieces < 2:
        parser.error("a puzzle has two pieces at least")

    pieces = cut(options.pieces, Random(options.seed))
    polygons = gcv.Polygon.many(map(outline, pieces))
    scene = gcv.Scene([(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)])
    ids = [scene.add(polygon) for polygon in polygons]

    start = perf_counter()
    alone = sum(is_alone(scene, *one) for one in zip(polygons, ids))
    milliseconds = 1000 * (perf_counter() - start) / len(ids)
    vertices = sum(map(len, polygons))
    print(f"{len(ids)} pieces of {vertices} vertices, {milliseconds:.1f} ms for each")
    print(f"{alone} have one place when they are out: their own")
    kinds = with_a_neighbour_out(scene, polygons)
    counts = ", ".join(f"{kind} for {count}" for kind, count in sorted(kinds.items()))
    print(f"with a neighbour out, the own place is {counts}")
    if alone != len(ids) or "not free" in kinds:
        raise SystemExit("puzzle: a piece does not fit")


if __name__ == "__main__":
    main()

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Nests a dozen parts in a strip that is as high as two rows of them, and draws the result.

Each part goes as far left as it can, then as far down, while the parts before it stay where
they are. No-fit polygons say where that is: the reference point of a part, the lower left
corner of its box, must not be inside the no-fit polygon of any part before it. Positions
are fractions, so that parts that touch do so exactly. Places inside another no-fit polygon,
in a hole of it or where a part just fits, are left out: gcv.no_fit_region has those too.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import gcv

Point = tuple[Fraction, Fraction]
Ring = list[Point]
Edge = tuple[Point, Point]
Placed = tuple[gcv.Polygon, Point]

SHAPES = [
    [(0, 0), (12, 0), (12, 4), (5, 3), (4, 11), (0, 11)],  # a bracket
    [(0, 0), (11, 0), (11, 9), (8, 10), (7, 3), (4, 3), (3, 10), (0, 9)],  # a fork
    [(0, 0), (6, 4), (12, 0), (7, 11), (5, 11)],  # an arrow
    [(0, 3), (4, 4), (5, 0), (7, 4), (12, 5), (8, 7), (8, 12), (5, 8), (1, 9), (3, 6)],  # a star
]
TURNS = 3
COLOURS = ["#8da0cb", "#66c2a5", "#fc8d62", "#e78ac3"]


def parts() -> list[gcv.Polygon]:
    """Every shape at every turn, the lower left corner of its box at the origin."""
    return [gcv.Polygon(turned(shape, turn)) for turn in range(TURNS) for shape in SHAPES]


def turned(shape: list[tuple[int, int]], turn: int) -> list[tuple[int, int]]:
    for _ in range(turn):
        shape = [(-y, x) for x, y in shape]
    left, bottom = (min(axis) for axis in zip(*shape))
    return [(x - left, y - bottom) for x, y in shape]


def moved(ring: Iterable[Point], by: Point) -> Ring:
    return [(x + by[0], y + by[1]) for x, y in ring]


def edges(ring: Ring) -> Iterator[Edge]:
    return zip(ring, ring[1:] + ring[:1])


def side(edge: Edge, point: Point) -> Fraction:
    """Above 0 to the left of the edge, 0 on its line, below 0 to its right."""
    (x0, y0), (x1, y1) = edge
    return (x1 - x0) * (point[1] - y0) - (y1 - y0) * (point[0] - x0)


def on(edge: Edge, point: Point) -> bool:
    low, high = (tuple(map(choose, *edge)) for choose in (min, max))
    return all(a <= p <= b for a, p, b in zip(low, point, high)) and side(edge, point) == 0


def touches(ring: Ring, point: Point) -> bool:
    return any(on(edge, point) for edge in edges(ring))


def strictly_inside(ring: Ring, point: Point) -> bool:
    """Whether the point is inside, and not on the ring: by the edges to the right of it."""
    y = point[1]
    level = [(a, b) for a, b in edges(ring) if (a[1] <= y) != (b[1] <= y)]
    right = sum((side(edge, point) > 0) == (edge[0][1] <= y) for edge in level)
    return right % 2 == 1 and not touches(ring, point)


def crossing(e: Edge, f: Edge) -> Iterator[Point]:
    """The point that two edges of different directions share, if they share one."""
    start, end = side(f, e[0]), side(f, e[1])
    if start != end and start * end <= 0 and side(e, f[0]) * side(e, f[1]) <= 0:
        (x0, y0), (x1, y1) = e
        t = start / (start - end)
        yield x0 + t * (x1 - x0), y0 + t * (y1 - y0)


def leftmost(height: Fraction, length: Fraction, no_fits: list[Ring]) -> Point:
    """The leftmost, then lowest position of a part in a strip that is free.

    height and length say how far the reference point may go. The position is where two edges
    cross, of the no-fit polygons or of the box that the reference point is in.
    """
    zero = Fraction(0)
    box = [(zero, zero), (length, zero), (length, height), (zero, height)]
    lines = [edge for ring in (box, *no_fits) for edge in edges(ring)]
    candidates = {point for e, f in combinations(lines, 2) for point in crossing(e, f)}
    return next(
        (x, y)
        for x, y in sorted(candidates)
        if x >= 0 and 0 <= y <= height and not any(strictly_inside(n, (x, y)) for n in no_fits)
    )


def no_fit_polygons(part: gcv.Polygon, others: Iterable[Placed]) -> list[Ring]:
    """Where the part must not be, one ring for each of the others where they are."""
    return [
        moved(gcv.no_fit_polygon(other, part, (0, 0)).exact, position) for other, position in others
    ]


def nest(parts: list[gcv.Polygon], height: Fraction) -> list[Placed]:
    length = sum((Fraction(part.bounds[2]) for part in parts), Fraction(0))
    placed: list[Placed] = []
    for part in parts:
        _, _, _, top = part.bounds
        position = leftmost(height - Fraction(top), length, no_fit_polygons(part, placed))
        placed.append((part, position))
    return placed


def check(placed: list[Placed]) -> None:
    """No part overlaps another, and each touches one or the start of the strip."""
    for k, (part, position) in enumerate(placed):
        rings = no_fit_polygons(part, placed[:k] + placed[k + 1 :])
        if any(strictly_inside(ring, position) for ring in rings):
            raise SystemExit("nesting: parts overlap")
        if position[0] != 0 and not any(touches(ring, position) for ring in rings):
            raise SystemExit("nesting: a part touches none")


def svg(rings: list[Ring], length: Fraction, height: Fraction) -> str:
    """The strip as far as it is used, and the parts, upside down as y goes down in SVG."""
    across, up = float(length), float(height)
    paths = "".join(
        f'<path d="M{"L".join(f"{float(x)} {float(y)}" for x, y in ring)}Z" '
        f'fill="{COLOURS[k % len(COLOURS)]}"/>\n'
        for k, ring in enumerate(rings)
    )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="1000" '
        f'viewBox="-1 -1 {across + 2} {up + 2}">\n'
        f'<g transform="matrix(1 0 0 -1 0 {up})" stroke="#333" stroke-width="0.1">\n'
        f'<rect width="{across}" height="{up}" fill="#eee"/>\n{paths}</g>\n</svg>\n'
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--svg", type=Path, default=Path("nesting.svg"), metavar="FILE")
    file: Path = parser.parse_args().svg

    to_place = parts()
    height = Fraction(2 * max(part.bounds[3] for part in to_place))
    placed = nest(to_place, height)
    check(placed)
    rings = [
        moved([(Fraction(x), Fraction(y)) for x, y in part.vertices], position)
        for part, position in placed
    ]
    length = max(x for ring in rings for x, _ in ring)
    file.write_text(svg(rings, length, height), encoding="utf-8")
    print(f"{len(placed)} parts, length {length} (about {float(length):.3f}): {file}")


if __name__ == "__main__":
    main()

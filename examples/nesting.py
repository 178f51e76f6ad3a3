# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Nests parts in a strip, and draws the result.

The parts are placed one after another. Each goes to the best free position in a scene:
leftmost, and of these lowest, wherever it fits, also in between parts and into places of its
own width. It then becomes a member of the scene. Every placement is checked, exactly. With
--rotate, quarter turns are tried, and the one that ends furthest to the left is taken.

The parts are a dozen of four shapes, or those of a nesting instance, a JSON file of ESICUP with
"boards" and "pieces", the large ones first.
"""

from __future__ import annotations

import argparse
import json
from fractions import Fraction
from math import fsum
from pathlib import Path
from time import perf_counter
from typing import Any, NamedTuple, Optional

import gcv

Point = tuple[float, float]

SHAPES = [
    [(0, 0), (12, 0), (12, 4), (5, 3), (4, 11), (0, 11)],  # a bracket
    [(0, 0), (11, 0), (11, 9), (8, 10), (7, 3), (4, 3), (3, 10), (0, 9)],  # a fork
    [(0, 0), (6, 4), (12, 0), (7, 11), (5, 11)],  # an arrow
    [(0, 3), (4, 4), (5, 0), (7, 4), (12, 5), (8, 7), (8, 12), (5, 8), (1, 9), (3, 6)],  # a star
]
WIDTH = 24.0  # of the strip, twice that of the largest shape
DIRECTIONS = [(1, 0), (0, 1), (-1, 0), (0, -1)]  # of the x axis after quarter turns
LEFT = (-1, 0)
COLOURS = ["#8da0cb", "#66c2a5", "#fc8d62", "#e78ac3"]


class Part(NamedTuple):
    polygon: gcv.Polygon
    kind: int
    turns: tuple[int, ...]
    """The numbers of quarter turns that are allowed."""


class Place(NamedTuple):
    polygon: gcv.Polygon
    turn: int
    position: Point

    @property
    def end(self) -> Fraction:
        """How far it reaches to the right, exactly."""
        return Fraction(self.position[0]) + Fraction(self.polygon.bounds[2])


def turned(polygon: gcv.Polygon, turn: int) -> gcv.Polygon:
    """The polygon after quarter turns about the origin, which are exact."""
    x, y = DIRECTIONS[turn % 4]
    return polygon.affine([[x, -y, 0], [y, x, 0]])


def parts() -> list[gcv.Polygon]:
    """Every shape at three turns."""
    shapes = [gcv.Polygon(shape) for shape in SHAPES]
    return [turned(shape, turn) for turn in range(3) for shape in shapes]


def read(file: Path) -> tuple[list[Part], float]:
    """The parts of an instance, and the width of its strip."""
    instance = json.loads(file.read_text(encoding="utf-8"))
    width = max(y for _, y in outline(instance["boards"][0]))
    found = [
        Part(gcv.Polygon(outline(piece)), kind, tuple(angle // 90 for angle in piece["angles"]))
        for kind, piece in enumerate(instance["pieces"])
        for _ in range(piece["quantity"])
    ]
    return sorted(found, key=lambda part: -part.polygon.area), width


def outline(piece: Any) -> list[Point]:
    ring: list[Point] = piece["rings"][0]["xy"]
    return ring


def best(scene: gcv.Scene, polygon: gcv.Polygon) -> Optional[Point]:
    """The leftmost, then lowest free position.

    Where a part fits exactly, at a position that is not in floats, it overlaps something at
    the nearest one that is. Then it goes beside other parts.
    """
    position = scene.best(polygon, LEFT)
    if position is not None and scene.relation(polygon, position) is gcv.OVERLAPPING:
        position = scene.best(polygon, LEFT, leave_out="fits")
    return position


def place(scene: gcv.Scene, part: Part, turns: tuple[int, ...]) -> Place:
    """The place of the part that ends furthest to the left, of these turns the first."""
    found = []
    for turn in turns:
        polygon = turned(part.polygon, turn)
        position = best(scene, polygon)
        if position is not None:
            found.append(Place(polygon, turn, position))
    if not found:
        raise SystemExit("nesting: the strip is too narrow for a part")
    return min(found, key=lambda place: place.end)


def nest(to_place: list[Part], width: float, rotate: bool) -> list[Place]:
    length = fsum(abs(c) for part in to_place for c in part.polygon.bounds)
    scene = gcv.Scene([(0, 0), (length, 0), (length, width), (0, width)])
    placed = []
    for number, part in enumerate(to_place):
        start = perf_counter()
        one = place(scene, part, part.turns if rotate else (0,))
        milliseconds = 1000 * (perf_counter() - start)
        if scene.relation(one.polygon, one.position) is gcv.OVERLAPPING:
            raise SystemExit("nesting: a part overlaps another")
        scene.add(one.polygon, one.position)
        placed.append(one)
        x, y = one.position
        turn = f", turned by {90 * one.turn}" if one.turn else ""
        print(f"part {number} at ({x:g}, {y:g}){turn}: {milliseconds:.2f} ms")
    return placed


def svg(placed: list[Place], kinds: list[int], length: float, width: float) -> str:
    """The strip as far as it is used, and the parts, upside down as y goes down in SVG."""
    margin = width / 24
    paths = "".join(
        f'<path d="M{"L".join(f"{px + x} {py + y}" for px, py in polygon.vertices)}Z" '
        f'fill="{COLOURS[kind % len(COLOURS)]}"/>\n'
        for (polygon, _, (x, y)), kind in zip(placed, kinds)
    )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="1000" '
        f'viewBox="{-margin} {-margin} {length + 2 * margin} {width + 2 * margin}">\n'
        f'<g transform="matrix(1 0 0 -1 0 {width})" stroke="#333" stroke-width="{margin / 10}">\n'
        f'<rect width="{length}" height="{width}" fill="#eee"/>\n{paths}</g>\n</svg>\n'
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("instance", type=Path, nargs="?", help="a JSON file; default: 12 parts")
    parser.add_argument("--rotate", action="store_true", help="try quarter turns")
    parser.add_argument("--width", type=float, metavar="W", help="of the strip")
    parser.add_argument("--svg", type=Path, default=Path("nesting.svg"), metavar="FILE")
    options = parser.parse_args()

    if options.instance:
        to_place, width = read(options.instance)
    else:
        to_place = [Part(p, k % len(SHAPES), (0, 1, 2, 3)) for k, p in enumerate(parts())]
        width = WIDTH
    width = options.width or width
    placed = nest(to_place, width, options.rotate)
    length = float(max(one.end for one in placed))
    used = fsum(one.polygon.area for one in placed) / (length * width)
    picture = svg(placed, [part.kind for part in to_place], length, width)
    options.svg.write_text(picture, encoding="utf-8")
    print(f"{len(placed)} parts, length {length:.3f}, {100 * used:.1f} % used: {options.svg}")


if __name__ == "__main__":
    main()

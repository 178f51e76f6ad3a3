# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Finds the contacts of the blocks of a small wall, and draws them.

A level course carries a sill, whose upper side is a slope. Two courses on it are turned by
the angle of the slope, and rounded: faces that lie on each other are parallel but for
rounding. One brick was pushed into its neighbour, and is brought out of it. One hangs in the
air, and falls on the wall. Then all pairs of blocks near each other are asked for their
contacts, with a slope that stands for the rounding, and without. contact.c does the same in C.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import NamedTuple

import gcv

Point = tuple[float, float]

LENGTH, HEIGHT = 4.0, 2.0
LEVEL = [(0.0, 0.0), (4.0, 0.0), (8.0, 0.0), (12.0, 0.0)]
SILL = [(0.0, 2.0), (16.0, 2.0), (16.0, 5.6)]
TURNED = [(1.0, 0.0), (5.0, 0.0), (9.0, 0.0), (3.0, 2.0), (7.0, 2.0)]
PUSHED = (10.75, 2.0)
HANGING = (1.0, 11.0)
# Turns by the angle of the slope, whose tangent is 9/40, and leads to its start.
TURN = [[40 / 41, -9 / 41, 0.0], [9 / 41, 40 / 41, 2.0]]
FALL = (0.0, -16.0)
REACH = 0.01  # contacts are no further than this from touching, and no deeper
SLOPE = 1e-9  # far above what rounding turns a face by

MARGIN, ARROW = 1.0, 0.7
FILLS = {"block": "#e3eefc", "pushed": "#fdebe0", "hanging": "#e0f3ec"}


class Block(NamedTuple):
    polygon: gcv.Polygon
    translation: Point


class Touch(NamedTuple):
    """Two blocks that have contacts."""

    a: Block
    b: Block
    contacts: gcv.ContactList
    without_slope: gcv.ContactList


def brick(corner: Point) -> list[Point]:
    x, y = corner
    return [(x, y), (x + LENGTH, y), (x + LENGTH, y + HEIGHT), (x, y + HEIGHT)]


def wall() -> list[Block]:
    """The blocks that stay, then the pushed one, then the hanging one."""
    rings = [*map(brick, LEVEL), SILL, *map(brick, [*TURNED, PUSHED, HANGING])]
    polygons = gcv.Polygon.many(rings)
    for k in range(len(LEVEL) + 1, len(polygons) - 1):
        polygons[k] = polygons[k].affine(TURN)
    return [Block(polygon, (0.0, 0.0)) for polygon in polygons]


def between(a: Block, b: Block) -> Point:
    """The translation of b that is asked for, beside a as it was made.

    Exact here: of two blocks near each other, only b was moved.
    """
    return b.translation[0] - a.translation[0], b.translation[1] - a.translation[1]


def moved(block: Block, beside: Block, position: Point) -> Block:
    """The block at the position that was found beside another one."""
    x, y = position
    return Block(block.polygon, (x + beside.translation[0], y + beside.translation[1]))


def pull_out(blocks: list[Block], k: int) -> None:
    """Bring a block out of the earlier one that it is deepest in."""
    b = blocks[k]
    ways = [gcv.penetration(a.polygon, b.polygon, between(a, b)) for a in blocks[:k]]
    other = max(range(k), key=lambda i: ways[i].depth)
    way = ways[other]
    blocks[k] = moved(b, blocks[other], way.position)
    x, y = way.translation
    print(f"block {k} is {way.depth:g} deep in block {other}, and is moved by ({x:g}, {y:g})")


def drop(blocks: list[Block], k: int) -> None:
    """Let a block fall on the earlier ones."""
    b = blocks[k]
    falls = [gcv.cast(a.polygon, b.polygon, between(a, b), FALL) for a in blocks[:k]]
    other = min(range(k), key=lambda i: falls[i].time)
    fall = falls[other]
    blocks[k] = moved(b, blocks[other], fall.position)
    print(f"block {k} falls by {fall.time * -FALL[1]:g}, on block {other}")


def are_near(a: Block, b: Block) -> bool:
    """Whether their boxes are no further apart than the reach."""
    for axis in range(2):
        (low_a, high_a), (low_b, high_b) = (
            [block.polygon.bounds[k] + block.translation[axis] for k in (axis, axis + 2)]
            for block in (a, b)
        )
        if low_a > high_b + REACH or low_b > high_a + REACH:
            return False
    return True


def touches(blocks: list[Block]) -> Iterator[Touch]:
    for a, b in combinations(blocks, 2):
        if are_near(a, b):
            lists = [
                gcv.contacts(a.polygon, b.polygon, between(a, b), REACH, slope)
                for slope in (SLOPE, 0)
            ]
            if lists[0]:
                yield Touch(a, b, *lists)


def keeps_both_ends(contacts: gcv.ContactList) -> bool:
    """Whether there are contacts in two places: a face lies on the other along a stretch."""
    return any(
        abs(contact.on_a[axis] - contacts[0].on_a[axis]) > REACH
        for contact in contacts
        for axis in range(2)
    )


def report(found: list[Touch]) -> None:
    relations = Counter(
        gcv.relation(touch.a.polygon, touch.b.polygon, between(touch.a, touch.b)) for touch in found
    )
    print(
        f"{len(found)} pairs of blocks have contacts: {relations[gcv.TOUCHING]} touch, "
        f"{relations[gcv.APART]} are apart by rounding, "
        f"{relations[gcv.OVERLAPPING]} overlap by rounding"
    )
    total = sum(len(touch.contacts) for touch in found)
    lost = total - sum(len(touch.without_slope) for touch in found)
    print(f"{total} contacts within {REACH:g}; without a slope {lost} of them are lost")
    faces = sum(keeps_both_ends(touch.contacts) for touch in found)
    kept = sum(keeps_both_ends(touch.without_slope) for touch in found)
    print(f"{faces} pairs have contacts at both ends of a face; without a slope {kept} keep both")


# -------------------------------------------------------------------------- the picture --


def ring(block: Block) -> list[Point]:
    x, y = block.translation
    return [(px + x, py + y) for px, py in block.polygon.vertices]


def svg(blocks: list[Block], found: list[Touch]) -> str:
    """The blocks, the points of contacts on the first of two, and the normals of edges."""
    rings = [ring(block) for block in blocks]
    across = max(x for points in rings for x, _ in points)
    up = max(y for points in rings for _, y in points)
    styles = ["block"] * (len(blocks) - 2) + ["pushed", "hanging"]
    lines = [
        f'<path class="{style}" d="M{"L".join(f"{x:.4f} {y:.4f}" for x, y in points)}Z" '
        f'fill="{FILLS[style]}"/>'
        for points, style in zip(rings, styles)
    ]
    for touch in found:
        x0, y0 = touch.a.translation
        for contact in touch.contacts:
            x, y = contact.on_a[0] + x0, contact.on_a[1] + y0
            lines.append(f'<circle class="contact" cx="{x:.4f}" cy="{y:.4f}" r="0.11"/>')
            if contact.kind != gcv.ContactKind.VERTEX_VERTEX:
                dx, dy = (ARROW * coordinate for coordinate in contact.normal)
                lines.append(
                    f'<path class="normal" d="M{x:.4f} {y:.4f}L{x + dx:.4f} {y + dy:.4f}"/>'
                )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="900" '
        f'viewBox="{-MARGIN:.4f} {-MARGIN:.4f} {across + 2 * MARGIN:.4f} {up + 2 * MARGIN:.4f}">\n'
        '<marker id="head" viewBox="0 0 6 6" refX="6" refY="3" markerWidth="6" '
        'markerHeight="6" orient="auto"><path d="M0 0L6 3L0 6Z" fill="#a3238e"/></marker>\n'
        "<style>.normal { stroke: #a3238e; marker-end: url(#head) } "
        ".contact { fill: #1b2430; stroke: none }</style>\n"
        f'<g transform="matrix(1 0 0 -1 0 {up:.4f})" stroke="#5b6675" stroke-width="0.05">\n'
        + "\n".join(lines)
        + "\n</g>\n</svg>\n"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--svg", type=Path, default=Path("contacts.svg"), metavar="FILE")
    file: Path = parser.parse_args().svg

    blocks = wall()
    pull_out(blocks, len(blocks) - 2)
    drop(blocks, len(blocks) - 1)
    found = list(touches(blocks))
    report(found)
    file.write_text(svg(blocks, found), encoding="utf-8")
    print(f"picture: {file}")


if __name__ == "__main__":
    main()

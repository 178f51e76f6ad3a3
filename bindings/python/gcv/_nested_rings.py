# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons that rings bound together: which of them are holes of which."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from ._contacts import Relation
from ._coordinates import Points
from ._named import NamedPolygon, make
from ._scene import Scene


class Ring(NamedTuple):
    name: str
    points: Points


def polygons_of_rings(rings: list[Ring], *, nonzero: bool = False) -> list[NamedPolygon]:
    """The polygons of rings that may touch but not cross.

    What an odd number of rings goes round is inside; or, with nonzero, what they go round
    another number of times one way than the other. A hole belongs to the smallest ring
    that is around it.
    """
    solids = [make(*ring) for ring in rings]
    turns = [_turn(ring.points) if nonzero else 1 for ring in rings]
    outer: dict[int, list[int]] = {}
    for k, around in sorted(
        _around(solids, [ring.points for ring in rings]).items(), key=lambda item: len(item[1])
    ):
        if around:
            # Whatever is inside another ring must not cross it.
            names = f"{solids[around[0]].name} and {solids[k].name}"
            make(names, solids[around[0]].polygon, [rings[k].points])
        outside = sum(turns[other] for other in around)
        inside = outside + turns[k]
        if not nonzero:
            outside, inside = outside % 2, inside % 2
        if inside and not outside:
            outer[k] = []
        elif outside and not inside:
            next(outer[other] for other in around if other in outer).append(k)
    return [
        make(solids[k].name, solids[k].polygon, [rings[hole].points for hole in holes])
        if holes
        else solids[k]
        for k, holes in sorted(outer.items())
    ]


class _Size:
    """Of rings one of which goes round the other: that one is larger."""

    def __init__(self, box: tuple[float, float, float, float], points: Points) -> None:
        self._box = box
        self._points = points

    @cached_property
    def _twice_the_area(self) -> Fraction:
        return abs(_twice_the_area(self._points))

    def __lt__(self, other: _Size) -> bool:
        if self._box == other._box:
            return self._twice_the_area < other._twice_the_area
        (x0, y0, x1, y1), (left, bottom, right, top) = self._box, other._box
        return left <= x0 and bottom <= y0 and x1 <= right and y1 <= top


def _around(solids: list[NamedPolygon], rings: list[Points]) -> dict[int, list[int]]:
    """The rings around each ring, the smallest first."""
    scene = Scene()
    ids = [scene.add(solid.polygon) for solid in solids]
    numbers = {number: k for k, number in enumerate(ids)}
    sizes = [_Size(solid.polygon.bounds, points) for solid, points in zip(solids, rings)]
    around: dict[int, list[int]] = {k: [] for k in range(len(solids))}
    for pair in scene.pairs():
        if pair.relation == Relation.OVERLAPPING:
            small, large = sorted((numbers[pair.a], numbers[pair.b]), key=sizes.__getitem__)
            around[small].append(large)
    for others in around.values():
        others.sort(key=sizes.__getitem__)
    return around


def _turn(ring: Points) -> int:
    """1 for a ring that is counter-clockwise, -1 for one that is clockwise."""
    return 1 if _twice_the_area(ring) > 0 else -1


def _twice_the_area(ring: Points) -> Fraction:
    exact = [(Fraction(x), Fraction(y)) for x, y in ring]
    pairs = zip(exact, exact[1:] + exact[:1])
    return sum((x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in pairs), Fraction())

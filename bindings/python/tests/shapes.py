# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Polygons that several tests use, and what they ask of results."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Any, Union

import gcv

BINDING = Path(__file__).resolve().parents[1]
REPOSITORY = BINDING.parents[1]

Points = list[tuple[float, float]]
NOWHERE: Points = []

SQUARE: Points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
SQUARE_2: Points = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
SQUARE_3: Points = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)]
BOW_TIE: Points = [(0, 0), (2, 2), (2, 0), (0, 2)]
U_SHAPE: Points = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]
U_NO_FIT: Points = [(-1, -1), (6, -1), (6, 6), (3, 6), (3, 2), (2, 2), (2, 6), (-1, 6)]
NOTCHED: Points = [(0, 0), (8, 0), (8, 6), (3, 1), (0, 7)]
# Bumps and dents of 1/8 in its lower and upper sides.
BUMPY: Points = [
    *((0, 0), (1, 0), (2, -0.125), (3, 0), (4, 0)),
    *((4, 4), (3, 4), (2, 3.875), (1, 4), (0, 4)),
]
DUMB_BELL: Points = [
    *((0, 0), (4, 0), (4, 1), (6, 1), (6, 0), (10, 0)),
    *((10, 4), (6, 4), (6, 3), (4, 3), (4, 4), (0, 4)),
]
"""Two rooms, and a passage of height 2 between them."""
TRIANGLE: Points = [(0, 0), (1, 0), (0, 1)]


def box(left: float, bottom: float, right: float, top: float) -> Points:
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def scaled(ring: Points, factor: float) -> gcv.Polygon:
    return gcv.Polygon([(factor * x, factor * y) for x, y in ring])


HUGE = scaled(SQUARE, 1e308)
FRAME = gcv.Polygon(box(0, 0, 10, 10), [box(1, 1, 9, 9)])
ROOMS = gcv.Polygon(box(0, 0, 20, 9), [box(1, 1, 4, 4), box(6, 3, 8, 5), box(10, 3, 14, 5)])
"""A peg of 2 x 2 has room in the first, one place in the second, a way in the third."""


def star(count: int, seed: int) -> gcv.Polygon:
    """A star-shaped polygon with a ragged boundary."""
    generator = random.Random(seed)
    ring = []
    for k in range(count):
        radius, angle = 1 - 0.3 * generator.random(), 2 * math.pi * k / count
        ring.append((radius * math.cos(angle), radius * math.sin(angle)))
    return gcv.Polygon(ring)


def pairs(vertices: Any) -> Points:
    return [(float(x), float(y)) for x, y in vertices]


def points(ring: Union[gcv.Polygon, gcv.OuterFace]) -> Points:
    """The vertices as pairs."""
    return pairs(ring.vertices)


def polygons_of(region: gcv.Region) -> list[tuple[Points, list[Points]]]:
    """The polygons: for each its outer ring and the list of its holes."""
    return [(pairs(outer), [pairs(hole) for hole in holes]) for outer, holes in region.polygons]


def facts(region: gcv.Region) -> tuple[Any, ...]:
    """All that a region can be asked."""
    return (
        *(region.parts, region.vertices.tolist(), region.exact_parts, region.exact),
        *(region.exact_indices.tolist(), region.sources, region.owners.tolist()),
        *(region.area, region.error_bound, region.stats, region.wkt, region.fits_wkt),
        *(polygons_of(region), region.segments.tolist(), region.points.tolist(), list(region)),
    )

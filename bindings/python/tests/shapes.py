# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Polygons that several tests use."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Union

import gcv

BINDING = Path(__file__).resolve().parents[1]
REPOSITORY = BINDING.parents[1]

Points = list[tuple[float, float]]

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
TRIANGLE: Points = [(0, 0), (1, 0), (0, 1)]


def points(ring: Union[gcv.Polygon, gcv.OuterFace]) -> Points:
    """The vertices as pairs."""
    return [(float(x), float(y)) for x, y in ring.vertices]


def box(left: float, bottom: float, right: float, top: float) -> Points:
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def scaled(ring: Points, factor: float) -> gcv.Polygon:
    return gcv.Polygon([(factor * x, factor * y) for x, y in ring])


def star(count: int, seed: int) -> gcv.Polygon:
    """A star-shaped polygon with a ragged boundary."""
    generator = random.Random(seed)
    ring = []
    for k in range(count):
        radius, angle = 1 - 0.3 * generator.random(), 2 * math.pi * k / count
        ring.append((radius * math.cos(angle), radius * math.sin(angle)))
    return gcv.Polygon(ring)

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Circles that drawings have, and polygons in their place."""

from __future__ import annotations

from typing import Any

import numpy


def check_circle(vertices: Any, distance: float) -> None:
    """All vertices are on the circle of radius 10, and all edges within the distance of it."""
    assert numpy.allclose(numpy.hypot(*vertices.T), 10, rtol=0, atol=1e-9)
    middles = (vertices + numpy.roll(vertices, 1, axis=0)) / 2
    assert (10 - numpy.hypot(*middles.T)).max() <= distance

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Affine maps, and where they take the vertices as passed."""

from __future__ import annotations

from array import array
from typing import Any, Optional

from ._coordinates import Points, Rings, check_finite, check_order, numbers, points

_MATRIX = "2 rows of 2 or 3 numbers, 3 rows of 3 that end with 0 0 1, or 6 numbers"


def six_numbers(matrix: Any) -> array[float]:
    """The numbers of the first two rows of a matrix, or of a flat one of 2 x 3."""
    check_order(matrix, "matrix")
    try:
        rows = list(matrix)
        values = _two_rows(list(map(list, rows))) if len(rows) in (2, 3) else rows
    except (TypeError, ValueError):
        values = []
    found = numbers(values, 6, "matrix", matrix, _MATRIX)
    check_finite("matrix", found)
    return found


def _two_rows(rows: list[list[Any]]) -> list[Any]:
    """The numbers of two rows of three; none where the rows are of no affine map."""
    sizes = list(map(len, rows))
    if sizes == [2, 2]:
        return [*rows[0], 0, *rows[1], 0]
    if sizes == [3, 3] or (sizes == [3, 3, 3] and rows[2] == [0, 0, 1]):
        return rows[0] + rows[1]
    return []


def moved(given: Rings, matrix: array[float], images: list[Points]) -> Optional[Rings]:
    """The rings as passed, moved: the vertices of the normalised images in that order.

    None where a vertex was dropped, for then the images do not have all of them.
    """
    rings = []
    for ring, image in zip(map(points, given), images):
        is_closed = ring[0] == ring[-1]
        count = len(ring) - is_closed
        if count != len(image):
            return None
        start = image.index(_image(matrix, ring[0]))
        step = 1 if image[(start + 1) % count] == _image(matrix, ring[1]) else -1
        order = (image[(start + step * k) % count] for k in range(len(ring)))
        rings.append(array("d", [c for vertex in order for c in vertex]).tobytes())
    return rings


def _image(matrix: array[float], point: tuple[float, float]) -> tuple[float, float]:
    x, y = point
    m00, m01, m02, m10, m11, m12 = matrix
    return _row(m00, m01, m02, x, y), _row(m10, m11, m12, x, y)


def _row(m0: float, m1: float, m2: float, x: float, y: float) -> float:
    """The float nearest to m0 x + m1 y + m2, in integers: faster than in fractions."""
    (a, p), (b, q), (c, r) = (value.as_integer_ratio() for value in (m0, m1, m2))
    (u, s), (v, t) = x.as_integer_ratio(), y.as_integer_ratio()
    p, q = p * s, q * t
    return (a * u * q * r + b * v * p * r + c * p * q) / (p * q * r)

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where points lie in an exact region, in fractions.

For regions that were pickled, which the library does not know. Each point is compared
with every edge.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction

from ._ffi import NOT_FINITE, InputError

_Point = tuple[Fraction, Fraction]
_Edge = tuple[_Point, _Point]

INSIDE, BOUNDARY, OUTSIDE = 1, 0, -1


def located(
    xys: Iterable[tuple[float, float]], rings: list[list[_Point]], fits: list[list[_Point]]
) -> Iterator[int]:
    """Where each point lies; the fits are segments of two points and single points.

    Raises InputError for a NaN or an infinity.
    """
    ring_edges = [edge for ring in rings for edge in zip(ring, ring[1:] + ring[:1])]
    fit_edges = [(ends[0], ends[-1]) for ends in fits]
    for k, xy in enumerate(xys):
        point = _exact(xy, k)
        if any(_is_on(point, edge) for edge in ring_edges + fit_edges):
            yield BOUNDARY
        else:
            crossed = sum(_is_right_of(point, edge) for edge in ring_edges)
            yield INSIDE if crossed % 2 == 1 else OUTSIDE


def _exact(xy: tuple[float, float], k: int) -> _Point:
    """Point k in fractions."""
    for name, value in zip("xy", xy):
        if not math.isfinite(value):
            reason = f"the {name} coordinate of point {k} is {value}, not a finite number"
            raise InputError(NOT_FINITE, f"points: {reason}")
    return Fraction(xy[0]), Fraction(xy[1])


def _side(point: _Point, edge: _Edge) -> Fraction:
    """Above 0 where the point is to the left of the edge, 0 where it is on its line."""
    (ax, ay), (bx, by) = edge
    return (bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax)


def _is_on(point: _Point, edge: _Edge) -> bool:
    (ax, ay), (bx, by) = edge
    return (
        min(ay, by) <= point[1] <= max(ay, by)
        and min(ax, bx) <= point[0] <= max(ax, bx)
        and _side(point, edge) == 0
    )


def _is_right_of(point: _Point, edge: _Edge) -> bool:
    """Whether a ray from the point to the left, which is on no edge, crosses the edge."""
    (_, ay), (_, by) = edge
    return (ay <= point[1]) != (by <= point[1]) and (_side(point, edge) < 0) == (ay < by)

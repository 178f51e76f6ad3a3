# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where points lie in exact regions.

The library tells it, but for regions that were pickled, which it does not know. There
each point is compared with every edge, in fractions.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from ctypes import c_int8
from enum import IntEnum
from fractions import Fraction
from typing import Any

from . import _ffi
from ._coordinates import points, size

_Point = tuple[Fraction, Fraction]
_Edge = tuple[_Point, _Point]
ExactPoints = list[_Point]


class Location(IntEnum):
    """Where a point lies."""

    INSIDE = 1
    """In the interior of a polygon of the region."""
    BOUNDARY = 0
    """On a ring, a segment or a point of it."""
    OUTSIDE = -1
    """Elsewhere; holes are outside."""


def location(located: bytes) -> Location:
    """Where one point lies, of what says it: an int8."""
    (place,) = struct.unpack("b", located)
    return Location(place)


def locations(located: bytes) -> Any:
    """Where each of many points lies: an array of int8; a list of Location without numpy."""
    try:
        import numpy
    except ImportError:
        return [Location(place) for (place,) in struct.iter_unpack("b", located)]
    return numpy.frombuffer(located, "int8").copy()


def located_by_library(region: _ffi.Region, doubles: bytes) -> bytes:
    located = (c_int8 * size(doubles))()
    try:
        _ffi.region_locate(region, doubles, len(located), located)
    except _ffi.Error as error:
        # Here the argument has another name.
        raise type(error)(error.status, str(error).replace("xy:", "points:", 1)) from None
    return bytes(located)


def located_in_fractions(
    doubles: bytes, rings: list[ExactPoints], fits: list[ExactPoints]
) -> bytes:
    """Where each point lies; the fits are segments of two points and single points.

    Raises InputError for a NaN or an infinity.
    """
    return struct.pack(f"{size(doubles)}b", *_located(doubles, rings, fits))


def _located(
    doubles: bytes, rings: list[ExactPoints], fits: list[ExactPoints]
) -> Iterator[Location]:
    ring_edges = [edge for ring in rings for edge in zip(ring, ring[1:] + ring[:1])]
    fit_edges = [(ends[0], ends[-1]) for ends in fits]
    for k, xy in enumerate(points(doubles)):
        point = _exact(xy, k)
        if any(_is_on(point, edge) for edge in ring_edges + fit_edges):
            yield Location.BOUNDARY
        else:
            crossed = sum(_is_right_of(point, edge) for edge in ring_edges)
            yield Location.INSIDE if crossed % 2 == 1 else Location.OUTSIDE


def _exact(xy: tuple[float, float], k: int) -> _Point:
    """Point k in fractions."""
    for name, value in zip("xy", xy):
        if not math.isfinite(value):
            reason = f"the {name} coordinate of point {k} is {value}, not a finite number"
            raise _ffi.InputError(_ffi.NOT_FINITE, f"points: {reason}")
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

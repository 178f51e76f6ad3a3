# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The vertices of whatever a polygon can be made from, as doubles x0 y0 x1 y1 ..."""

from __future__ import annotations

import re
import sys
from array import array
from collections.abc import Iterable, Mapping
from typing import Any, Optional

_DOUBLE_FORMATS = ("d", ("<" if sys.byteorder == "little" else ">") + "d")


def coordinates(source: Any) -> bytes:
    """The coordinates of a buffer, a geometry, or a sequence of pairs.

    Raises TypeError or ValueError for anything else.
    """
    in_buffer = _from_buffer(source)
    if in_buffer is not None:
        return in_buffer
    geometry = getattr(source, "__geo_interface__", source)
    return _from_pairs(_outer_ring(geometry) if isinstance(geometry, Mapping) else source)


def coordinates_of_wkt(text: str) -> bytes:
    """The coordinates of the outer ring of a polygon that the library has accepted."""
    ring = re.search(r"\(\s*\(([^()]*)\)", text)
    return array("d", map(float, re.findall(r"[^\s,]+", ring[1] if ring else ""))).tobytes()


def _from_buffer(source: Any) -> Optional[bytes]:
    """The doubles in a buffer of any strides; None where there is no such buffer."""
    try:
        view = memoryview(source)
    except TypeError:
        return None
    if view.format not in _DOUBLE_FORMATS:
        return None
    if view.nbytes % 16 != 0 or (view.shape or ())[1:] not in ((), (2,)):
        raise ValueError(f"a buffer of shape {view.shape} does not hold pairs of doubles")
    return view.tobytes()


def _outer_ring(geometry: Mapping[str, Any]) -> Iterable[Iterable[float]]:
    """The outer ring of a GeoJSON object, without elevations."""
    kind = geometry.get("type")
    if kind == "Feature":
        return _outer_ring(geometry["geometry"])
    if kind == "Polygon":
        rings = geometry["coordinates"]
        return [position[:2] for position in rings[0]] if rings else []
    if kind == "LinearRing":
        return [position[:2] for position in geometry["coordinates"]]
    raise ValueError(f"a geometry of type {kind!r} is not a polygon")


def _from_pairs(source: Iterable[Iterable[float]]) -> bytes:
    doubles = array("d")
    for index, vertex in enumerate(source):
        try:
            x, y = vertex
            doubles.extend((x, y))
        except (TypeError, ValueError):
            raise TypeError(f"vertex {index} is not a pair of numbers: {vertex!r}") from None
    return doubles.tobytes()

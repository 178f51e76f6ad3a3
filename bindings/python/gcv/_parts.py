# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The parts of regions: their kinds, and how they make up polygons."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, TypeVar

from . import _ffi

if TYPE_CHECKING:
    import numpy
    import numpy.typing

PART_OUTER = 1
"""The outer ring of a polygon, counter-clockwise."""
PART_HOLE = 2
"""The ring of a hole in the polygon before it, clockwise."""
PART_SEGMENT = 3
"""A segment: one polygon fits the other exactly, and has room along a line only."""
PART_POINT = 4
"""A point: one polygon fits the other exactly, and has no room at all."""

_OfPart = TypeVar("_OfPart")


class RegionPart(NamedTuple):
    """One part of a region: a ring, a segment or a point."""

    kind: int
    """PART_OUTER, PART_HOLE, PART_SEGMENT or PART_POINT."""
    polygon: Optional[int]
    """The number of the polygon, from 0; None for segments and points."""
    start: int
    """The index of its first vertex."""
    stop: int
    """The index after that of its last vertex."""


class RegionPolygon(NamedTuple):
    """One polygon of a region in floats, each ring an array of shape (n, 2).

    Two are equal when their rings have the same vertices in the same order.
    """

    outer: numpy.typing.NDArray[numpy.float64]
    """Counter-clockwise."""
    holes: list[numpy.typing.NDArray[numpy.float64]]
    """Clockwise."""

    def _pairs(self) -> tuple[tuple[tuple[float, float], ...], ...]:
        return tuple(tuple((x, y) for x, y in ring) for ring in (self.outer, *self.holes))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, RegionPolygon):
            return NotImplemented
        return self._pairs() == other._pairs()

    # A tuple has its own, which looks at the arrays.
    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash(self._pairs())


def parts_of(parts: bytes) -> list[RegionPart]:
    """The parts, of the structs that the library gives."""
    result, start = [], 0
    for kind, polygon, count in struct.iter_unpack("=iIQ", parts):
        number = None if polygon == _ffi.NO_POLYGON else polygon
        result.append(RegionPart(kind, number, start, start + count))
        start += count
    return result


def grouped(parts: list[RegionPart], of_parts: list[_OfPart]) -> list[list[_OfPart]]:
    """What belongs to the rings of each polygon, of what belongs to each part."""
    polygons: list[list[_OfPart]] = []
    for part, of_part in zip(parts, of_parts):
        if part.kind == PART_OUTER:
            polygons.append([of_part])
        elif part.kind == PART_HOLE:
            polygons[-1].append(of_part)
    return polygons


def by_polygon(parts: list[RegionPart], vertices: Any) -> list[list[Any]]:
    """The vertices of the rings of each polygon."""
    return grouped(parts, [vertices[part.start : part.stop] for part in parts])

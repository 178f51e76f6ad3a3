# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What all shapes have in common.

The base class of polygons and outer faces: their vertices as an array and as a
geometry, how they are drawn, added, counted and hashed.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, TypeVar

from ._coordinates import Points, Rings, points, size
from ._drawing import plot, svg

if TYPE_CHECKING:
    import numpy
    import numpy.typing

    from ._outer_face import OuterFace

_ShapeType = TypeVar("_ShapeType", bound="Shape")
_BYTE_ORDER = "<" if sys.byteorder == "little" else ">"


class Shape:
    """What polygons and outer faces have in common: an outer ring of doubles, and holes."""

    __slots__ = ()

    @property
    def _doubles(self) -> bytes:
        """The coordinates x0 y0 x1 y1 ... of the outer ring, made once and then kept."""
        raise NotImplementedError

    @property
    def _ring_doubles(self) -> list[bytes]:
        """The coordinates of all rings, the outer one first."""
        return [self._doubles]

    def _numbered(self) -> Rings:
        """All rings, with the numbers of vertices that the shape has in sums."""
        raise NotImplementedError

    def _ring_points(self) -> list[Points]:
        return [points(doubles) for doubles in self._ring_doubles]

    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """The vertices of the outer ring, counter-clockwise from the lexicographically smallest.

        The ring is simple and not closed. An array of shape (n, 2), in input units,
        that cannot be written to: every access looks at the same memory, without a
        copy. Where numpy is not installed, a list of pairs.

        Of a Polygon, these are not the points as passed: their order is another one, and
        repeated points and points on a straight line are dropped. Contacts and sources
        have the numbers of the points as passed. To look these up, keep the points.
        """
        return array_of(self._doubles)

    @property
    def __array_interface__(self) -> dict[str, Any]:
        return {
            "version": 3,
            "typestr": _BYTE_ORDER + "f8",
            "shape": (len(self), 2),
            "data": self._doubles,
        }

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return {"type": "Polygon", "coordinates": rings_as_geometry(self._ring_points())}

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the region with matplotlib.

        ax is the axes to draw on, by default the current ones; style goes to
        ax.fill. Holes stay empty. Returns the axes. Raises ImportError without
        matplotlib.
        """
        return plot(self._ring_points(), (), ax, style)

    def _repr_svg_(self) -> str:
        return svg([self._ring_points()])

    # So that numpy does not take array + polygon for a sum of numbers.
    __array_ufunc__ = None

    def __add__(self, other: Shape) -> OuterFace:
        if not isinstance(other, Shape):
            return NotImplemented
        # Here, for sums are made of shapes.
        from ._sums import minkowski_sum

        return minkowski_sum(self, other)

    def __radd__(self: _ShapeType, other: int) -> _ShapeType:
        """Nothing is added by 0, which sum() begins with."""
        if not isinstance(other, int) or other != 0:
            return NotImplemented
        return self

    def __len__(self) -> int:
        """The number of vertices of the outer ring."""
        return size(self._doubles)

    def __hash__(self) -> int:
        return hash(self._doubles)

    def __copy__(self: _ShapeType) -> _ShapeType:
        return self

    def __deepcopy__(self: _ShapeType, _memo: object) -> _ShapeType:
        return self

    def __repr__(self) -> str:
        return f"<gcv.{type(self).__name__} of {len(self)} vertices>"


def array_of(doubles: bytes) -> numpy.typing.NDArray[numpy.float64]:
    """An array of pairs that looks at the doubles; a list of pairs without numpy."""
    try:
        import numpy
    except ImportError:
        return points(doubles)  # type: ignore[return-value]
    return numpy.frombuffer(doubles).reshape(-1, 2)


def rings_as_geometry(rings: list[Points]) -> tuple[Any, ...]:
    """The coordinates of a polygon in GeoJSON: closed rings."""
    return tuple((*ring, ring[0]) for ring in rings)


def parts_as_geometry(polygons: list[list[Points]], fits: list[Points]) -> dict[str, Any]:
    """Polygons, each of its rings, and fits: segments of two points and single points."""
    coordinates = [rings_as_geometry(rings) for rings in polygons]
    if not fits:
        return {"type": "MultiPolygon", "coordinates": tuple(coordinates)}
    geometries = [{"type": "Polygon", "coordinates": rings} for rings in coordinates]
    geometries += [
        {"type": "LineString", "coordinates": tuple(ends)}
        if len(ends) == 2
        else {"type": "Point", "coordinates": ends[0]}
        for ends in fits
    ]
    return {"type": "GeometryCollection", "geometries": geometries}

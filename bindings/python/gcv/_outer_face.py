# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The class of outer faces.

What a sum gives: its ring in floats, the exact ring, where its edges come from, and
what the computation took.
"""

from __future__ import annotations

from ctypes import c_size_t
from fractions import Fraction
from typing import TYPE_CHECKING

from . import _ffi, _structs
from ._coordinates import Rings, points
from ._facts import (
    EdgeSource,
    Result,
    Stats,
    edge_sources,
    exact_points,
    indices,
    of_area,
    of_elements,
    of_indices,
    of_number,
    of_stats,
    of_text,
    text,
)
from ._polygon import Polygon
from ._shape import Shape

if TYPE_CHECKING:
    import numpy
    import numpy.typing

__all__ = ["EdgeSource", "OuterFace", "Stats"]  # pickles say that all of them are of this module


class OuterFace(Result, Shape):
    """The outer face of a Minkowski sum; it never changes.

    Made by minkowski_sum, no_fit_polygon, entrance_block, the forms of these for many
    pairs, and the + of polygons and outer faces. The floats of its vertices are rounded
    from an exact ring, each once; exact gives that ring itself. Where vertices of the
    exact ring fall together in floats, there are fewer floats than exact vertices.

    Two outer faces are equal when both their rings are, the exact ones and those in
    floats. A pickled outer face carries all that it can be asked.
    """

    __slots__ = ()

    def _numbered(self) -> Rings:
        return [self._doubles]

    @property
    def exact(self) -> list[tuple[Fraction, Fraction]]:
        """The vertices of the exact ring, whatever the rounding of the floats.

        Counter-clockwise from the lexicographically smallest, without collinear
        vertices, not closed. With a tolerance, the ring of the simplified polygons.
        """
        return self._list("exact", exact_points).copy()

    @property
    def sources(self) -> list[EdgeSource]:
        """Where each edge of the exact ring comes from: i is for vertex i to i+1.

        Where several edges of the superset overlap on the ring, one of them.
        """
        return self._list("sources", edge_sources).copy()

    @property
    def exact_indices(self) -> numpy.typing.NDArray[numpy.int64]:
        """For each of vertices, the index in exact of the vertex that it stands for.

        sources[exact_indices[k]] is where the edge from vertices[k] on comes from. Of exact
        vertices that fell together, it is the lowest index: the edges between them have
        vanished, and the edge on comes from that of the last of them along the ring. They can
        lie on both sides of the start of the ring. For a vertex that rounding made, it is the
        start of the exact edge that the edge on lies closest to, measured in floats.

        An array of shape (n,) that cannot be written to; a list without numpy. Takes
        version 0.2 of the library.
        """
        return indices(self._fact("exact_indices"))

    @property
    def error_bound(self) -> float:
        """An upper bound on the Hausdorff distance from the exact ring, in input units.

        Certified and rounded up. It is 0 where every exact coordinate is a float.

        With a tolerance it also has what the polygons were simplified by, and is one
        between sets: no point of the ring is further than it from the exact sum of the
        polygons as given, and no point of that sum is further than it from the region
        inside the ring. A pocket whose entrance is narrower than twice the bound may be
        open in one of the two sums and closed in the other.
        """
        return float(self._fact("error_bound"))

    @property
    def area(self) -> float:
        """The area inside the ring of floats, in square units, correctly rounded.

        Holes of the sum are not subtracted; the area of a Region is without them.

        Raises Error where it is larger than any finite float.
        """
        return float(self._fact("area"))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The smallest box around the ring of floats: (xmin, ymin, xmax, ymax)."""
        xs, ys = zip(*points(self._doubles))
        return min(xs), min(ys), max(xs), max(ys)

    @property
    def wkt(self) -> str:
        """The ring of floats as Well-Known Text, which reads back to the same floats."""
        return str(self._fact("wkt"))

    @property
    def polygon(self) -> Polygon:
        """The ring of floats as a polygon, for the next sum; made at each access.

        Its vertices have the numbers that they have in vertices.
        """
        return Polygon._of([self._doubles])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, OuterFace):
            return NotImplemented
        return self._doubles == other._doubles and self._fact("exact") == other._fact("exact")

    __hash__ = Shape.__hash__


def _exact(face: _ffi.OuterFace) -> list[str]:
    count = _ffi.value(_ffi.outer_face_exact_vertex_count, c_size_t, face)
    return [text(_ffi.outer_face_exact_vertex, face, index) for index in range(count)]


OuterFace._questions = {
    "doubles": of_elements(_ffi.outer_face_vertices, _structs.Point),
    "exact": _exact,
    "sources": of_elements(_ffi.outer_face_edge_sources, _structs.EdgeSource),
    "exact_indices": of_indices(_ffi.outer_face_exact_indices),
    "error_bound": of_number(_ffi.outer_face_error_bound),
    "area": of_area(_ffi.outer_face_area),
    "wkt": of_text(_ffi.outer_face_wkt),
    "stats": of_stats(_ffi.outer_face_stats),
}

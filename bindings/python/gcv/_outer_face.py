# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The class of outer faces.

What a sum gives: its ring in floats, the exact ring, where its edges come from, and
what the computation took. Each fact is asked of the library once, when needed.
"""

from __future__ import annotations

import struct
from ctypes import byref, c_char, c_double, c_size_t
from fractions import Fraction
from typing import Any, Callable, NamedTuple, Optional, Union

from . import _ffi
from ._coordinates import Rings, points
from ._polygon import Polygon
from ._shape import Shape

EDGE_TRANSLATED = 1
"""Edge a of A, translated by vertex b of B."""
EDGE_CORNER = 2
"""Edge b of B, translated by vertex a of A."""
EDGE_TRANSLATED_CORNER = 3
"""Edge a of A and edge b of B, which have the same direction, merged."""


class EdgeSource(NamedTuple):
    """Where an edge of a sum comes from.

    The kind is one of the EDGE_ constants, which say whether a and b are numbers of
    vertices or of edges: of vertex k as passed, or of the edge from vertex k to k+1.
    """

    kind: int
    a: int
    b: int


class Stats(NamedTuple):
    """What a computation took: counts, the same on every run, not times."""

    walk_steps: int
    """Edges that the walk went along."""
    candidate_edges: int
    """Superset edges that it looked at."""
    predicates_filtered: int
    """Predicates settled by floats with a proven error bound or by indices."""
    predicates_fixed_width: int
    """Predicates settled by pairs of floats or integers of at most 512 bits."""
    predicates_rational: int
    """Predicates that needed arbitrary-precision arithmetic."""
    vertices_repaired: int
    """Vertices moved further than to the nearest float to keep the ring simple."""


class OuterFace(Shape):
    """The outer face of a Minkowski sum; it never changes.

    Made by minkowski_sum, minkowski_sum_many, no_fit_polygon, entrance_block and by
    the + of polygons and outer faces. The floats of its vertices are rounded from an
    exact ring, each once; exact gives that ring itself. Where vertices of the exact
    ring fall together in floats, there are fewer floats than exact vertices.

    Two outer faces are equal when both their rings are, the exact ones and those in
    floats. A pickled outer face carries all that it can be asked.
    """

    __slots__ = ("_facts", "_handle")

    def __init__(self, handle: Optional[_ffi.OuterFace], facts: dict[str, Any]) -> None:
        self._handle = handle
        self._facts = facts

    def _fact(self, name: str) -> Any:
        if name not in self._facts:
            self._facts[name] = _FACTS[name](self._handle)
        return self._facts[name]

    @property
    def _doubles(self) -> bytes:
        doubles: bytes = self._fact("doubles")
        return doubles

    def _numbered(self) -> Rings:
        return [self._doubles]

    @property
    def exact(self) -> list[tuple[Fraction, Fraction]]:
        """The vertices of the exact ring, whatever the rounding of the floats.

        Counter-clockwise from the lexicographically smallest, without collinear
        vertices, not closed. With a tolerance, the ring of the simplified polygons.
        """
        return [
            (Fraction(x), Fraction(y))
            for x, y in (vertex.split() for vertex in self._fact("exact"))
        ]

    @property
    def sources(self) -> list[EdgeSource]:
        """Where each edge of the exact ring comes from: i is for vertex i to i+1.

        Where several edges of the superset overlap on the ring, one of them.
        """
        return [EdgeSource(*edge) for edge in struct.iter_unpack("=iII", self._fact("sources"))]

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

        Holes of the sum are not subtracted.

        Raises Error where it is larger than any finite float.
        """
        area = self._fact("area")
        if isinstance(area, _ffi.Error):
            raise area
        return float(area)

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

    @property
    def stats(self) -> Stats:
        """What the computation took."""
        stats: Stats = self._fact("stats")
        return stats

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, OuterFace):
            return NotImplemented
        return self._doubles == other._doubles and self._fact("exact") == other._fact("exact")

    __hash__ = Shape.__hash__

    def __reduce__(self) -> tuple[type[OuterFace], tuple[None, dict[str, Any]]]:
        return OuterFace, (None, {name: self._fact(name) for name in _FACTS})


def _doubles(face: _ffi.OuterFace) -> bytes:
    return bytes(_ffi.elements(_ffi.outer_face_vertices, _ffi.Point, face))


def _exact(face: _ffi.OuterFace) -> list[str]:
    count = _ffi.value(_ffi.outer_face_exact_vertex_count, c_size_t, face)
    return [_text(_ffi.outer_face_exact_vertex, face, index) for index in range(count)]


def _sources(face: _ffi.OuterFace) -> bytes:
    return bytes(_ffi.elements(_ffi.outer_face_edge_sources, _ffi.EdgeSource, face))


def _error_bound(face: _ffi.OuterFace) -> float:
    return float(_ffi.value(_ffi.outer_face_error_bound, c_double, face))


def _area(face: _ffi.OuterFace) -> Union[float, _ffi.Error]:
    try:
        return float(_ffi.value(_ffi.outer_face_area, c_double, face))
    except _ffi.Error as error:
        return error.with_traceback(None)


def _wkt(face: _ffi.OuterFace) -> str:
    return _text(_ffi.outer_face_wkt, face)


def _stats(face: _ffi.OuterFace) -> Stats:
    stats = _ffi.sized(_ffi.Stats)
    _ffi.outer_face_stats(face, byref(stats))
    return Stats(*(getattr(stats, name) for name in Stats._fields))


def _text(function: Any, *arguments: Any) -> str:
    text: bytes = _ffi.elements(function, c_char, *arguments).value
    return text.decode()


_FACTS: dict[str, Callable[[Any], Any]] = {
    "doubles": _doubles,
    "exact": _exact,
    "sources": _sources,
    "error_bound": _error_bound,
    "area": _area,
    "wkt": _wkt,
    "stats": _stats,
}
"""What can be asked about an outer face, each asked of the library once, when needed."""

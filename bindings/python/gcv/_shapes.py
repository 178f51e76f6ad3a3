# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The classes of the package."""

from __future__ import annotations

import struct
import sys
from array import array
from collections.abc import Iterable, Mapping
from ctypes import byref, c_char, c_double, c_size_t
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Protocol, TypeVar, Union

from . import _ffi
from ._call import Rounding, value_of
from ._coordinates import coordinates, coordinates_of_wkt
from ._drawing import svg

if TYPE_CHECKING:
    import numpy
    import numpy.typing

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
    """Predicates settled by integers of at most 512 bits."""
    predicates_rational: int
    """Predicates that needed arbitrary-precision arithmetic."""
    vertices_repaired: int
    """Vertices moved further than to the nearest float to keep the ring simple."""


class Simplified(NamedTuple):
    """A polygon with fewer vertices, and how far it is from the given one."""

    polygon: Polygon
    error_bound: float
    """At least the Hausdorff distance between the two boundaries, certified."""


class SupportsArrayInterface(Protocol):
    """An array in the manner of numpy."""

    @property
    def __array_interface__(self) -> dict[str, Any]: ...


class SupportsGeoInterface(Protocol):
    """A geometry in the manner of shapely."""

    @property
    def __geo_interface__(self) -> Mapping[str, Any]: ...


PolygonLike = Union[
    "Polygon",
    "OuterFace",
    str,
    SupportsArrayInterface,
    SupportsGeoInterface,
    "array[float]",
    "memoryview[Any]",
    Mapping[str, Any],
    Iterable[Iterable[float]],
]
"""All that Polygon can be made from."""

_RingType = TypeVar("_RingType", bound="_Ring")
_BYTE_ORDER = "<" if sys.byteorder == "little" else ">"


class _Ring:
    """What polygons and outer faces have in common: a ring of doubles."""

    __slots__ = ()

    @property
    def _doubles(self) -> bytes:
        """The coordinates x0 y0 x1 y1 ..., made once and then kept."""
        raise NotImplementedError

    def _points(self) -> list[tuple[float, float]]:
        return list(struct.iter_unpack("dd", self._doubles))

    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """The vertices, counter-clockwise from the lexicographically smallest.

        The ring is simple and not closed. An array of shape (n, 2), in input units,
        that cannot be written to: every access looks at the same memory, without a
        copy. Where numpy is not installed, a list of pairs.
        """
        try:
            import numpy
        except ImportError:
            return self._points()  # type: ignore[return-value]
        return numpy.asarray(self)

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
        points = self._points()
        return {"type": "Polygon", "coordinates": ((*points, points[0]),)}

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the region with matplotlib.

        ax is the axes to draw on, by default the current ones; style goes to
        ax.fill. Returns the axes. Raises ImportError without matplotlib.
        """
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.gca()
            ax.set_aspect("equal")
        xs, ys = zip(*self._points())
        ax.fill(xs, ys, **{"alpha": 0.5, "edgecolor": "black", **style})
        return ax

    def _repr_svg_(self) -> str:
        return svg([self._points()])

    # So that numpy does not take array + polygon for a sum of numbers.
    __array_ufunc__ = None

    def __add__(self, other: Union[Polygon, OuterFace]) -> OuterFace:
        if not isinstance(other, (Polygon, OuterFace)):
            return NotImplemented
        from ._sums import minkowski_sum

        return minkowski_sum(self, other)

    def __len__(self) -> int:
        """The number of vertices."""
        return len(self._doubles) // 16

    def __hash__(self) -> int:
        return hash(self._doubles)

    def __copy__(self: _RingType) -> _RingType:
        return self

    def __deepcopy__(self: _RingType, _memo: object) -> _RingType:
        return self

    def __repr__(self) -> str:
        return f"<gcv.{type(self).__name__} of {len(self)} vertices>"


class Polygon(_Ring):
    """A simple polygon; it never changes.

    The source is one of

    - a sequence of (x, y) pairs of numbers, each converted to a float;
    - an array or another buffer of numbers, of shape (n, 2) and any strides, or of
      floats x0 y0 x1 y1 ...;
    - an object with a __geo_interface__, such as one of shapely, or a GeoJSON
      mapping: a Polygon, a LinearRing, or a Feature with one of these; holes and
      elevations are left out, for holes never change an outer face;
    - Well-Known Text, "POLYGON ((x y, x y, ...))"; holes are left out;
    - another polygon, or an outer face.

    Either orientation will do, and the first vertex may be repeated at the end. Every
    check is exact: coordinates are taken for the numbers that they are. Two polygons
    are equal when they are the same set of points.

    Raises InputError for a coordinate that is a NaN or an infinity, for a polygon
    without area, for a ring that crosses or touches itself, and for text that is
    not a polygon; TypeError or ValueError for a source that is none of the above.
    """

    __slots__ = ("_given", "_handle", "_ring")

    def __init__(self, source: PolygonLike) -> None:
        if isinstance(source, str):
            text = source.encode()
            self._handle = _ffi.Polygon()
            _ffi.polygon_create_wkt(text, len(text), byref(self._handle))
            self._given = coordinates_of_wkt(source)
        elif isinstance(source, Polygon):
            self._handle, self._given = source._handle, source._given
        else:
            self._take(source._doubles if isinstance(source, OuterFace) else coordinates(source))
        self._ring: Optional[bytes] = None

    def _take(self, given: bytes) -> None:
        """Become the polygon of these coordinates, which alone know the caller's numbers."""
        self._handle = _ffi.Polygon()
        _ffi.polygon_create(given, len(given) // 16, 0, byref(self._handle))
        self._given = given

    @classmethod
    def _of(cls, given: bytes) -> Polygon:
        polygon = cls.__new__(cls)
        polygon._take(given)
        polygon._ring = None
        return polygon

    @property
    def _doubles(self) -> bytes:
        if self._ring is None:
            self._ring = _vertices(self._handle)
        return self._ring

    @property
    def area(self) -> float:
        """The area in square units, above 0, correctly rounded.

        Raises Error where it is larger than any finite float.
        """
        return float(_ffi.value(_ffi.polygon_area, c_double, self._handle))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The smallest box around the polygon, exact: (xmin, ymin, xmax, ymax)."""
        box = _ffi.Box()
        _ffi.polygon_bounds(self._handle, box)
        xmin, ymin, xmax, ymax = box
        return xmin, ymin, xmax, ymax

    def simplified(self, tolerance: float, *, rounding: Rounding = "nearest") -> Simplified:
        """The polygon with fewer vertices, and a bound: polygon, error_bound = ...

        Made once for many sums, in scenes that need no more detail. The new boundary is
        simple, and within the tolerance, in input units, of the given one in Hausdorff
        distance; error_bound says how far it is at most, which is often less. With
        "nearest" the vertices are some of the given ones. With "outward" the new polygon
        contains the given one, and may have new vertices, where edges were lengthened
        until they meet.

        Its vertices have the numbers that they have in vertices; sums with a tolerance
        of their own keep the numbers of the given polygons.

        Raises InputError for a tolerance that is negative or not finite.
        """
        handle, bound = _ffi.Polygon(), c_double()
        _ffi.polygon_simplified(
            self._handle, tolerance, value_of(rounding), byref(handle), byref(bound)
        )
        return Simplified(self._of(_vertices(handle)), bound.value)

    def __neg__(self) -> Polygon:
        """The polygon reflected in the origin, exactly; its vertices keep their numbers."""
        return self._of(array("d", [-c for c in array("d", self._given)]).tobytes())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Polygon):
            return NotImplemented
        return self._doubles == other._doubles

    __hash__ = _Ring.__hash__

    def __reduce__(self) -> tuple[Callable[[bytes], Polygon], tuple[bytes]]:
        return _polygon_of, (self._given,)


class OuterFace(_Ring):
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

        Raises Error where it is larger than any finite float.
        """
        area = self._fact("area")
        if isinstance(area, _ffi.Error):
            raise area
        return float(area)

    @property
    def wkt(self) -> str:
        """The ring of floats as Well-Known Text, which reads back to the same floats."""
        return str(self._fact("wkt"))

    @property
    def polygon(self) -> Polygon:
        """The ring of floats as a polygon, for the next sum; made at each access.

        Its vertices have the numbers that they have in vertices.
        """
        return Polygon._of(self._doubles)

    @property
    def stats(self) -> Stats:
        """What the computation took."""
        stats: Stats = self._fact("stats")
        return stats

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, OuterFace):
            return NotImplemented
        return self._doubles == other._doubles and self._fact("exact") == other._fact("exact")

    __hash__ = _Ring.__hash__

    def __reduce__(self) -> tuple[type[OuterFace], tuple[None, dict[str, Any]]]:
        return OuterFace, (None, {name: self._fact(name) for name in _FACTS})


def as_polygon(source: PolygonLike) -> Polygon:
    """The polygon that the source is, or that can be made from it."""
    return source if isinstance(source, Polygon) else Polygon(source)


def _polygon_of(given: bytes) -> Polygon:
    return Polygon._of(given)


def _vertices(polygon: _ffi.Polygon) -> bytes:
    return bytes(_ffi.elements(_ffi.polygon_vertices, _ffi.Point, polygon))


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

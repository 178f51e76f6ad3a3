# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The classes and functions of the package."""

from __future__ import annotations

import sys
from array import array
from collections.abc import Iterable, Mapping
from ctypes import byref, c_char, c_double, c_size_t
from fractions import Fraction
from typing import Any, NamedTuple, Optional, Protocol, Union

from . import _ffi

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


class SupersetEdge(NamedTuple):
    """An edge of the superset, from one point to another."""

    start: tuple[float, float]
    end: tuple[float, float]
    source: EdgeSource


class SupportsArrayInterface(Protocol):
    """An array in the manner of numpy."""

    @property
    def __array_interface__(self) -> Mapping[str, Any]: ...


PolygonLike = Union[
    "Polygon",
    str,
    SupportsArrayInterface,
    "array[float]",
    "memoryview[Any]",
    Iterable[Iterable[float]],
]
"""All that Polygon can be made from."""


class Polygon:
    """A simple polygon; it never changes.

    The source is one of

    - a sequence of (x, y) pairs of numbers, each converted to a float;
    - an array of n x 2 numbers; one of float64 with x and y side by side and the
      vertices in ascending order is read where it lies, without a copy;
    - a buffer of doubles, n x 2 or x0 y0 x1 y1 ...;
    - Well-Known Text, "POLYGON ((x y, x y, ...))"; holes are left out, as they
      never change an outer face;
    - another polygon.

    Either orientation will do, and the first vertex may be repeated at the end.

    Raises InputError for a coordinate that is a NaN or an infinity, for a polygon
    without area, for a ring that crosses or touches itself, and for text that is
    not a polygon; TypeError or ValueError for a source that is none of the above.
    """

    __slots__ = ("_handle",)

    def __init__(self, source: PolygonLike) -> None:
        self._handle = _polygon(source)

    @property
    def vertices(self) -> list[tuple[float, float]]:
        """The vertices, counter-clockwise from the lexicographically smallest.

        Repeated and collinear vertices are left out; the ring is not closed.
        """
        return _points(_ffi.elements(_ffi.polygon_vertices, _ffi.Point, self._handle))

    @property
    def area(self) -> float:
        """The area in square units, above 0, correctly rounded.

        Raises Error where it is larger than any finite float.
        """
        return float(_ffi.value(_ffi.polygon_area, c_double, self._handle))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The smallest box around the polygon: (xmin, ymin, xmax, ymax)."""
        box = _ffi.Box()
        _ffi.polygon_bounds(self._handle, box)
        xmin, ymin, xmax, ymax = box
        return xmin, ymin, xmax, ymax

    def __len__(self) -> int:
        """The number of vertices."""
        return int(_ffi.value(_ffi.polygon_vertex_count, c_size_t, self._handle))

    def __repr__(self) -> str:
        return f"<gcv.Polygon of {len(self)} vertices>"


class OuterFace:
    """The outer face of a Minkowski sum; it never changes.

    Made by minkowski_sum, no_fit_polygon and entrance_block.
    """

    __slots__ = ("_handle",)

    def __init__(self, handle: _ffi.OuterFace) -> None:
        self._handle = handle

    @property
    def vertices(self) -> list[tuple[float, float]]:
        """The vertices of the outer boundary, each coordinate correctly rounded.

        Counter-clockwise from the lexicographically smallest, not closed. They form
        a simple ring.
        """
        return _points(_ffi.elements(_ffi.outer_face_vertices, _ffi.Point, self._handle))

    @property
    def exact(self) -> list[tuple[Fraction, Fraction]]:
        """The vertices of the exact ring, which has no collinear vertices."""
        count = _ffi.value(_ffi.outer_face_exact_vertex_count, c_size_t, self._handle)
        return [self._exact_vertex(index) for index in range(count)]

    def _exact_vertex(self, index: int) -> tuple[Fraction, Fraction]:
        text = _ffi.elements(_ffi.outer_face_exact_vertex, c_char, self._handle, index)
        x, y = text.value.decode().split()
        return Fraction(x), Fraction(y)

    @property
    def sources(self) -> list[EdgeSource]:
        """Where each edge of the exact ring comes from: i is for vertex i to i+1."""
        edges = _ffi.elements(_ffi.outer_face_edge_sources, _ffi.EdgeSource, self._handle)
        return [_edge_source(edge) for edge in edges]

    @property
    def error_bound(self) -> float:
        """An upper bound on the Hausdorff distance from the exact ring, in input units.

        It is 0 where every exact coordinate is a float.
        """
        return float(_ffi.value(_ffi.outer_face_error_bound, c_double, self._handle))

    @property
    def area(self) -> float:
        """The area inside the ring of vertices, in square units, correctly rounded.

        Raises Error where it is larger than any finite float.
        """
        return float(_ffi.value(_ffi.outer_face_area, c_double, self._handle))

    @property
    def wkt(self) -> str:
        """The ring of vertices as Well-Known Text, which reads back to the same floats."""
        text: bytes = _ffi.elements(_ffi.outer_face_wkt, c_char, self._handle).value
        return text.decode()

    @property
    def polygon(self) -> Polygon:
        """The ring of vertices as a polygon, for the next sum."""
        polygon = Polygon.__new__(Polygon)
        polygon._handle = _ffi.Polygon()
        _ffi.outer_face_polygon(self._handle, byref(polygon._handle))
        return polygon

    def __len__(self) -> int:
        """The number of vertices."""
        return int(_ffi.value(_ffi.outer_face_vertex_count, c_size_t, self._handle))

    def __repr__(self) -> str:
        return f"<gcv.OuterFace of {len(self)} vertices>"


def minkowski_sum(a: PolygonLike, b: PolygonLike) -> OuterFace:
    """The outer face of the Minkowski sum A + B.

    Raises as Polygon does, and Error where a coordinate of the result is not a
    finite float or where the rounded vertices do not form a simple ring.
    """
    face = _ffi.OuterFace()
    _ffi.minkowski_sum(_polygon(a), _polygon(b), None, byref(face))
    return OuterFace(face)


def no_fit_polygon(
    fixed: PolygonLike, moving: PolygonLike, reference: Iterable[float]
) -> OuterFace:
    """The no-fit polygon fixed + (-moving) + reference.

    It is where the point reference, (x, y) and tied to moving, may go while the two
    polygons touch: inside the ring they overlap, outside they are apart.

    Raises as minkowski_sum does, and InputError for a reference that is not finite.
    """
    face = _ffi.OuterFace()
    point = _point(reference)
    _ffi.no_fit_polygon(_polygon(fixed), _polygon(moving), point, None, byref(face))
    return OuterFace(face)


def entrance_block(a: PolygonLike, b: PolygonLike, a0: Iterable[float]) -> OuterFace:
    """Shi's entrance block E(A, B) = B + (-A) + a0.

    It is where the point a0, (x, y) and tied to block A, may go while A and B touch.

    Raises as minkowski_sum does, and InputError for an a0 that is not finite.
    """
    face = _ffi.OuterFace()
    _ffi.entrance_block(_polygon(a), _polygon(b), _point(a0), None, byref(face))
    return OuterFace(face)


def superset(a: PolygonLike, b: PolygonLike) -> list[SupersetEdge]:
    """The superset of the outer face of A + B, for plots and for tests.

    First the translated edges, then the corner edges, then the translated-corner
    edges; there can be in the order of n m of them. Sums do not need it.

    Raises as Polygon does, and Error where a coordinate is not a finite float.
    """
    handle = _ffi.Superset()
    _ffi.superset_create(_polygon(a), _polygon(b), byref(handle))
    return [
        SupersetEdge((edge.x0, edge.y0), (edge.x1, edge.y1), _edge_source(edge.source))
        for edge in _ffi.elements(_ffi.superset_edges, _ffi.SupersetEdge, handle)
    ]


def library_version() -> str:
    """The version of the library that is running, such as "0.1.0"."""
    version: bytes = _ffi.version_string()
    return version.decode()


def _polygon(source: PolygonLike) -> _ffi.Polygon:
    if isinstance(source, Polygon):
        return source._handle
    handle = _ffi.Polygon()
    if isinstance(source, str):
        text = source.encode()
        _ffi.polygon_create_wkt(text, len(text), byref(handle))
        return handle
    in_place = _address_count_stride(source)
    if in_place is not None:
        _ffi.polygon_create(*in_place, byref(handle))
    else:
        doubles = _doubles(source)
        _ffi.polygon_create(doubles, len(doubles) // 16, 0, byref(handle))
    return handle


_BYTE_ORDER = "<" if sys.byteorder == "little" else ">"


def _address_count_stride(source: object) -> Optional[tuple[int, int, int]]:
    """Where the vertices of an array lie, if the library can read them there."""
    interface = getattr(source, "__array_interface__", None)
    if interface is None or interface["typestr"] != _BYTE_ORDER + "f8":
        return None
    shape, data = interface["shape"], interface.get("data")
    if len(shape) != 2 or shape[1] != 2 or not isinstance(data, tuple):
        return None
    stride, step = interface.get("strides") or (16, 8)
    return (data[0], shape[0], stride) if stride >= 16 and step == 8 else None


def _doubles(source: Any) -> bytes:
    """The coordinates x0 y0 x1 y1 ... of a buffer or of a sequence of pairs."""
    try:
        view = memoryview(source)
    except TypeError:
        return _pairs(source)
    if view.format not in ("d", _BYTE_ORDER + "d"):
        return _pairs(source)
    if view.nbytes % 16 != 0 or (view.shape or ())[1:] not in ((), (2,)):
        raise ValueError(f"a buffer of shape {view.shape} does not hold pairs of doubles")
    return view.tobytes()


def _pairs(source: Iterable[Iterable[float]]) -> bytes:
    coordinates = array("d")
    for index, vertex in enumerate(source):
        try:
            x, y = vertex
            coordinates.extend((x, y))
        except (TypeError, ValueError):
            raise TypeError(f"vertex {index} is not a pair of numbers: {vertex!r}") from None
    return coordinates.tobytes()


def _point(pair: Iterable[float]) -> Any:
    x, y = pair
    return _ffi.Point(x, y)


def _points(ring: Iterable[Any]) -> list[tuple[float, float]]:
    return [(x, y) for x, y in ring]


def _edge_source(edge: Any) -> EdgeSource:
    return EdgeSource(edge.kind, edge.a, edge.b)

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""How two polygons lie: the records of it, one by one and in arrays.

An array has a field for each member of the C struct. A record has what Python needs.
"""

from __future__ import annotations

from ctypes import Array, c_int8, c_uint64
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional

from . import _structs

if TYPE_CHECKING:
    import numpy


class Relation(IntEnum):
    """How two polygons lie."""

    APART = 1
    """They have no point in common."""
    TOUCHING = 0
    """Their boundaries meet, their interiors do not."""
    OVERLAPPING = -1
    """Their interiors meet."""


class ContactKind(IntEnum):
    """The features of a contact."""

    EDGE_VERTEX = 1
    """An edge of A and a vertex of B."""
    VERTEX_EDGE = 2
    """A vertex of A and an edge of B."""
    VERTEX_VERTEX = 3
    """A vertex of A and a vertex of B."""


class Contact(NamedTuple):
    """A feature of A and one of B that touch, or would, and where.

    a and b are numbers of the points as they were passed to Polygon: of all rings, one after
    the other, closing and repeated points counted. They are not indices of Polygon.vertices,
    which has other points in another order. With points, a list of the points of A as
    passed, the vertex is points[contact.a], and an edge begins there. Points in the middle
    of straight edges are no vertices: an edge past them has the number of the first along
    the ring in Polygon.vertices, which is counter-clockwise, holes clockwise. A point that
    is passed several times in a row has its last number.
    """

    kind: ContactKind
    """Whether a and b are numbers of vertices or of edges."""
    a: int
    """Of vertex k of A as passed, or of the edge from vertex k to k+1."""
    b: int
    """The same of B."""
    gap: float
    """The distance between the features, correctly rounded.

    In lists negative for a vertex that is on the inner side of the line of the edge.
    """
    normal: tuple[float, float]
    """A unit vector, each coordinate within 1 ulp.

    The normal of the edge, towards B. For two vertices the direction from that of A to
    that of B, or (0, 0) where they coincide.
    """
    on_a: tuple[float, float]
    """The point of the feature of A that is nearest to that of B, correctly rounded."""
    on_b: tuple[float, float]
    """The point of the feature of B, where the translation has moved it."""
    id_a: int = 0
    """The id of A in a scene, 1 for the container; 0 without a scene."""
    id_b: int = 0
    """The id of B in a scene; 0 for a polygon that is no member, and without a scene."""


class Separation(NamedTuple):
    """How far two polygons are from each other."""

    distance: float
    """The Euclidean distance, correctly rounded; 0 where they touch or overlap."""
    relation: Relation
    """Exact, even where the distance underflows to 0."""
    nearest: Optional[Contact]
    """Where the distance is taken; None where they touch or overlap.

    Of several, the one with the smallest kind, then a, then b.
    """
    id: int = 0
    """In a scene, of what is nearest, also without a contact; 0 where nothing is there."""


class Escape(NamedTuple):
    """The shortest way out of an overlap."""

    depth: float
    """The length of the way, correctly rounded; 0 where they do not overlap."""
    translation: tuple[float, float]
    """The way itself, rounded to nearest. Of several ways, the lexicographically smallest."""
    position: tuple[float, float]
    """A translation of B in floats within 2 ulps of the exact end, where it does not overlap A.

    The nearest one to the exact end where there is no such translation.
    """
    relation: Relation
    """How they lie at the position, exactly."""
    contact: Optional[Contact]
    """What they touch with at the end of the way.

    None where they do not overlap, in a scene where nothing is free, and where only points
    touch there at which rings of both polygons touch.
    """
    id: int = 0
    """In a scene, of what is touched at the end of the way; 0 where there is no way."""


class Impact(NamedTuple):
    """How far a motion leads before the polygons overlap."""

    hit: bool
    """Whether B would overlap A right after the time."""
    relation: Relation
    """How they lie at the position, exactly."""
    time: float
    """The largest part of the motion, from 0 to 1, up to which they never overlap.

    Rounded down. It is 1 without a hit.
    """
    position: tuple[float, float]
    """A translation of floats within 2 ulps of the exact one, at which B does not overlap A.

    The nearest one to the exact one where there is no such translation.
    """
    contact: Optional[Contact]
    """What is hit, with gap 0; None without a hit and where they overlap at the start.

    Of several, the one with the smallest kind, then a, then b. Where two vertices meet, its normal
    is (0, 0): contacts at `position` has those of the edges beside them, with a distance of some
    ulps where `relation` is APART.
    """
    id: int = 0
    """In a scene, of what is hit, also without a contact; 0 without a hit."""


class Pair(NamedTuple):
    """Two members of a scene, or the container or another polygon and a member."""

    a: int
    """An id, 1 for the container."""
    b: int
    """The other one; 0 for a polygon that is no member."""
    relation: Relation
    """How they lie, exactly."""


_dtypes: dict[Any, numpy.dtype[Any]] = {}


def dtype_of(kind: Any) -> numpy.dtype[Any]:
    """The dtype of an array of a C type, made once. Raises ImportError without numpy."""
    import numpy

    if kind not in _dtypes:
        _dtypes[kind] = numpy.dtype(kind)
    return _dtypes[kind]


DTYPES = {
    "CONTACT_DTYPE": _structs.Contact,
    "SEPARATION_DTYPE": _structs.Separation,
    "ESCAPE_DTYPE": _structs.Escape,
    "IMPACT_DTYPE": _structs.Impact,
    "PAIR_DTYPE": _structs.Pair,
}
"""The structs by the public names of their dtypes."""


def record(values: Array[Any]) -> Any:
    """The record of the first of C values."""
    return _RECORDS[values._type_](values[0])


def records(values: Array[Any]) -> Any:
    """An array on the memory of C values; a list of their records without numpy."""
    try:
        import numpy
    except ImportError:
        return list(map(_RECORDS[values._type_], values))
    return numpy.frombuffer(memoryview(values), dtype_of(values._type_))


def record_of(kind: Any) -> Callable[[Any], Any]:
    """What makes a record of a C value of that type."""
    return _RECORDS[kind]


def _contact(of: _structs.Contact) -> Contact:
    return Contact(
        *(ContactKind(of.kind), of.a, of.b, of.gap),
        *(_point(of.normal), _point(of.on_a), _point(of.on_b)),
        *(of.id_a, of.id_b),
    )


def _contact_or_none(of: _structs.Contact) -> Optional[Contact]:
    return _contact(of) if of.kind != 0 else None


def _separation(of: _structs.Separation) -> Separation:
    nearest = of.nearest
    return Separation(
        *(of.distance, Relation(of.relation), _contact_or_none(nearest), nearest.id_a)
    )


def _escape(of: _structs.Escape) -> Escape:
    return Escape(
        *(of.depth, _point(of.translation), _point(of.position), Relation(of.relation)),
        *(_contact_or_none(of.contact), of.contact.id_a),
    )


def _impact(of: _structs.Impact) -> Impact:
    return Impact(
        *(of.hit != 0, Relation(of.relation), of.time, _point(of.position)),
        *(_contact_or_none(of.contact), of.contact.id_a),
    )


def _pair(of: _structs.Pair) -> Pair:
    return Pair(of.a, of.b, Relation(of.relation))


def _point(pair: Any) -> tuple[float, float]:
    x, y = pair
    return x, y


_RECORDS: dict[Any, Callable[[Any], Any]] = {
    c_int8: Relation,
    c_uint64: int,
    _structs.Point: _point,
    _structs.Contact: _contact,
    _structs.Separation: _separation,
    _structs.Escape: _escape,
    _structs.Impact: _impact,
    _structs.Pair: _pair,
}

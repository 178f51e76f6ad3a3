# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Lists of contacts, and all contacts of two polygons at one translation."""

from __future__ import annotations

from ctypes import c_uint64, c_void_p, sizeof
from typing import Any, Optional, SupportsFloat

from . import _ffi, _structs
from ._call import SHORT, Progress
from ._contacts import Contact
from ._coordinates import number, pair
from ._facts import made_by_itself
from ._many import vertices
from ._polygon import Polygon, as_polygon
from ._record_list import RecordList
from ._sources import PointLike, PolygonLike
from ._two_polygons import VERTICES_A_PAIR, ask, distance_in

_NOT_THERE = 2**64 - 1
"""The index of a contact that was not in the earlier list."""


class ContactList(RecordList[Contact]):
    """Contacts, the nearest first; it never changes.

    Made by contacts and Scene.contacts. It is a sequence of Contact, and array and
    numpy.asarray have all of them, of dtype CONTACT_DTYPE. Two lists are equal when all
    numbers of their contacts and of previous are. It can be pickled; a pickled list is none
    that Scene.contacts takes as previous.
    """

    __slots__ = ("_previous",)

    _struct, _noun, _read = _structs.Contact, "contact", _ffi.contact_list_contacts
    _previous: Optional[bytes]
    """The indices in an earlier list, as the library gives them, once they were needed."""

    def __init__(self, structs: Any = None, previous: Any = None, handle: Any = None) -> None:
        super().__init__(structs, handle)
        if not isinstance(handle, c_void_p) and (
            not isinstance(previous, bytes) or len(previous) != len(self) * sizeof(c_uint64)
        ):
            raise made_by_itself(self)
        self._previous = previous

    def _indices(self) -> bytes:
        if self._previous is None:
            self._previous = bytes(
                _ffi.elements(_ffi.contact_list_previous, c_uint64, self._handle)
            )
        return self._previous

    @property
    def previous(self) -> tuple[Optional[int], ...]:
        """For each contact its index in the earlier list that was passed, or None.

        None for all contacts where no list was passed, as to contacts(), which takes none.
        """
        indices = memoryview(self._indices()).cast("Q")
        return tuple(None if index == _NOT_THERE else index for index in indices)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, ContactList):
            return NotImplemented
        return super().__eq__(other) and self._indices() == other._indices()

    __hash__ = RecordList.__hash__

    def __reduce__(self) -> tuple[type[ContactList], tuple[bytes, ...]]:
        return type(self), (bytes(self._structs()), self._indices())


def contacts(
    a: PolygonLike,
    b: PolygonLike,
    translation: PointLike = (0, 0),
    distance: SupportsFloat = 0.0,
    slope: SupportsFloat = 0.0,
    *,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> ContactList:
    """All pairs of a feature of A and one of B, moved by a translation, that can touch.

    A pair is an edge and a vertex, or two vertices, that no small part of the polygons
    beside them keeps from touching. It is in the list where the size of its gap is at most
    the distance. Parallel edges give the ends of what they share, each as a vertex and an
    edge. Where the nearest point of an edge is its end, the pair of two vertices is there as
    well.

    translation: (x, y). distance: in input units, from 0 on. slope: from 0 on; pairs that
    could touch once one polygon was turned by an angle of at most this tangent are there
    too, so that sides that are parallel but for rounding have both of their contacts.

    The contacts are in the order of the size of the gap, then kind, a, b. Which there are
    is exact. gap is correctly rounded; it is negative where the vertex is on the inner
    side of the line of the edge, and never for two vertices.

    threads, progress, and errors are those of relation; InputError also for a distance
    or a slope that is negative or not finite, Error where a result is larger than any
    finite float. Takes version 0.2 of the library.
    """
    a, b = as_polygon(a, "a"), as_polygon(b, "b")
    limits = number(distance, "distance"), number(slope, "slope")
    point = _structs.Point(*pair(translation, "translation"))
    handle = _ffi.ContactList()
    ask(
        lambda options: _ffi.contacts(a._handle, b._handle, point, *limits, options, handle),
        *(_pairs_within(limits[0], a, b), threads, progress),
    )
    return ContactList(handle=handle)


def _pairs_within(distance: float, a: Polygon, b: Polygon) -> int:
    """A guess of how many pairs of vertices are near: all, for distances like the sizes."""
    along, of_all = (vertices(a) + vertices(b)) // VERTICES_A_PAIR, vertices(a) * vertices(b)
    return along if of_all <= SHORT else along + int(of_all * min(1, distance_in(b, distance)))

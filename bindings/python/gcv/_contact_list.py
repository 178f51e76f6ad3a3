# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""All contacts of two polygons at one translation."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from ctypes import c_uint64, sizeof
from typing import TYPE_CHECKING, Optional, Union, overload

from . import _ffi, _structs
from ._call import Progress
from ._contacts import Contact, contact, dtype_of
from ._coordinates import number, pair
from ._many import vertices
from ._polygon import as_polygon
from ._sources import PolygonLike
from ._two_polygons import ask

if TYPE_CHECKING:
    import numpy
    import numpy.typing


_NOT_THERE = 2**64 - 1
"""The index of a contact that was not in the earlier list."""


class ContactList(Sequence[Contact]):
    """Contacts, the nearest first; it never changes.

    Made by contacts. It is a sequence of Contact, and array has all of them. Two lists
    are equal when all numbers of their contacts are. It can be pickled.
    """

    __slots__ = ("_bytes", "_previous", "_records")

    _bytes: bytes
    """The structs of the library."""
    _previous: bytes
    """The indices in an earlier list, as the library gives them."""
    _records: Optional[tuple[Contact, ...]]
    """The records, once one was asked for."""

    def __init__(self, structs: bytes, previous: bytes) -> None:
        self._bytes, self._previous, self._records = structs, previous, None

    @property
    def array(self) -> numpy.typing.NDArray[numpy.void]:
        """An array of n of dtype CONTACT_DTYPE, which cannot be written to.

        Every access looks at the same memory, without a copy. A list of Contact without
        numpy.
        """
        try:
            import numpy
        except ImportError:
            return list(self)  # type: ignore[return-value]
        return numpy.frombuffer(self._bytes, dtype_of(_structs.Contact))

    @property
    def previous(self) -> tuple[Optional[int], ...]:
        """For each contact its index in the earlier list that was passed, or None.

        None for all contacts of contacts(), which takes no list.
        """
        indices = memoryview(self._previous).cast("Q")
        return tuple(None if index == _NOT_THERE else index for index in indices)

    def _all(self) -> tuple[Contact, ...]:
        if self._records is None:
            kind = _structs.Contact * len(self)
            self._records = tuple(map(contact, kind.from_buffer_copy(self._bytes)))
        return self._records

    def __len__(self) -> int:
        return len(self._bytes) // sizeof(_structs.Contact)

    @overload
    def __getitem__(self, index: int) -> Contact: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Contact]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Contact, Sequence[Contact]]:
        return self._all()[index]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, ContactList):
            return NotImplemented
        return self._bytes == other._bytes and self._previous == other._previous

    def __hash__(self) -> int:
        return hash(self._bytes)

    def __copy__(self) -> ContactList:
        return self

    def __deepcopy__(self, _memo: object) -> ContactList:
        return self

    def __repr__(self) -> str:
        return f"<gcv.ContactList of {len(self)} contact{'s' if len(self) != 1 else ''}>"

    def __reduce__(self) -> tuple[type[ContactList], tuple[bytes, bytes]]:
        return type(self), (self._bytes, self._previous)


def contacts(
    a: PolygonLike,
    b: PolygonLike,
    translation: Iterable[float] = (0, 0),
    distance: float = 0.0,
    slope: float = 0.0,
    *,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> ContactList:
    """All pairs of a feature of A and one of B, moved by a translation, that can touch.

    A pair is an edge and a vertex, or two vertices, that no small part of the polygons
    beside them keeps from touching. It is in the list where the gap between them is not
    above the distance, or, where they are that deep in each other, not below -distance.
    Parallel edges give the ends of what they share, each as a vertex and an edge. Where
    the nearest point of an edge is its end, the pair of two vertices is there as well.

    translation: (x, y). distance: in input units, from 0 on. slope: from 0 on; pairs that
    could touch once one polygon was turned by an angle of at most this tangent are there
    too, so that sides that are parallel but for rounding have both of their contacts.

    The contacts are in the order of the size of the gap, then kind, a, b. Which there are
    is exact. gap is correctly rounded; it is negative where the vertex is on the inner
    side of the edge, and never for two vertices.

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
        *(vertices(a) + vertices(b), threads, progress),
    )
    return ContactList(
        bytes(_ffi.elements(_ffi.contact_list_contacts, _structs.Contact, handle)),
        bytes(_ffi.elements(_ffi.contact_list_previous, c_uint64, handle)),
    )

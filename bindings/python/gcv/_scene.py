# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The class of scenes: the questions to them."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import byref, c_int8, c_uint64
from typing import Any, Callable, Optional, SupportsIndex, TypeVar, overload

from . import _ffi, _structs
from ._call import Progress, run
from ._contact_list import ContactList, contact_list
from ._contacts import Impact, Relation, Separation, record, records
from ._coordinates import number, pair, unfit
from ._many import vertices
from ._members import Members
from ._pair_list import PairList, pair_list
from ._polygon import as_polygon
from ._record_list import RecordList
from ._sources import PolygonLike
from ._two_polygons import VERTICES_A_PAIR, read_vectors
from ._whole_numbers import WholeNumbers, ids_of, one_of_layers

_Handle = TypeVar("_Handle", _ffi.PairList, _ffi.ContactList)

# A guess of how many members are near to a polygon.
_NEIGHBOURS = 8


class Scene(Members):
    """Polygons at positions, the members, and perhaps a container round them; it can change.

    container: what members are to be in; a polygon, or whatever Polygon can be made from,
    or None. It can be set later on.

    A member is its polygon moved by its position, exactly. Members may touch and overlap.
    They have ids: 2, 3, 4, ... as they are added. An id is never used again. The
    container's is 1. The scene keeps each Polygon as it was passed: the numbers of its
    vertices and edges are those of contacts.

    Questions are about all members and the container. layers, a whole number, leaves out
    the members that share no bit with it: set_layers gives them bits, at first they have
    all. The container is in every layer. With layers=0 there is neither. ignore, an id or
    several, leaves out these members, and 1 the container; ids that are not there are no
    error.

    The same changes in the same order give the same answers, to the bit. A change that
    raises leaves the scene as it was.

    Threads may share a scene. Questions of several threads run side by side. A change
    waits until no question runs, and questions wait until it is done. A progress function
    may ask the scene that is being asked, but not change it: that raises RuntimeError, and
    so cancels the question.

    len(scene), iteration and in are about the ids of members. Two scenes are equal only if
    they are one and the same. A scene can be copied and pickled: ids, layers, positions
    and container are kept, and new ids go on from where they were. To read a pickle takes
    time for every id that was ever given out. Takes version 0.2 of the library.

    Raises as Polygon does for the container.
    """

    __slots__ = ()

    @overload
    def relation(
        self,
        moving: PolygonLike,
        positions: tuple[float, float] = ...,
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> Relation: ...

    @overload
    def relation(
        self,
        moving: PolygonLike,
        positions: Iterable[Any],
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> Any: ...

    def relation(
        self,
        moving: PolygonLike,
        positions: Any = (0, 0),
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> Any:
        """How a polygon at a position lies to the members and the container.

        OVERLAPPING if it overlaps one of them, otherwise TOUCHING if it touches one,
        otherwise APART.

        moving: a polygon, or whatever Polygon can be made from. positions: (x, y), in input
        units, for one Relation; or an array or another buffer of shape (n, 2), or a
        sequence of pairs, for an array of n int8. Without numpy that is a list of Relation.

        layers, ignore: which members; see Scene. threads: how many threads share the
        positions; 0 is as many as the machine runs at once. progress: called as
        progress(done, estimate), as gcv.relation does.

        Exact. Takes O(log n), and gcv.relation for each member whose box comes near.

        Raises as Polygon does, and InputError for a position that is no pair of numbers or
        not finite, by its number, for layers, ignore, and an option.
        """
        return self._answer(
            *(_ffi.scene_relation, c_int8, moving),
            {"positions": positions},
            query=(layers, ignore),
            options=(threads, progress),
        )

    @overload
    def distance(
        self,
        moving: PolygonLike,
        positions: tuple[float, float] = ...,
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> Separation: ...

    @overload
    def distance(
        self,
        moving: PolygonLike,
        positions: Iterable[Any],
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> Any: ...

    def distance(
        self,
        moving: PolygonLike,
        positions: Any = (0, 0),
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> Any:
        """How far a polygon at a position is from what is nearest, a member or the container.

        One position gives a Separation; its id says what is nearest. Many give an array of
        n of dtype SEPARATION_DTYPE, with that id in nearest["id_a"]. Without numpy that is
        a list of Separation. Of several at the same distance, it is the one with the
        smallest id. In the contact, a is about it and b about moving.

        The relation is that of relation. Where nothing is there, the distance is infinite,
        the relation is APART, and the id is 0.

        Exact as gcv.distance. Takes O(log n), and gcv.distance for each member whose box is
        as near.

        Arguments and errors are those of relation; Error where a result is larger than any
        finite float.
        """
        return self._answer(
            *(_ffi.scene_distance, _structs.Separation, moving),
            {"positions": positions},
            query=(layers, ignore),
            options=(threads, progress),
        )

    @overload
    def cast(
        self,
        moving: PolygonLike,
        positions: tuple[float, float],
        motions: tuple[float, float],
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> Impact: ...

    @overload
    def cast(
        self,
        moving: PolygonLike,
        positions: Iterable[Any],
        motions: Iterable[Any],
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> Any: ...

    def cast(
        self,
        moving: PolygonLike,
        positions: Any,
        motions: Any,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> Any:
        """How far a polygon can move along a motion before it overlaps something.

        It moves from the position to position + motion, as in gcv.cast, to the first member
        that is hit, or the container.

        positions, motions: each is (x, y), or an array of shape (n, 2), or a sequence of
        pairs. Two pairs give an Impact; its id says what is hit, also where they overlap at
        the start. Otherwise there is an array of n of dtype IMPACT_DTYPE, with that id in
        contact["id_a"]; a pair stands for n of them. Without numpy that is a list of
        Impact. Of several that are hit at the same time, it is the one with the smallest
        id. Position and relation are about the whole scene.

        Exact as gcv.cast. Takes gcv.cast for each member whose box the motion meets.

        The other arguments and the errors are those of distance; ValueError where there are
        not as many positions as motions.
        """
        return self._answer(
            *(_ffi.scene_cast, _structs.Impact, moving),
            {"positions": positions, "motions": motions},
            query=(layers, ignore),
            options=(threads, progress),
        )

    def near(
        self,
        moving: PolygonLike,
        position: Iterable[float],
        distance: float = 0.0,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> PairList:
        """What is no further than a distance from a polygon at a position.

        Each Pair has the id of a member, or of the container, in a, and 0 in b; from the
        smallest id on.

        position: (x, y). distance: in input units, from 0 on. Exact.

        The other arguments and the errors are those of relation; InputError also for a
        distance that is negative or not finite.
        """
        polygon = as_polygon(moving, "moving")
        point = _structs.Point(*pair(position, "position"))
        limit, query, handle = number(distance, "distance"), _query(layers, ignore), _ffi.PairList()
        self._ask(
            lambda options: _ffi.scene_near(
                *(self._handle, polygon._handle, point, limit, query, options, byref(handle))
            ),
            *(self._vertices_near(vertices(polygon)), threads, progress),
        )
        return pair_list(handle)

    def pairs(
        self,
        distance: float = 0.0,
        previous: Optional[PairList] = None,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> PairList:
        """All pairs that are no further than a distance from each other.

        Pairs of members, and of the container and a member: with a < b, by a, then by b.

        distance: in input units, from 0 on. previous: an earlier list that pairs gave for
        this scene, or for one that it was copied from or to. What has not moved since is then not
        computed again, where distance, layers and ignore are the same. The list is the
        same as without it.

        Exact. Takes O(n log n), and gcv.distance for each pair whose boxes are as near;
        with a previous list O(n), and that for the members that have changed.

        The other arguments and the errors are those of near; InputError also for a list of
        another scene.
        """
        limit, query, handle = number(distance, "distance"), _query(layers, ignore), _ffi.PairList()
        earlier = _handle_of(previous, PairList, _ffi.PairList)
        self._ask(
            lambda options: _ffi.scene_pairs(
                *(self._handle, earlier, limit, query, options, byref(handle))
            ),
            *(self._vertices_of_pairs(), threads, progress),
        )
        return pair_list(handle)

    def contacts(
        self,
        distance: float = 0.0,
        slope: float = 0.0,
        previous: Optional[ContactList] = None,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> ContactList:
        """The contacts of all pairs, within a distance: those of gcv.contacts.

        Pairs of members, and of the container and a member, with id_a < id_b. In a contact,
        a is about what has id_a, and the points are where the members are. They are in the
        order of the size of the gap, then id_a, id_b, kind, a, b.

        distance, slope: as in gcv.contacts. previous: an earlier list of contacts of this
        scene, or of one that it was copied from or to. What has not moved since is then not
        computed again. ContactList.previous tells which contacts were in that list. The
        contacts are the same as without it.

        Exact as gcv.contacts. Takes as long as pairs, and gcv.contacts for each pair.

        The other arguments and the errors are those of pairs and of gcv.contacts.
        """
        limits, query = (
            (number(distance, "distance"), number(slope, "slope")),
            _query(layers, ignore),
        )
        earlier, handle = _handle_of(previous, ContactList, _ffi.ContactList), _ffi.ContactList()
        self._ask(
            lambda options: _ffi.scene_contacts(
                *(self._handle, earlier, *limits, query, options, byref(handle))
            ),
            *(self._vertices_of_pairs(), threads, progress),
        )
        return contact_list(handle)

    def _answer(
        self,
        function: Callable[..., int],
        kind: Any,
        moving: PolygonLike,
        vectors: dict[str, Any],
        query: tuple[Optional[SupportsIndex], WholeNumbers],
        options: tuple[int, Optional[Progress]],
    ) -> Any:
        """What the function gives, of that C type, for the vectors by their names.

        A record where each of the vectors is one; otherwise an array.
        """
        polygon, members = as_polygon(moving, "moving"), _query(*query)
        arguments, count, is_one = read_vectors(vectors)
        out = (kind * count)()
        self._ask(
            lambda known: function(
                *(self._handle, polygon._handle, *arguments, count, members, known, out)
            ),
            *(count * self._vertices_near(vertices(polygon)), *options),
        )
        return record(out) if is_one else records(out)

    def _ask(
        self,
        call: Callable[[Any], object],
        visited: int,
        threads: int,
        progress: Optional[Progress],
    ) -> None:
        """As run does call(options), while nothing changes; visited is a number of vertices."""
        with self._gate.asking():
            run(call, visited // VERTICES_A_PAIR, "nearest", 0, threads, progress)

    def _vertices_near(self, own: int) -> int:
        """A guess of the vertices that a polygon of so many is compared with, and its own."""
        container = 0 if self._container is None else vertices(self._container)
        return container + _NEIGHBOURS * (own + self._vertices // max(len(self), 1))

    def _vertices_of_pairs(self) -> int:
        """A guess of the vertices of all pairs that are near."""
        container = 0 if self._container is None else vertices(self._container)
        return container + 2 * _NEIGHBOURS * self._vertices


def _query(layers: Optional[SupportsIndex], ignore: WholeNumbers) -> Optional[_structs.Query]:
    """Which members a question is about, as the library takes it; None for all."""
    ids, _ = ids_of(ignore, "ignore")
    if layers is None and not ids:
        return None
    query: _structs.Query = _structs.sized(_structs.Query, ignore_count=len(ids))
    query.layers = 2**32 - 1 if layers is None else one_of_layers(layers, "layers")
    query.ignore = (c_uint64 * len(ids))(*ids)
    return query


def _handle_of(
    previous: Optional[RecordList[Any]], kind: type[RecordList[Any]], handle: type[_Handle]
) -> Optional[_Handle]:
    """The handle of an earlier list, which should be of that kind."""
    if previous is None:
        return None
    if not isinstance(previous, kind):
        raise unfit("previous", previous, f"a gcv.{kind.__name__}")
    if not isinstance(previous._handle, handle):
        raise unfit("previous", previous, "the list of a scene: it was pickled")
    return previous._handle

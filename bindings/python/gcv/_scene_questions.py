# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Questions about a polygon and a scene: relation, distance, cast."""

from __future__ import annotations

from ctypes import c_int8, c_uint64
from threading import get_ident
from typing import TYPE_CHECKING, Any, Callable, Optional, SupportsIndex, Union, overload

from . import _ffi, _structs
from ._call import LeaveOut, Progress, run
from ._contacts import Impact, Relation, Separation, record, records
from ._many import vertices
from ._members import Members
from ._polygon import as_polygon
from ._sources import PolygonLike, Vector, Vectors
from ._two_polygons import VERTICES_A_PAIR, read_vectors
from ._whole_numbers import WholeNumbers, ids_of, one_of_layers

if TYPE_CHECKING:
    import numpy
    import numpy.typing

# A guess of how many members are near to a polygon.
NEIGHBOURS = 8


class Questions(Members):
    """The members of a scene, and questions about them and another polygon."""

    __slots__ = ()

    @overload
    def relation(
        self,
        moving: PolygonLike,
        positions: Vector = ...,
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
        positions: Vectors,
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> numpy.typing.NDArray[numpy.int8]: ...

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
        positions: Vector = ...,
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
        positions: Vectors,
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> numpy.typing.NDArray[numpy.void]: ...

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
    def cast(  # type: ignore[overload-overlap]
        self,
        moving: PolygonLike,
        positions: Vector,
        motions: Vector,
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
        positions: Union[Vector, Vectors],
        motions: Union[Vector, Vectors],
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
    ) -> numpy.typing.NDArray[numpy.void]: ...

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

        The other arguments and the errors are those of distance; InputError also where
        there are not as many positions as motions.
        """
        return self._answer(
            *(_ffi.scene_cast, _structs.Impact, moving),
            {"positions": positions, "motions": motions},
            query=(layers, ignore),
            options=(threads, progress),
        )

    def _answer(
        self,
        function: Callable[..., int],
        kind: Any,
        moving: PolygonLike,
        vectors: dict[str, Any],
        query: tuple[Optional[SupportsIndex], WholeNumbers],
        options: tuple[Any, ...],
        passes_all: bool = False,
    ) -> Any:
        """What the function gives, of that C type, for the vectors by their names.

        A record where each of the vectors is one; otherwise an array. The options are those
        of _ask. passes_all: may it visit all members, and pairs of vertices with them?
        """
        polygon, members = as_polygon(moving, "moving"), query_of(*query)
        arguments, count, is_one = read_vectors(vectors)
        out = (kind * count)()
        own = vertices(polygon)
        visited = own * self._vertices if passes_all else self._vertices_near(own)
        self._ask(
            lambda known: function(
                *(self._handle, polygon._handle, *arguments, count, members, known, out)
            ),
            *(count * visited, *options),
        )
        return record(out) if is_one else records(out)

    def _ask(
        self,
        call: Callable[[Any], object],
        visited: int,
        threads: int,
        progress: Optional[Progress],
        leave_out: LeaveOut = (),
    ) -> None:
        """As run does call(options), while nothing changes; visited is a number of vertices."""
        pairs = visited // VERTICES_A_PAIR
        self._gate.ask(
            lambda: run(self._kept(call), pairs, "nearest", 0.0, threads, progress, leave_out)
        )

    def _kept(self, call: Callable[[Any], object]) -> Callable[[Any], object]:
        """The call, in whatever thread it is made: nothing changes before it ends.

        Not even where the thread that waits for it was interrupted, again and again.
        """
        caller = get_ident()
        return lambda options: self._gate.ask(lambda: call(options), caller)

    def _vertices_near(self, own: int) -> int:
        """A guess of the vertices that a polygon of so many is compared with, and its own."""
        members = NEIGHBOURS * (own + self._vertices // max(len(self), 1))
        return self._container_vertices() + members

    def _container_vertices(self) -> int:
        container = self._container
        return 0 if container is None else vertices(container)


def query_of(layers: Optional[SupportsIndex], ignore: WholeNumbers) -> Optional[_structs.Query]:
    """Which members a question is about, as the library takes it; None for all."""
    ids, _ = ids_of(ignore, "ignore")
    if layers is None and not ids:
        return None
    query: _structs.Query = _structs.sized(_structs.Query, ignore_count=len(ids))
    query.layers = 2**32 - 1 if layers is None else one_of_layers(layers, "layers")
    query.ignore = (c_uint64 * len(ids))(*ids)
    return query

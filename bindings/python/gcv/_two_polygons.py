# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Questions about two polygons, one of which is moved by many translations."""

from __future__ import annotations

import re
from ctypes import c_int8
from typing import TYPE_CHECKING, Any, Callable, Optional, Union, overload

from . import _ffi, _structs
from ._call import LeaveOut, Progress, run
from ._contacts import Escape, Impact, Relation, Separation, record, records
from ._coordinates import point_or_points, size
from ._many import vertices
from ._polygon import Polygon, as_polygon
from ._sources import PolygonLike, Vector, Vectors

if TYPE_CHECKING:
    import numpy
    import numpy.typing

# In the time of a pair of vertices in a sum, a translation gets past so many vertices.
VERTICES_A_PAIR = 16


@overload
def relation(
    a: PolygonLike,
    b: PolygonLike,
    translation: Vector = ...,
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
) -> Relation: ...


@overload
def relation(
    a: PolygonLike,
    b: PolygonLike,
    translation: Vectors,
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
) -> numpy.typing.NDArray[numpy.int8]: ...


def relation(
    a: PolygonLike,
    b: PolygonLike,
    translation: Any = (0, 0),
    *,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Any:
    """How A and B moved by a translation lie: apart, touching or overlapping.

    a, b: polygons, or whatever Polygon can be made from, with their holes. A polygon in
    a hole of the other is apart from it, or touches it.

    translation: (x, y), in input units, for one Relation; or an array or another buffer
    of shape (n, 2), or a sequence of pairs, for an array of n int8: APART 1, TOUCHING 0,
    OVERLAPPING -1. Without numpy that is a list of Relation. The moved coordinates are
    sums of two floats, and are never rounded.

    threads: how many threads share the translations; 0 is as many as the machine runs
    at once. progress: called as progress(done, estimate), with numbers of translations,
    as minkowski_sum does. An exception that it raises cancels the computation, and so
    does a long one in the main thread KeyboardInterrupt.

    Exact. The first question to a polygon prepares it: one that is asked again is best
    made a Polygon first. Takes version 0.2 of the library.

    Raises as Polygon does, and InputError for a translation that is no pair of numbers
    or not finite, by its number, and for an option.
    """
    return _answer(
        *(_ffi.relation, c_int8, a, b),
        {"translation": translation},
        options=(threads, progress),
    )


@overload
def distance(
    a: PolygonLike,
    b: PolygonLike,
    translation: Vector = ...,
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
) -> Separation: ...


@overload
def distance(
    a: PolygonLike,
    b: PolygonLike,
    translation: Vectors,
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
) -> numpy.typing.NDArray[numpy.void]: ...


def distance(
    a: PolygonLike,
    b: PolygonLike,
    translation: Any = (0, 0),
    *,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Any:
    """How far B moved by a translation is from A, and where they are nearest.

    One translation gives a Separation. Many give an array of n of dtype SEPARATION_DTYPE,
    with the fields distance, relation and nearest, which is all 0 where they touch or
    overlap. Without numpy that is a list of Separation.

    The relation and the features are exact, the distance is correctly rounded, in input
    units. It can underflow to 0 while the polygons are apart.

    Arguments and errors are those of relation; Error where a result is larger than any
    finite float.
    """
    return _answer(
        *(_ffi.distance, _structs.Separation, a, b),
        {"translation": translation},
        options=(threads, progress),
    )


@overload
def cast(  # type: ignore[overload-overlap]
    a: PolygonLike,
    b: PolygonLike,
    translation: Vector,
    motion: Vector,
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
) -> Impact: ...


@overload
def cast(
    a: PolygonLike,
    b: PolygonLike,
    translation: Union[Vector, Vectors],
    motion: Union[Vector, Vectors],
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
) -> numpy.typing.NDArray[numpy.void]: ...


def cast(
    a: PolygonLike,
    b: PolygonLike,
    translation: Any,
    motion: Any,
    *,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Any:
    """How far B can move along a motion before it overlaps A.

    B moves from the translation to translation + motion. Sliding along a boundary is no
    hit, and neither is touching at the end of the motion. Where they overlap at the start,
    that is a hit at time 0 without a contact.

    translation, motion: each is (x, y), or an array of shape (n, 2), or a sequence of
    pairs, in input units. Two pairs give an Impact. Otherwise there is an array of n of
    dtype IMPACT_DTYPE, with the fields hit, which is 1 or 0, relation, time, position
    and contact, which is all 0 where there is none; a pair stands for n of them. Without
    numpy that is a list of Impact.

    hit, contact and relation are exact. The time is rounded down: B does not overlap A
    at translation + time * motion, taken exactly.

    The other arguments and the errors are those of distance; InputError also where there
    are not as many translations as motions.
    """
    return _answer(
        *(_ffi.cast, _structs.Impact, a, b),
        {"translation": translation, "motion": motion},
        options=(threads, progress),
    )


@overload
def penetration(
    a: PolygonLike,
    b: PolygonLike,
    translation: Vector = ...,
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    leave_out: LeaveOut = ...,
) -> Escape: ...


@overload
def penetration(
    a: PolygonLike,
    b: PolygonLike,
    translation: Vectors,
    *,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    leave_out: LeaveOut = ...,
) -> numpy.typing.NDArray[numpy.void]: ...


def penetration(
    a: PolygonLike,
    b: PolygonLike,
    translation: Any = (0, 0),
    *,
    threads: int = 1,
    progress: Optional[Progress] = None,
    leave_out: LeaveOut = (),
) -> Any:
    """The shortest way out: how B is best moved on so that it does not overlap A.

    One translation gives an Escape. Many give an array of n of dtype ESCAPE_DTYPE, with
    the fields depth, translation, position, relation and contact. Without numpy that is a
    list of Escape. Where they do not overlap, the depth is 0.

    Ways into holes, and into places that one polygon fits exactly, count. leave_out:
    "holes", "fits", or both, for ways that do not lead there.

    The way is the exact one; the depth is correctly rounded, in input units. The other
    arguments and the errors are those of distance.
    """
    a, b = as_polygon(a, "a"), as_polygon(b, "b")
    return _answer(
        *(_ffi.penetration, _structs.Escape, a, b),
        {"translation": translation},
        options=(threads, progress, leave_out),
        visited=vertices(a) * vertices(b),  # the way out of a deep overlap passes most of them
    )


def _answer(
    function: Callable[..., int],
    kind: Any,
    a: PolygonLike,
    b: PolygonLike,
    vectors: dict[str, Any],
    options: tuple[Any, ...],
    visited: int = 0,
) -> Any:
    """What the function gives, of that C type, for the vectors by their names.

    A record where each of the vectors is one; otherwise an array. The options are those of
    ask. visited: how many pairs of vertices a long search visits, if that is more than usual.
    """
    a, b = as_polygon(a, "a"), as_polygon(b, "b")
    arguments, count, is_one = read_vectors(vectors)
    out = (kind * count)()
    ask(
        lambda known: function(a._handle, b._handle, *arguments, count, known, out),
        *(count * max(visited, (vertices(a) + vertices(b)) // VERTICES_A_PAIR), *options),
    )
    return record(out) if is_one else records(out)


def read_vectors(vectors: dict[str, Any]) -> tuple[list[bytes], int, bool]:
    """The doubles of vectors by their names, their number, and whether each is one.

    One vector stands for as many as there are of the others.
    """
    read = {name: _read(value, name) for name, value in vectors.items()}
    counts = {name: size(doubles) for name, (doubles, is_one) in read.items() if not is_one}
    count = next(iter(counts.values()), 1)
    if len(set(counts.values())) > 1:
        found = " and ".join(f"{name} has {n} pairs" for name, n in counts.items())
        raise _ffi.InputError(_ffi.INVALID_ARGUMENT, found)
    doubles = [doubles * count if is_one else doubles for doubles, is_one in read.values()]
    return doubles, count, not counts


def distance_in(polygon: Polygon, distance: float) -> float:
    """A distance in sizes of the polygon, from 0 on; 0 for what is no distance."""
    x0, y0, x1, y1 = polygon.bounds
    return max(0.0, distance / max(x1 - x0, y1 - y0))


def ask(
    call: Callable[[Any], Any],
    pairs: int,
    threads: int,
    progress: Optional[Progress],
    leave_out: LeaveOut = (),
) -> None:
    """As run does call(options); messages name the arguments as they are called here.

    pairs is a guess of how many pairs of vertices are visited.
    """
    try:
        run(call, pairs, "nearest", 0.0, threads, progress, leave_out)
    except _ffi.Error as error:
        reason = re.sub(r"^(translation|motion)s:", r"\1:", str(error))
        raise type(error)(error.status, reason) from None


def _read(value: Any, name: str) -> tuple[bytes, bool]:
    return point_or_points(value, name, "a pair of numbers, nor a sequence of pairs")

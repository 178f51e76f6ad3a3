# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The functions of the package."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import byref, c_int32, c_void_p
from typing import Any, Literal, NamedTuple, Optional, Union, overload

from . import _ffi
from ._call import Progress, Rounding, run
from ._shapes import EdgeSource, OuterFace, Polygon, PolygonLike, as_polygon


class SupersetEdge(NamedTuple):
    """An edge of the superset, from one point to another."""

    start: tuple[float, float]
    end: tuple[float, float]
    source: EdgeSource


def minkowski_sum(
    a: PolygonLike,
    b: PolygonLike,
    *,
    rounding: Rounding = "nearest",
    tolerance: float = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> OuterFace:
    """The outer face of the Minkowski sum A + B = {a + b : a in A, b in B}.

    a, b: polygons, or whatever Polygon can be made from.

    rounding: how exact coordinates become floats. With "nearest" each is the nearest
    float, save where vertices must move a few units in the last place for the ring to
    be simple; with "outward" the region inside the ring contains the exact one.

    tolerance: how far, in input units, the result may be from the exact one, but for
    the rounding: finite, from 0 on. Above 0, each polygon is first simplified by at most
    half of it, as Polygon.simplified does, where that saves a quarter of its vertices;
    error_bound says how far the result is at most. With rounding="outward" it still
    contains the exact sum.

    threads: how many threads work on the sum; 0 is as many as the machine runs at
    once. The result is the same, to the bit, for every number.

    progress: called as progress(done, estimate) from the calling thread, some ten
    times a second and once in the end, with the steps done and a guess of all steps,
    which is never below. An exception that it raises cancels the computation.

    Exact, but for the rounding: see OuterFace. In the main thread, KeyboardInterrupt and
    any exception that a handler of a signal raises cancels a long computation. Other
    threads run meanwhile.

    Raises as Polygon does, InputError for an option, and Error where a coordinate of
    the result is not a finite float, or where the result is so small that in floats
    it has no area.
    """
    a, b = as_polygon(a), as_polygon(b)
    face = _ffi.OuterFace()
    run(
        lambda options: _ffi.minkowski_sum(a._handle, b._handle, options, face),
        *(_pairs(a, b), rounding, tolerance, threads, progress),
    )
    return OuterFace(face, {})


def no_fit_polygon(
    fixed: PolygonLike,
    moving: PolygonLike,
    reference: Iterable[float],
    *,
    rounding: Rounding = "nearest",
    tolerance: float = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> OuterFace:
    """The no-fit polygon fixed + (-moving) + reference.

    It is where the point reference, (x, y) and tied to moving, may go while the two
    polygons touch: inside the ring they overlap, on it they touch, outside they are
    apart. The reference is added exactly, before rounding. In the sources, a is a
    number of fixed and b one of moving.

    Options, exactness and errors are those of minkowski_sum; a reference that is not
    finite raises InputError.
    """
    fixed, moving, point = as_polygon(fixed), as_polygon(moving), _point(reference)
    face = _ffi.OuterFace()
    run(
        lambda options: _ffi.no_fit_polygon(fixed._handle, moving._handle, point, options, face),
        *(_pairs(fixed, moving), rounding, tolerance, threads, progress),
    )
    return OuterFace(face, {})


def entrance_block(
    a: PolygonLike,
    b: PolygonLike,
    a0: Iterable[float],
    *,
    rounding: Rounding = "nearest",
    tolerance: float = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> OuterFace:
    """Shi's entrance block E(A, B) = B + (-A) + a0.

    It is where the point a0, (x, y) and tied to block A, may go while A and B touch.
    In the sources, a is a number of A and b one of B.

    Options, exactness and errors are those of no_fit_polygon.
    """
    a, b, point = as_polygon(a), as_polygon(b), _point(a0)
    face = _ffi.OuterFace()
    run(
        lambda options: _ffi.entrance_block(a._handle, b._handle, point, options, face),
        *(_pairs(a, b), rounding, tolerance, threads, progress),
    )
    return OuterFace(face, {})


@overload
def minkowski_sum_many(
    a: Iterable[PolygonLike],
    b: Iterable[PolygonLike],
    *,
    rounding: Rounding = ...,
    tolerance: float = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    return_errors: Literal[False] = ...,
) -> list[OuterFace]: ...


@overload
def minkowski_sum_many(
    a: Iterable[PolygonLike],
    b: Iterable[PolygonLike],
    *,
    rounding: Rounding = ...,
    tolerance: float = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    return_errors: bool,
) -> list[Union[OuterFace, _ffi.Error]]: ...


def minkowski_sum_many(
    a: Iterable[PolygonLike],
    b: Iterable[PolygonLike],
    *,
    rounding: Rounding = "nearest",
    tolerance: float = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    return_errors: bool = False,
) -> Any:
    """Many sums in one call: the k-th outer face is that of a[k] + b[k].

    Each is what minkowski_sum gives, whose options these are; the pairs are shared out
    over the threads. A polygon that occurs more than once is best made a Polygon first,
    for whatever else is made one at each occurrence.

    A pair that cannot be summed leaves the others as they are. With return_errors its
    Error takes the place of the outer face; otherwise the first such Error is raised.
    The text of the first one names the pair and the reason.

    Raises as Polygon does, InputError for an option, and ValueError where a and b are
    not equally many.
    """
    first, second = [as_polygon(p) for p in a], [as_polygon(p) for p in b]
    count = len(first)
    if len(second) != count:
        raise ValueError(f"a has {count} polygons, b has {len(second)}")
    faces = (c_void_p * count)()
    statuses = (c_int32 * count)()

    def call(options: Any) -> str:
        handles = _handles(first), _handles(second)
        _ffi.minkowski_sum_many(*handles, count, options, faces, statuses)
        return _ffi.last_error_message()

    pairs = sum(map(_pairs, first, second))
    try:
        message = run(call, pairs, rounding, tolerance, threads, progress)
    finally:
        owned = [OuterFace(_ffi.OuterFace(face), {}) for face in faces]
    results: list[Union[OuterFace, _ffi.Error]] = list(owned)
    for k, status in enumerate(statuses):
        if status != 0:
            error = _ffi.error(status, message or f"pair {k} alone says why it fails")
            if not return_errors:
                raise error
            results[k] = error
            message = ""
    return results


def superset(a: PolygonLike, b: PolygonLike) -> list[SupersetEdge]:
    """The superset of the outer face of A + B, for plots and for tests.

    First the translated edges, then the corner edges, then the translated-corner
    edges; there can be in the order of n m of them. Which edges there are is exact,
    their coordinates are correctly rounded. Sums do not need it.

    Raises as Polygon does, and Error where a coordinate is not a finite float.
    """
    handle = _ffi.Superset()
    _ffi.superset_create(as_polygon(a)._handle, as_polygon(b)._handle, byref(handle))
    return [
        SupersetEdge(
            (edge.x0, edge.y0),
            (edge.x1, edge.y1),
            EdgeSource(edge.source.kind, edge.source.a, edge.source.b),
        )
        for edge in _ffi.elements(_ffi.superset_edges, _ffi.SupersetEdge, handle)
    ]


def library_version() -> str:
    """The version of the library that is running, such as "0.1.0"."""
    version: bytes = _ffi.version_string()
    return version.decode()


def _pairs(a: Polygon, b: Polygon) -> int:
    """The number of pairs of a vertex of a and one of b."""
    return (len(a._given) // 16) * (len(b._given) // 16)


def _handles(polygons: list[Polygon]) -> Any:
    return (c_void_p * len(polygons))(*(polygon._handle.value for polygon in polygons))


def _point(pair: Iterable[float]) -> Any:
    x, y = pair
    return _ffi.Point(x, y)

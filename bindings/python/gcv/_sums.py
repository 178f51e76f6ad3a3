# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Outer faces, supersets, and the version of the library."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import byref
from typing import Any, Literal, NamedTuple, Optional, SupportsFloat, Union, overload

from . import _ffi, _structs
from ._call import Progress, Rounding, run
from ._coordinates import pair
from ._facts import EdgeSource
from ._many import each, vertex_pairs
from ._outer_face import OuterFace
from ._polygon import as_polygon
from ._result_list import ResultList
from ._sources import PointLike, PolygonLike, PolygonsLike


class SupersetEdge(NamedTuple):
    """An edge of the superset, from one point to another."""

    start: tuple[float, float]
    """Its first point, in floats."""
    end: tuple[float, float]
    """Its last point, in floats."""
    source: EdgeSource
    """Where it comes from."""


def minkowski_sum(
    a: PolygonLike,
    b: PolygonLike,
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> OuterFace:
    """The outer face of the Minkowski sum A + B = {a + b : a in A, b in B}.

    a, b: polygons, or whatever Polygon can be made from. Their holes change nothing.

    The ring is the outer boundary. It leaves out what lies inside: holes of the sum, and
    the segments and points of exact fits. minkowski_sum_region has all of them.

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
    a, b = as_polygon(a, "a"), as_polygon(b, "b")
    face = _ffi.OuterFace()
    run(
        lambda options: _ffi.minkowski_sum(a._handle, b._handle, options, face),
        *(vertex_pairs(a, b), rounding, tolerance, threads, progress),
    )
    return OuterFace(face)


def no_fit_polygon(
    fixed: PolygonLike,
    moving: PolygonLike,
    reference: PointLike = (0, 0),
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> OuterFace:
    """The no-fit polygon fixed + (-moving) + reference.

    It is where the point reference, (x, y) and tied to moving, may go while the two
    polygons touch. The reference is the origin by default, and is added exactly, before
    rounding. In the sources, a is a number of fixed and b one of moving.

    With the point outside the exact ring the two polygons are apart. On the ring they
    touch and do not overlap. Inside the ring they overlap, but not everywhere: in a hole
    of the sum they are apart. In a slit without width and at a single free point, as
    where one polygon just fits the other, they touch and do not overlap. The ring has
    none of these positions, unless a gap connects them with the outside, however narrow,
    in the floats passed in. no_fit_region has all of them.

    Options, exactness and errors are those of minkowski_sum; a reference that is not
    finite raises InputError.
    """
    fixed, moving = as_polygon(fixed, "fixed"), as_polygon(moving, "moving")
    point = _structs.Point(*pair(reference, "reference"))
    face = _ffi.OuterFace()
    run(
        lambda options: _ffi.no_fit_polygon(fixed._handle, moving._handle, point, options, face),
        *(vertex_pairs(fixed, moving), rounding, tolerance, threads, progress),
    )
    return OuterFace(face)


def entrance_block(
    a: PolygonLike,
    b: PolygonLike,
    a0: PointLike = (0, 0),
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> OuterFace:
    """Shi's entrance block E(A, B) = B + (-A) + a0.

    It is where the point a0, (x, y) and tied to block A, may go while A and B touch; a0
    is the origin by default. In the sources, a is a number of A and b one of B.

    What holds outside, on and inside the ring is said at no_fit_polygon. entrance_region
    has what the ring leaves out.

    Options, exactness and errors are those of no_fit_polygon.
    """
    a, b, point = as_polygon(a, "a"), as_polygon(b, "b"), _structs.Point(*pair(a0, "a0"))
    face = _ffi.OuterFace()
    run(
        lambda options: _ffi.entrance_block(a._handle, b._handle, point, options, face),
        *(vertex_pairs(a, b), rounding, tolerance, threads, progress),
    )
    return OuterFace(face)


@overload
def minkowski_sum_many(
    a: PolygonsLike,
    b: PolygonsLike,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    return_errors: Literal[False] = ...,
) -> ResultList[OuterFace]: ...


@overload
def minkowski_sum_many(
    a: PolygonsLike,
    b: PolygonsLike,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    return_errors: bool,
) -> ResultList[Union[OuterFace, _ffi.Error]]: ...


def minkowski_sum_many(
    a: PolygonsLike,
    b: PolygonsLike,
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    return_errors: bool = False,
) -> Any:
    """Many sums in one call: the k-th outer face is that of a[k] + b[k].

    a, b: sequences of whatever Polygon can be made from; collections and text of several
    polygons, as Polygon.many takes them; or columns, as GeoPandas has them
    (a GeoSeries, a GeoDataFrame, a GeometryArray), or Arrow arrays of geoarrow.polygon,
    geoarrow.multipolygon, geoarrow.wkb or geoarrow.wkt, which take pyarrow. Pairs are made
    by position. The result is a list that is such a column too, see ResultList.

    Each is what minkowski_sum gives, whose options these are; the pairs are shared out
    over the threads. A polygon that occurs more than once is best made a Polygon first,
    for whatever else is made one at each occurrence.

    A pair that cannot be summed leaves the others as they are, be it for a source that
    is no polygon. With return_errors its Error takes the place of the outer face;
    otherwise the first such Error is raised, one for a source that is no polygon before
    any other. The text of an Error for a source names it, as in "a[2]"; the text of the
    first other one names the pair and the reason.

    Raises as Polygon does, and InputError for an option, where a and b are not equally
    many, and for columns whose indexes or reference systems differ.
    """
    return each(
        *(_ffi.minkowski_sum_many, OuterFace, {"a": a, "b": b}),
        references=None,
        return_errors=return_errors,
        options=(rounding, tolerance, threads, progress),
    )


@overload
def no_fit_polygon_many(
    fixed: PolygonsLike,
    moving: PolygonsLike,
    references: Optional[Iterable[PointLike]] = ...,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    return_errors: Literal[False] = ...,
) -> ResultList[OuterFace]: ...


@overload
def no_fit_polygon_many(
    fixed: PolygonsLike,
    moving: PolygonsLike,
    references: Optional[Iterable[PointLike]] = ...,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    return_errors: bool,
) -> ResultList[Union[OuterFace, _ffi.Error]]: ...


def no_fit_polygon_many(
    fixed: PolygonsLike,
    moving: PolygonsLike,
    references: Optional[Iterable[PointLike]] = None,
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    return_errors: bool = False,
) -> Any:
    """Many no-fit polygons in one call: the k-th is fixed[k] + (-moving[k]) + references[k].

    Each is what no_fit_polygon gives. references: an array of shape (n, 2), or another
    sequence of pairs; all are the origin by default.

    Options and errors are those of minkowski_sum_many. A reference that is no pair of
    numbers, or not finite, fails its pair, as a source that is no polygon does.
    """
    return each(
        *(_ffi.no_fit_polygon_many, OuterFace, {"fixed": fixed, "moving": moving}),
        references=references,
        return_errors=return_errors,
        options=(rounding, tolerance, threads, progress),
    )


def superset(a: PolygonLike, b: PolygonLike) -> list[SupersetEdge]:
    """The superset of the outer face of A + B, for plots and for tests.

    First the translated edges, then the corner edges, then the translated-corner
    edges; there can be in the order of n m of them. Which edges there are is exact,
    their coordinates are correctly rounded. Sums do not need it.

    Raises as Polygon does, and Error where a coordinate is not a finite float.
    """
    handle = _ffi.Superset()
    a, b = as_polygon(a, "a"), as_polygon(b, "b")
    _ffi.superset_create(a._handle, b._handle, byref(handle))
    return [
        SupersetEdge(
            (edge.x0, edge.y0),
            (edge.x1, edge.y1),
            EdgeSource(edge.source.kind, edge.source.a, edge.source.b),
        )
        for edge in _ffi.elements(_ffi.superset_edges, _structs.SupersetEdge, handle)
    ]


def library_version() -> str:
    """The version of the library that is running, such as "0.1.0"."""
    version: bytes = _ffi.version_string()
    return version.decode()

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Regions of two polygons: whole sums, no-fit regions and inner fits."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Callable, Literal, Optional, SupportsFloat, Union, overload

from . import _ffi, _structs
from ._call import LeaveOut, Progress, Rounding, run
from ._coordinates import pair
from ._many import each, vertex_pairs
from ._polygon import Polygon, as_polygon
from ._region import Region
from ._result_list import ResultList
from ._sources import PointLike, PolygonLike, PolygonsLike


def minkowski_sum_region(
    a: PolygonLike,
    b: PolygonLike,
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    leave_out: LeaveOut = (),
) -> Region:
    """The whole Minkowski sum A + B: its outer ring, its holes, and the exact fits in it.

    a, b: polygons, or whatever Polygon can be made from, with their holes.

    The interior of the region is the open sum: the sums of an inner point of A and an
    inner point of B. Its holes are what the open sum leaves free. In its segments and
    points, A and the reflection of B fit exactly. There is one polygon, whose outer ring
    is the ring of minkowski_sum, vertex for vertex, but where a tolerance would make it
    cross holes.

    leave_out: "holes", "fits", or both, as in ("holes", "fits"), for a region without
    its holes, or without its segments and points; () leaves out nothing. To leave out
    both saves the search for them.

    The other options, exactness and errors are those of minkowski_sum; with
    rounding="outward" the region contains the exact one. Takes version 0.2 of the
    library.
    """
    options = rounding, tolerance, threads, progress, leave_out
    a, b = as_polygon(a, "a"), as_polygon(b, "b")
    return _region(_ffi.minkowski_sum_region, a, b, [], options)


def no_fit_region(
    fixed: PolygonLike,
    moving: PolygonLike,
    reference: PointLike = (0, 0),
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    leave_out: LeaveOut = (),
) -> Region:
    """The no-fit region fixed + (-moving) + reference, with its holes and exact fits.

    It is where the point reference, (x, y) and tied to moving, may not go. The reference
    is the origin by default, and is added exactly, before rounding. In the sources, a is a
    number of fixed and b one of moving.

    With the point in the interior of the region, and on no segment and no point of it,
    the two polygons overlap. With the point anywhere else they do not: outside the outer
    ring and inside the holes they are apart; on the rings, the segments and the points
    they touch. Region.locate tells which, exactly: they overlap where it says INSIDE,
    touch where it says BOUNDARY, and are apart where it says OUTSIDE.

    Options, exactness and errors are those of minkowski_sum_region; a reference that is
    not finite raises InputError.
    """
    options = rounding, tolerance, threads, progress, leave_out
    fixed, moving = as_polygon(fixed, "fixed"), as_polygon(moving, "moving")
    return _region(
        _ffi.no_fit_region, fixed, moving, [_structs.Point(*pair(reference, "reference"))], options
    )


def entrance_region(
    a: PolygonLike,
    b: PolygonLike,
    a0: PointLike = (0, 0),
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    leave_out: LeaveOut = (),
) -> Region:
    """The whole of Shi's entrance block E(A, B) = B + (-A) + a0.

    It is where the point a0, (x, y) and tied to block A, may not go; a0 is the origin by
    default. It is no_fit_region of B and A, but in the sources a is a number of A and b
    one of B.

    Options, exactness and errors are those of no_fit_region.
    """
    options = rounding, tolerance, threads, progress, leave_out
    a, b = as_polygon(a, "a"), as_polygon(b, "b")
    return _region(_ffi.entrance_region, a, b, [_structs.Point(*pair(a0, "a0"))], options)


def inner_fit_region(
    container: PolygonLike,
    moving: PolygonLike,
    reference: PointLike = (0, 0),
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    leave_out: LeaveOut = (),
) -> Region:
    """Where moving may go inside the container.

    It is where the point reference, (x, y) and tied to moving, may go with moving inside
    the container. The reference is the origin by default, and is added exactly, before
    rounding. Touching the container is allowed; its holes are solid.

    All of the region is free, its boundary, segments and points too. It can be several
    polygons with holes, segments and points, or have no parts, which is no error. In the
    sources, a is a number of the container and b one of moving.

    Options, exactness and errors are those of no_fit_region, but for these: with
    rounding="outward" the region lies inside the exact one, so that what is placed by it
    never overlaps; a tolerance above 0, and leaving out the holes, which would make
    obstacles free, raise InputError.
    """
    options = rounding, tolerance, threads, progress, leave_out
    container, moving = as_polygon(container, "container"), as_polygon(moving, "moving")
    return _region(
        _ffi.inner_fit_region,
        container,
        moving,
        [_structs.Point(*pair(reference, "reference"))],
        options,
    )


@overload
def minkowski_sum_region_many(
    a: PolygonsLike,
    b: PolygonsLike,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    leave_out: LeaveOut = ...,
    return_errors: Literal[False] = ...,
) -> ResultList[Region]: ...


@overload
def minkowski_sum_region_many(
    a: PolygonsLike,
    b: PolygonsLike,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    leave_out: LeaveOut = ...,
    return_errors: bool,
) -> ResultList[Union[Region, _ffi.Error]]: ...


def minkowski_sum_region_many(
    a: PolygonsLike,
    b: PolygonsLike,
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    leave_out: LeaveOut = (),
    return_errors: bool = False,
) -> Any:
    """Many whole sums in one call: the k-th region is that of a[k] + b[k].

    Each is what minkowski_sum_region gives, whose options these are. For what fails,
    return_errors, and the threads, see minkowski_sum_many.
    """
    return each(
        *(_ffi.minkowski_sum_region_many, Region, {"a": a, "b": b}),
        references=None,
        return_errors=return_errors,
        options=(rounding, tolerance, threads, progress, leave_out),
    )


@overload
def no_fit_region_many(
    fixed: PolygonsLike,
    moving: PolygonsLike,
    references: Optional[Iterable[PointLike]] = ...,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    leave_out: LeaveOut = ...,
    return_errors: Literal[False] = ...,
) -> ResultList[Region]: ...


@overload
def no_fit_region_many(
    fixed: PolygonsLike,
    moving: PolygonsLike,
    references: Optional[Iterable[PointLike]] = ...,
    *,
    rounding: Rounding = ...,
    tolerance: SupportsFloat = ...,
    threads: int = ...,
    progress: Optional[Progress] = ...,
    leave_out: LeaveOut = ...,
    return_errors: bool,
) -> ResultList[Union[Region, _ffi.Error]]: ...


def no_fit_region_many(
    fixed: PolygonsLike,
    moving: PolygonsLike,
    references: Optional[Iterable[PointLike]] = None,
    *,
    rounding: Rounding = "nearest",
    tolerance: SupportsFloat = 0.0,
    threads: int = 1,
    progress: Optional[Progress] = None,
    leave_out: LeaveOut = (),
    return_errors: bool = False,
) -> Any:
    """Many no-fit regions in one call: the k-th is fixed[k] + (-moving[k]) + references[k].

    Each is what no_fit_region gives, whose options these are. For references, what fails,
    return_errors, and the threads, see no_fit_polygon_many.
    """
    return each(
        *(_ffi.no_fit_region_many, Region, {"fixed": fixed, "moving": moving}),
        references=references,
        return_errors=return_errors,
        options=(rounding, tolerance, threads, progress, leave_out),
    )


def _region(
    function: Callable[..., int],
    first: Polygon,
    second: Polygon,
    point: list[Any],
    options: tuple[Any, ...],
) -> Region:
    """What the function gives for two polygons and a point, where it takes one."""
    region = _ffi.Region()
    run(
        lambda known: function(first._handle, second._handle, *point, known, region),
        *(vertex_pairs(first, second), *options),
    )
    return Region(region)

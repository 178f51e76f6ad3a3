# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where a polygon is free in a scene: free_region, best, penetration."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import byref, c_int32
from typing import TYPE_CHECKING, Any, Callable, Optional, SupportsFloat, SupportsIndex, overload

from . import _ffi, _structs
from ._call import LeaveOut, Progress, Rounding, run
from ._contacts import Escape
from ._coordinates import numbers, pair
from ._many import vertices
from ._polygon import Polygon, as_polygon
from ._region import Region
from ._scene_questions import Questions, query_of
from ._sources import PointLike, PolygonLike, Vector, Vectors
from ._whole_numbers import WholeNumbers

if TYPE_CHECKING:
    import numpy
    import numpy.typing


class Places(Questions):
    """The members of a scene, and where another polygon overlaps none of them."""

    __slots__ = ()

    def free_region(
        self,
        moving: PolygonLike,
        window: Optional[Iterable[SupportsFloat]] = None,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        rounding: Rounding = "nearest",
        threads: int = 1,
        progress: Optional[Progress] = None,
        leave_out: LeaveOut = (),
    ) -> Region:
        """Where a polygon is free: where it lies in the container and overlaps no member.

        It may touch them, and they may touch and overlap one another. All of the region is
        free, its boundary, segments and points too. In a segment or a point, the polygon
        fits exactly. The region can have no parts, which is no error.

        window: (xmin, ymin, xmax, ymax), of positions. The answer is then what of the
        region lies in it: polygons are cut, and segments and points in it and on its border
        stay. Where there is no container, there must be a window.

        Region.owners has the id of the member that made each edge, 1 for the container. In
        the sources, a is a number of that member and b one of moving. Edges that the window
        has cut have the owner 0 and the kind 0.

        rounding, leave_out: as in gcv.inner_fit_region. progress: as in
        gcv.minkowski_sum_region.

        Exact as gcv.inner_fit_region. Takes as long as the inner fit of a container with
        all vertices of the members that can be reached.

        The other arguments are those of relation. Raises as Polygon does, and InputError
        for a window, for layers, ignore, and an option, and where there is neither a window
        nor a container.
        """
        polygon, members = as_polygon(moving, "moving"), query_of(layers, ignore)
        bounds, region = _box_or_none(window), _ffi.Region()
        self._search(
            lambda options: _ffi.scene_free_region(
                *(self._handle, polygon._handle, bounds, members, options, byref(region))
            ),
            *(polygon, rounding, threads, progress, leave_out),
        )
        return Region(region)

    def best(
        self,
        moving: PolygonLike,
        direction: PointLike,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
        leave_out: LeaveOut = (),
    ) -> Optional[tuple[float, float]]:
        """The free position that is furthest in a direction; None where nothing is free.

        It is the position of free_region that is furthest; of several, the
        lexicographically smallest. Direction (-1, 0) places bottom-left: leftmost, and of
        these lowest. There must be a container.

        direction: (x, y), of any length but 0. leave_out: "fits" for positions on the
        boundary of the polygons of free_region alone.

        Which position is the furthest is decided exactly. It is returned in floats, and the
        polygon overlaps nothing there: within 2 ulps of the exact one where such a position
        is free, otherwise the nearest one found on the way into what is free around, within
        2^20 ulps of the larger coordinate. An exact fit that no floats within 2 ulps show, as
        between slanted edges, or between decimal fractions, is passed over, and so is a corner
        where what is free is narrower than the gaps between floats, for the corner or fit
        that is furthest else. Where nothing else is free, it is the one nearest to the exact
        position, where relation tells OVERLAPPING.

        Takes as long as the superset edges that reach further; less if one with the same
        vertices was asked for before, and members were only added since. The other arguments
        and the errors are those of free_region, with direction in place of the window.
        """
        polygon, members = as_polygon(moving, "moving"), query_of(layers, ignore)
        towards = _structs.Point(*pair(direction, "direction"))
        position, found = _structs.Point(), c_int32()
        self._search(
            lambda options: _ffi.scene_best(
                *(self._handle, polygon._handle, towards, members, options),
                *(position, byref(found)),
            ),
            *(polygon, "nearest", threads, progress, leave_out),
        )
        x, y = position
        return (x, y) if found.value else None

    @overload
    def penetration(
        self,
        moving: PolygonLike,
        positions: Vector = ...,
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
        leave_out: LeaveOut = ...,
    ) -> Escape: ...

    @overload
    def penetration(
        self,
        moving: PolygonLike,
        positions: Vectors,
        *,
        layers: Optional[SupportsIndex] = ...,
        ignore: WholeNumbers = ...,
        threads: int = ...,
        progress: Optional[Progress] = ...,
        leave_out: LeaveOut = ...,
    ) -> numpy.typing.NDArray[numpy.void]: ...

    def penetration(
        self,
        moving: PolygonLike,
        positions: Any = (0, 0),
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
        leave_out: LeaveOut = (),
    ) -> Any:
        """The shortest way out of all overlaps with members and the container.

        It leads to the nearest free position. One position gives an Escape; its id says
        what is touched there. Many give an array of n of dtype ESCAPE_DTYPE, with that id
        in contact["id_a"]. Without numpy that is a list of Escape. Of several that are
        touched, it is the one with the smallest id. In the contact, a is about it and b
        about moving.

        Where the polygon is free already, the depth is 0. Where nothing is free, the depth
        is infinite, the position is the given one, and there is no contact.

        leave_out: "fits" for ways that do not end in a place that the polygon fits exactly.

        Exact as gcv.penetration. The other arguments and the errors are those of distance.
        """
        return self._answer(
            *(_ffi.scene_penetration, _structs.Escape, moving),
            {"positions": positions},
            query=(layers, ignore),
            options=(threads, progress, leave_out),
            passes_all=True,
        )

    def _search(
        self,
        call: Callable[[Any], object],
        moving: Polygon,
        rounding: Rounding,
        threads: int,
        progress: Optional[Progress],
        leave_out: LeaveOut,
    ) -> None:
        """As run does call(options), while nothing changes."""

        def ask() -> None:
            pairs = vertices(moving) * (self._container_vertices() + self._vertices)
            run(self._kept(call), pairs, rounding, 0, threads, progress, leave_out)

        self._gate.ask(ask)


def _box_or_none(window: Optional[Iterable[SupportsFloat]]) -> Any:
    """The window as the library takes it; None for none."""
    if window is None:
        return None
    return _structs.Box(*numbers(window, 4, "window", window, "four numbers"))

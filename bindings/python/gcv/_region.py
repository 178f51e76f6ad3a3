# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The class of regions.

Whole sums and inner fits: polygons with holes, segments and points, in floats and
exactly, where points lie in them, and what they look like.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any, overload

from . import _ffi, _structs
from ._coordinates import Points, Rings, count, point_or_points, points, split
from ._drawing import plot, svg
from ._facts import (
    EdgeSource,
    Result,
    edge_sources,
    exact_points,
    indices,
    of_area,
    of_elements,
    of_indices,
    of_number,
    of_stats,
    of_text,
    text,
)
from ._locating import (
    ExactPoints,
    Location,
    located_by_library,
    located_in_fractions,
    location,
    locations,
)
from ._parts import (
    PART_POINT,
    PART_SEGMENT,
    RegionPart,
    RegionPolygon,
    by_polygon,
    grouped,
    parts_of,
)
from ._polygon import Polygon
from ._shape import array_of, parts_as_geometry
from ._sources import Vector, Vectors

if TYPE_CHECKING:
    import numpy
    import numpy.typing


class Region(Result):
    """Polygons with holes, segments and points; it never changes.

    Made by minkowski_sum_region, no_fit_region, entrance_region, inner_fit_region, the
    forms of these for many pairs, and Scene.free_region.

    Its parts are rings, segments and points. For each polygon comes its outer ring, then
    its holes; then come the segments, then the points. Outer rings are counter-clockwise,
    holes clockwise, both from their lexicographically smallest vertex, not closed. In a
    segment or a point, one polygon fits the other exactly: it can be there without an
    overlap, but nowhere beside it.

    There are two regions in one. The exact region has fractions for coordinates and is
    canonical: the same set has the same parts. The returned region has floats, which are
    rounded from these, each once. In floats too every ring is simple, no two rings cross,
    and holes lie in their polygon. What floats cannot show is not there;
    stats.parts_dropped counts it. Properties without exact in their name are about the
    returned region.

    len(region) and iteration are those of its polygons. bool(region) is whether it has
    any part. Two regions are equal when both their exact and their returned parts are. A
    pickled region carries all that it can be asked.
    """

    __slots__ = ()

    @property
    def parts(self) -> list[RegionPart]:
        """The parts in the order of their vertices.

        The vertices of a part are vertices[part.start:part.stop].
        """
        return self._list("parts", parts_of).copy()

    @property
    def vertices(self) -> numpy.typing.NDArray[numpy.float64]:
        """The vertices of all parts, part after part.

        An array of shape (n, 2), in input units, that cannot be written to: every access
        looks at the same memory, without a copy. Where numpy is not installed, a list of
        pairs. Segments, points and polygons are in the same form.

        With rounding="nearest" each coordinate is correctly rounded, save those of the
        vertices that stats.vertices_repaired counts. With "outward" a sum contains the
        exact one, an inner-fit region lies inside the exact one, and segments and points
        are exact.
        """
        return array_of(self._doubles)

    @property
    def polygons(self) -> list[RegionPolygon]:
        """The polygons: for each its outer ring and the list of its holes.

        The rings look at the memory of vertices. polygon(k) and iteration give a Polygon.
        """
        return [RegionPolygon(outer, holes) for outer, *holes in self._polygon_arrays()]

    def _polygon_arrays(self) -> list[list[numpy.typing.NDArray[numpy.float64]]]:
        """The rings of each polygon: not to be changed."""
        arrays = self._lists.get("polygons")
        if arrays is None:
            vertices = self.vertices
            arrays = by_polygon(self._list("parts", parts_of), vertices)
            if not isinstance(vertices, list):  # these can be changed
                self._lists["polygons"] = arrays
        return arrays

    @property
    def segments(self) -> numpy.typing.NDArray[numpy.float64]:
        """The segments, an array of shape (n, 2, 2): for each its ends, each an x and a y.

        The ends are in lexicographic order.
        """
        ends = self._vertices_of(PART_SEGMENT)
        if isinstance(ends, list):
            return list(zip(ends[::2], ends[1::2]))
        return ends.reshape(-1, 2, 2)

    @property
    def points(self) -> numpy.typing.NDArray[numpy.float64]:
        """The single points, an array of shape (n, 2)."""
        return self._vertices_of(PART_POINT)

    def _vertices_of(self, kind: int) -> numpy.typing.NDArray[numpy.float64]:
        """The vertices of the parts of one kind, which follow one another."""
        spans = [(part.start, part.stop) for part in self.parts if part.kind == kind]
        return self.vertices[spans[0][0] : spans[-1][1]] if spans else self.vertices[:0]

    @property
    def exact_parts(self) -> list[RegionPart]:
        """The parts of the exact region, whatever the rounding of the floats.

        The vertices of a part are exact[part.start:part.stop]. Rings have no
        collinear vertices and visit no point twice. Segments are maximal, and are cut
        where they meet a ring; points lie on no ring and on no segment. Polygons, holes,
        segments and points are each in lexicographic order. With a tolerance, the region
        is that of the simplified polygons.
        """
        return self._list("exact_parts", parts_of).copy()

    @property
    def exact(self) -> list[tuple[Fraction, Fraction]]:
        """The vertices of all parts of the exact region, part after part."""
        return self._list("exact", exact_points).copy()

    @property
    def exact_indices(self) -> numpy.typing.NDArray[numpy.int64]:
        """For each of vertices, the index in exact of what it stands for.

        sources[exact_indices[k]] is where the edge from vertices[k] on comes from. Of exact
        vertices that fell together, it is the lowest index: the edges between them have
        vanished, and the edge on comes from that of the last of them along the ring. They can
        lie on both sides of the start of the ring. For a vertex that rounding made, it is the
        start of the exact edge that the edge on lies closest to, measured in floats.

        An array of shape (n,) that cannot be written to; a list without numpy.
        """
        return indices(self._fact("exact_indices"))

    @property
    def sources(self) -> list[EdgeSource]:
        """Where each edge of the exact region comes from.

        i is for the edge from exact[i] to the next vertex of its part. The
        second end of a segment and a point have no edge: kind, a and b are 0 there. Where
        several edges of the superset overlap, one of them.
        """
        return self._list("sources", edge_sources).copy()

    @property
    def owners(self) -> numpy.typing.NDArray[numpy.int64]:
        """The id of the member that made each edge of the exact region: one of several.

        1 is the container, 0 a window. Regions of two polygons come from no scene: all
        owners are 0. An array of shape (n,), as sources; a list without numpy.
        """
        return indices(self._fact("owners"))

    @property
    def area(self) -> float:
        """The area of the polygons without their holes, in square units.

        Correctly rounded; 0 for an empty region.

        Raises Error where it is larger than any finite float.
        """
        return float(self._fact("area"))

    @property
    def error_bound(self) -> float:
        """An upper bound on the Hausdorff distance from the exact boundary, in input units.

        The boundary is all rings, segments and points. A part that was dropped counts
        with its extents. Certified and rounded up. It is 0 where every exact coordinate is
        a float. With a tolerance it is a bound between sets, as in OuterFace.
        """
        return float(self._fact("error_bound"))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The smallest box around all parts: (xmin, ymin, xmax, ymax).

        Four NaNs for a region without parts, as in shapely.
        """
        if not self:
            nan = float("nan")
            return nan, nan, nan, nan
        xs, ys = zip(*points(self._doubles))
        return min(xs), min(ys), max(xs), max(ys)

    @property
    def wkt(self) -> str:
        """The polygons as Well-Known Text, which reads back to the same floats.

        Always a MULTIPOLYGON, perhaps an empty one, without the segments and points.
        """
        return str(self._fact("wkt"))

    @property
    def fits_wkt(self) -> str:
        """The segments and points as Well-Known Text.

        Always a GEOMETRYCOLLECTION, of LINESTRING and POINT, perhaps an empty one.
        """
        return str(self._fact("fits_wkt"))

    def polygon(self, number: int) -> Polygon:
        """One polygon with its holes, for the next sum; made at each call.

        number: from 0 to len(region) - 1. The numbers of its vertices begin at 0, in the
        order of its rings.

        Raises InputError where there is no such polygon.
        """
        polygons = self._polygon_rings()
        k = count(number, "polygon")
        if not 0 <= k < len(polygons):
            raise _ffi.InputError(
                _ffi.INVALID_ARGUMENT, f"polygon is {k}, the region has {len(polygons)} polygons"
            )
        return Polygon._of(polygons[k])

    def _polygon_rings(self) -> list[Rings]:
        """The rings of each polygon, as doubles: not to be changed."""

        def rings(doubles: bytes) -> list[Rings]:
            parts = self._list("parts", parts_of)
            return grouped(parts, split(doubles, (part.stop - part.start for part in parts)))

        return self._list("doubles", rings)

    @overload
    def locate(self, points: Vector) -> Location: ...

    @overload
    def locate(self, points: Vectors) -> numpy.typing.NDArray[numpy.int8]: ...

    def locate(self, points: Any) -> Any:
        """Where a point lies in the exact region, or where each of many points lies.

        points: (x, y), or an array or another buffer of shape (n, 2), or a sequence of
        pairs; or a Point of shapely, or a GeoSeries of them. One point gives a Location.
        Many give an array of n int8: INSIDE 1, BOUNDARY 0, OUTSIDE -1; without numpy, a
        list of Location.

        Exact, whatever the rounding. The first call makes an index, and then a point takes
        O(log n) for most regions. In a region that was pickled, each point is compared
        with every edge.

        Raises InputError for what is no point, and for a NaN or an infinity.
        """
        doubles, is_one = point_or_points(points, "points")
        if self._handle:
            located = located_by_library(self._handle, doubles)
        else:
            polygons, fits = self._exact_polygons_and_fits()
            rings = [ring for rings in polygons for ring in rings]
            located = located_in_fractions(doubles, rings, fits)
        return location(located) if is_one else locations(located)

    def _exact_polygons_and_fits(self) -> tuple[list[list[ExactPoints]], list[ExactPoints]]:
        """The rings of each exact polygon, and the exact segments and points."""
        parts, vertices = self.exact_parts, self.exact
        fits = [vertices[part.start : part.stop] for part in parts if part.polygon is None]
        return by_polygon(parts, vertices), fits

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """The region in floats as a geometry.

        A MultiPolygon where there are neither segments nor points; otherwise a
        GeometryCollection of a Polygon, a LineString or a Point for each of its parts.
        """
        return parts_as_geometry(self._ring_points(), self._fit_points())

    def _ring_points(self) -> list[list[Points]]:
        return by_polygon(self.parts, points(self._doubles))

    def _fit_points(self) -> list[Points]:
        vertices = points(self._doubles)
        return [vertices[part.start : part.stop] for part in self.parts if part.polygon is None]

    def shapely(self) -> Any:
        """The geometry of shapely that __geo_interface__ describes.

        Raises ImportError without shapely.
        """
        from shapely.geometry import shape

        return shape(self)

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the region with matplotlib: polygons with empty holes, segments, points.

        ax is the axes to draw on, by default the current ones; style goes to ax.fill.
        Returns the axes. Raises ImportError without matplotlib.
        """
        return plot(self._all_ring_points(), self._fit_points(), ax, style)

    def _repr_svg_(self) -> str:
        return svg([self._all_ring_points()], self._fit_points())

    def _all_ring_points(self) -> list[Points]:
        return [ring for rings in self._ring_points() for ring in rings]

    def __len__(self) -> int:
        """The number of polygons."""
        return len(self._polygon_rings())

    def __bool__(self) -> bool:
        """Whether there is any part."""
        return bool(self._fact("parts"))

    def __iter__(self) -> Iterator[Polygon]:
        """The polygons with their holes."""
        return map(Polygon._of, self._polygon_rings())

    # So that a point in a region is not taken for one of its polygons: locate tells that.
    __contains__ = None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Region):
            return NotImplemented
        names = ("doubles", "parts", "exact", "exact_parts")
        return all(self._fact(name) == other._fact(name) for name in names)

    def __hash__(self) -> int:
        return hash((self._doubles, self._fact("parts")))

    def __copy__(self) -> Region:
        return self

    def __deepcopy__(self, _memo: object) -> Region:
        return self

    def __repr__(self) -> str:
        words = ("", "polygon", "hole", "segment", "point")
        counts = Counter(part.kind for part in self.parts)
        phrases = [f"{n} {words[kind]}{'s' if n > 1 else ''}" for kind, n in sorted(counts.items())]
        return f"<gcv.Region of {', '.join(phrases) or 'no parts'}>"


def _exact(region: _ffi.Region) -> list[str]:
    parts = _ffi.elements(_ffi.region_exact_parts, _structs.RegionPart, region)
    count = sum(part.vertex_count for part in parts)
    return [text(_ffi.region_exact_vertex, region, index) for index in range(count)]


Region._questions = {
    "parts": of_elements(_ffi.region_parts, _structs.RegionPart),
    "doubles": of_elements(_ffi.region_vertices, _structs.Point),
    "exact_parts": of_elements(_ffi.region_exact_parts, _structs.RegionPart),
    "exact": _exact,
    "exact_indices": of_indices(_ffi.region_exact_indices),
    "sources": of_elements(_ffi.region_edge_sources, _structs.EdgeSource),
    "owners": of_indices(_ffi.region_edge_owners),
    "error_bound": of_number(_ffi.region_error_bound),
    "area": of_area(_ffi.region_area),
    "wkt": of_text(_ffi.region_wkt),
    "fits_wkt": of_text(_ffi.region_fits_wkt),
    "stats": of_stats(_ffi.region_stats),
}

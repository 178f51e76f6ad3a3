# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The class of polygons.

How they are made, one by one and many at once, what they tell of themselves, what is
made from them, and what their pickles hold.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable
from ctypes import byref, c_double
from typing import (
    TYPE_CHECKING,
    Any,
    Literal,
    NamedTuple,
    Optional,
    SupportsFloat,
    Union,
    overload,
)

from . import _ffi, _structs
from ._affine import moved, six_numbers
from ._call import Rounding, value_of
from ._coordinates import Rings, check_finite, number, pair, points, size, split
from ._handles import created, mapped, normalised_rings
from ._shape import Shape, array_of
from ._sources import PointLike, PolygonLike, PolygonsLike, read, read_holes

if TYPE_CHECKING:
    import numpy
    import numpy.typing

    from ._result_list import ResultList


class Simplified(NamedTuple):
    """A polygon with fewer vertices, and how far it is from the given one."""

    polygon: Polygon
    error_bound: float
    """At least the Hausdorff distance between the two boundaries, certified."""


class Polygon(Shape):
    """A simple polygon, perhaps with holes; it never changes.

    The source is one of

    - a sequence of (x, y) pairs of numbers, each converted to a float; integers must be
      floats, as all of them up to 2**53 are;
    - an array or another buffer of numbers, of shape (n, 2) and any strides, or of
      floats x0 y0 x1 y1 ...; without masked elements; what only numpy makes an array of
      takes numpy;
    - an object with a __geo_interface__, such as one of shapely, or a GeoJSON
      mapping: a Polygon, a LinearRing, a MultiPolygon of one part, or a Feature, a
      FeatureCollection or a GeometryCollection of one of these;
    - text, as str or bytes: GeoJSON, or Well-Known Text, "POLYGON ((x y, x y, ...))",
      a MULTIPOLYGON of one part, or a GEOMETRYCOLLECTION of one of these;
    - the pathlib.Path of a file of such text;
    - another polygon, an outer face, or a region of one polygon and nothing else.

    Elevations and empty parts of geometries and of text are left out; pairs and arrays must
    have none. Holes are kept; those of the argument holes are added to them, each a ring in one of
    the forms above. A polygon lies inside its outer ring and outside its holes. Rings may
    touch one another in single points, but not cross or overlap; holes lie in the outer
    ring and outside one another. An outer face is that of the outer rings: holes never
    change it. They do change a region.

    Any orientation will do, and the first vertex of a ring may be repeated at its end.
    Every check is exact: coordinates are taken for the numbers that they are. Numbers of
    vertices and edges run through all rings as passed, closing and repeated points
    counted. Two polygons are equal when they are the same set of points.

    Its length, vertices, and numpy.asarray of it are those of the outer ring; rings has
    all. Holes take version 0.2 of the library.

    Raises InputError for a coordinate that is a NaN, an infinity, or an integer that no
    float is, for a polygon without area, for rings that cross or touch where they may
    not, for text that is not a polygon, and for a source that is none of the above;
    OSError for a file that cannot be read.
    """

    __slots__ = ("__weakref__", "_arrays", "_given", "_handle", "_maps", "_rings", "_vertices")

    _given: Rings
    """The rings as passed, which alone know the caller's numbers."""
    _maps: tuple[bytes, ...]
    """The matrices that take these to this polygon, one after the other."""
    _handle: _ffi.Polygon
    _rings: Optional[list[bytes]]
    """The normalised rings, once they were asked for."""
    _arrays: Optional[list[numpy.typing.NDArray[numpy.float64]]]
    """Arrays of them, likewise."""
    _vertices: int
    """How many there are in all rings as passed."""

    def __init__(self, source: PolygonLike, holes: Optional[Iterable[PolygonLike]] = None) -> None:
        added = read_holes(holes) if holes is not None else []
        if isinstance(source, Polygon) and not added:
            self._become(source._given, source._handle, source._maps)
            return
        given, handle = read(source)
        if added:
            given, handle = given + added, None
        self._become(given, handle)

    def _become(
        self, given: Rings, handle: Optional[_ffi.Polygon], maps: tuple[bytes, ...] = ()
    ) -> None:
        self._given, self._handle, self._maps = given, handle or created(given), maps
        self._rings = self._arrays = None
        self._vertices = sum(map(size, given))

    @classmethod
    def _of(
        cls,
        given: Rings,
        handle: Optional[_ffi.Polygon] = None,
        maps: tuple[bytes, ...] = (),
    ) -> Polygon:
        polygon = cls.__new__(cls)
        polygon._become(given, handle, maps)
        return polygon

    @overload
    @classmethod
    def many(
        cls, sources: PolygonsLike, *, return_errors: Literal[False] = ...
    ) -> ResultList[Polygon]: ...

    @overload
    @classmethod
    def many(
        cls, sources: PolygonsLike, *, return_errors: bool
    ) -> ResultList[Union[Polygon, _ffi.Error]]: ...

    @classmethod
    def many(cls, sources: Any, *, return_errors: bool = False) -> Any:
        """Many polygons in one call of the library, such as blocks that turn in every step.

        sources: an array of shape (n, k, 2), for n polygons of k vertices; a GeoSeries or
        an Arrow array, as in minkowski_sum_many; a GeoJSON mapping or an object with a
        __geo_interface__ that has several polygons, such as a FeatureCollection or a
        MultiPolygon; text of several, or the pathlib.Path of a file of it; or anything with
        a source in each place. Segments, points, and missing and empty geometries in
        collections are left out. Those with holes, of text and of collections are made one by one.

        A source that is no polygon leaves the others as they are. With return_errors its
        Error takes the place of the polygon; otherwise the first such Error is raised.
        Each says which source it is about.

        Takes version 0.2 of the library. Raises as Polygon does.
        """
        # Here, for lists of results are made of polygons.
        from ._many_polygons import many_polygons

        return many_polygons(sources, return_errors)

    @classmethod
    def disc(
        cls,
        centre: PointLike,
        radius: SupportsFloat,
        tolerance: SupportsFloat,
        *,
        rounding: Rounding = "nearest",
    ) -> Polygon:
        """A convex polygon in place of a disc: for clearances, as part + disc.

        Every point of its boundary is within the tolerance of the circle, and every
        point of the circle within the tolerance of its boundary; that is certified by
        exact arithmetic. With rounding="outward" the polygon contains the disc. It has
        about 1.6 sqrt(radius / tolerance) vertices, or 2.2 with "outward", up to twice
        as many.

        centre is (x, y); radius and tolerance are in input units. The tolerance must
        leave some units in the last place of the coordinates for their rounding.

        Takes version 0.2 of the library. Raises InputError for a number that is not
        finite, a radius or a tolerance that is not above 0, and a tolerance too small
        for floats; Error where coordinates are near the largest float.
        """
        handle = _ffi.Polygon()
        _ffi.polygon_create_disc(
            *(_structs.Point(*pair(centre, "centre")), number(radius, "radius")),
            *(number(tolerance, "tolerance"), value_of(rounding), byref(handle)),
        )
        return cls._of(normalised_rings(handle, 1))

    @property
    def _ring_doubles(self) -> list[bytes]:
        if self._rings is None:
            self._rings = normalised_rings(self._handle, self.ring_count)
        return self._rings

    @property
    def _doubles(self) -> bytes:
        return self._ring_doubles[0]

    def _numbered(self) -> Rings:
        """The rings as passed; the normalised ones where that takes maps."""
        given, maps = self._with_few_maps()
        return self._ring_doubles if maps else given

    @property
    def ring_count(self) -> int:
        """The number of rings: 1 for the outer one, and 1 for each hole."""
        return len(self._given)

    @property
    def rings(self) -> list[numpy.typing.NDArray[numpy.float64]]:
        """The vertices of every ring, each in the form of vertices.

        First the outer ring, which is counter-clockwise, then the holes in the order
        passed, which are clockwise: the polygon is on the left of all edges. Each begins
        with its lexicographically smallest vertex.

        As in vertices, points are reordered, and some are dropped: the numbers of contacts
        and sources are those of the points as passed, not of these.

        The arrays are made at the first access, and are the same ones at every other.
        """
        if self._arrays is None:
            arrays = [array_of(doubles) for doubles in self._ring_doubles]
            if isinstance(arrays[0], list):
                return arrays  # these can be changed
            self._arrays = arrays
        return self._arrays.copy()

    @property
    def holes(self) -> list[numpy.typing.NDArray[numpy.float64]]:
        """The rings without the outer one."""
        return self.rings[1:]

    @property
    def wkt(self) -> str:
        """All rings as Well-Known Text, which reads back to the same floats.

        Every number has the fewest digits for that.
        """
        rings = (
            ", ".join(f"{digits(x)} {digits(y)}" for x, y in (*ring, ring[0]))
            for ring in self._ring_points()
        )
        return f"POLYGON (({'), ('.join(rings)}))"

    @property
    def area(self) -> float:
        """The area without the holes, in square units, above 0, correctly rounded.

        Raises Error where it is larger than any finite float.
        """
        return float(_ffi.value(_ffi.polygon_area, c_double, self._handle))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The smallest box around the polygon, exact: (xmin, ymin, xmax, ymax)."""
        box = _structs.Box()
        _ffi.polygon_bounds(self._handle, box)
        xmin, ymin, xmax, ymax = box
        return xmin, ymin, xmax, ymax

    def simplified(self, tolerance: SupportsFloat, *, rounding: Rounding = "nearest") -> Simplified:
        """The polygon with fewer vertices, and a bound: polygon, error_bound = ...

        Made once for many sums, in scenes that need no more detail. The new boundary is
        simple, and within the tolerance, in input units, of the given one in Hausdorff
        distance; error_bound says how far it is at most, which is often less. With
        "nearest" the vertices are some of the given ones. With "outward" the new polygon
        contains the given one, and may have new vertices, where edges were lengthened
        until they meet. Holes are simplified likewise; none is lost.

        Its vertices have the numbers that they have in vertices and the rings that
        follow; sums with a tolerance of their own keep the numbers of the given polygons.

        It tells no progress, and nothing cancels it: KeyboardInterrupt comes when it is done,
        which for hundreds of thousands of vertices can take seconds.

        Raises InputError for a tolerance that is negative or not finite.
        """
        handle, bound = _ffi.Polygon(), c_double()
        limit = number(tolerance, "tolerance")
        _ffi.polygon_simplified(
            self._handle, limit, value_of(rounding), byref(handle), byref(bound)
        )
        return Simplified(self._of(normalised_rings(handle, self.ring_count)), bound.value)

    def affine(
        self, matrix: Union[Iterable[SupportsFloat], Iterable[Iterable[SupportsFloat]]]
    ) -> Polygon:
        """The polygon with (x, y) moved to (m00 x + m01 y + m02, m10 x + m11 y + m12).

        matrix: 2 rows of 3 numbers; of 2, where m02 and m12 are 0; 3 rows of 3, the third
        of which is 0, 0, 1; or the 6 numbers of 2 rows in that order, row by row
        (shapely.affinity has another order). [[0, -1], [1, 0]] is a quarter turn.

        Each coordinate is correctly rounded, to nearest, ties to even, from its exact
        value; quarter turns, reflections and scalings by powers of two are exact so.
        Vertices and edges keep their numbers, by a reflection too. A polygon that turns in
        every step is best made from the one at the start each time, for roundings add up.

        Takes version 0.2 of the library. Raises InputError for a number that is not
        finite, and where the map or the roundings leave no polygon; Error where a
        coordinate is not a finite float.
        """
        numbers = six_numbers(matrix)
        given, maps = self._with_few_maps()
        return self._of(given, mapped(self._handle, numbers), (*maps, numbers.tobytes()))

    def _with_few_maps(self) -> tuple[Rings, tuple[bytes, ...]]:
        """Rings and maps that make this polygon, with its numbers.

        There is no map where the rings as passed were moved by one and kept all their
        vertices, so that maps do not pile up.
        """
        if len(self._maps) == 1:
            images = list(map(points, self._ring_doubles))
            given = moved(self._given, array("d", self._maps[0]), images)
            if given is not None:
                return given, ()
        return self._given, self._maps

    def translated(self, vector: PointLike) -> Polygon:
        """The polygon moved by the vector (x, y), each coordinate correctly rounded.

        As affine does it.
        """
        x, y = pair(vector, "vector")
        check_finite("vector", (x, y))
        return self.affine((1, 0, x, 0, 1, y))

    def __neg__(self) -> Polygon:
        """The polygon reflected in the origin, exactly; its vertices keep their numbers."""
        if self._maps:
            return self.affine((-1, 0, 0, 0, -1, 0))
        return self._of([array("d", [-c for c in array("d", r)]).tobytes() for r in self._given])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Polygon):
            return NotImplemented
        (outer, *holes), (other_outer, *other_holes) = self._ring_doubles, other._ring_doubles
        return outer == other_outer and sorted(holes) == sorted(other_holes)

    __hash__ = Shape.__hash__

    def __repr__(self) -> str:
        count = self.ring_count - 1
        holes = f" with {count} hole{'s' if count > 1 else ''}" if count else ""
        return f"<gcv.Polygon of {len(self)} vertices{holes}>"

    def __reduce__(self) -> tuple[Any, ...]:
        state = b"".join(self._given), tuple(map(size, self._given)), self._maps
        if type(self) is Polygon:
            return _polygon_of, state
        return _polygon_of, (*state, type(self)), getattr(self, "__dict__", None)


def as_polygon(source: PolygonLike, name: str) -> Polygon:
    """The polygon that the source is, or that can be made from it.

    Messages call it by that name.
    """
    if isinstance(source, Polygon):
        return source
    try:
        return Polygon(source)
    except _ffi.Error as error:
        raise _ffi.named(error, name) from None


def _polygon_of(
    doubles: bytes,
    sizes: Optional[tuple[int, ...]] = None,
    maps: tuple[bytes, ...] = (),
    kind: type[Polygon] = Polygon,
) -> Polygon:
    """What a pickle holds; those of version 0.1 had no sizes."""
    given = [doubles] if sizes is None else split(doubles, sizes)
    handle = created(given)
    for matrix in maps:
        handle = mapped(handle, array("d", matrix))
    return kind._of(given, handle, maps)


def digits(value: float) -> str:
    """The number with the fewest digits that read back to it."""
    text = repr(value)
    return text[:-2] if text.endswith(".0") else text

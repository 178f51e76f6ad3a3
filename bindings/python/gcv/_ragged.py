# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The rings of many polygons in one array of coordinates, with levels of offsets.

The last level says which vertices each ring has, the one before it which rings each polygon
has. There can be one more, which says what polygons each row has.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate
from typing import TYPE_CHECKING, Any, Union

from ._coordinates import Rings, invalid, size, split, unfit
from ._ffi import Error, InputError
from ._outer_face import OuterFace
from ._polygon import Polygon
from ._region import Region

if TYPE_CHECKING:
    pass

Rows = list[Union[Rings, InputError]]
"""The rings of the polygon of each row, or why it has none."""
_POLYGON, _MULTIPOLYGON = 3, 6
"""Types of geometries in shapely."""


def rows_of_levels(coordinates: Any, levels: Sequence[Any], missing: Any) -> Rows:
    """The rows of an array of shape (n, 2), levels of offsets, and which rows are missing."""
    import numpy

    doubles = numpy.ascontiguousarray(coordinates, "float64").tobytes()
    *multi, polygons, vertices = (level.tolist() for level in levels)
    skipped = vertices[0] if vertices else 0
    sizes = [stop - start for start, stop in zip(vertices, vertices[1:])]
    rings = split(doubles[16 * skipped :], sizes)
    starts = multi[0] if multi else range(len(missing) + 1)

    def row(gone: bool, start: int, stop: int) -> Union[Rings, InputError]:
        if gone:
            return absent()
        parts = [rings[polygons[k] : polygons[k + 1]] for k in range(start, stop)]
        parts = list(filter(any, parts)) or parts[:1]
        if len(parts) != 1:
            return invalid(f"a MultiPolygon of {len(parts)} parts is not one polygon")
        return parts[0] or [b""]

    return list(map(row, missing.tolist(), starts, starts[1:]))


def absent() -> InputError:
    """Why a row has no polygon where there is nothing in it."""
    return unfit("polygon", None, "a polygon, and none can be made from it")


def rows_of_geometries(geometries: Any) -> Rows:
    """The rows of an array of geometries of shapely."""
    import numpy
    import shapely

    kinds = shapely.get_type_id(geometries)
    fit = numpy.isin(kinds, (_POLYGON, _MULTIPOLYGON))
    found: Iterator[Union[Rings, InputError]] = iter(())
    if fit.any():
        _, coordinates, offsets = shapely.to_ragged_array(geometries[fit], include_z=False)
        found = iter(rows_of_levels(coordinates, offsets[::-1], numpy.zeros(fit.sum(), bool)))

    def row(geometry: Any, is_fit: bool) -> Union[Rings, InputError]:
        if is_fit:
            return next(found)
        if geometry is None:
            return absent()
        return invalid(f"a geometry of type {geometry.geom_type!r} is not a polygon")

    return list(map(row, geometries, fit.tolist()))


def levels_of(
    shapes: Sequence[Union[Polygon, OuterFace, Region, Error]], *, multi: bool
) -> tuple[bytes, list[Any]]:
    """The doubles of all closed rings, and levels of offsets; errors have no rings.

    multi is whether rows have several polygons: all are regions then.
    """
    import numpy

    rows = [_polygons(shape) for shape in shapes]
    polygons = [polygon for row in rows for polygon in row]
    if not multi:
        polygons = [row[0] if row else [] for row in rows]
    closed = [ring + ring[:16] for polygon in polygons for ring in polygon]
    counts = [map(len, polygons), map(size, closed)]
    if multi:
        counts.insert(0, map(len, rows))
    levels = [numpy.fromiter(accumulate(of, initial=0), "int64") for of in counts]
    return b"".join(closed), levels


def _polygons(shape: Union[Polygon, OuterFace, Region, Error]) -> list[Rings]:
    """The rings of each polygon of a shape."""
    if isinstance(shape, Error):
        return []
    return shape._polygon_rings() if isinstance(shape, Region) else [shape._ring_doubles]


def geometries_of(shapes: Sequence[Any], *, multi: bool) -> Any:
    """An array of geometries of shapely, with None for errors."""
    import numpy
    import shapely

    geometries = numpy.full(len(shapes), None, object)
    there = [k for k, shape in enumerate(shapes) if not isinstance(shape, Error)]
    doubles, levels = levels_of([shapes[k] for k in there], multi=multi)
    geometries[there] = shapely.from_ragged_array(
        shapely.GeometryType(_MULTIPOLYGON if multi else _POLYGON),
        numpy.frombuffer(doubles).reshape(-1, 2),
        tuple(levels[::-1]),
    )
    return geometries

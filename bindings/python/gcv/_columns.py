# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reading polygons from columns: of GeoPandas, and of Arrow in the manner of GeoArrow."""

from __future__ import annotations

import json
import sys
from typing import Any, NamedTuple, Optional, Union

from ._arrow import arrow_column
from ._ffi import INVALID_ARGUMENT, Error, InputError, named
from ._handles import created_many
from ._polygon import Polygon
from ._ragged import Rows, rows_of_geometries


class Origin(NamedTuple):
    """What a column has beside polygons, and what is made from these keeps."""

    labels: Any = None
    """Those of the rows, an index of pandas."""
    crs: Any = None
    """The coordinate reference system: of pyproj, or as the metadata of GeoArrow has it."""

    def label(self, row: int) -> str:
        """What messages say of a row beside its number: its label where it has another one."""
        label = row if self.labels is None else self.labels[row : row + 1].tolist()[0]
        return "" if label == row else f", index {label!r}"


NO_ORIGIN = Origin()


class Column(NamedTuple):
    """Polygons of a column, and errors where a row has none."""

    polygons: list[Union[Polygon, Error]]
    origin: Origin


def column_of(source: Any, name: str, row_name: str = "") -> Optional[Column]:
    """The polygons of a column; None for other sources.

    Messages call it by that name, and its rows by row_name with their number in it, which
    is "name[{}]" by default.
    """
    if isinstance(source, list):
        return None
    series = _geoseries(source)
    if series is not None:
        index = getattr(source, "index", None)
        rows, origin = rows_of_geometries(series.to_numpy()), Origin(index, series.crs)
    else:
        try:
            arrow = arrow_column(source)
        except Error as error:
            raise named(error, name) from None
        if arrow is None:
            return None
        rows, origin = arrow[0], Origin(None, arrow[1])
    return Column(_polygons(rows, origin, row_name or f"{name}[{{}}]"), origin)


def _geoseries(source: Any) -> Any:
    """The GeoSeries that a source is or has; None where it is nothing of GeoPandas."""
    geopandas = sys.modules.get("geopandas")
    if geopandas is None:
        return None
    if isinstance(source, geopandas.GeoDataFrame):
        return source.geometry
    if isinstance(source, geopandas.array.GeometryArray):
        return geopandas.GeoSeries(source)
    return source if isinstance(source, geopandas.GeoSeries) else None


def _polygons(rows: Rows, origin: Origin, name: str) -> list[Union[Polygon, Error]]:
    """The polygons, those of one ring in one call of the library."""
    single = {
        k: rings[0] for k, rings in enumerate(rows) if isinstance(rings, list) and len(rings) == 1
    }
    handles = dict(zip(single, created_many(list(single.values()))))
    results: list[Union[Polygon, Error]] = []
    for k, rings in enumerate(rows):
        try:
            if isinstance(rings, Error):
                raise rings
            # Where there is no handle, this says why.
            results.append(Polygon._of(rings, handles.get(k)))
        except Error as error:
            results.append(named(error, name.format(k) + origin.label(k)))
    return results


def without_errors(results: list[Any]) -> list[Any]:
    """The results, the first error of which is raised."""
    for result in results:
        if isinstance(result, Error):
            raise result
    return results


def origin_of(source: Any, column: Optional[Column]) -> Origin:
    """What results keep of a source, which may be a list of results itself."""
    origin: Origin = column.origin if column else getattr(source, "_origin", NO_ORIGIN)
    return origin


def common_origin(origins: dict[str, Origin]) -> Origin:
    """What sources have in common, by their names.

    Raises InputError where their rows or their coordinates do not belong together.
    """
    labels = {name: of.labels for name, of in origins.items() if of.labels is not None}
    systems = {name: of.crs for name, of in origins.items() if of.crs is not None}
    if len(labels) > 1:
        one, other = labels.values()
        if not one.equals(other):
            raise _different(labels, "indexes: align them, or pass the values of one of them")
    if len(systems) > 1:
        one, other = map(_comparable, systems.values())
        if one != other:
            raise _different(systems, "coordinate reference systems: transform one of them")
    return Origin(*(next(iter(known.values()), None) for known in (labels, systems)))


def _different(known: dict[str, Any], what: str) -> InputError:
    return InputError(INVALID_ARGUMENT, f"{' and '.join(known)} have different {what}")


def _comparable(crs: Any) -> Any:
    """A coordinate reference system that can be compared."""
    try:
        from pyproj import CRS
    except ImportError:
        return json.dumps(crs, sort_keys=True, default=str)
    return CRS.from_user_input(crs)

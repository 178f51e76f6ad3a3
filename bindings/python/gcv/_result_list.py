# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The class of what functions for many polygons give."""

from __future__ import annotations

from collections.abc import Iterable
from operator import is_
from typing import TYPE_CHECKING, Any, TypeVar

from ._arrow import exported
from ._columns import NO_ORIGIN, Origin
from ._ragged import geometries_of

if TYPE_CHECKING:
    import geopandas

_T = TypeVar("_T")


class ResultList(list[_T]):
    """A list of polygons, outer faces or regions, which is a column too.

    Made by Polygon.many, and by the functions for many pairs. Where polygons came in a
    GeoSeries or an Arrow array, it has the index and the coordinate reference system that
    they had.

    It is an Arrow array for whoever asks by the PyCapsule interface, such as
    pyarrow.array(results) or geopandas.GeoSeries.from_arrow(results): one of geoarrow.polygon,
    for regions of geoarrow.multipolygon, with null for errors. That takes pyarrow.

    Segments and points of regions are in none of these columns; Region.shapely has them.
    Slices, sorted copies and sums of it are plain lists. Once it was changed in place, such as
    by sort or append, it has no index and no reference system either: they are of the rows as
    they were made.
    """

    def __init__(
        self, results: Iterable[_T] = (), origin: Origin = NO_ORIGIN, *, of_regions: bool = False
    ) -> None:
        super().__init__(results)
        self._made = tuple(self), origin
        self._of_regions = of_regions

    @property
    def _origin(self) -> Origin:
        """What the rows came with; nothing where they are not those that were made."""
        rows, origin = self._made
        same = len(self) == len(rows) and all(map(is_, self, rows))
        return origin if same else NO_ORIGIN

    @property
    def labels(self) -> Any:
        """The index of the rows, one of pandas.

        None where no GeoSeries was given, or the list was changed in place.
        """
        return self._origin.labels

    @property
    def crs(self) -> Any:
        """The coordinate reference system as it was given: of pyproj, or as GeoArrow has it.

        None where there was none, or the list was changed in place.
        """
        return self._origin.crs

    def to_geoseries(self) -> geopandas.GeoSeries:
        """The shapes in floats as a GeoSeries, with the index and the reference system.

        Regions are Multi-Polygons; errors are missing geometries. Raises ImportError without
        GeoPandas.
        """
        import geopandas

        geometries = geometries_of(self, multi=self._of_regions)
        return geopandas.GeoSeries(geometries, index=self.labels, crs=self.crs)

    def __arrow_c_array__(self, requested_schema: object = None) -> tuple[object, object]:
        """Capsules with the schema and the array of a GeoArrow column."""
        return exported(list[Any](self), self.crs, multi=self._of_regions)

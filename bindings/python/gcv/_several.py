# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""One polygon or a sequence of them, whichever a source is."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sized
from pathlib import Path
from typing import Any, Union

from ._columns import column_of, without_errors
from ._coordinates import is_array
from ._polygon import Polygon, as_polygon
from ._shape import Shape
from ._sources import PolygonLike, iterable

Polygons = Union[PolygonLike, Iterable[PolygonLike]]
"""What one polygon can be made from, or a sequence of it."""


def polygons_of(source: Any, name: str) -> tuple[list[Polygon], bool]:
    """The polygons of a source, and whether it is one polygon.

    Messages call them by that name. A sequence is one polygon where its first element is a
    vertex: a pair of numbers. A GeoSeries or an Arrow array is a sequence.
    """
    column = column_of(source, name)
    if column is not None:
        return without_errors(column.polygons), False
    if _is_one(source):
        return [as_polygon(source, name)], True
    sources = tuple(iterable(source, name, "a polygon, nor a sequence of polygons"))
    if sources and _is_vertex(sources[0]):
        return [as_polygon(sources, name)], True
    return [as_polygon(one, f"{name}[{k}]") for k, one in enumerate(sources)], False


def _is_one(source: Any) -> bool:
    if isinstance(source, (Shape, str, bytes, bytearray, Path, Mapping)):
        return True
    is_only_array = is_array(source) and not isinstance(source, Iterable)
    return hasattr(source, "__geo_interface__") or is_only_array or _is_flat(source)


def _is_flat(source: Any) -> bool:
    """Whether the source is a buffer of numbers with one or two indices."""
    try:
        view = memoryview(source)
    except (TypeError, ValueError):
        return False
    return view.ndim <= 2 and view.format != "O"


def _is_vertex(source: Any) -> bool:
    """Whether the source is a pair of what are no sequences: of numbers, if all is well."""
    if isinstance(source, (str, bytes, Mapping)) or not isinstance(source, Collection):
        return False
    return len(source) == 2 and not any(isinstance(number, Sized) for number in source)

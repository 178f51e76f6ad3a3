# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Many polygons in one call of the library."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Union

from . import _ffi
from ._collections import collection_of
from ._columns import column_of, origin_of, without_errors
from ._coordinates import rings_of_many
from ._handles import created_many
from ._polygon import Polygon
from ._result_list import ResultList
from ._sources import iterable, read


def many_polygons(sources: Any, return_errors: bool) -> ResultList[Any]:
    """The polygons of sources, or their errors in their places."""
    file = f"{sources}: ".replace("{", "{{").replace("}", "}}") if isinstance(sources, Path) else ""
    names = "sources", file + "polygon {}"
    column = column_of(sources, *names) or collection_of(sources, *names)
    results = _polygons(sources) if column is None else column.polygons
    origin = origin_of(sources, column)
    return ResultList(results if return_errors else without_errors(results), origin)


def _polygons(sources: Any) -> list[Any]:
    results: list[Any] = list(rings_of_many(sources) or ())
    if not results:
        results += [
            _ring_or_polygon(source, k) for k, source in enumerate(iterable(sources, "sources"))
        ]
    single = [(k, ring) for k, ring in enumerate(results) if isinstance(ring, bytes)]
    handles = created_many([ring for _, ring in single])
    for (k, ring), handle in zip(single, handles):
        try:
            # Where there is no handle, this says why.
            results[k] = Polygon._of([ring], handle)
        except _ffi.Error as error:
            results[k] = _ffi.named(error, f"polygon {k}")
    return results


def _ring_or_polygon(source: Any, index: int) -> Union[bytes, Polygon, _ffi.Error]:
    """The one ring of a source, the polygon where it is one or has holes, or its error."""
    if isinstance(source, Polygon):
        return source
    try:
        rings, handle = read(source)
        if handle is None and len(rings) == 1:
            return rings[0]
        return Polygon._of(rings, handle)
    except _ffi.Error as error:
        return _ffi.named(error, f"polygon {index}")

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Many pairs of polygons in one call of the library."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import c_double, c_int32, c_void_p
from typing import Any, Callable, NamedTuple, Optional, Union

from . import _ffi
from ._call import run
from ._collections import collection_of
from ._columns import Origin, column_of, common_origin, origin_of, without_errors
from ._coordinates import pair
from ._outer_face import OuterFace
from ._polygon import Polygon, as_polygon
from ._region import Region
from ._result_list import ResultList
from ._sources import PointLike, PolygonsLike, iterable

_HANDLES = {OuterFace: _ffi.OuterFace, Region: _ffi.Region}


class _Pair(NamedTuple):
    number: int
    first: Polygon
    second: Polygon
    reference: tuple[float, float]


def each(
    function: Callable[..., int],
    kind: Union[type[OuterFace], type[Region]],
    sources: dict[str, PolygonsLike],
    *,
    references: Optional[Iterable[PointLike]],
    return_errors: bool,
    options: tuple[Any, ...],
) -> ResultList[Any]:
    """What the function gives for each pair: results of that kind, or errors.

    sources are the first and the second polygons by the names of the arguments. The
    options are those of run.
    """
    results, pairs, origin = _read(sources, references, return_errors)
    count = len(pairs)
    handles, statuses = (c_void_p * count)(), (c_int32 * count)()
    arguments = [handle_array([p.first for p in pairs]), handle_array([p.second for p in pairs])]
    if "fixed" in sources:
        arguments.append((c_double * (2 * count))(*(c for p in pairs for c in p.reference)))

    def call(known: Any) -> str:
        function(*arguments, count, known, handles, statuses)
        return _ffi.last_error_message()

    try:
        message = run(call, sum(vertex_pairs(p.first, p.second) for p in pairs), *options)
    finally:
        owned = [kind(_HANDLES[kind](handle)) for handle in handles]
    for tried, (one, result, status) in enumerate(zip(pairs, owned, statuses)):
        results[one.number] = result
        if status != 0:
            name = f"pair {one.number}{origin.label(one.number)}"
            reason = message.replace(f"pair {tried}:", f"{name}:", 1)
            error = _ffi.error(status, reason or f"{name} alone says why it fails")
            if not return_errors:
                raise error
            results[one.number] = error
            message = ""
    return ResultList(results, origin, of_regions=kind is Region)


def _read(
    sources: dict[str, PolygonsLike],
    references: Optional[Iterable[PointLike]],
    return_errors: bool,
) -> tuple[list[Any], list[_Pair], Origin]:
    """Room for the results with the errors of sources in it, and the pairs without one.

    And what the results keep of columns.
    """

    def read(function: Callable[[Any, str], Any], value: Any, name: str) -> Any:
        try:
            return function(value, name)
        except _ffi.Error as error:
            if not return_errors:
                raise
            return error

    columns = {
        name: column_of(some, name) or collection_of(some, name) for name, some in sources.items()
    }

    def polygons(name: str, some: PolygonsLike) -> list[Any]:
        column = columns[name]
        if column is None:
            return [read(as_polygon, p, f"{name}[{k}]") for k, p in enumerate(iterable(some, name))]
        return column.polygons if return_errors else without_errors(column.polygons)

    (a, first), (b, second) = ((name, polygons(name, some)) for name, some in sources.items())
    if len(first) != len(second):
        raise _ffi.InputError(
            _ffi.INVALID_ARGUMENT, f"{a} has {len(first)} polygons, {b} has {len(second)}"
        )
    points: list[Any] = [(0.0, 0.0)] * len(first)
    if references is not None:
        given = iterable(references, "references", "a sequence of pairs of numbers")
        points = [read(pair, point, f"references[{k}]") for k, point in enumerate(given)]
    if len(points) != len(first):
        raise _ffi.InputError(
            _ffi.INVALID_ARGUMENT,
            f"{a} has {len(first)} polygons, references has {len(points)} points",
        )
    results: list[Any] = [None] * len(first)
    pairs = []
    for k, found in enumerate(zip(first, second, points)):
        errors = [error for error in found if isinstance(error, _ffi.Error)]
        if errors:
            results[k] = errors[0]
        else:
            pairs.append(_Pair(k, *found))
    origins = {name: origin_of(some, columns[name]) for name, some in sources.items()}
    return results, pairs, common_origin(origins)


def vertex_pairs(a: Polygon, b: Polygon) -> int:
    """The number of pairs of a vertex of a and one of b."""
    return vertices(a) * vertices(b)


def vertices(polygon: Polygon) -> int:
    """The number of vertices of all rings as passed."""
    return polygon._vertices


def handle_array(polygons: list[Polygon]) -> Any:
    return (c_void_p * len(polygons))(*(polygon._handle.value for polygon in polygons))

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The rings of geometries, which are GeoJSON or have a __geo_interface__, and of pairs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ._coordinates import (
    Rings,
    doubles_of_pairs,
    elements_of,
    invalid,
    short,
    vertex_name,
)
from ._ffi import InputError

_LISTS = (list, tuple)


def rings_of(source: Any) -> Rings:
    """The rings of a geometry, or of a sequence of pairs.

    Raises InputError for anything else.
    """
    geometry = getattr(source, "__geo_interface__", source)
    if isinstance(geometry, Mapping):
        rings = _rings_of_geometry(geometry)
        return [_from_pairs(ring, k, elevations=True) for k, ring in enumerate(rings)]
    if hasattr(source, "read"):
        raise invalid("an open file is no polygon; pass what it says, or its pathlib.Path")
    try:
        return [_from_pairs(source)]
    except InputError as error:
        if isinstance(source, _LISTS) and _is_ring(source[0]):
            raise InputError(error.status, f"{error}: it is a ring; pass holes as holes") from None
        raise


def _is_ring(value: Any) -> bool:
    return isinstance(value, _LISTS) and any(isinstance(p, _LISTS) for p in value)


def _from_pairs(source: Iterable[Any], ring: int = 0, *, elevations: bool = False) -> bytes:
    vertices = elements_of(source, "polygon", "a polygon, and none can be made from it")
    doubles = doubles_of_pairs(vertices, lambda k: vertex_name(k, ring), elevations=elevations)
    return doubles.tobytes()


def _rings_of_geometry(geometry: Any) -> Sequence[Any]:
    """The rings of a GeoJSON object."""
    kind = _kind(geometry)
    outer: dict[int, Any] = {}  # with what has these ids, which others could take else
    while kind in ("Feature", "FeatureCollection", "GeometryCollection"):
        if id(geometry) in outer:
            raise invalid(f"a {kind} that is in itself is not a polygon")
        outer[id(geometry)] = geometry
        if kind == "Feature":
            geometry = geometry.get("geometry")
        elif kind == "FeatureCollection":
            geometry = _only(_member(geometry, "features"), kind)
        else:
            geometry = _only_geometry(_member(geometry, "geometries"))
        kind = _kind(geometry)
    if kind == "MultiPolygon":
        parts = _sequence(_member(geometry, "coordinates"))
        return _sequence(_only([rings for rings in parts if not is_empty(rings)], kind))
    if kind == "LinearRing":
        return [_sequence(_member(geometry, "coordinates"))]
    if kind == "Polygon":
        return _sequence(_member(geometry, "coordinates")) or [()]
    if kind is None:
        raise invalid(f"{short(geometry)} is not a geometry")
    raise invalid(f"a geometry of type {kind!r} is not a polygon")


def _kind(geometry: Any) -> Any:
    return geometry.get("type") if isinstance(geometry, Mapping) else None


def _member(geometry: Mapping[str, Any], name: str) -> Any:
    if name not in geometry:
        raise invalid(f"a {_kind(geometry)} without {name} is not a polygon")
    return geometry[name]


def _only_geometry(parts: Any) -> Any:
    parts = _sequence(parts)
    if len(parts) != 1:
        raise not_one_geometry([str(_kind(part)) for part in parts])
    return parts[0]


def not_one_geometry(kinds: list[str]) -> InputError:
    """The error for a collection of geometries of these kinds."""
    counts = Counter(kinds).items()
    found = ", ".join(f"{count} {kind}" for kind, count in counts) or "nothing"
    hint = "; Polygon.many reads its polygons" if len(kinds) > 1 else ""
    return invalid(f"a GeometryCollection of {found} is not one polygon{hint}")


def is_empty(rings: Any) -> bool:
    """Whether the coordinates of a polygon in GeoJSON have no vertex."""
    return isinstance(rings, _LISTS) and all(
        isinstance(ring, _LISTS) and not ring for ring in rings
    )


def _only(parts: Any, kind: str) -> Any:
    parts = _sequence(parts)
    if len(parts) != 1:
        raise invalid(f"a {kind} of {len(parts)} parts is not one polygon")
    return parts[0]


def _sequence(value: Any) -> Sequence[Any]:
    if not isinstance(value, Sequence) or isinstance(value, str):
        raise invalid(f"{short(value)} in a geometry is not a list")
    return value

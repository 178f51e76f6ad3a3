# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Polygons of the library.

How it makes them, from rings, from Well-Known Text, or from another one by an affine
map, and how their normalised rings are read back. What owns them is _ffi.Polygon.
"""

from __future__ import annotations

from array import array
from ctypes import byref, c_int32, c_size_t, c_void_p
from typing import Any

from . import _ffi, _structs
from ._coordinates import Rings, size
from ._texts import rings_of_wkt


def created(rings: Rings) -> _ffi.Polygon:
    handle = _ffi.Polygon()
    if len(rings) == 1:
        (ring,) = rings
        _ffi.polygon_create(ring, size(ring), 0, byref(handle))
    else:
        _ffi.polygon_create_rings(b"".join(rings), _sizes(rings), len(rings), 0, byref(handle))
    return handle


def created_of_wkt(text: bytes) -> tuple[Rings, _ffi.Polygon]:
    """The rings of the text too, which the library does not tell as they were passed."""
    handle = _ffi.Polygon()
    _ffi.polygon_create_wkt(text, len(text), byref(handle))
    rings = rings_of_wkt(text)
    if len(rings) > 1:
        # Raises with version 0.1 of the library, which left the holes out.
        _ffi.value(_ffi.polygon_ring_count, c_size_t, handle)
    return rings, handle


def _sizes(rings: list[bytes]) -> Any:
    return (c_size_t * len(rings))(*map(size, rings))


def created_many(rings: list[bytes]) -> list[_ffi.Polygon]:
    """The handles of polygons of one ring each; handles of nothing for those that are none."""
    count = len(rings)
    handles, statuses = (c_void_p * count)(), (c_int32 * count)()
    try:
        _ffi.polygon_create_many(b"".join(rings), _sizes(rings), count, 0, handles, statuses)
    finally:
        owned = [_ffi.Polygon(handle) for handle in handles]
    return owned


def mapped(handle: _ffi.Polygon, matrix: array[float]) -> _ffi.Polygon:
    image = _ffi.Polygon()
    _ffi.polygon_affine(handle, _structs.Matrix(*matrix), byref(image))
    return image


def normalised_rings(polygon: _ffi.Polygon, count: int) -> list[bytes]:
    """The coordinates of its normalised rings, which are so many."""
    if count == 1:
        return [bytes(_ffi.elements(_ffi.polygon_vertices, _structs.Point, polygon))]
    return [
        bytes(_ffi.elements(_ffi.polygon_ring, _structs.Point, polygon, k)) for k in range(count)
    ]

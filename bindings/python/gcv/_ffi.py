# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The functions of gcv.h, each without its prefix, raising where it fails."""

from __future__ import annotations

from ctypes import (
    POINTER,
    Array,
    Structure,
    byref,
    c_char_p,
    c_double,
    c_int32,
    c_size_t,
    c_uint32,
    c_void_p,
)
from typing import Any, Callable, ClassVar, NoReturn

from ._loader import load

_lib = load()

version_string = _lib.gcv_version_string
version_string.argtypes = ()
version_string.restype = c_char_p

_status_name = _lib.gcv_status_name
_status_name.argtypes = (c_int32,)
_status_name.restype = c_char_p

_last_error_message = _lib.gcv_last_error_message
_last_error_message.argtypes = ()
_last_error_message.restype = c_char_p


class Error(Exception):
    """A call of libgcv that failed; the text says why.

    status is the gcv_status, a number that stays the same in all versions.
    """

    __module__ = "gcv"

    def __init__(self, status: int, message: str) -> None:
        super().__init__(status, message)
        self.status = status

    @property
    def status_name(self) -> str:
        """The name of the status, such as "GCV_ERR_NOT_SIMPLE"."""
        name: bytes = _status_name(self.status)
        return name.decode()

    def __str__(self) -> str:
        return str(self.args[1])


class InputError(Error, ValueError):
    """A failure that the input is to blame for: no polygon, or not finite."""

    __module__ = "gcv"


_INPUT_STATUSES = {
    2,  # GCV_ERR_INVALID_ARGUMENT
    3,  # GCV_ERR_NOT_FINITE
    4,  # GCV_ERR_DEGENERATE
    5,  # GCV_ERR_NOT_SIMPLE
    8,  # GCV_ERR_PARSE
}


def _check(status: int, _function: object, _arguments: object) -> int:
    if status != 0:
        message = _last_error_message().decode(errors="replace")
        raise (InputError if status in _INPUT_STATUSES else Error)(status, message)
    return status


class _Handle(c_void_p):
    """Owns an object of the library: ends it together with itself."""

    _destroy: ClassVar[Any]

    def __del__(self) -> None:
        self._destroy(self)

    def __reduce__(self) -> NoReturn:
        raise TypeError("objects of libgcv cannot be pickled, nor copied in depth")


def _destroyer(name: str) -> Any:
    function = getattr(_lib, name)
    function.argtypes = (c_void_p,)
    function.restype = None
    return function


class Polygon(_Handle):
    _destroy = _destroyer("gcv_polygon_destroy")


class OuterFace(_Handle):
    _destroy = _destroyer("gcv_outer_face_destroy")


class Superset(_Handle):
    _destroy = _destroyer("gcv_superset_destroy")


Point = c_double * 2
Box = c_double * 4


class EdgeSource(Structure):
    _fields_ = (("kind", c_int32), ("a", c_uint32), ("b", c_uint32))


class SupersetEdge(Structure):
    _fields_ = (
        ("x0", c_double),
        ("y0", c_double),
        ("x1", c_double),
        ("y1", c_double),
        ("source", EdgeSource),
    )


def _function(name: str, *argtypes: Any) -> Any:
    function = getattr(_lib, name)
    function.argtypes = argtypes
    function.restype = c_int32
    function.errcheck = _check
    return function


_double = POINTER(c_double)
_size = POINTER(c_size_t)
_buffer = (c_void_p, c_size_t, _size)
_polygon = POINTER(Polygon)
_face = POINTER(OuterFace)
_options = c_void_p

polygon_create = _function("gcv_polygon_create", c_void_p, c_size_t, c_size_t, _polygon)
polygon_create_wkt = _function("gcv_polygon_create_wkt", c_char_p, c_size_t, _polygon)
polygon_vertex_count = _function("gcv_polygon_vertex_count", Polygon, _size)
polygon_vertices = _function("gcv_polygon_vertices", Polygon, *_buffer)
polygon_area = _function("gcv_polygon_area", Polygon, _double)
polygon_bounds = _function("gcv_polygon_bounds", Polygon, _double)

minkowski_sum = _function("gcv_minkowski_sum", Polygon, Polygon, _options, _face)
no_fit_polygon = _function("gcv_no_fit_polygon", Polygon, Polygon, _double, _options, _face)
entrance_block = _function("gcv_entrance_block", Polygon, Polygon, _double, _options, _face)

outer_face_vertex_count = _function("gcv_outer_face_vertex_count", OuterFace, _size)
outer_face_vertices = _function("gcv_outer_face_vertices", OuterFace, *_buffer)
outer_face_exact_vertex_count = _function("gcv_outer_face_exact_vertex_count", OuterFace, _size)
outer_face_exact_vertex = _function("gcv_outer_face_exact_vertex", OuterFace, c_size_t, *_buffer)
outer_face_edge_sources = _function("gcv_outer_face_edge_sources", OuterFace, *_buffer)
outer_face_error_bound = _function("gcv_outer_face_error_bound", OuterFace, _double)
outer_face_area = _function("gcv_outer_face_area", OuterFace, _double)
outer_face_wkt = _function("gcv_outer_face_wkt", OuterFace, *_buffer)
outer_face_polygon = _function("gcv_outer_face_polygon", OuterFace, _polygon)

superset_create = _function("gcv_superset_create", Polygon, Polygon, POINTER(Superset))
superset_edges = _function("gcv_superset_edges", Superset, *_buffer)


def value(function: Callable[..., int], kind: Any, handle: _Handle) -> Any:
    """What a function with one output of the given ctypes type gives."""
    out = kind()
    function(handle, byref(out))
    return out.value


def elements(function: Callable[..., int], kind: Any, *arguments: Any) -> Array[Any]:
    """What a buffer function gives, as elements of the given ctypes type."""
    count = c_size_t()
    function(*arguments, None, 0, byref(count))
    out: Array[Any] = (kind * count.value)()
    function(*arguments, out, count.value, byref(count))
    return out

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The functions of gcv.h, without their prefix and raising where they fail."""

from __future__ import annotations

from ctypes import (
    POINTER,
    Array,
    byref,
    c_char_p,
    c_double,
    c_int8,
    c_int32,
    c_size_t,
    c_uint32,
    c_uint64,
    c_void_p,
)
from functools import partial
from typing import Any, Callable, NoReturn

from ._loader import load
from ._structs import Options, Query, Stats
from ._versions import NEW_IN_0_2

_library = load()

FUNCTIONS: dict[str, Any] = {}
"""Every function of the library that is declared here, by its name in C."""


def _declare(name: str, restype: Any, *argtypes: Any) -> Any:
    if name in NEW_IN_0_2 and not hasattr(_library, name):
        return _Missing(name)
    function = getattr(_library, name)
    function.argtypes = argtypes
    function.restype = restype
    FUNCTIONS[name] = function
    return function


class _Missing:
    """In place of a function that the library does not have, for it is too old."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __call__(self, *_arguments: object) -> NoReturn:
        version: bytes = version_string()
        raise NotImplementedError(
            f"{self.name} came with libgcv 0.2; the library that is running is {version.decode()}"
        )


# ----------------------------------------------------------------- status --

INVALID_ARGUMENT = 2
NOT_FINITE = 3
PARSE = 8
ROUNDINGS = {"nearest": 0, "outward": 1}
LEAVE_OUTS = {"holes": 1, "fits": 2}
NO_POLYGON = 2**32 - 1

version_number = _declare("gcv_version_number", c_uint32)
version_string = _declare("gcv_version_string", c_char_p)
_status_name = _declare("gcv_status_name", c_char_p, c_int32)
_last_error_message = _declare("gcv_last_error_message", c_char_p)


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


class OutOfMemoryError(Error, MemoryError):
    """A failure for want of memory."""

    __module__ = "gcv"


_KINDS: dict[int, type[Error]] = {
    INVALID_ARGUMENT: InputError,
    NOT_FINITE: InputError,
    4: InputError,  # GCV_ERR_DEGENERATE
    5: InputError,  # GCV_ERR_NOT_SIMPLE
    PARSE: InputError,
    9: OutOfMemoryError,  # GCV_ERR_NO_MEMORY
}


def error(status: int, message: str) -> Error:
    """The exception for a status other than 0."""
    return _KINDS.get(status, Error)(status, message)


def named(error: Error, name: str) -> Error:
    """The same failure, of the polygon of that name."""
    reason = str(error)
    prefix = "polygon: "
    if reason.startswith(prefix):
        reason = reason[len(prefix) :]
    return type(error)(error.status, f"{name}: {reason}")


def last_error_message() -> str:
    """What the last failure on this thread was about."""
    message: bytes = _last_error_message()
    return message.decode(errors="replace").replace("GCV_LEAVE_OUT_HOLES", "'holes'")


def _check(status: int, _function: object, _arguments: object) -> int:
    if status != 0:
        raise error(status, last_error_message())
    return status


def _function(name: str, *argtypes: Any) -> Any:
    function = _declare(name, c_int32, *argtypes)
    function.errcheck = _check
    return function


# ---------------------------------------------------------------- handles --


class _Handle(c_void_p):
    """Owns an object of the library: ends it together with itself."""

    def __reduce__(self) -> NoReturn:
        raise TypeError("handles of libgcv cannot be pickled or copied")


def _ended_by(name: str) -> Any:
    """What is to be __del__ of a handle, by the function of the library that ends its object.

    It gives that function bound to the handle. All of it is of C: what a handler of a signal
    raises in a __del__ of Python, such as KeyboardInterrupt, would be lost.
    """
    function = _declare(name, None, c_void_p)
    # A library without it makes no such objects.
    return property(partial(partial, bool if isinstance(function, _Missing) else function))


class Polygon(_Handle):
    __del__ = _ended_by("gcv_polygon_destroy")


class OuterFace(_Handle):
    __del__ = _ended_by("gcv_outer_face_destroy")


class Region(_Handle):
    __del__ = _ended_by("gcv_region_destroy")


class ContactList(_Handle):
    __del__ = _ended_by("gcv_contact_list_destroy")


class Scene(_Handle):
    __del__ = _ended_by("gcv_scene_destroy")


class PairList(_Handle):
    __del__ = _ended_by("gcv_pair_list_destroy")


class Superset(_Handle):
    __del__ = _ended_by("gcv_superset_destroy")


# -------------------------------------------------------------- functions --

_double = POINTER(c_double)
_size = POINTER(c_size_t)
_buffer = (c_void_p, c_size_t, _size)
_options = POINTER(Options)
_polygon = POINTER(Polygon)
_face = POINTER(OuterFace)
_region = POINTER(Region)
_handles = POINTER(c_void_p)
_statuses = POINTER(c_int32)

polygon_create = _function("gcv_polygon_create", c_void_p, c_size_t, c_size_t, _polygon)
polygon_create_wkt = _function("gcv_polygon_create_wkt", c_char_p, c_size_t, _polygon)
polygon_create_rings = _function(
    "gcv_polygon_create_rings", c_void_p, _size, c_size_t, c_size_t, _polygon
)
polygon_create_many = _function(
    "gcv_polygon_create_many", c_void_p, _size, c_size_t, c_size_t, _handles, _statuses
)
polygon_create_disc = _function(
    "gcv_polygon_create_disc", _double, c_double, c_double, c_int32, _polygon
)
polygon_affine = _function("gcv_polygon_affine", Polygon, _double, _polygon)
polygon_ring_count = _function("gcv_polygon_ring_count", Polygon, _size)
polygon_ring = _function("gcv_polygon_ring", Polygon, c_size_t, *_buffer)
polygon_vertex_count = _function("gcv_polygon_vertex_count", Polygon, _size)
polygon_vertices = _function("gcv_polygon_vertices", Polygon, *_buffer)
polygon_area = _function("gcv_polygon_area", Polygon, _double)
polygon_bounds = _function("gcv_polygon_bounds", Polygon, _double)
polygon_simplified = _function(
    "gcv_polygon_simplified", Polygon, c_double, c_int32, _polygon, _double
)

options_init = _declare("gcv_options_init", None, _options)
options_init_size = _declare("gcv_options_init_size", None, _options, c_uint32)

minkowski_sum = _function("gcv_minkowski_sum", Polygon, Polygon, _options, _face)
no_fit_polygon = _function("gcv_no_fit_polygon", Polygon, Polygon, _double, _options, _face)
entrance_block = _function("gcv_entrance_block", Polygon, Polygon, _double, _options, _face)
minkowski_sum_many = _function(
    *("gcv_minkowski_sum_many", _handles, _handles, c_size_t, _options, _handles, _statuses)
)
no_fit_polygon_many = _function(
    *("gcv_no_fit_polygon_many", _handles, _handles, _double, c_size_t, _options),
    *(_handles, _statuses),
)

minkowski_sum_region = _function("gcv_minkowski_sum_region", Polygon, Polygon, _options, _region)
no_fit_region = _function("gcv_no_fit_region", Polygon, Polygon, _double, _options, _region)
entrance_region = _function("gcv_entrance_region", Polygon, Polygon, _double, _options, _region)
inner_fit_region = _function("gcv_inner_fit_region", Polygon, Polygon, _double, _options, _region)
minkowski_sum_region_many = _function(
    *("gcv_minkowski_sum_region_many", _handles, _handles, c_size_t, _options),
    *(_handles, _statuses),
)
no_fit_region_many = _function(
    *("gcv_no_fit_region_many", _handles, _handles, _double, c_size_t, _options),
    *(_handles, _statuses),
)

outer_face_vertex_count = _function("gcv_outer_face_vertex_count", OuterFace, _size)
outer_face_vertices = _function("gcv_outer_face_vertices", OuterFace, *_buffer)
outer_face_exact_vertex_count = _function("gcv_outer_face_exact_vertex_count", OuterFace, _size)
outer_face_exact_vertex = _function("gcv_outer_face_exact_vertex", OuterFace, c_size_t, *_buffer)
outer_face_edge_sources = _function("gcv_outer_face_edge_sources", OuterFace, *_buffer)
outer_face_exact_indices = _function("gcv_outer_face_exact_indices", OuterFace, *_buffer)
outer_face_error_bound = _function("gcv_outer_face_error_bound", OuterFace, _double)
outer_face_area = _function("gcv_outer_face_area", OuterFace, _double)
outer_face_wkt = _function("gcv_outer_face_wkt", OuterFace, *_buffer)
outer_face_polygon = _function("gcv_outer_face_polygon", OuterFace, _polygon)
outer_face_stats = _function("gcv_outer_face_stats", OuterFace, POINTER(Stats))

region_parts = _function("gcv_region_parts", Region, *_buffer)
region_vertices = _function("gcv_region_vertices", Region, *_buffer)
region_exact_parts = _function("gcv_region_exact_parts", Region, *_buffer)
region_exact_vertex = _function("gcv_region_exact_vertex", Region, c_size_t, *_buffer)
region_exact_indices = _function("gcv_region_exact_indices", Region, *_buffer)
region_edge_sources = _function("gcv_region_edge_sources", Region, *_buffer)
region_edge_owners = _function("gcv_region_edge_owners", Region, *_buffer)
region_area = _function("gcv_region_area", Region, _double)
region_error_bound = _function("gcv_region_error_bound", Region, _double)
region_wkt = _function("gcv_region_wkt", Region, *_buffer)
region_fits_wkt = _function("gcv_region_fits_wkt", Region, *_buffer)
region_polygon = _function("gcv_region_polygon", Region, c_size_t, _polygon)
region_locate = _function("gcv_region_locate", Region, c_void_p, c_size_t, POINTER(c_int8))
region_stats = _function("gcv_region_stats", Region, POINTER(Stats))

_translations = (Polygon, Polygon, c_void_p)
_answers = (c_size_t, _options, c_void_p)
relation = _function("gcv_relation", *_translations, *_answers)
distance = _function("gcv_distance", *_translations, *_answers)
penetration = _function("gcv_penetration", *_translations, *_answers)
cast = _function("gcv_cast", *_translations, c_void_p, *_answers)
contacts = _function(
    *("gcv_contacts", *_translations, c_double, c_double, _options, POINTER(ContactList))
)
contact_list_contacts = _function("gcv_contact_list_contacts", ContactList, *_buffer)
contact_list_previous = _function("gcv_contact_list_previous", ContactList, *_buffer)

_scene = POINTER(Scene)
_asked = (POINTER(Query), _options)

scene_create = _function("gcv_scene_create", _scene)
scene_copy = _function("gcv_scene_copy", Scene, _scene)
scene_ids = _function("gcv_scene_ids", Scene, *_buffer)
scene_positions = _function("gcv_scene_positions", Scene, c_void_p, c_size_t, c_void_p)
scene_polygon = _function("gcv_scene_polygon", Scene, c_uint64, _polygon)

# These return the status: at_once looks at it.
scene_set_container = _declare("gcv_scene_set_container", c_int32, Scene, Polygon)
scene_add = _declare("gcv_scene_add", c_int32, Scene, _handles, c_void_p, c_size_t, c_void_p)
scene_set = _declare("gcv_scene_set", c_int32, Scene, c_void_p, _handles, c_void_p, c_size_t)
scene_set_layers = _declare("gcv_scene_set_layers", c_int32, Scene, c_void_p, c_void_p, c_size_t)
scene_remove = _declare("gcv_scene_remove", c_int32, Scene, c_void_p, c_size_t)

_moving = (Scene, Polygon, c_void_p)
scene_free_region = _function("gcv_scene_free_region", *_moving, *_asked, _region)
scene_best = _function("gcv_scene_best", *_moving, *_asked, c_void_p, POINTER(c_int32))
scene_relation = _function("gcv_scene_relation", *_moving, c_size_t, *_asked, c_void_p)
scene_distance = _function("gcv_scene_distance", *_moving, c_size_t, *_asked, c_void_p)
scene_penetration = _function("gcv_scene_penetration", *_moving, c_size_t, *_asked, c_void_p)
scene_cast = _function("gcv_scene_cast", *_moving, c_void_p, c_size_t, *_asked, c_void_p)
scene_near = _function("gcv_scene_near", *_moving, c_double, *_asked, POINTER(PairList))
scene_pairs = _function(*("gcv_scene_pairs", Scene, PairList, c_double, *_asked, POINTER(PairList)))
scene_contacts = _function(
    *("gcv_scene_contacts", Scene, ContactList, c_double, c_double, *_asked),
    POINTER(ContactList),
)
pair_list_pairs = _function("gcv_pair_list_pairs", PairList, *_buffer)

superset_create = _function("gcv_superset_create", Polygon, Polygon, POINTER(Superset))
superset_edges = _function("gcv_superset_edges", Superset, *_buffer)


def value(function: Callable[..., int], kind: Any, handle: Any) -> Any:
    """What a function with one output of the given ctypes type gives."""
    out = kind()
    function(handle, byref(out))
    return out.value


def count(function: Callable[..., int], *arguments: Any) -> int:
    """How many elements a buffer function gives."""
    required = c_size_t()
    function(*arguments, None, 0, byref(required))
    return required.value


def elements(function: Callable[..., int], kind: Any, *arguments: Any) -> Array[Any]:
    """What a buffer function gives, as elements of the given ctypes type."""
    out: Array[Any] = (kind * count(function, *arguments))()
    function(*arguments, out, len(out), byref(c_size_t()))
    return out

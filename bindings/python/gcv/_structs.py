# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The structs of gcv.h, and the arrays and the function that its functions take."""

from __future__ import annotations

from ctypes import (
    CFUNCTYPE,
    POINTER,
    Structure,
    c_double,
    c_int32,
    c_size_t,
    c_uint32,
    c_uint64,
    c_void_p,
    sizeof,
)
from typing import Any

Point = c_double * 2
Box = c_double * 4
Matrix = c_double * 6
Progress = CFUNCTYPE(c_int32, c_void_p, c_uint64, c_uint64)


class Options(Structure):
    _fields_ = (
        ("struct_size", c_uint32),
        ("rounding", c_int32),
        ("tolerance", c_double),
        ("threads", c_int32),
        ("progress", Progress),
        ("progress_context", c_void_p),
        ("leave_out", c_uint64),
    )


class Query(Structure):
    _fields_ = (
        ("struct_size", c_uint32),
        ("layers", c_uint32),
        ("ignore", POINTER(c_uint64)),
        ("ignore_count", c_size_t),
    )


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


class Stats(Structure):
    _fields_ = (
        ("struct_size", c_uint32),
        ("walk_steps", c_uint64),
        ("candidate_edges", c_uint64),
        ("predicates_filtered", c_uint64),
        ("predicates_fixed_width", c_uint64),
        ("predicates_rational", c_uint64),
        ("vertices_repaired", c_uint64),
        ("parts_dropped", c_uint64),
    )


class RegionPart(Structure):
    _fields_ = (("kind", c_int32), ("polygon", c_uint32), ("vertex_count", c_uint64))


class Contact(Structure):
    _fields_ = (
        ("kind", c_int32),
        ("a", c_uint32),
        ("b", c_uint32),
        ("reserved", c_uint32),
        ("id_a", c_uint64),
        ("id_b", c_uint64),
        ("gap", c_double),
        ("normal", Point),
        ("on_a", Point),
        ("on_b", Point),
    )


class Separation(Structure):
    _fields_ = (
        ("distance", c_double),
        ("relation", c_int32),
        ("reserved", c_uint32),
        ("nearest", Contact),
    )


class Escape(Structure):
    _fields_ = (
        ("depth", c_double),
        ("translation", Point),
        ("position", Point),
        ("relation", c_int32),
        ("reserved", c_uint32),
        ("contact", Contact),
    )


class Impact(Structure):
    _fields_ = (
        ("hit", c_int32),
        ("relation", c_int32),
        ("time", c_double),
        ("position", Point),
        ("contact", Contact),
    )


class Pair(Structure):
    _fields_ = (
        ("a", c_uint64),
        ("b", c_uint64),
        ("relation", c_int32),
        ("reserved", c_uint32),
    )


def sized(struct: Any, **fields: Any) -> Any:
    """A struct that begins with its own size."""
    return struct(struct_size=sizeof(struct), **fields)

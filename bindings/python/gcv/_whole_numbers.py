# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Ids and layers, as the library takes them."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Mapping
from operator import index
from typing import Any, Literal, Optional, SupportsIndex, Union

from ._coordinates import MASKED, has_masked, unfit
from ._ffi import INVALID_ARGUMENT, InputError

_ID = "an id"
_LAYERS = "a number of 32 bits, one for each layer"

WholeNumbers = Union[SupportsIndex, Iterable[Any]]
"""One whole number, or a sequence or an array of them."""


def ids_of(source: WholeNumbers, name: str) -> tuple[array[int], bool]:
    """The ids, and whether the source is one. Messages call them by that name."""
    return _read(source, "Q", name, _ID)


def layers_of(source: WholeNumbers, name: str) -> tuple[array[int], bool]:
    """The bits of layers, likewise."""
    return _read(source, "I", name, _LAYERS)


def one_id(source: SupportsIndex, name: str) -> int:
    return _number(source, "Q", name, _ID)


def one_of_layers(source: SupportsIndex, name: str) -> int:
    return _number(source, "I", name, _LAYERS)


def _read(source: Any, code: Literal["Q", "I"], name: str, what: str) -> tuple[array[int], bool]:
    if has_masked(source):
        raise InputError(INVALID_ARGUMENT, f"{name}: {MASKED}")
    numbers = _in_buffer(source, code)
    if numbers is not None:
        return numbers, False
    if hasattr(source, "__index__") and not getattr(source, "ndim", 0):
        return array(code, [_number(source, code, name, what)]), True
    is_refused = isinstance(source, (bytes, bytearray, Mapping))
    try:
        values = None if is_refused else tuple(source)
    except TypeError:
        values = None
    if values is None:
        raise unfit(name, source, f"{what}, nor a sequence of them")
    try:
        if not any(map(_is_truth, set(map(type, values)))):
            return array(code, map(index, values)), False
    except (TypeError, OverflowError):
        pass
    found = (_number(value, code, f"{name}[{k}]", what) for k, value in enumerate(values))
    return array(code, found), False


def _in_buffer(source: Any, code: Literal["Q", "I"]) -> Optional[array[int]]:
    """The numbers in a buffer of just this type; None for other sources."""
    try:
        view = memoryview(source)
    except (TypeError, ValueError):
        return None
    numbers = array(code)
    if view.ndim != 1 or view.format not in ("I", "L", "Q") or view.itemsize != numbers.itemsize:
        return None
    numbers.frombytes(view.tobytes())
    return numbers


def _is_truth(kind: type) -> bool:
    """Whether it is the type of True, or that of numpy, by either of its names."""
    return kind.__name__ in ("bool", "bool_")


def _number(value: Any, code: Literal["Q", "I"], name: str, what: str) -> int:
    if _is_truth(type(value)):
        raise unfit(name, value, what)
    try:
        return array(code, [index(value)])[0]
    except (TypeError, OverflowError):
        raise unfit(name, value, what) from None

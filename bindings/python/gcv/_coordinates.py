# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Numbers, points and rings of whatever they can be made from, as doubles x0 y0 x1 y1 ..."""

from __future__ import annotations

import math
import operator
import reprlib
import struct
import sys
from array import array
from collections.abc import Iterable, Iterator, Mapping, Sequence, Sized
from itertools import accumulate, chain
from numbers import Complex, Integral, Real
from typing import Any, Callable, Optional

from ._ffi import INVALID_ARGUMENT, NOT_FINITE, InputError, named

_DOUBLE_FORMATS = ("d", ("<" if sys.byteorder == "little" else ">") + "d")
_NUMBER_FORMATS = (*_DOUBLE_FORMATS, *"fbBhHiIlLqQ")
_VERTEX_BYTES = 16
_LEAST_INEXACT = 2.0**53
"""Below this, every integer is a float."""
_FLOATS, _PLAIN, _LISTS = {float}, {float, int}, {list, tuple}
_SETS = (set, frozenset)
_NO_PAIRS = (*_SETS, Mapping, bytes, bytearray)

Points = list[tuple[float, float]]

Rings = list[bytes]
"""The rings of a polygon as passed, each as doubles: the outer one first, then the holes."""


def size(ring: bytes) -> int:
    """The number of vertices of a ring."""
    return len(ring) // _VERTEX_BYTES


def split(doubles: bytes, sizes: Iterable[int]) -> list[bytes]:
    """The rings of these numbers of vertices that follow one another."""
    ends = [0, *accumulate(vertices * _VERTEX_BYTES for vertices in sizes)]
    return [doubles[start:end] for start, end in zip(ends, ends[1:])]


def points(doubles: bytes) -> Points:
    return list(struct.iter_unpack("dd", doubles))


def ring_in_buffer(source: Any) -> Optional[bytes]:
    """The ring in a buffer of pairs of numbers; None for other sources, and for text."""
    view = _buffer(source, _NUMBER_FORMATS)
    if view is None:
        return None
    of_pairs = (view.shape or ())[1:] in ((), (2,)) and view.nbytes % (2 * view.itemsize) == 0
    if of_pairs and view.format in _DOUBLE_FORMATS:
        return view.tobytes()
    if not of_pairs:
        raise invalid(f"a buffer of shape {view.shape} does not hold pairs of numbers")
    values: Any = view.tolist()
    pairs = values if view.ndim == 2 else zip(values[::2], values[1::2])
    return doubles_of_pairs(tuple(pairs), vertex_name).tobytes()


def rings_of_many(source: Any) -> Optional[list[bytes]]:
    """The rings in a buffer of shape (n, k, 2), one a polygon; None for other sources."""
    view = _buffer(source)
    if view is None or view.ndim != 3 or (view.shape or ())[2:] != (2,):
        return None
    count, vertices, _ = view.shape or ()
    return split(view.tobytes(), [vertices] * count)


def number(value: Any, name: str) -> float:
    """The value as a float, which the argument of that name should be."""
    if type(value) is float:
        return value
    (as_float,) = numbers((value,), 1, name, value, "a number")
    return as_float


def count(value: Any, name: str) -> int:
    """The value as a number of 32 bits, which the argument of that name should be."""
    try:
        (whole,) = array("i", [operator.index(value)])
    except (TypeError, OverflowError):
        raise unfit(name, value, "a whole number of 32 bits") from None
    return whole


def pair(value: Any, name: str) -> tuple[float, float]:
    """The value as (x, y), which the argument of that name should be."""
    x, y = numbers(value, 2, name, value, "a pair of numbers")
    return x, y


def point_or_points(
    source: Any, name: str, what: str = "a point, nor a sequence of points"
) -> tuple[bytes, bool]:
    """The doubles of one point or of a sequence of them, and whether it is one.

    Messages call them by that name, and say what else the source is not.
    """
    try:
        view = _buffer(source, _NUMBER_FORMATS)
    except InputError as error:
        raise named(error, name) from None
    if view is not None and view.format in _DOUBLE_FORMATS:
        if (view.shape or ())[-1:] == (2,) and view.ndim <= 2:
            return view.tobytes(), view.ndim == 1
        view = None
    values = elements_of(source if view is None else view, name, what)
    shape = getattr(source, "shape", ())
    if not values and len(shape) > 1 and shape[1:] != (2,):
        raise unfit(name, source, what)
    if len(values) == 2 and not any(map(_has_elements, values)):
        return numbers(values, 2, name, source, "a pair of numbers").tobytes(), True
    return doubles_of_pairs(values, lambda k: f"{name}[{k}]").tobytes(), False


def _has_elements(value: object) -> bool:
    if not isinstance(value, Sized):
        return hasattr(value, "__geo_interface__")
    try:
        len(value)
    except TypeError:  # an array of no dimensions is a number
        return False
    return True


def elements_of(source: Any, name: str, what: str) -> tuple[Any, ...]:
    """What is in a sequence, all of it; a message calls it by that name, and says what it is not.

    A view is taken as lists: Python cannot iterate over one of several dimensions.
    """
    if type(source) in _LISTS:
        return tuple(source)
    check_order(source, name)
    if isinstance(source, _NO_PAIRS):
        raise unfit(name, source, what)
    if has_masked(source):
        raise InputError(INVALID_ARGUMENT, f"{name}: {MASKED}")
    if len(getattr(source, "shape", ())) == 2 and hasattr(source, "to_numpy"):
        source = source.to_numpy()  # a frame: its elements are the names of its columns
    try:
        elements = iter(source.tolist() if isinstance(source, memoryview) else source)
    except (TypeError, NotImplementedError):
        elements = _elements_by_interface(source)
        if elements is None:
            raise unfit(name, source, what) from None
    return tuple(elements)


def is_array(source: object) -> bool:
    """Whether numpy makes an array of it by an interface for that."""
    return hasattr(source, "__array__") or hasattr(source, "__array_interface__")


def _elements_by_interface(source: Any) -> Optional[Iterator[Any]]:
    """Those of a point in the manner of shapely, or of an array that only numpy can read."""
    geometry = getattr(source, "__geo_interface__", None)
    if isinstance(geometry, Mapping):
        point = geometry["coordinates"][:2] if geometry.get("type") == "Point" else ()
        return iter(point) if point else None
    if not is_array(source):
        return None
    try:
        import numpy
    except ImportError:
        return None
    array = numpy.asarray(source)
    return iter(array.tolist()) if array.ndim else None


def check_order(source: object, name: str) -> None:
    """Raise InputError for a set: its order is not that in which it was written."""
    if isinstance(source, _SETS):
        raise unfit(name, source, "a sequence: a set has no order")


def doubles_of_pairs(
    values: Sequence[Any], name: Callable[[int], str], *, elevations: bool = False
) -> array[float]:
    """The numbers of pairs, taken all at once where none of them is to blame.

    With elevations, more than two numbers will do, and the first two are taken.
    """
    try:
        kinds = set(map(type, values))
        if kinds <= _LISTS or not any(issubclass(kind, _NO_PAIRS) for kind in kinds):
            lengths = set(map(len, values))
            if lengths <= {2}:
                return _floats(tuple(chain.from_iterable(values)))
            if elevations and min(lengths) >= 2:
                return _floats(tuple(x for value in values for x in value[:2]))
    except (TypeError, ValueError, ArithmeticError):
        pass
    doubles = array("d")
    for k, value in enumerate(values):
        doubles.extend(_pair(value, name(k), elevations=elevations))
    return doubles


def _pair(value: Any, name: str, *, elevations: bool) -> array[float]:
    what = "a pair of numbers"
    if elevations and not isinstance(value, (str, Mapping)):
        return numbers(elements_of(value, name, what)[:2], 2, name, value, what)
    return numbers(value, 2, name, value, what)


def numbers(values: Iterable[Any], count: int, name: str, value: object, what: str) -> array[float]:
    """The values, which should be so many numbers, as floats; value is what the caller passed."""
    elements = elements_of(values, name, what)
    try:
        doubles = _floats(elements)
    except OverflowError:
        raise _too_large(name, value) from None
    except ArithmeticError as error:
        raise InputError(INVALID_ARGUMENT, f"{name}: {error}") from None
    except (TypeError, ValueError):
        raise unfit(name, value, what) from None
    if len(doubles) != count:
        raise unfit(name, value, what)
    return doubles


def _floats(values: tuple[Any, ...]) -> array[float]:
    """The numbers as floats: each integer exactly, others to the nearest one.

    Raises OverflowError for what no finite float is near to, ArithmeticError for an integer
    that no float is, TypeError or ValueError for what is no real number.
    """
    kinds = set(map(type, values))
    if not kinds <= _PLAIN and any(map(_is_no_coordinate, kinds)):
        raise TypeError("a complex number, or one behind a mask, is no coordinate")
    doubles = array("d", values)
    if kinds != _FLOATS and (max(doubles) >= _LEAST_INEXACT or min(doubles) <= -_LEAST_INEXACT):
        for value, double in zip(values, doubles):
            if isinstance(value, Integral) and int(value) != double:
                raise ArithmeticError(f"no float is the integer {short(int(value))}")
    return doubles


def _is_no_coordinate(kind: type) -> bool:
    is_complex = issubclass(kind, Complex) and not issubclass(kind, Real)
    return is_complex or kind.__name__ == "MaskedConstant"


def unfit(name: str, value: object, what: str, status: int = INVALID_ARGUMENT) -> InputError:
    """The error for a value that is not what it should be."""
    return InputError(status, f"{name}: {short(value)} is not {what}")


def unfit_number(name: str, value: float, what: str) -> InputError:
    """The error for a number that is not finite, or out of its range."""
    return unfit(name, value, what, INVALID_ARGUMENT if math.isfinite(value) else NOT_FINITE)


def check_finite(name: str, values: Iterable[float]) -> None:
    """Raises InputError for a number that is not finite."""
    for k, x in enumerate(values):
        if not math.isfinite(x):
            raise InputError(NOT_FINITE, f"{name}: number {k} is {x}, not finite")


def _too_large(name: str, value: object) -> InputError:
    return InputError(
        NOT_FINITE, f"{name}: {short(value)} is not a number that a finite float can be near to"
    )


def short(value: object) -> str:
    """The value in a message."""
    try:
        return " ".join(reprlib.repr(value).split())
    except ValueError:  # an integer with more digits than Python writes
        return f"an object of type {type(value).__name__}"


def invalid(message: str) -> InputError:
    """The error for a polygon that the message is about."""
    return InputError(INVALID_ARGUMENT, f"polygon: {message}")


MASKED = "some elements of the array are masked; leave them out first"


def has_masked(source: Any) -> bool:
    """Whether it is an array some elements of which are masked."""
    any_masked = getattr(getattr(source, "mask", None), "any", None)
    return any_masked is not None and bool(any_masked())


def _buffer(source: Any, formats: tuple[str, ...] = _DOUBLE_FORMATS) -> Optional[memoryview]:
    """The buffer of a source that holds numbers of these formats; None for others, and bytes.

    Refuses arrays some elements of which are masked: what lies behind a mask is no data.
    """
    if has_masked(source):
        raise invalid(MASKED)
    if isinstance(source, (bytes, bytearray)):
        return None
    try:
        view = memoryview(source)
    except (TypeError, ValueError):  # numpy has no buffers of times
        return None
    return view if view.format in formats else None


def vertex_name(index: int, ring: int = 0) -> str:
    return f"polygon: vertex {index}" + (f" of ring {ring}" if ring else "")

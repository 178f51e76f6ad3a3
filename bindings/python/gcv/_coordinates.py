# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The rings of whatever a polygon can be made from, as doubles x0 y0 x1 y1 ..."""

from __future__ import annotations

import json
import operator
import re
import reprlib
import struct
import sys
from array import array
from collections.abc import Iterable, Mapping, Sequence, Sized
from itertools import accumulate, chain
from typing import Any, Optional

from ._ffi import INVALID_ARGUMENT, NOT_FINITE, PARSE, InputError, named

_DOUBLE_FORMATS = ("d", ("<" if sys.byteorder == "little" else ">") + "d")
_NUMBER_FORMATS = (*_DOUBLE_FORMATS, *"fbBhHiIlLqQ")
_VERTEX_BYTES = 16

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
    """The ring in a buffer of pairs of doubles; None for other sources."""
    view = _buffer(source)
    if view is None:
        return None
    if view.nbytes % _VERTEX_BYTES != 0 or (view.shape or ())[1:] not in ((), (2,)):
        raise invalid(f"a buffer of shape {view.shape} does not hold pairs of doubles")
    return view.tobytes()


def rings_of(source: Any) -> Rings:
    """The rings of a geometry, or of a sequence of pairs.

    Raises InputError for anything else.
    """
    geometry = getattr(source, "__geo_interface__", source)
    if isinstance(geometry, Mapping):
        rings = _rings_of_geometry(geometry)
        return [_from_pairs(ring, k, elevations=True) for k, ring in enumerate(rings)]
    return [_from_pairs(source)]


def rings_of_many(source: Any) -> Optional[list[bytes]]:
    """The rings in a buffer of shape (n, k, 2), one a polygon; None for other sources."""
    view = _buffer(source)
    if view is None or view.ndim != 3 or (view.shape or ())[2:] != (2,):
        return None
    count, vertices, _ = view.shape or ()
    return split(view.tobytes(), [vertices] * count)


def geometry_of_text(text: bytes) -> Optional[Any]:
    """What GeoJSON text says; None for text of another kind."""
    if not text.lstrip().startswith(b"{"):
        return None
    try:
        return json.loads(text)
    except ValueError as error:
        raise InputError(PARSE, f"polygon: GeoJSON text: {error}") from None


def of_one_part(text: bytes) -> bytes:
    """Well-Known Text of a MULTIPOLYGON of one part as that of the part.

    Every other byte stays where it is, with blanks for what goes. Raises InputError for
    other numbers of parts.
    """
    tag = re.match(rb"\s*(MULTI)POLYGON\s*(?:ZM|Z|M)?\s*(?:(\()|EMPTY\s*$)", text, re.IGNORECASE)
    if not tag:
        return text
    parts = len(re.findall(rb"\(\s*\(", text[tag.end() :])) if tag[2] else 0
    if parts != 1:
        raise invalid(f"a MultiPolygon of {parts} parts is not one polygon")
    bare = bytearray(text.rstrip())
    bare[slice(*tag.span(1))] = b" " * len(tag[1])
    bare[tag.start(2)] = ord(" ")
    return bytes(bare[:-1] if bare.endswith(b")") else bare)


def without_elevations(text: bytes) -> bytes:
    """Well-Known Text with blanks for the Z and M of a POLYGON and for their numbers.

    Every other byte stays where it is.
    """
    tag = re.match(rb"\s*POLYGON\s*(ZM|Z|M)\s*(?=\(|EMPTY)", text, re.IGNORECASE)
    if not tag:
        return text
    start, end = tag.span(1)
    count = end - start
    elevations = rb"(?:\s+[-+.\w]+){%d}" % count
    return re.sub(
        rb"([(,]\s*[-+.\w]+\s+[-+.\w]+)(" + elevations + rb")(?=\s*[,)])",
        lambda vertex: vertex[1] + b" " * len(vertex[2]),
        text[:start] + b" " * count + text[end:],
    )


def rings_of_wkt(text: bytes) -> Rings:
    """The rings of a polygon that the library has accepted."""
    rings = re.findall(rb"\(([^()]*)\)", text)
    return [array("d", map(float, re.findall(rb"[^\s,]+", ring))).tobytes() for ring in rings]


def number(value: Any, name: str) -> float:
    """The value as a float, which the argument of that name should be."""
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
    if view is not None and (view.shape or ())[-1:] == (2,) and view.ndim <= 2:
        if view.format in _DOUBLE_FORMATS:
            return view.tobytes(), view.ndim == 1
        if view.ndim == 2:
            rows: Any = view.tolist()
            return array("d", chain.from_iterable(rows)).tobytes(), False
    try:
        values = tuple(source)
    except TypeError:
        raise unfit(name, source, what) from None
    if len(values) == 2 and not any(isinstance(value, Sized) for value in values):
        return numbers(values, 2, name, source, "a pair of numbers").tobytes(), True
    return _doubles_of_pairs(values, name).tobytes(), False


def _doubles_of_pairs(values: tuple[Any, ...], name: str) -> array[float]:
    """The numbers of pairs, taken all at once where none of them is to blame."""
    try:
        if set(map(len, values)) <= {2}:
            return array("d", chain.from_iterable(values))
    except (TypeError, ValueError, OverflowError):
        pass
    doubles = array("d")
    for k, value in enumerate(values):
        doubles.extend(pair(value, f"{name}[{k}]"))
    return doubles


def numbers(values: Iterable[Any], count: int, name: str, value: object, what: str) -> array[float]:
    """The values, which should be so many numbers, as floats; value is what the caller passed."""
    doubles = array("d")
    try:
        doubles.extend(tuple(values))
    except OverflowError:
        raise _too_large(name, value) from None
    except (TypeError, ValueError):
        raise unfit(name, value, what) from None
    if len(doubles) != count:
        raise unfit(name, value, what)
    return doubles


def unfit(name: str, value: object, what: str) -> InputError:
    """The error for a value that is not what it should be."""
    return InputError(INVALID_ARGUMENT, f"{name}: {_short(value)} is not {what}")


def _too_large(name: str, value: object) -> InputError:
    return InputError(
        NOT_FINITE, f"{name}: {_short(value)} is not a number that a finite float can be near to"
    )


def _short(value: object) -> str:
    """The value in a message."""
    try:
        return " ".join(reprlib.repr(value).split())
    except ValueError:  # an integer with more digits than Python writes
        return f"an object of type {type(value).__name__}"


def invalid(message: str) -> InputError:
    """The error for a polygon that the message is about."""
    return InputError(INVALID_ARGUMENT, f"polygon: {message}")


def _buffer(source: Any, formats: tuple[str, ...] = _DOUBLE_FORMATS) -> Optional[memoryview]:
    """The buffer of a source that holds numbers of these formats; None where there is none.

    Refuses arrays some elements of which are masked: what lies behind a mask is no data.
    """
    any_masked = getattr(getattr(source, "mask", None), "any", None)
    if any_masked is not None and any_masked():
        raise invalid("some elements of the array are masked; leave them out first")
    try:
        view = memoryview(source)
    except TypeError:
        return None
    return view if view.format in formats else None


def _rings_of_geometry(geometry: Any) -> Sequence[Any]:
    """The rings of a GeoJSON object."""
    kind = geometry.get("type") if isinstance(geometry, Mapping) else None
    if kind == "Feature":
        return _rings_of_geometry(geometry.get("geometry"))
    if kind == "FeatureCollection":
        return _rings_of_geometry(_only(geometry.get("features"), "FeatureCollection"))
    coordinates = geometry.get("coordinates") if isinstance(geometry, Mapping) else None
    if kind == "MultiPolygon":
        return _sequence(_only(coordinates, "MultiPolygon")) or [()]
    if kind == "LinearRing":
        return [_sequence(coordinates)]
    if kind == "Polygon":
        return _sequence(coordinates) or [()]
    if kind is None:
        raise invalid(f"{_short(geometry)} is not a geometry")
    raise invalid(f"a geometry of type {kind!r} is not a polygon")


def _only(parts: Any, kind: str) -> Any:
    parts = _sequence(parts)
    if len(parts) != 1:
        raise invalid(f"a {kind} of {len(parts)} parts is not one polygon")
    return parts[0]


def _sequence(value: Any) -> Sequence[Any]:
    if not isinstance(value, Sequence) or isinstance(value, str):
        raise invalid(f"{_short(value)} in a geometry is not a list")
    return value


def _from_pairs(source: Iterable[Any], ring: int = 0, *, elevations: bool = False) -> bytes:
    doubles = array("d")
    try:
        vertices = enumerate(source)
    except TypeError:
        what = "a polygon, and none can be made from it"
        raise unfit("polygon", source, what) from None
    for index, vertex in vertices:
        try:
            x, y = vertex[:2] if elevations else vertex
            doubles.append(x)
            doubles.append(y)
        except (TypeError, ValueError):
            raise unfit(_vertex(index, ring), vertex, "a pair of numbers") from None
        except OverflowError:
            raise _too_large(_vertex(index, ring), vertex) from None
    return doubles.tobytes()


def _vertex(index: int, ring: int) -> str:
    return f"polygon: vertex {index}" + (f" of ring {ring}" if ring else "")

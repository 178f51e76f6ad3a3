# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reading polygons from anything.

The types of all that a polygon can be made from, and the rings of a source of any of
these types, be it a shape, a file, a text, or what _coordinates reads.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Protocol, SupportsFloat, Union

from . import _ffi
from ._coordinates import (
    Rings,
    check_order,
    ring_in_buffer,
    unfit,
)
from ._geometries import rings_of
from ._handles import created_of_wkt
from ._shape import Shape
from ._texts import geometry_of_text, of_one_part, text_of, without_elevations

if TYPE_CHECKING:
    import numpy
    import numpy.typing


class SupportsArrayInterface(Protocol):
    """An array in the manner of numpy."""

    @property
    def __array_interface__(self) -> dict[str, Any]: ...


class SupportsArray(Protocol):
    """What numpy makes an array of."""

    def __array__(self) -> numpy.typing.NDArray[Any]: ...


class SupportsGeoInterface(Protocol):
    """A geometry in the manner of shapely."""

    @property
    def __geo_interface__(self) -> Mapping[str, Any]: ...


PolygonLike = Union[
    Shape,
    str,
    bytes,
    Path,
    SupportsArray,
    SupportsArrayInterface,
    SupportsGeoInterface,
    "array[float]",
    "memoryview[Any]",
    Mapping[str, Any],
    Iterable[Iterable[SupportsFloat]],
]
"""All that Polygon can be made from."""

PointLike = Union[Iterable[SupportsFloat], SupportsGeoInterface]
"""A pair of numbers, or a point in the manner of shapely."""
Vector = Union[Sequence[Union[float, Fraction, Decimal, "numpy.number[Any]"]], SupportsGeoInterface]
"""The same. These are not all numbers that have a __float__, for arrays have one."""
Vectors = Union[Iterable[PointLike], SupportsArrayInterface, "memoryview[Any]"]
"""Many points. An array is taken for many: types do not say whether it is one pair."""


class SupportsArrowArray(Protocol):
    """An array of Arrow, by the PyCapsule interface."""

    def __arrow_c_array__(self, requested_schema: Any = None) -> tuple[Any, Any]: ...


class SupportsArrowStream(Protocol):
    """A stream of arrays of Arrow, by the PyCapsule interface."""

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any: ...


PolygonsLike = Union[
    Iterable[PolygonLike],
    str,
    bytes,
    Path,
    SupportsGeoInterface,
    Mapping[str, Any],
    SupportsArrowArray,
    SupportsArrowStream,
]
"""All that many polygons can be made from; what GeoPandas has is an iterable."""


def read(source: Any) -> tuple[Rings, Optional[_ffi.Polygon]]:
    """The rings of a source, and the handle of its polygon where it was made on the way."""
    if isinstance(source, Shape):
        return source._numbered(), None
    ring = ring_in_buffer(source)
    if ring is not None:
        return [ring], None
    if isinstance(source, Path):
        try:
            return read(text_of(source))
        except _ffi.Error as error:
            raise _ffi.named(error, f"polygon: {source}") from None
    if isinstance(source, (str, bytes, bytearray)):
        text = text_of(source)
        geometry = geometry_of_text(text)
        if geometry is None:
            return created_of_wkt(without_elevations(of_one_part(text)))
        source = geometry
    if type(source) not in (list, tuple):
        # Here, for scenes are made of polygons.
        from ._members import Members

        if isinstance(source, Members):
            raise unfit("polygon", source, "a polygon but a scene")
    return rings_of(source), None


def read_holes(sources: Iterable[PolygonLike]) -> Rings:
    """The one ring of each hole."""
    if isinstance(sources, (str, bytes, bytearray)):
        raise unfit("holes", sources, "a sequence of polygons, for it is text")
    return [_hole(source, k) for k, source in enumerate(iterable(sources, "holes"))]


def _hole(source: PolygonLike, index: int) -> bytes:
    try:
        rings, _ = read(source)
    except _ffi.Error as error:
        raise _ffi.named(error, f"polygon: hole {index}") from None
    if len(rings) != 1:
        raise _ffi.InputError(
            _ffi.INVALID_ARGUMENT, f"polygon: hole {index} has {len(rings)} rings, not one"
        )
    return rings[0]


def iterable(sources: Any, name: str, what: str = "a sequence of polygons") -> Iterable[Any]:
    """An iterator of the sources, which the argument of that name should be."""
    check_order(sources, name)
    try:
        iterator: Iterable[Any] = iter(sources)
        return iterator
    except TypeError:
        raise unfit(name, sources, what) from None

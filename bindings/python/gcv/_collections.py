# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reading polygons from one source that has several: a geometry, or text."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Callable, Optional, Union

from ._columns import NO_ORIGIN, Column
from ._ffi import INVALID_ARGUMENT, Error, InputError
from ._named import NamedPolygon, make
from ._polygon import Polygon
from ._region import Region
from ._shape import Shape
from ._text_files import geometries, polygon_of_wkt, texts_of_wkt
from ._texts import read_json, text_of

_Maker = Callable[[str], NamedPolygon]
"""What makes a polygon of a source, whose errors have that name."""


def collection_of(source: Any, name: str, row_name: str = "") -> Optional[Column]:
    """The polygons of a mapping, an object with a __geo_interface__, or text; None for others.

    Segments and points of collections are left out. Messages call it by that name, and its
    polygons by row_name with their number in it, which is "name[{}]" by default.
    """
    if isinstance(source, (list, tuple, Region)):
        return None
    if isinstance(source, (str, bytes, bytearray, Path)):
        makers = _makers_of_text(text_of(source), name)
    elif isinstance(source, Shape):
        makers = [_maker(source)]
    else:
        geometry = getattr(source, "__geo_interface__", source)
        if not isinstance(geometry, Mapping):
            return None
        makers = _makers(geometry, name)
    row_name = row_name or f"{name}[{{}}]"
    return Column([_made(maker, row_name.format(k)) for k, maker in enumerate(makers)], NO_ORIGIN)


def _makers_of_text(text: bytes, name: str) -> list[_Maker]:
    if text.lstrip().startswith(b"{"):
        return _makers(read_json(text, name), name)

    def maker(of: Any) -> _Maker:
        return lambda row: polygon_of_wkt(text, of, row)

    return list(map(maker, texts_of_wkt(text, name)))


def _makers(geometry: Any, name: str) -> list[_Maker]:
    try:
        return list(map(_maker, geometries(geometry)))
    except RecursionError:
        raise InputError(INVALID_ARGUMENT, f"{name}: this is nested too deeply") from None


def _maker(source: Any) -> _Maker:
    return lambda row: make(row, source)


def _made(maker: _Maker, name: str) -> Union[Polygon, Error]:
    try:
        return maker(name).polygon
    except Error as error:
        return error

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""All polygons of Well-Known Text and of GeoJSON."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from ._ffi import PARSE, InputError
from ._named import NamedPolygon, Reading, make

_TAG = re.compile(
    rb"[\s,;]*(?P<multi>MULTI|)(?P<kind>POLYGON|POINT|LINESTRING|GEOMETRYCOLLECTION)"
    rb"\s*(?P<elevation>(?:ZM|Z|M)?)\s*(?:(?P<open>\()|(?P<empty>EMPTY\b))",
    re.IGNORECASE,
)
_BRACKET = re.compile(rb"[()]")


class _Text(NamedTuple):
    """Where the text of a polygon is: that of its rings, which the tag goes before."""

    tag: bytes
    start: int
    stop: int


def polygons_of_wkt(text: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of all geometries of a text, one after the other.

    Collections may have segments and points too, as regions have: these are left out.
    """
    texts = list(_texts(text, 0, len(text), alone=True))
    return [
        _polygon_of_wkt(text, one, name)
        for one, name in zip(texts, _names(reading.file, len(texts)))
    ]


def _polygon_of_wkt(text: bytes, of: _Text, name: str) -> NamedPolygon:
    rings = text[of.start : of.stop]
    try:
        return make(name, of.tag + rings)
    except InputError as error:
        if error.status != PARSE:
            raise
        # With as much before it as in the file, so that the message has the number of the byte.
        return make(name, of.tag.ljust(of.start) + rings)


def _texts(text: bytes, start: int, end: int, *, alone: bool) -> Iterator[_Text]:
    """The polygons from start to end; those that stand alone are not in a collection.

    What is no geometry is given as it is: whoever reads it says what is wrong.
    """
    while text[start:end].strip():
        tag = _TAG.match(text, start, end)
        if not tag or (alone and tag["kind"].upper() in (b"POINT", b"LINESTRING")):
            yield _Text(b"", start, end)
            return
        start = tag.end()
        if tag["empty"]:
            continue
        opening, start = start - 1, _closing(text, start, end)
        if tag["kind"].upper() == b"GEOMETRYCOLLECTION":
            yield from _texts(text, opening + 1, start - 1, alone=False)
        elif tag["kind"].upper() == b"POLYGON":
            name = b"POLYGON" + tag["elevation"]
            if not tag["multi"]:
                yield _Text(name, opening, start)
                continue
            part = opening + 1
            while (bracket := text.find(b"(", part, start)) >= 0:
                part = _closing(text, bracket + 1, start)
                yield _Text(name, bracket, part)


def _closing(text: bytes, start: int, end: int) -> int:
    """Where what was opened before start is closed; the end where it is not."""
    depth = 1
    for bracket in _BRACKET.finditer(text, start, end):
        depth += 1 if bracket[0] == b"(" else -1
        if depth == 0:
            return bracket.end()
    return end


def polygons_of_geojson(text: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of a geometry, of a Feature, or of a collection of these.

    Collections may have other geometries too: these are left out.
    """
    try:
        geometry = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise InputError(PARSE, f"{reading.file}: GeoJSON text: {error}") from None
    sources = list(_geometries(geometry, alone=True))
    return [make(name, one) for one, name in zip(sources, _names(reading.file, len(sources)))]


_MEMBERS = {"FeatureCollection": "features", "GeometryCollection": "geometries"}
_WITHOUT_AREA = {"Point", "MultiPoint", "LineString", "MultiLineString"}


def _geometries(source: Any, *, alone: bool) -> Iterator[Any]:
    """The polygons of a source; what is none is given as it is, for whoever reads it."""
    kind = source.get("type") if isinstance(source, Mapping) else None
    if not isinstance(kind, str):
        yield source
        return
    members = source.get(_MEMBERS.get(kind))
    if isinstance(members, list):
        for member in members:
            yield from _geometries(member, alone=False)
    elif kind == "Feature":
        if source.get("geometry") is not None:
            yield from _geometries(source["geometry"], alone=alone)
    elif kind == "MultiPolygon" and isinstance(source.get("coordinates"), list):
        for rings in source["coordinates"]:
            yield {"type": "Polygon", "coordinates": rings}
    elif alone or kind not in _WITHOUT_AREA:
        yield source


def _names(file: str, count: int) -> list[str]:
    """The names of the polygons of a file."""
    return [f"{file}: polygon {k}" if count > 1 else f"{file}: polygon" for k in range(count)]

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""All polygons of Well-Known Text and of GeoJSON."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple, Optional

from ._ffi import PARSE, InputError
from ._geometries import is_empty
from ._named import NUMBER, NamedPolygon, Reading, make
from ._texts import read_json

_TAG = re.compile(
    rb"\s*(?P<multi>MULTI|)(?P<kind>POLYGON|POINT|LINESTRING|(?<!MULTI)GEOMETRYCOLLECTION)"
    rb"\s*(?P<elevation>(?:ZM|Z|M)?)\s*(?:(?P<open>\()|(?P<empty>EMPTY\b))",
    re.IGNORECASE,
)
_BETWEEN_GEOMETRIES = re.compile(rb"[\s,;]*")
_PART = re.compile(rb"\s*(?:(?P<open>\()|EMPTY\b)", re.IGNORECASE)
_NEXT = re.compile(rb"\s*([,)])")
_BRACKET = re.compile(rb"[()]")
_ELEVATION = rf"(?:{NUMBER}|nan|NaN)"
_VERTEX = re.compile(rf"\s*{NUMBER}\s+{NUMBER}(?:\s+{_ELEVATION}){{0,2}}(?=\s*[,)])".encode())


class Text(NamedTuple):
    """Where the text of a polygon is: that of its rings, which the tag goes before."""

    tag: bytes
    start: int
    stop: int


def polygons_of_wkt(text: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of all geometries of a text, one after the other.

    Collections may have segments and points too, as regions have: these are left out.
    """
    texts = texts_of_wkt(text, reading.file)
    return [
        polygon_of_wkt(text, one, name)
        for one, name in zip(texts, _names(reading.file, len(texts)))
    ]


def texts_of_wkt(text: bytes, file: str) -> list[Text]:
    """Where the polygons of all geometries of a text are, which messages call by that name."""
    return list(_Reader(text, file).texts())


def polygon_of_wkt(text: bytes, of: Text, name: str) -> NamedPolygon:
    """The polygon at a place of a text, whose errors have that name."""
    rings = text[of.start : of.stop]
    try:
        return make(name, of.tag + rings)
    except InputError as error:
        if error.status != PARSE:
            raise
        # With as much before it as in the file, so that the message has the number of the byte.
        return make(name, of.tag.ljust(of.start) + rings)


class _Reader:
    """What goes through a text, and finds the polygons in it.

    A text that should be that of a polygon is given as it is: whoever reads it says what is
    wrong.
    """

    def __init__(self, text: bytes, file: str) -> None:
        self._text, self._file = text, file
        self._place = 0

    def texts(self) -> Iterator[Text]:
        """The polygons of all geometries, one after the other."""
        depth = 0  # of collections
        while True:
            if depth == 0:
                self._take(_BETWEEN_GEOMETRIES)
                if self._place == len(self._text):
                    return
            tag = _TAG.match(self._text, self._place)
            kind = tag["kind"].upper() if tag else b""
            if depth == 0 and kind not in (b"POLYGON", b"GEOMETRYCOLLECTION"):
                yield Text(b"", self._place, len(self._text))
                return
            if not tag:
                raise self._expected("a geometry")
            self._place = tag.end()
            if tag["open"] and kind == b"GEOMETRYCOLLECTION":
                depth += 1
                continue
            if tag["open"]:
                yield from self._geometry(tag)
            while depth > 0 and not self._goes_on():
                depth -= 1

    def _geometry(self, tag: re.Match[bytes]) -> Iterator[Text]:
        """The polygons of a geometry that has just been opened."""
        is_polygon = tag["kind"].upper() == b"POLYGON"
        name = b"POLYGON" + tag["elevation"]
        if not tag["multi"]:
            if is_polygon:
                yield self._polygon(name)
            else:
                self._vertices()
            return
        if tag["kind"].upper() == b"POINT" and not _PART.match(self._text, self._place):
            self._vertices()
            return
        while True:
            part = self._take(_PART)
            if not part:
                raise self._expected("'('")
            if part["open"]:
                if is_polygon:
                    yield self._polygon(name)
                else:
                    self._vertices()
            if not self._goes_on():
                return

    def _polygon(self, name: bytes) -> Text:
        start = self._place - 1
        self._place = _closing(self._text, self._place)
        return Text(name, start, self._place)

    def _vertices(self) -> None:
        while True:
            if not self._take(_VERTEX):
                raise self._expected("a vertex")
            if not self._goes_on():
                return

    def _goes_on(self) -> bool:
        """Whether a comma is next, and not what closes a list."""
        found = self._take(_NEXT)
        if not found:
            raise self._expected("',' or ')'")
        return found[1] == b","

    def _take(self, pattern: re.Pattern[bytes]) -> Optional[re.Match[bytes]]:
        found = pattern.match(self._text, self._place)
        if found:
            self._place = found.end()
        return found

    def _expected(self, what: str) -> InputError:
        rest = self._text[self._place :]
        place = len(self._text) - len(rest.lstrip())
        return InputError(PARSE, f"{self._file}: byte {place}: expected {what}")


def _closing(text: bytes, start: int) -> int:
    """Where what was opened before start is closed; the end where it is not."""
    depth = 1
    for bracket in _BRACKET.finditer(text, start):
        depth += 1 if bracket[0] == b"(" else -1
        if depth == 0:
            return bracket.end()
    return len(text)


def polygons_of_geojson(text: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of a geometry, of a Feature, or of a collection of these.

    Collections may have other geometries too: these are left out.
    """
    sources = list(geometries(read_json(text, reading.file)))
    return [make(name, one) for one, name in zip(sources, _names(reading.file, len(sources)))]


_MEMBERS = {"FeatureCollection": "features", "GeometryCollection": "geometries"}
_WITHOUT_AREA = {"Point", "MultiPoint", "LineString", "MultiLineString"}
_LISTS = (list, tuple)


def geometries(source: Any, *, alone: bool = True) -> Iterator[Any]:
    """The polygons of a source; what is none is given as it is, for whoever reads it.

    alone: whether it is in no collection. What has no area, or is empty, is left out in one.
    """
    kind = source.get("type") if isinstance(source, Mapping) else None
    if not isinstance(kind, str):
        yield source
        return
    members = source.get(_MEMBERS.get(kind))
    if isinstance(members, _LISTS):
        for member in members:
            yield from geometries(member, alone=False)
    elif kind == "Feature":
        if source.get("geometry") is not None:
            yield from geometries(source["geometry"], alone=alone)
    elif kind == "MultiPolygon" and isinstance(source.get("coordinates"), _LISTS):
        for rings in source["coordinates"]:
            yield from geometries({"type": "Polygon", "coordinates": rings}, alone=False)
    elif alone or not (kind in _WITHOUT_AREA or is_empty(source.get("coordinates"))):
        yield source


def _names(file: str, count: int) -> list[str]:
    """The names of the polygons of a file."""
    return [f"{file}: polygon {k}" if count > 1 else f"{file}: polygon" for k in range(count)]

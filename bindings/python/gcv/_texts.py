# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Text that says a polygon: GeoJSON, and Well-Known Text as the library reads it."""

from __future__ import annotations

import codecs
import json
import re
from array import array
from pathlib import Path
from typing import Any, Optional, Union

from ._coordinates import Rings, invalid
from ._ffi import PARSE, InputError
from ._geometries import not_one_geometry

_DIMENSIONS = rb"\s*(?:ZM|Z|M)?\s*"
_COLLECTIONS = re.compile(rb"(?:\s*GEOMETRYCOLLECTION" + _DIMENSIONS + rb"\()+", re.IGNORECASE)
_KIND = re.compile(rb"([A-Z]{5,}?)" + _DIMENSIONS + rb"(?:\(|EMPTY)", re.IGNORECASE)
_MULTIPOLYGON = re.compile(
    rb"\s*(MULTI)POLYGON" + _DIMENSIONS + rb"(?:(\((?:\s*EMPTY\s*,)*)|EMPTY\s*$)", re.IGNORECASE
)
_EMPTY_PARTS_AT_THE_END = re.compile(rb"(?:,\s*EMPTY\s*)+$", re.IGNORECASE)


def text_of(source: Union[str, bytes, bytearray, Path]) -> bytes:
    """The text, or that of a file, in UTF-8, without a mark that says so."""
    if isinstance(source, Path):
        source = source.read_bytes()
    text = source.encode(errors="replace") if isinstance(source, str) else bytes(source)
    if text.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        raise InputError(PARSE, "polygon: text in UTF-16, not UTF-8")
    return text[len(codecs.BOM_UTF8) :] if text.startswith(codecs.BOM_UTF8) else text


def geometry_of_text(text: bytes) -> Optional[Any]:
    """What GeoJSON text says; None for text of another kind."""
    if not text.lstrip().startswith(b"{"):
        return None
    return read_json(text, "polygon")


def read_json(text: bytes, name: str) -> Any:
    """What GeoJSON text of that name says."""
    try:
        return json.loads(text)
    except ValueError as error:
        reason = str(error)
    except RecursionError:
        reason = "it is nested too deeply"
    raise InputError(PARSE, f"{name}: GeoJSON text: {reason}")


def of_one_part(text: bytes) -> bytes:
    """Well-Known Text of a collection, or of a MULTIPOLYGON, of one polygon as that of it.

    Every other byte stays where it is, with blanks for what goes, as empty parts of a
    MULTIPOLYGON do. Raises InputError for other numbers of polygons.
    """
    around = _COLLECTIONS.match(text)
    if around:
        text = _bare(text, 0, around.end(), around[0].count(b"("))
        kinds = [kind.decode().upper() for kind in _KIND.findall(text)]
        if len(kinds) != 1:
            raise not_one_geometry(kinds)
    tag = _MULTIPOLYGON.match(text)
    if not tag:
        return text
    parts = len(re.findall(rb"\(\s*\(", text[tag.end() :])) if tag[2] else 0
    if parts != 1:
        raise invalid(f"a MultiPolygon of {parts} parts is not one polygon")
    text = _bare(text, *tag.span(2), 1)
    without = _EMPTY_PARTS_AT_THE_END.search(text)
    text = text[: without.start()] if without else text
    return text[: tag.start(1)] + b" " * len(tag[1]) + text[tag.end(1) :]


def _bare(text: bytes, start: int, stop: int, brackets: int) -> bytes:
    """The text with blanks for that from start to stop, and for so many of its last brackets."""
    text = text[:start] + b" " * (stop - start) + text[stop:]
    for _ in range(brackets):
        before, bracket, after = text.rpartition(b")")
        text = before + b" " * len(bracket) + after
    return text


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

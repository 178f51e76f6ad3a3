# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What the program reads: polygons, and tables of points."""

from __future__ import annotations

import errno
import math
import os
import re
import sys
from codecs import BOM_UTF8
from typing import Callable, Optional

from ._coordinates import Points
from ._dxf_files import polygons_of_dxf
from ._named import NUMBER, NamedPolygon, Reading, invalid
from ._svg_files import polygons_of_svg
from ._text_files import polygons_of_geojson, polygons_of_wkt

STANDARD_INPUT = "-"
_PAIR = re.compile(rf"({NUMBER})(?:\s*,\s*|\s+)({NUMBER})")


def read_polygons(
    file: str, flatten: Optional[float], note: Callable[[str], None], *, or_none: bool = False
) -> list[NamedPolygon]:
    """All polygons of a file; whether it is WKT, GeoJSON, SVG or DXF is told by its bytes.

    flatten: how far lines may be from curves; None where there may be none. note is told
    in a sentence of what the file has beside polygons. or_none: whether geometries without a
    polygon will do, such as a MULTIPOLYGON EMPTY.

    Raises InputError where there is no polygon, or one that is none; OSError where the
    file cannot be read.
    """
    name, data = name_of(file), _read(file)
    reading = Reading(name, flatten, note)
    read = _reader_of(data, name)
    try:
        polygons = read(data, reading)
    except RecursionError:
        raise invalid(name, "this is nested too deeply") from None
    # A drawing without polygons is more likely one of what is not read.
    empty = or_none and bool(data.strip()) and read in (polygons_of_geojson, polygons_of_wkt)
    if not polygons and not empty:
        raise invalid(name, "there is no polygon in this file")
    return polygons


def _reader_of(data: bytes, name: str) -> Callable[[bytes, Reading], list[NamedPolygon]]:
    start = data[:64].lstrip()
    if start.startswith(b"{"):
        return polygons_of_geojson
    if start.startswith(b"<"):
        return polygons_of_svg
    # The first group code of a drawing is that of a section or of a comment.
    first_line = start.splitlines()[0].strip() if start else b""
    if start.startswith(b"AutoCAD Binary DXF") or first_line in (b"0", b"999"):
        return polygons_of_dxf
    if re.match(NUMBER.encode(), start):
        reason = "these are numbers, and neither Well-Known Text, GeoJSON, SVG nor DXF"
        raise invalid(name, reason)
    return polygons_of_wkt


def read_points(file: str) -> Points:
    """The points of a table: on each line an x and a y, with a comma or blanks between.

    Empty lines are left out, and what begins with a #.
    """
    name, data = name_of(file), _read(file)
    points: Points = []
    for number, line in enumerate(data.decode(errors="replace").splitlines(), 1):
        words = line.partition("#")[0].strip()
        if words:
            pair = _PAIR.fullmatch(words)
            point = (float(pair[1]), float(pair[2])) if pair else (math.nan, math.nan)
            if not all(map(math.isfinite, point)):
                raise invalid(name, f"line {number}: '{line.strip()}' is not a pair of numbers")
            points.append(point)
    if not points:
        raise invalid(name, "there is no point in this table")
    return points


def name_of(file: str) -> str:
    """What messages call a file."""
    return "standard input" if file == STANDARD_INPUT else file


def _read(file: str) -> bytes:
    if file != STANDARD_INPUT:
        with open(file, "rb") as opened:
            data = opened.read()
    elif sys.stdin is None:
        raise OSError(errno.EBADF, os.strerror(errno.EBADF), name_of(file))
    else:
        data = sys.stdin.buffer.read()
    return data[len(BOM_UTF8) :] if data.startswith(BOM_UTF8) else data

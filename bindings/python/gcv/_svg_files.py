# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons of SVG drawings, which svgelements reads."""

from __future__ import annotations

import io
import math
import re
from collections import Counter
from collections.abc import Iterator
from typing import Any, Optional
from xml.etree import ElementTree

from ._coordinates import Points
from ._named import NUMBER, NamedPolygon, Reading, curve, invalid, package, too_fine
from ._nested_rings import Ring, polygons_of_rings

_NUMBERS = {"Z": 0, "H": 1, "V": 1, "M": 2, "L": 2, "T": 2, "Q": 4, "S": 4, "C": 6, "A": 7}
"""How many numbers each command of path data takes."""
_LEAST_LINES = 2
"""A curve has at least as many lines in its place, so that some of its area stays."""
_MOST_LINES = 1_000_000
_NOT_DRAWN = {"marker", "mask", "pattern", "symbol"}


def polygons_of_svg(text: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of all shapes that are drawn, in the units of the drawing.

    y points up: a point (x, y) of the drawing is (x, -y). Rings of a path are holes by
    its fill-rule. An open path is closed, as where SVG fills it.
    """
    svgelements = package("svgelements", "svg", reading.file)
    polygons, left_out = [], Counter[str]()
    for element in _elements(svgelements, text, reading.file):
        kind = element.values.get("tag", "")
        if isinstance(element, svgelements.Shape):
            name = _name(reading.file, kind, element.id)
            rings = list(_rings(svgelements, svgelements.Path(element), name, reading))
            rule = element.values.get("fill-rule", "nonzero")
            polygons += polygons_of_rings(rings, nonzero=rule == "nonzero")
            left_out[kind] += not rings
        elif isinstance(element, (svgelements.Text, svgelements.Image)):
            left_out[kind] += 1
    reading.leave_out(left_out)
    return polygons


def _elements(svgelements: Any, text: bytes, file: str) -> list[Any]:
    try:
        root = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError) as error:
        raise invalid(file, f"SVG: {error}") from None
    # The units of the drawing, and not those of the page that it is shown on.
    for name in ("width", "height", "viewBox"):
        root.attrib.pop(name, None)
    for element in list(root.iter()):
        _check_data(element, file)
        _hide_what_is_not_drawn(element)
    try:
        drawing = svgelements.SVG.parse(io.BytesIO(ElementTree.tostring(root)), reify=True)
        return list(drawing.elements())
    except Exception as error:  # whatever a damaged drawing leads to
        raise invalid(file, f"SVG: {error}") from None


def _name(file: str, kind: str, identifier: Optional[str]) -> str:
    """What a message calls an element."""
    return f"{file}: {kind} '{identifier}'" if identifier else f"{file}: {kind}"


def _tag(element: ElementTree.Element) -> tuple[str, str]:
    """The name space of an element and its kind."""
    space, brace, kind = str(element.tag).rpartition("}")
    return space + brace, kind


def _hide_what_is_not_drawn(element: ElementTree.Element) -> None:
    """Put symbols and their like among the definitions, which are drawn by use alone."""
    for k, child in enumerate(element):
        space, kind = _tag(child)
        if kind in _NOT_DRAWN:
            element[k] = ElementTree.Element(f"{space}defs")
            element[k].append(child)


def _check_data(element: ElementTree.Element, file: str) -> None:
    """Raise InputError for path data and points that are not whole.

    Programs that draw them stop there without a word.
    """
    _, kind = _tag(element)
    name = _name(file, kind, element.get("id"))
    if kind == "path":
        _check_path_data(element.get("d", ""), name)
    elif kind in ("polygon", "polyline") and not _is_numbers(element.get("points", ""), 2):
        raise invalid(name, "the points are not pairs of numbers")


def _check_path_data(data: str, name: str) -> None:
    start, *commands = re.split(r"([A-DF-Za-df-z])", data)
    for command, numbers in zip(commands[::2], commands[1::2]):
        count = _NUMBERS.get(command.upper())
        # The flags of an arc need no blanks after them.
        fits = count is not None and (count == 7 or _is_numbers(numbers, count))
        if not fits:
            raise invalid(name, f"'{command}{numbers.rstrip()}' is no command of path data")
    if start.strip():
        raise invalid(name, f"'{start.strip()}' is no command of path data")


def _is_numbers(text: str, count: int) -> bool:
    """Whether a text is numbers, a multiple of so many."""
    if re.sub(NUMBER, "", text).strip(" \t\r\n\f,"):
        return False
    numbers = len(re.findall(NUMBER, text))
    return numbers % count == 0 if count else numbers == 0


def _rings(svgelements: Any, path: Any, name: str, reading: Reading) -> Iterator[Ring]:
    """The rings of a path; what has less than three points has no area, and is left out."""
    subpaths = list(path.as_subpaths())
    for k, subpath in enumerate(subpaths):
        points: Points = []
        for segment in subpath:
            if isinstance(segment, (svgelements.Move, svgelements.Line, svgelements.Close)):
                steps = 1
            elif reading.flatten is None:
                raise curve(name)
            else:
                steps = _steps(svgelements, segment, name, reading.flatten)
            points += [_point(segment.point(step / steps)) for step in range(1, steps)]
            if segment.end is not None:
                points.append(_point(segment.end))
        if len(set(points)) > 2:
            yield Ring(f"{name}, ring {k}" if len(subpaths) > 1 else name, points)


def _point(point: Any) -> tuple[float, float]:
    return float(point.x), 0.0 - float(point.y)


def _steps(svgelements: Any, segment: Any, name: str, distance: float) -> int:
    """How many lines are within the distance of a segment."""
    if isinstance(segment, svgelements.Arc):
        radius, sweep = float(max(segment.rx, segment.ry)), float(segment.sweep)
        angle = 4 * math.asin(math.sqrt(min(distance / radius, 1) / 2)) if radius > 0 else math.pi
        lines = abs(sweep) / angle
    else:
        # A curve of degree n is within n (n - 1) / 8 of the largest second difference of its
        # control points, over the square of the number of lines.
        points = [complex(p.x, p.y) for p in segment if p is not None]
        degree = len(points) - 1
        bend = max(abs(a - 2 * b + c) for a, b, c in zip(points, points[1:], points[2:]))
        lines = math.sqrt(degree * (degree - 1) / 8 * (bend / distance))
    if lines > _MOST_LINES:
        raise too_fine(name)
    return max(_LEAST_LINES, math.ceil(lines))

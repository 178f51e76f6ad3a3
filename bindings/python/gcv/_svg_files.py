# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons of SVG drawings, which svgelements reads."""

from __future__ import annotations

import io
import math
from collections import Counter
from collections.abc import Iterator
from typing import Any
from xml.etree import ElementTree

from ._named import NamedPolygon, Reading, curve, invalid, package, too_fine
from ._nested_rings import Ring, polygons_of_rings
from ._svg_checks import check, name_of

_LEAST_LINES = 2
"""A curve has at least as many lines in its place, so that some of its area stays."""
_MOST_LINES = 1_000_000


def polygons_of_svg(text: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of all shapes that are drawn, in the units of the drawing.

    y points up: a point (x, y) of the drawing is (x, -y). Rings of a path are holes by
    its fill-rule. An open path is closed, as where SVG fills it.
    """
    svgelements = package("svgelements", "SVG", reading.file)
    polygons, left_out = [], Counter[str]()
    for element in _elements(svgelements, text, reading.file, left_out):
        kind = element.values.get("tag", "")
        if isinstance(element, svgelements.Shape):
            name = name_of(reading.file, kind, element.id)
            rings = list(_rings(svgelements, element, name, reading))
            rule = element.values.get("fill-rule", "nonzero")
            polygons += polygons_of_rings(rings, nonzero=rule == "nonzero")
            left_out[kind] += not rings
        elif isinstance(element, (svgelements.Text, svgelements.Image)):
            left_out[kind] += 1
    reading.leave_out(left_out)
    return polygons


def _elements(svgelements: Any, text: bytes, file: str, left_out: Counter[str]) -> list[Any]:
    try:
        root = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError) as error:
        raise invalid(file, f"SVG: {error}") from None
    check(root, file, left_out)
    # The units of the drawing, and not those of the page that it is shown on.
    for name in ("width", "height", "viewBox"):
        root.attrib.pop(name, None)
    try:
        drawing = svgelements.SVG.parse(io.BytesIO(ElementTree.tostring(root)), reify=False)
        return list(drawing.elements())
    except RecursionError:
        raise invalid(file, "SVG: this is nested too deeply, or uses itself") from None
    except Exception as error:  # whatever a damaged drawing leads to
        raise invalid(file, f"SVG: {error}") from None


def _rings(svgelements: Any, shape: Any, name: str, reading: Reading) -> Iterator[Ring]:
    """The rings of a shape; what has less than three points has no area, and is left out.

    Its curves become lines before it is transformed: svgelements cannot skew arcs.
    """
    matrix = shape.transform
    finest = reading.flatten and reading.flatten / _stretch(matrix)
    path = svgelements.Path(*shape.segments(transformed=False))
    subpaths = list(path.as_subpaths())
    for k, subpath in enumerate(subpaths):
        found: list[Any] = []
        for segment in subpath:
            if isinstance(segment, (svgelements.Move, svgelements.Line, svgelements.Close)):
                steps = 1
            elif finest is None:
                raise curve(name)
            else:
                steps = _steps(svgelements, segment, name, finest)
            found += [segment.point(step / steps) for step in range(1, steps)]
            if segment.end is not None:
                found.append(segment.end)
        points = [_point(matrix.point_in_matrix_space(point)) for point in found]
        if len(set(points)) > 2:
            yield Ring(f"{name}, ring {k}" if len(subpaths) > 1 else name, points)


def _stretch(matrix: Any) -> float:
    """How much longer a matrix makes a vector, at most; 1 where it makes all of them nothing."""
    a, b, c, d = matrix.a, matrix.b, matrix.c, matrix.d
    return (math.hypot(a + d, b - c) + math.hypot(a - d, b + c)) / 2 or 1.0


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

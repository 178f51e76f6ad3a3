# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Shapes as text: Well-Known Text, fractions, GeoJSON, SVG."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, Callable, NamedTuple, Union

from ._coordinates import Points
from ._drawing import COLOURS, FIT_COLOUR
from ._ffi import INVALID_ARGUMENT, InputError
from ._outer_face import OuterFace
from ._polygon import Polygon, digits
from ._region import Region

Shape = Union[OuterFace, Polygon, Region]
_MARGIN = 0.025
"""Of a drawing, as a part of its size."""


class Result(NamedTuple):
    """A shape that the program has computed."""

    numbers: dict[str, int]
    """Of which polygons of their files it is made, where files have several."""
    shape: Shape
    error_bound: float


def wkt(results: Sequence[Result]) -> str:
    """A line for each shape; for a region a second one, of its segments and points."""
    lines = []
    for _, shape, _ in results:
        lines.append(shape.wkt)
        if isinstance(shape, Region):
            lines.append(shape.fits_wkt)
    return "\n".join(lines)


def exact(results: Sequence[Result]) -> str:
    """As wkt, but with the exact coordinates as fractions."""
    lines = []
    for _, shape, _ in results:
        if isinstance(shape, Region):
            polygons, fits = shape._exact_polygons_and_fits()
            lines.append(_tagged("MULTIPOLYGON", map(_rings_text, polygons)))
            lines.append(_tagged("GEOMETRYCOLLECTION", map(_fit_text, fits)))
        else:
            rings = [shape.exact] if isinstance(shape, OuterFace) else _fractions(shape)
            lines.append(f"POLYGON {_rings_text(rings)}")
    return "\n".join(lines)


def geojson(results: Sequence[Result]) -> str:
    """A Feature for each shape, in a FeatureCollection where there are several."""
    features = [
        {
            "type": "Feature",
            "properties": {**numbers, "error_bound": error_bound},
            "geometry": shape.__geo_interface__,
        }
        for numbers, shape, error_bound in results
    ]
    if len(features) == 1:
        return json.dumps(features[0])
    return json.dumps({"type": "FeatureCollection", "features": features})


def svg(results: Sequence[Result]) -> str:
    """A drawing in the units of the coordinates, with y up, from which they can be read.

    Raises InputError for what is larger than the largest float.
    """
    paths, shown = [], []
    for k, (_, shape, _) in enumerate(results):
        polygons, fits = polygons_and_fits(shape)
        colour = COLOURS[k % len(COLOURS)]
        paths += [
            f'<path fill="{colour}" d="{"".join(f"M{_path(ring)}Z" for ring in rings)}"/>'
            for rings in polygons
        ]
        # A point is a segment without length, and its round ends.
        paths += [
            f'<path stroke="{FIT_COLOUR}" stroke-width="{3 * (3 - len(ends))}" '
            f'd="M{_path([ends[0], ends[-1]])}"/>'
            for ends in fits
        ]
        shown += [point for rings in [*polygons, fits] for ring in rings for point in ring]
    xs, ys = zip(*(shown or [(0.0, 0.0)]))
    left, top = min(xs), max(ys)
    width, height = max(xs) - left, top - min(ys)
    size = max(width, height)
    margin = _MARGIN * (size or max(abs(left), abs(top), 1.0))  # of a point by itself
    if not math.isfinite(size + 2 * margin):
        raise InputError(INVALID_ARGUMENT, "SVG: a shape is larger than the largest float")
    box = (left - margin, -top - margin, width + 2 * margin, height + 2 * margin)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{" ".join(map(digits, box))}">\n'
        '<g transform="matrix(1 0 0 -1 0 0)" fill-rule="evenodd" fill-opacity="0.5" '
        'stroke="#333" stroke-linejoin="round" stroke-linecap="round">\n'
        + "".join(path.replace("/>", ' vector-effect="non-scaling-stroke"/>\n') for path in paths)
        + "</g>\n</svg>"
    )


FORMATS: dict[str, Callable[[Sequence[Result]], str]] = {
    "wkt": wkt,
    "geojson": geojson,
    "svg": svg,
    "exact": exact,
}


def polygons_and_fits(shape: Shape) -> tuple[list[list[Points]], list[Points]]:
    """The rings of each polygon, and the segments and points."""
    if isinstance(shape, Region):
        return shape._ring_points(), shape._fit_points()
    return [shape._ring_points()], []


def _path(points: Points) -> str:
    return "L".join(f"{digits(x)} {digits(y)}" for x, y in points)


def _fractions(polygon: Polygon) -> list[Any]:
    return [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in polygon._ring_points()]


def _tagged(tag: str, parts: Any) -> str:
    text = ", ".join(parts)
    return f"{tag} ({text})" if text else f"{tag} EMPTY"


def _rings_text(rings: Any) -> str:
    return f"({', '.join(_points_text([*ring, ring[0]]) for ring in rings)})"


def _fit_text(ends: Any) -> str:
    return f"{'LINESTRING' if len(ends) == 2 else 'POINT'} {_points_text(ends)}"


def _points_text(points: Any) -> str:
    return f"({', '.join(f'{x} {y}' for x, y in points)})"

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Pictures of polygons."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

Points = Sequence[tuple[float, float]]

_SIZE, _MARGIN = 400.0, 10.0
_COLOURS = ("#8da0cb", "#66c2a5", "#fc8d62")


def svg(polygons: Sequence[Sequence[Points]]) -> str:
    """An SVG picture of polygons, each upon those before it, to a common scale.

    A polygon is its rings: the outer one, and those of its holes.
    """
    outer = [point for rings in polygons for point in rings[0]]
    # Below 1, so that differences neither overflow nor vanish.
    _, exponent = math.frexp(max(abs(value) for point in outer for value in point))

    def scaled(value: float) -> float:
        return math.ldexp(value, -exponent)

    xs, ys = [scaled(x) for x, _ in outer], [scaled(y) for _, y in outer]
    left, top = min(xs), max(ys)
    columns, rows = max(xs) - left, top - min(ys)
    pixels = _SIZE / max(columns, rows)

    def path(ring: Points) -> str:
        return "L".join(
            f"{_MARGIN + (scaled(x) - left) * pixels:.2f} "
            f"{_MARGIN + (top - scaled(y)) * pixels:.2f}"
            for x, y in ring
        )

    width = 2 * _MARGIN + columns * pixels
    height = 2 * _MARGIN + rows * pixels
    paths = "".join(
        f'<path d="{"".join(f"M{path(ring)}Z" for ring in rings)}" fill-rule="evenodd" '
        f'fill="{_COLOURS[k % len(_COLOURS)]}" fill-opacity="0.5" '
        'stroke="#333" stroke-linejoin="round"/>'
        for k, rings in enumerate(polygons)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.2f} {height:.2f}">{paths}</svg>'
    )


def put_holes(patch: Any, rings: Sequence[Points]) -> None:
    """Put a patch with holes in the place of one without, in the same style."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    outlines = (Outline([*ring, ring[0]], closed=True) for ring in rings)
    hollow = PathPatch(Outline.make_compound_path(*outlines))
    hollow.update_from(patch)
    ax = patch.axes
    patch.remove()
    ax.add_patch(hollow)

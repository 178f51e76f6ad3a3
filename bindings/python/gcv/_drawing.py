# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Pictures of polygons, segments and points."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import chain
from typing import Any

Points = Sequence[tuple[float, float]]

_SIZE, _MARGIN = 400.0, 10.0
COLOURS = ("#8da0cb", "#66c2a5", "#fc8d62")
FIT_COLOUR = "#d7301f"
GROUND_COLOUR = "#f0f0f0"
_DOT = 3.0


def svg(
    layers: Sequence[Sequence[Points]],
    fits: Sequence[Points] = (),
    ground: Sequence[Points] = (),
) -> str:
    """An SVG picture of layers, each upon those before it, to a common scale.

    A layer is the rings of a polygon, or of several that do not overlap. The fits, upon
    all of them, are segments of two points and single points. The ground, below them, is
    the rings of a polygon that contains them.
    """
    shown = [*chain(*ground, *(ring for rings in layers for ring in rings), *fits)]
    if not shown:
        shown = [(0.0, 0.0)]
    # Below 1, so that differences neither overflow nor vanish.
    _, exponent = math.frexp(max(abs(value) for point in shown for value in point))

    def scaled(value: float) -> float:
        return math.ldexp(value, -exponent)

    xs, ys = [scaled(x) for x, _ in shown], [scaled(y) for _, y in shown]
    left, top = min(xs), max(ys)
    columns, rows = max(xs) - left, top - min(ys)
    pixels = _SIZE / (max(columns, rows) or 1)

    def place(point: tuple[float, float]) -> tuple[str, str]:
        x, y = (scaled(point[0]) - left) * pixels, (top - scaled(point[1])) * pixels
        return f"{_MARGIN + x:.2f}", f"{_MARGIN + y:.2f}"

    def path(ring: Points) -> str:
        return "L".join(" ".join(place(point)) for point in ring)

    def fit(ends: Points) -> str:
        if len(ends) == 2:
            return f'<path d="M{path(ends)}" stroke="{FIT_COLOUR}" stroke-width="2"/>'
        x, y = place(ends[0])
        return f'<circle cx="{x}" cy="{y}" r="{_DOT}" fill="{FIT_COLOUR}"/>'

    def area(rings: Sequence[Points], colour: str, opacity: float) -> str:
        return (
            f'<path d="{"".join(f"M{path(ring)}Z" for ring in rings)}" fill-rule="evenodd" '
            f'fill="{colour}" fill-opacity="{opacity}" stroke="#333" stroke-linejoin="round"/>'
        )

    width = 2 * _MARGIN + columns * pixels
    height = 2 * _MARGIN + rows * pixels
    paths = [area(rings, COLOURS[k % len(COLOURS)], 0.5) for k, rings in enumerate(layers) if rings]
    if ground:
        paths.insert(0, area(ground, GROUND_COLOUR, 1))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.2f} {height:.2f}">{"".join([*paths, *map(fit, fits)])}</svg>'
    )


def plot(rings: Sequence[Points], fits: Sequence[Points], ax: Any, style: dict[str, Any]) -> Any:
    """Draw a layer and fits, as svg does, on axes of matplotlib, and return these."""
    if ax is None:
        from matplotlib import pyplot

        ax = pyplot.gca()
        ax.set_aspect("equal")
    if rings:
        (patch,) = ax.fill(*zip(*rings[0]), **{"alpha": 0.5, "edgecolor": "black", **style})
        if len(rings) > 1:
            _put_all(patch, rings)
    for ends in fits:
        ax.plot(*zip(*ends), color=FIT_COLOUR, marker="" if len(ends) == 2 else "o")
    return ax


def _put_all(patch: Any, rings: Sequence[Points]) -> None:
    """Put a patch of all rings in the place of that of the first one, in the same style."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    outlines = (Outline([*ring, ring[0]], closed=True) for ring in rings)
    hollow = PathPatch(Outline.make_compound_path(*outlines))
    hollow.update_from(patch)
    hollow.set_zorder(patch.get_zorder())
    ax = patch.axes
    patch.remove()
    ax.add_patch(hollow)

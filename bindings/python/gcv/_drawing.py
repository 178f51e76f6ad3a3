# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Pictures of rings."""

from __future__ import annotations

import math
from collections.abc import Sequence

Points = Sequence[tuple[float, float]]

_SIZE, _MARGIN = 400.0, 10.0
_COLOURS = ("#8da0cb", "#66c2a5", "#fc8d62")


def svg(rings: Sequence[Points]) -> str:
    """An SVG picture of rings, each upon those before it, to a common scale."""
    # Below 1, so that differences neither overflow nor vanish.
    _, exponent = math.frexp(max(abs(value) for r in rings for point in r for value in point))
    scaled = [[(math.ldexp(x, -exponent), math.ldexp(y, -exponent)) for x, y in r] for r in rings]
    xs = [x for ring in scaled for x, _ in ring]
    ys = [y for ring in scaled for _, y in ring]
    left, top = min(xs), max(ys)
    columns, rows = max(xs) - left, top - min(ys)
    pixels = _SIZE / max(columns, rows)

    def path(ring: Points) -> str:
        return "L".join(
            f"{_MARGIN + (x - left) * pixels:.2f} {_MARGIN + (top - y) * pixels:.2f}"
            for x, y in ring
        )

    width = 2 * _MARGIN + columns * pixels
    height = 2 * _MARGIN + rows * pixels
    paths = "".join(
        f'<path d="M{path(ring)}Z" fill="{_COLOURS[k % len(_COLOURS)]}" fill-opacity="0.5" '
        'stroke="#333" stroke-linejoin="round"/>'
        for k, ring in enumerate(scaled)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.2f} {height:.2f}">{paths}</svg>'
    )

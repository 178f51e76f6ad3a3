# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws regions with holes and exact fits: docs/regions.

In each picture A stays where it is. What is drawn round it is where the origin of B may not
go, or may go for an inner fit. Coordinates are multiples of 1/64, so that fits are exact.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy
import numpy.typing
from gallery_style import INK, PURPLE, STYLE_A, STYLE_B, STYLE_FREE, STYLE_SUM, arrange
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import gcv

Points = list[tuple[float, float]]

FEW = 4  # holes that B is drawn in
FINE = 500  # vertices of a region that is drawn as it is; of larger ones the holes, finely


class Example(NamedTuple):
    name: str
    a: gcv.Polygon
    b: gcv.Polygon
    region: gcv.Region
    is_free: bool
    """Whether B may be in the region, as in an inner fit; or else outside of it."""


def no_fit(name: str, a: gcv.Polygon, b: gcv.Polygon) -> Example:
    return Example(name, a, b, gcv.no_fit_region(a, b), is_free=False)


def examples() -> list[Example]:
    return [peg(), keyholes(), combs(), jigsaw(), sheet()]


# ----------------------------------------------------------------------- the examples --


def peg() -> Example:
    """A slot, turned by an angle whose tangent is 3/4, and a peg of its width."""
    turn = [[4, -3, 0], [3, 4, 0]]
    slot = gcv.Polygon([(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)])
    bar = gcv.Polygon([(0, 0), (2, 0), (2, 3), (0, 3)])
    return no_fit("A peg in its slot", slot.affine(turn), bar.affine(turn))


def keyhole(radius: float, width: float, height: float, x: float, y: float) -> Points:
    """A circle round (x, y) on a bar."""
    angle = math.asin(width / 2 / radius)
    circle = [
        (radius * math.sin(t), -radius * math.cos(t))
        for t in (angle + k * (2 * math.pi - 2 * angle) / 24 for k in range(25))
    ]
    outline = [(-width / 2, -height), (width / 2, -height), *circle]
    return [(x + round(64 * px) / 64, y + round(64 * py) / 64) for px, py in outline]


def keyholes() -> Example:
    """A plate with a keyhole that is too small, one that fits, a large one, and a chamber."""
    holes = [
        keyhole(1.5, 1, 3, x=4, y=7),
        keyhole(2, 1.5, 4, x=10, y=7),
        keyhole(3, 2.5, 6, x=17, y=7),
    ]
    chamber = [(25, 9), (27, 9), (27, 2), (22, 2), (22, 9), (24, 9)]
    plate = gcv.Polygon([(0, 0), (29, 0), (29, 12), (25, 12), *chamber, (24, 12), (0, 12)], holes)
    return no_fit("Keyholes", plate, gcv.Polygon(keyhole(2, 1.5, 4, 0, 0)))


def comb(teeth: int) -> Points:
    points: Points = [(0, 0), (2.0 * teeth - 1, 0)]
    for k in reversed(range(teeth)):
        points += [(2 * k + 1, 5), (2 * k, 5), (2 * k, 1), (2 * k - 1, 1)]
    return points[:-1]


def combs() -> Example:
    """Two combs whose teeth are as wide as their gaps."""
    return no_fit("Combs that mesh", gcv.Polygon(comb(5)), -gcv.Polygon(comb(5)))


def jigsaw() -> Example:
    """Two pieces with one border in common."""
    border: Points = [(12, 0), (12, 5), (13, 5), (14, 4), (15, 4), (16, 5), (16, 7), (15, 8)]
    border += [(14, 8), (13, 7), (12, 7), (12, 12)]
    socket: Points = [(7, 12), (7, 11), (8, 10), (7, 9), (5, 9), (4, 10), (5, 11), (5, 12)]
    piece = gcv.Polygon([(0, 0), *border, *socket, (0, 12)])
    knob: Points = [(19, 12), (19, 13), (20, 14), (19, 15), (17, 15), (16, 14), (17, 13), (17, 12)]
    neighbour = gcv.Polygon([(24, 0), (24, 12), *knob, *border[::-1]])
    return no_fit("Pieces of a jigsaw", piece, neighbour.translated((-12, 0)))


def sheet() -> Example:
    """A sheet with flaws that no part may lie on, and two clamps with a part's width between."""
    outline = [(0, 0), (14, -2), (32, 0), (36, 12), (31, 23), (14, 22), (3, 24), (-2, 12)]
    flaws: list[Points] = [
        [(10, 9), (12, 8), (14, 10), (12, 12)],
        [(20, 0), (22, 0), (22, 7), (20, 7)],
        [(26, 1), (28, 1), (28, 7), (26, 7)],
        [(4, 17), (7, 17), (6, 20)],
        [(24, 15), (27, 14), (28, 17), (26, 18)],
    ]
    part = gcv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 5), (0, 5)])
    container = gcv.Polygon(outline, flaws)
    region = gcv.inner_fit_region(container, part)
    return Example("A part in a sheet with flaws", container, part, region, is_free=True)


# ----------------------------------------------------------------------- the pictures --


def regions(examples: Sequence[Example]) -> Figure:
    """Draw three examples a row, the widest pictures first."""
    figure = Figure()
    arrange(figure, [draw(figure.add_axes((0, 0, 1, 1)), example) for example in examples])
    return figure


def draw(ax: Axes, example: Example) -> Axes:
    a, b, region = example.a, example.b, example.region
    style = STYLE_FREE if example.is_free else STYLE_SUM
    # The region lies round A where it is not free, and inside it where it is.
    region.plot(ax, facecolor=style["facecolor"], edgecolor="none", alpha=None, zorder=0.8)
    a.plot(ax, **STYLE_A, alpha=None, linewidth=0.8, zorder=0.7 if example.is_free else 0.9)
    for x, y in places(example):
        b.translated((x, y)).plot(ax, **STYLE_B, alpha=0.8, linewidth=0.8)
        ax.plot(x, y, color=STYLE_B["edgecolor"], marker="o", markersize=3)
    before = len(ax.lines)
    width = 1.2 if len(region.vertices) <= FINE else 0.5
    region.plot(ax, facecolor="none", edgecolor=style["edgecolor"], alpha=None, linewidth=width)
    for line in ax.lines[before:]:
        line.set(color=PURPLE, linewidth=2.5, markersize=6, zorder=4)
    ax.autoscale_view()
    if len(region.vertices) > FINE:
        holes = numpy.concatenate([hole for polygon in region.polygons for hole in polygon.holes])
        (left, bottom), (right, top) = holes.min(axis=0), holes.max(axis=0)
        ax.set(xlim=(left, right), ylim=(bottom, top))
    ax.set(aspect="equal", anchor="N")
    ax.set_axis_off()
    ax.set_title(example.name, weight="bold", color=INK, pad=40)
    kind = "inner-fit" if example.is_free else "no-fit"
    for line_number, text in enumerate((f"the {kind} region:", counts(region))):
        ax.annotate(
            text,
            (0.5, 1),
            xycoords="axes fraction",
            xytext=(0, 24 - 14 * line_number),
            textcoords="offset points",
            ha="center",
            color=INK,
        )
    return ax


def counts(region: gcv.Region) -> str:
    """How many parts of each kind there are, in words."""
    return repr(region).removeprefix("<gcv.Region of ").removesuffix(">")


def places(example: Example) -> Points:
    """Where B is drawn: at a point, in the middle of a segment, and in a corner of each hole.

    Where B may be in the region, in a corner of each polygon instead. Not where there are
    too many of these.
    """
    region = example.region
    found: Points = [shown(point) for point in region.points[:1]]
    for start, end in region.segments[len(region.segments) // 2 :][:1]:
        found.append(shown((start + end) / 2))
    rings = [
        ring
        for polygon in region.polygons
        for ring in ([polygon.outer] if example.is_free else polygon.holes)
    ]
    return found + [shown(ring[0]) for ring in rings if len(rings) <= FEW]


def shown(point: numpy.typing.NDArray[numpy.float64]) -> tuple[float, float]:
    x, y = point.tolist()
    return x, y

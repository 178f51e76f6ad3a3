# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the pictures of the pages, each as SVG and as PNG.

docs/gallery is Fig. 9 of the paper, its nine pairs of polygons and their sums, with their
holes; docs/superset is its Fig. 8, the superset of one of them. docs/regions shows regions,
docs/witnesses how one is found. docs/relation, distance, penetration, cast and contacts show
questions about two polygons, docs/scenes those to a scene.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from itertools import dropwhile, takewhile
from pathlib import Path
from typing import NamedTuple

import gallery_contacts
import gallery_regions
import gallery_scenes
import gallery_witnesses
import matplotlib
from gallery_style import (
    BLUE,
    GREEN,
    INK,
    STYLE_A,
    STYLE_B,
    STYLE_SUM,
    VERMILION,
    arrange,
    place,
    save,
    size,
)
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

import gcv

ROOT = Path(__file__).resolve().parent.parent
PAIR_OF_SUPERSET = "fork"

KINDS = {
    gcv.EDGE_TRANSLATED: (BLUE, "translated edges:\nan edge of A at a vertex of B"),
    gcv.EDGE_CORNER: (VERMILION, "corner edges:\nan edge of B at a vertex of A"),
    gcv.EDGE_TRANSLATED_CORNER: (GREEN, "translated-corner edges:\none of A and one of B, merged"),
}

# A polygon that is this many times smaller than the other is drawn once more, magnified.
SMALL, MAGNIFICATION = 10, 5


class Operand(NamedTuple):
    """A polygon, its name, and its number of vertices, collinear ones too."""

    name: str
    polygon: gcv.Polygon
    vertices: int


class Pair(NamedTuple):
    name: str
    a: Operand
    b: Operand


# ------------------------------------------------------------------------- the pairs --


def read_pairs(folder: Path) -> list[Pair]:
    """Return the pairs of the first block of pairs.txt, where ~ marks substitutes."""
    lines = (folder / "pairs.txt").read_text().splitlines()
    block = takewhile(is_pair, dropwhile(lambda line: not is_pair(line), lines))
    return [
        Pair(
            name.strip("~") + ", with substitutes" * ("~" in name),
            read(folder / a),
            read(folder / b),
        )
        for name, a, b in map(str.split, block)
    ]


def is_pair(line: str) -> bool:
    return not line.startswith("#")


def read(file: Path) -> Operand:
    """Return the polygon of a file: one closed ring, with a comma for each vertex."""
    text = file.read_text()
    return Operand(file.stem, gcv.Polygon(text), text.count(","))


# ----------------------------------------------------------------------- the pictures --


def gallery(pairs: Sequence[Pair]) -> Figure:
    """Draw three pairs a row, the widest pictures first."""
    figure = Figure()
    arrange(figure, [draw_pair(figure.add_axes((0, 0, 1, 1)), pair) for pair in pairs])
    return figure


def draw_pair(ax: Axes, pair: Pair) -> Axes:
    """Draw A and B, and below them, to the same scale, A + B with its holes."""
    a, b = pair.a.polygon, pair.b.polygon
    (whole,) = gcv.minkowski_sum_region(a, b, leave_out="fits")
    width, height = size(whole)
    gap = width / 12
    operands = [(a, STYLE_A, scale) for scale in scales(a, b)]
    operands += [(b, STYLE_B, scale) for scale in scales(b, a)]
    tallest = max(scale * size(polygon)[1] for polygon, _, scale in operands)
    right = -gap
    for polygon, style, scale in operands:
        across, up = (scale * length for length in size(polygon))
        left, bottom = right + gap, height + gap + (tallest - up) / 2
        draw(ax, polygon, style, left, bottom, scale)
        if scale > 1:
            ax.text(
                left + across / 2,
                bottom - gap / 4,
                f"{scale} times larger",
                color=style["edgecolor"],
                size=8,
                ha="center",
                va="top",
            )
        right = left + across
    draw(ax, whole, STYLE_SUM, (right - width) / 2, 0)
    ax.set(xlim=(0, right), ylim=(0, height + gap + tallest), aspect="equal", anchor="N")
    ax.set_axis_off()

    ax.set_title(pair.name, weight="bold", color=INK, pad=54)
    captions = [
        (describe("A", pair.a), BLUE),
        (describe("B", pair.b), VERMILION),
        (f"A + B: {len(whole)} vertices{and_holes(whole)}", INK),
    ]
    for line, (text, colour) in enumerate(captions):
        ax.annotate(
            text,
            (0.5, 1),
            xycoords="axes fraction",
            xytext=(0, 38 - 14 * line),
            textcoords="offset points",
            ha="center",
            color=colour,
        )
    return ax


def superset(pair: Pair) -> Figure:
    """Draw A above B, and beside them, to the same scale, the superset and the outer face."""
    a, b = pair.a.polygon, pair.b.polygon
    face, edges = a + b, gcv.superset(a, b)
    left, bottom, right, top = face.polygon.bounds
    gap = (right - left) / 16
    (width_a, height_a), (width_b, height_b) = size(a), size(b)
    start = left - 1.5 * gap - max(width_a, width_b)
    xlim, ylim = (start - gap, right + gap), (bottom - gap, top + 3 * gap)
    figure = Figure((9, 9 * (ylim[1] - ylim[0]) / (xlim[1] - xlim[0])))
    ax = figure.add_axes((0, 0, 1, 1), xlim=xlim, ylim=ylim)
    ax.set_axis_off()

    draw(ax, a, STYLE_A, start, top + gap - height_a)
    ax.text(start, top + 1.25 * gap, describe("A", pair.a), color=BLUE)
    draw(ax, b, STYLE_B, start, bottom)
    ax.text(start, bottom + height_b + gap / 4, describe("B", pair.b), color=VERMILION)

    face.plot(ax, facecolor=STYLE_SUM["facecolor"], edgecolor="none", alpha=None)
    for kind, (colour, name) in KINDS.items():
        segments = [(edge.start, edge.end) for edge in edges if edge.source.kind == kind]
        label = f"{len(segments)} {name}"
        ax.add_collection(LineCollection(segments, colors=colour, linewidths=1, label=label))
    label = f"outer face: {len(face)} vertices"
    face.plot(ax, facecolor="none", edgecolor=INK, alpha=None, linewidth=1.2, zorder=3, label=label)
    title = f"{len(edges)} edges of the superset"
    ax.legend(title=title, loc="upper right", frameon=False, alignment="left", labelspacing=0.8)
    return figure


def scales(polygon: gcv.Polygon, other: gcv.Polygon) -> tuple[int, ...]:
    """Return the scales that a polygon is drawn at, beside the other."""
    small = SMALL * max(size(polygon)) < max(size(other))
    return (1, MAGNIFICATION) if small else (1,)


def and_holes(polygon: gcv.Polygon) -> str:
    holes = polygon.ring_count - 1
    return f", {holes} holes" if holes else ""


def describe(label: str, operand: Operand) -> str:
    return f"{label}: {operand.name}, {operand.vertices} vertices"


def draw(
    ax: Axes, polygon: gcv.Polygon, style: dict[str, str], x: float, y: float, scale: float = 1
) -> None:
    """Draw a polygon with the lower left corner of its box at (x, y)."""
    moved = place(ax, polygon, x, y, scale)
    polygon.plot(
        ax, alpha=None, linewidth=0.8, joinstyle="round", clip_on=False, transform=moved, **style
    )


def main() -> None:
    data = Path(os.environ.get("GCV_DATA_DIR", ROOT.parent / "shared" / "data"))
    if not (data / "pairs.txt").exists():
        sys.exit(f"gallery: no pairs.txt in {data}, the folder of the data (GCV_DATA_DIR)")
    pairs = read_pairs(data)
    matplotlib.rcdefaults()
    save(gallery(pairs), "gallery", ROOT / "docs")
    of_superset = next(pair for pair in pairs if pair.name == PAIR_OF_SUPERSET)
    save(superset(of_superset), "superset", ROOT / "docs")
    fork = gallery_regions.no_fit(
        "Two forks, closer", of_superset.a.polygon, -of_superset.b.polygon
    )
    shown = [fork, *gallery_regions.examples()]
    save(gallery_regions.regions(shown), "regions", ROOT / "docs")
    save(gallery_witnesses.example(), "witnesses", ROOT / "docs")
    save(gallery_scenes.example(), "scenes", ROOT / "docs")
    for name, draw in gallery_contacts.PICTURES.items():
        save(draw(), name, ROOT / "docs")


if __name__ == "__main__":
    main()

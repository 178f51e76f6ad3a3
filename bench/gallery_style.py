# SPDX-License-Identifier: LGPL-3.0-or-later
"""What the pictures of the gallery share: colours, places, and files."""

from __future__ import annotations

from pathlib import Path
from typing import Union

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import Affine2D, Transform

import gcv

# The palette of Okabe and Ito, which tells colours apart for colour-blind readers too.
BLUE, VERMILION, GREEN, PURPLE, INK = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#222222"
STYLE_A = {"facecolor": "#d6e8f4", "edgecolor": BLUE}
STYLE_B = {"facecolor": "#fae3d4", "edgecolor": VERMILION}
STYLE_SUM = {"facecolor": "#eeeeee", "edgecolor": INK}
STYLE_FREE = {"facecolor": "#cfe9e0", "edgecolor": GREEN}

COLUMNS = 3
CELL, CAPTION, GAP = 3.0, 0.8, 0.4  # inches: the width of a cell, the height of its caption
TALLEST = 1.35  # the height of a row, in widths of a cell, at most


def arrange(figure: Figure, cells: list[Axes]) -> None:
    """Lay pictures out in rows, the widest ones first."""
    cells.sort(key=height_for_width)
    rows = [cells[k : k + COLUMNS] for k in range(0, len(cells), COLUMNS)]
    heights = [min(max(map(height_for_width, row)), TALLEST) * CELL for row in rows]
    width, height = COLUMNS * (CELL + GAP) + GAP, sum(heights) + len(rows) * (CAPTION + GAP) + GAP
    figure.set_size_inches(width, height)
    top = height
    for row, row_height in zip(rows, heights):
        top -= GAP + CAPTION + row_height
        for column, ax in enumerate(row):
            left = GAP + column * (CELL + GAP)
            ax.set_position((left / width, top / height, CELL / width, row_height / height))


def height_for_width(ax: Axes) -> float:
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    return (top - bottom) / (right - left)


def size(shape: Union[gcv.Polygon, gcv.Region]) -> tuple[float, float]:
    left, bottom, right, top = shape.bounds
    return right - left, top - bottom


def place(ax: Axes, polygon: gcv.Polygon, x: float, y: float, scale: float = 1) -> Transform:
    """Return what moves the lower left corner of the box of a polygon to (x, y) on the axes."""
    left, bottom, _, _ = polygon.bounds
    return Affine2D().translate(-left, -bottom).scale(scale).translate(x, y) + ax.transData


def save(figure: Figure, name: str, folder: Path) -> None:
    """Write a picture, the same to the byte whenever it is drawn."""
    with matplotlib.rc_context({"svg.hashsalt": "gcv"}):
        figure.savefig(folder / f"{name}.svg", metadata={"Date": None, "Creator": None})
        figure.savefig(folder / f"{name}.png", dpi=110, metadata={"Software": None})

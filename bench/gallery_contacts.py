# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws questions about two polygons: docs/relation, distance, penetration, cast and contacts.

In each picture A stays where it is, and B is moved by a translation. What is drawn in purple is
the library's answer.
"""

from __future__ import annotations

from typing import Optional

from gallery_style import GREEN, INK, PURPLE, STYLE_A, STYLE_B, STYLE_FREE, arrange
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import gcv

Point = tuple[float, float]
Box = tuple[float, float, float, float]  # left, bottom, right, top

# A plate with a slot as wide as B, and a window.
PLATE = gcv.Polygon(
    [(0, 0), (13, 0), (13, 8), (4.5, 8), (4.5, 4), (2.5, 4), (2.5, 8), (0, 8)],
    [[(7, 1), (11.5, 1), (11.5, 6), (7, 6)]],
)
HOUSE = gcv.Polygon([(0, 0), (2, 0), (2, 1.5), (1, 2.5), (0, 1.5)])
WEDGE = gcv.Polygon([(0, 0), (9, 0), (6, 7), (0, 5)])
BRICK = gcv.Polygon([(0, 0), (4, 0), (4, 2), (0, 2)])
# A turn by an angle whose tangent is 9/40; its coordinates are rounded.
TURN = (40 / 41, -9 / 41), (9 / 41, 40 / 41)

ROUND_PLATE: Box = (-1.5, -1, 17.5, 9)
ABOVE_PLATE: Box = (-1.5, -1, 17.5, 11.5)
REACH, SLOPE = 0.5, 1e-9  # of the contacts that are drawn
NORMAL = 1.3  # the length of a normal


# ------------------------------------------------------------------------ the pictures --


def relations() -> Figure:
    """Apart, touching and overlapping, from outside and in a hole."""
    figure = Figure()
    cells = []
    for place, translation in {
        "outside": (14.5, 3),
        "at an edge": (13, 3),
        "on an edge": (12.25, 3),
        "in a hole": (8.25, 2.25),
        "at the edge of a hole": (9.5, 2.25),
        "on the edge of a hole": (6.25, 2.25),
    }.items():
        relation = gcv.relation(PLATE, HOUSE, translation)
        ax = cell(figure, relation.name, f"B is {place}", ROUND_PLATE)
        draw_pair(ax, PLATE, HOUSE, translation)
        cells.append(ax)
    arrange(figure, cells)
    return figure


def distances() -> Figure:
    """The points that are nearest, and the normal there."""
    figure = Figure()
    cells = []
    for name, a, translation in (
        ("An edge and a vertex", WEDGE, (10, 5)),
        ("Two vertices", WEDGE, (7.5, 7.5)),
        ("In a hole", PLATE, (8.5, 2.25)),
    ):
        separation = gcv.distance(a, HOUSE, translation)
        ax = cell(figure, name, f"distance {separation.distance:.3g}", ABOVE_PLATE)
        draw_pair(ax, a, HOUSE, translation)
        nearest = separation.nearest
        if nearest is not None:
            draw_line(ax, nearest.on_a, nearest.on_b)
            draw_contact(ax, nearest)
        cells.append(ax)
    arrange(figure, cells)
    return figure


def penetrations() -> Figure:
    """The shortest ways out, and those that leave out holes and exact fits."""
    figure = Figure()
    cells = []
    leave_out: gcv.LeaveOut
    for name, translation, leave_out in (
        ("Out of the plate", (12.25, 3), ()),
        ("Into a hole", (10.25, 2.25), ()),
        ("The same, without holes", (10.25, 2.25), "holes"),
        ("Into an exact fit", (2.75, 5), ()),
        ("The same, without fits", (2.75, 5), "fits"),
    ):
        escape = gcv.penetration(PLATE, HOUSE, translation, leave_out=leave_out)
        ax = cell(figure, name, f"depth {escape.depth:.3g}", ABOVE_PLATE)
        draw_pair(ax, PLATE, HOUSE, translation, escape.position)
        draw_way(ax, HOUSE, translation, escape.position)
        cells.append(ax)
    arrange(figure, cells)
    return figure


def casts() -> Figure:
    """Motions up to the first overlap."""
    figure = Figure()
    cells = []
    box = (-1.5, -1, 18.5, 13)
    for name, translation, motion in (
        ("Up to the first hit", (16, 9), (-8, -4)),
        ("Along a wall", (13, 9), (0, -9)),
        ("Down a slot of its width", (2.5, 10), (0, -8)),
    ):
        impact = gcv.cast(PLATE, HOUSE, translation, motion)
        hit = "hits" if impact.hit else "no hit"
        ax = cell(figure, name, f"{hit}, time {impact.time:.3g}", box)
        draw_pair(ax, PLATE, HOUSE, translation, impact.position)
        draw_way(ax, HOUSE, translation, impact.position)
        if impact.contact is not None:
            draw_contact(ax, impact.contact)
        cells.append(ax)
    arrange(figure, cells)
    return figure


def bricks() -> tuple[gcv.Polygon, gcv.Polygon]:
    """Two bricks, one on the other, both turned: their faces are parallel but for rounding."""
    rows = [[*TURN[0], 0.0], [*TURN[1], 2.0]]
    lower, upper = (BRICK.translated(by).affine(rows) for by in ((5, 0), (3, 2)))
    return lower, upper


def contacts() -> Figure:
    """All contacts within a distance, and what a slope is for."""
    figure = Figure()
    cells = []
    lower, upper = bricks()
    for name, a, b, translation, slope, box in (
        ("Within a distance", PLATE, HOUSE, (2.5, 4.25), 0.0, (-1, 1.5, 8, 9)),
        ("Two turned bricks", lower, upper, (0.0, 0.0), 0.0, (0, 2, 9, 9.5)),
        ("The same with a slope", lower, upper, (0.0, 0.0), SLOPE, (0, 2, 9, 9.5)),
    ):
        found = gcv.contacts(a, b, translation, REACH, slope)
        ax = cell(figure, name, f"{len(found)} contact{'s' if len(found) != 1 else ''}", box)
        draw_pair(ax, a, b, translation)
        for contact in found:
            draw_contact(ax, contact)
        cells.append(ax)
    arrange(figure, cells)
    return figure


# --------------------------------------------------------------------------- the cells --


def cell(figure: Figure, name: str, text: str, box: Box) -> Axes:
    ax = figure.add_axes((0, 0, 1, 1))
    ax.set(xlim=(box[0], box[2]), ylim=(box[1], box[3]), aspect="equal", anchor="N")
    ax.set_axis_off()
    ax.set_title(name, weight="bold", color=INK, pad=24)
    ax.annotate(
        text,
        (0.5, 1),
        xycoords="axes fraction",
        xytext=(0, 8),
        textcoords="offset points",
        ha="center",
        color=INK,
    )
    return ax


def draw_pair(
    ax: Axes, a: gcv.Polygon, b: gcv.Polygon, start: Point, end: Optional[Point] = None
) -> None:
    """A, and B where it is; where it comes to, too, if it moves."""
    limits = ax.axis()
    a.plot(ax, **STYLE_A, alpha=None, linewidth=0.8)
    b.translated(start).plot(ax, **STYLE_B, alpha=0.8, linewidth=0.8)
    if end is not None:
        style = {**STYLE_FREE, "edgecolor": GREEN}
        b.translated(end).plot(ax, **style, alpha=0.8, linewidth=1.2)
    ax.axis(limits)


def draw_line(ax: Axes, start: Point, end: Point) -> None:
    ax.plot(*zip(start, end), color=PURPLE, linewidth=1.8, zorder=4)
    ax.plot(*end, color=PURPLE, marker="o", markersize=4, zorder=4)


def draw_arrow(ax: Axes, start: Point, end: Point, colour: str, width: float) -> None:
    arrow = {"arrowstyle": "->", "color": colour, "linewidth": width}
    arrow |= {"shrinkA": 0, "shrinkB": 0}
    ax.annotate("", end, start, arrowprops=arrow, zorder=5)


def draw_contact(ax: Axes, contact: gcv.Contact) -> None:
    """The point on A, and the normal there, unless it is that of two vertices that touch."""
    x, y = contact.on_a
    ax.plot(x, y, color=PURPLE, marker="o", markersize=4, zorder=6)
    if contact.kind != gcv.ContactKind.VERTEX_VERTEX or contact.gap > SLOPE:
        dx, dy = contact.normal
        draw_arrow(ax, (x, y), (x + NORMAL * dx, y + NORMAL * dy), INK, 1)


def draw_way(ax: Axes, b: gcv.Polygon, start: Point, end: Point) -> None:
    """From the middle of B where it is to where it comes to."""
    left, bottom, right, top = b.bounds
    x, y = (left + right) / 2, (bottom + top) / 2
    draw_arrow(ax, (x + start[0], y + start[1]), (x + end[0], y + end[1]), PURPLE, 1.8)


PICTURES = {
    "relation": relations,
    "distance": distances,
    "penetration": penetrations,
    "cast": casts,
    "contacts": contacts,
}

# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws questions about a scene: docs/scenes.

What is drawn in purple is the library's answer.
"""

from __future__ import annotations

import gallery_contacts
from gallery_style import BLUE, INK, PURPLE, STYLE_A, STYLE_B, STYLE_FREE, arrange
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import gcv

Point = tuple[float, float]

SHEET = gcv.Polygon([(0, 0), (15, 0), (15, 9), (0, 9)], [[(11, 5), (13, 5), (13, 7), (11, 7)]])
TEE = gcv.Polygon([(0, 0), (6, 0), (6, 2), (4, 2), (4, 5), (2, 5), (2, 2), (0, 2)])
HOUSE = gallery_contacts.HOUSE
BRICK = gallery_contacts.BRICK
BOX: gallery_contacts.Box = (-0.5, -0.5, 15.5, 9.5)

STYLES = {
    gcv.Relation.APART: STYLE_FREE,
    gcv.Relation.TOUCHING: STYLE_FREE,
    gcv.Relation.OVERLAPPING: STYLE_B,
}


def sheet() -> gcv.Scene:
    """Two tees in a container, of which one stands on its head between the other and the wall."""
    scene = gcv.Scene(SHEET)
    scene.add([TEE, TEE.affine([[-1, 0, 0], [0, -1, 0]])], [(0, 0), (10, 5)])
    return scene


def example() -> Figure:
    figure = Figure()
    cells = [
        positions(figure),
        motion(figure),
        contacts(figure),
        free_region(figure),
        best(figure),
        way_out(figure),
    ]
    arrange(figure, cells)
    return figure


def positions(figure: Figure) -> Axes:
    """Where a polygon overlaps members or the container, and where it does not."""
    scene = sheet()
    places = [(0.5, 6), (4.25, 6.25), (10, 0), (12, 3.5), (13, 5.5), (1.25, 1.5)]
    relations = [scene.relation(HOUSE, place) for place in places]
    free = sum(relation != gcv.Relation.OVERLAPPING for relation in relations)
    ax = gallery_contacts.cell(figure, "Positions", f"{free} of {len(places)} are free", BOX)
    draw(ax, scene)
    for place, relation in zip(places, relations):
        HOUSE.translated(place).plot(ax, **STYLES[relation], alpha=0.8, linewidth=1.2)
    ax.axis((BOX[0], BOX[2], BOX[1], BOX[3]))
    return ax


def motion(figure: Figure) -> Axes:
    """A motion up to the first hit."""
    start: Point = (13, 2)
    impact = sheet().cast(HOUSE, start, (-10, -2.5))
    name = f"hits member {impact.id}, time {impact.time:.3g}"
    return way(figure, ("A motion", name), start, impact)


def contacts(figure: Figure) -> Axes:
    """All contacts of a small wall on the ground of its container."""
    scene = gcv.Scene(gcv.Polygon([(0, 0), (15, 0), (15, 9), (0, 9)]))
    for row in range(3):
        scene.add(BRICK, [(1.5 + 2 * (row % 2) + 4 * k, 2 * row) for k in range(3 - row % 2)])
    found = scene.contacts()
    ax = gallery_contacts.cell(figure, "A wall", f"{len(found)} contacts", BOX)
    draw(ax, scene)
    for contact in found:
        gallery_contacts.draw_contact(ax, contact)
    ax.axis((BOX[0], BOX[2], BOX[1], BOX[3]))
    return ax


def free_region(figure: Figure) -> Axes:
    """All free positions of the lower left corner, and the polygon at the end of an exact fit."""
    scene = sheet()
    region = scene.free_region(HOUSE)
    name = f"{len(region.polygons)} polygons, {len(region.segments)} segments"
    ax = gallery_contacts.cell(figure, "The free region", name, BOX)
    draw(ax, scene)
    region.plot(ax, facecolor=PURPLE, edgecolor=PURPLE, alpha=0.3, linewidth=1.2)
    for segment in region.segments:
        ax.plot(*zip(*segment), color=PURPLE, linewidth=2)
    HOUSE.translated(region.segments[0][0]).plot(ax, **STYLE_FREE, alpha=0.5, linewidth=1.2)
    ax.axis((BOX[0], BOX[2], BOX[1], BOX[3]))
    return ax


def best(figure: Figure) -> Axes:
    """The free position furthest to the left, and of these the lowest."""
    scene = sheet()
    place = scene.best(HOUSE, (-1, 0))
    assert place is not None
    name = f"at ({place[0]:g}, {place[1]:g})"
    ax = gallery_contacts.cell(figure, "Furthest to the left", name, BOX)
    draw(ax, scene)
    HOUSE.translated(place).plot(ax, **STYLE_FREE, alpha=0.8, linewidth=1.2)
    ax.plot(*place, "o", color=PURPLE, markersize=5)
    ax.axis((BOX[0], BOX[2], BOX[1], BOX[3]))
    return ax


def way_out(figure: Figure) -> Axes:
    """The shortest way out of all overlaps."""
    start: Point = (9, 3.5)
    escape = sheet().penetration(HOUSE, start)
    name = f"depth {escape.depth:.3g}, touching member {escape.id}"
    return way(figure, ("A way out", name), start, escape)


def way(
    figure: Figure, titles: tuple[str, str], start: Point, end: gcv.Impact | gcv.Escape
) -> Axes:
    """How the house goes from where it starts to where it ends, and what it touches there."""
    ax = gallery_contacts.cell(figure, *titles, BOX)
    draw(ax, sheet())
    HOUSE.translated(start).plot(ax, **STYLE_B, alpha=0.8, linewidth=0.8)
    HOUSE.translated(end.position).plot(ax, **STYLE_FREE, alpha=0.8, linewidth=1.2)
    gallery_contacts.draw_way(ax, HOUSE, start, end.position)
    if end.contact is not None:
        gallery_contacts.draw_contact(ax, end.contact)
    ax.axis((BOX[0], BOX[2], BOX[1], BOX[3]))
    return ax


def draw(ax: Axes, scene: gcv.Scene) -> None:
    """The container by its boundary, with its holes solid, and the members with their ids."""
    container = scene.container
    if container is not None:
        ax.plot(*zip(*container.vertices, container.vertices[0]), color=INK, linewidth=1.2)
        for hole in container.holes:
            gcv.Polygon(hole).plot(ax, facecolor=INK, edgecolor=INK, alpha=0.3)
    for number in scene:
        x, y = scene.positions([number])[0]
        member = scene.polygon(number).translated((x, y))
        member.plot(ax, **STYLE_A, alpha=None, linewidth=0.8)
        left, bottom, right, top = member.bounds
        ax.text(
            (left + right) / 2,
            (bottom + top) / 2,
            str(number),
            color=BLUE,
            ha="center",
            va="center",
        )

# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws how witnesses cover a superset edge, and what they leave: docs/witnesses.

A witness is an open parallelogram in the open sum, of an edge of A and one of B, or of a
chain of edges of A and one of B. cpp/search/witness.hpp says why. Everything is done with
fractions here, without the searches of the library.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple, Optional

from gallery_style import (
    BLUE,
    GREEN,
    INK,
    PURPLE,
    STYLE_A,
    STYLE_B,
    STYLE_SUM,
    VERMILION,
    place,
    size,
)
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import gcv

Point = tuple[Fraction, Fraction]

# A chamber with a wavy floor behind a mouth, and a crooked bar that does not pass the mouth.
A = gcv.Polygon(
    [
        *((0, 0), (20, 0), (20, 15), (13, 15), (13, 12), (17, 12), (17, 3)),
        *((16 - k, 3.5 - 0.5 * (k % 2)) for k in range(13)),
        *((3, 3), (3, 12), (10, 12), (10, 15), (0, 15)),
    ]
)
B = gcv.Polygon(
    [
        *((k, -0.5 * (k % 2)) for k in range(8)),
        *((8, 2), (6, 1.5), (5, 2), (3, 1.5), (1, 2)),
    ]
)
EDGE_OF_A, VERTEX_OF_B = 21, 3  # their sum is the superset edge: the ceiling of the chamber

COLOURS = BLUE, VERMILION, PURPLE


class Chain(NamedTuple):
    """Edges of a ring that follow one another: its vertices from first to last."""

    vertices: list[Point]

    @property
    def edges(self) -> int:
        return len(self.vertices) - 1

    @property
    def chord(self) -> Point:
        return minus(self.vertices[-1], self.vertices[0])

    @property
    def area(self) -> Fraction:
        """The length of the chord, times the distance of the furthest vertex from its line."""
        return max(abs(cross(self.chord, minus(v, self.vertices[0]))) for v in self.vertices)

    def halves(self) -> list[Chain]:
        """The chain in two, at the vertex that is furthest from the chord."""
        start, u = self.vertices[0], self.chord
        away = [minus(vertex, start) for vertex in self.vertices[1:-1]]
        distances = [abs(cross(u, w)) if any(u) else w[0] ** 2 + w[1] ** 2 for w in away]
        k = 1 + distances.index(max(distances))
        return [Chain(self.vertices[: k + 1]), Chain(self.vertices[k:])]


class Witness(NamedTuple):
    """A chain of A, one of B, and what they cover of a line: parameters, an open interval."""

    p: Chain
    q: Chain
    enter: Fraction
    leave: Fraction


Interval = tuple[Fraction, Fraction]


class Line(NamedTuple):
    """A superset edge: its points are start + t direction, for t from 0 to 1."""

    start: Point
    direction: Point

    def at(self, t: Fraction) -> Point:
        return plus(self.start, times(t, self.direction))


def plus(p: Point, q: Point) -> Point:
    return p[0] + q[0], p[1] + q[1]


def minus(p: Point, q: Point) -> Point:
    return p[0] - q[0], p[1] - q[1]


def times(factor: Fraction, p: Point) -> Point:
    return factor * p[0], factor * p[1]


def cross(p: Point, q: Point) -> Fraction:
    return p[0] * q[1] - p[1] * q[0]


def chain_of(polygon: gcv.Polygon) -> Chain:
    """The whole outer ring, closed."""
    ring = [(Fraction(x), Fraction(y)) for x, y in polygon.vertices.tolist()]
    return Chain([*ring, ring[0]])


def edges(chain: Chain) -> list[Chain]:
    return [Chain(list(ends)) for ends in zip(chain.vertices, chain.vertices[1:])]


def witness(p: Chain, q: Chain, line: Line) -> Optional[Witness]:
    """What the parallelogram of two chords covers of a line, less the radii of the chains.

    A point of it must be further than the radius of q from the sides along the chord v of q,
    and further than that of p from those along the chord u of p.
    """
    u, v, corner = p.chord, q.chord, plus(p.vertices[0], q.vertices[0])
    area = cross(u, v)
    if area == 0:
        return None
    sign = 1 if area > 0 else -1
    w, d = minus(line.start, corner), line.direction
    enter, leave = Fraction(-1), Fraction(2)
    for value, slope, least in (
        (sign * cross(w, v), sign * cross(d, v), q.area),
        (sign * cross(u, w), sign * cross(u, d), p.area),
    ):
        low, high = least - value, abs(area) - least - value
        if not low < high or (slope == 0 and not low < 0 < high):
            return None
        if slope != 0:
            first, last = sorted((low / slope, high / slope))
            enter, leave = max(enter, first), min(leave, last)
    return Witness(p, q, enter, leave) if enter < leave else None


def search(a: Chain, b: Chain, line: Line, t: Fraction) -> Optional[Witness]:
    """The coarsest witness that covers what follows t, as far as a twentieth of the line.

    Or else the one of two edges that covers most of what follows; None where none does.
    """
    best = None
    queue = deque([(a, b)])
    while queue:
        p, q = queue.popleft()
        found = witness(p, q, line)
        if found and found.enter <= t < found.leave:
            if found.leave >= min(t + Fraction(1, 20), Fraction(1)):
                return found
            if p.edges == q.edges == 1 and (best is None or found.leave > best.leave):
                best = found
        if p.edges > q.edges:
            queue.extend((half, q) for half in p.halves())
        elif q.edges > 1:
            queue.extend((p, half) for half in q.halves())
    return best


def cover(a: gcv.Polygon, b: gcv.Polygon, line: Line) -> tuple[list[Witness], list[Interval]]:
    """Witnesses that cover the line, from its start on, and the intervals that none covers."""
    chain_a, chain_b = chain_of(a), chain_of(b)
    enters = sorted(
        found.enter
        for p in edges(chain_a)
        for q in edges(chain_b)
        if (found := witness(p, q, line)) and found.leave > 0
    )
    witnesses: list[Witness] = []
    free: list[Interval] = []
    t = Fraction(0)
    while t < 1:
        found = search(chain_a, chain_b, line, t)
        if found:
            witnesses.append(found)
            t = found.leave
        else:
            end = min((enter for enter in enters if enter > t), default=Fraction(1))
            free.append((t, min(end, Fraction(1))))
            t = end
    return witnesses, free


def superset_edge(a: gcv.Polygon, b: gcv.Polygon, kind: int, i: int, j: int) -> Line:
    """The superset edge with that source."""
    (edge,) = (e for e in gcv.superset(a, b) if e.source == (kind, i, j))
    start, end = (tuple(map(Fraction, point)) for point in (edge.start, edge.end))
    return Line((start[0], start[1]), (end[0] - start[0], end[1] - start[1]))


def example() -> Figure:
    line = superset_edge(A, B, gcv.EDGE_TRANSLATED, EDGE_OF_A, VERTEX_OF_B)
    return picture(A, B, line)


def picture(a: gcv.Polygon, b: gcv.Polygon, line: Line) -> Figure:
    """Draw A above B, and beside them the region, the superset edge and its witnesses."""
    region = gcv.minkowski_sum_region(a, b)
    witnesses, free = cover(a, b, line)
    left, bottom, right, top = region.bounds
    gap = (right - left) / 20
    start = left - 1.5 * gap - size(a)[0]
    xlim, ylim = (start - gap, right + gap), (bottom - gap, top + 5 * gap)
    figure = Figure((10, 10 * (ylim[1] - ylim[0]) / (xlim[1] - xlim[0])))
    ax = figure.add_axes((0, 0, 1, 1), xlim=xlim, ylim=ylim)
    ax.set_axis_off()

    above_b = bottom + size(b)[1] + 2 * gap
    draw_operand(ax, a, STYLE_A, (start, above_b), "A", [w.p for w in witnesses])
    draw_operand(ax, b, STYLE_B, (start, bottom), "B", [w.q for w in witnesses])
    region.plot(ax, **STYLE_SUM, alpha=None, linewidth=0.8)
    for colour, found in zip(COLOURS, witnesses):
        draw_witness(ax, found, colour)
    put_line(ax, [line.at(Fraction(0)), line.at(Fraction(1))], INK, 2, "a superset edge s")
    for low, high in free:
        put_line(ax, [line.at(low), line.at(high)], GREEN, 4, "what no witness covers of s")
        put_germ(ax, line, (low + high) / 2)
    ax.legend(loc="upper right", frameon=False, alignment="left")
    return figure


def draw_operand(
    ax: Axes,
    polygon: gcv.Polygon,
    style: dict[str, str],
    corner: tuple[float, float],
    name: str,
    chains: Iterable[Chain],
) -> None:
    """Draw a polygon with the lower left corner of its box there, and chains of it."""
    moved = place(ax, polygon, *corner)
    polygon.plot(ax, alpha=None, linewidth=0.8, transform=moved, **style)
    for colour, chain in zip(COLOURS, chains):
        xs, ys = zip(*shown(chain.vertices))
        ax.plot(xs, ys, color=colour, linewidth=3, alpha=0.8, transform=moved)
    ax.text(corner[0], corner[1] + size(polygon)[1] + 0.4, name, color=style["edgecolor"])


def draw_witness(ax: Axes, found: Witness, colour: str) -> None:
    """Draw the parallelogram of the chords, the chains along its sides, and what is covered."""
    (p, q), (u, v) = (found.p, found.q), (found.p.chord, found.q.chord)
    corner, area = plus(p.vertices[0], q.vertices[0]), abs(cross(u, v))
    along_u, along_v = q.area / area, p.area / area

    def at(x: Fraction, y: Fraction) -> Point:
        return plus(corner, plus(times(x, u), times(y, v)))

    zero, one = Fraction(0), Fraction(1)
    inner = [
        *(at(along_u, along_v), at(one - along_u, along_v)),
        *(at(one - along_u, one - along_v), at(along_u, one - along_v)),
    ]
    label = f"a witness: {chain_words(p, 'A')} and {chain_words(q, 'B')}"
    ax.fill(*zip(*shown(inner)), facecolor=colour, edgecolor="none", alpha=0.3, label=label)
    outer = [at(zero, zero), at(one, zero), at(one, one), at(zero, one), at(zero, zero)]
    put_line(ax, outer, colour, 0.8, dashes=(4, 3))
    for chain, other in ((p, q), (q, p)):
        for end in (other.vertices[0], other.vertices[-1]):
            put_line(ax, [plus(vertex, end) for vertex in chain.vertices], colour, 1)


def chain_words(chain: Chain, name: str) -> str:
    return f"an edge of {name}" if chain.edges == 1 else f"{chain.edges} edges of {name}"


def put_line(
    ax: Axes,
    points: Iterable[Point],
    colour: str,
    width: float,
    label: Optional[str] = None,
    dashes: tuple[float, ...] = (),
) -> None:
    xs, ys = zip(*shown(points))
    (line,) = ax.plot(xs, ys, color=colour, linewidth=width, label=label)
    if dashes:
        line.set_dashes(dashes)


def put_germ(ax: Axes, line: Line, t: Fraction) -> None:
    """Mark a place, and the way from there along s and then to its right."""
    (x, y), (dx, dy) = shown([line.at(t), line.direction])
    along, right = (dx / 8, dy / 8), (dy / 8, -dx / 8)
    turn = (x + along[0], y + along[1])
    end = (turn[0] + right[0], turn[1] + right[1])
    arrow = {"arrowstyle": "->", "color": INK, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", turn, (x, y), arrowprops=arrow, zorder=4)
    ax.annotate("", end, turn, arrowprops=arrow, zorder=4)
    ax.text(end[0], end[1], "its germ", color=INK, ha="center", va="top")
    ax.plot(x, y, color=INK, marker="o", markersize=5, zorder=4)


def shown(points: Iterable[Point]) -> list[tuple[float, float]]:
    return [(float(x), float(y)) for x, y in points]

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The exact region of a sum, of an inner fit or of a scene, in fractions, without the library.

A position x is blocked if the interiors of A and of x - B meet, for one A of several; the positions
that are not are free. Whether two polygons overlap is asked of the polygons alone, for every face,
edge and vertex of the arrangement of all edges of each polygon moved to all vertices of the other.
The region of a sum is what is blocked. That of an inner fit or of a scene is what is free, where
one A is the outside of a container, or where there is a window, whose edges are in the
arrangement too. Fits are free edges and vertices among blocked faces.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from arrangement import (
    Point,
    Segment,
    are_apart,
    area_twice,
    around,
    arrangement,
    cross,
    direction,
    edges,
    meeting_points,
    plus,
    within,
    without_straight_angles,
)

Ring = list[Point]
Polygon = list[Ring]
Part = tuple[str, Ring]
"""The word "outer", "hole", "segment" or "point", and the vertices."""


class Solid:
    """Rings, the solid on the left of every edge: a polygon, or the outside of one."""

    def __init__(self, given: Polygon, is_outside: bool = False) -> None:
        self.given = given
        self.is_outside = is_outside
        self.rings = [
            ring if (area_twice(ring) > 0) == ((k == 0) != is_outside) else ring[::-1]
            for k, ring in enumerate(given)
        ]
        self.edges = [edge for ring in self.rings for edge in edges(ring)]
        self.vertices = [p for ring in self.rings for p in ring]
        xs, ys = zip(*self.vertices)
        self.box: Segment = ((min(xs), min(ys)), (max(xs), max(ys)))

    def moved(self, t: Point) -> Solid:
        return Solid([[plus(p, t) for p in ring] for ring in self.given], self.is_outside)

    def at(self, x: Point) -> Solid:
        """X - B, for this B."""
        return Solid([[direction(p, x) for p in ring] for ring in self.rings], self.is_outside)

    def has_left_of(self, m: Point, towards: Point) -> bool:
        """Whether there is solid on the left of m, seen in a direction.

        No edge of this solid crosses the line through m in that direction at m, or ends there.
        """
        is_inside = self.is_outside
        for p, q in self.edges:
            if max(p[1], q[1]) < m[1] or m[1] < min(p[1], q[1]):
                continue
            side = cross(p, q, m)
            if side == 0 and within(m, p, q):
                along = direction(p, q)
                return towards[0] * along[0] + towards[1] * along[1] > 0
            if (p[1] <= m[1]) != (q[1] <= m[1]) and (side > 0) == (p[1] < q[1]):
                is_inside = not is_inside
        return is_inside


Window = tuple[Fraction, Fraction, Fraction, Fraction]
"""The smallest x and y, and the largest ones."""


def corners_of(window: Window) -> Ring:
    x_min, y_min, x_max, y_max = window
    return [(x_min, y_min), (x_max, y_min), (x_max, y_max), (x_min, y_max)]


def middle(p: Point, q: Point) -> Point:
    return ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)


def overlap(a: Solid, b: Solid) -> bool:
    """Whether the interiors meet.

    If they do, what they share is bounded by parts of edges of one of the solids, with the other
    solid on the left too.
    """
    if not (a.is_outside or b.is_outside) and are_apart(a.box, b.box):
        return False
    for one, other in ((a, b), (b, a)):
        for edge in one.edges:
            cuts = {p for t in other.edges for p in meeting_points(edge, t)} | set(edge)
            chain = sorted(cuts)
            towards = direction(*edge)
            if any(other.has_left_of(middle(p, q), towards) for p, q in zip(chain, chain[1:])):
                return True
    return False


class Faces:
    """For each edge of the arrangement: whether the face on its left is blocked, and is wanted."""

    def __init__(self, solids: list[Solid], b: Solid, window: Window | None) -> None:
        self.is_blocked: Callable[[Point], bool] = lambda x: any(
            overlap(a, b.at(x)) for a in solids
        )
        self.window = window
        wants_blocked = window is None and not any(a.is_outside for a in solids)
        segments = {
            (plus(p, v), plus(q, v)) for a in solids for p, q in a.edges for v in b.vertices
        }
        segments |= {
            (plus(p, v), plus(q, v)) for p, q in b.edges for a in solids for v in a.vertices
        }
        segments |= set(edges(corners_of(window)) if window is not None else [])
        neighbours = arrangement(segments)
        self.around = {p: around(p, others) for p, others in neighbours.items()}
        self.edges = [(p, q) for p, others in self.around.items() for q in others]
        self.segments = [(p, q) for p, q in self.edges if p < q]
        self.blocked_left: dict[Segment, bool] = {}
        self.wanted_left: dict[Segment, bool] = {}
        for edge in self.edges:
            if edge not in self.blocked_left:
                place = self.place_left_of(edge)
                blocked = self.is_blocked(place)
                while edge not in self.blocked_left:
                    self.blocked_left[edge] = blocked
                    self.wanted_left[edge] = blocked == wants_blocked and self.is_in_window(place)
                    edge = self.following(edge, lambda _: True)

    def is_in_window(self, p: Point) -> bool:
        """Or on its border."""
        if self.window is None:
            return True
        x_min, y_min, x_max, y_max = self.window
        return x_min <= p[0] <= x_max and y_min <= p[1] <= y_max

    def place_left_of(self, edge: Segment) -> Point:
        """A place in the face on the left: half the way from the edge to the next one."""
        m = middle(*edge)
        towards = direction(*edge)
        far = (m[0] - towards[1], m[1] + towards[0])
        nearest = Fraction(1)
        for p, q in self.segments:
            if are_apart((m, far), (p, q)):
                continue
            start, end = cross(m, far, p), cross(m, far, q)
            if start * end > 0:
                continue
            if start == end:
                met = [p, q]
            else:
                met = [plus(p, scaled(direction(p, q), start / (start - end)))]
            for x in met:
                height = cross(*edge, x) / (towards[0] ** 2 + towards[1] ** 2)
                if 0 < height < nearest:
                    nearest = height
        return plus(m, scaled((-towards[1], towards[0]), nearest / 2))

    def following(self, edge: Segment, is_wanted: Callable[[Segment], bool]) -> Segment:
        """The next wanted edge around the face on the left."""
        p, q = edge
        others = self.around[q]
        k = others.index(p)
        while True:
            k -= 1
            if is_wanted((q, others[k])):
                return (q, others[k])


def scaled(v: Point, factor: Fraction) -> Point:
    return (v[0] * factor, v[1] * factor)


def simple_rings(walk: Ring) -> list[Ring]:
    """The walk, cut where it visits a point twice."""
    rings = []
    path: Ring = []
    for p in walk:
        if p in path:
            k = path.index(p)
            rings.append(path[k:])
            del path[k:]
        path.append(p)
    return [*rings, path]


def from_smallest(ring: Ring) -> Ring:
    k = ring.index(min(ring))
    return ring[k:] + ring[:k]


def contains(ring: Ring, p: Point) -> bool:
    """Whether p, which is not on the ring, is inside."""
    return Solid([ring]).has_left_of(p, (Fraction(1), Fraction(0)))


def region(solids: list[Solid], b: Solid, window: Window | None = None) -> list[Part]:
    """All parts in their order."""
    faces = Faces(solids, b, window)

    def is_boundary(edge: Segment) -> bool:
        p, q = edge
        return faces.wanted_left[edge] and not faces.wanted_left[q, p]

    outer: list[Ring] = []
    holes: list[tuple[Ring, Point]] = []
    seen: set[Segment] = set()
    on_rings: set[Point] = set()
    for first in filter(is_boundary, faces.edges):
        walk = []
        edge = first
        while edge not in seen:
            seen.add(edge)
            walk.append(edge[0])
            edge = faces.following(edge, is_boundary)
        on_rings.update(walk)
        for ring in simple_rings(walk) if walk else []:
            clean = from_smallest(without_straight_angles(ring))
            if area_twice(ring) > 0:
                outer.append(clean)
            else:
                holes.append((clean, faces.place_left_of((ring[0], ring[1]))))

    outer.sort()
    holes_of: list[list[Ring]] = [[] for _ in outer]
    for hole, inside in holes:
        around_it = [k for k, ring in enumerate(outer) if contains(ring, inside)]
        holes_of[min(around_it, key=lambda k: area_twice(outer[k]))].append(hole)
    parts: list[Part] = []
    for ring, its_holes in zip(outer, holes_of):
        parts.append(("outer", ring))
        parts += [("hole", hole) for hole in sorted(its_holes)]
    return parts + fits(faces, on_rings)


def fits(faces: Faces, on_rings: set[Point]) -> list[Part]:
    blocked = faces.blocked_left

    def is_place(p: Point) -> bool:
        return faces.is_in_window(p) and not faces.is_blocked(p)

    thin = {
        (p, q)
        for p, q in faces.segments
        if blocked[p, q] and blocked[q, p] and is_place(middle(p, q))
    }
    points = [
        p
        for p, others in faces.around.items()
        if p not in on_rings
        and not any((min(p, q), max(p, q)) in thin for q in others)
        and all(blocked[p, q] for q in others)
        and is_place(p)
    ]
    segments = []
    for p, q in sorted(thin):
        if any(r == p and p not in on_rings and cross(o, p, q) == 0 for o, r in thin):
            continue  # not the first edge of its segment
        end = q
        while end not in on_rings:
            onward = [s for r, s in thin if r == end and cross(p, end, s) == 0]
            if not onward:
                break
            end = onward[0]
        segments.append([p, end])
    return [("segment", ends) for ends in sorted(segments)] + [
        ("point", [p]) for p in sorted(points)
    ]


# ------------------------------------------------------------------------------ texts --


def text_of_ring(ring: Ring) -> str:
    return ", ".join(
        f"{x.numerator}/{x.denominator} {y.numerator}/{y.denominator}" for x, y in ring
    )


def text_of_parts(parts: list[Part]) -> str:
    return "; ".join(f"{kind} {text_of_ring(vertices)}" for kind, vertices in parts) or "empty"

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""How two polygons lie, how far apart they are, how far one can move, how it gets out of an
overlap, and all their contacts: in fractions.

Every pair of features is looked at. Whether interiors meet is asked as for regions. Nothing comes
from the library.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple

from arrangement import Point, Segment, area_twice, cross, direction, meeting_points, plus, within
from regions import Solid, overlap, scaled

ZERO = (Fraction(0), Fraction(0))
EDGE_VERTEX, VERTEX_EDGE, VERTEX_VERTEX = 1, 2, 3
KINDS = {EDGE_VERTEX: "edge_vertex", VERTEX_EDGE: "vertex_edge", VERTEX_VERTEX: "vertex_vertex"}
RELATIONS = {1: "apart", 0: "touching", -1: "overlapping"}


def product(u: Point, v: Point) -> Fraction:
    return cross(ZERO, u, v)


def dot(u: Point, v: Point) -> Fraction:
    return u[0] * v[0] + u[1] * v[1]


def is_on(segment: Segment, x: Point) -> bool:
    return cross(*segment, x) == 0 and within(x, *segment)


class Corner(NamedTuple):
    """A vertex, and the edge that begins there, which has the solid on its left."""

    before: Point
    place: Point
    after: Point
    vertex: int
    edge: int


def corners(solid: Solid) -> list[Corner]:
    """Without repeated and collinear vertices, with the caller's numbers."""
    result = []
    first = 0
    for ring, given in enumerate(solid.given):
        last = len(given)
        while last > 1 and given[last - 1] == given[0]:
            last -= 1
        # A vertex that is repeated has its last number.
        kept = [k for k in range(last) if k + 1 == last or given[k] != given[k + 1]]
        places = [given[k] for k in kept]
        vertices = [first + k for k in kept]
        edges = list(vertices)
        if (area_twice(places) > 0) != (ring == 0):
            places.reverse()
            vertices.reverse()
            edges = edges[-2::-1] + edges[-1:]
        turns = [
            k
            for k in range(len(places))
            if cross(places[k - 1], places[k], places[(k + 1) % len(places)]) != 0
        ]
        for n, k in enumerate(turns):
            before, after = turns[n - 1], turns[(n + 1) % len(turns)]
            edge = edges[k]
            if solid.is_outside:
                before, after, edge = after, before, edges[before]
            result.append(Corner(places[before], places[k], places[after], vertices[k], edge))
        first += len(given)
    return result


def relation(a: Solid, b: Solid) -> int:
    if overlap(a, b):
        return -1
    return 0 if any(meeting_points(s, t) for s in a.edges for t in b.edges) else 1


class Contact(NamedTuple):
    """Contacts are in the order of their first three numbers."""

    kind: int
    a: int
    b: int
    squared_gap: Fraction
    on_a: Point
    on_b: Point
    is_deep: bool = False
    """Whether the gap counts as negative."""


def nearest(a: Solid, b: Solid) -> Contact:
    """The smallest of the nearest pairs of features."""

    def foot(corner: Corner, p: Point) -> Point | None:
        """The foot of the perpendicular to an edge, if it is inside."""
        along = direction(corner.place, corner.after)
        share = dot(direction(corner.place, p), along) / dot(along, along)
        return plus(corner.place, scaled(along, share)) if 0 < share < 1 else None

    found = []
    for p in corners(a):
        for q in corners(b):
            pairs = [
                (EDGE_VERTEX, p.edge, q.vertex, foot(p, q.place), q.place),
                (VERTEX_EDGE, p.vertex, q.edge, p.place, foot(q, p.place)),
                (VERTEX_VERTEX, p.vertex, q.vertex, p.place, q.place),
            ]
            for kind, i, j, on_a, on_b in pairs:
                if on_a is not None and on_b is not None:
                    way = direction(on_a, on_b)
                    found.append(Contact(kind, i, j, dot(way, way), on_a, on_b))
    return min(found, key=lambda contact: (contact.squared_gap, contact[:3]))


# ----------------------------------------------------------------------------- motions --

Sector = tuple[Point, Point]
"""The directions from the first counter-clockwise to the second, without these."""


def convex_sectors(sector: Sector) -> list[Sector]:
    """Parts of less than a half-turn each, which make up the sector but for rays."""
    u, v = sector
    if product(u, v) > 0:
        return [sector]
    quarter = (-u[1], u[0])
    back = (-u[0], -u[1])
    if product(u, v) == 0:
        return [(u, quarter), (quarter, v)]
    return [(u, quarter), (quarter, back), (back, v)]


def is_inside_hull(vectors: list[Point], m: Point) -> bool:
    """Whether m is a sum of multiples of the vectors, by factors above 0, with room around it."""
    lefts = [v for v in vectors if product(m, v) > 0]
    rights = [v for v in vectors if product(m, v) < 0]
    if any(product(m, v) == 0 and dot(m, v) > 0 for v in vectors):
        return bool(lefts) and bool(rights)
    return any(product(r, v) > 0 for r in rights for v in lefts)


def meet_after(a: Sector, b: Sector, m: Point) -> bool:
    """Whether points of a are points of b moved by m: m is one of a less one of b."""
    return any(
        is_inside_hull([*p, *((-x, -y) for x, y in q)], m)
        for p in convex_sectors(a)
        for q in convex_sectors(b)
    )


def features_at(solid: list[Corner], x: Point) -> list[tuple[bool, int, Sector]]:
    """Whether each is a vertex, its number, and the directions into the solid there."""
    found = []
    for corner in solid:
        into = (direction(x, corner.after), direction(x, corner.before))
        along = (into[0], direction(x, corner.place))
        if corner.place == x:
            found.append((True, corner.vertex, into))
        elif x != corner.after and is_on((corner.place, corner.after), x):
            found.append((False, corner.edge, along))
    return found


def entered(a: Solid, b: Solid, motion: Point) -> Contact:
    """The smallest contact that the motion of b enters. They touch."""
    found = []
    of_a, of_b = corners(a), corners(b)
    for x in {corner.place for corner in of_a + of_b}:
        here, there = features_at(of_a, x), features_at(of_b, x)
        if not here or not there:
            continue
        assert len(here) == len(there) == 1, "rings touch where a contact is to be named"
        (at_vertex, i, into_a), (at_other_vertex, j, into_b) = here[0], there[0]
        if meet_after(into_a, into_b, motion):
            kind = VERTEX_VERTEX if at_other_vertex else VERTEX_EDGE
            found.append(Contact(kind if at_vertex else EDGE_VERTEX, i, j, Fraction(0), x, x))
    return min(found)


def times_of_events(a: Solid, b: Solid, motion: Point) -> list[Fraction]:
    """From 0 to 1, when vertices come to edges or leave them; nothing changes in between."""
    times = {Fraction(0), Fraction(1)}
    of_a, of_b = corners(a), corners(b)
    for some, others, way in (
        (of_a, of_b, motion),
        (of_b, of_a, (-motion[0], -motion[1])),
    ):
        for edge in some:
            along = direction(edge.place, edge.after)
            speed = product(along, way)
            for corner in others if speed != 0 else []:
                time = product(along, direction(corner.place, edge.place)) / speed
                reached = plus(corner.place, scaled(way, time))
                if 0 < time < 1 and within(reached, edge.place, edge.after):
                    times.add(time)
    return sorted(times)


class Impact(NamedTuple):
    hit: bool
    time: Fraction
    contact: Contact | None


def impact(a: Solid, b: Solid, motion: Point) -> Impact:
    if relation(a, b) < 0:
        return Impact(True, Fraction(0), None)
    times = times_of_events(a, b, motion)
    for time, following in zip(times, times[1:]):
        later = b.moved(scaled(motion, (time + following) / 2))
        if relation(a, later) < 0:
            here = b.moved(scaled(motion, time))
            assert relation(a, here) == 0
            return Impact(True, time, entered(a, here, motion))
    return Impact(False, Fraction(1), None)


# ---------------------------------------------------------------------------- contacts --


def admits(edge: Segment, corner: Corner, slope: Fraction) -> bool:
    """Whether the corner can come to the edge from outside, once turned by no more than that."""
    if cross(corner.before, corner.place, corner.after) <= 0:
        return False
    along = direction(*edge)
    leaving = direction(corner.place, corner.after)
    arriving = direction(corner.before, corner.place)

    def is_near(way: Point) -> bool:
        """The way of an edge that lies on the line of the other one runs against that."""
        return dot(way, along) < 0 and abs(product(way, along)) <= -slope * dot(way, along)

    if product(along, leaving) <= 0 <= product(along, arriving):
        return True
    return is_near(leaving) or is_near(arriving)


def clamped_foot(edge: Segment, p: Point) -> Point:
    """The point of the edge that is nearest to p."""
    along = direction(*edge)
    share = dot(direction(edge[0], p), along) / dot(along, along)
    return plus(edge[0], scaled(along, min(max(share, Fraction(0)), Fraction(1))))


def contacts(a: Solid, b: Solid, distance: Fraction, slope: Fraction) -> list[Contact]:
    """Those of Definition 1 within the distance, by their features."""

    def edge_of(corner: Corner) -> Segment:
        return (corner.place, corner.after)

    def sides(corner: Corner) -> list[Segment]:
        return [(corner.before, corner.place), (corner.place, corner.after)]

    found = []
    for p in corners(a):
        for q in corners(b):
            pairs = []
            if admits(edge_of(p), q, slope):
                foot = clamped_foot(edge_of(p), q.place)
                is_deep = cross(*edge_of(p), q.place) > 0
                pairs.append((EDGE_VERTEX, p.edge, q.vertex, foot, q.place, is_deep))
            if admits(edge_of(q), p, slope):
                foot = clamped_foot(edge_of(q), p.place)
                is_deep = cross(*edge_of(q), p.place) > 0
                pairs.append((VERTEX_EDGE, p.vertex, q.edge, p.place, foot, is_deep))
            are_convex = cross(p.before, p.place, p.after) > 0 < cross(q.before, q.place, q.after)
            if are_convex and (
                any(admits(edge, q, slope) for edge in sides(p))
                or any(admits(edge, p, slope) for edge in sides(q))
            ):
                pairs.append((VERTEX_VERTEX, p.vertex, q.vertex, p.place, q.place, False))
            for kind, i, j, on_a, on_b, is_deep in pairs:
                way = direction(on_a, on_b)
                if dot(way, way) <= distance**2:
                    found.append(Contact(kind, i, j, dot(way, way), on_a, on_b, is_deep))
    return sorted(found)


# ------------------------------------------------------------------------ ways out --


def nearest_free(a: Solid, b: Solid, ways: set[Point]) -> Point:
    """The shortest of the ways by which b does not overlap a; of several, the smallest."""
    for way in sorted(ways, key=lambda way: (dot(way, way), way)):
        if relation(a, b.moved(way)) >= 0:
            return way
    raise AssertionError("no way out")


def way_out(a: Solid, b: Solid) -> Point:
    """The shortest one.

    It ends on a segment of ways that bring a vertex to an edge: where that is nearest, where it
    ends, or where another one crosses it. Only there can ways begin to lead out, or stop to.
    """
    if relation(a, b) >= 0:
        return ZERO
    segments = set()
    for p in corners(a):
        for q in corners(b):
            segments.add((direction(q.place, p.place), direction(q.place, p.after)))
            segments.add((direction(q.place, p.place), direction(q.after, p.place)))
    feet = {segment: clamped_foot(segment, ZERO) for segment in segments}
    bound = nearest_free(a, b, {*feet.values(), *(end for segment in segments for end in segment)})
    near = [s for s in segments if dot(feet[s], feet[s]) <= dot(bound, bound)]
    ways = {bound, *(feet[s] for s in near)}
    for k, segment in enumerate(near):
        for other in near[:k]:
            for way in meeting_points(segment, other):
                if dot(way, way) <= dot(bound, bound):
                    ways.add(way)
    return nearest_free(a, b, ways)


# ------------------------------------------------------------------------------ texts --


def nearest_double(x: Fraction) -> float:
    """Correctly rounded; OverflowError beyond the largest double."""
    return x.numerator / x.denominator + 0.0  # never -0


def double_below(x: Fraction) -> float:
    rounded = nearest_double(x)
    return math.nextafter(rounded, -math.inf) if Fraction(rounded) > x else rounded


def root(square: Fraction) -> float:
    """The nearest double."""
    # An integer of more than 120 bits, and a half where there is a rest: rounds as the root does.
    bits = square.denominator.bit_length() - square.numerator.bit_length()
    shift = max(0, bits // 2 + 122)
    scaled_square = square * 4**shift
    whole = math.isqrt(math.floor(scaled_square))
    rest = Fraction(0) if whole**2 == scaled_square else Fraction(1, 2)
    return nearest_double((whole + rest) / 2**shift)


def text_of_number(x: float) -> str:
    return f"{x:.17g}"


def text_of_contact(contact: Contact | None) -> str:
    if contact is None:
        return "none"
    gap = root(contact.squared_gap)
    numbers = [-gap if contact.is_deep else gap]
    numbers += [nearest_double(x) for x in (*contact.on_a, *contact.on_b)]
    name = f"{KINDS[contact.kind]} {contact.a} {contact.b}"
    return " ".join([name, *map(text_of_number, numbers)])


def text_of_relation(a: Solid, b: Solid) -> str:
    return RELATIONS[relation(a, b)]


def nearest_if_apart(a: Solid, b: Solid) -> Contact | None:
    return nearest(a, b) if relation(a, b) > 0 else None


def text_of_gap(contact: Contact | None) -> str:
    return text_of_number(root(contact.squared_gap) if contact is not None else 0.0)


def text_of_distance(a: Solid, b: Solid) -> str:
    contact = nearest_if_apart(a, b)
    return f"{text_of_relation(a, b)} {text_of_gap(contact)} {text_of_contact(contact)}"


def text_of_point(exact: Point) -> str:
    position = [nearest_double(x) for x in exact]
    if [Fraction(x) for x in position] != list(exact):
        return "inexact"
    return " ".join(map(text_of_number, position))


def text_of_position(exact: Point, relation_at: Callable[[Point], int]) -> str:
    text = text_of_point(exact)
    return text if text == "inexact" else f"{RELATIONS[relation_at(exact)]} {text}"


def text_of_cast(a: Solid, b: Solid, translation: Point, motion: Point) -> str:
    """Of b before the translation."""
    hit, time, contact = impact(a, b.moved(translation), motion)
    end = plus(translation, scaled(motion, time))
    place = text_of_position(end, lambda t: relation(a, b.moved(t)))
    word = "hit" if hit else "miss"
    return f"{word} {text_of_number(double_below(time))} {place} {text_of_contact(contact)}"


def text_of_way(way: Point) -> str:
    """Its length, and the way itself."""
    numbers = [root(dot(way, way)), nearest_double(way[0]), nearest_double(way[1])]
    return " ".join(map(text_of_number, numbers))


def contact_with_edge(a: Solid, b: Solid) -> Contact:
    """The smallest one of an edge and a vertex. They touch."""
    touching = contacts(a, b, Fraction(0), Fraction(0))
    with_edges = [contact for contact in touching if contact.kind != VERTEX_VERTEX]
    assert with_edges, "rings touch where a contact is to be named"
    return min(with_edges)


def text_of_penetration(a: Solid, b: Solid, translation: Point) -> str:
    """Of b before the translation."""
    way = way_out(a, b.moved(translation))
    end = plus(translation, way)
    contact = contact_with_edge(a, b.moved(end)) if way != ZERO else None
    place = text_of_position(end, lambda t: relation(a, b.moved(t)))
    return f"{text_of_way(way)} {place} {text_of_contact(contact)}"


def text_of_contacts(a: Solid, b: Solid, distance: Fraction, slope: Fraction) -> str:
    found = contacts(a, b, distance, slope)
    found.sort(key=lambda contact: root(contact.squared_gap))
    return "; ".join(map(text_of_contact, found)) or "empty"


def answer(a: Solid, b: Solid, question: str, words: list[str]) -> str:
    """The status, and what the question asks for, for its numbers: a translation, and others."""
    numbers = [float(word) for word in words]
    if not all(map(math.isfinite, numbers)):
        return "GCV_ERR_NOT_FINITE"
    exact = [Fraction(x) for x in numbers]
    translation = (exact[0], exact[1])
    try:
        if question == "relation":
            return f"GCV_OK {text_of_relation(a, b.moved(translation))}"
        if question == "distance":
            return f"GCV_OK {text_of_distance(a, b.moved(translation))}"
        if question == "penetration":
            return f"GCV_OK {text_of_penetration(a, b, translation)}"
        if question == "contacts":
            if min(exact[2:]) < 0:
                return "GCV_ERR_INVALID_ARGUMENT"
            return f"GCV_OK {text_of_contacts(a, b.moved(translation), exact[2], exact[3])}"
        return f"GCV_OK {text_of_cast(a, b, translation, (exact[2], exact[3]))}"
    except OverflowError:
        return "GCV_ERR_RANGE"

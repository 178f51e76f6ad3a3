# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Questions about many polygons, and about one more that moves among them: in fractions.

What two polygons answer is asked of each of them in turn. A container is the outside of a polygon,
which is solid. Where the moving polygon is free comes from regions.py: the furthest free position
and the nearest one lie on the boundary of that region.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import cached_property
from itertools import combinations

import questions
from arrangement import Point, direction, edges, plus
from questions import (
    RELATIONS,
    ZERO,
    clamped_foot,
    contact_with_edge,
    contacts,
    dot,
    impact,
    nearest_if_apart,
    text_of_contact,
    text_of_gap,
    text_of_number,
    text_of_point,
    text_of_position,
    text_of_way,
)
from regions import Part, Solid, Window, region, scaled, text_of_parts

CONTAINER = 1


class StatusError(Exception):
    """With the name of the status."""


class Scene:
    """The solids by their ids, and the polygon that moves: where it is before it is moved."""

    def __init__(self, solids: dict[int, Solid], moving: Solid) -> None:
        self.solids = dict(sorted(solids.items()))
        self.moving = moving

    def relation(self, t: Point) -> int:
        b = self.moving.moved(t)
        return min((questions.relation(a, b) for a in self.solids.values()), default=1)

    def parts(self, window: Window | None = None) -> list[Part]:
        """Of the free region; of the blocked one where there is neither window nor container."""
        reflected = Solid([[(-x, -y) for x, y in ring] for ring in self.moving.given])
        return region(list(self.solids.values()), reflected, window)

    @cached_property
    def boundary(self) -> list[list[Point]]:
        return [vertices for _, vertices in self.parts()]

    def best(self, towards: Point) -> Point | None:
        places = [p for ring in self.boundary for p in ring]
        return min(places, key=lambda p: (-dot(p, towards), p), default=None)

    def way_out(self, t: Point) -> Point | None:
        """The shortest one; of several, the smallest."""
        if self.relation(t) >= 0:
            return ZERO
        ends = {p for ring in self.boundary for p in ring}
        ends |= {clamped_foot(edge, t) for ring in self.boundary for edge in edges(ring)}
        ways = [direction(t, end) for end in ends]
        return min(ways, key=lambda way: (dot(way, way), way), default=None)


def text_of_distance(scene: Scene, t: Point) -> str:
    if not scene.solids:
        return "apart inf 0 none"
    b = scene.moving.moved(t)
    contacts_by_id = {key: nearest_if_apart(a, b) for key, a in scene.solids.items()}

    def squared_distance(key: int) -> Fraction:
        contact = contacts_by_id[key]
        return contact.squared_gap if contact is not None else Fraction(0)

    key = min(contacts_by_id, key=squared_distance)  # of several, the first one
    contact = contacts_by_id[key]
    lie = RELATIONS[scene.relation(t)]
    return f"{lie} {text_of_gap(contact)} {key} {text_of_contact(contact)}"


def text_of_cast(scene: Scene, t: Point, motion: Point) -> str:
    b = scene.moving.moved(t)
    impacts = [(impact(a, b, motion), key) for key, a in scene.solids.items()]
    hits = [(found.time, key, found.contact) for found, key in impacts if found.hit]
    time, key, contact = min(hits, key=lambda hit: hit[:2], default=(Fraction(1), 0, None))
    place = text_of_position(plus(t, scaled(motion, time)), scene.relation)
    rounded = text_of_number(questions.double_below(time))
    return f"{'hit' if hits else 'miss'} {rounded} {place} {key} {text_of_contact(contact)}"


def text_of_penetration(scene: Scene, t: Point) -> str:
    way = scene.way_out(t)
    if way is None:
        return f"inf 0 0 {text_of_position(t, scene.relation)} 0 none"
    end = plus(t, way)
    key, contact = 0, None
    if way != ZERO:
        b = scene.moving.moved(end)
        key, a = next((k, a) for k, a in scene.solids.items() if questions.relation(a, b) == 0)
        contact = contact_with_edge(a, b)
    place = text_of_position(end, scene.relation)
    return f"{text_of_way(way)} {place} {key} {text_of_contact(contact)}"


def text_of_best(scene: Scene, towards: Point) -> str:
    if towards == ZERO or CONTAINER not in scene.solids:
        raise StatusError("GCV_ERR_INVALID_ARGUMENT")
    best = scene.best(towards)
    return text_of_point(best) if best is not None else "none"


def text_of_free_region(scene: Scene) -> str:
    if CONTAINER not in scene.solids:
        raise StatusError("GCV_ERR_INVALID_ARGUMENT")
    return text_of_parts(scene.parts())


def text_of_window_region(scene: Scene, window: Window) -> str:
    x_min, y_min, x_max, y_max = window
    if x_min >= x_max or y_min >= y_max:
        raise StatusError("GCV_ERR_INVALID_ARGUMENT")
    return text_of_parts(scene.parts(window))


Pair = tuple[int, int, Solid, Solid]
"""The ids, and what they are."""


def text_of_pairs(pairs: list[Pair], distance: Fraction) -> str:
    """Of those no further apart than that."""
    if distance < 0:
        raise StatusError("GCV_ERR_INVALID_ARGUMENT")
    texts = []
    for i, j, a, b in pairs:
        contact = nearest_if_apart(a, b)
        if contact is None or contact.squared_gap <= distance**2:
            texts.append(f"{i} {j} {questions.text_of_relation(a, b)}")
    return "; ".join(texts) or "empty"


def text_of_contacts(pairs: list[Pair], distance: Fraction, slope: Fraction) -> str:
    if distance < 0 or slope < 0:
        raise StatusError("GCV_ERR_INVALID_ARGUMENT")
    found = [(i, j, contact) for i, j, a, b in pairs for contact in contacts(a, b, distance, slope)]
    found.sort(key=lambda contact: questions.root(contact[2].squared_gap))
    return "; ".join(f"{i} {j} {text_of_contact(contact)}" for i, j, contact in found) or "empty"


def pairs(scene: Scene) -> list[Pair]:
    return [(i, j, a, b) for (i, a), (j, b) in combinations(scene.solids.items(), 2)]


def pairs_with(scene: Scene, b: Solid) -> list[Pair]:
    return [(key, 0, a, b) for key, a in scene.solids.items()]


QUESTIONS: dict[str, Callable[..., str]] = {
    "relation": lambda scene, x, y: RELATIONS[scene.relation((x, y))],
    "distance": lambda scene, x, y: text_of_distance(scene, (x, y)),
    "cast": lambda scene, x, y, dx, dy: text_of_cast(scene, (x, y), (dx, dy)),
    "penetration": lambda scene, x, y: text_of_penetration(scene, (x, y)),
    "best": lambda scene, dx, dy: text_of_best(scene, (dx, dy)),
    "free_region": text_of_free_region,
    "window_region": lambda scene, *window: text_of_window_region(scene, window),
    "near": lambda scene, x, y, distance: text_of_pairs(
        pairs_with(scene, scene.moving.moved((x, y))), distance
    ),
    "pairs": lambda scene, distance: text_of_pairs(pairs(scene), distance),
    "contacts": lambda scene, *limits: text_of_contacts(pairs(scene), *limits),
}


def answer(scene: Scene, question: str, words: list[str]) -> str:
    """The status, and what the question asks for, for its numbers."""
    numbers = [float(word) for word in words]
    if not all(map(math.isfinite, numbers)):
        return "GCV_ERR_NOT_FINITE"
    try:
        return f"GCV_OK {QUESTIONS[question](scene, *map(Fraction, numbers))}"
    except StatusError as error:
        return str(error)
    except OverflowError:
        return "GCV_ERR_RANGE"

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The cases that all bindings share; tests/corpus/README.md describes the format."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import pytest
from shapes import REPOSITORY

import gcv

FUNCTIONS = {"no_fit": gcv.no_fit_polygon, "entrance": gcv.entrance_block}
REGIONS = {
    "no_fit_region": gcv.no_fit_region,
    "entrance_region": gcv.entrance_region,
    "inner_fit_region": gcv.inner_fit_region,
}
QUESTIONS = ("relation", "distance", "cast", "penetration", "contacts")
PARTS = {
    gcv.PART_OUTER: "outer",
    gcv.PART_HOLE: "hole",
    gcv.PART_SEGMENT: "segment",
    gcv.PART_POINT: "point",
}


def cases() -> Iterator[tuple[str, str, str, list[str], str]]:
    """The name, a, b, the lines of the scene and the line, for every line that says more."""
    name = a = b = ""
    scene: list[str] = []
    for line in (REPOSITORY / "tests/corpus/cases.txt").read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word == "case":
            name, a, b, scene = rest, "", "", []
        elif word == "a":
            a = rest
        elif word == "b":
            b = rest
        elif word in ("container", "member"):
            scene.append(line)
        elif word not in ("", "#"):
            yield name, a, b, scene, line


def vertices(exact: list[tuple[Fraction, Fraction]]) -> str:
    return ", ".join(
        f"{x.numerator}/{x.denominator} {y.numerator}/{y.denominator}" for x, y in exact
    )


def parts(region: gcv.Region) -> str:
    exact = region.exact
    texts = [
        f"{PARTS[part.kind]} {vertices(exact[part.start : part.stop])}"
        for part in region.exact_parts
    ]
    return "; ".join(texts) or "empty"


def numbers(*values: float) -> str:
    return " ".join(f"{x:.17g}" for x in values)


def contact(contact: gcv.Contact | None) -> str:
    if contact is None:
        return "none"
    name = f"{contact.kind.name.lower()} {contact.a} {contact.b}"
    return f"{name} {numbers(contact.gap, *contact.on_a, *contact.on_b)}"


def position(found: gcv.Impact | gcv.Escape, line: str) -> str:
    """None where the exact one is no pair of floats."""
    exact = f"{found.relation.name.lower()} {numbers(*found.position)}"
    return "inexact" if " inexact" in line else exact


def separation(found: gcv.Separation, key: str = "") -> str:
    lie = f"{found.relation.name.lower()} {numbers(found.distance)}"
    return f"{lie} {key}{contact(found.nearest)}"


def escape(found: gcv.Escape, line: str, key: str = "") -> str:
    way = numbers(found.depth, *found.translation)
    return f"{way} {position(found, line)} {key}{contact(found.contact)}"


def impact(found: gcv.Impact, line: str, key: str = "") -> str:
    time = f"{'hit' if found.hit else 'miss'} {numbers(found.time)}"
    return f"{time} {position(found, line)} {key}{contact(found.contact)}"


def words_of_question(line: str) -> tuple[str, list[float]]:
    word, *words = line[: line.index(" GCV_")].split(" ")
    return word, list(map(float, words))


def answer(a: str, b: str, line: str) -> str:
    """What the line asks for."""
    word, (x, y, *more) = words_of_question(line)
    if word == "relation":
        return gcv.relation(a, b, (x, y)).name.lower()
    if word == "distance":
        return separation(gcv.distance(a, b, (x, y)))
    if word == "penetration":
        return escape(gcv.penetration(a, b, (x, y)), line)
    if word == "contacts":
        found = gcv.contacts(a, b, (x, y), *more)
        return "; ".join(map(contact, found)) or "empty"
    return impact(gcv.cast(a, b, (x, y), (more[0], more[1])), line)


def scene_of(lines: list[str]) -> gcv.Scene:
    scene = gcv.Scene()
    for line in lines:
        word, _, rest = line.partition(" ")
        if word == "container":
            scene.container = rest
        else:
            x, y, wkt = rest.split(" ", 2)
            scene.add(wkt, (float(x), float(y)))
    return scene


def pairs(found: gcv.PairList) -> str:
    return "; ".join(f"{a} {b} {relation.name.lower()}" for a, b, relation in found) or "empty"


def scene_answer(scene: gcv.Scene, b: str, line: str) -> str:
    """What the line asks for."""
    word, values = words_of_question(line)
    if word == "scene_free_region":
        return parts(scene.free_region(b))
    if word == "scene_window_region":
        return parts(scene.free_region(b, values))
    if word == "scene_pairs":
        return pairs(scene.pairs(values[0]))
    if word == "scene_contacts":
        found = scene.contacts(values[0], values[1])
        return "; ".join(f"{c.id_a} {c.id_b} {contact(c)}" for c in found) or "empty"
    x, y, *more = values
    if word == "scene_near":
        return pairs(scene.near(b, (x, y), *more))
    if word == "scene_best":
        best = scene.best(b, (x, y))
        if best is None:
            return "none"
        return "inexact" if line.endswith(" inexact") else numbers(*best)
    if word == "scene_relation":
        return scene.relation(b, (x, y)).name.lower()
    if word == "scene_distance":
        nearest = scene.distance(b, (x, y))
        return separation(nearest, f"{nearest.id} ")
    if word == "scene_penetration":
        way = scene.penetration(b, (x, y))
        return escape(way, line, f"{way.id} ")
    hit = scene.cast(b, (x, y), (more[0], more[1]))
    return impact(hit, line, f"{hit.id} ")


def outcome(a: str, b: str, scene: list[str], line: str) -> str:
    """The status, and the ring, the region or the refused text, that the line should have."""
    word, *words = line.split(" ")
    refused = line.split(" ", 2)[2] if word == "refuse" else ""
    try:
        if word == "refuse":
            gcv.Polygon(refused)
            return "GCV_OK"
        if word == "sum":
            return f"GCV_OK {vertices(gcv.minkowski_sum(a, b).exact)}"
        if word == "sum_region":
            return f"GCV_OK {parts(gcv.minkowski_sum_region(a, b))}"
        if word.startswith("scene_"):
            return f"GCV_OK {scene_answer(scene_of(scene), b, line)}"
        if word in QUESTIONS:
            return f"GCV_OK {answer(a, b, line)}"
        point = float(words[0]), float(words[1])
        if word in REGIONS:
            return f"GCV_OK {parts(REGIONS[word](a, b, point))}"
        return f"GCV_OK {vertices(FUNCTIONS[word](a, b, point).exact)}"
    except gcv.Error as error:
        return f"{error.status_name} {refused}".rstrip()


CASES = list(cases())
ONE_PART = "MULTIPOLYGON (((0 0, 1 0, 0 1)))"
"""The library refuses this text. Python takes the one polygon of it, as it does from GeoJSON."""


@pytest.mark.parametrize(
    ("name", "a", "b", "scene", "line"), CASES, ids=[case[0] for case in CASES]
)
def test_case(name: str, a: str, b: str, scene: list[str], line: str) -> None:
    expected = "GCV_OK" if line.endswith(ONE_PART) else line[line.index("GCV_") :]
    assert outcome(a, b, scene, line) == expected

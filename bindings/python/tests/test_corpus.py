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


def cases() -> Iterator[tuple[str, str, str, str]]:
    """The name, a, b and what else it says, for every line that says more."""
    name = a = b = ""
    for line in (REPOSITORY / "tests/corpus/cases.txt").read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word == "case":
            name, a, b = rest, "", ""
        elif word == "a":
            a = rest
        elif word == "b":
            b = rest
        elif word not in ("", "#"):
            yield name, a, b, line


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


def answer(a: str, b: str, line: str) -> str:
    """What the line asks for."""
    word, *words = line[: line.index(" GCV_")].split(" ")
    translation = float(words[0]), float(words[1])
    if word == "relation":
        return gcv.relation(a, b, translation).name.lower()
    if word == "distance":
        distance, relation, nearest, _ = gcv.distance(a, b, translation)
        return f"{relation.name.lower()} {numbers(distance)} {contact(nearest)}"
    if word == "penetration":
        escape = gcv.penetration(a, b, translation)
        way = numbers(escape.depth, *escape.translation)
        return f"{way} {position(escape, line)} {contact(escape.contact)}"
    more = float(words[2]), float(words[3])
    if word == "contacts":
        found = gcv.contacts(a, b, translation, *more)
        return "; ".join(map(contact, found)) or "empty"
    impact = gcv.cast(a, b, translation, more)
    time = f"{'hit' if impact.hit else 'miss'} {numbers(impact.time)}"
    return f"{time} {position(impact, line)} {contact(impact.contact)}"


def outcome(a: str, b: str, line: str) -> str:
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


@pytest.mark.parametrize(("name", "a", "b", "line"), CASES, ids=[case[0] for case in CASES])
def test_case(name: str, a: str, b: str, line: str) -> None:
    expected = "GCV_OK" if line.endswith(ONE_PART) else line[line.index("GCV_") :]
    assert outcome(a, b, line) == expected

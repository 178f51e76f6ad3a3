# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The cases that all bindings share; tests/corpus/README.md describes the format."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from shapes import REPOSITORY

import gcv

FUNCTIONS = {"no_fit": gcv.no_fit_polygon, "entrance": gcv.entrance_block}


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


def ring(face: gcv.OuterFace) -> str:
    return ", ".join(
        f"{x.numerator}/{x.denominator} {y.numerator}/{y.denominator}" for x, y in face.exact
    )


def outcome(a: str, b: str, line: str) -> str:
    """The status and the ring, or the status and the refused text, that the line should have."""
    word, *words = line.split(" ")
    refused = line.split(" ", 2)[2] if word == "refuse" else ""
    try:
        if word == "refuse":
            gcv.Polygon(refused)
            return "GCV_OK"
        if word == "sum":
            return f"GCV_OK {ring(gcv.minkowski_sum(a, b))}"
        point = float(words[0]), float(words[1])
        return f"GCV_OK {ring(FUNCTIONS[word](a, b, point))}"
    except gcv.Error as error:
        return f"{error.status_name} {refused}".rstrip()


CASES = list(cases())


@pytest.mark.parametrize(("name", "a", "b", "line"), CASES, ids=[case[0] for case in CASES])
def test_case(name: str, a: str, b: str, line: str) -> None:
    assert outcome(a, b, line) == line[line.index("GCV_") :]

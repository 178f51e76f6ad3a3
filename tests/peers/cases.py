# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the suites; README.md describes the format."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from point_set import Ring


@dataclass
class Case:
    name: str
    a: str = ""
    b: str = ""
    operation: str = ""
    reference: tuple[float, float] = (0.0, 0.0)
    theirs: list[Ring] = field(default_factory=list)
    missing: list[Ring] = field(default_factory=list)
    why: str = ""


@dataclass
class Suite:
    rounding: Fraction = Fraction(0)
    cases: list[Case] = field(default_factory=list)


def rings_of(wkt: str) -> list[Ring]:
    """The rings of any geometry of Well-Known Text, without the vertices that close them."""
    rings = []
    for text in re.findall(r"\(([^()]+)\)", wkt):
        ring = [_point(pair) for pair in text.split(",")]
        rings.append(ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring)
    return rings


def _point(text: str) -> tuple[Fraction, Fraction]:
    x, y = text.split()
    return Fraction(x), Fraction(y)


def vertices_of(text: str) -> Ring:
    """From "p/q r/s, ..."."""
    return [_point(pair) for pair in text.split(",")]


def read_suite(file: Path, data: Path | None) -> Suite | None:
    """None for a suite that needs the data, where it is missing."""
    suite = Suite()
    case = Case("")
    for line in file.read_text().splitlines():
        word, _, rest = line.partition(" ")
        if rest.endswith(".wkt"):
            if data is None:
                return None
            rest = (data / rest).read_text()
        if word == "rounding":
            suite.rounding = Fraction(rest)
        elif word == "case":
            case = Case(rest)
            suite.cases.append(case)
        elif word in ("a", "b", "why"):
            setattr(case, word, rest)
        elif word == "theirs":
            case.theirs += rings_of(rest)
        elif word == "missing":
            for part in rest.split("; "):
                case.missing.append(vertices_of(part.partition(" ")[2]))
        elif word in ("sum", "no_fit", "inner_fit"):
            x, y = rest.split() or ("0", "0")
            case.operation, case.reference = word, (float(x), float(y))
        elif word not in ("", "#"):
            raise ValueError(f"{file}: what is {line!r}?")
    return suite

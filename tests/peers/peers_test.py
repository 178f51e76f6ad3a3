# SPDX-License-Identifier: LGPL-3.0-or-later
"""The suites of others: each case by the library, against their answer as a set of points.

Takes the file of a suite. Fails on a difference that the file does not explain, and on an
explanation that is not needed. With --cgal there are further answers, by that program.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from collections import Counter
from fractions import Fraction
from pathlib import Path

import gcv
from cases import Case, read_suite, rings_of, vertices_of
from point_set import Point, PointSet, Ring, point_set, snapped

BESIDE = Path(__file__).resolve().parents[3] / "shared/data"
SKIPPED = 77


def data_directory() -> Path | None:
    directory = Path(os.environ.get("GCV_DATA_DIR", BESIDE))
    return directory if (directory / "pairs.txt").exists() else None


def ours(case: Case) -> list[Ring]:
    """All parts of the exact region."""
    a, b = gcv.Polygon(case.a), gcv.Polygon(case.b)
    if case.operation == "sum":
        region = gcv.minkowski_sum_region(a, b)
    elif case.operation == "no_fit":
        region = gcv.no_fit_region(a, b, case.reference)
    else:
        region = gcv.inner_fit_region(a, b, case.reference)
    vertices = region.exact
    return [vertices[part.start : part.stop] for part in region.exact_parts]


def doubles(wkt: str) -> str:
    rings = [", ".join(f"{float(x)!r} {float(y)!r}" for x, y in ring) for ring in rings_of(wkt)]
    return "; ".join(rings)


def by_cgal(program: Path, case: Case) -> dict[str, list[Ring]]:
    """What each of its methods gives."""
    text = f"a {doubles(case.a)}\nb {doubles(case.b)}\n"
    answer = subprocess.run([program], input=text, capture_output=True, text=True, check=True)
    sums: dict[str, list[Ring]] = {}
    for line in answer.stdout.splitlines():
        word, _, rest = line.partition(" ")
        if word == "method":
            rings = sums[rest] = []
        else:
            rings.append(vertices_of(rest))
    return sums


def differences(theirs: PointSet, right: PointSet) -> str:
    counts = [
        f"{len(mine - their)} of {len(mine)} {name} missing, {len(their - mine)} too many"
        for name, their, mine in zip(PointSet._fields, theirs, right)
        if their != mine
    ]
    return "; ".join(counts)


def verdict(
    case: Case, rounding: Fraction, answer: list[Ring], right: PointSet, vertices: set[Point]
) -> str:
    """One of "equal", "rounded", "explained"; or what is wrong."""
    if not case.missing and point_set(answer) == right:
        return "equal"
    on_vertices = [snapped(ring, vertices, rounding) for ring in answer]
    completed = point_set(on_vertices + case.missing)
    if completed != right:
        return differences(completed, right)
    if not case.missing:
        return "rounded"
    for part in case.missing:
        if point_set(on_vertices + [other for other in case.missing if other != part]) == right:
            return "an explanation that is not needed"
    return "explained" if case.why else "a difference without an explanation"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("suite", type=Path)
    parser.add_argument("--cgal", type=Path, help="a program that computes sums by CGAL")
    options = parser.parse_args()
    suite = read_suite(options.suite, data_directory())
    if suite is None:
        print("skipped: no polygon data in ../shared/data: set GCV_DATA_DIR")
        return SKIPPED
    counts: Counter[str] = Counter()
    wrong = []
    for case in suite.cases:
        answers = {"theirs": case.theirs} if case.theirs else {}
        if options.cgal:
            answers |= by_cgal(options.cgal, case)
        rings = ours(case)
        right = point_set(rings)
        vertices = {vertex for ring in rings for vertex in ring}
        for name, answer in answers.items():
            found = verdict(case, suite.rounding, answer, right, vertices)
            if found in ("equal", "rounded", "explained"):
                counts[found] += 1
            else:
                wrong.append(f"{case.name}, {name}: {found}")
        if not answers:
            wrong.append(f"{case.name}: no answer")
    print(*wrong, sep="\n", end="\n" if wrong else "")
    print(
        f"{len(suite.cases)} cases, {counts.total()} answers as they should be: "
        f"{counts['equal']} equal, {counts['rounded']} equal when rounded by up to "
        f"{float(suite.rounding):g}, {counts['explained']} different and explained; "
        f"{len(wrong)} wrong"
    )
    return 1 if wrong or not suite.cases else 0


if __name__ == "__main__":
    sys.exit(main())

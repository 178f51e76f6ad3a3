# SPDX-License-Identifier: LGPL-3.0-or-later
"""Prints the table of docs/METHOD.md: the sizes of supersets, and what the methods take."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Optional

from compare import (
    CGAL,
    GCVMSOF,
    OWN,
    RCMSOF,
    Row,
    cell,
    check_superset_sizes,
    disagreements,
    machine_description,
    measure,
    number,
    ratio,
    table,
)

FULL = "CGAL full convolution"
NO_CYCLE = "libgcv without cycle"
NO_MERGE = "libgcv without merge"
SYSTEMS = [OWN, NO_CYCLE, NO_MERGE, CGAL, FULL, GCVMSOF, RCMSOF]

MACHINE = ["date", "machine", "load, of 15 minutes", "compiler", "libgcv", "CGAL"]

SUPERSETS = ["all_pairs", "full_convolution", "convolution_cycles", "reduced_convolution", "gcv"]

HEAD = ["pair", "A", "B", "all", "full", "cycles", "reduced", "GCV", "ring", "libgcv ms",
        "by search", "GCVMSOF", "RCMSOF", "CGAL reduced", "CGAL full"]  # fmt: skip

LEGEND = """\
A, B: vertices (reflex ones). Edges of the supersets, of the polygons without collinear vertices:
*all* pairs of an edge and a vertex; the *full* convolution; the convolution *cycles*; the *reduced*
convolution; *GCV*, the paper's. *ring*: vertices of the outer face. The last six columns are
times, medians: libgcv's in milliseconds, the others in times of it. *by search*: libgcv without its
own ways for pairs of which one polygon is convex, or both are. -: not tried; >: cut off.
"""


def times(row: Row, system: str, limit: float) -> str:
    """Return how many times longer the system took than libgcv."""
    failure = row["results"].get(system, {}).get("failure", "")
    if failure and not failure.startswith(">"):
        return str(failure)
    value: Optional[float] = ratio(row, system, limit)
    return "-" if value is None else ("> " if failure else "") + number(value)


def by_search(row: Row, limit: float) -> str:
    """Return what a search for each step takes where libgcv has a way without one."""
    convex = sum(row[polygon]["reflex"] == 0 for polygon in "ab")
    return "-" if convex == 0 else times(row, NO_CYCLE if convex == 1 else NO_MERGE, limit)


def line(row: Row, limit: float) -> list[str]:
    return [
        row["pair"],
        *(f"{row[polygon]['vertices']} ({row[polygon]['reflex']})" for polygon in "ab"),
        *(str(row["supersets"][name]) for name in SUPERSETS),
        str(row["results"][OWN]["vertices"]),
        cell(row, OWN),
        by_search(row, limit),
        *(times(row, system, limit) for system in (GCVMSOF, RCMSOF, CGAL, FULL)),
    ]


def check_sizes(rows: list[Row]) -> None:
    """Check that the arrangements are those of supersets of the sizes in the table."""
    for row in rows:
        for system, name in ((GCVMSOF, "gcv"), (RCMSOF, "reduced_convolution")):
            edges = row["results"].get(system, {}).get("superset_edges")
            if edges is not None and edges != row["supersets"][name]:
                raise AssertionError(
                    f"{row['pair']}: {system} has {edges} superset edges, "
                    f"not {row['supersets'][name]}"
                )


def report(machine: dict[str, str], rows: list[Row], limit: float) -> str:
    found = disagreements(rows) or ["All results agree with libgcv's."]
    return "\n".join(
        [
            "".join(f"- {key}: {machine[key]}\n" for key in MACHINE),
            LEGEND,
            table(HEAD, [line(row, limit) for row in rows]),
            "".join(f"- {sentence}\n" for sentence in found),
        ]
    )


def main() -> None:
    parser = argparse.ArgumentParser(prog="bench/method", description=__doc__)
    parser.add_argument("--rounds", type=int, default=5, help="of every system on every pair (5)")
    parser.add_argument("--limit", type=float, default=20, help="seconds for one sum (20)")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the table there too")
    options = parser.parse_args()
    arguments = ["--sets", "method", "--systems", ",".join(SYSTEMS)]
    arguments += ["--limit", str(options.limit), "--rounds", str(options.rounds)]
    rows = measure(arguments)
    text = report(machine_description(), rows, options.limit)
    print(text)
    if options.markdown:
        options.markdown.write_text(text, encoding="utf-8")
    check_sizes(rows)
    check_superset_sizes([row for row in rows if row["pair"] in ("stars", "comb", "fork", "knife")])


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: LGPL-3.0-or-later
"""Times questions about two polygons beside other systems, and counts wrong answers."""

from __future__ import annotations

import argparse
import json
import math
import statistics
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Optional

import matplotlib as mpl
from compare import BUILD, ROOT, Bar, machine_description, number, table
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

Row = dict[str, Any]  # one question about one pair at the placements of one kind
Result = dict[str, Any]  # one system's: a failure, or times and verdict

OWN, SINGLE, ANEW = "libgcv", "libgcv, one at a time", "libgcv, polygons made anew"
GEOS_BOTH = "GEOS prepared, intersects and touches"
GEOS_ALONE = "GEOS prepared, intersects alone"
GEOS_DISTANCE = "GEOS prepared distance"
PARRY = {"relation": "parry, intersection_test", "distance": "parry, distance",
         "cast": "parry, cast_shapes"}  # fmt: skip

CONVEX, NESTING, COASTS = "convex, 4 to 20 vertices", "nesting parts", "coasts 100000"
LARGE = 60  # vertices of each polygon

TITLES = {
    ("relation", "near"): "Apart, touching or overlapping, near contact",
    ("relation", "contact"): "Apart, touching or overlapping, in contact",
    ("distance", "near"): "Distance, near contact",
    ("distance", "contact"): "Distance, in contact",
    ("distance", "motion"): "Distance, where they are apart",
    ("cast", "motion"): "Motion up to the first overlap",
}

STYLES = {  # colour and marker
    OWN: ("#0b3d91", "o"),
    GEOS_BOTH: ("#c0392b", "s"),
    GEOS_ALONE: ("#e67e22", "P"),
    GEOS_DISTANCE: ("#c0392b", "s"),
    "GEOS indexed distance": ("#e67e22", "P"),
    "Boost.Geometry, intersects and touches": ("#7f6a55", "h"),
    "Boost.Geometry distance": ("#7f6a55", "h"),
    "CGAL EPICK, do_intersect of all edges": ("#2e7d32", "^"),
    "CGAL EPICK, squared_distance of all edges": ("#2e7d32", "^"),
    "CGAL EPECK, do_intersect of polygons": ("#14a098", "D"),
    PARRY["relation"]: ("#8e44ad", "v"),
    PARRY["distance"]: ("#8e44ad", "v"),
}
DRAWN = (CONVEX, NESTING, "growing shapes", "coasts 10000")


# -------------------------------------------------------------------------- results --


def result(row: Row, system: str) -> Optional[Result]:
    """Return what the system did, if it answered."""
    found = row["results"].get(system)
    return None if found is None or "failure" in found else dict(found)


def results(rows: Iterable[Row], system: str) -> list[Result]:
    return [found for row in rows if (found := result(row, system)) is not None]


def of(rows: list[Row], question: str, kind: str, family: Optional[str] = None) -> list[Row]:
    return [row for row in rows if (row["question"], row["kind"]) == (question, kind)
            and family in (None, row["family"])]  # fmt: skip


def large(rows: list[Row]) -> list[Row]:
    return [row for row in rows if min(row["a"], row["b"]) >= LARGE]


def families(rows: list[Row]) -> list[str]:
    return list(dict.fromkeys(row["family"] for row in rows))


def systems(rows: list[Row]) -> list[str]:
    return list(dict.fromkeys(system for row in rows for system in row["results"]))


def like(system: str) -> str:
    """Return the way of libgcv's that a system is compared to."""
    return ANEW if "made anew" in system else OWN


def ratios(rows: list[Row], system: str) -> list[float]:
    """Return how many times as long as libgcv the system takes on each pair."""
    if like(system) == OWN:
        return [float(found["ratio"]) for found in results(rows, system)]
    return [peer["ns"] / own["ns"] for row in rows
            if (peer := result(row, system)) and (own := result(row, ANEW))]  # fmt: skip


def share(rows: list[Row], system: str, key: str) -> Optional[float]:
    """Return a share of all answers, None where the system gives none."""
    found = [r for r in results(rows, system) if key in r]
    answers = sum(r["answers"] for r in found)
    return sum(r[key] for r in found) / answers if answers else None


def worst(rows: list[Row], system: str, key: str = "worst") -> float:
    return max((float(r[key]) for r in results(rows, system)), default=math.nan)


def percent(part: Optional[float]) -> str:
    if part is None:
        return "-"
    return "0" if part == 0 else f"{100 * part:.2g} %"


def scientific(x: float) -> str:
    return "0" if x == 0 else f"{x:.1e}"


def large_number(x: float) -> str:
    return f"{x:.0f}" if x >= 100 else number(x)


# --------------------------------------------------------------------------- tables --


def time_cell(rows: list[Row], system: str) -> str:
    found = results(rows, system)
    if not found:
        return "-"
    if system.startswith(OWN):
        return large_number(statistics.median(r["ns"] for r in found))
    times = ratios(rows, system)
    return f"{large_number(statistics.median(times))} ({large_number(min(times))})"


def time_table(rows: list[Row]) -> str:
    names = families(rows)
    lines = [["pairs", *(str(sum(row["family"] == name for row in rows)) for name in names)]]
    for system in systems(rows):
        unit = "ns" if system.startswith(OWN) else f"times {like(system)}"
        lines.append([f"{system}: {unit}", *(time_cell(of_family(rows, n), system) for n in names)])
    return table(["", *names], lines)


def of_family(rows: list[Row], family: str) -> list[Row]:
    return [row for row in rows if row["family"] == family]


def judged(rows: list[Row]) -> list[str]:
    """Return the systems whose answers are told: of each, one way to ask."""
    return [name for name in systems(rows) if name != SINGLE and "made anew" not in name]


def wrong_cell(rows: list[Row], system: str) -> str:
    wrong, of_rounded = (share(rows, system, key) for key in ("wrong", "wrong_of_rounded"))
    return percent(wrong) + ("" if of_rounded is None else f" ({percent(of_rounded)})")


def wrong_table(rows: list[Row]) -> str:
    names = families(rows)
    lines = [
        [system, *(wrong_cell(of_family(rows, name), system) for name in names)]
        for system in judged(rows)
    ]
    return table(["", *names], lines)


def error_table(rows: list[Row]) -> str:
    """Sum the errors of distances or times up over all families."""
    lines = []
    for system in judged(rows):
        cells = [percent(share(rows, system, key)) for key in
                 ("not_nearest", "not_nearest_of_rounded", "wrong", "wrong_of_rounded",
                  "gross")]  # fmt: skip
        count = sum(r["answers"] for r in results(rows, system))
        lines.append([system, str(count), *cells, scientific(worst(rows, system))])
    head = ["", "answers", "not the nearest double", "of B as moved", "off by 10^-12 of it",
            "of B as moved", "off by 10^-9 of the size", "the worst"]  # fmt: skip
    return table(head, lines)


def wrong_answers(rows: list[Row]) -> str:
    parts = []
    for (question, kind), title in TITLES.items():
        chosen = of(rows, question, kind)
        if not chosen:
            continue
        parts.append(f"### {title}\n")
        if question == "relation":
            counts = [sum(row[key] for row in chosen) for key in ("apart", "zero")]
            total = sum(r["answers"] for r in results(chosen, SINGLE))
            parts.append(f"{counts[0]} of {total} are apart, {counts[1]} touch.\n")
        if all(not share(chosen, system, "wrong") for system in systems(chosen)):
            parts.append("No system is wrong.\n")
            continue
        parts.append(wrong_table(chosen))
        if question != "relation":
            parts.append(error_table(chosen))
    return "\n".join(parts)


def quicker_peers(rows: list[Row]) -> str:
    """List where a system is quicker than libgcv on some pairs."""
    lines = []
    for (question, kind), title in TITLES.items():
        for family in families(rows):
            chosen = of(rows, question, kind, family)
            for system in systems(chosen):
                if not system.startswith(OWN):
                    lines += quicker_line([title, family, system], chosen, system)
    head = ["question", "pairs", "system", "quicker on", "median ratio", "least", "on the pair",
            "its ns", "libgcv's ns", "its wrong answers"]  # fmt: skip
    return table(head, lines) if lines else "None is quicker on any pair.\n"


def quicker_line(names: list[str], rows: list[Row], system: str) -> list[list[str]]:
    times = ratios(rows, system)
    quicker = sum(ratio < 1 for ratio in times)
    if not quicker:
        return []
    chosen = [row for row in rows if result(row, system) is not None]
    row = chosen[times.index(min(times))]
    pair = f"{row['pair']} ({row['a']} / {row['b']})"
    ns = [large_number(row["results"][name]["ns"]) for name in (system, like(system))]
    return [[*names, f"{quicker} of {len(times)}", number(statistics.median(times)),
             number(min(times)), pair, *ns, percent(share(rows, system, "wrong"))]]  # fmt: skip


# -------------------------------------------------------------------------- the bars --


def median_of(values: list[float]) -> Optional[float]:
    return statistics.median(values) if values else None


def bars(rows: list[Row]) -> list[Bar]:
    found = []

    def beside(question: str, kind: str, peer: str, nesting: float, of_large: float) -> None:
        chosen = of(rows, question, kind)
        for name, some, bound in (
            ("nesting", of_family(chosen, NESTING), nesting),
            (f"≥ {LARGE} vertices", large(chosen), of_large),
        ):
            title = f"{question}, {kind}, {name}: {peer}"
            found.append(Bar(title, median_of(ratios(some, peer)), bound))

    for kind in ("near", "contact"):
        beside("relation", kind, GEOS_BOTH, 3, 20)
        beside("relation", kind, GEOS_ALONE, 3, 20)
    for kind in ("near", "contact", "motion"):
        beside("distance", kind, GEOS_DISTANCE, 5, 20)
    for question, kind in TITLES:
        times = ratios(of(rows, question, kind, CONVEX), PARRY[question])
        title = f"{question}, {kind}, convex: parry, the least"
        found.append(Bar(title, min(times, default=None), 1))
    for kind in ("near", "contact"):
        own = results(of(rows, "relation", kind, COASTS), OWN)
        slowest = max((float(r["slowest_ns"]) / 1000 for r in own), default=None)
        title = f"relation, {kind}, {COASTS}: µs of the slowest question"
        found.append(Bar(title, slowest, 20, False))
    for family in families(rows):
        casts, distances = (results(of(rows, question, "motion", family), OWN)
                            for question in ("cast", "distance"))  # fmt: skip
        quotients = [cast["ns"] / distance["ns"] for cast, distance in zip(casts, distances)]
        title = f"cast : distance, {family}, the largest"
        found.append(Bar(title, max(quotients, default=None), 3, False))
    return found


# -------------------------------------------------------------------------- picture --

LEAST = {"relation": 1e-4, "distance": 1e-19}  # of the errors that are drawn as they are


def error(rows: list[Row], question: str, system: str) -> float:
    if question == "relation":
        return share(rows, system, "wrong") or 0.0
    return worst(rows, system)


def draw(axes: Axes, rows: list[Row], question: str) -> None:
    """Draw time against error of each system, near contact and in contact."""
    least = LEAST[question]
    zero = least / 10
    for system, (colour, marker) in STYLES.items():
        places = []
        for kind in ("near", "contact"):
            chosen = of(rows, question, kind)
            if found := results(chosen, system):
                wrong = error(chosen, question, system)
                places.append((statistics.median(r["ns"] for r in found),
                               max(wrong, least) if wrong > 0 else zero, kind))  # fmt: skip
        axes.plot([x for x, _, _ in places], [y for _, y, _ in places], color=colour, linewidth=1,
                  alpha=0.6, zorder=2)  # fmt: skip
        for x, y, kind in places:
            axes.plot(x, y, marker, color=colour, markersize=6, zorder=3,
                      markerfacecolor="white" if kind == "near" else colour)  # fmt: skip
    axes.set(xscale="log", yscale="log", ylim=(zero / 4, 2))
    axes.axhspan(zero / 4, zero * 2, color="#e8f3e8", zorder=0)
    decades = range(-4, 1) if question == "relation" else range(-18, 1, 3)
    names = [f"{100 * 10.0**k:g} %" if question == "relation" else f"$10^{{{k}}}$" for k in decades]
    axes.set_yticks([zero, *(10.0**k for k in decades)], ["0", *names])
    axes.minorticks_off()
    axes.grid(color="#e2e2e2", linewidth=0.6, zorder=1)
    axes.set_title(rows[0]["family"], fontsize=10)
    axes.set_xlabel(f"{question}: nanoseconds of one question", fontsize=9)
    axes.set_ylabel("wrong answers" if question == "relation" else "worst error / size", fontsize=9)


def picture(rows: list[Row]) -> Figure:
    shown = [family for family in DRAWN if of_family(rows, family)]
    figure = Figure(figsize=(3.6 * len(shown), 8.2), layout="constrained")
    for line, question in enumerate(("relation", "distance")):
        for k, family in enumerate(shown):
            axes = figure.add_subplot(2, len(shown), line * len(shown) + k + 1)
            draw(axes, of_family(rows, family), question)
    handles = [Line2D([], [], color=colour, marker=marker, label=system)
               for system, (colour, marker) in STYLES.items()]  # fmt: skip
    handles += [Line2D([], [], color="#555", linestyle="", marker="o", markerfacecolor=face,
                       label=label)
                for face, label in (("white", "near contact"), ("#555", "in contact"))]  # fmt: skip
    figure.legend(handles=handles, loc="outside lower center", ncols=4, fontsize=8, frameon=False)
    return figure


# ------------------------------------------------------------------------------ run --


def machine() -> str:
    known = machine_description()
    versions = {"GEOS": "libgeos-dev", "Boost.Geometry": "libboost-dev", "CGAL": "libcgal-dev",
                "GMP": "libgmp-dev"}  # fmt: skip
    for name, package in versions.items():
        command = ["dpkg-query", "-W", "-f=${Version}", package]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        known[name] = done.stdout or "unknown"
    lock = (ROOT / "bench" / "contact" / "parry" / "Cargo.lock").read_text(encoding="utf-8")
    known["parry2d-f64"] = lock.split('name = "parry2d-f64"\nversion = "')[1].split('"')[0]
    left_out = {"SFCGAL", "Clipper", "Boost.Polygon"}
    return "".join(f"- {key}: {value}\n" for key, value in known.items() if key not in left_out)


def report(rows: list[Row], described: str) -> str:
    parts = [
        described,
        "Of libgcv nanoseconds of one question, the median of the pairs. Of others, times as long "
        "as libgcv with many questions at once: the median of the pairs, and the least.\n",
    ]
    for (question, kind), title in TITLES.items():
        if chosen := of(rows, question, kind):
            parts += [f"## {title}\n", time_table(chosen)]
    parts += ["## Wrong answers\n", wrong_answers(rows)]
    parts += ["## Quicker than libgcv\n", quicker_peers(rows)]
    parts += ["## Bars\n", table(["bar", "asked", "measured", ""], [b.cells() for b in bars(rows)])]
    return "\n".join(parts)


def measure(arguments: list[str]) -> list[Row]:
    rows: list[Row] = []
    with subprocess.Popen(
        [str(BUILD / "bench" / "gcv_contacts"), *arguments], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            row: Row = json.loads(line)
            rows.append(row)
            own = row["results"].get(OWN, {}).get("ns", math.nan)
            print(f"{row['family']}: {row['pair']}: {row['question']}, {row['kind']}: {own:.0f} ns",
                  file=sys.stderr)  # fmt: skip
    if process.returncode != 0 or not rows:
        sys.exit("bench/contacts: nothing was measured")
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(prog="bench/contacts", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer and smaller pairs, no picture")
    parser.add_argument("--families", help="only these, as named in the tables, with ; between")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there too")
    parser.add_argument("--draw", action="store_true", help="from the results of the last run")
    options = parser.parse_args()
    file = BUILD / "contacts.json"
    if not options.draw:
        arguments = ["--quick"] * options.quick
        if options.families:
            arguments += ["--families", options.families]
        rows = measure(arguments)
        text = json.dumps({"machine": machine(), "rows": rows}, indent=1)
        file.write_text(text, encoding="utf-8")
    known = json.loads(file.read_text(encoding="utf-8"))
    text = report(known["rows"], known["machine"])
    print(text)
    (BUILD / "contacts_wrong.md").write_text(wrong_answers(known["rows"]), encoding="utf-8")
    if options.markdown:
        options.markdown.write_text("# Questions about two polygons\n\n" + text, encoding="utf-8")
    if not options.quick and not options.families:
        mpl.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "gcv"})
        picture(known["rows"]).savefig(ROOT / "bench" / "contacts.svg", metadata={"Date": None})


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: LGPL-3.0-or-later
"""Holds the time of each system against its error, and reports it with pictures."""

from __future__ import annotations

import argparse
import html
import json
import math
import re
import statistics
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Optional

import matplotlib as mpl
from compare import BUILD, ROOT, machine_description, number
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

Row = dict[str, Any]  # one pair: its results, and how large its polygons are
Result = dict[str, Any]  # one system at one setting: a failure, or time and verdict

REPORT = ROOT / "bench" / "report"

NEAREST, OUTWARD = "libgcv, nearest", "libgcv, outward"
COLD = (NEAREST, OUTWARD)
PREPARED, PLAIN = "libgcv, prepared", "libgcv, plain doubles"

STYLES = {  # colour and marker
    NEAREST: ("#0b3d91", "o"),
    OUTWARD: ("#2e9bd6", "^"),
    PREPARED: ("#14a098", "D"),
    PLAIN: ("#8e44ad", "v"),
    "CGAL reduced convolution": ("#c0392b", "s"),
    "SFCGAL": ("#e67e22", "P"),
    "Clipper": ("#2e7d32", "o"),
    "Boost.Polygon": ("#7f6a55", "h"),
}
MAIN = ("fork", "~monkey", "rotated slot", "coasts 10000 x 10000", "coasts 1000 x 1000")

LEAST_ERROR = 1e-19  # of those that are drawn as they are
FINE = 1e-9  # an error that few would mind
ZERO = 1e-20  # where errors of 0 are drawn


# -------------------------------------------------------------------------- results --


def failed(result: Result) -> bool:
    return "failure" in result


def error(result: Result) -> float:
    """Return the certified upper bound, in diameters of the sum."""
    return float(result["error"][1])


def right(result: Result) -> bool:
    """Tell whether there is a result, simple, counter-clockwise, and with nothing lost."""
    return not failed(result) and all(
        result[key] for key in ("simple", "counter_clockwise", "complete")
    )


def faults(result: Result) -> str:
    names = {"simple": "not simple", "counter_clockwise": "clockwise", "complete": "incomplete"}
    if not result["simple"]:
        del names["counter_clockwise"]
    return ", ".join(name for key, name in names.items() if not result[key])


def of_system(row: Row, system: str) -> list[Result]:
    found = [result for result in row["results"] if result["system"] == system]
    return sorted(found, key=lambda result: float(result["resolution"]))


def scientific(x: float) -> str:
    return "0" if x == 0 else f"{x:.1e}"


def called(result: Result) -> str:
    name, setting = str(result["system"]), str(result["setting"])
    return name if setting in ("exact", "doubles") else f"{name} ({setting})"


def measured(result: Result) -> str:
    return f"{number(result['ms'])} ms at an error of {scientific(error(result))}"


# ------------------------------------------------------------------------ the front --


def rival(row: Row, result: Result) -> Optional[Result]:
    """Return libgcv's fastest result, cold, that is as accurate as this one."""
    as_accurate = [own for system in COLD for own in of_system(row, system)
                   if right(own) and error(own) <= error(result)]  # fmt: skip
    return min(as_accurate, key=lambda own: float(own["ms"]), default=None)


def rivals(row: Row, systems: Iterable[str]) -> list[tuple[Result, Optional[Result]]]:
    """Return the right results of the systems, each with its rival."""
    found = [r for system in systems for r in of_system(row, system) if right(r)]
    return [(r, rival(row, r)) for r in found]


def sentence(row: Row) -> str:
    """Say whether anything is both faster than libgcv, cold, and as accurate."""
    parts = []
    others = rivals(row, (system for system in STYLES if not system.startswith("libgcv")))
    compared = sorted(((r, own) for r, own in others if own is not None),
                      key=lambda pair: float(pair[0]["ms"] / pair[1]["ms"]))  # fmt: skip
    ahead = [(r, own) for r, own in compared if r["ms"] < own["ms"]]
    if ahead:
        parts += [
            f"{called(r)} is faster than libgcv and as accurate: {measured(r)}, against "
            f"{measured(own)} of {called(own)}, which takes {number(own['ms'] / r['ms'])} times as "
            "long."
            for r, own in ahead
        ]
    elif compared:
        parts.append("No other system is both faster and as accurate.")
        fine = [pair for pair in compared if error(pair[0]) < FINE]
        closest = {"The closest is": compared[:1]}
        if fine[:1] != compared[:1]:
            closest[f"With an error below {FINE:g} it is"] = fine[:1]
        parts += [
            f"{start} {called(r)}: {measured(r)}, {number(r['ms'] / own['ms'])} times as long as "
            f"{called(own)} with {measured(own)}."
            for start, pairs in closest.items()
            for r, own in pairs
        ]
    else:
        parts.append("No other system has a right result that libgcv's can be compared to.")
    parts += [f"{called(r)} is more accurate: {measured(r)}." for r, own in others if own is None]
    for r, usual in rivals(row, [PLAIN]):
        if usual is not None:
            share = number(r["ms"] / usual["ms"])
            parts.append(f"In plain doubles libgcv takes {share} of its time.")
    return " ".join(parts)


# ------------------------------------------------------------------------- pictures --


def draw(axes: Axes, row: Row) -> None:
    """Draw time against error: wrong results hollow, failures as crosses at the right."""
    times = [float(r["ms"]) for r in row["results"] if not failed(r)]
    low, high = min(times) / 2, max(*times, 20 * min(times)) * 2
    step = (high / low) ** (0.12 / len(STYLES))  # each system fails in a column of its own
    end = high * step ** (len(STYLES) + 1)
    for k, (system, (colour, marker)) in enumerate(STYLES.items()):
        results = of_system(row, system)
        done = [r for r in results if not failed(r)]
        ms = [float(r["ms"]) for r in done]
        errors = [max(error(r), LEAST_ERROR) if error(r) > 0 else ZERO for r in done]
        axes.plot(ms, errors, color=colour, linewidth=1, alpha=0.6, zorder=2)
        for x, y, r in zip(ms, errors, done):
            axes.plot(x, y, marker, color=colour, markersize=6, zorder=3,
                      markerfacecolor=colour if right(r) else "white")  # fmt: skip
        without = [max(r["resolution"], 1e-16) for r in results
                   if failed(r) and r["failure"] != "not tried"]  # fmt: skip
        axes.plot([high * step ** (k + 1)] * len(without), without, "x", color=colour,
                  markersize=5, zorder=3)  # fmt: skip
    decades = range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)
    axes.set(xscale="log", yscale="log", xlim=(low, end), ylim=(ZERO / 4, 2),
             xticks=[10.0**k for k in decades])  # fmt: skip
    axes.axvspan(high, end, color="#f4e3e1", zorder=0)
    axes.axhspan(ZERO / 4, ZERO * 4, color="#e8f3e8", zorder=0)
    axes.set_yticks([ZERO, *(10.0**k for k in range(-18, 1, 3))],
                    ["0", *(f"$10^{{{k}}}$" for k in range(-18, 1, 3))])  # fmt: skip
    axes.minorticks_off()
    axes.grid(color="#e2e2e2", linewidth=0.6, zorder=1)
    axes.set_title(f"{row['pair']}: {row['a']} + {row['b']} vertices", fontsize=10)
    axes.set_xlabel("milliseconds of one sum", fontsize=9)
    axes.set_ylabel("error / diameter", fontsize=9)


def legend(figure: Figure, columns: int) -> None:
    handles = [Line2D([], [], color=colour, marker=marker, label=system)
               for system, (colour, marker) in STYLES.items()]  # fmt: skip
    handles += [Line2D([], [], color="#555", linestyle="", marker=marker, markerfacecolor="white",
                       label=label)
                for marker, label in (("o", "wrong result"), ("x", "no result"))]  # fmt: skip
    figure.legend(handles=handles, loc="outside lower center", ncols=columns, fontsize=8,
                  frameon=False)  # fmt: skip


def picture(rows: list[Row], columns: int) -> Figure:
    lines = math.ceil(len(rows) / columns)
    figure = Figure(figsize=(5.6 * columns if columns > 1 else 8, 3.9 * lines + 0.9),
                    layout="constrained")  # fmt: skip
    for k, row in enumerate(rows):
        draw(figure.add_subplot(lines, columns, k + 1), row)
    legend(figure, 5)
    return figure


def save(figure: Figure, file: Path) -> None:
    metadata = {"Date": None} if file.suffix == ".svg" else {}
    figure.savefig(file, dpi=150, metadata=metadata)


def file_name(row: Row) -> str:
    return re.sub(r"[^a-z0-9]+", "_", row["pair"]).strip("_") + ".svg"


# ----------------------------------------------------------------------------- HTML --


def table(head: list[str], lines: Iterable[list[str]]) -> str:
    def cells(tag: str, line: list[str]) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in line) + "</tr>"

    return "\n".join(["<table>", cells("th", head), *(cells("td", line) for line in lines),
                      "</table>"])  # fmt: skip


def yes(value: bool) -> str:
    return "yes" if value else "no"


def pair_table(row: Row) -> str:
    lines = []
    for system in STYLES:
        for r in of_system(row, system):
            name = [system, r["setting"]]
            if failed(r):
                lines.append([*name, "-", "-", "-", "-", "-", r["failure"]])
            else:
                lines.append([*name, number(r["ms"]), scientific(error(r)), str(r["vertices"]),
                              yes(r["simple"]), yes(r["contains"]), faults(r)])  # fmt: skip
    head = ["system", "setting", "ms", "error ≤", "vertices", "simple", "contains the exact sum",
            "fault"]  # fmt: skip
    return table(head, lines)


def overview(rows: list[Row]) -> str:
    lines = []
    for system in STYLES:
        results = [(row, r) for row in rows for r in of_system(row, system)
                   if r.get("failure") != "not tried"]  # fmt: skip
        done = [(row, r) for row, r in results if not failed(r)]
        times = [r["ms"] / own["ms"] for row, r in done
                 for own in of_system(row, NEAREST)[:1] if not failed(own)]  # fmt: skip
        errors = [error(r) for _, r in done if right(r)]
        lines.append(
            [
                system,
                str(len(results)),
                str(len(results) - len(done)),
                str(sum(not r["simple"] for _, r in done)),
                str(sum(not r["complete"] for _, r in done)),
                str(sum(r["contains"] for _, r in done)),
                number(statistics.median(times)) if times else "-",
                scientific(min(errors)) if errors else "-",
                scientific(max(errors)) if errors else "-",
            ]
        )
    head = ["system", "runs", "no result", "not simple", "incomplete", "contains",
            "median of time / libgcv's", "least error of right results", "largest"]  # fmt: skip
    return table(head, lines)


def bounds(rows: list[Row], slots: Optional[Row]) -> str:
    """Say whether libgcv's own bounds hold."""
    own = (NEAREST, OUTWARD, PREPARED)
    checked = [r for row in rows for system in own for r in of_system(row, system)
               if not failed(r) and r["resolution"] == 0]  # fmt: skip
    count, beyond = len(checked), sum(not r["within_bound"] for r in checked)
    if slots is not None:
        of_slots = [r for r in slots["results"] if r["system"] in own and r["setting"] == "exact"]
        count += sum(slots["slots"] - r["no_result"] for r in of_slots)
        beyond += sum(r["beyond_bound"] for r in of_slots)
    return (
        f"<p>libgcv certifies a bound on the error of each result. Of {count} results without a "
        f"tolerance, {beyond} have a larger error.</p>"
    )


def slots_table(slots: Row) -> str:
    def share(count: int) -> str:
        return f"{100 * count / slots['slots']:.1f} %"

    head = ["system", "setting", "no result", "not simple", "incomplete", "any of these",
            "contains the exact sum", "largest error ≤"]  # fmt: skip
    keys = ["no_result", "not_simple", "incomplete", "wrong", "containing"]
    return table(head, ([r["system"], r["setting"], *(share(r[key]) for key in keys),
                         scientific(r["largest_error"])] for r in slots["results"]))  # fmt: skip


STYLE = """body { font: 15px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; font-size: 13px; margin: 1em 0; }
td, th { border-bottom: 1px solid #ddd; padding: 2px 10px; text-align: right; }
td:nth-child(-n+1), th:nth-child(-n+1) { text-align: left; }
img { width: 100%; } summary { cursor: pointer; }"""

READING = """<p>Each point is one system at one setting: the time of one sum, from two arrays of
doubles to the outer ring in doubles, on one thread (median of the rounds), and the Hausdorff
distance of the returned ring from the exact one, edges and all, over the diameter of the sum. The
distance is bounded from exact coordinates; the upper bound is shown, at most 5 % above the lower
one. Both axes are logarithmic; the strip at the bottom is an error of 0.</p>
<p>Hollow marks are wrong results: rings that are not simple, exactly, in the doubles returned;
that are clockwise; or that are incomplete, as where a pocket is lost: the error is more than ten
times the resolution (the cell of the grid, the tolerance, or the unit in the last place of the
largest coordinate) and more than 10<sup>-9</sup> of the diameter, or the exact ring has another
number of corners by the system's own account. Crosses in the strip at the right are settings
without a result, at the height of their resolution: refused, crashed, or out of time. A system that
has used up the time for one run is not tried at its other settings, and these are not drawn.
<i>Contains</i>: the returned region contains the exact sum, decided exactly.</p>
<p>libgcv is cold: both polygons are created, summed, copied out, destroyed; <i>prepared</i>: their
handles exist, with a tolerance those of the simplified polygons. Outward rounding closes slits
thinner than a few units in the last place, and is then incomplete by design. A tolerance bounds
the distance between the sums as sets; the rings can be further apart where it opens or closes the
entrance of a pocket.
<i>Plain doubles</i> is libgcv with
predicates in doubles alone, which may fail. Clipper's grids have 2 to 12 decimal digits behind the
power of ten that is next above the diameter; on those of Boost.Polygon all of the sum is within 16
to 31 bits. CGAL and SFCGAL are exact, and their own functions convert the result to doubles.</p>
<p>The pairs fork, stars, ~monkey and gardeyn5 are left out where their data is missing.</p>"""


def page(machine: dict[str, str], rows: list[Row], slots: Optional[Row]) -> str:
    parts = [
        '<!DOCTYPE html><html lang="en"><meta charset="utf-8">'
        f"<title>Speed against error</title><style>{STYLE}</style>",
        "<h1>Speed against error</h1>",
        READING,
        '<img src="accuracy.svg" alt="Time against error on four pairs">',
        "<h2>Is anything faster and as accurate?</h2><ul>",
        *(f"<li><b>{html.escape(row['pair'])}</b>: {html.escape(sentence(row))}" for row in rows),
        "</ul><h2>All pairs</h2>",
        overview(rows),
        bounds(rows, slots),
    ]
    if slots is not None:
        parts += [
            f"<h2>{slots['slots']} rotated slots</h2>",
            "<p>Blocks with a slot and parts that fit it exactly, turned by the same random angle "
            "in doubles. Shares of the sums:</p>",
            slots_table(slots),
        ]
    for row in rows:
        parts += [
            f"<h2>{html.escape(row['pair'])}</h2>",
            f"<p>{row['a']} + {row['b']} vertices; the exact ring has {row['exact_vertices']}, the "
            f"sum the diameter {row['diameter']:g}. {html.escape(sentence(row))}</p>",
            f'<img src="{file_name(row)}" alt="Time against error">',
            f"<details><summary>All results</summary>{pair_table(row)}</details>",
        ]
    parts += ["<h2>The machine</h2>", table(["", ""], ([k, v] for k, v in machine.items()))]
    return "\n".join([*parts, "</html>"]) + "\n"


# ------------------------------------------------------------------------------ run --


def measure(arguments: list[str]) -> list[Row]:
    lines = []
    with subprocess.Popen(
        [str(BUILD / "bench" / "gcv_accuracy"), *arguments], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            row: Row = json.loads(line)
            lines.append(row)
            print(f"{row['pair']}: {sentence(row)}" if "pair" in row else "slots", file=sys.stderr)
    if process.returncode != 0 or not any("pair" in line for line in lines):
        sys.exit("bench/accuracy: nothing was measured")
    return lines


def write(results: dict[str, Any]) -> None:
    """Write the whole report from the results."""
    rows: list[Row] = results["pairs"]
    for old in REPORT.glob("*.svg"):
        old.unlink()
    mpl.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "gcv"})
    for row in rows:
        save(picture([row], 1), REPORT / file_name(row))
    chosen = [row for name in MAIN for row in rows if row["pair"] == name] or rows[:4]
    for suffix in (".svg", ".png"):
        save(picture(chosen, 2), REPORT / f"accuracy{suffix}")
    text = page(results["machine"], rows, results["slots"])
    (REPORT / "index.html").write_text(text, encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(prog="bench/accuracy", description=__doc__)
    parser.add_argument("--quick", action="store_true",
                        help="fewer settings, smaller coasts, 1 round, 100 slots")  # fmt: skip
    parser.add_argument("--pairs", help="only these, with ; between them")
    parser.add_argument("--rounds", type=int, help="of every setting on every pair (3)")
    parser.add_argument("--limit", type=float, help="seconds for one run (20)")
    parser.add_argument("--slots", type=int, help="how many rotated slots (2000)")
    parser.add_argument("--draw", action="store_true", help="from the results of the last run")
    options = parser.parse_args()
    REPORT.mkdir(exist_ok=True)
    file = REPORT / "results.json"
    if not options.draw:
        defaults = {
            "rounds": 1 if options.quick else 3,
            "limit": 5 if options.quick else 20,
            "slots": 100 if options.quick else 2000,
        }
        arguments = ["--quick"] * options.quick
        for name, default in defaults.items():
            value = getattr(options, name)
            arguments += [f"--{name}", str(default if value is None else value)]
        if options.pairs:
            arguments += ["--pairs", options.pairs]
        lines = measure(arguments)
        results = {
            "machine": machine_description(),
            "pairs": [row for row in lines if "pair" in row],
            "slots": next((row for row in lines if "slots" in row), None),
        }
        file.write_text(json.dumps(results, indent=1), encoding="utf-8")
    write(json.loads(file.read_text(encoding="utf-8")))
    print(f"written: {REPORT / 'index.html'}")


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs gcv_positions and reports it: the time of each pair in each position, and bars."""

from __future__ import annotations

import argparse
import datetime
import json
import math
import os
import statistics
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional

Result = dict[str, Any]  # ms and vertices, or failure and is_cut_off

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "positions"

MODES = ("prepared", "cold")
REFERENCE = "reference"  # the family of coasts that others are compared to
LEAST_REFERENCE = 16  # vertices: smaller coasts are nearly convex
LARGE_COASTS = 10000  # vertices of each

MOST_SPREAD = 3.0  # slowest to quickest position
COMPARABLE = 1.5  # as many vertices in one ring as in the other
MOST_COASTS = 4.0  # times of coasts of the same size

# In every position: milliseconds, and times of the large coasts.
MOST_MS = {
    "comb of 250 teeth": 3.0,
    "comb of 2500 teeth": 100.0,
    "high comb of 250 teeth": 3.0,
    "high comb of 2500 teeth": 100.0,
}
MOST_LARGE_COASTS = {"spiky stars 1000 x 1000": 0.3, "Koch curves 3072 x 3072": 0.5}


@dataclass
class Trial:
    """One pair in all positions."""

    family: str
    name: str
    vertices: tuple[int, int]
    results: dict[str, dict[str, Result]] = field(default_factory=dict)  # of a position, a system
    sizes: dict[str, int] = field(default_factory=dict)  # vertices of the input, of a position
    unusable: set[str] = field(default_factory=set)  # positions where a ring is not simple

    def ms(self, position: str, system: str) -> Optional[float]:
        value = self.results.get(position, {}).get(system, {}).get("ms")
        return None if value is None else float(value)

    def ring(self, position: str, system: str) -> Optional[int]:
        value = self.results.get(position, {}).get(system, {}).get("vertices")
        return None if value is None else int(value)

    def times(self, system: str) -> dict[str, float]:
        found = ((position, self.ms(position, system)) for position in self.results)
        return {position: ms for position, ms in found if ms is not None}


@dataclass
class Miss:
    """A bar that a pair does not keep, and the positions where."""

    pair: str
    mode: str
    bar: str
    asked: str
    worst: str
    positions: list[str]


class References:
    """The times of coasts, by the vertices of both of them together."""

    def __init__(self, rows: list[dict[str, Any]]) -> None:
        self.curves: dict[str, list[tuple[int, float]]] = {}
        times: dict[tuple[str, int], list[float]] = {}
        for row in rows:
            for system, result in row["results"].items():
                if "ms" in result and row["a"] >= LEAST_REFERENCE:
                    times.setdefault((system, row["a"] + row["b"]), []).append(result["ms"])
        for (system, size), found in sorted(times.items()):
            self.curves.setdefault(system, []).append((size, statistics.median(found)))

    def ms(self, system: str, size: int) -> float:
        """Interpolate between sizes; in proportion beyond the least and the largest."""
        curve = self.curves[system]
        for (n, s), (m, t) in zip(curve, curve[1:]):
            if n <= size <= m:
                return float(s * (t / s) ** (math.log(size / n) / math.log(m / n)))
        n, s = curve[0] if size < curve[0][0] else curve[-1]
        return s * size / n


# -------------------------------------------------------------------------- the bars --


def spread(trial: Trial, system: str) -> tuple[float, str]:
    """Return the greatest ratio of the times of two positions with rings of about the same size."""
    times = trial.times(system)
    worst, where = 1.0, ""
    for slow, slow_ms in times.items():
        for quick, quick_ms in times.items():
            n, m = trial.ring(slow, system) or 0, trial.ring(quick, system) or 0
            if max(n, m) <= COMPARABLE * min(n, m) and slow_ms > worst * quick_ms:
                worst, where = slow_ms / quick_ms, f"{slow} to {quick}"
    return worst, where


def coasts(trial: Trial, system: str, references: References) -> dict[str, float]:
    """Return the time of each position in times of coasts of the same size."""
    times = trial.times(system)
    return {p: ms / references.ms(system, trial.sizes[p]) for p, ms in times.items()}


def most_ms(trial: Trial, system: str, references: References) -> Optional[float]:
    """Return the bound of the bar that is this pair's own."""
    if trial.name in MOST_LARGE_COASTS:
        return MOST_LARGE_COASTS[trial.name] * references.ms(system, 2 * LARGE_COASTS)
    return MOST_MS.get(trial.name)


def too_slow(trial: Trial, mode: str, references: References) -> set[str]:
    """Return the positions to mark in the tables."""
    system = f"library {mode}"
    bound = most_ms(trial, system, references) or math.inf
    slow = {p for p, ratio in coasts(trial, system, references).items() if ratio > MOST_COASTS}
    slow |= {p for p, ms in trial.times(system).items() if ms > bound}
    return slow | {p for p, r in trial.results.items() if "failure" in r.get(system, {})}


def misses(trial: Trial, mode: str, references: References) -> list[Miss]:
    system = f"library {mode}"
    found = []

    def add(bar: str, asked: str, values: dict[str, float], bound: float) -> None:
        over = {p: value for p, value in values.items() if value > bound}
        if over:
            worst = number(max(over.values()))
            positions = sorted(over, key=lambda p: -over[p])
            found.append(Miss(trial.name, mode, bar, asked, worst, positions))

    failures: dict[str, list[str]] = {}
    for position, results in trial.results.items():
        if "failure" in results.get(system, {}):
            failures.setdefault(results[system]["failure"], []).append(position)
    for failure, positions in failures.items():
        found.append(Miss(trial.name, mode, "a result", "yes", failure, positions))
    worst, where = spread(trial, system)
    add("spread", f"≤ {number(MOST_SPREAD)}", {where: worst}, MOST_SPREAD)
    add("coasts of the same size", f"≤ {number(MOST_COASTS)}",
        coasts(trial, system, references), MOST_COASTS)  # fmt: skip
    times = trial.times(system)
    if trial.name in MOST_LARGE_COASTS:
        large = references.ms(system, 2 * LARGE_COASTS)
        bound = MOST_LARGE_COASTS[trial.name]
        add(f"coasts {LARGE_COASTS} x {LARGE_COASTS}", f"≤ {number(bound)}",
            {p: ms / large for p, ms in times.items()}, bound)  # fmt: skip
    elif trial.name in MOST_MS:
        bound = MOST_MS[trial.name]
        add("milliseconds", f"≤ {number(bound)}", times, bound)
    return found


# ---------------------------------------------------------------------------- tables --


def number(x: float) -> str:
    """Three digits, without an exponent."""
    digits = max(0, 2 - math.floor(math.log10(abs(x)))) if x else 0
    return f"{x:.{digits}f}"


def bold(text: str, if_so: bool) -> str:
    return f"**{text}**" if if_so else text


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def positions_of(trials: list[Trial]) -> list[str]:
    return list(dict.fromkeys(p for t in trials for p in [*t.results, *t.unusable]))


def is_cut_off(trial: Trial, position: str, system: str) -> bool:
    return bool(trial.results[position].get(system, {}).get("is_cut_off", False))


def cell(trial: Trial, position: str, system: str) -> str:
    if position in trial.unusable:
        return "not simple"
    result = trial.results.get(position, {}).get(system)
    if result is None:
        return "-"
    if "failure" in result:
        return str(result["failure"]) if is_cut_off(trial, position, system) else "failed"
    return number(result["ms"])


def times_table(trials: list[Trial], mode: str, references: References) -> str:
    system = f"library {mode}"
    positions = positions_of(trials)
    lines = []
    for trial in trials:
        marked = too_slow(trial, mode, references)
        rings = [ring for p in positions if (ring := trial.ring(p, system)) is not None]
        ratio = max(coasts(trial, system, references).values(), default=0.0)
        wide = spread(trial, system)[0]
        verdicts = [
            bold(number(wide), wide > MOST_SPREAD),
            bold(number(ratio), ratio > MOST_COASTS),
        ]
        if any(is_cut_off(trial, p, system) for p in trial.results):
            verdicts = ["**cut off**"] * 2
        lines.append(
            [
                trial.name,
                f"{trial.vertices[0]} / {trial.vertices[1]}",
                f"{min(rings)} - {max(rings)}" if rings else "-",
                *(bold(cell(trial, p, system), p in marked) for p in positions),
                *verdicts,
            ]
        )
    return table(["pair", "A / B", "rings", *positions, "spread", "coasts"], lines)


def summary(ratios: list[float]) -> list[str]:
    if not ratios:
        return ["-", "-"]
    return [number(statistics.geometric_mean(ratios)), number(max(ratios))]


def versus_table(trials: list[Trial], mode: str) -> str:
    """Put the times of the first library over those of the second."""
    positions = positions_of(trials)
    lines: list[list[str]] = []
    everything: list[float] = []
    for trial in trials:
        ours, theirs = trial.times(f"library {mode}"), trial.times(f"versus {mode}")
        ratios = {p: ours[p] / theirs[p] for p in positions if p in ours and p in theirs}
        cells = [
            number(ratios[p])
            if p in ratios
            else f"{cell(trial, p, f'library {mode}')} : {cell(trial, p, f'versus {mode}')}"
            for p in positions
        ]
        everything += ratios.values()
        lines.append([trial.name, *cells, *summary(list(ratios.values()))])
    lines.append(["all", *("" for _ in positions), *summary(everything)])
    return table(["pair", *positions, "geometric mean", "most"], lines)


def disagreements(trials: list[Trial]) -> list[str]:
    found = []
    for trial in trials:
        for position in trial.results:
            rings = [trial.ring(position, f"{who} cold") for who in ("library", "versus")]
            if None not in rings and rings[0] != rings[1]:
                found.append(f"{trial.name}, {position}: {rings[0]} vertices, not {rings[1]}.")
    return found


def misses_table(found: list[Miss], count: int) -> str:
    lines = []
    for miss in found:
        shown = ", ".join(miss.positions[:4]) + (", ..." if len(miss.positions) > 4 else "")
        of = "" if miss.bar == "spread" else f"{len(miss.positions)} of {count}"
        lines.append([miss.pair, miss.mode, miss.bar, miss.asked, miss.worst, of, shown])
    head = ["pair", "handles", "bar", "asked", "worst", "positions", "the worst first"]
    return table(head, lines) if lines else "None.\n"


def report(
    described: dict[str, str],
    trials: list[Trial],
    references: References,
    found: list[Miss],
    has_versus: bool,
) -> str:
    parts = ["".join(f"- {key}: {value}\n" for key, value in described.items())]
    parts.append(
        "Milliseconds of one sum on one thread, the least of all runs. *Spread*: the slowest "
        f"position to the quickest, of those whose rings are within {COMPARABLE} times of each "
        "other. *Coasts*: the slowest position in times of two coasts with as many vertices in "
        "all. Bold: a bar is missed. >: cut off. -: not tried, after three that were cut off. "
        "Not simple: rounding made the input so.\n"
    )
    for mode in MODES:
        parts.append(f"## Handles {'prepared' if mode == 'prepared' else 'made anew'}\n")
        parts.append(times_table(trials, mode, references))
    if has_versus:
        for mode in MODES:
            parts.append(f"## Library : versus, {mode}\n")
            parts.append(versus_table(trials, mode))
        parts.append("## Rings that differ\n")
        parts.append("".join(f"- {s}\n" for s in disagreements(trials)) or "None.\n")
    parts.append("## Bars missed\n")
    parts.append(misses_table(found, len(positions_of(trials))))
    return "\n".join(parts)


# ------------------------------------------------------------------------------- run --


def measure(arguments: list[str]) -> list[dict[str, Any]]:
    rows = []
    with subprocess.Popen(
        [str(BUILD / "bench" / "gcv_positions"), *arguments], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            row: dict[str, Any] = json.loads(line)
            rows.append(row)
            result = row["results"].get("library cold", {"failure": "not simple"})
            text = result["failure"] if "failure" in result else number(result["ms"])
            if row["family"] != REFERENCE:
                print(f"{row['pair']}, {row['position']}: {text}", file=sys.stderr)
    if process.returncode != 0 or not rows:
        sys.exit("bench/positions: the measurement failed")
    return rows


def trials_of(rows: list[dict[str, Any]]) -> list[Trial]:
    trials: dict[tuple[str, str], Trial] = {}
    for row in rows:
        if row["family"] == REFERENCE:
            continue
        key = row["family"], row["pair"]
        trial = trials.setdefault(key, Trial(*key, (row["a"], row["b"])))
        if row["is_simple"]:
            trial.results[row["position"]] = row["results"]
            trial.sizes[row["position"]] = row["a"] + row["b"]
        else:
            trial.unusable.add(row["position"])
    return list(trials.values())


def main() -> None:
    parser = argparse.ArgumentParser(prog="bench/positions", description=__doc__)
    parser.add_argument(
        "--quick", action="store_true", help="small pairs, one round, cut off at 2 s"
    )
    parser.add_argument("--families", metavar="NAME,...", help="only these families or pairs")
    parser.add_argument("--positions", metavar="NAME,...", help="only these positions")
    parser.add_argument("--library", type=Path, metavar="PATH", help="a libgcv.so to measure")
    parser.add_argument("--versus", type=Path, metavar="PATH", help="another one, in turns with it")
    parser.add_argument("--rounds", type=int, help="processes for each position (2)")
    parser.add_argument("--limit", type=float, help="seconds for one of them (20)")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there too")
    parser.add_argument("--strict", action="store_true", help="exit with 1 if a bar is missed")
    options = parser.parse_args()
    library = options.library or BUILD / "capi" / "libgcv.so"
    limit = options.limit or (2 if options.quick else 20)
    rounds = options.rounds or (1 if options.quick else 2)
    arguments = [
        "--library",
        str(library.resolve()),
        "--limit",
        str(limit),
        "--rounds",
        str(rounds),
    ]
    if options.versus:
        arguments += ["--versus", str(options.versus.resolve())]
    for name in ("families", "positions"):
        if value := getattr(options, name):
            arguments += [f"--{name}", value]
    rows = measure(arguments + ["--quick"] * options.quick)
    BUILD.joinpath("results.json").write_text(json.dumps(rows, indent=1), encoding="utf-8")

    references = References([row for row in rows if row["family"] == REFERENCE])
    trials = trials_of(rows)
    found = [m for t in trials for mode in MODES for m in misses(t, mode, references)]
    described = {
        "date": datetime.date.today().isoformat(),
        "load, of 15 minutes": f"{os.getloadavg()[2]:.1f}",
        "library": str(library),
        **({"versus": str(options.versus)} if options.versus else {}),
    }
    text = report(described, trials, references, found, options.versus is not None)
    print(text)
    if options.markdown:
        options.markdown.write_text("# Positions\n\n" + text, encoding="utf-8")
    if found and options.strict:
        sys.exit(1)


if __name__ == "__main__":
    main()

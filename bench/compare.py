# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs the comparison and reports it: tables, the paper's Table 2, bars, a picture."""

from __future__ import annotations

import argparse
import datetime
import json
import math
import os
import platform
import statistics
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

Row = dict[str, Any]  # one line of gcv_compare: set, pair, a, b, results

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "bench"

OWN = "libgcv"
PREPARED = "libgcv prepared"
CGAL = "CGAL reduced convolution"
GCVMSOF = "GCVMSOF by arrangement"
RCMSOF = "RCMSOF by arrangement"
EXACT = {OWN, PREPARED, "libgcv exact tier only", CGAL, "CGAL full convolution",
         "CGAL decomposition", GCVMSOF, RCMSOF}  # fmt: skip

# The paper's Table 2: superset edges and total ms, of GCVMSOF and of RCMSOF.
PAPER = {
    "chain": (170, 133, 63, 142),
    "stars": (371, 395, 372, 399),
    "comb": (80, 65, 81, 65),
    "fork": (331, 2023, 342, 1974),
    "knife": (211, 931, 211, 952),
    "g1g2": (389, 964, 346, 828),
    "monkey": (8189, 10988, 8189, 11900),
    "hand": (369, 403, 369, 382),
    "bird": (1019, 1363, 1017, 1598),
}

TITLES = {
    "paper": "The paper's pairs",
    "real": "Real parts and shapes",
    "growing": "Growing real shapes",
    "nesting": "Nesting parts, pairs drawn at random",
    "coasts": "Fractal coasts",
    "spiky stars": "Spiky stars",
    "rectilinear": "Histograms",
    "convex": "Convex polygons",
    "tiny": "Tiny polygons",
    "hostile": "Hostile shapes",
    "method": "The pairs of docs/METHOD.md",
}
SUMMARISED = {"nesting", "tiny"}  # many small pairs: one line for each system


# ---------------------------------------------------------------------- measurements --


def milliseconds(row: Row, system: str) -> Optional[float]:
    """Return what the system took, if it finished."""
    ms = row["results"].get(system, {}).get("ms")
    return None if ms is None else float(ms)


def at_least(row: Row, system: str, limit: float) -> Optional[float]:
    """Return what the system took, or the limit that it was cut off at."""
    if row["results"].get(system, {}).get("failure", "").startswith(">"):
        return 1000 * limit
    return milliseconds(row, system)


def rounds_of(row: Row, system: str) -> list[float]:
    """Return what the system took in each round."""
    return list(row["results"].get(system, {}).get("rounds_ms", []))


def quotient(times: list[float], others: list[float]) -> Optional[float]:
    """Return the median of the quotients of the rounds: in one, the machine is as fast for both."""
    quotients = [x / y for x, y in zip(times, others)]
    return statistics.median(quotients) if quotients else None


def ratio(row: Row, peer: str, limit: float, own: str = OWN) -> Optional[float]:
    """Return how many times longer the peer took: a lower bound where it was cut off."""
    if milliseconds(row, peer) is not None:
        return quotient(rounds_of(row, peer), rounds_of(row, own))
    peer_ms = at_least(row, peer, limit)
    own_ms = milliseconds(row, own)
    return None if peer_ms is None or own_ms is None else peer_ms / own_ms


def clipper_of(rows: list[Row]) -> str:
    return "Clipper2" if any("Clipper2" in row["results"] for row in rows) else "Clipper"


def disagreements(rows: list[Row]) -> list[str]:
    """Return a sentence for each result that differs from libgcv's."""
    found = []
    for row in rows:
        own = row["results"].get(OWN, {})
        for system, result in row["results"].items():
            if "area" not in own or "area" not in result:
                continue
            exact = system in EXACT
            if abs(result["area"] - own["area"]) > (1e-9 if exact else 1e-5) * own["area"]:
                found.append(
                    f"{row['set']}, {row['pair']}: {system} has the area {result['area']:.6g}, "
                    f"{OWN} {own['area']:.6g}."
                )
            elif exact and result["exact_vertices"] != own["exact_vertices"]:
                found.append(
                    f"{row['set']}, {row['pair']}: {system} has {result['exact_vertices']} "
                    f"vertices, {OWN} {own['exact_vertices']}."
                )
    return found


# -------------------------------------------------------------------------- the bars --


@dataclass
class Bar:
    """What is asked of a number, and the number; None where it was not measured."""

    name: str
    value: Optional[float]
    bound: float
    at_least: bool = True

    def state(self) -> str:
        if self.value is None:
            return "not measured"
        met = self.value >= self.bound if self.at_least else self.value <= self.bound
        return "PASS" if met else "FAIL"

    def cells(self) -> list[str]:
        sign = "≥" if self.at_least else "≤"
        value = "-" if self.value is None else number(self.value)
        return [self.name, f"{sign} {number(self.bound)}", value, self.state()]


def bars_of_growth(coasts: dict[str, Row]) -> list[Bar]:
    def per_vertex(name: str) -> list[float]:
        row = coasts.get(name)
        if row is None:
            return []
        return [ms / row["results"][OWN]["vertices"] for ms in rounds_of(row, OWN)]

    growth = quotient(per_vertex("1000000 x 1000000"), per_vertex("1000 x 1000"))
    memory = None
    largest = coasts.get("1000000 x 1000000")
    if largest is not None and "peak_bytes" in largest["results"][OWN]:
        vertices = largest["a"]["vertices"] + largest["b"]["vertices"]
        memory = largest["results"][OWN]["peak_bytes"] / vertices
    return [
        Bar("coasts: time per output vertex, 10^6 against 10^3", growth, 2, False),
        Bar("coasts: peak bytes per input vertex at 10^6, with the input", memory, 400, False),
    ]  # fmt: skip


def bars(rows: list[Row], limit: float) -> list[Bar]:
    sets: dict[str, dict[str, Row]] = {}
    for row in rows:
        sets.setdefault(row["set"], {})[row["pair"]] = row

    def of_pair(set_name: str, pair: str, own: str = OWN) -> Optional[float]:
        row = sets.get(set_name, {}).get(pair)
        return None if row is None else ratio(row, CGAL, limit, own)

    def of_set(set_name: str, peer: str) -> list[float]:
        ratios = (ratio(row, peer, limit) for row in rows if row["set"] == set_name)
        return [r for r in ratios if r is not None]

    paper = of_set("paper", CGAL)
    nesting = of_set("nesting", CGAL)
    clipper = clipper_of(rows)
    on_clipper = of_set("nesting", clipper)
    tiny = [ms for row in rows if row["set"] == "tiny" and (ms := milliseconds(row, OWN))]
    result = [
        Bar("paper's pairs, against CGAL: the worst", min(paper, default=None), 100),
        Bar("paper's pairs, against CGAL: geometric mean",
            statistics.geometric_mean(paper) if paper else None, 300),
        Bar("nesting, against CGAL: median", statistics.median(nesting) if nesting else None, 60),
        Bar("nesting, against CGAL: the worst", min(nesting, default=None), 20),
        Bar("tiny: microseconds of the median pair",
            1000 * statistics.median(tiny) if tiny else None, 0.5, False),
        Bar(f"nesting, against {clipper}: median",
            statistics.median(on_clipper) if on_clipper else None, 60),
        Bar("coasts 1000 x 1000, against CGAL", of_pair("coasts", "1000 x 1000"), 400),
        Bar("monkey2-heron2, against CGAL", of_pair("growing", "monkey2-heron2"), 10000),
        Bar("convex 8 x 8 prepared, against CGAL", of_pair("convex", "8 x 8", PREPARED), 200),
        *bars_of_growth(sets.get("coasts", {})),
    ]  # fmt: skip
    hostile = sets.get("hostile", {})
    coast = hostile.get("coasts 10000 x 10000")
    for pair, bound in [
        ("comb of 250 teeth, with itself", 0.2),
        ("comb of 2500 teeth, turned", 2),
        ("Koch curves 3072 x 3072", 0.5),
        ("spiky stars 1000 x 1000", 0.3),
        ("spiky stars 10000 x 10000", 30),
        ("regular 10000-gons", 0.05),
    ]:
        shape = hostile.get(pair)
        value = quotient(rounds_of(shape, OWN), rounds_of(coast, OWN)) if shape and coast else None
        result.append(Bar(f"{pair}, in times of the coasts 10000 x 10000", value, bound, False))
    return result


# ---------------------------------------------------------------------------- tables --


def number(x: float) -> str:
    """Three digits, without an exponent."""
    digits = max(0, 2 - math.floor(math.log10(abs(x)))) if x else 0
    return f"{x:.{digits}f}"


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def cell(row: Row, system: str) -> str:
    result = row["results"].get(system)
    if result is None:
        return "-"
    return str(result["failure"]) if "failure" in result else number(result["ms"])


def systems_of(rows: list[Row]) -> list[str]:
    return list(dict.fromkeys(system for row in rows for system in row["results"]))


def full_table(rows: list[Row], limit: float) -> str:
    systems = systems_of(rows)
    lines = []
    for row in rows:
        times = ratio(row, CGAL, limit)
        cut_off = milliseconds(row, CGAL) is None
        lines.append(
            [
                row["pair"],
                f"{row['a']['vertices']} / {row['b']['vertices']}",
                str(row["results"].get(OWN, {}).get("vertices", "-")),
                *(cell(row, system) for system in systems),
                "-" if times is None else ("> " if cut_off else "") + number(times),
            ]
        )
    return table(["pair", "A / B", "ring", *systems, "CGAL : libgcv"], lines)


def summary_table(rows: list[Row], limit: float) -> str:
    lines = []
    for system in systems_of(rows):
        times = [ms for row in rows if (ms := milliseconds(row, system)) is not None]
        ratios = [r for row in rows if (r := ratio(row, system, limit)) is not None]
        failures = sum("failure" in row["results"].get(system, {}) for row in rows)
        some = bool(times and ratios)
        lines.append(
            [
                system,
                number(statistics.median(times)) if some else "-",
                number(max(times)) if some else "-",
                number(min(ratios)) if some else "-",
                number(statistics.median(ratios)) if some else "-",
                number(statistics.geometric_mean(ratios)) if some else "-",
                str(failures),
            ]
        )
    head = ["system", "median ms", "most ms", "least ratio to libgcv", "median ratio",
            "geometric mean", "failed"]  # fmt: skip
    return table(head, lines)


def paper_table(rows: list[Row]) -> str:
    """Put the paper's Table 2 and its numbers beside ours."""
    head = ["pair", "A", "B"]
    for method in ("GCV", "RC"):
        head += [f"{method} edges: paper", "ours", "paper ms", "superset ms", "extraction ms",
                 "total ms"]  # fmt: skip
    head += ["libgcv's walk ms", "prepared ms"]
    lines = []
    for row in rows:
        name = row["pair"]
        line = [name, *(f"{row[p]['vertices']} ({row[p]['reflex']})" for p in "ab")]
        published = PAPER[name.lstrip("~")]
        for system, (edges, ms) in ((GCVMSOF, published[:2]), (RCMSOF, published[2:])):
            result = row["results"].get(system, {})
            line += [str(edges)]
            if "ms" in result:
                superset = result["superset_ms"]
                extraction = result["ms"] - superset
                line += [str(result["superset_edges"]), str(ms), number(superset),
                         number(extraction), number(result["ms"])]  # fmt: skip
            else:
                line += ["-", str(ms), "-", "-", cell(row, system)]
        lines.append([*line, cell(row, OWN), cell(row, PREPARED)])
    return table(head, lines)


def check_superset_sizes(rows: list[Row]) -> None:
    """Of the pairs whose files are the paper's, the supersets have the paper's sizes."""
    for row in rows:
        if row["pair"].startswith("~"):
            continue
        gcv, _, reduced, _ = PAPER[row["pair"]]
        for system, edges in ((GCVMSOF, gcv), (RCMSOF, reduced)):
            result = row["results"].get(system, {})
            if "superset_edges" in result and result["superset_edges"] != edges:
                raise AssertionError(
                    f"{row['pair']}: {system} has {result['superset_edges']} superset edges, "
                    f"the paper {edges}"
                )


def report(machine: dict[str, str], rows: list[Row], limit: float) -> str:
    parts = ["".join(f"- {key}: {value}\n" for key, value in machine.items())]
    parts.append(
        "Milliseconds of one sum on one thread, medians. A / B and ring: vertices. "
        "-: not tried; >: cut off.\n"
    )
    for name in dict.fromkeys(row["set"] for row in rows):
        of_set = [row for row in rows if row["set"] == name]
        parts.append(f"## {TITLES[name]}\n")
        parts.append((summary_table if name in SUMMARISED else full_table)(of_set, limit))
        if name == "paper":
            parts.append("## The paper's Table 2\n")
            parts.append("~: a substitute, not the paper's files.\n")
            parts.append(paper_table(of_set))
    parts.append("## Agreement\n")
    found = disagreements(rows)
    parts.append("".join(f"- {line}\n" for line in found) or "All results agree with libgcv's.\n")
    parts.append("## Bars\n")
    parts.append(table(["bar", "asked", "measured", ""], [b.cells() for b in bars(rows, limit)]))
    return "\n".join(parts)


# --------------------------------------------------------------------------- picture --

COLOURS = ["#1b5e9e", "#7fb2de", "#c0392b", "#e59866", "#27ae60", "#8e44ad", "#7f8c8d", "#111111",
           "#d4ac0d", "#e91e63"]  # fmt: skip


def growth_picture(rows: list[Row]) -> str:
    """Draw the times on the coasts against their size, both logarithmic."""
    curves: dict[str, list[tuple[float, float]]] = {}
    for row in rows:
        for system in row["results"]:
            ms = milliseconds(row, system)
            if ms is not None and (system in (OWN, PREPARED) or not system.startswith(OWN)):
                curves.setdefault(system, []).append((row["a"]["vertices"], ms))
    points = [point for curve in curves.values() for point in curve]
    x0, x1 = (f(math.log10(n) for n, _ in points) for f in (min, max))
    y0 = math.floor(min(math.log10(ms) for _, ms in points))
    y1 = math.ceil(max(math.log10(ms) for _, ms in points))

    def at(n: float, ms: float) -> tuple[float, float]:
        x = 70 + 420 * (math.log10(n) - x0) / max(x1 - x0, 1)
        return x, 370 - 340 * (math.log10(ms) - y0) / (y1 - y0)

    lines = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 420" font-family="sans-serif" '
        'font-size="12">',
        '<rect width="720" height="420" fill="white"/>',
    ]
    for k in range(y0, y1 + 1):
        y = at(10**x0, 10**k)[1]
        lines.append(f'<path d="M70 {y:.1f}H490" stroke="#ddd"/>')
        lines.append(f'<text x="62" y="{y + 4:.1f}" text-anchor="end">{10.0**k:g} ms</text>')
    for k in range(round(x0), round(x1) + 1):
        x = at(10**k, 10**y0)[0]
        lines.append(f'<path d="M{x:.1f} 30V370" stroke="#ddd"/>')
        lines.append(f'<text x="{x:.1f}" y="388" text-anchor="middle">{10**k}</text>')
    lines.append('<text x="280" y="408" text-anchor="middle">vertices of each coast</text>')
    for k, (system, curve) in enumerate(curves.items()):
        colour = COLOURS[k % len(COLOURS)]
        places = [at(n, ms) for n, ms in curve]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        lines.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        lines += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in places]
        lines.append(f'<circle cx="512" cy="{46 + 20 * k}" r="4" fill="{colour}"/>')
        lines.append(f'<text x="522" y="{50 + 20 * k}">{system}</text>')
    return "\n".join([*lines, "</svg>"]) + "\n"


# ------------------------------------------------------------------------------- run --


def machine_description() -> dict[str, str]:
    def output(*command: str) -> str:
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False)
        except OSError:
            return "unknown"
        return (done.stdout.splitlines() or ["unknown"])[0]

    def version(package: str) -> str:
        return output("dpkg-query", "-W", "-f=${Version}", package)

    cpuinfo = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    models = [line.split(":", 1)[1].strip() for line in cpuinfo if line.startswith("model name")]
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8").splitlines()
    compiler = next(li.split("=", 1)[1] for li in cache if li.startswith("CMAKE_CXX_COMPILER:"))
    return {
        "date": datetime.date.today().isoformat(),
        "machine": f"{models[0] if models else platform.machine()}, {len(models)} cores",
        "load, of 15 minutes": f"{os.getloadavg()[2]:.1f}",
        "compiler": output(compiler, "--version") + ", Release",
        "libgcv": output("git", "-C", str(ROOT), "describe", "--always", "--dirty"),
        "CGAL": version("libcgal-dev"),
        "SFCGAL": version("libsfcgal-dev"),
        "Clipper2": output("pkg-config", "--modversion", "Clipper2"),
        "Clipper": version("libpolyclipping-dev"),
        "Boost.Polygon": version("libboost-dev"),
        "GMP": version("libgmp-dev"),
    }


def measure(arguments: list[str]) -> list[Row]:
    rows = []
    with subprocess.Popen(
        [str(BUILD / "bench" / "gcv_compare"), *arguments], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            row: Row = json.loads(line)
            rows.append(row)
            times = cell(row, OWN), cell(row, CGAL)
            print(f"{row['set']}: {row['pair']}: libgcv {times[0]}, CGAL {times[1]}",
                  file=sys.stderr)  # fmt: skip
    if process.returncode != 0 or not rows:
        sys.exit("bench/run: nothing was measured")
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(prog="bench/run", description=__doc__)
    parser.add_argument("--sets", help="only these, of: " + ",".join(TITLES))
    parser.add_argument("--systems", help="only these, as named in the tables")
    parser.add_argument("--quick", action="store_true", help="fewer and smaller pairs, 2 rounds")
    parser.add_argument("--rounds", type=int, help="of every system on every pair (5)")
    parser.add_argument("--limit", type=float, help="seconds for one system on one pair (60)")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there too")
    options = parser.parse_args()
    limit = options.limit or (10 if options.quick else 60)
    rounds = options.rounds or (2 if options.quick else 5)
    arguments = ["--limit", str(limit), "--rounds", str(rounds)]
    for name in ("sets", "systems"):
        if value := getattr(options, name):
            arguments += [f"--{name}", value]
    rows = measure(arguments + ["--quick"] * options.quick)

    machine = machine_description()
    results = {
        "machine": machine,
        "limit_seconds": limit,
        "pairs": rows,
        "bars": [
            {"name": b.name, "value": b.value, "bound": b.bound, "state": b.state()}
            for b in bars(rows, limit)
        ],
    }
    (BUILD / "results.json").write_text(json.dumps(results, indent=1), encoding="utf-8")
    text = report(machine, rows, limit)
    print(text)
    if options.markdown:
        options.markdown.write_text("# Measurements\n\n" + text, encoding="utf-8")
    coasts = [row for row in rows if row["set"] == "coasts"]
    if coasts and not options.quick:
        (ROOT / "bench" / "growth.svg").write_text(growth_picture(coasts), encoding="utf-8")
    check_superset_sizes([row for row in rows if row["set"] == "paper"])


if __name__ == "__main__":
    main()

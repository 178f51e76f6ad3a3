# SPDX-License-Identifier: LGPL-3.0-or-later
"""Prints which functions of libgcv take the instructions of a sum, and its cache misses.

callgrind counts them, with caches of fixed sizes, so that they are the same on every machine of a
kind. Three sums in a process less one, halved, are what counts.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "bench" / "bench" / "gcv_profiles"
# Instructions and data of 32 KiB each, and 8 MiB for all.
CACHES = ["--cache-sim=yes", "--I1=32768,8,64", "--D1=32768,8,64", "--LL=8388608,16,64"]

# Where libgcv is least ahead of CGAL: of outer faces, and of whole regions.
CASES = [
    ("outer-face", "real", "shirts"),
    ("outer-face", "real", "albano"),
    ("outer-face", "real", "trousers"),
    ("outer-face", "paper", "~chain"),
    ("outer-face", "real", "dragon-egg"),
    ("region", "real", "rooms"),
    ("region", "real", "albano"),
    ("region", "real", "shirts"),
    ("region", "paper", "fork"),
    ("region", "paper", "stars"),
]

Counts = dict[str, float]  # of each event
Profile = dict[str, Counts]  # of each function, without those that it calls


def read_profile(text: str) -> Profile:
    """Return what a file of callgrind says."""
    profile: Profile = defaultdict(lambda: defaultdict(float))
    names: dict[str, str] = {}
    events: list[str] = []
    function = ""
    is_of_call = False
    for line in text.splitlines():
        if line.startswith("events: "):
            events = line.split()[1:]
        elif match := re.match(r"c?fn=(\(\d+\))(?: (.*))?$", line):
            if match[2]:
                names[match[1]] = match[2]
            if line.startswith("fn="):
                function = names[match[1]]
        elif line.startswith("calls="):
            is_of_call = True
        elif re.match(r"[+\-*\d]", line):
            if not is_of_call:
                for event, count in zip(events, line.split()[1:]):
                    profile[function][event] += int(count)
            is_of_call = False
    return profile


def short_name(function: str) -> str:
    """Return the name without what tells where it is and what it takes."""
    name = re.sub(r"\(anonymous namespace\)::|'\d+$", "", function)
    while re.search(r"<[^<>]*>", name):
        name = re.sub(r"<[^<>]*>", "", name)
    name = re.sub(r"\{lambda\([^()]*\)#\d+\}", "lambda", name)
    name = re.sub(r"\(.*", "", name)
    return re.sub(r"\bgcv::", "", name.split(" ")[-1])


def run(case: tuple[str, str, str], repetitions: int) -> tuple[Profile, list[int]]:
    """Return the profile, and how many predicates a sum takes."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind.out"
        command = ["valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={out}"]
        done = subprocess.run([*command, *CACHES, PROGRAM, *case, str(repetitions)],
                              capture_output=True, text=True)  # fmt: skip
        if done.returncode != 0:
            sys.exit(done.stderr.strip())
        return read_profile(out.read_text()), [int(count) for count in done.stdout.split()]


def of_one_sum(case: tuple[str, str, str]) -> tuple[Profile, list[int]]:
    once, _ = run(case, 1)
    thrice, predicates = run(case, 3)
    profile: Profile = defaultdict(lambda: defaultdict(float))
    for function, counts in thrice.items():
        for event, count in counts.items():
            before = once[function][event] if function in once else 0
            profile[short_name(function)][event] += (count - before) / 2
    return profile, predicates


def misses(counts: Counts, cache: str) -> float:
    return counts[cache + "mr"] + counts[cache + "mw"]


def row(case: tuple[str, str, str], most: int) -> str:
    profile, predicates = of_one_sum(case)
    total: Counts = defaultdict(float)
    for counts in profile.values():
        for event, count in counts.items():
            total[event] += count
    by_instructions = sorted(profile.items(), key=lambda item: -item[1]["Ir"])
    functions = [
        f"{counts['Ir'] / total['Ir']:.0%} `{function}`"
        for function, counts in by_instructions[:most]
    ]
    numbers = [
        total["Ir"],
        total["Dr"] + total["Dw"],
        misses(total, "D1"),
        misses(total, "DL"),
        *predicates,
    ]
    kind, _, pair = case
    cells = [f"{pair}, {kind.replace('-', ' ')}", *(f"{x:,.0f}" for x in numbers)]
    return f"| {' | '.join([*cells, ', '.join(functions)])} |"


HEAD = """\
| sum | instructions | reads and writes | that miss L1 | all caches | predicates by doubles | \
fixed width | larger | functions |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("case", nargs="*", metavar="outer-face|region SET PAIR",
                        help="instead of where libgcv is least ahead of CGAL")  # fmt: skip
    parser.add_argument("--most", type=int, default=4, help="functions of each")
    options = parser.parse_args()
    if options.case and len(options.case) != 3:
        parser.error("a case has three parts")
    print(HEAD)
    for case in [tuple(options.case)] if options.case else CASES:
        print(row(case, options.most), flush=True)


if __name__ == "__main__":
    main()

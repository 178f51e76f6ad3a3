# SPDX-License-Identifier: LGPL-3.0-or-later
"""No case takes over 5 % more instructions than are kept for it in counts.txt.

Three sums in a process less one, halved, are what counts: neither the start of a process
nor what its first sum sets up. The environment is empty, so that nothing of it has a part.
After a change that is worth its instructions, and after one that saves many, --update
keeps the counts of the day.
"""

import argparse
import pathlib
import re
import shlex
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
COUNTS = FOLDER / "counts.txt"
PROGRAM = FOLDER.parents[1] / "build/release/tests/speed/speed_case"
TOLERANCE = 0.05


def cases(program: pathlib.Path) -> list[str]:
    return subprocess.run(
        [program], env={}, check=True, stdout=subprocess.PIPE, text=True
    ).stdout.split()


def total(valgrind: str, program: pathlib.Path, case: str, repetitions: int) -> int:
    out = program.with_name(f"{case}.{repetitions}.callgrind")
    callgrind = [valgrind, "--quiet", "--tool=callgrind", f"--callgrind-out-file={out}"]
    subprocess.run([*callgrind, program, case, str(repetitions)], env={}, check=True)
    return int(re.findall(r"^totals: (\d+)$", out.read_text(), re.MULTILINE)[0])


def instructions(valgrind: str, program: pathlib.Path, case: str) -> int:
    once, thrice = (total(valgrind, program, case, repetitions) for repetitions in (1, 3))
    return (thrice - once) // 2


def kept_counts() -> dict[str, int]:
    lines = [line.split() for line in COUNTS.read_text().splitlines()]
    return {case: int(count) for case, count in lines}


def complaints(counts: dict[str, int], kept: dict[str, int]) -> list[str]:
    if counts.keys() != kept.keys():
        return [f"{COUNTS.name} is about other cases: {', '.join(kept)}"]
    found = []
    for case, count in counts.items():
        change = count / kept[case] - 1
        print(f"{case}: {count} instructions, {kept[case]} kept, {change:+.2%}")
        if change > TOLERANCE:
            found.append(f"{case} takes {count} instructions: {change:.2%} above {kept[case]}")
        elif change < -TOLERANCE:
            print(f"{case} has become faster: its count should be updated")
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--valgrind", default="valgrind")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM, help="speed_case, built")
    parser.add_argument("--update", action="store_true", help="keep these counts")
    options = parser.parse_args()

    counts = {
        case: instructions(options.valgrind, options.program, case)
        for case in cases(options.program)
    }
    if options.update:
        COUNTS.write_text("".join(f"{case} {count}\n" for case, count in counts.items()))
        return 0
    found = complaints(counts, kept_counts())
    if found:
        print(*found, sep="\n")
        print("To keep the new counts:", shlex.join(["python3", *sys.argv, "--update"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

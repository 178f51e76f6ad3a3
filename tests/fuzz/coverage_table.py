# SPDX-License-Identifier: LGPL-3.0-or-later
"""What is reached of the library, room by room, and what is not: from the format of lcov."""

import argparse
import collections
import dataclasses
import itertools
import pathlib
import subprocess


@dataclasses.dataclass
class Counts:
    """How often lines, branches and functions of a file ran. The keys are numbers of lines."""

    lines: dict[int, int] = dataclasses.field(default_factory=dict)
    branches: dict[str, int] = dataclasses.field(default_factory=dict)
    functions: dict[int, int] = dataclasses.field(default_factory=dict)
    names: dict[int, str] = dataclasses.field(default_factory=dict)


def read(report: pathlib.Path) -> dict[pathlib.Path, Counts]:
    """Of what is compiled several times, such as templates, the sum."""
    files: dict[pathlib.Path, Counts] = {}
    counts = Counts()
    starts: dict[str, int] = {}
    for record in report.read_text().splitlines():
        key, _, value = record.partition(":")
        if key == "SF":
            file = pathlib.Path(value).relative_to(pathlib.Path.cwd())
            counts = files.setdefault(file, Counts())
            starts = {}
        elif key == "FN":
            line, name = value.split(",", 1)
            starts[name] = int(line)
            counts.names[int(line)] = name
        elif key == "FNDA":
            count, name = value.split(",", 1)
            line_number = starts[name]
            counts.functions[line_number] = counts.functions.get(line_number, 0) + int(count)
        elif key == "DA":
            line, count = value.split(",")
            counts.lines[int(line)] = counts.lines.get(int(line), 0) + int(count)
        elif key == "BRDA":
            branch, _, count = value.rpartition(",")
            taken = 0 if count == "-" else int(count)
            counts.branches[branch] = counts.branches.get(branch, 0) + taken
    return files


def share(reached: int, all_of_them: int) -> str:
    if all_of_them == 0:
        return "| 0 | |"
    return f"| {all_of_them:,} | {100 * reached / all_of_them:.1f} % |"


def row(name: str, group: list[Counts]) -> str:
    cells = ""
    for kind in ("functions", "lines", "branches"):
        counts = [count for one in group for count in getattr(one, kind).values()]
        cells += " " + share(sum(count > 0 for count in counts), len(counts))[:-2]
    return f"| {name}{cells} |"


def table(files: dict[pathlib.Path, Counts]) -> list[str]:
    rooms: dict[str, list[Counts]] = collections.defaultdict(list)
    for file, counts in files.items():
        rooms[str(file.parent)].append(counts)
    head = "| room | functions | reached | lines | reached | branches | reached |"
    rows = [row(f"`{room}`", rooms[room]) for room in sorted(rooms)]
    return [head, "| --- |" + " ---: |" * 6, *rows, row("all", list(files.values()))]


def readable(names: list[str]) -> list[str]:
    """Names of C++, without what clang puts before those of a file of its own."""
    plain = [name.rsplit(":", 1)[-1] for name in names]
    result = subprocess.run(
        ["c++filt"], input="\n".join(plain), capture_output=True, text=True, check=True
    )
    return result.stdout.splitlines()


def ranges(numbers: list[int]) -> list[tuple[int, int]]:
    """Numbers that follow one another, as first and last."""
    found = []
    for _, run in itertools.groupby(enumerate(numbers), lambda pair: pair[1] - pair[0]):
        members = [number for _, number in run]
        found.append((members[0], members[-1]))
    return found


def unreached(files: dict[pathlib.Path, Counts]) -> list[str]:
    result = []
    for file, counts in sorted(files.items()):
        text = file.read_text().splitlines()
        starts = sorted(line for line, count in counts.functions.items() if count == 0)
        lines = ranges(sorted(line for line, count in counts.lines.items() if count == 0))
        names = readable([counts.names[line] for line in starts])
        result += [f"{file}:{line}: {name}" for line, name in zip(starts, names, strict=True)]
        for first, last in lines:
            result.append(f"{file}:{first}-{last}")
            result += [f"    {line}" for line in text[first - 1 : last]]
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("report", type=pathlib.Path, help="of llvm-cov export -format=lcov")
    parser.add_argument("unreached", type=pathlib.Path, help="where to write what is not reached")
    arguments = parser.parse_args()
    files = read(arguments.report)
    print(*table(files), sep="\n")
    arguments.unreached.write_text("".join(line + "\n" for line in unreached(files)))


if __name__ == "__main__":
    main()

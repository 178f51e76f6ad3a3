# SPDX-License-Identifier: LGPL-3.0-or-later
"""The rooms of the core include downwards only, and no files include each other.

A room is a folder of cpp/; a header and the source of the same name are one file here.
The order of the rooms, from the lowest to the highest, is that of cpp/CMakeLists.txt.
"""

import argparse
import pathlib
import re
import sys
from collections.abc import Iterable

Unit = tuple[str, str]  # room and name

LONGEST_FILE = 400
LONGEST_CLASS = 250


def order_of_rooms(cmake: str) -> list[str]:
    return re.findall(r"^gcv_room\((\w+)", cmake, re.MULTILINE)


def includes(text: str) -> list[str]:
    return re.findall(r'^#include "([^"]+)"', text, re.MULTILINE)


def read_units(files: Iterable[pathlib.Path]) -> tuple[dict[Unit, set[Unit]], list[str]]:
    """The units that each unit includes, and what is wrong with names."""
    files = list(files)
    headers: dict[str, Unit] = {}
    wrong = []
    for file in files:
        if file.suffix == ".hpp":
            if file.name in headers:
                wrong.append(f"{file.name} is in {headers[file.name][0]} and in {file.parent.name}")
            headers[file.name] = (file.parent.name, file.stem)
    graph: dict[Unit, set[Unit]] = {}
    for file in files:
        unit = (file.parent.name, file.stem)
        found = graph.setdefault(unit, set())
        for name in includes(file.read_text()):
            if name not in headers:
                wrong.append(f"{file}: {name} is not a header of the core")
            elif headers[name] != unit:
                found.add(headers[name])
    return graph, wrong


def upward(graph: dict[Unit, set[Unit]], rooms: list[str]) -> list[str]:
    height = {room: k for k, room in enumerate(rooms)}
    return [
        f"{unit[0]}/{unit[1]} includes {other[0]}/{other[1]}, which is above it"
        for unit, others in graph.items()
        for other in sorted(others)
        if height[other[0]] > height[unit[0]]
    ]


def reachable(graph: dict[Unit, set[Unit]], start: Unit) -> set[Unit]:
    found: set[Unit] = set()
    ahead = list(graph[start])
    while ahead:
        unit = ahead.pop()
        if unit not in found:
            found.add(unit)
            ahead += graph[unit]
    return found


def circles(graph: dict[Unit, set[Unit]]) -> list[str]:
    return [
        f"{room}/{name} includes itself in the end"
        for room, name in graph
        if (room, name) in reachable(graph, (room, name))
    ]


def too_long(files: Iterable[pathlib.Path]) -> list[str]:
    return [
        f"{file} has {lines} lines, more than {LONGEST_FILE}"
        for file in files
        if (lines := len(file.read_text().splitlines())) > LONGEST_FILE
    ]


CLASS = re.compile(
    r"(?<!enum )\b(?:class|struct)\s+(?:alignas\(\w+\)\s+)?([\w:]+)"  # its name
    r"(?:<[^{};]*>)?\s*(?:final\s*)?(?::[^{};]*)?\{"  # what it specialises and extends
)
NO_CODE = re.compile(r"""//[^\n]*|"(?:\\.|[^"\\\n])*"|(?<!\w)'(?:\\.|[^'\\\n])+'""")


def class_lengths(text: str) -> list[tuple[str, int]]:
    """Each class and struct, and its lines from its name to its closing brace."""
    text = NO_CODE.sub("", text)
    lengths = []
    for start in CLASS.finditer(text):
        depth, end = 1, start.end()
        while depth > 0 and end < len(text):
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        lengths.append((start[1], text.count("\n", start.start(), end) + 1))
    return lengths


def too_long_classes(files: Iterable[pathlib.Path]) -> list[str]:
    return [
        f"{file}: {name} has {lines} lines, more than {LONGEST_CLASS}"
        for file in files
        for name, lines in class_lengths(file.read_text())
        if lines > LONGEST_CLASS
    ]


def check_the_checks() -> None:
    low, high = ("low", "a"), ("high", "b")
    assert upward({low: {high}, high: set()}, ["low", "high"])
    assert not upward({low: set(), high: {low}}, ["low", "high"])
    assert circles({low: {high}, high: {low}})
    assert not circles({low: set(), high: {low}})
    assert class_lengths("enum class E { a };\ntemplate <class T> void f() {\n}\n") == []
    assert class_lengths("struct A : B<C> {  // not a }\n  char c = '}';\n};\nint i;") == [("A", 3)]
    assert class_lengths("class A {\n  struct alignas(16) B {\n  };\n};") == [("A", 4), ("B", 2)]
    assert class_lengths("class A::B final {\n  void f() {\n  }\n};\nvoid g() {}") == [("A::B", 4)]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("core", type=pathlib.Path, help="the folder cpp")
    core = parser.parse_args().core
    check_the_checks()
    rooms = order_of_rooms((core / "CMakeLists.txt").read_text())
    files = sorted([*core.glob("*/*.hpp"), *core.glob("*/*.cpp")])
    graph, wrong = read_units(files)
    folders = {folder.name for folder in core.iterdir() if folder.is_dir()}
    wrong += [f"{folder} is not a room of CMakeLists.txt" for folder in folders - set(rooms)]
    wrong += [f"{file} is in no room" for file in core.glob("*.?pp")]
    wrong += upward(graph, rooms) + circles(graph) + too_long(files) + too_long_classes(files)
    print(*wrong, f"{len(files)} files in {len(rooms)} rooms", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The binary interface against that of the last release; docs/ABI.md says what may change.

    abi.py baseline         write libgcv.abi, as part of a release
    abi.py symbols          enter new functions in Debian's symbols file
    abi.py check-baseline   fail on a change that breaks programs
    abi.py check-symbols    fail where Debian's symbols file is not complete

What is looked at is the C interface alone, compiled with debug information and without the
core. Both checks also see whether changes are told apart that must fail and must not.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable

ROOT = pathlib.Path(__file__).resolve().parents[2]
BASELINE = ROOT / "tests/abi/libgcv.abi"
SYMBOLS = ROOT / "debian/libgcv0.symbols"

COMPILER = os.environ.get("CXX", "c++")
# fmt: off
OPTIONS = ["-std=c++20", "-w", "-g", "-O0", "-fPIC", "-fvisibility=hidden", "-shared",
           "-Dgcv_EXPORTS", "-Wl,-soname,libgcv.so.0"]
ABIDW = ["abidw", "--drop-private-types", "--exported-interfaces-only", "--no-architecture",
         "--no-comp-dir-path", "--no-corpus-path", "--no-elf-needed", "--no-show-locs",
         "--type-id-style", "hash"]
GENSYMBOLS = ["dpkg-gensymbols", "-plibgcv0", "-c4"]
# fmt: on

Edit = tuple[str, str, str]
"""A file in capi/, a pattern that occurs in it, and its replacement."""
Look = Callable[[pathlib.Path, pathlib.Path], str]
"""What is seen of an interface, from its sources and with a folder for scratch."""

LAYOUT = "layout.cpp"
"""Does not compile where a struct has changed, and is no part of the interface."""
HEADER, HANDLES, SOURCE, MAP = "include/gcv/gcv.h", "handles.hpp", "version.cpp", "gcv.map"
OPTIONS_SOURCE = "options.cpp"
"""Names version nodes, as gcv.map does."""

NEW_FUNCTION: list[Edit] = [
    (HEADER, r"(#ifdef __cplusplus\n\})", r"GCV_API int32_t gcv_new(void);\n\1"),
    (SOURCE, r"\Z", "int32_t gcv_new(void) { return 1; }\n"),
    (MAP, r"\A([^{]*\{\s*global:)", r"\1 gcv_new;"),
]
LOST_FUNCTION: list[Edit] = [(MAP, r"\bgcv_polygon_area;", "")]

COMPATIBLE: list[Edit] = [
    *NEW_FUNCTION,
    (HEADER, r"\} gcv_options;", r"double later; \g<0>"),
    (HEADER, r"\} gcv_stats;", r"uint64_t later; \g<0>"),
    (HANDLES, r"(struct gcv_polygon \{[^}]*)\}", r"\1 int later = 0; }"),
]
INCOMPATIBLE: dict[str, list[Edit]] = {
    "a lost function": LOST_FUNCTION,
    "another version node": [(file, r"GCV_0\.1\b", "GCV_0.1.1") for file in (MAP, OPTIONS_SOURCE)],
    "another return type": [(HEADER, r"typedef int32_t gcv_status", "typedef int64_t gcv_status")],
    "gcv_options grows in the middle": [(HEADER, r"int32_t rounding;", r"\g<0> double earlier;")],
    "gcv_stats grows before its end": [
        (HEADER, r"uint64_t vertices_repaired;", r"uint64_t earlier; \g<0>")
    ],
    "gcv_edge_source grows": [(HEADER, r"\} gcv_edge_source;", r"uint32_t later; \g<0>")],
}


def interface(capi: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    """The C interface compiled as a shared library, from the sources in capi, in one piece."""
    library = folder / "libgcv.so.0"
    sources = sorted(source for source in capi.glob("*.cpp") if source.name != LAYOUT)
    unit = folder / "all.cpp"
    unit.write_text("".join(f'#include "{source}"\n' for source in sources))
    subprocess.run(
        [
            COMPILER,
            *OPTIONS,
            f"-I{capi / 'include'}",
            *(f"-I{room}" for room in (ROOT / "cpp").iterdir() if room.is_dir()),
            f"-I{capi}",
            unit,
            f"-Wl,--version-script={capi / MAP}",
            "-o",
            library,
        ],
        check=True,
    )
    return library


def describe(capi: pathlib.Path, folder: pathlib.Path) -> str:
    """What abidw says of the interface, with the names of its sources but not their folders."""
    described = subprocess.run(
        [*ABIDW, "--headers-dir", capi / "include", interface(capi, folder)],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    return re.sub(r" path='[^']*/", " path='", described)


def without_growth(description: str, baseline: str) -> str:
    """The structs that begin with their size as the baseline has them, where they only grew.

    abidiff's own has_data_member_inserted_at = end also lets fields in between pass.
    """
    for name in "gcv_options", "gcv_stats":
        pattern = rf" *<class-decl name='{name}'.*?\n((?: +<(?:data|var|/data).*\n)+)"
        now, before = re.search(pattern, description), re.search(pattern, baseline)
        if now and before and now[1].startswith(before[1]):
            description = description.replace(now[0], before[0])
    return description


def breaks_programs(capi: pathlib.Path, folder: pathlib.Path) -> str:
    """What abidiff reports of the interface, as against the baseline."""
    described = folder / "described.abi"
    described.write_text(without_growth(describe(capi, folder), BASELINE.read_text()))
    run = subprocess.run(
        ["abidiff", "--no-added-syms", BASELINE, described], capture_output=True, text=True
    )
    return run.stdout + run.stderr if run.returncode else ""


def gensymbols(capi: pathlib.Path, folder: pathlib.Path) -> tuple[str, str]:
    """Debian's symbols file as it should be, and in what it is not."""
    made = folder / "symbols"
    run = subprocess.run(
        [
            *GENSYMBOLS,
            f"-e{interface(capi, folder)}",
            f"-I{SYMBOLS}",
            f"-O{made}",
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    without_revisions = re.sub(r"(?m)^( \S+ [\d.]+)-\S+$", r"\1", made.read_text())
    return without_revisions, run.stdout + run.stderr if run.returncode else ""


def symbols_differ(capi: pathlib.Path, folder: pathlib.Path) -> str:
    return gensymbols(capi, folder)[1]


def with_edits(look: Look, edits: list[Edit]) -> str:
    """What is seen of a copy of capi/ that was changed."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        capi = folder / "capi"
        shutil.copytree(ROOT / "capi", capi)
        for file, pattern, replacement in edits:
            text, count = re.subn(pattern, replacement, (capi / file).read_text())
            if count == 0:
                raise SystemExit(f"{pattern!r} is not in capi/{file}")
            (capi / file).write_text(text)
        return look(capi, folder)


def check(look: Look, allowed: list[Edit], refused: dict[str, list[Edit]]) -> int:
    reports = {
        "nothing has changed": with_edits(look, []),
        "allowed changes": with_edits(look, allowed) if allowed else "",
    }
    found = [f"{name}: {report}" for name, report in reports.items() if report]
    found += [
        f"not noticed: {name}" for name, edits in refused.items() if not with_edits(look, edits)
    ]
    print(*found, sep="\n")
    return 1 if found else 0


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("task", choices=["baseline", "symbols", "check-baseline", "check-symbols"])
    task = parser.parse_args().task
    if task == "baseline":
        BASELINE.write_text(with_edits(describe, []))
    elif task == "symbols":
        SYMBOLS.write_text(with_edits(lambda *place: gensymbols(*place)[0], []))
    elif task == "check-baseline":
        return check(breaks_programs, COMPATIBLE, INCOMPATIBLE)
    else:
        return check(
            symbols_differ,
            [],
            {"a new function": NEW_FUNCTION, "a lost function": LOST_FUNCTION},
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every block of code in the Markdown files of the repository is run.

This checks that each block has a runner, or a comment before it:

    <!-- run by c.smoke -->          another test runs it
    <!-- not run: takes minutes -->  nothing does, and why

A comment `<!-- rust: run by rust.test -->` is about all blocks of a page in a language. Commands
that are not run are parsed, and what they call of the repository must be there.

With languages to be run, it runs their blocks, and compares what they print with the block behind.
"""

from __future__ import annotations

import argparse
import pathlib
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator

from pages import Block, blocks, pages
from runners import RUNNERS, faults

SHELL = {"sh", "bash"}
PROGRAM = re.compile(r"^(?:\w+=\S* )*((?!build/)\w[\w.-]*/[\w./-]+)", re.MULTILINE)


def is_run(block: Block) -> bool:
    return block.language in RUNNERS and not block.not_run and not block.run_by


def wrong_mark(block: Block, tests: str) -> str:
    """What is wrong with what the page says of a block: nothing where it is right."""
    if block.run_by and not re.search(rf"\b{re.escape(block.run_by)}\b", tests):
        return f"there is no test {block.run_by}"
    if not (is_run(block) or block.not_run or block.run_by):
        return f"nothing runs a block of {block.language}, and no comment says so"
    return ""


def wrong_command(root: pathlib.Path, block: Block) -> str:
    """What is wrong with commands that are not run."""
    parsed = subprocess.run(["bash", "-n"], input=block.text, capture_output=True, text=True)
    if parsed.returncode:
        return parsed.stderr
    missing = [
        program
        for program in PROGRAM.findall(block.text)
        if not (root / program).exists() and not (block.page.parent / program).exists()
    ]
    return f"there is no {', '.join(missing)}" if missing else ""


def check_marks(root: pathlib.Path, found: list[Block]) -> Iterator[str]:
    tests = "".join(file.read_text() for file in root.glob("*/**/CMakeLists.txt"))
    for block in found:
        wrong = wrong_mark(block, tests)
        if not wrong and block.language in SHELL:
            wrong = wrong_command(root, block)
        if wrong:
            yield f"{block.place}: {wrong}"


def run_blocks(found: list[Block], languages: list[str]) -> Iterator[str]:
    for page in sorted({block.page for block in found}):
        for language in languages:
            chosen = [block for block in found if (block.page, block.language) == (page, language)]
            if chosen:
                yield from faults(chosen, language)


def count(found: list[Block]) -> Iterator[str]:
    run = [block.language for block in found if is_run(block)]
    elsewhere = [block.run_by for block in found if block.run_by]
    left = [block.not_run for block in found if block.not_run]
    for what, names in (("run", run), ("run by other tests", elsewhere), ("not run", left)):
        if names:
            counts = (f"{n} {name}" for name, n in sorted(Counter(names).items()))
            yield f"{len(names)} {what}: {', '.join(counts)}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path, help="the folder of the repository")
    parser.add_argument("--run", nargs="+", default=[], choices=sorted(RUNNERS), metavar="LANGUAGE")
    options = parser.parse_args()
    root: pathlib.Path = options.root.resolve()
    found = [block for page in pages(root) for block in blocks(page)]
    if options.run:
        found = [b for b in found if is_run(b) and b.language in options.run]
        wrong = list(run_blocks(found, options.run))
    else:
        wrong = list(check_marks(root, found))
    print(*wrong, *count(found), f"{len(wrong)} faults", sep="\n")
    if not found:
        print("no blocks were found, so nothing was tested")
    return int(bool(wrong) or not found)


if __name__ == "__main__":
    sys.exit(main())

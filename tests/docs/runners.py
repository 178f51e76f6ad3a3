# SPDX-License-Identifier: LGPL-3.0-or-later
"""How the blocks of a page are run, language by language.

A runner takes the blocks of a page in one language, and gives what is wrong with them.
"""

from __future__ import annotations

import doctest
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from typing import Callable

from pages import Block

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FLAGS = {"c": ["cc", "-std=c99"], "cpp": ["c++", "-std=c++17"]}
CARGO = """[package]
name = "page"
version = "0.0.0"
edition = "2021"

[dependencies]
gcv = {{ path = "{}" }}
rayon = "=1.10.0"

[workspace]
"""
COMMAND = re.compile(r"^\$ (.*(?:\n> .*)*)\n((?:(?!\$ ).*\n)*)", re.MULTILINE)
LOGGED = re.compile(r"(console\.log\(.*\);) // (.*)")
SEPARATOR = "\x1e"
LONGEST = 300  # seconds for a block

Runner = Callable[[list[Block], pathlib.Path], Iterator[str]]


def run(command: list[str], folder: pathlib.Path, **more: str) -> tuple[str, str]:
    """What it prints, and what went wrong."""
    done = subprocess.run(
        command,
        cwd=folder,
        env=os.environ | more,
        capture_output=True,
        text=True,
        check=False,
        timeout=LONGEST,
    )
    return done.stdout, f"{done.stdout}{done.stderr}" if done.returncode else ""


def compared(block: Block, output: str, wrong: str) -> Iterator[str]:
    """What is wrong with a program that ran: its status, or what it printed."""
    if wrong:
        yield f"{block.place}: fails\n{wrong}"
    elif block.output is not None and output != block.output:
        yield f"{block.place}: prints\n{output}in place of\n{block.output}"


def programs(blocks: list[Block], scratch: pathlib.Path) -> Iterator[str]:
    """Whole programs in C and C++, by the compilers CC and CXX, with the library GCV_LIBRARY."""
    library = pathlib.Path(os.environ["GCV_LIBRARY"])
    headers = [f"-I{ROOT / folder}" for folder in ("capi/include", "bindings/c/include")]
    for block in blocks:
        compiler, standard = FLAGS[block.language]
        compiler = os.environ.get({"c": "CC", "cpp": "CXX"}[block.language], compiler)
        source = scratch / f"program.{block.language}"
        source.write_text(block.text)
        strict = [standard, "-Wall", "-Wextra", "-Werror", *headers]
        linked = [str(library), f"-Wl,-rpath,{library.parent}", "-o", "program"]
        _, wrong = run([compiler, *strict, source.name, *linked], scratch)
        output = ""
        if not wrong:
            output, wrong = run(["./program"], scratch)
        yield from compared(block, output, wrong)


def python(blocks: list[Block], scratch: pathlib.Path) -> Iterator[str]:
    """Sessions with prompts, which go on through the page, and programs without."""
    session = [block for block in blocks if block.text.startswith(">>>")]
    if session:
        yield from doctested(session)
    for block in blocks:
        if block not in session:
            (scratch / "program.py").write_text(block.text)
            yield from compared(block, *run([sys.executable, "program.py"], scratch))


def doctested(session: list[Block]) -> Iterator[str]:
    text = ""
    for block in session:
        text += "\n" * (block.line - 1 - text.count("\n")) + block.text
    page = str(session[0].page)
    test = doctest.DocTestParser().get_doctest(text, {"__name__": "__main__"}, page, page, 0)
    found: list[str] = []
    doctest.DocTestRunner(verbose=False).run(test, out=found.append)
    if found:
        yield "".join(found)


def cell(blocks: list[Block], scratch: pathlib.Path) -> Iterator[str]:
    """The cells of a notebook, one after the other."""
    (scratch / "cells.py").write_text("\n".join(block.text for block in blocks))
    _, wrong = run([sys.executable, "cells.py"], scratch, MPLBACKEND="Agg")
    if wrong:
        yield f"{blocks[0].place}: a cell of this notebook fails\n{wrong}"


def console(blocks: list[Block], scratch: pathlib.Path) -> Iterator[str]:
    """Commands behind `$ `, with what they print; `gcv` is the program."""
    start = f'gcv() {{ {sys.executable} -m gcv "$@"; }}\n'
    for block in blocks:
        for command, expected in COMMAND.findall(block.text):
            text = start + command.replace("\n> ", "\n")
            printed, _ = run(["bash", "-c", f"exec 2>&1\n{text}"], scratch)
            if printed != expected:
                yield f"{block.place}: $ {command}\nprints\n{printed}in place of\n{expected}"


def rust(blocks: list[Block], scratch: pathlib.Path) -> Iterator[str]:
    """Whole programs, each a binary of one package."""
    cargo = os.environ.get("CARGO", "cargo")
    (scratch / "src").mkdir(exist_ok=True)
    (scratch / "Cargo.toml").write_text(CARGO.format(ROOT / "bindings/rust/gcv"))
    for block in blocks:
        (scratch / "src/main.rs").write_text(block.text)
        yield from compared(block, *run([cargo, "run", "--quiet"], scratch))


def js(blocks: list[Block], scratch: pathlib.Path) -> Iterator[str]:
    """The blocks of a page as one module; what they log is in the comment behind, or in a block."""
    modules = scratch / "node_modules"
    modules.mkdir(exist_ok=True)
    if not (modules / "gcv").exists():
        (modules / "gcv").symlink_to(os.environ.get("GCV_JAVASCRIPT", ROOT / "bindings/javascript"))
    text = "\n".join(block.text for block in blocks)
    expected = [comment for _, comment in LOGGED.findall(text)]
    separated = LOGGED.sub(lambda log: f"{log[1]} console.log('{SEPARATOR}');", text)
    (scratch / "page.mjs").write_text(separated)
    output, wrong = run(["node", "page.mjs"], scratch)
    if wrong or not expected:
        yield from compared(blocks[-1], output, wrong)
        return
    for logged, comment in zip(output.split(SEPARATOR), expected):
        if not squeezed(comment).startswith(squeezed(logged)):
            yield f"{blocks[0].page}: logs {logged.strip()} in place of {comment}"


def squeezed(text: str) -> str:
    return re.sub(r"\s", "", text)


RUNNERS: dict[str, Runner] = {
    "c": programs,
    "cell": cell,
    "console": console,
    "cpp": programs,
    "js": js,
    "python": python,
    "rust": rust,
}


def faults(blocks: list[Block], language: str) -> list[str]:
    """What is wrong with the blocks of one page in one language."""
    with tempfile.TemporaryDirectory() as scratch:
        return list(RUNNERS[language](blocks, pathlib.Path(scratch)))

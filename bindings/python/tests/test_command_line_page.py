# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The page of the program and its manual page: what they show is what there is."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from program import run_shell
from shapes import BINDING

from gcv._arguments import parser
from gcv._completion import subcommands

DOCS = BINDING.parent.parent / "docs"
MANUAL = DOCS / "gcv.1"
COMMAND = re.compile(r"^\$ (.*(?:\n> .*)*)\n((?:(?!\$ ).*\n)*)", re.MULTILINE)


def test_page(tmp_path: Path) -> None:
    pytest.importorskip("svgelements", reason="gcv[svg] is not installed: the page is not tested")
    page = (DOCS / "COMMAND_LINE.md").read_text()
    shown = ""
    for block in re.findall(r"^```console\n(.*?)^```", page, re.MULTILINE | re.DOTALL):
        for command, _ in COMMAND.findall(block):
            run = run_shell(tmp_path, command.replace("\n> ", "\n"))
            shown += f"$ {command}\n{run.stdout}"
    blocks = re.findall(r"^```console\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    assert shown == "".join(blocks)
    for command in subcommands(parser()):
        assert f"gcv {command}" in page


def test_manual_page_has_everything() -> None:
    text = MANUAL.read_text().replace("\\-", "-").replace('"', "")
    for command, options in subcommands(parser()).items():
        assert f".B {command}\n" in text
        for action in options._actions:
            for name in action.option_strings:
                assert re.search(rf"(?<![\w-]){name}(?![\w-])", text), name
            for choice in action.choices or ():
                assert choice in text


def test_manual_page_has_nothing_else() -> None:
    text = MANUAL.read_text().replace("\\-", "-")
    there = {
        name
        for options in subcommands(parser()).values()
        for action in options._actions
        for name in action.option_strings
    }
    assert set(re.findall(r"(?<![\w-])--[a-z-]+", text)) <= there | {"--version"}


@pytest.mark.parametrize(
    "command", [["mandoc", "-T", "lint", "-W", "warning"], ["man", "--warnings", "-l"]]
)
def test_manual_page_is_clean(command: list[str]) -> None:
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed: the manual page is not checked by it")
    run = subprocess.run([*command, str(MANUAL)], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stderr) == (0, "")
    if command[0] == "mandoc":
        assert run.stdout == ""

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv, run as from a shell."""

from __future__ import annotations

import contextlib
import io
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from gcv._command_line import main

Run = subprocess.CompletedProcess[str]
SLOT = "POLYGON ((0 0, 6 0, 6 6, 4 6, 4 2, 2 2, 2 6, 0 6))"
PEG = "POLYGON ((0 0, 2 0, 2 2, 0 2))"
FILES = {
    "a.wkt": "POLYGON ((0 0, 8 0, 8 6, 3 1, 0 7))\n",
    "b.wkt": "POLYGON ((0 0, 1 0, 0 1))\n",
    "slot.wkt": SLOT,
    "peg.wkt": PEG,
    "two.wkt": f"{SLOT}\n{PEG}\n",
    "bow tie.wkt": "POLYGON ((0 0, 2 2, 2 0, 0 2))\n",
    "table.txt": "# x y\n10 0\n\n8.5, 0 # near\n0 0\n",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def run_program(directory: Path, *arguments: str, text: str = "") -> Run:
    """Run the program in this process, with this text as its standard input."""
    stdin, folder, status = sys.stdin, Path.cwd(), 0
    output, errors = io.StringIO(), io.StringIO()
    sys.stdin = io.TextIOWrapper(io.BytesIO(text.encode()))
    os.chdir(directory)
    try:
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            status = main(list(arguments))
    except SystemExit as end:
        status = int(end.code or 0)
    finally:
        sys.stdin = stdin
        os.chdir(folder)
    return Run(arguments, status, output.getvalue(), errors.getvalue())


def run_shell(directory: Path, command: str) -> Run:
    """Run a command of bash in which gcv is the program; errors are in the output."""
    return subprocess.run(
        ["bash", "-c", f'gcv() {{ "{sys.executable}" -m gcv "$@"; }}\n{command}'],
        cwd=directory,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )


def output(folder: Path, command: str, text: str = "") -> str:
    """What a command prints, which must not fail."""
    run = run_program(folder, *command.split(), text=text)
    assert (run.stderr, run.returncode) == ("", 0)
    return run.stdout


def as_json(folder: Path, command: str) -> Any:
    return json.loads(output(folder, f"{command} --format json"))


def failure(run: Run, status: int) -> str:
    """The message of a run that failed with this status: one sentence, where it is no usage."""
    assert (run.stdout, run.returncode) == ("", status)
    assert "Traceback" not in run.stderr
    if status == 1:
        assert run.stderr.startswith("gcv: ")
        assert run.stderr.count("\n") == 1
    return run.stderr

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv, run as from a shell."""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import sys
from pathlib import Path

from gcv._command_line import main

Run = subprocess.CompletedProcess[str]


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

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv: subcommands, exit status, and where output and errors go."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import Optional

from ._arguments import parser
from ._commands import UsageError
from ._completion import subcommands
from ._ffi import Error
from ._files import STANDARD_INPUT

_FAILED, _INTERRUPTED = 1, 130


def main(arguments: Optional[list[str]] = None) -> int:
    """Run the program; the exit status is 0, 1 for a failure, 130 when interrupted.

    Wrong usage exits with the status 2.
    """
    program = parser()
    words = sys.argv[1:] if arguments is None else arguments
    options = program.parse_args(_with_command(program, words))
    try:
        _write(_run(options), options.output)
    except Error as error:
        return _fail(str(error))
    except BrokenPipeError:
        return _FAILED
    except OSError as error:
        return _fail(": ".join(filter(None, (error.filename, error.strerror))))
    except MemoryError:
        return _fail("there is not enough memory")
    except KeyboardInterrupt:
        print("gcv: interrupted", file=sys.stderr)
        return _INTERRUPTED
    return 0


def _with_command(program: argparse.ArgumentParser, words: list[str]) -> list[str]:
    """The words of the command line, with sum before those that begin with a file or an option."""
    if not words or words[0] in (*subcommands(program), "-h", "--help", "--version"):
        return words
    return ["sum", *words] if words[0].startswith("-") or Path(words[0]).exists() else words


def _run(options: argparse.Namespace) -> str:
    """What is to be printed."""
    files = [getattr(options, name, None) for name in ("a", "b", "scene", "container", "positions")]
    usage: argparse.ArgumentParser = options.parser
    if files.count(STANDARD_INPUT) > 1:
        usage.error("standard input can stand for one file only")
    try:
        text: str = options.run(options)
        return text
    except UsageError as error:
        usage.error(str(error))


def _write(text: str, file: Optional[str]) -> None:
    lines = text and text + "\n"
    if file is not None:
        Path(file).write_text(lines)
        return
    try:
        print(lines, end="", flush=True)
    except OSError:
        # So that Python does not try once more when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise


def _fail(reason: str) -> int:
    print(f"gcv: {reason}", file=sys.stderr)
    return _FAILED

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv: subcommands, exit status, and where output and errors go."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Optional

from ._arguments import parser
from ._commands import UsageError
from ._completion import subcommands
from ._ffi import Error
from ._files import STANDARD_INPUT
from ._writing import STANDARD_OUTPUT, write

_FAILED, _INTERRUPTED = 1, 130


def main(arguments: Optional[list[str]] = None) -> int:
    """Run the program; the exit status is 0, 1 for a failure, 130 when interrupted.

    Wrong usage exits with the status 2.
    """
    program = parser()
    words = sys.argv[1:] if arguments is None else arguments
    options, unknown = program.parse_known_args(_with_command(program, words))
    if unknown:
        options.parser.error(f"unrecognized arguments: {' '.join(unknown)}")
    try:
        text = _run(options)
        write(text and text + "\n", options.output)
    except Error as error:
        return _fail(str(error))
    except BrokenPipeError:
        return _FAILED
    except OSError as error:
        return _fail(f"{error.filename or repr('')}: {error.strerror}")
    except MemoryError:
        return _fail("there is not enough memory")
    except KeyboardInterrupt:
        print("gcv: interrupted", file=sys.stderr)
        return _INTERRUPTED
    return 0


def _with_command(program: argparse.ArgumentParser, words: list[str]) -> list[str]:
    """The words of the command line, with sum before those that begin with a file or an option.

    A word with a suffix is a file, too: it may be one that is missing.
    """
    if not words or words[0] in (*subcommands(program), "-h", "--help", "--version"):
        return words
    first = Path(words[0])
    is_file = words[0].startswith("-") or first.suffix or first.exists()
    return ["sum", *words] if is_file else words


def _run(options: argparse.Namespace) -> str:
    """What is to be printed."""
    files = [getattr(options, name, None) for name in ("a", "b", "scene", "container", "positions")]
    usage: argparse.ArgumentParser = options.parser
    if files.count(STANDARD_INPUT) > 1:
        usage.error("standard input can stand for one file only")
    if STANDARD_OUTPUT == options.output == getattr(options, "svg", None):
        usage.error("--svg - takes -o FILE: the result goes to standard output")
    try:
        text: str = options.run(options)
        return text
    except UsageError as error:
        usage.error(str(error))


def _fail(reason: str) -> int:
    print(f"gcv: {reason}", file=sys.stderr)
    return _FAILED

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv: subcommands, exit status, and where output and errors go."""

from __future__ import annotations

import argparse
import difflib
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Optional

from ._arguments import parser
from ._commands import UsageError
from ._completion import option_strings, subcommands
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
    try:
        options, unknown = program.parse_known_args(_with_command(program, words))
        if unknown:
            meant = _meant(unknown[0], option_strings(options.parser))
            options.parser.error(f"unrecognized arguments: {' '.join(unknown)}{meant}")
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
    """The words of the command line, with sum before those that begin with a file or its option.

    A word with a suffix is a file, too: it may be one that is missing.
    """
    commands, own = subcommands(program), option_strings(program)
    if not words or words[0] in (*commands, *own):
        return words
    first = words[0]
    if first.startswith("-") and first not in (STANDARD_INPUT, "--"):
        known = [*own, *option_strings(commands["sum"])]
        if _name(first) not in known and not first.startswith("-o"):
            program.error(f"unrecognized arguments: {first}{_meant(first, known)}")
    elif first[:1] != "-" and not Path(first).suffix and not Path(first).exists():
        others = f"; choose from {', '.join(commands)}"
        program.error(f"there is no command {first!r}{_meant(first, commands) or others}")
    return ["sum", *words]


def _name(option: str) -> str:
    """The name of an option, which can have its value after it."""
    return option.partition("=")[0]


def _meant(word: str, known: Iterable[str]) -> str:
    """A question for a word that is like one of those that are known; nothing for others."""
    found = difflib.get_close_matches(_name(word), known, 1)
    return f"; did you mean {found[0]}?" if found else ""


def _run(options: argparse.Namespace) -> str:
    """What is to be printed."""
    files = [getattr(options, name, None) for name in ("a", "b", "scene", "container", "positions")]
    usage: argparse.ArgumentParser = options.parser
    if files.count(STANDARD_INPUT) > 1:
        usage.error("standard input can stand for one file only")
    drawing = getattr(options, "svg", None)
    if STANDARD_OUTPUT == options.output == drawing:
        usage.error("--svg - takes -o FILE: the result goes to standard output")
    if options.output != STANDARD_OUTPUT and _is_same(options.output, drawing):
        usage.error("--svg and -o name the same file")
    try:
        text: str = options.run(options)
        return text
    except UsageError as error:
        usage.error(str(error))


def _is_same(file: str, other: Optional[str]) -> bool:
    return other is not None and Path(file).absolute() == Path(other).absolute()


def _fail(reason: str) -> int:
    print(f"gcv: {reason}", file=sys.stderr)
    return _FAILED

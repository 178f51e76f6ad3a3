# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where what the program prints goes."""

from __future__ import annotations

import errno
import os
import sys

STANDARD_OUTPUT = "-"


def write(text: str, file: str) -> None:
    """Write a text to a file, or to standard output.

    Raises OSError that has the name of either.
    """
    name = "standard output" if file == STANDARD_OUTPUT else file
    try:
        if file == STANDARD_OUTPUT:
            _print(text)
        else:
            with open(file, "w") as opened:
                opened.write(text)
    except OSError as error:
        error.filename = name
        raise


def _print(text: str) -> None:
    if sys.stdout is None:
        raise OSError(errno.EBADF, os.strerror(errno.EBADF))
    try:
        print(text, end="", flush=True)
    except OSError:
        # So that Python does not try once more when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise

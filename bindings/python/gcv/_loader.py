# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Finds and opens the shared library."""

from __future__ import annotations

import ctypes.util
import os
import sys
from collections.abc import Iterator
from ctypes import CDLL
from pathlib import Path
from typing import Optional

_FILES = {"win32": "gcv.dll", "darwin": "libgcv.dylib"}
"""The name of the library's file, by sys.platform. Elsewhere it is the SONAME."""


def load() -> CDLL:
    """Open libgcv.

    The environment variable GCV_LIBRARY, when it is set, names the one file to
    open, by an absolute path. Otherwise the first of these that works is taken:
    the file beside this package, what the system's dynamic loader finds, and what
    ctypes.util.find_library finds. The working directory is not one of them.

    Raises ImportError, with every place tried in its message.
    """
    tried = []
    for place, name in _candidates():
        try:
            return _open(name)
        except (OSError, AttributeError) as error:
            tried.append(f"{place}: {error}")
    raise ImportError("\n  ".join(["libgcv cannot be loaded; tried", *tried]))


def _candidates() -> Iterator[tuple[str, Optional[str]]]:
    chosen = os.environ.get("GCV_LIBRARY")
    if chosen:
        if not os.path.isabs(chosen):
            raise ImportError(f"GCV_LIBRARY is not an absolute path: {chosen!r}")
        yield "the environment variable GCV_LIBRARY", chosen
        return
    file = _FILES.get(sys.platform, "libgcv.so.0")
    yield "the file beside the package", str(Path(__file__).absolute().with_name(file))
    yield "the dynamic loader", file
    yield "ctypes.util.find_library", ctypes.util.find_library("gcv")


def _open(name: Optional[str]) -> CDLL:
    if name is None:
        raise OSError("found nothing")
    library = CDLL(name)
    version = library.gcv_version_number()
    if not 100 <= version < 10000:
        raise OSError(f"{name}: version number {version} is none of 0.1 and later 0.x")
    return library

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Polygons of files, with the names that messages call them by."""

from __future__ import annotations

import importlib
from collections import Counter
from typing import Any, Callable, NamedTuple, Optional

from ._ffi import INVALID_ARGUMENT, Error, InputError, named
from ._polygon import Polygon
from ._sources import PolygonLike

NUMBER = r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?"
"""A number in a file, as a pattern."""


class NamedPolygon(NamedTuple):
    """A polygon, and where it comes from: a file, and perhaps a place in it."""

    name: str
    polygon: Polygon


class Reading(NamedTuple):
    """How a file is read."""

    file: str
    """What messages call it."""
    flatten: Optional[float]
    """How far lines may be from the curves that they stand for; None where none may."""
    note: Callable[[str], None]
    """Told in a sentence of what is left out."""

    def leave_out(self, counts: Counter[str]) -> None:
        """Say that so many things of these kinds are left out."""
        found = [f"{count} {kind}" for kind, count in counts.items() if count]
        if found:
            self.note(f"{self.file}: left out: {', '.join(found)}")


def make(name: str, source: PolygonLike, holes: Optional[list[Any]] = None) -> NamedPolygon:
    """The polygon of a source, whose errors have that name."""
    try:
        return NamedPolygon(name, Polygon(source, holes))
    except Error as error:
        raise named(error, name) from None


def invalid(name: str, reason: str) -> InputError:
    """The error for a file, or a place in it, that is not what it should be."""
    return InputError(INVALID_ARGUMENT, f"{name}: {reason}")


def curve(name: str) -> InputError:
    """The error for a curve where none may be."""
    return invalid(name, "this is a curve; --flatten DISTANCE takes lines for it")


def too_fine(name: str) -> InputError:
    """The error for a curve that would take far too many lines."""
    return invalid(name, "lines as near to this curve as --flatten says are too many")


def package(module: str, kind: str, file: str) -> Any:
    """A module of the package that reads files of this kind, such as SVG."""
    name = module.partition(".")[0]
    try:
        importlib.import_module(name)
        return importlib.import_module(module)
    except ImportError:
        raise invalid(
            file, f"reading {kind} takes the package {name}, such as by pip install {name}"
        ) from None

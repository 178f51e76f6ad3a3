# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons that a subcommand works on, and work on one set of them after the other."""

from __future__ import annotations

import argparse
import contextlib
import importlib
import sys
from collections.abc import Iterator
from itertools import product
from typing import Any, Callable, NamedTuple, Optional

from ._call import Progress
from ._ffi import Error
from ._files import name_of, read_polygons
from ._named import NamedPolygon, invalid
from ._polygon import Polygon

Work = Callable[[tuple[Polygon, ...], Optional[Progress]], Any]
"""What is done with polygons, one of each file."""


class Operands(NamedTuple):
    """One polygon of each file."""

    numbers: dict[str, int]
    """Those of the polygons of files that have several."""
    polygons: tuple[Polygon, ...]
    name: str


def operands(options: argparse.Namespace, *names: str) -> list[Operands]:
    """Each polygon of the first of these files with each of the second one."""
    files = [_picked(options, name) for name in names]
    return [
        Operands(
            {
                name: number
                for name, file, (number, _) in zip(names, files, chosen)
                if len(file) > 1
            },
            tuple(one.polygon for _, one in chosen),
            " and ".join(one.name for _, one in chosen),
        )
        for chosen in product(*files)
    ]


def polygons_of(
    options: argparse.Namespace, name: str, *, or_none: bool = False
) -> list[NamedPolygon]:
    """All polygons of the file that the argument of this name says.

    or_none: whether geometries without a polygon will do.
    """

    def note(text: str) -> None:
        print(f"gcv: {text}", file=sys.stderr)

    return read_polygons(getattr(options, name), options.flatten, note, or_none=or_none)


def _picked(options: argparse.Namespace, name: str) -> list[tuple[int, NamedPolygon]]:
    """The polygons of a file with their numbers, or the one that was picked."""
    found = list(enumerate(polygons_of(options, name)))
    number = getattr(options, f"pick_{name}")
    if number is None:
        return found
    if not 0 <= number < len(found):
        reason = f"there is no polygon {number} in this file of {len(found)}"
        raise invalid(name_of(getattr(options, name)), reason)
    return [found[number]]


def each(sets: list[Operands], work: Work) -> list[Any]:
    """What the work gives for each set; errors say which one of several it was."""
    results = []
    for one in sets:
        try:
            with progress_bar() as progress:
                results.append(work(one.polygons, progress))
        except Error as error:
            if not one.numbers:
                raise
            raise type(error)(error.status, f"{one.name}: {error}") from None
    return results


@contextlib.contextmanager
def progress_bar() -> Iterator[Optional[Progress]]:
    """A bar on a terminal, once work has taken a second, where tqdm is installed.

    Where there is more to do than was thought, it counts the steps: nobody knows the end.
    """
    try:
        tqdm = importlib.import_module("tqdm").tqdm
    except ImportError:
        yield None
        return
    tqdm.monitor_interval = 0  # no thread that watches it
    with tqdm(disable=None, delay=1, unit=" steps", unit_scale=True, leave=False) as bar:

        def progress(done: int, estimate: int) -> None:
            bar.total = estimate if done < estimate else None
            bar.update(done - bar.n)

        yield progress

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""python -m gcv: the sum of two polygons in files, its outer face or its region."""

from __future__ import annotations

import argparse
import contextlib
import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Optional, Union

import gcv

from ._coordinates import Points
from ._drawing import svg


def main(arguments: Optional[list[str]] = None) -> int:
    """Run the program; the exit status is 0, 1 for a failure, 2 for wrong usage."""
    options = _parser().parse_args(arguments)
    try:
        result = _compute(options)
        if options.svg is not None:
            options.svg.write_text(_picture(result, options.drawn) + "\n")
    except (gcv.Error, OSError) as error:
        print(f"gcv: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("gcv: interrupted", file=sys.stderr)
        return 130
    print(result.wkt)
    if isinstance(result, gcv.Region):
        print(result.fits_wkt)
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m gcv",
        description="Prints the outer face of the Minkowski sum A + B as Well-Known Text, or "
        "its whole region: the polygons, and in a second line the segments and points of exact "
        "fits. A and B are files of Well-Known Text or GeoJSON, each with one polygon.",
    )
    parser.add_argument("a", type=Path, metavar="A.wkt")
    parser.add_argument("b", type=Path, metavar="B.wkt")
    parser.add_argument("--region", action="store_true", help="the whole region")
    placing = parser.add_mutually_exclusive_group()
    placing.add_argument(
        "--no-fit",
        nargs=2,
        type=float,
        metavar=("X", "Y"),
        help="instead the no-fit polygon A + (-B) + (X, Y): where the point (X, Y) of B may go "
        "while A and B touch",
    )
    placing.add_argument(
        "--inner-fit",
        nargs=2,
        type=float,
        metavar=("X", "Y"),
        help="instead the region where the point (X, Y) of B may go with B inside A",
    )
    parser.add_argument("--rounding", choices=["nearest", "outward"], default="nearest")
    parser.add_argument(
        "--tolerance",
        type=float,
        default=0.0,
        metavar="DISTANCE",
        help="how far the result may be from the exact one; default 0. A and B are simplified "
        "within half of it, each",
    )
    parser.add_argument("--threads", type=int, default=1, metavar="N", help="0: all; default 1")
    parser.add_argument("--svg", type=Path, metavar="FILE", help="also draws the polygons")
    parser.add_argument("--version", action="version", version=gcv.library_version())
    return parser


def _compute(options: argparse.Namespace) -> Union[gcv.OuterFace, gcv.Region]:
    a, b = _read(options.a), _read(options.b)
    options.drawn = [a._ring_points(), b._ring_points()]
    function: Any
    if options.inner_fit is not None:
        function, point = gcv.inner_fit_region, [options.inner_fit]
    elif options.no_fit is not None:
        function = gcv.no_fit_region if options.region else gcv.no_fit_polygon
        point = [options.no_fit]
    else:
        function = gcv.minkowski_sum_region if options.region else gcv.minkowski_sum
        point = []
    with _progress_bar() as progress:
        result: Union[gcv.OuterFace, gcv.Region] = function(
            *(a, b, *point),
            rounding=options.rounding,
            tolerance=options.tolerance,
            threads=options.threads,
            progress=progress,
        )
    return result


def _picture(result: Union[gcv.OuterFace, gcv.Region], drawn: list[list[Points]]) -> str:
    if isinstance(result, gcv.Region):
        return svg([result._all_ring_points(), *drawn], result._fit_points())
    return svg([result._ring_points(), *drawn])


def _read(file: Path) -> gcv.Polygon:
    try:
        return gcv.Polygon(file)
    except gcv.Error as error:
        raise type(error)(error.status, f"{file}: {error}") from None


@contextlib.contextmanager
def _progress_bar() -> Iterator[Optional[gcv.Progress]]:
    """A bar on a terminal, once work has taken a second, where tqdm is installed."""
    try:
        tqdm = importlib.import_module("tqdm").tqdm
    except ImportError:
        yield None
        return
    with tqdm(disable=None, delay=1, unit=" steps", unit_scale=True, leave=False) as bar:

        def progress(done: int, estimate: int) -> None:
            bar.total = estimate
            bar.update(done - bar.n)

        yield progress


if __name__ == "__main__":
    sys.exit(main())

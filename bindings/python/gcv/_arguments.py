# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The subcommands of the program and their options."""

from __future__ import annotations

import argparse
import math
import re
import sys
from pathlib import Path
from typing import Any, Callable

from . import _answers, _commands, _formats
from ._completion import SHELLS, script
from ._ffi import LEAVE_OUTS, ROUNDINGS
from ._named import NUMBER
from ._sums import library_version
from ._writing import STANDARD_OUTPUT, write

_FILES = (
    "Files are Well-Known Text, GeoJSON, SVG or DXF, whichever they say; - is standard input. "
    "Of files with several polygons, each of A is taken with each of B. "
    "The exit status is 0, 1 for a failure, 2 for wrong usage, 130 when interrupted. "
    "The manual page gcv(1) says more."
)

_OTHER_IMAGES = {".bmp", ".eps", ".gif", ".jpeg", ".jpg", ".pdf", ".png", ".tif", ".tiff", ".webp"}


class _Parser(argparse.ArgumentParser):
    """A parser that takes every negative number for a number, such as -1e-3."""

    def __init__(self, **keywords: Any) -> None:
        super().__init__(allow_abbrev=False, **keywords)
        self._negative_number_matcher = re.compile(r"-(\.?\d|inf|nan)", re.IGNORECASE)

    def _print_message(self, message: str, file: Any = None) -> None:
        """Print help or a version as all output is, and messages as argparse does."""
        if file is sys.stdout:
            write(message, STANDARD_OUTPUT)
        else:
            super()._print_message(message, file)


def parser() -> argparse.ArgumentParser:
    """The parser; what it gives has the subcommand's function as run."""
    program = _Parser(
        prog="gcv",
        description="Minkowski sums of polygons, exactly, and what they are for.",
        epilog=_FILES,
    )
    program.add_argument("--version", action="version", version=library_version())
    commands = program.add_subparsers(dest="command", metavar="COMMAND", required=True)

    def command(name: str, run: Callable[..., str], text: str) -> argparse.ArgumentParser:
        added: argparse.ArgumentParser = commands.add_parser(
            name, help=text, description=text[0].upper() + text[1:] + ".", epilog=_FILES
        )
        added.set_defaults(run=run, parser=added)
        return added

    one = command("sum", _commands.sum_of, "the sum A + B: its outer face, or its region")
    _add_operands(one)
    _add_whole(one)
    _add_shape_options(one, tolerance=True)

    one = command("nfp", _commands.no_fit, "the no-fit polygon: where B may go round A")
    _add_operands(one)
    _add_reference(one)
    _add_whole(one)
    _add_shape_options(one, tolerance=True)

    one = command("inner-fit", _commands.inner_fit, "the region where B may go inside A")
    _add_operands(one)
    _add_reference(one)
    _add_leave_out(one, ["fits"])
    _add_shape_options(one)

    one = command("free", _commands.free, "where B is free among the polygons of a scene")
    _add_scene(one, "a polygon that B is to be in")
    _add_operand(one, "b")
    one.add_argument(
        "--window",
        nargs=4,
        type=_number,
        metavar=("XMIN", "YMIN", "XMAX", "YMAX"),
        help="the positions in this box alone",
    )
    one.add_argument(
        "--best",
        nargs=2,
        type=_number,
        metavar=("X", "Y"),
        help="instead the one position that is furthest in this direction",
    )
    _add_leave_out(one, ["fits"])
    _add_shape_options(one, formats=[*_formats.FORMATS, *_answers.FORMATS])

    one = command("relation", _commands.relations, "whether A and B are apart, touch or overlap")
    _add_operands(one)
    _add_question_options(one)

    one = command("distance", _commands.distances, "how far B is from A")
    _add_operands(one)
    _add_question_options(one)

    one = command("cast", _commands.casts, "how far B can move before it overlaps A")
    _add_operands(one)
    one.add_argument(
        "--motion",
        nargs=2,
        type=_number,
        metavar=("X", "Y"),
        required=True,
        help="how B is to move",
    )
    _add_question_options(one)

    one = command("penetration", _commands.penetrations, "the shortest way of B out of A")
    _add_operands(one)
    _add_leave_out(one, list(LEAVE_OUTS))
    _add_question_options(one)

    one = command("contacts", _commands.contact_lists, "what of A and B touches, or is near to it")
    _add_operands(one)
    _add_contact_limits(one)
    _add_question_options(one, positions=False)

    text = "which polygons of a scene overlap, touch, or are near"
    one = command("scene-pairs", _commands.scene_pairs, text)
    _add_scene(one)
    _add_limit(one)
    _add_answer_options(one)

    text = "what of the polygons of a scene touches, or is near"
    one = command("scene-contacts", _commands.scene_contacts, text)
    _add_scene(one)
    _add_contact_limits(one)
    _add_answer_options(one)

    one = command("offset", _commands.offsets, "A grown by a distance, or shrunk by it")
    _add_operand(one, "a")
    one.add_argument(
        "--distance", type=_offset, required=True, help="by which A grows; it shrinks below 0"
    )
    _add_tolerance(
        one, "how much more it may grow or shrink in places", required=True, type=_distance
    )
    _add_shape_options(one, rounding=False)

    one = command("simplify", _commands.simplify, "A with fewer vertices")
    _add_operand(one, "a")
    _add_tolerance(one, "how far the boundary may be from the given one", required=True)
    _add_shape_options(one, threads=False)

    one = command(
        "completion",
        lambda options: script(options.shell, program),
        "a script that completes commands of gcv in a shell",
    )
    one.add_argument("shell", choices=SHELLS)
    one.set_defaults(output=STANDARD_OUTPUT)
    return program


def _add_operands(to: argparse.ArgumentParser) -> None:
    _add_operand(to, "a")
    _add_operand(to, "b")


def _add_operand(to: argparse.ArgumentParser, name: str) -> None:
    to.add_argument(name, metavar=name.upper(), help="a file of polygons")
    to.add_argument(
        f"--pick-{name}",
        type=_count,
        metavar="N",
        help=f"the polygon with this number in {name.upper()}, from 0, and no other",
    )


def _add_scene(to: argparse.ArgumentParser, container: str = "a polygon round them") -> None:
    to.add_argument("scene", metavar="SCENE", help="a file, all polygons of which are there")
    to.add_argument("--container", metavar="FILE", help=container)


def _add_point(to: argparse._ActionsContainer, name: str, help_text: str) -> None:
    to.add_argument(
        name,
        nargs=2,
        type=_number,
        default=(0.0, 0.0),
        metavar=("X", "Y"),
        help=f"{help_text}; default 0 0",
    )


def _add_reference(to: argparse.ArgumentParser) -> None:
    _add_point(to, "--reference", "the point of B that tells where it is")


def _add_whole(to: argparse.ArgumentParser) -> None:
    to.add_argument("--region", action="store_true", help="with all holes and exact fits")
    _add_leave_out(to, list(LEAVE_OUTS))


def _add_leave_out(to: argparse.ArgumentParser, parts: list[str]) -> None:
    to.add_argument(
        "--leave-out",
        action="append",
        default=[],
        choices=parts,
        help="what a region is to lack, to save time",
    )


def _add_tolerance(to: argparse.ArgumentParser, text: str, **keywords: Any) -> None:
    keywords = {"type": _limit, **keywords}
    to.add_argument("--tolerance", metavar="DISTANCE", help=text, **keywords)


def _add_contact_limits(to: argparse.ArgumentParser) -> None:
    _add_limit(to)
    to.add_argument(
        "--slope",
        type=_limit,
        default=0.0,
        metavar="TANGENT",
        help="by how much sides may be turned to touch; default 0",
    )


def _add_limit(to: argparse.ArgumentParser) -> None:
    text = "how far apart they may be; default 0"
    to.add_argument("--distance", type=_limit, default=0.0, help=text)


def _add_shape_options(
    to: argparse.ArgumentParser,
    *,
    tolerance: bool = False,
    threads: bool = True,
    rounding: bool = True,
    formats: Any = None,
) -> None:
    """The options of what gives shapes."""
    if rounding:
        to.add_argument(
            "--rounding",
            choices=list(ROUNDINGS),
            default="nearest",
            help="how exact coordinates become floats; default nearest",
        )
    if tolerance:
        _add_tolerance(to, "how far the result may be from the exact one; default 0", default=0.0)
    if threads:
        _add_threads(to)
    to.add_argument(
        "--format",
        choices=formats or list(_formats.FORMATS),
        default=None if formats else "wkt",
        help="of what is printed",
    )
    to.add_argument(
        "--svg", type=_drawing, metavar="FILE", help="also draw a picture, with what was given"
    )
    _add_file_options(to)


def _add_question_options(to: argparse.ArgumentParser, *, positions: bool = True) -> None:
    """The options of questions about two polygons."""
    where = to.add_mutually_exclusive_group()
    _add_point(where, "--at", "how B is moved first")
    if positions:
        where.add_argument(
            "--positions", metavar="FILE", help="a table of these, an x and a y a line"
        )
    else:
        to.set_defaults(positions=None)
    _add_answer_options(to)


def _add_answer_options(to: argparse.ArgumentParser) -> None:
    """The options of what gives answers."""
    _add_threads(to)
    to.add_argument(
        "--format", choices=list(_answers.FORMATS), default="text", help="of what is printed"
    )
    _add_file_options(to)


def _add_threads(to: argparse.ArgumentParser) -> None:
    to.add_argument("--threads", type=_count, default=1, metavar="N", help="0: all; default 1")


def _add_file_options(to: argparse.ArgumentParser) -> None:
    to.add_argument(
        "--flatten",
        type=_distance,
        metavar="DISTANCE",
        help="take lines for the curves of SVG and DXF, no further from them than this",
    )
    to.add_argument(
        *("-o", "--output"),
        default=STANDARD_OUTPUT,
        metavar="FILE",
        help="print to this file; - is standard output",
    )


def _drawing(file: str) -> str:
    if Path(file).suffix.lower() in _OTHER_IMAGES:
        raise argparse.ArgumentTypeError(f"{file!r} has the name of another image than SVG")
    return file


def _number(text: str) -> float:
    value = float(text) if re.fullmatch(NUMBER, text.strip()) else math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def _distance(text: str) -> float:
    value = _number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not above 0")
    return value


def _limit(text: str) -> float:
    value = _number(text)
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text!r} is below 0")
    return value


def _offset(text: str) -> float:
    value = _number(text)
    if value == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is no offset")
    return value


def _count(text: str) -> int:
    if not re.fullmatch("[0-9]{1,9}", text):
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number of at most 9 digits")
    return int(text)

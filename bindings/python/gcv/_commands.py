# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The subcommands of the program: each takes its options and gives what is printed."""

from __future__ import annotations

import argparse
from ctypes import c_int8
from typing import Any, Callable, Optional

from . import _answers, _formats, _structs
from ._answers import Answer
from ._call import Progress
from ._contact_list import contacts
from ._contacts import record_of
from ._coordinates import Points
from ._drawing import svg
from ._ffi import Error
from ._files import name_of, read_points
from ._formats import Result, polygons_and_fits
from ._named import invalid
from ._offset import offset
from ._operands import each, operands, polygons_of, progress_bar
from ._polygon import Polygon
from ._region_sums import (
    inner_fit_region,
    minkowski_sum_region,
    minkowski_sum_region_many,
    no_fit_region,
    no_fit_region_many,
)
from ._scene import Scene
from ._sums import minkowski_sum, minkowski_sum_many, no_fit_polygon, no_fit_polygon_many
from ._two_polygons import cast, distance, penetration, relation
from ._writing import write

Options = argparse.Namespace

_FOR_RINGS = ("rounding", "tolerance", "threads")
_FOR_REGIONS = (*_FOR_RINGS, "leave_out")
_FOR_FITS = ("rounding", "threads", "leave_out")


class UsageError(Exception):
    """Options that do not go together."""


def sum_of(options: Options) -> str:
    if options.region:
        return _sums(options, _FOR_REGIONS, minkowski_sum_region, minkowski_sum_region_many)
    return _sums(options, _FOR_RINGS, minkowski_sum, minkowski_sum_many)


def no_fit(options: Options) -> str:
    if options.region:
        return _sums(options, _FOR_REGIONS, no_fit_region, no_fit_region_many)
    return _sums(options, _FOR_RINGS, no_fit_polygon, no_fit_polygon_many)


def inner_fit(options: Options) -> str:
    return _sums(options, _FOR_FITS, inner_fit_region)


def _sums(
    options: Options,
    names: tuple[str, ...],
    function: Callable[..., Any],
    of_many: Optional[Callable[..., Any]] = None,
) -> str:
    """The shapes that a function gives for all pairs, with the options of these names.

    of_many does so in one call.
    """
    if options.leave_out and "leave_out" not in names:
        raise UsageError("--leave-out takes --region")
    keywords = _keywords(options, *names)
    reference = [options.reference] if "reference" in options else []
    pairs = operands(options, "a", "b")

    def one(polygons: tuple[Polygon, ...], progress: Optional[Progress]) -> Any:
        return function(*polygons, *reference, **keywords, progress=progress)

    if of_many is None or len(pairs) == 1:
        shapes = each(pairs, one)
    else:
        a, b = zip(*(pair.polygons for pair in pairs))
        references = [point * len(pairs) for point in [reference] if point]
        with progress_bar() as progress:
            shapes = of_many(
                *(a, b, *references), **keywords, progress=progress, return_errors=True
            )
        for pair, shape in zip(pairs, shapes):
            if isinstance(shape, Error):
                # Alone, it says most about why.
                each([pair], one)
                raise shape
    results = [Result(pair.numbers, shape, shape.error_bound) for pair, shape in zip(pairs, shapes)]
    _draw(options, results, [polygon for pair in pairs for polygon in pair.polygons])
    return _formats.FORMATS[options.format](results)


def simplify(options: Options) -> str:
    keywords = _keywords(options, "tolerance", "rounding")
    given = operands(options, "a")
    found = each(given, lambda polygons, _progress: polygons[0].simplified(**keywords))
    results = [Result(of.numbers, *simplified) for of, simplified in zip(given, found)]
    _draw(options, results, [of.polygons[0] for of in given])
    return _formats.FORMATS[options.format](results)


def offsets(options: Options) -> str:
    keywords = _keywords(options, "distance", "tolerance", "threads")
    given = operands(options, "a")
    found = each(
        given, lambda polygons, progress: offset(polygons[0], **keywords, progress=progress)
    )
    results = [Result(of.numbers, region, region.error_bound) for of, region in zip(given, found)]
    _draw(options, results, [of.polygons[0] for of in given])
    return _formats.FORMATS[options.format](results)


def free(options: Options) -> str:
    """Where polygons are free among those of a scene, or the best of these positions."""
    allowed = _formats.FORMATS if options.best is None else _answers.FORMATS
    form = options.format or next(iter(allowed))
    if form not in allowed:
        raise UsageError(
            f"--format {form} is not for {'a position' if options.best else 'regions'}"
        )
    _check_limits(options)
    scene, members = _scene(options)
    moving = operands(options, "b")
    if options.best is not None:
        keywords = _keywords(options, "threads", "leave_out")
        found = each(
            moving,
            lambda polygons, progress: scene.best(
                *(polygons[0], options.best), **keywords, progress=progress
            ),
        )
        return _answers.FORMATS[form](
            [Answer(of.numbers, None, position) for of, position in zip(moving, found)]
        )
    keywords = _keywords(options, *_FOR_FITS)
    found = each(
        moving,
        lambda polygons, progress: scene.free_region(
            *(polygons[0], options.window), **keywords, progress=progress
        ),
    )
    results = [Result(of.numbers, region, region.error_bound) for of, region in zip(moving, found)]
    _draw(options, results, [*members, *(of.polygons[0] for of in moving)], scene.container)
    return _formats.FORMATS[form](results)


def _check_limits(options: Options) -> None:
    if options.best is not None:
        if options.window is not None:
            raise UsageError("--best takes no --window")
        if options.svg is not None:
            raise UsageError("--best takes no --svg: there is no region to draw")
        if options.rounding != "nearest":
            raise UsageError("--best takes no --rounding: its floats are free as they are")
        if options.container is None:
            raise UsageError("--best takes --container")
        if not any(options.best):
            raise UsageError("--best 0 0 is no direction")
    elif options.window is not None:
        left, bottom, right, top = options.window
        if left >= right or bottom >= top:
            raise UsageError("--window takes XMIN YMIN XMAX YMAX, the smaller ones first")
    elif options.container is None:
        raise UsageError("there is no end to what is free: --container or --window is needed")


def _scene(options: Options) -> tuple[Scene, list[Polygon]]:
    """A scene of all polygons of a file, in its order, and these."""
    members = [member.polygon for member in polygons_of(options, "scene", or_none=True)]
    scene = Scene(None if options.container is None else _container(options))
    scene.add(members)
    return scene, members


def _container(options: Options) -> Polygon:
    first, *others = polygons_of(options, "container")
    if others:
        reason = "a container is one polygon, and this file has several"
        raise invalid(name_of(options.container), reason)
    return first.polygon


def relations(options: Options) -> str:
    return _answers_of(options, relation, c_int8)


def distances(options: Options) -> str:
    return _answers_of(options, distance, _structs.Separation)


def casts(options: Options) -> str:
    return _answers_of(options, cast, _structs.Impact, options.motion)


def penetrations(options: Options) -> str:
    keywords = _keywords(options, "leave_out")
    return _answers_of(options, penetration, _structs.Escape, **keywords)


def contact_lists(options: Options) -> str:
    limits = options.distance, options.slope
    return _answers_of(options, contacts, None, *limits)


def scene_pairs(options: Options) -> str:
    return _list_of(options, Scene.pairs, "distance")


def scene_contacts(options: Options) -> str:
    return _list_of(options, Scene.contacts, "distance", "slope")


def _list_of(options: Options, function: Callable[..., Any], *names: str) -> str:
    """The list that a function gives for a scene, with the options of these names."""
    scene, _ = _scene(options)
    with progress_bar() as progress:
        found = function(scene, **_keywords(options, *names, "threads"), progress=progress)
    return _answers.FORMATS[options.format]([Answer({}, None, found)])


def _answers_of(
    options: Options, function: Callable[..., Any], kind: Any, *arguments: Any, **keywords: Any
) -> str:
    """What a function says of all pairs at all positions, in records of a C type."""
    table = None if options.positions is None else read_points(options.positions)
    pairs = operands(options, "a", "b")

    def ask(polygons: tuple[Polygon, ...], progress: Optional[Progress]) -> Any:
        return function(
            *(*polygons, options.at if table is None else table, *arguments),
            **{**keywords, "threads": options.threads, "progress": progress},
        )

    answers = []
    for pair, found in zip(pairs, each(pairs, ask)):
        if table is None:
            answers.append(Answer(pair.numbers, None, found))
        else:
            records = _records(found, kind)
            answers += [Answer(pair.numbers, *one) for one in zip(table, records)]
    return _answers.FORMATS[options.format](answers)


def _records(found: Any, kind: Any) -> list[Any]:
    """The records of what a function gives for many positions: an array where numpy is."""
    if isinstance(found, list):
        return found
    values = (kind * len(found)).from_buffer_copy(found.tobytes())
    return list(map(record_of(kind), values))


def _draw(
    options: Options,
    results: list[Result],
    given: list[Polygon],
    container: Optional[Polygon] = None,
) -> None:
    """A picture of the results and of what they were made from, where one is asked for."""
    if options.svg is None:
        return
    layers: list[list[Points]] = []
    fits: list[Points] = []
    for result in results:
        polygons, more = polygons_and_fits(result.shape)
        layers.append([ring for rings in polygons for ring in rings])
        fits += more
    layers += [polygon._ring_points() for polygon in dict.fromkeys(given)]
    ground = [] if container is None else container._ring_points()
    write(svg(layers, fits, ground) + "\n", options.svg)


def _keywords(options: Options, *names: str) -> dict[str, Any]:
    """The options of these names, as functions of the library take them."""
    return {name: getattr(options, name) for name in names}

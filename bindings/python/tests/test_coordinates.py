# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Coordinates as they are passed: none is lost or taken for another one."""

from __future__ import annotations

import math
import subprocess
import sys
from array import array
from itertools import chain
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from shapes import SQUARE, TRIANGLE

import gcv
from gcv._contacts import DTYPES

BEYOND = 2**53 + 1
"""The first integer that no float is."""
IN_A_ROW = [0, 0, 1, 0, 0, 1]


def check_refused(function: Callable[[], object], reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{reason}$"):
        function()


def check_translation(translation: Any, reason: str, number: str = "") -> None:
    check_refused(
        lambda: gcv.relation(SQUARE, SQUARE, translation), f"translation{number}: {reason}"
    )


# ---------------------------------------------------------------- numbers --


@pytest.mark.parametrize("dtype", ["complex64", "complex128", "clongdouble"])
def test_complex_numbers_are_refused(dtype: str) -> None:
    ring: Any = np.array([[0, 0], [1, 5j], [0, 1]], dtype)
    reason = "vertex 0: array.* is not a pair of numbers"
    check_refused(lambda: gcv.Polygon(ring), f"polygon: {reason}")
    check_refused(lambda: gcv.Polygon(list(map(tuple, ring))), "polygon: vertex 0: .*")
    check_refused(lambda: gcv.Polygon.many(ring[np.newaxis]), f"polygon 0: {reason}")
    pair = ring[1]
    reason = "array.* is not a pair of numbers"
    check_refused(lambda: gcv.relation(SQUARE, SQUARE, pair), f"translation: {reason}")
    check_refused(lambda: gcv.relation(SQUARE, SQUARE, ring), rf"translation\[0\]: {reason}")
    check_refused(lambda: gcv.no_fit_polygon(SQUARE, SQUARE, pair), f"reference: {reason}")


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(
    "of", [list, np.array, iter, lambda ring: array("q", chain.from_iterable(ring))]
)
def test_integers_that_no_float_is(sign: int, of: Callable[[Any], Any]) -> None:
    number = sign * BEYOND
    ring = [(0, 0), (number, 0), (number, 1)]
    reason = f"no float is the integer {number}"
    check_refused(lambda: gcv.Polygon(of(ring)), f"polygon: vertex 1: {reason}")
    check_refused(lambda: gcv.relation(SQUARE, of(ring)), f"b: vertex 1: {reason}")
    check_refused(lambda: gcv.Polygon.many([SQUARE, of(ring)]), f"polygon 1: vertex 1: {reason}")


def test_integers_that_floats_are() -> None:
    for large in (2**53, 2**53 + 2, 2**70, np.int64(2**62), np.uint64(2**63)):
        ring: list[Any] = [(0, 0), (large, 0), (0, large)]
        assert gcv.Polygon(ring) == gcv.Polygon(np.array(ring, float))


def test_integers_of_translations() -> None:
    reason = f"no float is the integer {BEYOND}"
    some: Any
    for some in ((BEYOND, 0), np.array([0, BEYOND])):
        check_translation(some, reason)
    for some in ([(0, 0), (BEYOND, 0)], np.array([(0, 0), (BEYOND, 0)])):
        check_translation(some, reason, r"\[1\]")
    geometry = f'{{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, {BEYOND}]]]}}'
    check_refused(lambda: gcv.Polygon(geometry), f"polygon: vertex 2: {reason}")


def test_elevations_are_no_coordinates() -> None:
    ring: list[Any] = [(x, y, "high", None) for x, y in TRIANGLE]
    for some in (ring, [*ring[:2], ring[2][:2]]):
        geometry = {"type": "Polygon", "coordinates": [some]}
        assert gcv.Polygon(geometry) == gcv.Polygon(TRIANGLE)


# ------------------------------------------------------------------ order --


def test_sets_have_no_order() -> None:
    reason = ".* is not a sequence: a set has no order"
    check_refused(lambda: gcv.Polygon(set(TRIANGLE)), f"polygon: {reason}")
    check_refused(lambda: gcv.Polygon([(0, 0), {1, 2}, (0, 1)]), f"polygon: vertex 1: {reason}")
    check_refused(lambda: gcv.Polygon(SQUARE, frozenset()), f"holes: {reason}")
    check_refused(lambda: gcv.Polygon.many({gcv.Polygon(SQUARE)}), f"sources: {reason}")
    places: Any
    for places in (set(TRIANGLE), {1, 2}):
        check_translation(places, reason)
    square: Any = gcv.Polygon(SQUARE)
    check_refused(lambda: gcv.no_fit_polygon(SQUARE, SQUARE, {1, 2}), f"reference: {reason}")
    check_refused(lambda: square.affine({1, 2, 3, 4, 5, 6}), f"matrix: {reason}")


def test_mappings_are_no_pairs() -> None:
    places: Any
    for places in ({}, {1: 2, 3: 4}, {(0, 0): 1}):
        check_translation(places, ".* is not a pair of numbers, nor a sequence of pairs")
    reason = "polygon: vertex 0: {.*} is not a pair of numbers"
    check_refused(lambda: gcv.Polygon([{1: 2, 3: 4}]), reason)
    geometry = {"type": "Polygon", "coordinates": [[{1: 2, 3: 4}]]}
    check_refused(lambda: gcv.Polygon(geometry), reason)


def test_bytes_are_no_pairs() -> None:
    places: Any = b"ab"
    check_translation(places, "b'ab' is not a pair of numbers, nor a sequence of pairs")
    check_translation([places], "b'ab' is not a pair of numbers", r"\[0\]")
    check_refused(lambda: gcv.entrance_block(SQUARE, SQUARE, places), "a0: b'ab' is not a .*")


def test_sets_of_ids() -> None:
    scene = gcv.Scene()
    scene.add(SQUARE, [(0, 0), (5, 0)])
    places = [(1, 0), (6, 0)]
    reason = "ids: {2, 3} is not a sequence: a set has no order"
    check_refused(lambda: scene.move({2, 3}, places), reason)
    check_refused(lambda: scene.set_layers({2, 3}, [1, 2]), reason)
    check_refused(lambda: scene.positions({2, 3}), reason)
    scene.set_layers({2, 3}, 1)
    assert scene.relation(SQUARE, (0, 0), ignore={2, 3}) == gcv.APART
    scene.remove({2, 3})


# ---------------------------------------------------------------- buffers --


@pytest.mark.parametrize(
    "source",
    [
        *(np.array(IN_A_ROW, dtype) for dtype in ("i8", "i4", "f4", "u1")),
        *(array(code, IN_A_ROW) for code in "ifq"),
        memoryview(array("q", IN_A_ROW)).cast("B").cast("q", [3, 2]),
    ],
)
def test_numbers_in_a_row(source: Any) -> None:
    assert gcv.Polygon(source) == gcv.Polygon(TRIANGLE)
    reason = r"polygon: a buffer of shape \(5,\) does not hold pairs of numbers"
    if not isinstance(source, memoryview):
        check_refused(lambda: gcv.Polygon(source[:5]), reason)


@pytest.mark.parametrize("dtype", ["M8[s]", "m8[s]"])
def test_times_are_refused(dtype: str) -> None:
    times = np.array([[0, 0], [1, 0], [0, 1]], dtype)
    reason = "array.* is not a pair of numbers"
    check_refused(lambda: gcv.Polygon(times), f"polygon: vertex 0: {reason}")
    check_refused(lambda: gcv.relation(SQUARE, SQUARE, times), rf"translation\[0\]: {reason}")
    check_refused(lambda: gcv.relation(SQUARE, SQUARE, times[0]), f"translation: {reason}")
    check_refused(lambda: gcv.Scene().add(times), r"polygons: vertex 0: .*")
    check_refused(lambda: gcv.Scene().remove(times[0]), "ids.*")


def test_views_of_other_numbers() -> None:
    view: Any = memoryview(bytes(8)).cast("?", [4, 2])
    check_refused(
        lambda: gcv.relation(SQUARE, SQUARE, memoryview(bytes(48)).cast("d", [2, 3])),
        (r"translation\[0\]: \[0.0, 0.0, 0.0\] is not a pair of numbers"),
    )
    assert gcv.relation(SQUARE, SQUARE, view).tolist() == [gcv.OVERLAPPING] * 4


# ------------------------------------------------------------------ other --


def test_nested_text() -> None:
    check_refused(lambda: gcv.Polygon('{"a":' * 100_000), "polygon: GeoJSON text: it is .*")
    depth = 2 * sys.getrecursionlimit()
    nested: Any = {"type": "Polygon", "coordinates": [TRIANGLE]}
    for _ in range(depth):
        nested = {"type": "Feature", "geometry": nested}
    assert gcv.Polygon(nested) == gcv.Polygon(TRIANGLE)


def test_regions_with_fits() -> None:
    frame = gcv.Polygon([(0, 0), (6, 0), (6, 6), (0, 6)], [[(1, 1), (3, 1), (3, 3), (1, 3)]])
    region = gcv.no_fit_region(frame, [(0, 0), (2, 0), (2, 2), (0, 2)])
    check_refused(
        lambda: gcv.Polygon(region),
        "polygon: a GeometryCollection of 1 Polygon, 1 Point is not one polygon; "
        "Polygon.many reads its polygons",
    )
    geometry = {"type": "GeometryCollection", "geometries": []}
    check_refused(lambda: gcv.Polygon(geometry), ".*Collection of nothing is not one polygon")


def test_vectors_that_are_not_finite() -> None:
    reason = "vector: number 0 is nan, not finite"
    check_refused(lambda: gcv.Polygon(SQUARE).translated((math.nan, 0)), reason)
    matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, math.inf]]
    check_refused(lambda: gcv.Polygon(SQUARE).affine(matrix), "matrix: number 5 is inf, not finite")


def test_open_files(tmp_path: Path) -> None:
    file = tmp_path / "square.wkt"
    file.write_text(gcv.Polygon(SQUARE).wkt)
    reason = "polygon: an open file is no polygon; pass what it says, or its pathlib.Path"
    with file.open() as opened:
        check_refused(lambda: gcv.Polygon(opened), reason)  # type: ignore[arg-type]
    assert gcv.Polygon(file) == gcv.Polygon(SQUARE)


@pytest.mark.parametrize("numpy", ["import numpy", "import sys; sys.modules['numpy'] = None"])
def test_public_names(numpy: str) -> None:
    code = f"""
{numpy}
import gcv
names = {{name for name in dir(gcv) if name[0] != "_"}}
assert names == set(gcv.__all__)
from gcv import *
assert names <= set(dir())
print(*(name for name in names if name.endswith("_DTYPE")))
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    found = set(run.stdout.split())
    assert found == (set(DTYPES) if numpy == "import numpy" else set())

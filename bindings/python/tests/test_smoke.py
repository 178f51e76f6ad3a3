# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Known results through the whole interface; needs the library and nothing else."""

from __future__ import annotations

import copy
import doctest
import math
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import unittest
from array import array
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from ctypes import addressof, c_double
from fractions import Fraction
from pathlib import Path
from typing import Any, Optional

import gcv

ROOT = Path(__file__).parents[1]

SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
SQUARE_2 = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
SQUARE_3 = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)]
BOW_TIE = [(0, 0), (2, 2), (2, 0), (0, 2)]
U_SHAPE = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]
U_NO_FIT = [(-1, -1), (6, -1), (6, 6), (3, 6), (3, 2), (2, 2), (2, 6), (-1, 6)]
NOTCHED = [(0, 0), (8, 0), (8, 6), (3, 1), (0, 7)]
TRIANGLE = [(0, 0), (1, 0), (0, 1)]


class StridedArray:
    """An array of vertices, each followed by room for more doubles."""

    def __init__(self, vertices: list[tuple[float, float]], doubles_per_vertex: int) -> None:
        self.memory = (c_double * (doubles_per_vertex * len(vertices)))()
        for k, (x, y) in enumerate(vertices):
            self.memory[doubles_per_vertex * k] = x
            self.memory[doubles_per_vertex * k + 1] = y
        self.__array_interface__: dict[str, Any] = {
            "version": 3,
            "typestr": "<f8" if sys.byteorder == "little" else ">f8",
            "shape": (len(vertices), 2),
            "strides": (8 * doubles_per_vertex, 8),
            "data": (addressof(self.memory), True),
        }


class PolygonTest(unittest.TestCase):
    def test_properties(self) -> None:
        polygon = gcv.Polygon([(2, 0), (2, 1), (0, 1), (0, 0), (1, 0), (2, 0)])
        self.assertEqual(polygon.vertices, [(0, 0), (2, 0), (2, 1), (0, 1)])
        self.assertEqual(polygon.area, 2)
        self.assertEqual(polygon.bounds, (0, 0, 2, 1))
        self.assertEqual(len(polygon), 4)
        self.assertEqual(repr(polygon), "<gcv.Polygon of 4 vertices>")

    def test_sources(self) -> None:
        flat = array("d", [x for vertex in SQUARE for x in vertex])
        pairs = memoryview(flat).cast("B").cast("d", [4, 2])
        for source in (
            [list(vertex) for vertex in SQUARE],
            iter(SQUARE),
            [(Fraction(x), int(y)) for x, y in SQUARE],
            flat,
            pairs,
            (c_double * 8)(*flat),
            StridedArray(SQUARE, 2),
            StridedArray(SQUARE, 5),
            "Polygon((0 0, 1 0, 1 1, 0 1, 0 0))",
            gcv.Polygon(SQUARE),
        ):
            with self.subTest(source):
                self.assertEqual(gcv.Polygon(source).vertices, SQUARE)  # type: ignore[arg-type]

    def test_in_place(self) -> None:
        source = StridedArray(SQUARE, 3)
        self.assertFalse(isinstance(source, Iterable))
        self.assertEqual(gcv.Polygon(source).area, 1)

    def test_not_pairs(self) -> None:
        for source in (5, [1, 2, 3], [(0, 0, 0)], ["ab", "cd", "ef"], b"POLYGON EMPTY", None):
            with self.subTest(source), self.assertRaises(TypeError):
                gcv.Polygon(source)  # type: ignore[arg-type]
        with self.assertRaises(ValueError):
            gcv.Polygon(array("d", [0, 0, 1]))
        with self.assertRaises(ValueError):
            gcv.Polygon(memoryview(bytes(96)).cast("d", [4, 3]))

    def test_copy(self) -> None:
        duplicate = copy.copy(gcv.Polygon(SQUARE))
        self.assertEqual(duplicate.vertices, SQUARE)
        for attempt in (pickle.dumps, copy.deepcopy):
            with self.subTest(attempt), self.assertRaises(TypeError):
                attempt(duplicate)


class ErrorTest(unittest.TestCase):
    def assert_refused(self, source: gcv.PolygonLike, status: int, name: str) -> None:
        with self.subTest(source), self.assertRaises(gcv.InputError) as raised:
            gcv.Polygon(source)
        error = raised.exception
        self.assertIsInstance(error, ValueError)
        self.assertEqual((error.status, error.status_name), (status, name))
        self.assertNotEqual(str(error), "")
        duplicate = pickle.loads(pickle.dumps(error))
        self.assertEqual((duplicate.status, str(duplicate)), (status, str(error)))

    def test_refused(self) -> None:
        self.assert_refused([(0, 0), (1, math.nan), (0, 1)], 3, "GCV_ERR_NOT_FINITE")
        self.assert_refused([(0, 0), (1, 0), (-math.inf, 1)], 3, "GCV_ERR_NOT_FINITE")
        self.assert_refused("POLYGON ((0 0, 1e999 0, 1 1))", 3, "GCV_ERR_NOT_FINITE")
        self.assert_refused([], 4, "GCV_ERR_DEGENERATE")
        self.assert_refused([(0, 0), (1, 1), (2, 2)], 4, "GCV_ERR_DEGENERATE")
        self.assert_refused(BOW_TIE, 5, "GCV_ERR_NOT_SIMPLE")
        self.assert_refused("POLYGON ((0 0, 1 0", 8, "GCV_ERR_PARSE")

    def test_reference(self) -> None:
        with self.assertRaises(gcv.InputError):
            gcv.no_fit_polygon(SQUARE, SQUARE, (math.nan, 0))
        with self.assertRaises(gcv.InputError):
            gcv.entrance_block(SQUARE, SQUARE, (0, math.inf))

    def test_range(self) -> None:
        huge = gcv.Polygon([(1e308 * x, 1e308 * y) for x, y in SQUARE])
        with self.assertRaises(gcv.Error) as raised:
            gcv.minkowski_sum(huge, huge)
        self.assertNotIsInstance(raised.exception, ValueError)
        self.assertEqual(raised.exception.status_name, "GCV_ERR_RANGE")


class SumTest(unittest.TestCase):
    def test_squares(self) -> None:
        face = gcv.minkowski_sum(gcv.Polygon(SQUARE), gcv.Polygon(SQUARE_2))
        self.assertEqual(face.vertices, SQUARE_3)
        self.assertEqual(face.exact, SQUARE_3)
        self.assertEqual(face.area, 9)
        self.assertEqual(face.error_bound, 0)
        self.assertEqual(len(face), 4)
        self.assertEqual(repr(face), "<gcv.OuterFace of 4 vertices>")
        self.assertEqual(face.wkt, "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))")
        self.assertEqual(gcv.Polygon(face.wkt).vertices, SQUARE_3)
        self.assertEqual(face.sources, [(gcv.EDGE_TRANSLATED_CORNER, k, k) for k in range(4)])

    def test_outlives_inputs(self) -> None:
        polygon = gcv.minkowski_sum(SQUARE, SQUARE_2).polygon
        self.assertEqual(gcv.minkowski_sum(polygon, polygon).area, 36)

    def test_fractions(self) -> None:
        face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
        crossing = (Fraction(10, 3), Fraction(7, 3))
        self.assertEqual(face.exact, [(0, 0), (9, 0), (9, 6), (8, 7), crossing, (1, 7), (0, 8)])
        self.assertEqual(face.vertices[4], (10 / 3, 7 / 3))
        self.assertGreater(face.error_bound, 0)
        self.assertLess(face.error_bound, 1e-15)
        self.assertEqual(
            face.sources,
            [(3, 0, 0), (1, 1, 1), (2, 2, 1), (1, 2, 2), (1, 3, 1), (2, 4, 1), (3, 4, 2)],
        )

    def test_no_fit(self) -> None:
        face = gcv.no_fit_polygon(U_SHAPE, SQUARE, (0, 0))
        self.assertEqual(face.vertices, U_NO_FIT)
        self.assertEqual(face.area, 45)
        moved = gcv.no_fit_polygon(U_SHAPE, SQUARE, (0.5, -2))
        self.assertEqual(moved.vertices, [(x + 0.5, y - 2) for x, y in U_NO_FIT])

    def test_entrance_block(self) -> None:
        face = gcv.entrance_block(SQUARE, U_SHAPE, (1, 0))
        self.assertEqual(face.vertices, [(x + 1, y) for x, y in U_NO_FIT])

    def test_superset(self) -> None:
        edges = gcv.superset(SQUARE, SQUARE_2)
        ring = zip(SQUARE_3, SQUARE_3[1:] + SQUARE_3[:1])
        for k, (start, end) in enumerate(ring):
            self.assertIn((start, end, (gcv.EDGE_TRANSLATED_CORNER, k, k)), edges)

    def test_threads(self) -> None:
        polygon = gcv.Polygon(NOTCHED)
        with ThreadPoolExecutor(4) as pool:
            faces = pool.map(lambda _: gcv.minkowski_sum(polygon, TRIANGLE).wkt, range(100))
            self.assertEqual(len(set(faces)), 1)


class LibraryTest(unittest.TestCase):
    def test_version(self) -> None:
        self.assertEqual(gcv.library_version(), gcv.__version__)

    def run_import(
        self, library: Optional[str], directory: str
    ) -> subprocess.CompletedProcess[str]:
        environment = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONDONTWRITEBYTECODE": "1"}
        environment.pop("GCV_LIBRARY", None)
        if library is not None:
            environment["GCV_LIBRARY"] = library
        program = "import gcv; print(open('/proc/self/maps').read())"
        return subprocess.run(
            [sys.executable, "-c", program],
            env=environment,
            cwd=directory,
            capture_output=True,
            text=True,
        )

    def test_chosen_library_or_none(self) -> None:
        for library in ("/nowhere/libgcv.so.0", "libgcv.so.0", sys.executable):
            with self.subTest(library):
                run = self.run_import(library, "/")
                self.assertNotEqual(run.returncode, 0)
                self.assertIn("GCV_LIBRARY", run.stderr)
                self.assertIn(library, run.stderr)

    @unittest.skipUnless("GCV_LIBRARY" in os.environ, "needs a library to copy")
    def test_working_directory_is_not_searched(self) -> None:
        with tempfile.TemporaryDirectory() as directory:
            planted = Path(directory, "libgcv.so.0")
            shutil.copy(os.environ["GCV_LIBRARY"], planted)
            run = self.run_import(None, directory)
            self.assertNotIn(str(planted), run.stdout)
            if run.returncode != 0:
                for place in ("beside the package", "dynamic loader", "find_library"):
                    self.assertIn(place, run.stderr)
            self.assertEqual(self.run_import(str(planted), "/").returncode, 0)

    def test_readme(self) -> None:
        result = doctest.testfile(str(ROOT / "README.md"), module_relative=False)
        self.assertGreater(result.attempted, 0)
        self.assertEqual(result.failed, 0)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: LGPL-3.0-or-later
"""Tests of the examples with scenes in Python."""

import json
import subprocess
import sys
import unittest

from test_cases import HERE, Bindings


class Nesting(Bindings):
    """Parts in a strip, and pieces of a puzzle."""

    def nest(self, *arguments):
        """The lines that are printed, and the rings of the picture."""
        picture = self.folder / "nesting.svg"
        done = self.succeed(sys.executable, HERE / "nesting.py", "--svg", picture, *arguments)
        *lines, last = done.stdout.splitlines()
        for number, line in enumerate(lines):
            place = r"at \(\S+, \S+\)(, turned by (90|180|270))?"
            self.assertRegex(line, rf"^part {number} {place}: \d+\.\d\d ms$")
        return lines, last.removesuffix(f": {picture}"), self.rings(picture)

    def test_nesting(self):
        lines, last, rings = self.nest()
        self.assertEqual(last, "12 parts, length 64.605, 48.7 % used")
        self.assertEqual((len(lines), len(rings)), (12, 12))
        self.assertTrue(lines[1].startswith("part 1 at (0, 11): "))
        corners = [point for ring in rings for point in ring]
        self.assertAlmostEqual(max(corners)[0], 7387246 / 114345, places=9)
        self.assertTrue(all(0 <= x and 0 <= y <= 24 for x, y in corners))

    def test_turned(self):
        lines, last, rings = self.nest("--rotate", "--width", "20")
        self.assertEqual(len(rings), 12)
        self.assertTrue(any("turned by" in line for line in lines))
        self.assertTrue(all(0 <= x and 0 <= y <= 20 for ring in rings for x, y in ring))

    def test_instance(self):
        """Two rectangles in a row and a small square above them; turned, they stand."""
        def piece(quantity, width, height):
            ring = {"xy": [[0, 0], [width, 0], [width, height], [0, height]]}
            return {"quantity": quantity, "angles": [0, 90], "rings": [ring]}

        instance = {"boards": [piece(1, 99, 4)], "pieces": [piece(1, 1, 1), piece(2, 4, 3)]}
        file = self.write("instance.json", json.dumps(instance))
        lines, last, rings = self.nest(file)
        self.assertEqual(last, "3 parts, length 8.000, 78.1 % used")
        self.assertEqual(rings, [[(0, 0), (4, 0), (4, 3), (0, 3)], [(4, 0), (8, 0), (8, 3), (4, 3)],
                                 [(0, 3), (1, 3), (1, 4), (0, 4)]])
        lines, last, rings = self.nest(file, "--rotate")
        self.assertEqual(last, "3 parts, length 7.000, 89.3 % used")
        self.assertIn(", turned by 90: ", lines[0])

    def test_too_narrow(self):
        done = subprocess.run([sys.executable, HERE / "nesting.py", "--width", "5"], text=True,
                              capture_output=True, check=False, cwd=self.folder, timeout=300)
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (1, "", "nesting: the strip is too narrow for a part\n"))

    def test_puzzle(self):
        done = self.succeed(sys.executable, HERE / "puzzle.py", "--pieces", "25", "--seed", "3")
        pieces, places, pairs = done.stdout.splitlines()
        self.assertRegex(pieces, r"^25 pieces of \d+ vertices, \d+\.\d ms for each$")
        self.assertEqual(places, "25 have one place when they are out: their own")
        self.assertRegex(pairs, r"^with a neighbour out, the own place is a point for \d+\b")


if __name__ == "__main__":
    unittest.main()

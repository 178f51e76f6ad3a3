# SPDX-License-Identifier: LGPL-3.0-or-later
"""What tests of the examples begin with."""

import subprocess
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

HERE = Path(__file__).parent
SVG = "{http://www.w3.org/2000/svg}"


class TestInFolder(unittest.TestCase):
    """A test with a folder for its files, and a square and a triangle in it."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.square = self.write("square.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))")
        self.triangle = self.write("triangle.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0))")

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path


class Bindings(TestInFolder):
    """The examples in Python and Rust."""

    def succeed(self, *command):
        done = subprocess.run([*map(str, command)], text=True, capture_output=True, check=False,
                              timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def rings(self, path, style=None):
        """The paths in a picture, those of a class if one is given."""
        return [[tuple(map(float, pair.split())) for pair in drawn.get("d").strip("MZ").split("L")]
                for drawn in ElementTree.parse(path).iter(f"{SVG}path")
                if drawn.get("class") == style]

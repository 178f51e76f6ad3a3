# SPDX-License-Identifier: LGPL-3.0-or-later
"""Tests of the gallery, on small polygons."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import gallery
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import gcv

PAIRS = """\
# the first block
square cgal/square.wkt cgal/square.wkt
~notched cgal/notched.wkt cgal/speck.wkt
# the second block
unread none.wkt none.wkt
"""
POLYGONS = {
    "square": "POLYGON ((0 0, 1 0, 2 0, 2 2, 0 2, 0 0))",
    "notched": "POLYGON ((0 0, 0 7, 3 1, 8 6, 8 0, 0 0))",
    "speck": "POLYGON ((0 0, 0.5 0, 0 0.5, 0 0))",
}


@pytest.fixture
def pairs(tmp_path: Path) -> list[gallery.Pair]:
    (tmp_path / "cgal").mkdir()
    (tmp_path / "pairs.txt").write_text(PAIRS)
    for name, text in POLYGONS.items():
        (tmp_path / "cgal" / f"{name}.wkt").write_text(text)
    return gallery.read_pairs(tmp_path)


def texts(figure: Figure) -> set[str]:
    return {text.get_text() for text in figure.findobj(Text) if isinstance(text, Text)}


def test_gallery(pairs: list[gallery.Pair]) -> None:
    figure = gallery.gallery(pairs)
    assert texts(figure) >= {
        *("square", "A: square, 5 vertices", "B: square, 5 vertices", "A + B: 4 vertices"),
        *("notched, with substitutes", "A: notched, 5 vertices", "B: speck, 3 vertices"),
        "5 times larger",
    }
    assert sorted(len(ax.patches) for ax in figure.axes) == [3, 4]


def test_superset(pairs: list[gallery.Pair]) -> None:
    figure = gallery.superset(pairs[0])
    kinds = [edge.source.kind for edge in gcv.superset(pairs[0].a.polygon, pairs[0].b.polygon)]
    for kind, (_, name) in gallery.KINDS.items():
        assert f"{kinds.count(kind)} {name}" in texts(figure)
    assert f"{len(kinds)} edges of the superset" in texts(figure)


def test_pictures_are_the_same_to_the_byte(pairs: list[gallery.Pair], tmp_path: Path) -> None:
    for name in "first", "second":
        gallery.save(gallery.superset(pairs[1]), name, tmp_path)
    for kind in "svg", "png":
        first, second = ((tmp_path / f"{name}.{kind}").read_bytes() for name in ("first", "second"))
        assert first == second
    assert ElementTree.parse(tmp_path / "first.svg").getroot().tag.endswith("svg")


def test_no_data(tmp_path: Path) -> None:
    run = subprocess.run(
        [sys.executable, gallery.__file__],
        env={**os.environ, "GCV_DATA_DIR": str(tmp_path / "none")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (run.returncode, run.stdout, run.stderr.count("\n")) == (1, "", 1)
    assert "GCV_DATA_DIR" in run.stderr

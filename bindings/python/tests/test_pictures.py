# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Pictures."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest
from matplotlib import pyplot
from matplotlib.patches import Polygon as Patch
from shapes import NOTCHED, SQUARE, TRIANGLE, Points, scaled

import gcv
from gcv._drawing import svg

pyplot.switch_backend("Agg")


def corners(picture: str) -> list[list[tuple[float, float]]]:
    """The corners of the rings in a picture, all of which must lie in its view box."""
    root = ElementTree.fromstring(picture)
    _, _, width, height = map(float, root.attrib["viewBox"].split())
    rings = []
    for path in root:
        assert path.attrib["fill-rule"] == "evenodd"
        for ring in path.attrib["d"].strip("MZ").split("ZM"):
            words = ring.split("L")
            rings.append([(float(w.split()[0]), float(w.split()[1])) for w in words])
    assert all(10 <= x <= width - 10 and 10 <= y <= height - 10 for r in rings for x, y in r)
    return rings


def test_svg() -> None:
    assert corners(gcv.Polygon(SQUARE)._repr_svg_()) == [
        [(10, 410), (410, 410), (410, 10), (10, 10)],
    ]
    triangle: Points = [(0, 0), (4, 0), (0, 2)]
    ring, square = corners(svg([[triangle], [SQUARE]]))
    assert ring == [(10, 210), (410, 210), (10, 10)]
    assert square == [(10, 210), (110, 210), (110, 110), (10, 110)]


@pytest.mark.parametrize("factor", [5e-324, 1e-300, -1.0, 1e300, 1.7976931348623157e308])
def test_svg_of_any_size(factor: float) -> None:
    assert len(corners(scaled([(x * 2 - 1, y) for x, y in SQUARE], factor)._repr_svg_())[0]) == 4


def test_svg_of_outer_face() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    assert len(corners(face._repr_svg_())[0]) == len(face)


def test_plot() -> None:
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    ax = face.plot(facecolor="red")
    assert ax is pyplot.gca()
    (patch,) = ax.patches
    assert isinstance(patch, Patch)
    assert patch.get_facecolor()[:3] == (1, 0, 0)
    assert patch.get_xy()[: len(face)].tolist() == face.vertices.tolist()
    _, (left, right) = pyplot.subplots(1, 2)
    assert gcv.Polygon(SQUARE).plot(left) is left
    assert len(left.patches) == 1
    assert not right.patches
    pyplot.close("all")

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Pictures, and the program that draws them."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
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


def program(directory: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    (directory / "a.wkt").write_text("POLYGON ((0 0, 8 0, 8 6, 3 1, 0 7))\n")
    (directory / "b.wkt").write_text("POLYGON ((0 0, 1 0, 0 1))\n")
    (directory / "bow tie.wkt").write_text("POLYGON ((0 0, 2 2, 2 0, 0 2))\n")
    return subprocess.run(
        [sys.executable, "-m", "gcv", *arguments],
        cwd=directory,
        capture_output=True,
        text=True,
        check=False,
    )


def test_program(tmp_path: Path) -> None:
    run = program(tmp_path, "a.wkt", "b.wkt", "--svg", "out.svg")
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    assert (run.stdout, run.stderr, run.returncode) == (face.wkt + "\n", "", 0)
    assert [len(r) for r in corners((tmp_path / "out.svg").read_text())] == [len(face), 5, 3]


def test_program_with_holes_and_geojson(tmp_path: Path) -> None:
    plate = gcv.Polygon(NOTCHED, [[(1, 1), (2, 1), (1, 2)]])
    (tmp_path / "plate.json").write_text(json.dumps(plate.__geo_interface__))
    run = program(tmp_path, "plate.json", "b.wkt", "--svg", "out.svg")
    face = gcv.minkowski_sum(NOTCHED, TRIANGLE)
    assert (run.stdout, run.stderr, run.returncode) == (face.wkt + "\n", "", 0)
    assert [len(r) for r in corners((tmp_path / "out.svg").read_text())] == [len(face), 5, 3, 3]
    (tmp_path / "latin.wkt").write_bytes(b"\xff")
    assert "byte 0: expected POLYGON" in program(tmp_path, "latin.wkt", "b.wkt").stderr


def test_program_options(tmp_path: Path) -> None:
    run = program(tmp_path, "a.wkt", "b.wkt", *("--no-fit", "0.5", "-2", "--rounding", "outward"))
    face = gcv.no_fit_polygon(NOTCHED, TRIANGLE, (0.5, -2), rounding="outward")
    assert (run.stdout, run.returncode) == (face.wkt + "\n", 0)
    assert program(tmp_path, "a.wkt", "b.wkt", "--threads", "2").returncode == 0
    near = gcv.minkowski_sum(NOTCHED, TRIANGLE, tolerance=20)
    assert program(tmp_path, "a.wkt", "b.wkt", "--tolerance", "20").stdout == near.wkt + "\n"


def test_program_regions(tmp_path: Path) -> None:
    (tmp_path / "slot.wkt").write_text("POLYGON ((0 0, 6 0, 6 6, 4 6, 4 2, 2 2, 2 6, 0 6))")
    (tmp_path / "peg.wkt").write_text("POLYGON ((0 0, 2 0, 2 2, 0 2))")
    options = "slot.wkt", "peg.wkt", "--svg", "out.svg"
    run = program(tmp_path, *options, "--region", "--no-fit", "0", "1")
    rings = "MULTIPOLYGON (((-2 -1, 6 -1, 6 7, -2 7, -2 -1)))"
    fits = "GEOMETRYCOLLECTION (LINESTRING (2 3, 2 7))"
    assert (run.stdout, run.stderr, run.returncode) == (f"{rings}\n{fits}\n", "", 0)
    assert (tmp_path / "out.svg").read_text().count("<path") == 4
    run = program(tmp_path, *options, "--inner-fit", "0", "0")
    fits = (
        "GEOMETRYCOLLECTION (LINESTRING (0 0, 0 4), LINESTRING (0 0, 4 0), LINESTRING (4 0, 4 4))"
    )
    assert (run.stdout, run.returncode) == (f"MULTIPOLYGON EMPTY\n{fits}\n", 0)
    run = program(tmp_path, *options, "--region")
    assert run.stdout == "MULTIPOLYGON (((0 0, 8 0, 8 8, 0 8, 0 0)))\n" + (
        "GEOMETRYCOLLECTION (LINESTRING (4 4, 4 8))\n"
    )


@pytest.mark.parametrize(
    ("arguments", "status", "reason"),
    [
        (["a.wkt", "b.wkt", *("--no-fit", "0", "0", "--inner-fit", "0", "0")], 2, "not allowed"),
        (["a.wkt"], 2, "usage"),
        (["a.wkt", "b.wkt", "--rounding", "up"], 2, "up"),
        (["a.wkt", "b.wkt", "--tolerance", "-1"], 1, "tolerance"),
        (["a.wkt", "bow tie.wkt"], 1, "gcv: bow tie.wkt: polygon: edges 0 and 2"),
        (["a.wkt", "none.wkt"], 1, "none.wkt"),
        (["a.wkt", "b.wkt", "--svg", "no/where.svg"], 1, "where.svg"),
    ],
)
def test_program_failures(tmp_path: Path, arguments: list[str], status: int, reason: str) -> None:
    run = program(tmp_path, *arguments)
    assert (run.stdout, run.returncode) == ("", status)
    assert reason in run.stderr
    assert "Traceback" not in run.stderr

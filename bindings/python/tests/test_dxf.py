# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons of DXF drawings, as the program reads them."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy
import pytest
from circles import check_circle
from program import run_program, run_shell
from test_files import NOT_HERE, error, read

import gcv


@pytest.fixture
def drawing() -> Any:
    ezdxf = pytest.importorskip("ezdxf", reason=f"ezdxf {NOT_HERE.format('DXF')}")
    return ezdxf.new("R2010")


def dxf(drawing: Any) -> str:
    stream = io.StringIO()
    drawing.write(stream)
    return stream.getvalue()


class TestDxf:
    def test_polylines(self, tmp_path: Path, drawing: Any) -> None:
        space = drawing.modelspace()
        space.add_lwpolyline([(0.1, 0), (4, 0), (0, 3)], close=True)
        space.add_lwpolyline([(10, 0), (14, 0), (10, 3), (10, 0)])
        space.add_polyline2d([(20, 0), (24, 0), (20, 3)], close=True)
        space.add_polyline3d([(30, 0, 1), (34, 0, 1), (30, 3, 2)], close=True)
        assert [polygon.wkt for polygon in read(tmp_path, dxf(drawing))] == [
            "POLYGON ((0 3, 0.1 0, 4 0, 0 3))",
            "POLYGON ((10 0, 14 0, 10 3, 10 0))",
            "POLYGON ((20 0, 24 0, 20 3, 20 0))",
            "POLYGON ((30 0, 34 0, 30 3, 30 0))",
        ]

    def test_holes_by_layer(self, tmp_path: Path, drawing: Any) -> None:
        space = drawing.modelspace()
        for k, layer in ((0, "0"), (1, "0"), (2, "0"), (3, "other")):
            square = [(k, k), (20 - k, k), (20 - k, 20 - k), (k, 20 - k)]
            space.add_lwpolyline(square, close=True, dxfattribs={"layer": layer})
        assert [polygon.ring_count for polygon in read(tmp_path, dxf(drawing))] == [2, 1, 1]

    def test_blocks(self, tmp_path: Path, drawing: Any) -> None:
        block = drawing.blocks.new("part")
        block.add_lwpolyline([(0, 0), (1, 0), (0, 1)], close=True)
        scale = {"xscale": 2, "yscale": -2}
        drawing.modelspace().add_blockref("part", (10.5, 20), dxfattribs=scale)
        (polygon,) = read(tmp_path, dxf(drawing))
        assert polygon == gcv.Polygon([(10.5, 20), (12.5, 20), (10.5, 18)])

    def test_nested_blocks(self, tmp_path: Path, drawing: Any) -> None:
        drawing.blocks.new("part").add_lwpolyline([(0, 0), (1, 0), (0, 1)], close=True)
        turned = {"rotation": 90, "column_count": 2, "column_spacing": 3}
        drawing.blocks.new("pair").add_blockref("part", (1, 0), dxfattribs=turned)
        drawing.modelspace().add_blockref("pair", (10, 0), dxfattribs={"xscale": 2})
        found = read(tmp_path, dxf(drawing))
        rings = [(12, 0), (12, 1), (10, 0)], [(12, 3), (12, 4), (10, 3)]
        rounded = [gcv.Polygon(polygon.vertices.round(9)) for polygon in found]
        assert rounded == list(map(gcv.Polygon, rings))

    def test_blocks_in_themselves(self, tmp_path: Path, drawing: Any) -> None:
        block = drawing.blocks.new("part")
        block.add_lwpolyline([(0, 0), (1, 0), (0, 1)], close=True)
        block.add_blockref("part", (1, 1))
        drawing.modelspace().add_blockref("part", (0, 0))
        reason = "DXF: a block is in itself, or nested too deeply"
        assert error(tmp_path, dxf(drawing)) == reason

    @pytest.mark.parametrize("distance", [1e-4, 0.1])
    @pytest.mark.parametrize("scale", [{"xscale": 3.0}, {"yscale": -0.5, "rotation": 30.0}])
    @pytest.mark.parametrize("is_circle", [False, True])
    def test_curves_in_blocks(
        self,
        tmp_path: Path,
        drawing: Any,
        is_circle: bool,
        scale: dict[str, float],
        distance: float,
    ) -> None:
        block = drawing.blocks.new("part")
        if is_circle:
            block.add_circle((0, 0), 10)
        else:
            block.add_lwpolyline([(-10, 0, 1), (10, 0, 1)], "xyb", close=True)
        block.add_lwpolyline([(-10, 20), (10, 20), (0, 30)], close=True)
        drawing.modelspace().add_blockref("part", (5, 6), dxfattribs=scale)
        polygon, _ = read(tmp_path, dxf(drawing), "--flatten", str(distance))
        angle = numpy.radians(scale.get("rotation", 0))
        x, y = (polygon.vertices - (5, 6)).T
        x, y = (
            x * numpy.cos(angle) + y * numpy.sin(angle),
            y * numpy.cos(angle) - x * numpy.sin(angle),
        )
        inverse = 1 / numpy.array([scale.get("xscale", 1), scale.get("yscale", 1)])
        vertices = numpy.column_stack([x, y]) * inverse
        check_circle(vertices, distance * abs(inverse).max())
        assert len(polygon) < 8 + 60 / distance**0.5

    def test_binary(self, tmp_path: Path, drawing: Any) -> None:
        drawing.modelspace().add_lwpolyline([(0, 0), (4, 0), (0, 3)], close=True)
        drawing.saveas(tmp_path / "binary.dxf", fmt="bin")
        run = run_program(tmp_path, "simplify", "binary.dxf", "--tolerance", "0")
        reason = "DXF: this is binary; only DXF that is text is read"
        assert (run.stderr, run.returncode) == (f"gcv: binary.dxf: {reason}\n", 1)

    @pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
    def test_damaged(self, tmp_path: Path, drawing: Any, share: float) -> None:
        for k in range(100):
            ring = [(k, 0), (k + 0.5, 0), (k, 3)]
            drawing.modelspace().add_lwpolyline(ring, close=True)
        text = dxf(drawing)
        reason = "DXF: this ends before the end of the drawing, EOF"
        assert error(tmp_path, text[: int(share * len(text))]) == reason
        assert len(read(tmp_path, text + "\r\n\x1a")) == 100

    def test_damaged_entity(self, tmp_path: Path, drawing: Any) -> None:
        polyline = drawing.modelspace().add_polyline2d([(50, 0), (54, 0), (54, 3)], close=True)
        name = f"POLYLINE {polyline.dxf.handle} of layer '0': DXF: "
        text = dxf(drawing).replace(" 10\n54.0\n 20\n3.0\n", "")
        assert error(tmp_path, text).startswith(name)

    def test_warnings_of_ezdxf_are_not_shown(self, tmp_path: Path, drawing: Any) -> None:
        drawing.modelspace().add_lwpolyline([(7.25, 0), (4, 0), (0, 3)], close=True)
        text = dxf(drawing).replace("7.25", "9abc")
        (tmp_path / "a.dxf").write_text(text)
        run = run_shell(tmp_path, "gcv simplify a.dxf --tolerance 0")
        assert run.stdout.count("\n") == 1

    def test_curves(self, tmp_path: Path, drawing: Any) -> None:
        space = drawing.modelspace()
        circle = space.add_circle((0, 0), 10)
        reason = f"CIRCLE {circle.dxf.handle} of layer '0': this is a curve; --flatten"
        assert error(tmp_path, dxf(drawing)).startswith(reason)

    @pytest.mark.parametrize("distance", [1e-4, 0.1, 3, 100])
    @pytest.mark.parametrize(
        "add",
        [
            lambda space: space.add_circle((0, 0), 10),
            lambda space: space.add_ellipse((0, 0), (10, 0), 1.0),
            lambda space: space.add_lwpolyline([(-10, 0, 1), (10, 0, 1)], "xyb", close=True),
            lambda space: space.add_polyline2d([(-10, 0, -1), (10, 0, -1)], "xyb", close=True),
        ],
    )
    def test_flattened_circle(
        self, tmp_path: Path, drawing: Any, add: Callable[[Any], object], distance: float
    ) -> None:
        add(drawing.modelspace())
        (polygon,) = read(tmp_path, dxf(drawing), "--flatten", str(distance))
        check_circle(polygon.vertices, distance)

    def test_too_fine(self, tmp_path: Path, drawing: Any) -> None:
        drawing.modelspace().add_circle((0, 0), 10)
        assert "are too many" in error(tmp_path, dxf(drawing), "--flatten", "1e-300")

    def test_what_is_left_out(self, tmp_path: Path, drawing: Any) -> None:
        space = drawing.modelspace()
        space.add_lwpolyline([(0, 0), (4, 0), (0, 3)], close=True)
        space.add_lwpolyline([(0, 0), (4, 0), (0, 3)])
        space.add_line((0, 0), (1, 1))
        space.add_line((0, 0), (2, 1))
        space.add_arc((0, 0), 1, 0, 90)
        text = dxf(drawing)
        run = run_program(
            tmp_path, *("simplify", "-", "--tolerance", "0", "--flatten", "1"), text=text
        )
        assert run.stderr == "gcv: standard input: left out: 1 LWPOLYLINE, 2 LINE, 1 ARC\n"
        assert run.returncode == 0

    @pytest.mark.parametrize("text", ["  0\nSECTION\n garbage\n", "999\n"])
    def test_errors(self, tmp_path: Path, drawing: Any, text: str) -> None:
        assert error(tmp_path, text).startswith(("DXF: ", "there is no polygon"))

    def test_rings_that_cross(self, tmp_path: Path, drawing: Any) -> None:
        space = drawing.modelspace()
        space.add_lwpolyline([(0, 0), (4, 0), (4, 4), (0, 4)], close=True)
        space.add_lwpolyline([(2, 2), (5, 2), (5, 5), (2, 5)], close=True)
        text = error(tmp_path, dxf(drawing))
        assert text.count("LWPOLYLINE ") == 2
        assert " of layer '0': rings 0 and 1 " in text

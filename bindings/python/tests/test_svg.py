# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons of SVG drawings, as the program reads them."""

from __future__ import annotations

from pathlib import Path

import numpy
import pytest
from circles import check_circle
from program import run_program
from test_files import NOT_HERE, error, read

import gcv

BAR = '<rect width="3" height="2"'


def svg(body: str) -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="9cm" viewBox="0 0 5 5">{body}</svg>'


class TestSvg:
    @pytest.fixture(autouse=True)
    def _needs_svgelements(self) -> None:
        pytest.importorskip("svgelements", reason=f"svgelements {NOT_HERE.format('SVG')}")

    @pytest.mark.parametrize(
        ("body", "expected"),
        [
            ('<rect x="1" y="-3" width="2" height="1"/>', [[(1, 2), (3, 2), (3, 3), (1, 3)]]),
            ('<polygon points="0,0 4,0 0,-3"/>', [[(0, 0), (4, 0), (0, 3)]]),
            ('<polyline points="0,0 4,0 0,-3"/>', [[(0, 0), (4, 0), (0, 3)]]),
            ('<path d="M0.1 0h4L0-3"/>', [[(0.1, 0), (4.1, 0), (0, 3)]]),
            (
                '<path d="m1-1h1v-1zm5 0h1v-1z"/>',
                [[(1, 1), (2, 1), (2, 2)], [(6, 1), (7, 1), (7, 2)]],
            ),
            (
                '<g transform="translate(10 -5)"><g transform="scale(2)">'
                '<rect width="1" height="1"/></g></g>',
                [[(10, 3), (12, 3), (12, 5), (10, 5)]],
            ),
            (
                '<polygon transform="rotate(90)" points="1,0 2,0 2,1"/>',
                [[(0, -1), (0, -2), (-1, -2)]],
            ),
            (f'{BAR} transform="rotate(90)"/>', [[(0, 0), (0, -3), (-2, -3), (-2, 0)]]),
            (f'{BAR} transform="skewX(45)"/>', [[(0, 0), (3, 0), (5, -2), (2, -2)]]),
            (f'{BAR} transform="scale(-1,1)"/>', [[(0, 0), (-3, 0), (-3, -2), (0, -2)]]),
            (
                f'{BAR} transform="matrix(0 1 -1 0 0 0)"/>',
                [[(0, 0), (0, -3), (-2, -3), (-2, 0)]],
            ),
            (
                f'<g transform="rotate(90)">{BAR} transform="translate(1)"/></g>',
                [[(0, -1), (0, -4), (-2, -4), (-2, -1)]],
            ),
            ('<rect width="50%" height="20%"/>', [[(0, -1), (2.5, -1), (2.5, 0), (0, 0)]]),
            (
                '<rect x="40%" width="1in" height="72pt" transform="rotate(90deg)"/>',
                [[(0, -2), (0, -98), (-96, -98), (-96, -2)]],
            ),
            (
                f'<svg x="1" y="20%" width="10" viewBox="1 1 2 1">{BAR}/></svg>',
                [[(-4, 4), (11, 4), (11, -6), (-4, -6)]],
            ),
            (f'<svg x="1">{BAR}/></svg>', [[(1, -2), (4, -2), (4, 0), (1, 0)]]),
            (
                '<symbol id="s"><rect width="1" height="1"/></symbol><use href="#s" x="3"/>',
                [[(3, -1), (4, -1), (4, 0), (3, 0)]],
            ),
            (
                '<g display="none"><rect width="1" height="1"/></g><rect width="2" height="1"/>',
                [[(0, -1), (2, -1), (2, 0), (0, 0)]],
            ),
        ],
    )
    def test_shapes(
        self, tmp_path: Path, body: str, expected: list[list[tuple[float, float]]]
    ) -> None:
        found = read(tmp_path, svg(body))
        assert len(found) == len(expected)
        for polygon, ring in zip(found, expected):
            assert gcv.Polygon(polygon.vertices.round(9)) == gcv.Polygon(ring)

    @pytest.mark.parametrize(
        ("rule", "inner", "holes"),
        [
            ("evenodd", "M3 3h3v3h-3z", 1),
            ("evenodd", "M3 3v3h3v-3z", 1),
            ("nonzero", "M3 3h3v3h-3z", 0),
            ("nonzero", "M3 3v3h3v-3z", 1),
        ],
    )
    def test_fill_rule(self, tmp_path: Path, rule: str, inner: str, holes: int) -> None:
        path = f'<path fill-rule="{rule}" d="M0 0h9v9h-9z{inner}"/>'
        (polygon,) = read(tmp_path, svg(path))
        assert polygon.ring_count - 1 == holes

    @pytest.mark.parametrize(
        "path",
        [
            "M0 0H9e-165V9e-165H0zM1e-165 1e-165h1e-165l-1e-165 1e-165z",
            "M0 0H9e160V9e160H0zM1e160 1e160h1e160l-1e160 1e160z",
            "M-1e-30 .5L0 0L.5 -1e-30L1 0L.25000000000000006 .75L0 1ZM0 0L0 1L1 0Z",
            "M0 0L0 1L1 0ZM-1e-30 .5L0 0L.5 -1e-30L1 0L.25000000000000006 .75L0 1Z",
        ],
        ids=["no-area", "endless-area", "equal-areas", "hole-first"],
    )
    def test_holes_whose_areas_no_floats_compare(self, tmp_path: Path, path: str) -> None:
        (polygon,) = read(tmp_path, svg(f'<path fill-rule="evenodd" d="{path}"/>'))
        assert polygon.ring_count == 2

    def test_islands(self, tmp_path: Path) -> None:
        rings = "".join(f"M{k} {k}H{20 - k}V{20 - k}H{k}z" for k in range(5))
        found = read(tmp_path, svg(f'<path fill-rule="evenodd" d="{rings}"/>'))
        assert [polygon.ring_count for polygon in found] == [2, 2, 1]
        assert [polygon.area for polygon in found] == [400 - 324, 256 - 196, 144]

    @pytest.mark.parametrize(
        ("body", "reason"),
        [
            ("", "there is no polygon in this file"),
            ('<circle id="rim" r="2"/>', "circle 'rim': this is a curve; --flatten"),
            ('<rect width="4" height="4" rx="1"/>', "rect: this is a curve"),
            ('<path d="M0 0Q1 1 2 0z"/>', "path: this is a curve"),
            ('<path id="p" d="M0 0L1 x 2 z"/>', "path 'p': 'L1' is no command of path data"),
            ('<path d="M0 0L1 0 2z"/>', "path: 'L1 0 2' is no command"),
            ('<path d="M0 0L1 0L1 NaN z"/>', "path: 'NaN' in path data is no number"),
            ('<path d="M0 0L1 0Linf 1 z"/>', "path: 'inf' in path data is no number"),
            ('<path d="5M0 0L1 0 2 2z"/>', "path: '5' is no command"),
            ('<polygon id="q" points="0,0 1,0 1"/>', "polygon 'q': the points are not pairs"),
            ('<polygon points="0 0 2 2 2 0 0 2"/>', "polygon: edges "),
            ('<path d="M0 0H2V2z M0 0 L5 5 5 0 0 5z"/>', "path, ring 1: edges "),
            (
                '<path d="M0 0H4V4H0z M2 2H6V6H2z"/>',
                "path, ring 1 and standard input: path, ring 0: rings 0 and 1 ",
            ),
            ("<g>", "SVG: mismatched tag"),
            ('<rect id="r" width="-1" height="2"/>', "rect 'r': width is -1, and below 0"),
            ('<rect width="abc" height="2"/>', "rect: width is 'abc', and no length"),
            ('<rect width="2" height="2em"/>', "rect: height is '2em', and no length"),
            ('<circle cx="1_0" r="1"/>', "circle: cx is '1_0', and no length"),
            (f'{BAR} transform="bogus(1)"/>', "rect: 'bogus(1)' is no transform"),
            (f'{BAR} transform="scale(2) x"/>', "rect: 'x' is no transform"),
            (f'{BAR} transform="translate(NaN 0)"/>', "rect: 'translate(NaN 0)' is no transform"),
            (f'{BAR} transform="rotate(1 2)"/>', "rect: 'rotate(1 2)' is no transform"),
            ('<svg viewBox="0 0 1"/>', "SVG: the viewBox '0 0 1' is not four numbers"),
            (f'<svg>{BAR} x="1%"/></svg>', "rect: x is 1%, of a drawing without a viewBox"),
            (f'<svg><svg viewBox="0 0 1 1">{BAR}/></svg></svg>', "svg: width is missing, in a"),
            ('<use id="u" href="#u"/>', "SVG: this is nested too deeply, or uses itself"),
            ("<g>" * 5000 + "</g>" * 5000, "SVG: this is nested too deeply, or uses itself"),
        ],
    )
    def test_errors(self, tmp_path: Path, body: str, reason: str) -> None:
        assert error(tmp_path, svg(body)).startswith(reason)

    def test_other_drawings(self, tmp_path: Path) -> None:
        reason = "SVG: this is a drawing of 'html', not of 'svg'"
        assert error(tmp_path, "<html></html>") == reason

    def test_what_draws_nothing(self, tmp_path: Path) -> None:
        nothing = '<rect width="3"/><rect width="0" height="1"/><circle/><ellipse rx="auto"/>'
        hidden = '<defs><circle/></defs><g display="none"><circle/></g>'
        body = f'{nothing}{hidden}<use href="#no"/><use/>{BAR} id="r"/><use href="#r" x="4"/>'
        run = run_program(tmp_path, "simplify", "-", "--tolerance", "0", text=svg(body))
        left_out = "left out: 2 rect, 1 circle, 1 ellipse, 2 use"
        assert run.stderr == f"gcv: standard input: {left_out}\n"
        assert run.stdout.count("\n") == 2

    @pytest.mark.parametrize("distance", [1e-4, 0.1])
    @pytest.mark.parametrize(
        ("body", "shape"),
        [
            ('<circle r="10" transform="{}"/>', [1, 0, 0, 1]),
            ('<path d="M-10 0A10 10 0 0 0 10 0A10 10 0 0 0-10 0z" transform="{}"/>', [1, 0, 0, 1]),
            ('<ellipse rx="10" ry="5" transform="{}"/>', [1, 0, 0, 0.5]),
            ('<ellipse rx="10" transform="{}"/>', [1, 0, 0, 1]),
        ],
    )
    @pytest.mark.parametrize(
        ("transform", "matrix"),
        [
            ("rotate(90)", [0, 1, -1, 0]),
            ("skewX(45)", [1, -1, 0, 1]),
            ("matrix(1 1 0 3 0 0)", [1, 0, -1, 3]),
        ],
    )
    def test_transformed_curves(
        self,
        tmp_path: Path,
        body: str,
        shape: list[float],
        transform: str,
        matrix: list[float],
        distance: float,
    ) -> None:
        """The unit circle, taken back from what is read, is one again."""
        (polygon,) = read(tmp_path, svg(body.format(transform)), "--flatten", str(distance))
        inverse = numpy.linalg.inv(numpy.reshape(matrix, (2, 2)) @ numpy.reshape(shape, (2, 2)))
        vertices = polygon.vertices @ inverse.T
        check_circle(vertices, distance * float(numpy.linalg.norm(inverse, 2)))
        assert len(polygon) < 8 + 40 / distance**0.5

    def test_what_is_left_out(self, tmp_path: Path) -> None:
        body = '<text>A</text><line x2="1" y2="1"/><rect width="1" height="1"/>'
        run = run_program(tmp_path, "simplify", "-", "--tolerance", "0", text=svg(body))
        assert run.stderr == "gcv: standard input: left out: 1 text, 1 line\n"
        assert run.returncode == 0

    @pytest.mark.parametrize("distance", [1e-4, 0.1, 3, 100])
    @pytest.mark.parametrize(
        "body",
        [
            '<circle r="10"/>',
            '<ellipse rx="5" ry="10" transform="scale(2 1)"/>',
            '<path d="M-10 0A10 10 0 0 0 10 0A10 10 0 0 0-10 0z"/>',
        ],
    )
    def test_flattened_circle(self, tmp_path: Path, body: str, distance: float) -> None:
        (polygon,) = read(tmp_path, svg(body), "--flatten", str(distance))
        check_circle(polygon.vertices, distance)

    @pytest.mark.parametrize("path", ["A10 10 0 0 0 10 0z", "Q5 5 10 0z"])
    def test_too_fine(self, tmp_path: Path, path: str) -> None:
        text = svg(f'<path d="M-10 0{path}"/>')
        assert "are too many" in error(tmp_path, text, "--flatten", "1e-300")

    def test_flattened_curves(self, tmp_path: Path) -> None:
        body = '<path d="M0 0Q5-10 10 0z"/><path d="M0 0C0-10 10-10 10 0S20 10 0 10z"/>'
        parabola, _ = read(tmp_path, svg(body), "--flatten", "0.001")
        for x, y in parabola.vertices.tolist():
            assert abs(y - 2 * x * (10 - x) / 10) < 1e-9
        assert 0 < 10 * 5 * 2 / 3 - parabola.area < 10 * 0.001

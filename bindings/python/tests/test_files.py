# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons of files as the program reads them, and as it writes them."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from program import run_program
from shapes import NOTCHED, SQUARE, TRIANGLE

import gcv

PLATE = gcv.Polygon([(0, 0), (6, 0), (6, 4), (0, 4)], holes=[[(1, 1), (3, 1), (3, 3)]])
CORNER = "(0 0, 1 0, 0 1)"
NESTED = '{"type": "GeometryCollection", "geometries": [' * 480 + "]}" * 480
NOT_HERE = "is not installed: reading {} is not tested"


def read(folder: Path, text: str, *options: str) -> list[gcv.Polygon]:
    """The polygons that the program finds in a file."""
    run = run_program(folder, "simplify", "-", "--tolerance", "0", *options, text=text)
    assert (run.stderr, run.returncode) == ("", 0)
    return [gcv.Polygon(line) for line in run.stdout.splitlines()]


def error(folder: Path, text: str, *options: str) -> str:
    """What the program says to a file that it cannot read."""
    run = run_program(folder, "simplify", "-", "--tolerance", "0", *options, text=text)
    assert (run.stdout, run.returncode) == ("", 1)
    assert run.stderr.startswith("gcv: standard input: ")
    assert run.stderr.count("\n") == 1
    return run.stderr[len("gcv: standard input: ") : -1]


@pytest.mark.parametrize(
    "text",
    [
        PLATE.wkt,
        f"\ufeff {PLATE.wkt}\n\n",
        PLATE.wkt.lower().replace(" ", "\n"),
        PLATE.wkt.replace("POLYGON (", "MULTIPOLYGON (((0 0, 0 1, 1 0)), (") + ")",
        f"GEOMETRYCOLLECTION (POINT (1 1), POLYGON EMPTY, {PLATE.wkt}, LINESTRING (0 0, 1 1))",
        f"GEOMETRYCOLLECTION EMPTY\nMULTIPOLYGON EMPTY\n{PLATE.wkt}",
        f"MULTIPOLYGON (EMPTY , {PLATE.wkt[8:]})",
        f"GEOMETRYCOLLECTION (MULTIPOINT (0 0, 1 1), MULTIPOINT ((0 0), EMPTY), {PLATE.wkt})",
        f"GEOMETRYCOLLECTION (MULTILINESTRING ((0 0, 1 1)), POINT Z (1 -1e3 NaN), {PLATE.wkt})",
        "GEOMETRYCOLLECTION (" * 5000 + PLATE.wkt + ")" * 5000,
        "POLYGON Z ((0 0 1, 6 0 1, 6 4 1, 0 4 1), (1 1 1, 3 1 1, 3 3 1))",
        "MULTIPOLYGON Z (((0 0 1, 6 0 1, 6 4 1, 0 4 1), (1 1 1, 3 1 1, 3 3 1)))",
        json.dumps(PLATE.__geo_interface__),
        json.dumps({"type": "Feature", "geometry": PLATE.__geo_interface__}),
        json.dumps(
            {
                "type": "FeatureCollection",
                "features": [
                    {"type": "Feature", "geometry": None},
                    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 1]}},
                    {"type": "Feature", "geometry": PLATE.__geo_interface__},
                ],
            }
        ),
        json.dumps({"type": "GeometryCollection", "geometries": [PLATE.__geo_interface__]}),
        json.dumps(
            {"type": "MultiPolygon", "coordinates": [PLATE.__geo_interface__["coordinates"]]}
        ),
    ],
)
def test_text(tmp_path: Path, text: str) -> None:
    assert read(tmp_path, text)[-1] == PLATE


def test_many_in_text(tmp_path: Path) -> None:
    square, triangle = gcv.Polygon(SQUARE), gcv.Polygon(TRIANGLE)
    both = f"{square.wkt}\n{triangle.wkt}\n"
    assert read(tmp_path, both) == [square, triangle]
    parts = [shape.__geo_interface__["coordinates"] for shape in (PLATE, square)]
    multi = {"type": "MultiPolygon", "coordinates": parts}
    assert read(tmp_path, json.dumps(multi)) == [PLATE, square]
    assert read(tmp_path, json.dumps(multi), "--pick-a", "1") == [square]


def test_many_names_the_file(tmp_path: Path) -> None:
    path = tmp_path / "{bow}.wkt"
    path.write_text(f"POLYGON ({CORNER}) POLYGON ((0 0, 2 2, 2 0, 0 2))")
    with pytest.raises(gcv.InputError) as raised:
        gcv.Polygon.many(path)
    assert str(raised.value).startswith(f"{path}: polygon 1: edges 0 and 2 meet")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "there is no polygon in this file"),
        ("POLYGON EMPTY", "there is no polygon in this file"),
        ('{"type": "FeatureCollection", "features": []}', "there is no polygon in this file"),
        ("0 0\n1 0\n1 1\n", "these are numbers, and neither Well-Known Text, GeoJSON, SVG nor DXF"),
        (" -.5, 1\n999 0\n1 1\n", "these are numbers, and neither Well-Known Text,"),
        ("\x80", "polygon: byte 0: expected POLYGON"),
        ("POINT (1 1)", "polygon: byte 0: expected POLYGON"),
        ("POLYGON ((0 0, 1 0, 1 1)) POINT (1 1)", "polygon 1: byte 26: expected POLYGON"),
        ("POLYGON ((0 0, 1 0, 1 x))", "polygon: byte 22"),
        ("POLYGON ((0 0, 1 0, 1 1)", "polygon: byte 24"),
        ("MULTIPOLYGON (((0 0, 1 0, 1 1)), ((0 0, 1 0, 1 x)))", "polygon 1: byte 47"),
        (f"MULTIPOLYGON (({CORNER}),", "byte 32: expected '('"),
        (f"MULTIPOLYGON (({CORNER}), garbage, ({CORNER}))", "byte 33: expected '('"),
        (f"MULTIPOLYGON (({CORNER})", "byte 31: expected ',' or ')'"),
        (f"MULTIPOLYGON (({CORNER}) ({CORNER}))", "byte 32: expected ',' or ')'"),
        (f"MULTIPOLYGON (POLYGON ({CORNER}))", "byte 14: expected '('"),
        (f"GEOMETRYCOLLECTION (POLYGON ({CORNER}), LINESTRING (0 0", "byte 59: expected a vertex"),
        (f"GEOMETRYCOLLECTION (POINT (garbage), POLYGON ({CORNER}))", "byte 27: expected a vertex"),
        (f"GEOMETRYCOLLECTION (POLYGON ({CORNER}), ", "byte 47: expected a geometry"),
        (f"GEOMETRYCOLLECTION (POLYGON ({CORNER}) POINT (0 0))", "byte 46: expected ',' or ')'"),
        (f"GEOMETRYCOLLECTION (POLYGON ({CORNER}", "byte 44: expected ',' or ')'"),
        (f"GEOMETRYCOLLECTION (POLYGON ({CORNER})))", "polygon 1: byte 46: expected POLYGON"),
        (f"MULTIGEOMETRYCOLLECTION (POLYGON ({CORNER}))", "polygon: byte 0: expected POLYGON"),
        ("GEOMETRYCOLLECTION ()", "byte 20: expected a geometry"),
        ("GEOMETRYCOLLECTION (" * 5000, "byte 100000: expected a geometry"),
        (f"{PLATE.wkt} POLYGON ((0 0, 2 2, 2 0, 0 2))", "polygon 1: edges 0 and 2"),
        ("POLYGON ((0 0, 9 0, 0 9), (1 1, 9 1, 1 2))", "polygon: "),
        ('{"type": "Polygon", "coordinates": [[[0, 0], [1, "x"], [1, 1]]]}', "vertex 1"),
        ('{"type": "Point", "coordinates": [1, 1]}', "polygon: a geometry of type 'Point'"),
        ('{"type": "Polygon"', "GeoJSON text: "),
        ('{"a":' * 100_000, "GeoJSON text: "),
        (NESTED, "GeoJSON text: it is nested too deeply"),
        ('{"type": "FeatureCollection", "features": 1}', "polygon: "),
        ('{"type": ["Polygon"]}', "polygon: "),
    ],
)
def test_bad_text(tmp_path: Path, text: str, reason: str) -> None:
    assert error(tmp_path, text).startswith(reason) or f": {reason}" in error(tmp_path, text)


@pytest.mark.parametrize("form", ["wkt", "geojson", "svg"])
def test_formats_read_back(tmp_path: Path, form: str) -> None:
    if form == "svg":
        pytest.importorskip("svgelements", reason=f"svgelements {NOT_HERE.format('SVG')}")
    for name, polygon in {"a": PLATE, "b": gcv.Polygon(NOTCHED).translated((0.1, -1e-3))}.items():
        (tmp_path / name).write_text(polygon.wkt)
    for region in ([], ["--region"]):
        sum_of = run_program(tmp_path, "sum", "a", "b", "--format", form, *region)
        run = run_program(tmp_path, "sum", "a", "b", *region)
        assert [p.wkt for p in read(tmp_path, sum_of.stdout)] == [
            p.wkt for p in read(tmp_path, run.stdout)
        ]


def test_fits_are_left_out_of_what_is_read(tmp_path: Path) -> None:
    pytest.importorskip("svgelements", reason=f"svgelements {NOT_HERE.format('SVG')}")
    (tmp_path / "a").write_text("POLYGON ((0 0, 3 0, 3 3, 0 3), (1 1, 2 1, 2 2, 1 2))")
    (tmp_path / "b").write_text("POLYGON ((0 0, 1 0, 1 1, 0 1))")
    expected = gcv.Polygon([(-1, -1), (3, -1), (3, 3), (-1, 3)])
    for form in ("wkt", "geojson", "svg"):
        text = run_program(tmp_path, "nfp", "a", "b", "--region", "--format", form).stdout
        run = run_program(tmp_path, "simplify", "-", "--tolerance", "0", text=text)
        assert gcv.Polygon(run.stdout) == expected
        left_out = "gcv: standard input: left out: 1 path\n" if form == "svg" else ""
        assert run.stderr == left_out


@given(
    st.lists(st.tuples(*[st.floats(-1e6, 1e6, allow_subnormal=False)] * 2), min_size=3, max_size=3)
)
def test_svg_keeps_every_bit(triangle: list[tuple[float, float]]) -> None:
    pytest.importorskip("svgelements", reason=f"svgelements {NOT_HERE.format('SVG')}")
    try:
        polygon = gcv.Polygon(triangle)
    except gcv.InputError:
        return
    here = Path()
    arguments = "simplify", "-", "--tolerance", "0", "--format", "svg"
    text = run_program(here, *arguments, text=polygon.wkt).stdout
    assert read(here, text) == [polygon]


def test_paths_without_data(tmp_path: Path) -> None:
    paths = '<path d="M0 0H1V1Z"/><path/>'
    text = f'<svg xmlns="http://www.w3.org/2000/svg">{paths}</svg>'
    run = run_program(tmp_path, "simplify", "-", "--tolerance", "0", text=text)
    assert run.stdout == "POLYGON ((0 0, 1 -1, 1 0, 0 0))\n"
    assert run.stderr == "gcv: standard input: left out: 1 path\n"


@pytest.mark.parametrize(
    ("text", "package", "kind"),
    [
        ("<svg></svg>", "svgelements", "SVG"),
        ("  0\nSECTION\n", "ezdxf", "DXF"),
    ],
)
def test_missing_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, package: str, kind: str
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    assert error(tmp_path, text) == (
        f"reading {kind} takes the package {package}, such as by pip install {package}"
    )

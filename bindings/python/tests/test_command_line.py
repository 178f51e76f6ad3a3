# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv: its commands, and what they print."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from program import PEG, SLOT, as_json, failure, folder, output, run_program, run_shell
from shapes import NOTCHED, TRIANGLE

import gcv

__all__ = ["folder"]


@pytest.mark.parametrize("command", ["sum a.wkt b.wkt", "a.wkt b.wkt", "--threads 2 a.wkt b.wkt"])
def test_sum(folder: Path, command: str) -> None:
    assert output(folder, command) == gcv.minkowski_sum(NOTCHED, TRIANGLE).wkt + "\n"


def test_sum_options(folder: Path) -> None:
    near = gcv.minkowski_sum(NOTCHED, TRIANGLE, tolerance=20, rounding="outward")
    command = "sum a.wkt b.wkt --tolerance 20 --rounding outward"
    assert output(folder, command) == near.wkt + "\n"
    assert output(folder, "sum slot.wkt peg.wkt --region") == (
        "MULTIPOLYGON (((0 0, 8 0, 8 8, 0 8, 0 0)))\nGEOMETRYCOLLECTION (LINESTRING (4 4, 4 8))\n"
    )
    command = "sum slot.wkt peg.wkt --region --leave-out fits --leave-out holes"
    assert output(folder, command).endswith("\nGEOMETRYCOLLECTION EMPTY\n")


def test_nfp(folder: Path) -> None:
    face = gcv.no_fit_polygon(NOTCHED, TRIANGLE, (0.5, -2e-3))
    assert output(folder, "nfp a.wkt b.wkt --reference 0.5 -2e-3") == face.wkt + "\n"
    assert output(folder, "nfp slot.wkt peg.wkt --region --reference 0 1") == (
        "MULTIPOLYGON (((-2 -1, 6 -1, 6 7, -2 7, -2 -1)))\n"
        "GEOMETRYCOLLECTION (LINESTRING (2 3, 2 7))\n"
    )


def test_inner_fit(folder: Path) -> None:
    segments = "LINESTRING (1 0, 1 4), LINESTRING (1 0, 5 0), LINESTRING (5 0, 5 4)"
    command = "inner-fit slot.wkt peg.wkt --reference 1 0"
    assert output(folder, command) == (f"MULTIPOLYGON EMPTY\nGEOMETRYCOLLECTION ({segments})\n")
    assert output(folder, f"{command} --leave-out fits").endswith("\nGEOMETRYCOLLECTION EMPTY\n")


def test_free(folder: Path) -> None:
    (folder / "sheet.wkt").write_text("POLYGON ((0 0, 9 0, 9 6, 0 6))")
    command = "free slot.wkt peg.wkt --container sheet.wkt"
    fits = "LINESTRING (2 2, 2 4)"
    assert output(folder, command) == "MULTIPOLYGON (((6 0, 7 0, 7 4, 6 4, 6 0)))\n" + (
        f"GEOMETRYCOLLECTION ({fits})\n"
    )
    assert output(folder, f"{command} --best -1 0") == "2 2\n"
    assert as_json(folder, f"{command} --best 1 0") == {"position": [7, 0]}
    assert output(folder, f"{command} --best -1 0 --leave-out fits") == "6 0\n"
    window = output(folder, "free slot.wkt peg.wkt --window 0 1 4 3")
    assert window == "MULTIPOLYGON EMPTY\nGEOMETRYCOLLECTION (LINESTRING (2 2, 2 3))\n"
    assert output(folder, "free two.wkt peg.wkt --window 6 0 7 1 --pick-b 0").count("\n") == 2
    (folder / "sheet.wkt").write_text(SLOT)
    assert output(folder, f"{command} --best 1 0") == "nothing is free\n"
    assert as_json(folder, f"{command} --best 1 0") == {"position": None}


def test_free_in_an_empty_scene(folder: Path) -> None:
    (folder / "sheet.wkt").write_text("POLYGON ((0 0, 9 0, 9 6, 0 6))")
    region = "MULTIPOLYGON (((0 0, 7 0, 7 4, 0 4, 0 0)))\nGEOMETRYCOLLECTION EMPTY\n"
    for scene in (
        *("POLYGON EMPTY", "MULTIPOLYGON EMPTY\nGEOMETRYCOLLECTION EMPTY\n"),
        *("GEOMETRYCOLLECTION (POINT (1 1))", "GEOMETRYCOLLECTION EMPTY"),
        *('{"type": "FeatureCollection", "features": []}',),
        *('{"type": "MultiPolygon", "coordinates": []}',),
        *('{"type": "Feature", "properties": {}, "geometry": null}',),
    ):
        command = "free - peg.wkt --container sheet.wkt"
        assert output(folder, command, scene) == region
        assert output(folder, f"{command} --best -1 0", scene) == "0 0\n"
        assert output(folder, f"{command} --svg out.svg", scene) == region
        window = output(folder, "free - peg.wkt --window 1 1 2 2", scene)
        assert window.startswith("MULTIPOLYGON (((1 1, 2 1, 2 2, 1 2, 1 1)))\n")
        for command in ("sum - peg.wkt", "free peg.wkt peg.wkt --container -", "free peg.wkt -"):
            words = [*command.split(), *(["--window", "0", "0", "1", "1"] * ("free" in command))]
            run = run_program(folder, *words, text=scene)
            assert failure(run, 1) == "gcv: standard input: there is no polygon in this file\n"
    for nothing in ("", " \n", '<svg xmlns="http://www.w3.org/2000/svg"/>', "LINESTRING EMPTY"):
        run = run_program(
            folder, *["free", "-", "peg.wkt", "--container", "sheet.wkt"], text=nothing
        )
        assert failure(run, 1).startswith("gcv: standard input: ")


def test_nesting_from_nothing(folder: Path) -> None:
    run = run_shell(
        folder,
        """
        echo 'POLYGON ((0 0, 5 0, 5 3, 0 3))' > sheet.wkt
        echo 'MULTIPOLYGON EMPTY' > placed.wkt
        for part in 1 2 3; do
          read x y < <(gcv free placed.wkt peg.wkt --container sheet.wkt --best -1 0)
          echo $x $y
          [ "$x" = nothing ] && break
          to="$((x + 2)) $((y + 2))"
          echo "POLYGON (($x $y, ${to% *} $y, $to, $x ${to#* }))" >> placed.wkt
        done
        """,
    )
    assert run.stdout == "0 0\n2 0\nnothing is free\n"


def test_questions(folder: Path) -> None:
    assert output(folder, "relation slot.wkt peg.wkt --at 2 2") == "touching\n"
    assert output(folder, "distance slot.wkt peg.wkt --at 9 0") == "3\n"
    assert output(folder, "cast slot.wkt peg.wkt --at 10 0 --motion -8 0") == (
        "hit at time 0.5, position 6 0\n"
    )
    assert output(folder, "cast slot.wkt peg.wkt --at 10 0 --motion 1 0") == "no hit\n"
    assert output(folder, "penetration slot.wkt peg.wkt --at 5 0") == "depth 1, position 6 0\n"
    assert output(folder, "contacts slot.wkt peg.wkt --at 6 6.5") == ""
    contacts = output(folder, "contacts slot.wkt peg.wkt --at 6 6.5 --distance 0.5").splitlines()
    assert contacts[0] == "edge 1 of A, vertex 0 of B, gap 0.5, at 6 6"
    assert contacts[2] == "vertex 2 of A, edge 0 of B, gap 0.5, at 6 6"
    assert contacts[4:] == ["vertex 2 of A, vertex 0 of B, gap 0.5, at 6 6"]


def test_scene_pairs(folder: Path) -> None:
    (folder / "scene.wkt").write_text(f"{SLOT}\nPOLYGON ((6 0, 8 0, 8 1, 6 1))\n{PEG}\n")
    assert output(folder, "scene-pairs scene.wkt") == "0 1 touching\n0 2 overlapping\n"
    (folder / "sheet.wkt").write_text("POLYGON ((1 -1, 9 -1, 9 7, 1 7))")
    command = "scene-pairs - --container sheet.wkt --distance 1 --threads 2"
    assert output(folder, command, text=(folder / "scene.wkt").read_text()) == (
        "container 0 overlapping\ncontainer 1 apart\ncontainer 2 overlapping\n"
        "0 1 touching\n0 2 overlapping\n"
    )
    assert as_json(folder, "scene-pairs scene.wkt") == {
        "pairs": [
            {"a": 0, "b": 1, "relation": "touching"},
            {"a": 0, "b": 2, "relation": "overlapping"},
        ]
    }
    assert output(folder, "scene-pairs -", "MULTIPOLYGON EMPTY") == ""
    assert output(folder, "scene-pairs - --format json", "MULTIPOLYGON EMPTY") == '{"pairs": []}\n'


def test_scene_contacts(folder: Path) -> None:
    (folder / "scene.wkt").write_text(f"POLYGON ((7 0, 8 0, 8 1, 7 1))\n{SLOT}\n")
    assert output(folder, "scene-contacts scene.wkt") == ""
    assert output(folder, "scene-contacts scene.wkt --distance 1") == (
        "0 1 edge 3 of A, vertex 1 of B, gap 1, at 7 0\n"
        "0 1 vertex 0 of A, edge 1 of B, gap 1, at 7 0\n"
        "0 1 vertex 3 of A, edge 1 of B, gap 1, at 7 1\n"
        "0 1 vertex 0 of A, vertex 1 of B, gap 1, at 7 0\n"
    )
    (folder / "sheet.wkt").write_text("POLYGON ((-1 0, 9 0, 9 7, -1 7))")
    command = "scene-contacts scene.wkt --container sheet.wkt --distance 1 --slope 1e-9"
    contacts = as_json(folder, command)["contacts"]
    scene = gcv.Scene("POLYGON ((-1 0, 9 0, 9 7, -1 7))")
    scene.add([gcv.Polygon([(7, 0), (8, 0), (8, 1), (7, 1)]), gcv.Polygon(SLOT)])
    assert [(one["gap"], one["a"], one["b"]) for one in contacts] == [
        (one.gap, one.a, one.b) for one in scene.contacts(1, 1e-9)
    ]
    numbers = {1: "container", 2: 0, 3: 1}
    assert [(one["polygon_a"], one["polygon_b"]) for one in contacts] == [
        (numbers[one.id_a], numbers[one.id_b]) for one in scene.contacts(1, 1e-9)
    ]
    keys = {"polygon_a", "polygon_b", "kind", "a", "b", "gap", "normal", "on_a", "on_b"}
    assert set(contacts[0]) == keys


def test_positions_that_overlap_still(folder: Path) -> None:
    """No floats beside the exact position, on slanted edges, are free."""
    (folder / "c.wkt").write_text("POLYGON ((8.5 6.3, 7 4.1, 7.5 7.2, 6.7 3.5))")
    (folder / "d.wkt").write_text("POLYGON ((2.5 9.4, 8 9, 2.7 4.3))")
    printed = output(folder, "penetration c.wkt d.wkt --at 4.5 0.6")
    depth, position = "depth 0.6810567380398088", "4.867715409367179 1.1732570611369324"
    assert printed == f"{depth}, position {position}, still overlapping\n"
    assert output(folder, f"relation c.wkt d.wkt --at {position}") == "overlapping\n"


def test_questions_as_json(folder: Path) -> None:
    assert as_json(folder, "relation slot.wkt peg.wkt") == {"relation": "overlapping"}
    separation = gcv.distance(SLOT, PEG, (9, 0))
    found = as_json(folder, "distance slot.wkt peg.wkt --at 9 0")
    assert (found["distance"], found["relation"]) == (3, "apart")
    assert separation.nearest is not None
    assert found["nearest"]["kind"] == "edge-vertex"
    assert found["nearest"]["a"] == separation.nearest.a
    assert set(found["nearest"]) == {"kind", "a", "b", "gap", "normal", "on_a", "on_b"}
    found = as_json(folder, "cast slot.wkt peg.wkt --at 10 0 --motion 1 0")
    assert found["hit"] is False
    assert found["contact"] is None
    assert as_json(folder, "penetration slot.wkt peg.wkt --at 5 0")["translation"] == [1, 0]
    assert len(as_json(folder, "contacts slot.wkt peg.wkt --at 2 2")["contacts"]) == len(
        gcv.contacts(SLOT, PEG, (2, 2))
    )


def test_positions(folder: Path) -> None:
    at = "slot.wkt peg.wkt --positions table.txt"
    assert output(folder, f"relation {at}") == "apart\napart\noverlapping\n"
    assert output(folder, f"distance {at}") == "4\n2.5\n0\n"
    assert output(folder, f"cast {at} --motion -4 0").startswith("no hit\nhit at time 0.625")
    found = as_json(folder, f"penetration {at}")
    assert [one["at"] for one in found] == [[10, 0], [8.5, 0], [0, 0]]
    assert [one["relation"] for one in found] == ["apart", "apart", "touching"]
    assert output(folder, "relation slot.wkt peg.wkt --positions -", "6 0") == "touching\n"


def test_without_numpy(folder: Path) -> None:
    code = "import sys; sys.modules['numpy'] = None; from gcv.__main__ import main; main()"
    arguments = "distance", "slot.wkt", "peg.wkt", "--positions", "table.txt"
    run = subprocess.run(
        [sys.executable, "-c", code, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (run.stdout, run.stderr) == ("4\n2.5\n0\n", "")


def test_several_polygons(folder: Path) -> None:
    slot, peg = gcv.Polygon(SLOT), gcv.Polygon(PEG)
    faces = [slot + slot, slot + peg, peg + slot, peg + peg]
    assert output(folder, "sum two.wkt two.wkt") == "".join(f"{face.wkt}\n" for face in faces)
    assert output(folder, "sum two.wkt two.wkt --pick-a 1 --pick-b 0") == f"{faces[2].wkt}\n"
    moved = [gcv.no_fit_polygon(slot, peg, (1, 2)), gcv.no_fit_polygon(peg, peg, (1, 2))]
    command = "nfp two.wkt peg.wkt --reference 1 2"
    assert output(folder, command) == "".join(f"{face.wkt}\n" for face in moved)
    assert output(folder, f"{command} --region").count("\n") == 4
    assert output(folder, "inner-fit two.wkt peg.wkt").count("\n") == 4
    assert output(folder, "simplify two.wkt --tolerance 0").count("\n") == 2
    assert output(folder, "relation two.wkt two.wkt --at 2 2") == (
        "0 0 overlapping\n0 1 touching\n1 0 touching\n1 1 touching\n"
    )
    found = as_json(folder, "distance two.wkt peg.wkt --positions table.txt")
    assert [(one["a"], one["at"]) for one in found[:4]] == [
        *((0, [10, 0]), (0, [8.5, 0]), (0, [0, 0]), (1, [10, 0]))
    ]
    collection = json.loads(output(folder, "sum two.wkt peg.wkt --format geojson"))
    assert [one["properties"] for one in collection["features"]] == [
        {"a": 0, "error_bound": 0},
        {"a": 1, "error_bound": 0},
    ]


def test_offset(folder: Path) -> None:
    for distance in (0.5, -0.25):
        region = gcv.offset(NOTCHED, distance, 0.01)
        command = f"offset a.wkt --distance {distance} --tolerance 0.01"
        assert output(folder, command) == f"{region.wkt}\n{region.fits_wkt}\n"
    assert (
        output(folder, "offset two.wkt --distance 1 --tolerance 1 --svg out.svg").count("\n") == 4
    )
    assert (folder / "out.svg").read_text().startswith("<svg")
    run = run_program(folder, *["offset", "two.wkt", "--distance", "0", "--tolerance", "1"])
    assert "'0' is no offset" in failure(run, 2)
    run = run_program(folder, *["offset", "a.wkt", "--distance", "1"])
    assert "--tolerance" in failure(run, 2)


def test_simplify(folder: Path) -> None:
    near = gcv.Polygon(NOTCHED).simplified(6, rounding="outward")
    command = "simplify a.wkt --tolerance 6 --rounding outward"
    assert output(folder, command) == f"{near.polygon.wkt}\n"
    feature = json.loads(output(folder, f"{command} --format geojson"))
    assert feature["properties"] == {"error_bound": near.error_bound}


def test_exact(folder: Path) -> None:
    text = output(folder, "sum a.wkt b.wkt --format exact")
    assert text == "POLYGON ((0 0, 9 0, 9 6, 8 7, 10/3 7/3, 1 7, 0 8, 0 0))\n"
    run = run_program(folder, "sum", "-", "b.wkt", text=text)
    assert failure(run, 1).startswith("gcv: standard input: polygon: byte 32: expected")
    assert output(folder, "nfp slot.wkt peg.wkt --region --format exact") == (
        output(folder, "nfp slot.wkt peg.wkt --region")
    )
    assert output(folder, "simplify - --tolerance 0 --format exact", "POLYGON((0 0,.5 0,0 1))") == (
        "POLYGON ((0 0, 1/2 0, 0 1, 0 0))\n"
    )
    assert output(folder, "inner-fit peg.wkt slot.wkt --format exact") == (
        "MULTIPOLYGON EMPTY\nGEOMETRYCOLLECTION EMPTY\n"
    )


def test_output_to_a_file(folder: Path) -> None:
    assert output(folder, "sum a.wkt b.wkt -o sum.wkt") == ""
    assert (folder / "sum.wkt").read_text() == output(folder, "sum a.wkt b.wkt")


def test_pictures(folder: Path) -> None:
    output(folder, "nfp slot.wkt peg.wkt --region --svg out.svg")
    assert (folder / "out.svg").read_text().count("<path") == 4
    output(folder, "free slot.wkt peg.wkt --window 0 0 9 9 --svg out.svg")
    assert (folder / "out.svg").read_text().count("<path") == 4
    output(folder, "simplify two.wkt --tolerance 0 --svg out.svg")
    assert (folder / "out.svg").read_text().count("<path") == 4


def test_drawings_of_points_and_beyond_the_range(folder: Path) -> None:
    drawing = output(folder, "inner-fit peg.wkt peg.wkt --format svg")
    assert 'viewBox="-0.025 -0.025 0.05 0.05"' in drawing
    huge = "-1e308 -1e308, 1e308 -1e308, 1e308 1e308, -1e308 1e308"
    (folder / "huge.wkt").write_text(f"POLYGON (({huge}))")
    run = run_program(folder, *["simplify", "huge.wkt", "--tolerance", "0", "--format", "svg"])
    assert failure(run, 1) == "gcv: SVG: a shape is larger than the largest float\n"


def test_interrupt(folder: Path) -> None:
    comb = ", ".join(f"{k} {(k % 2) * 1000 + k * k % 7}" for k in range(4001))
    (folder / "comb.wkt").write_text(f"POLYGON ((0 -9, {comb}, 4000 -9))")
    program = subprocess.Popen(
        [sys.executable, "-m", "gcv", "sum", "comb.wkt", "comb.wkt", "--region"],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    # Until it computes.
    while program.poll() is None and len(os.listdir(f"/proc/{program.pid}/task")) < 2:
        time.sleep(0.01)
    program.send_signal(signal.SIGINT)
    out, errors = program.communicate()
    assert (out, errors, program.returncode) == ("", "gcv: interrupted\n", 130)


def test_version_and_help(folder: Path) -> None:
    assert output(folder, "--version") == gcv.library_version() + "\n"
    assert "inner-fit" in output(folder, "--help")
    assert "--reference" in output(folder, "nfp --help")


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("gcv s", {"sum", "simplify", "scene-pairs", "scene-contacts"}),
        ("gcv inner", {"inner-fit"}),
        ("gcv sum --t", {"--tolerance", "--threads"}),
        ("gcv sum --format ", {"wkt", "geojson", "svg", "exact"}),
        ("gcv sum --threads ", set()),
        ("gcv relation --format j", {"json"}),
        ("gcv sum sl", {"slot.wkt"}),
        ("gcv sum --svg bow", {"bow tie.wkt"}),
        ("gcv completion z", {"zsh"}),
    ],
)
def test_completion_of_bash(folder: Path, line: str, words: set[str]) -> None:
    script = f"""
        source <(gcv completion bash)
        read -ra COMP_WORDS <<< {line!r}
        [[ {line!r} == *" " ]] && COMP_WORDS+=("")
        COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
        _gcv
        printf '%s\\n' "${{COMPREPLY[@]}}"
    """
    assert set(filter(None, run_shell(folder, script).stdout.splitlines())) == words


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_is_a_script(folder: Path, shell: str) -> None:
    text = output(folder, f"completion {shell}")
    for word in ("inner-fit", "reference", "geojson"):
        assert word in text
    (folder / "script").write_text(text)
    if shell != "bash" and run_shell(folder, f"command -v {shell}").returncode != 0:
        pytest.skip(f"{shell} is not installed: whether it can read its script is not tested")
    run = run_shell(folder, f"{shell} -n script")
    assert (run.stdout, run.returncode) == ("", 0)

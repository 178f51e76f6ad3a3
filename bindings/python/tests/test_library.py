# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""How the library is found, and that its declarations are those of gcv.h."""

from __future__ import annotations

import ctypes.util
import os
import pickle
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, Optional

import pytest
from shapes import BINDING, REPOSITORY

import gcv
from gcv import _ffi, _loader, _structs
from gcv._versions import NEW_IN_0_2

LIBRARY = os.environ["GCV_LIBRARY"]
HEADER = REPOSITORY / "capi/include/gcv/gcv.h"


def test_version() -> None:
    assert gcv.library_version() == gcv.__version__
    assert f'\nversion = "{gcv.__version__}"\n' in (BINDING / "pyproject.toml").read_text()


def test_every_function_is_declared() -> None:
    exported = re.findall(r"\bgcv_\w+(?=;)", (REPOSITORY / "capi/gcv.map").read_text())
    assert sorted(_ffi.FUNCTIONS) == sorted(set(exported))


def layout(struct: Any) -> list[tuple[str, int, int]]:
    members = [(name, getattr(struct, name)) for name, _ in struct._fields_]
    return [("", 0, ctypes.sizeof(struct))] + [(n, m.offset, m.size) for n, m in members]


def test_structs_are_those_of_the_compiler(tmp_path: Path) -> None:
    """A program made from the header's own text prints every size and offset."""
    text = re.sub(r"/\*.*?\*/", "", HEADER.read_text(), flags=re.DOTALL)
    structs = dict(re.findall(r"typedef struct (\w+) \{([^}]*)\}", text))
    lines = []
    for struct, members in structs.items():
        body = re.sub(r"\[\d+\]", "", members)
        lines.append(f'printf("{struct}. 0 %zu\\n", sizeof({struct}));')
        for names in re.findall(r"\(\*(\w+)\)[^;]*;|(\w+(?:, \w+)*);", body):
            for name in "".join(names).split(", "):
                member = f"(({struct} *)0)->{name}"
                lines.append(
                    f'printf("{struct}.{name} %zu %zu\\n", offsetof({struct}, {name}), '
                    f"sizeof({member}));"
                )
    constants = re.findall(r"\bGCV_[A-Z_]+(?= = )", text)
    lines += [f'printf("{name} %d\\n", (int){name});' for name in constants]
    program = tmp_path / "layout.c"
    program.write_text(
        "#include <gcv/gcv.h>\n#include <stdio.h>\nint main(void) {\n" + "\n".join(lines) + "\n}\n"
    )
    compiler = os.environ.get("CC", "cc")
    include = HEADER.parents[1]
    subprocess.run(
        [compiler, f"-I{include}", program, "-o", tmp_path / "layout"],
        check=True,
    )
    printed = subprocess.run(tmp_path / "layout", check=True, capture_output=True, text=True)

    declared = []
    for name, kind in vars(_structs).items():
        if isinstance(kind, type) and issubclass(kind, ctypes.Structure) and name != "Structure":
            struct = "gcv" + re.sub("[A-Z]", lambda letter: f"_{letter[0].lower()}", name)
            declared += [f"{struct}.{m} {offset} {size}" for m, offset, size in layout(kind)]
    values = {
        **{f"GCV_ROUND_{name.upper()}": value for name, value in _ffi.ROUNDINGS.items()},
        **{name: value for value in range(200) if "UNKNOWN" not in (name := status_name(value))},
        **{f"GCV_LEAVE_OUT_{name.upper()}": value for name, value in _ffi.LEAVE_OUTS.items()},
        **{f"GCV_{place.name}": int(place) for place in gcv.Location},
        **{f"GCV_{relation.name}": int(relation) for relation in gcv.Relation},
        **{f"GCV_CONTACT_{kind.name}": int(kind) for kind in gcv.ContactKind},
        **{name: getattr(gcv, name[4:]) for name in constants if "GCV_PART_" in name},
        "GCV_EDGE_TRANSLATED": gcv.EDGE_TRANSLATED,
        "GCV_EDGE_CORNER": gcv.EDGE_CORNER,
        "GCV_EDGE_TRANSLATED_CORNER": gcv.EDGE_TRANSLATED_CORNER,
    }
    declared += [f"{name} {value}" for name, value in values.items()]
    assert sorted(declared) == sorted(printed.stdout.splitlines())


def status_name(status: int) -> str:
    return gcv.Error(status, "").status_name


def run_import(
    library: Optional[str], directory: object, package: Path = BINDING
) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"}
    environment.pop("GCV_LIBRARY", None)
    if library is not None:
        environment["GCV_LIBRARY"] = library
    program = "import gcv; print(open('/proc/self/maps').read())"
    return subprocess.run(
        [sys.executable, "-c", program],
        env=environment,
        cwd=str(directory),
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize("library", ["/nowhere/libgcv.so.0", "libgcv.so.0", sys.executable])
def test_chosen_library_or_none(library: str) -> None:
    run = run_import(library, "/")
    assert run.returncode != 0
    assert "GCV_LIBRARY" in run.stderr
    assert library in run.stderr


def test_working_directory_is_not_searched(tmp_path: Path) -> None:
    planted = tmp_path / "libgcv.so.0"
    shutil.copy(LIBRARY, planted)
    run = run_import(None, tmp_path)
    assert str(planted) not in run.stdout
    if run.returncode != 0:
        for place in ("beside the package", "dynamic loader", "find_library"):
            assert place in run.stderr
    assert run_import(str(planted), "/").returncode == 0


def test_library_beside_the_package(tmp_path: Path) -> None:
    package = shutil.copytree(BINDING / "gcv", tmp_path / "gcv")
    shutil.copy(LIBRARY, package / "libgcv.so.0")
    assert str(package / "libgcv.so.0") in run_import(None, "/", tmp_path).stdout


@pytest.mark.parametrize(
    ("platform", "name"),
    [("linux", "libgcv.so.0"), ("darwin", "libgcv.dylib"), ("win32", "gcv.dll")],
)
def test_name_of_the_file(monkeypatch: pytest.MonkeyPatch, platform: str, name: str) -> None:
    monkeypatch.delenv("GCV_LIBRARY", raising=False)
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(ctypes.util, "find_library", lambda name: f"found {name}")
    names = [candidate for _, candidate in _loader._candidates()]
    assert names == [str(BINDING / "gcv" / name), name, "found gcv"]
    monkeypatch.setenv("GCV_LIBRARY", LIBRARY)
    assert [candidate for _, candidate in _loader._candidates()] == [LIBRARY]


def test_without_numpy() -> None:
    program = """
import sys
sys.modules["numpy"] = None
import gcv
face = gcv.minkowski_sum([(0, 0), (1, 0), (0, 1)], "POLYGON ((0 0, 1 0, 0 1))")
assert face.vertices == [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], face.vertices
assert face.polygon.vertices == face.vertices
assert face.exact_indices == [0, 1, 2]
slot = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]
region = gcv.no_fit_region(slot, [(0, 0), (2, 0), (2, 2), (0, 2)])
corners = [(-2.0, -2.0), (6.0, -2.0), (6.0, 6.0), (-2.0, 6.0)]
assert region.vertices == [*corners, (2.0, 2.0), (2.0, 6.0)], region.vertices
assert region.polygons == [(corners, [])], region.polygons
region.polygons[0].outer.clear()
assert region.polygons == [(corners, [])], region.polygons
room = gcv.Polygon(corners, [[(0, 0), (1, 0), (0, 1)]])
room.rings[0].clear()
room.holes[0].clear()
assert room.rings == [corners, [(0, 0), (0, 1), (1, 0)]], room.rings
assert region.segments == [((2.0, 2.0), (2.0, 6.0))], region.segments
assert region.points == [] and region.exact_indices == [0, 1, 2, 3, 4, 5]
assert region.locate([(2, 3), (1, 3)]) == [gcv.BOUNDARY, gcv.INSIDE]
assert region.locate((9, 9)) is gcv.OUTSIDE
assert region.polygon(0).vertices == corners
square = [(0, 0), (1, 0), (1, 1), (0, 1)]
moves = [(3, 0), (0, 1), (0.5, 0)]
assert gcv.relation(square, square, moves) == [gcv.APART, gcv.TOUCHING, gcv.OVERLAPPING]
assert gcv.relation(square, square, moves)[0] is gcv.APART
falls = lambda a, b, moves: gcv.cast(a, b, moves, (0, -0.5))
contacts = gcv.contacts(square, square, (0, 1))
assert contacts.array == list(contacts) and contacts[0].gap == 0
for function in (gcv.distance, gcv.penetration, falls):
    answers = function(square, square, moves)
    assert answers == [function(square, square, move) for move in moves], answers
    assert function(square, square, []) == []
scene = gcv.Scene()
assert scene.add([square, square], [(0, 0), (3, 0)]) == scene.ids == [2, 3]
assert scene.positions() == [(0.0, 0.0), (3.0, 0.0)] and scene.positions(3) == (3.0, 0.0)
relations = [gcv.OVERLAPPING, gcv.TOUCHING, gcv.OVERLAPPING]
assert scene.relation(square, moves) == relations
assert scene.distance(square, moves) == [scene.distance(square, move) for move in moves]
assert scene.pairs(2).array == [(2, 3, gcv.APART)]
free = scene.free_region(square, (0, 0, 3, 9), ignore=2)
assert free.vertices == [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (3.0, 1.0), (3.0, 9.0), (0.0, 9.0)]
assert free.owners == [0, 3, 3, 0, 0, 0]
ways = scene.penetration(square, moves)
assert ways == [scene.penetration(square, move) for move in moves] and ways[2].id == 2
scene.container = [(-9, -9), (9, -9), (9, 9), (-9, 9)]
assert scene.best(square, (-1, 0)) == (-9.0, -9.0)
assert not hasattr(gcv, "CONTACT_DTYPE")
try:
    gcv.IMPACT_DTYPE
except AttributeError as error:
    assert str(error) == "gcv.IMPACT_DTYPE takes numpy, which is not here"
"""
    subprocess.run([sys.executable, "-c", program], check=True)


@pytest.mark.parametrize(
    ("status", "kind", "builtin"),
    [
        (5, gcv.InputError, ValueError),
        (9, gcv.OutOfMemoryError, MemoryError),
        (7, gcv.Error, Exception),
    ],
)
def test_kinds_of_errors(status: int, kind: type[gcv.Error], builtin: type[Exception]) -> None:
    error = _ffi.named(_ffi.error(status, "polygon: why"), "a")
    assert type(error) is kind
    assert isinstance(error, builtin)
    assert (error.status, str(error)) == (status, "a: why")
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), again.args) == (kind, error.args)
    assert {5: "NOT_SIMPLE", 9: "NO_MEMORY", 7: "RANGE"}[status] in error.status_name


def test_with_version_0_1(tmp_path: Path) -> None:
    """A library without the functions of 0.2 serves all but what needs them."""
    program = f"""
import ctypes
class Old(ctypes.CDLL):
    def __getattr__(self, name):
        if name in {sorted(NEW_IN_0_2)}:
            raise AttributeError(name)
        return super().__getattr__(name)
ctypes.CDLL = Old
import pickle
import gcv
ring = [(0, 0), (9, 0), (0, 9)]
hole = [(1, 1), (2, 1), (1, 2)]
polygon = pickle.loads(pickle.dumps(gcv.Polygon(ring)))
assert (polygon + -polygon).area == 243
assert [polygon.area, polygon.ring_count, polygon.holes] == [40.5, 1, []]
face = polygon + polygon
assert pickle.loads(pickle.dumps(face)) == face
assert face.stats.parts_dropped == 0
assert gcv.Polygon(polygon.wkt) == polygon.simplified(0).polygon == polygon
text = "POLYGON ((0 0, 9 0, 0 9), (1 1, 2 1, 1 2))"
for call, name in [
    (lambda: gcv.Polygon(ring, [hole]), "gcv_polygon_create_rings"),
    (lambda: gcv.Polygon(text), "gcv_polygon_ring_count"),
    (lambda: gcv.Polygon.many([ring]), "gcv_polygon_create_many"),
    (lambda: gcv.Polygon.disc((0, 0), 1, 0.1), "gcv_polygon_create_disc"),
    (lambda: polygon.affine((1, 0, 0, 0, 1, 0)), "gcv_polygon_affine"),
    (lambda: face.exact_indices, "gcv_outer_face_exact_indices"),
    (lambda: pickle.loads(pickle.dumps(face)).exact_indices, "gcv_outer_face_exact_indices"),
    (lambda: gcv.no_fit_polygon_many([ring], [ring]), "gcv_no_fit_polygon_many"),
    (lambda: gcv.minkowski_sum_region(ring, ring), "gcv_minkowski_sum_region"),
    (lambda: gcv.no_fit_region(ring, ring, leave_out="fits"), "gcv_no_fit_region"),
    (lambda: gcv.no_fit_region_many([ring], [ring]), "gcv_no_fit_region_many"),
    (lambda: gcv.relation(ring, ring), "gcv_relation"),
    (lambda: gcv.distance(ring, ring, [(0, 0)]), "gcv_distance"),
    (lambda: gcv.cast(ring, ring, (0, 0), (1, 1)), "gcv_cast"),
    (lambda: gcv.penetration(ring, ring), "gcv_penetration"),
    (lambda: gcv.contacts(ring, ring), "gcv_contacts"),
    (lambda: gcv.Scene(), "gcv_scene_create"),
]:
    try:
        call()
    except NotImplementedError as error:
        version = gcv.library_version()
        assert str(error) == (
            f"{{name}} came with libgcv 0.2; the library that is running is {{version}}"
        )
    else:
        raise AssertionError(name)
"""
    subprocess.run([sys.executable, "-c", program], check=True, cwd=tmp_path)

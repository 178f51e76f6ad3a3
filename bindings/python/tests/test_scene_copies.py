# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What copies, pickles and pictures of a scene keep."""

from __future__ import annotations

import copy
import pickle
from typing import Any, Callable

import pytest
from matplotlib import pyplot
from matplotlib.patches import Polygon as Patch
from shapes import FRAME, SQUARE, SQUARE_2, TRIANGLE, box, scaled
from test_pictures import corners
from test_scene import BLOCK, PEG, state, three

import gcv

pyplot.switch_backend("Agg")


def copies() -> list[Callable[[gcv.Scene], gcv.Scene]]:
    return [
        gcv.Scene.copy,
        copy.copy,
        copy.deepcopy,
        lambda scene: pickle.loads(pickle.dumps(scene)),
        lambda scene: pickle.loads(pickle.dumps(scene, protocol=2)),
    ]


@pytest.mark.parametrize("copied", copies())
def test_copies(copied: Callable[[gcv.Scene], gcv.Scene]) -> None:
    scene = three()
    scene.container = box(-20, -20, 20, 20)
    scene.set(3, PEG, (0.1, -7e-300))
    scene.set_layers([3, 4], [0b101, 0])
    scene.add([*gcv.Polygon.many([SQUARE_2, TRIANGLE]), FRAME], [(9, 9), (-9, 9), (1e300, 1)])
    scene.remove([2, 6, 7])
    for source in (scene, gcv.Scene(), gcv.Scene(FRAME)):
        before = state(source)
        other = copied(source)
        assert state(other) == before
        assert repr(other) == repr(source)
        # New ids are the same in both.
        assert other.add(BLOCK, (1, 1)) == source.add(PEG, (2, 2))
        # Each changes alone.
        kept = state(source)
        other.remove(other.ids[:2])
        other.container = None
        other.set_layers(other.ids, 2)
        assert state(source) == kept


def test_pickles_of_scenes_without_members() -> None:
    scene = three()
    scene.remove(scene.ids)
    again = pickle.loads(pickle.dumps(scene))
    assert len(again) == 0
    assert again.add(BLOCK) == scene.add(BLOCK) == 5


def test_pickles_keep_what_members_share() -> None:
    scene = three()
    again = pickle.loads(pickle.dumps(scene))
    assert again.polygon(2) is again.polygon(3)
    assert len(pickle.dumps(scene)) < 1000


def test_pickles_of_many_ids(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gcv._members._IDS_AT_A_TIME", 7)
    scene = gcv.Scene()
    ids = scene.add(BLOCK, [(3 * k, 0) for k in range(50)])
    scene.remove(ids[5:36])
    again = pickle.loads(pickle.dumps(scene))
    assert state(again) == state(scene)
    assert again.add(BLOCK) == scene.add(BLOCK) == 52


def test_numbers_of_vertices_survive_pickles() -> None:
    """Contacts tell the numbers of the rings as passed."""
    turned = gcv.Polygon([*SQUARE[2:], *SQUARE[:2]]).affine([[1, 0, 1], [0, 1, 1]])
    scene = gcv.Scene()
    scene.add([BLOCK, turned], [(0, 0), (0, 0)])
    again = pickle.loads(pickle.dumps(scene))
    assert again.contacts() == scene.contacts()
    assert scene.contacts()[:1] == again.contacts()[:1]


def test_picture() -> None:
    scene = three()
    scene.container = box(-1, -1, 6, 3)
    frame, *members = corners(scene._repr_svg_())
    assert frame == [(10, 238.57), (410, 238.57), (410, 10), (10, 10)]
    assert len(members) == 3
    assert members[1] == [(181.43, 181.43), (238.57, 181.43), (238.57, 124.29), (181.43, 124.29)]
    assert corners(three()._repr_svg_())[0][0] == (10, 90)
    assert gcv.Scene()._repr_svg_().startswith("<svg")


def test_picture_of_any_size() -> None:
    scene = gcv.Scene(scaled([(x * 2 - 1, y * 2 - 1) for x, y in SQUARE], 1.7e308))
    scene.add(scaled(SQUARE, 1.7e308), [(1.7e308, 1.7e308), (-1.7e308, 0)])
    assert len(corners(scene._repr_svg_())) == 3
    scene = gcv.Scene()
    scene.add(scaled(SQUARE, 5e-324), (0, 0))
    assert len(corners(scene._repr_svg_())) == 1


def test_plot() -> None:
    scene = three()
    scene.container = FRAME
    ax = scene.plot(facecolor="red")
    assert ax is pyplot.gca()
    frame, *members = ax.patches
    assert len(members) == 3
    assert isinstance(members[1], Patch)
    assert members[1].get_facecolor()[:3] == (1, 0, 0)
    assert members[1].get_xy()[:4].tolist() == [[2, 0], [3, 0], [3, 1], [2, 1]]
    assert frame.get_zorder() <= members[0].get_zorder()
    _, (left, right) = pyplot.subplots(1, 2)
    assert gcv.Scene().plot(left) is left
    assert not left.patches
    assert not right.patches
    pyplot.close("all")


class Wall(gcv.Scene):
    """Has no container to be made with, attributes of its own, and notes what is added."""

    def __init__(self, name: str = "wall") -> None:
        super().__init__()
        self.name = name
        self.notes: list[str] = []

    def add(self, polygons: Any, positions: Any = (0, 0)) -> Any:
        self.notes.append("block")
        return super().add(polygons, positions)


@pytest.mark.parametrize(
    "again_of",
    [gcv.Scene.copy, copy.copy, copy.deepcopy, lambda wall: pickle.loads(pickle.dumps(wall))],
)
def test_derived_classes_keep_what_they_add(again_of: Callable[[Wall], Wall]) -> None:
    wall = Wall("north")
    wall.container = [(0, 0), (5, 0), (5, 5), (0, 5)]
    wall.add(BLOCK, [(1, 1), (2, 1)])
    wall.notes.append("dry")
    again = again_of(wall)
    assert type(again) is Wall
    assert (again.name, again.notes) == ("north", ["block", "dry"])
    assert again.container == wall.container
    assert again.positions().tolist() == [[1, 1], [2, 1]]
    shares = again_of in (gcv.Scene.copy, copy.copy)
    assert (again.notes is wall.notes) == shares

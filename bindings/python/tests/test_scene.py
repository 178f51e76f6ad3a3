# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The members of a scene: how they come, change and go."""

from __future__ import annotations

import math
from typing import Any, Callable

import numpy as np
import pytest
import shapely
from shapes import BOW_TIE, FRAME, SQUARE, SQUARE_2, TRIANGLE, box

import gcv

BLOCK = gcv.Polygon(SQUARE)
PEG = gcv.Polygon(TRIANGLE)


def three() -> gcv.Scene:
    """Members 2, 3 and 4: squares in a row, with gaps of 1."""
    scene = gcv.Scene()
    scene.add(BLOCK, [(0, 0), (2, 0), (4, 0)])
    return scene


def state(scene: gcv.Scene) -> tuple[Any, ...]:
    """All that a scene tells of its members."""
    layers = [scene.near(BLOCK, (0, 0), 1e9, layers=1 << k).array["a"].tolist() for k in range(32)]
    return (
        *(scene.container, scene.ids.tolist(), scene.positions().tolist()),
        *([scene.polygon(id) for id in scene], layers),
    )


def test_add_one() -> None:
    scene = gcv.Scene()
    assert scene.add(BLOCK) == 2
    assert scene.add(SQUARE, (3, 4)) == 3
    assert scene.add(np.array(SQUARE), np.array([5, 6])) == 4
    assert scene.add(shapely.box(0, 0, 1, 1), (7.5, 8)) == 5
    assert scene.add("POLYGON ((0 0, 1 0, 0 1, 0 0))", (9, 9)) == 6
    assert isinstance(scene.add(iter(SQUARE)), int)
    assert scene.ids.dtype == np.uint64
    assert scene.ids.tolist() == list(scene) == [2, 3, 4, 5, 6, 7]
    assert scene.positions().tolist() == [[0, 0], [3, 4], [5, 6], [7.5, 8], [9, 9], [0, 0]]
    assert scene.positions(3) == (3, 4)
    assert scene.polygon(2) is BLOCK
    assert scene.polygon(3) == BLOCK
    assert scene.polygon(6) == PEG


def test_add_many() -> None:
    scene = gcv.Scene()
    ids = scene.add([BLOCK, TRIANGLE, shapely.box(0, 0, 2, 2)], [(0, 0), (3, 0), (6, 0)])
    assert ids.dtype == np.uint64
    assert ids.tolist() == [2, 3, 4]
    assert scene.add(BLOCK, np.array([[0.0, 9.0], [3.0, 9.0]])).tolist() == [5, 6]
    assert scene.add(SQUARE, [(5, 9)]).tolist() == [7]
    assert scene.add([SQUARE], (5, 9)).tolist() == [8]
    assert scene.add(np.array([SQUARE, SQUARE_2]), (1, 2)).tolist() == [9, 10]
    assert scene.add(gcv.Polygon.many([SQUARE, SQUARE_2]), iter([(0, 0), (1, 1)])).tolist() == [
        *(11, 12)
    ]
    assert scene.polygon(5) is scene.polygon(6) is BLOCK
    assert scene.positions([10, 3]).tolist() == [[1, 2], [3, 0]]
    none: list[Any] = [[], ()]
    for empty in none:
        assert scene.add(empty).tolist() == scene.add(empty, empty).tolist() == []
        assert scene.add(BLOCK, empty).tolist() == []
    assert len(scene) == 11


def test_members() -> None:
    scene = three()
    assert len(scene) == 3
    assert 2 in scene
    assert np.uint64(4) in scene
    assert 1 not in scene
    assert "2" not in scene
    assert [2] not in scene
    assert np.array([2]) not in scene
    assert repr(scene) == "<gcv.Scene of 3 members>"
    scene.remove([2, 3])
    assert repr(scene) == "<gcv.Scene of 1 member>"
    scene.container = FRAME
    assert repr(scene) == "<gcv.Scene of 1 member in a container>"
    assert scene != three()
    assert not gcv.Scene(FRAME)
    assert gcv.Scene().ids.tolist() == gcv.Scene().positions().tolist() == []
    assert gcv.Scene().positions().shape == (0, 2)


def test_iteration_is_over_those_that_were_there() -> None:
    scene = three()
    for id in scene:
        scene.remove(id)
        scene.add(PEG)
    assert list(scene) == [5, 6, 7]


def test_ids_are_never_used_again() -> None:
    scene = three()
    scene.remove(4)
    assert scene.add(BLOCK) == 5
    scene.remove(scene.ids)
    assert scene.add(BLOCK) == 6


def test_arrays_are_the_callers() -> None:
    scene = three()
    places = scene.positions()
    places += (0, 1)
    scene.ids[0] = 9
    assert scene.positions().tolist() == [[0, 0], [2, 0], [4, 0]]
    scene.move(scene.ids, places)
    assert scene.positions().tolist() == [[0, 1], [2, 1], [4, 1]]


def test_set() -> None:
    scene = three()
    scene.set(3, positions=(9, 9))
    assert scene.positions().tolist() == [[0, 0], [9, 9], [4, 0]]
    scene.set(np.uint64(3), PEG)
    assert [scene.polygon(id) for id in scene] == [BLOCK, PEG, BLOCK]
    assert scene.positions(3) == (9, 9)
    changed: list[Any] = [PEG, SQUARE_2]
    scene.set([4, 2], changed, [(1, 1), (2, 2)])
    assert scene.positions().tolist() == [[2, 2], [9, 9], [1, 1]]
    assert [scene.polygon(id) for id in scene] == [gcv.Polygon(SQUARE_2), PEG, PEG]
    scene.set(scene.ids, BLOCK, (5, 5))
    assert scene.positions().tolist() == [[5, 5]] * 3
    assert all(scene.polygon(id) is BLOCK for id in scene)
    scene.set(scene.ids)
    scene.set([], PEG, (1, 1))
    scene.set((), [], [])
    scene.move(iter([2, 3]), [(0, 0), (1, 0)])
    scene.move(4, [(2, 0)])
    assert scene.positions().tolist() == [[0, 0], [1, 0], [2, 0]]
    assert scene.relation(BLOCK, (-1, 0)) is gcv.TOUCHING


def test_polygons_that_change_are_asked() -> None:
    scene = three()
    assert scene.relation(BLOCK, (1, 0)) is gcv.TOUCHING
    scene.set(2, SQUARE_2)
    assert scene.relation(BLOCK, (1, 0)) is gcv.OVERLAPPING
    scene.move(2, (0, 9))
    scene.remove(3)
    assert scene.relation(BLOCK, (1, 0)) is gcv.APART


def test_container() -> None:
    assert gcv.Scene().container is None
    scene = gcv.Scene(box(0, 0, 9, 9))
    assert scene.container == gcv.Polygon(box(0, 0, 9, 9))
    assert scene.relation(BLOCK, [(0, 0), (1, 1), (9, 9)]).tolist() == [0, 1, -1]
    scene.container = FRAME
    assert scene.container is FRAME
    # Its holes are solid.
    assert scene.relation(BLOCK, (1, 1)) is gcv.OVERLAPPING
    scene.container = None
    assert scene.container is None
    assert scene.relation(BLOCK, (1, 1)) is gcv.APART
    assert scene.add(BLOCK) == 2


UNKNOWN: list[Callable[[gcv.Scene, Any], object]] = [
    lambda scene, ids: scene.remove(ids),
    lambda scene, ids: scene.set(ids),
    lambda scene, ids: scene.set(ids, PEG, (7, 7)),
    lambda scene, ids: scene.move(ids, (7, 7)),
    lambda scene, ids: scene.set_layers(ids, 1),
    lambda scene, ids: scene.positions(ids),
]


@pytest.mark.parametrize("call", UNKNOWN)
@pytest.mark.parametrize(
    "ids", [5, 1, 0, 2**64 - 1, [2, 5], [3, 1], [2, 3, 2], np.array([4, 4], "uint64")]
)
def test_unknown_ids(call: Callable[[gcv.Scene, Any], object], ids: Any) -> None:
    scene = three()
    before = state(scene)
    with pytest.raises(gcv.InputError, match=r"\bid") as raised:
        call(scene, ids)
    assert raised.value.status_name == "GCV_ERR_INVALID_ARGUMENT"
    assert state(scene) == before


@pytest.mark.parametrize("call", UNKNOWN)
@pytest.mark.parametrize(
    ("ids", "message"),
    [
        (-1, "ids: -1 is not an id"),
        (2**64, r"ids: 1844\d+ is not an id"),
        (2.0, "ids: 2.0 is not an id, nor a sequence of them"),
        ([2, 3.0], r"ids\[1\]: 3.0 is not an id"),
        ([2, -1], r"ids\[1\]: -1 is not an id"),
        ("2", r"ids\[0\]: '2' is not an id"),
        (b"\x02", r"ids: b'\\x02' is not an id, nor a sequence of them"),
        (bytearray(), "ids: .* is not an id, nor a sequence of them"),
        ({2: 0}, "ids: {2: 0} is not an id, nor a sequence of them"),
        (True, "ids: True is not an id"),
        (np.True_, "ids: .*True.* is not an id.*"),
        ([2, True], r"ids\[1\]: True is not an id"),
        (np.array([True, True]), r"ids\[0\]: .*True.* is not an id"),
        (np.array([2.0, 3.0]), r"ids\[0\]: .*2.0.* is not an id"),
        (
            np.ma.array([2, 3], np.uint64, mask=[False, True]),
            "ids: some elements of the array are masked; .*",
        ),
    ],
)
def test_what_is_no_id(call: Callable[[gcv.Scene, Any], object], ids: Any, message: str) -> None:
    scene = three()
    before = state(scene)
    with pytest.raises(gcv.InputError, match=f"^{message}$"):
        call(scene, ids)
    assert state(scene) == before


def test_what_is_no_layer() -> None:
    scene = three()
    before = state(scene)
    wrong: list[Any] = [b"\x02", {2: 0}, True, np.True_, [True], np.array([True])]
    for layers in wrong:
        with pytest.raises(gcv.InputError, match=r"^layers.* is not a number of 32 bits"):
            scene.set_layers([2], layers)
    for layers in wrong[2:4]:
        with pytest.raises(gcv.InputError, match=r"^layers: .*True.* is not a number of 32 bits"):
            scene.relation(BLOCK, layers=layers)
    for ids in wrong:
        with pytest.raises(gcv.InputError, match=r"^ignore.* is not an id"):
            scene.relation(BLOCK, ignore=ids)
    assert state(scene) == before


def test_move_to_nowhere() -> None:
    scene = three()
    wrong: Any
    for wrong in (None, 3, np.zeros((0, 3))):
        with pytest.raises(gcv.InputError, match=r"^positions: .* is not a pair of numbers, nor"):
            scene.move(2, wrong)


def test_polygon_of_an_unknown_id() -> None:
    for id in (0, 5, 2**64 - 1):
        with pytest.raises(gcv.InputError, match=f"^id is {id}, not that of a member$"):
            three().polygon(id)
    with pytest.raises(gcv.InputError, match=r"^id is 1, the container's, not that of a member$"):
        three().polygon(1)
    wrong: Any
    for wrong in (-1, 2**64, "2", 2.0, [2]):
        with pytest.raises(gcv.InputError, match=r"^id: .* is not an id$"):
            three().polygon(wrong)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((BOW_TIE,), "polygons: edges 0 and 2 meet"),
        ((None,), "polygons: None is not a polygon, nor a sequence of polygons"),
        (([BLOCK, BOW_TIE],), r"polygons\[1\]: edges 0 and 2 meet"),
        (([BLOCK, None],), r"polygons\[1\]: None is not a polygon"),
        ((np.zeros((2, 3, 2)),), r"polygons\[0\]: "),
        (([(0, 0), (1, 0)],), "polygons: .*"),
        (("",), "polygons: .*"),
        ((BLOCK, None), "positions: None is not a pair of numbers, nor a sequence of pairs"),
        ((BLOCK, (1, 2, 3)), r"positions\[0\]: 1 is not a pair of numbers"),
        ((BLOCK, (0, math.nan)), r"positions\b.*\b0\b.*nan"),
        ((BLOCK, [(0, 0), (math.inf, 0)]), r"positions\b.*\b1\b.*inf"),
        (([BLOCK] * 2, [(0, 0)] * 3), "polygons has 2 elements and positions has 3 elements$"),
        (([BLOCK] * 2, [(0, 0)]), "polygons has 2 elements and positions has 1 elements$"),
    ],
)
def test_refused_members(arguments: Any, message: str) -> None:
    scene = three()
    before = state(scene)
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        scene.add(*arguments)
    assert state(scene) == before
    assert scene.add(BLOCK) == 5


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((BOW_TIE,), "polygons: edges 0 and 2 meet"),
        (([BLOCK, BOW_TIE],), r"polygons\[1\]: edges 0 and 2 meet"),
        ((BLOCK, (1, 2, 3)), r"positions\[0\]: 1 is not a pair of numbers"),
        ((BLOCK, 1), "positions: 1 is not a pair of numbers, nor a sequence of pairs"),
        ((None, (0, math.nan)), r"positions\b.*\b0\b.*nan"),
        ((PEG, [(0, 0), (math.inf, 0)]), r"positions\b.*\b1\b.*inf"),
    ],
)
def test_refused_changes(arguments: Any, message: str) -> None:
    scene = three()
    before = state(scene)
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        scene.set([2, 3], *arguments)
    assert state(scene) == before


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([2, 3], [PEG]), "ids has 2 elements and polygons has 1 elements"),
        (([2, 3], None, [(0, 0)]), "ids has 2 elements and positions has 1 elements"),
        (([2, 3], [PEG, PEG], [(0, 0)] * 3), "ids has 2 elements and polygons has 2 elements and "),
        ((2, [PEG, PEG]), "ids has 1 elements and polygons has 2 elements"),
        ((2, PEG, [(0, 0)] * 2), "ids has 1 elements and positions has 2 elements"),
    ],
)
def test_numbers_that_differ(arguments: Any, message: str) -> None:
    scene = three()
    before = state(scene)
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        scene.set(*arguments)
    assert state(scene) == before


@pytest.mark.parametrize(
    ("layers", "message"),
    [
        (-1, "layers: -1 is not a number of 32 bits, one for each layer"),
        (2**32, "layers: 4294967296 is not a number of 32 bits, one for each layer"),
        (1.0, "layers: 1.0 is not a number of 32 bits, one for each layer, nor a sequence of "),
        ([1, None], r"layers\[1\]: None is not a number of 32 bits"),
        ([1, 2, 3], "ids has 2 elements and layers has 3 elements"),
    ],
)
def test_refused_layers(layers: Any, message: str) -> None:
    scene = three()
    before = state(scene)
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        scene.set_layers([2, 3], layers)
    assert state(scene) == before


def test_refused_container() -> None:
    scene = gcv.Scene(FRAME)
    bow_tie: Any = BOW_TIE
    with pytest.raises(gcv.InputError, match=r"^container: edges 0 and 2 meet"):
        scene.container = bow_tie
    assert scene.container is FRAME
    with pytest.raises(gcv.InputError, match=r"^container: "):
        gcv.Scene(bow_tie)
    with pytest.raises(AttributeError):
        scene.ids = [2]  # type: ignore[misc, assignment]

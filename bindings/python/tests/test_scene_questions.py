# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Questions about a polygon at positions in a scene."""

from __future__ import annotations

import math
from typing import Any, Callable

import numpy as np
import pytest
import shapely
from shapes import BOW_TIE, FRAME, HUGE, NOWHERE, SQUARE, SQUARE_2, TRIANGLE, box

import gcv
from gcv import ContactKind

BLOCK = gcv.Polygon(SQUARE)
ROW = [(0.0, 0.0), (2.0, 0.0), (4.0, 0.0)]


def row(container: Any = None) -> gcv.Scene:
    """Members 2, 3 and 4: squares of 1 x 1 in a row, with gaps of 1."""
    scene = gcv.Scene(container)
    scene.add(BLOCK, ROW)
    return scene


def test_relation() -> None:
    scene = row()
    places = {
        (1, 0): gcv.TOUCHING,
        (1, 0.5): gcv.TOUCHING,
        (0.5, 0): gcv.OVERLAPPING,
        (1, math.nextafter(1, 0)): gcv.TOUCHING,
        (math.nextafter(1, 0), 0): gcv.OVERLAPPING,
        (5, 1): gcv.TOUCHING,
        (0, 1.5): gcv.APART,
        (1e300, -1e300): gcv.APART,
        (-1.7e308, 1.7e308): gcv.APART,
    }
    for where, expected in places.items():
        assert scene.relation(BLOCK, where) is expected
    relations = scene.relation(SQUARE, np.array(list(places)))
    assert relations.dtype == np.int8
    assert relations.tolist() == list(places.values())
    assert scene.relation(BLOCK) is gcv.OVERLAPPING
    assert scene.relation(shapely.box(1, 0, 2, 1)) is gcv.TOUCHING
    assert scene.relation(BLOCK, NOWHERE).shape == (0,)
    assert scene.relation(BLOCK, list(places), threads=2).tolist() == list(places.values())


def test_positions_are_exact() -> None:
    scene = gcv.Scene()
    scene.add(SQUARE, (0.1, 0))
    # In floats, 0.1 + 1 == 1.1: exactly, that is more.
    block = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.5)]
    assert scene.relation(block, (1.1, 0)) is gcv.APART
    assert scene.relation(block, (math.nextafter(1.1, 0), 0)) is gcv.OVERLAPPING
    far = 2.0**60
    scene.move(2, (far, 0.25))
    assert scene.relation(block, (far, 1.25)) is gcv.TOUCHING
    assert scene.relation(block, (far, 0.25)) is gcv.OVERLAPPING


def test_distance() -> None:
    scene = row()
    assert scene.distance(BLOCK, (4.5, 3)) == gcv.Separation(
        distance=2.0,
        relation=gcv.APART,
        nearest=gcv.Contact(
            *(ContactKind.EDGE_VERTEX, 2, 0, 2.0),
            *((0.0, 1.0), (4.5, 1.0), (4.5, 3.0)),
            *(4, 0),
        ),
        id=4,
    )
    # Of two that are as near, that with the smaller id.
    assert scene.distance(BLOCK, (1, 2)).id == 2
    scene.move(2, (2, 4))
    assert scene.distance(BLOCK, (2, 2)).id == 2
    assert scene.distance(BLOCK, (4, 1)) == (0, gcv.TOUCHING, None, 4)
    assert scene.distance(BLOCK, (4.5, 0.5)) == (0, gcv.OVERLAPPING, None, 4)
    assert scene.distance(BLOCK, (3, 0)) == (0, gcv.TOUCHING, None, 3)


def test_the_relation_is_that_of_all() -> None:
    """Touching what has the smaller id, and overlapping another."""
    scene = gcv.Scene()
    scene.add(BLOCK, [(1, 0), (0, 0.5)])
    assert scene.distance(BLOCK) == (0, gcv.OVERLAPPING, None, 2)


def test_distance_of_many() -> None:
    scene = row()
    places = [(4.0, 3.0), (1.0, 2.0), (4.0, 1.0), (9.0, 4.0)]
    found = scene.distance(BLOCK, places)
    assert found.dtype == gcv.SEPARATION_DTYPE
    assert found["distance"].tolist() == [2, 1, 0, 5]
    assert found["relation"].tolist() == [1, 1, 0, 1]
    assert found["nearest"]["id_a"].tolist() == [4, 2, 4, 4]
    assert found["nearest"]["kind"].tolist() == [1, 1, 0, 3] or found["nearest"]["kind"][2] == 0
    assert [scene.distance(BLOCK, place).distance for place in places] == [2, 1, 0, 5]
    assert scene.distance(BLOCK, np.empty((0, 2))).shape == (0,)


def test_cast() -> None:
    scene = row()
    assert scene.cast(BLOCK, (4.5, 5), (0, -8)) == gcv.Impact(
        hit=True,
        relation=gcv.TOUCHING,
        time=0.5,
        position=(4.5, 1.0),
        contact=gcv.Contact(
            *(ContactKind.EDGE_VERTEX, 2, 0, 0.0),
            *((0.0, 1.0), (4.5, 1.0), (4.5, 1.0)),
            *(4, 0),
        ),
        id=4,
    )
    # It fits between two of them, and slides on.
    assert scene.cast(BLOCK, (1, 5), (0, -8)) == (False, gcv.APART, 1, (1, -3), None, 0)
    assert scene.cast(BLOCK, (1, 5), (0, -5)) == (False, gcv.TOUCHING, 1, (1, 0), None, 0)
    # Two are hit at a time.
    impact = scene.cast(SQUARE_2, (0.5, 5), (0, -8))
    assert (impact.time, impact.id) == (0.5, 2)
    assert scene.cast(BLOCK, (4, 0), (9, 9)) == (True, gcv.OVERLAPPING, 0, (4, 0), None, 4)


def test_cast_of_many() -> None:
    scene = row()
    starts = [(4.5, 5.0), (1.0, 5.0), (4.0, 0.0)]
    impacts = scene.cast(BLOCK, starts, (0, -8))
    assert impacts.dtype == gcv.IMPACT_DTYPE
    assert impacts["hit"].tolist() == [1, 0, 1]
    assert impacts["contact"]["id_a"].tolist() == [4, 0, 4]
    assert impacts["time"].tolist() == [scene.cast(BLOCK, s, (0, -8)).time for s in starts]
    turned = scene.cast(BLOCK, (1, 5), np.array([(0, -8), (1, -8), (9, 0)]))
    assert turned["hit"].tolist() == [0, 1, 0]
    assert scene.cast(BLOCK, NOWHERE, (0, 1)).shape == (0,)
    with pytest.raises(gcv.InputError, match=r"^positions has 3 pairs and motions has 2 pairs$"):
        scene.cast(BLOCK, starts, [(0, 0)] * 2)


def test_near() -> None:
    scene = row(box(-1, -1, 6, 6))
    near = scene.near(BLOCK, (3, 1), 1)
    assert isinstance(near, gcv.PairList)
    assert list(near) == [(3, 0, gcv.TOUCHING), (4, 0, gcv.TOUCHING)]
    assert list(scene.near(BLOCK, (0.5, 0.5))) == [(2, 0, gcv.OVERLAPPING)]
    # The container is one of them.
    assert list(scene.near(BLOCK, (5, 3), 2)) == [(1, 0, gcv.TOUCHING), (4, 0, gcv.APART)]
    assert list(scene.near(BLOCK, (5, 3), math.nextafter(2, 0))) == [(1, 0, gcv.TOUCHING)]
    assert not scene.near(BLOCK, (2.5, 2.5), 1)


def test_with_a_container() -> None:
    scene = row(box(-1, -1, 6, 6))
    assert scene.relation(BLOCK, [(2, 2), (5, 5), (5.5, 2), (20, 0)]).tolist() == [1, 0, -1, -1]
    assert scene.distance(BLOCK, (3, 4.5)) == gcv.Separation(
        *(0.5, gcv.APART),
        gcv.Contact(
            *(ContactKind.EDGE_VERTEX, 2, 2, 0.5),
            *((0.0, -1.0), (4.0, 6.0), (4.0, 5.5)),
            *(1, 0),
        ),
        1,
    )
    impact = scene.cast(BLOCK, (3, 3), (0, 4))
    assert impact[:4] == (True, gcv.TOUCHING, 0.5, (3, 5))
    assert impact.id == 1
    assert scene.distance(BLOCK, (9, 9)) == (0, gcv.OVERLAPPING, None, 1)


def test_layers() -> None:
    scene = row(box(-1, -1, 6, 6))
    scene.set_layers([2, 3, 4], [0b01, 0b10, 0b11])
    assert [scene.near(BLOCK, (2, 0), 9, layers=bits).array["a"].tolist() for bits in range(4)] == [
        *([], [1, 2, 4], [1, 3, 4], [1, 2, 3, 4]),
    ]
    assert scene.relation(BLOCK, (2, 0), layers=1) is gcv.APART
    assert scene.relation(BLOCK, (2, 0), layers=2) is gcv.OVERLAPPING
    assert scene.relation(BLOCK, (5.5, 0), layers=1 << 31) is gcv.OVERLAPPING
    assert scene.relation(BLOCK, (5.5, 0), layers=0) is gcv.APART
    assert scene.distance(BLOCK, (2, 0), layers=1) == scene.distance(BLOCK, (2, 0), ignore=3)
    assert scene.cast(BLOCK, (2, 5), (0, -9), layers=1).id == 1
    assert scene.cast(BLOCK, (2, 5), (0, -9), layers=2).id == 3
    scene.set_layers(np.array([2], "uint64"), np.array([4], "uint32"))
    assert scene.near(BLOCK, (2, 0), 9, layers=1).array["a"].tolist() == [1, 4]
    scene.set_layers(scene.ids, 2**32 - 1)
    assert scene.relation(BLOCK, (2, 0), layers=1) is gcv.OVERLAPPING
    scene.set_layers([2, 3], 0)
    assert scene.near(BLOCK, (2, 0), 9).array["a"].tolist() == [1, 4]
    assert scene.add(BLOCK, (0, 3)) == 5
    assert scene.near(BLOCK, (0, 3), 0, layers=1 << 17).array["a"].tolist() == [5]


def test_ignore() -> None:
    scene = row(box(-1, -1, 6, 6))
    assert scene.relation(BLOCK, (2, 0), ignore=3) is gcv.APART
    assert scene.relation(BLOCK, (2, 0), ignore=[2, 4]) is gcv.OVERLAPPING
    assert scene.relation(BLOCK, (2, 0), ignore=np.uint64(3)) is gcv.APART
    assert scene.relation(BLOCK, (9, 9), ignore=scene.ids) is gcv.OVERLAPPING
    assert scene.relation(BLOCK, (9, 9), ignore=1) is gcv.APART
    assert scene.relation(BLOCK, (2, 0), ignore=[3, 3, 77, 2**64 - 1, 0]) is gcv.APART
    # A member that moves does not block itself.
    assert scene.cast(scene.polygon(3), scene.positions(3), (9, 0), ignore=3).id == 4
    # With nothing there.
    everything = [*scene, 1]
    assert scene.distance(BLOCK, ignore=everything) == (math.inf, gcv.APART, None, 0)
    nothing = gcv.Scene().distance(BLOCK, [(0, 0)])
    assert nothing["distance"] == math.inf
    assert nothing["nearest"]["id_a"] == 0
    assert scene.cast(BLOCK, (0, 0), (1, 1), ignore=everything) == gcv.Impact(
        *(False, gcv.APART, 1, (1, 1), None, 0)
    )
    assert not scene.near(BLOCK, (0, 0), 1e9, ignore=everything)


QUESTIONS: list[Callable[..., object]] = [
    lambda scene, moving=BLOCK, position=(0, 0), **more: scene.relation(moving, position, **more),
    lambda scene, moving=BLOCK, position=(0, 0), **more: scene.distance(moving, position, **more),
    lambda scene, moving=BLOCK, position=(0, 0), **more: scene.near(moving, position, 1, **more),
    lambda scene, moving=BLOCK, position=(0, 0), **more: scene.cast(
        moving, position, (1, 1), **more
    ),
]


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"moving": BOW_TIE}, "moving: edges 0 and 2 meet"),
        ({"moving": None}, "moving: None is not a polygon"),
        ({"position": None}, "positions?: None is not a pair of numbers"),
        ({"position": (1, "2")}, r"positions?(: \(1, '2'\)|\[0\]: 1) is not a pair of numbers"),
        ({"position": (0, math.nan)}, r".*\bposition.*nan"),
        ({"position": (math.inf, 0)}, r".*\bposition.*inf"),
        ({"layers": -1}, "layers: -1 is not a number of 32 bits, one for each layer"),
        ({"layers": [1]}, r"layers: \[1\] is not a number of 32 bits, one for each layer"),
        ({"layers": "1"}, "layers.*: '1' is not a number of 32 bits"),
        ({"ignore": -2}, "ignore: -2 is not an id"),
        ({"ignore": None}, "ignore: None is not an id, nor a sequence of them"),
        ({"ignore": [2, 2.5]}, r"ignore\[1\]: 2.5 is not an id"),
        ({"threads": -1}, ".*threads"),
    ],
)
def test_refused(question: Callable[..., object], arguments: Any, message: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        question(row(), **arguments)


def test_a_position_is_refused_by_its_number() -> None:
    with pytest.raises(gcv.InputError, match=r"^positions\b.*\b1\b.*nan"):
        row().relation(BLOCK, [(0, 0), (math.nan, 0)])
    with pytest.raises(gcv.InputError, match=r"^motions\b.*\b1\b.*inf"):
        row().cast(BLOCK, (0, 0), [(0, 0), (0, math.inf)])


@pytest.mark.parametrize(
    ("distance", "message"),
    [
        (-1, ".*distance"),
        (-5e-324, ".*distance"),
        (math.nan, ".*nan"),
        (math.inf, ".*distance"),
        ("1", "distance: '1' is not a number"),
        (None, "distance: None is not a number"),
    ],
)
def test_refused_distances(distance: Any, message: str) -> None:
    scene = row()
    for call in (
        lambda: scene.near(BLOCK, (0, 0), distance),
        lambda: scene.pairs(distance),
        lambda: scene.contacts(distance),
    ):
        with pytest.raises(gcv.InputError, match=f"^{message}"):
            call()


def test_beyond_the_largest_float() -> None:
    scene = gcv.Scene()
    scene.add(HUGE, (-1.7e308, 0))
    assert scene.relation(HUGE, (1.7e308, 0)) is gcv.APART
    with pytest.raises(gcv.Error, match=r"^positions: number 1: ") as raised:
        scene.distance(HUGE, [(0, 0), (1.7e308, 0)])
    assert raised.value.status_name == "GCV_ERR_RANGE"
    assert scene.distance(HUGE, (-1.7e308, 1e308)) == (0, gcv.TOUCHING, None, 2)


def random_scene(seed: int, container: Any) -> tuple[gcv.Scene, dict[int, gcv.Polygon]]:
    """A scene of polygons at whole numbers, and its members where they are."""
    generator = np.random.default_rng(seed)
    shapes = [BLOCK, gcv.Polygon(TRIANGLE), gcv.Polygon(SQUARE_2), FRAME]
    shapes.append(gcv.Polygon(box(0, 0, 5, 4), [box(1, 1, 4, 3)]))
    chosen = [shapes[k] for k in generator.choice(len(shapes), 30, p=[0.3, 0.3, 0.2, 0.05, 0.15])]
    places = generator.integers(-30, 30, (30, 2)).astype(float)
    scene = gcv.Scene(container)
    ids = scene.add(chosen, places)
    scene.move(ids[::3], places[::3] + 3)
    places[::3] += 3
    scene.remove(ids[5:8])
    members = {
        id: polygon.translated(place) for id, polygon, place in zip(ids.tolist(), chosen, places)
    }
    return scene, {id: members[id] for id in scene}


MOVING = gcv.Polygon([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)])
POSITIONS = np.random.default_rng(9).integers(-35, 35, (400, 2)).astype(float)


@pytest.mark.parametrize("seed", range(3))
def test_as_pair_by_pair(seed: int) -> None:
    scene, members = random_scene(seed, None)
    single = {id: gcv.distance(member, MOVING, POSITIONS) for id, member in members.items()}
    relations = np.min([found["relation"] for found in single.values()], axis=0)
    assert (scene.relation(MOVING, POSITIONS) == relations).all()
    assert set(relations) == {-1, 0, 1}

    ids = np.array(list(members), "uint64")
    nearest = np.argmin([found["distance"] for found in single.values()], axis=0)
    expected = np.array([single[int(ids[k])][i] for i, k in enumerate(nearest)])
    expected["nearest"]["id_a"] = ids[nearest]
    expected["relation"] = relations
    assert (scene.distance(MOVING, POSITIONS, threads=2) == expected).all()

    motions = POSITIONS[::-1] - POSITIONS
    casts = {id: gcv.cast(member, MOVING, POSITIONS, motions) for id, member in members.items()}
    found = scene.cast(MOVING, POSITIONS, motions)
    first = np.argmin([c["time"] - 0.5 * (c["hit"] * (c["time"] == 1)) for c in casts.values()], 0)
    for i, k in enumerate(first):
        one = casts[int(ids[k])][i]
        assert found["hit"][i] == any(c["hit"][i] for c in casts.values())
        assert found["time"][i] == one["time"]
        if found["hit"][i]:
            assert found["contact"]["id_a"][i] == ids[k]
            for name in ("kind", "a", "b", "gap", "normal"):
                assert (found["contact"][name][i] == one["contact"][name]).all()
    assert (scene.relation(MOVING, found["position"]) == found["relation"]).all()

    for place in POSITIONS[:40]:
        for distance in (0, 1, 5):
            near = [
                (id, 0, answer.relation)
                for id, member in members.items()
                if (answer := gcv.distance(member, MOVING, tuple(place))).distance <= distance
            ]
            assert list(scene.near(MOVING, place, distance)) == near


@pytest.mark.parametrize("seed", range(2))
def test_containers_as_holes_of_frames(seed: int) -> None:
    """A container is as a plate round it, with a plug in each hole."""
    ring = [(-30, -30), (30, -30), (36, 0), (30, 30), (-30, 30), (-20, 0)]
    hole = [(0, 0), (6, 0), (6, 6)]
    scene, _ = random_scene(seed, gcv.Polygon(ring, [hole]))
    other, _ = random_scene(seed, None)
    other.add([gcv.Polygon(box(-200, -200, 200, 200), [ring]), gcv.Polygon(hole)])
    assert (scene.relation(MOVING, POSITIONS) == other.relation(MOVING, POSITIONS)).all()
    found, expected = (s.distance(MOVING, POSITIONS) for s in (scene, other))
    assert (found["distance"] == expected["distance"]).all()
    assert (found["nearest"]["gap"] == expected["nearest"]["gap"]).all()
    motions = 2 * (POSITIONS[::-1] - POSITIONS)
    found, expected = (s.cast(MOVING, POSITIONS, motions) for s in (scene, other))
    for name in ("hit", "time", "position", "relation"):
        assert (found[name] == expected[name]).all()
    assert 1 in found["contact"]["id_a"]


def test_options() -> None:
    scene = row()
    reports: list[tuple[int, int]] = []
    relations = scene.relation(
        *(BLOCK, POSITIONS),
        threads=2,
        progress=lambda *steps: reports.append(steps),
    )
    assert (relations == scene.relation(BLOCK, POSITIONS)).all()
    assert reports[-1] == (len(POSITIONS), len(POSITIONS))

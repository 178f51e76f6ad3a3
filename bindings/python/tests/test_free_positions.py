# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Free positions in a scene: the best one in a direction, and the nearest one."""

from __future__ import annotations

import math
import pickle
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any, Optional

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapes import BOW_TIE, DUMB_BELL, HUGE, NOWHERE, SQUARE, SQUARE_2, TRIANGLE, box, scaled, star
from test_distance import is_nearest_root
from test_free_regions import PEG, YARD, shelf
from test_penetration import squares
from test_properties import ExactPoint, polygons
from test_scene_questions import MOVING, POSITIONS, random_scene

import gcv
from gcv import ContactKind

SAME: list[Any] = [
    *(PEG, SQUARE_2, np.array(SQUARE_2), shapely.box(0, 0, 2, 2)),
    "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))",
]
DIRECTIONS = [(-1, 0), (1, 0), (0, 1), (0, -1), (1, 1), (3, -2), (-0.1, 0.7), (1e-300, 5e-324)]


def test_bottom_left() -> None:
    scene = gcv.Scene(box(0, 0, 5, 3))
    places: list[Any] = []
    while (position := scene.best(SQUARE, (-1, 0))) is not None:
        places.append(position)
        scene.add(SQUARE, position)
    assert places == [(x, y) for x in range(5) for y in range(3)]
    assert scene.best(SQUARE, (-1, 0), ignore=9) == (2, 1)
    assert scene.best(SQUARE, (1, 0), ignore=[9, 3]) == (2, 1)


@pytest.mark.parametrize("moving", SAME)
def test_best(moving: Any) -> None:
    scene = shelf()
    known = {(-1, 0): (0, 2), (1, 0): (8, 0), (0, 1): (0, 4), (0, -1): (2, 0), (1, 1): (8, 4)}
    for direction, expected in known.items():
        assert scene.best(moving, direction) == expected
        assert scene.best(moving, np.array(direction)) == expected
        assert scene.best(moving, (1e300 * direction[0], 1e300 * direction[1])) == expected
    assert scene.best(moving, (-1, 0), leave_out="fits") == (4, 2)
    position = scene.best(moving, (-1, 0))
    assert isinstance(position, tuple)
    assert [type(coordinate) for coordinate in position] == [float, float]


def test_best_layers_and_ignore() -> None:
    scene = shelf()
    scene.set_layers([2, 3, 4], [1, 2, 4])
    assert scene.best(PEG, (-1, 0), layers=1) == (0, 2)
    assert scene.best(PEG, (-1, 0), layers=2) == (0, 0)
    assert scene.best(PEG, (-1, 0), ignore=2) == (0, 0)
    scene.set_layers(2, 0)
    assert scene.best(PEG, (-1, 0)) == (0, 0)


def test_free_nowhere() -> None:
    scene = shelf()
    large = gcv.Polygon(box(0, 0, 5, 5))
    assert scene.best(large, (-1, 0)) is None
    assert scene.best(box(0, 0, 11, 1), (1, 0), ignore=[2, 3, 4]) is None
    scene.add(box(0, 0, 9, 6), (0.5, 0))
    assert scene.best(SQUARE, (0, 1)) is None
    slot = gcv.Scene(box(0, 0, 5, 2))
    assert slot.best(PEG, (1, 0)) == (3, 0)
    assert slot.best(PEG, (1, 0), leave_out="fits") is None
    escape = scene.penetration(large, (3, 3))
    assert escape == (math.inf, (0, 0), (3, 3), gcv.OVERLAPPING, None, 0)
    escapes = scene.penetration(large, [(3, 3), (-9, 1e300)])
    assert escapes["depth"].tolist() == [math.inf] * 2
    assert escapes["position"].tolist() == [[3, 3], [-9, 1e300]]
    assert escapes["contact"]["id_a"].tolist() == escapes["contact"]["kind"].tolist() == [0, 0]


def furthest(region: gcv.Region, direction: Any) -> Optional[ExactPoint]:
    """The best position by the exact region."""
    dx, dy = map(Fraction, direction)
    return min(region.exact, key=lambda p: (-(p[0] * dx + p[1] * dy), p), default=None)


def check_best(scene: gcv.Scene, moving: gcv.Polygon, leave_out: Any, **query: Any) -> None:
    region = scene.free_region(moving, leave_out=leave_out, **query)
    for direction in DIRECTIONS:
        position = scene.best(moving, direction, leave_out=leave_out, **query)
        expected = furthest(region, direction)
        assert (position is None) == (expected is None)
        if position is not None and expected is not None:
            if all(map(lies_near, position, expected)):
                continue
            # No position so near to the exact one is free.
            grid = [(x, y) for x in ulps(expected[0]) for y in ulps(expected[1])]
            assert (scene.relation(moving, grid, **query) == gcv.OVERLAPPING).all()
            assert scene.relation(moving, position, **query) is not gcv.OVERLAPPING


def lies_near(coordinate: float, exact: Fraction) -> bool:
    return coordinate in ulps(exact)


def ulps(exact: Fraction) -> list[float]:
    """The floats within 2 ulps."""
    near = float(exact)
    for _ in range(3):
        near = math.nextafter(near, -math.inf)
    found = []
    for _ in range(7):
        if abs(Fraction(near) - exact) <= 2 * Fraction(math.ulp(float(exact))):
            found.append(near)
        near = math.nextafter(near, math.inf)
    return found


@pytest.mark.parametrize("leave_out", [(), "fits"])
@pytest.mark.parametrize("seed", range(3))
def test_best_of_the_region(seed: int, leave_out: Any) -> None:
    scene, _ = random_scene(seed, gcv.Polygon(YARD, [[(0, 0), (6, 0), (6, 6)]]))
    for moving in (MOVING, PEG, gcv.Polygon(TRIANGLE), star(9, seed)):
        check_best(scene, moving, leave_out)
    check_best(scene, MOVING, leave_out, ignore=list(scene)[::2])


@given(
    polygons(),
    polygons(),
    st.lists(st.tuples(polygons(), st.tuples(*[st.integers(-30, 30)] * 2)), max_size=4),
)
def test_best_of_any(container: gcv.Polygon, moving: gcv.Polygon, members: list[Any]) -> None:
    scene = gcv.Scene(container.affine([[4, 0, 0], [0, 4, 0]]))
    for polygon, place in members:
        scene.add(polygon, place)
    check_best(scene, moving, ())


def test_own_places() -> None:
    """A part that is taken out of a puzzle goes back."""
    middle = [(2.0, 0.1), (3.3, 1.7), (1 / 3, 2.9), (-0.7, 1.1)]
    corners = box(-5, -4, 6, 7)
    parts = [gcv.Polygon(middle)] + [
        gcv.Polygon([corners[k], corners[(k + 1) % 4], middle[(k + 1) % 4], middle[k]])
        for k in range(4)
    ]
    scene = gcv.Scene(corners)
    scene.add(parts)
    for id, part in zip(scene, parts):
        for direction in DIRECTIONS:
            assert scene.best(part, direction, ignore=id) == (0, 0)
            assert scene.best(part, direction, ignore=id, leave_out="fits") is None
        escape = scene.penetration(part, (3, -4), ignore=id)
        assert (escape.depth, escape.position) == (5, (0, 0))
        assert escape.relation is gcv.TOUCHING
        assert escape.id == (1 if id > 2 else 3)
        assert scene.penetration(part, (3, -4)).depth == math.inf


def test_a_place_between_floats() -> None:
    """A key that fits at (1/3, 1/3) alone: there it touches, but at no float."""
    lock = [(0, 0), (1, 0), (2, -0.5), (3, -1), (2, 0), (1.5, 1), (1.5, 2), (1, 1)]
    key = gcv.Polygon([(0, 0), (2, -1), (1, 1)])
    scene = gcv.Scene(lock)
    assert scene.free_region(key).exact == [(Fraction(1, 3), Fraction(1, 3))]
    for direction in DIRECTIONS:
        assert scene.best(key, direction) == (1 / 3, 1 / 3)
        assert scene.best(key, direction, leave_out="fits") is None
    assert scene.relation(key, (1 / 3, 1 / 3)) is gcv.OVERLAPPING
    escape = scene.penetration(key, (1, 1))
    assert escape[2:4] == ((1 / 3, 1 / 3), gcv.OVERLAPPING)
    assert is_nearest_root(escape.depth, Fraction(8, 9))


# ------------------------------------------------------------------------- ways out -----


def test_way_out() -> None:
    scene = shelf()
    escape = scene.penetration(PEG, (4, 1.5))
    assert escape == gcv.Escape(
        depth=0.5,
        translation=(0, 0.5),
        position=(4, 2),
        relation=gcv.TOUCHING,
        contact=gcv.Contact(
            *(ContactKind.EDGE_VERTEX, 2, 0, 0.0),
            *((0.0, 1.0), (4.0, 2.0), (4.0, 2.0)),
            *(3, 0),
        ),
        id=3,
    )
    assert scene.penetration(PEG, (20, 1))[:4] == (12, (-12, 0), (8, 1), gcv.TOUCHING)
    assert scene.penetration(PEG, (20, 1)).id == 1
    # Into a place that it fits exactly, or not.
    assert scene.penetration(PEG, (2.25, 1)).translation == (-0.25, 0)
    assert scene.penetration(PEG, (2.25, 1), leave_out="fits").position == (4, 2)
    # Of several that are touched, the one with the smallest id.
    assert [scene.penetration(PEG, p).id for p in [(3, 1), (2, 0.5), (1, 0)]] == [2, 0, 1]
    for moving in SAME:
        assert scene.penetration(moving, (4, 1.5))[:4] == escape[:4]
    assert scene.penetration(PEG) == scene.penetration(PEG, (0, 0))


def test_free_already() -> None:
    scene = shelf()
    assert scene.penetration(PEG, (4, 2)) == (0, (0, 0), (4, 2), gcv.TOUCHING, None, 0)
    assert scene.penetration(PEG, (7, 3)) == (0, (0, 0), (7, 3), gcv.APART, None, 0)
    assert gcv.Scene().penetration(PEG, (9, 8)) == (0, (0, 0), (9, 8), gcv.APART, None, 0)
    assert scene.penetration(PEG, (4, 1), layers=0) == (0, (0, 0), (4, 1), gcv.APART, None, 0)


def test_penetration_of_many() -> None:
    scene = shelf()
    places = [(4.0, 1.5), (4.0, 2.0), (20.0, 1.0), (3.0, 1.0)]
    escapes = scene.penetration(PEG, places)
    assert escapes.dtype == gcv.ESCAPE_DTYPE
    assert escapes["depth"].tolist() == [0.5, 0, 12, 1]
    assert escapes["contact"]["id_a"].tolist() == [3, 0, 1, 2]
    assert escapes["position"].tolist() == [[4, 2], [4, 2], [8, 1], [2, 1]]
    for place, escape in zip(places, escapes):
        one = scene.penetration(PEG, place)
        assert (one.depth, one.relation) == (escape["depth"], escape["relation"])
        assert one.id == escape["contact"]["id_a"]
    assert scene.penetration(PEG, np.array(places), threads=2).tobytes() == escapes.tobytes()
    assert scene.penetration(PEG, NOWHERE).shape == (0,)
    reports: list[tuple[int, int]] = []
    told = scene.penetration(PEG, places, progress=lambda *steps: reports.append(steps))
    assert told.tobytes() == escapes.tobytes()
    assert reports[-1][0] == reports[-1][1] > 0


def test_one_member_is_one_of_two_polygons() -> None:
    fixed, moving = gcv.Polygon(DUMB_BELL, [box(1, 1, 3, 3)]), gcv.Polygon(SQUARE_2)
    scene = gcv.Scene()
    scene.add(SQUARE, (1e9, 0))
    id = scene.add(fixed)
    places = np.random.default_rng(5).uniform(-2, 10, (500, 2))
    places[::2] = places[::2].round(1)
    expected = gcv.penetration(fixed, moving, places)
    expected["contact"]["id_a"][expected["depth"] > 0] = id
    assert (scene.penetration(moving, places) == expected).all()


@pytest.mark.parametrize("seed", range(3))
def test_nearest_of_the_region(seed: int) -> None:
    scene, members = random_scene(seed, YARD)
    region = scene.free_region(MOVING)
    places = POSITIONS[:30]
    relations = scene.relation(MOVING, places)
    for place, relation in zip(places, relations):
        escape = scene.penetration(MOVING, tuple(place))
        assert (escape.depth == 0) == (relation != gcv.OVERLAPPING) == (escape.id == 0)
        if relation != gcv.OVERLAPPING:
            continue
        exact = Fraction(place[0]), Fraction(place[1])
        assert is_nearest_root(escape.depth, min(squares(region, exact)))
        assert escape.relation is scene.relation(MOVING, escape.position)
        assert np.allclose(place + escape.translation, escape.position, 1e-12, 1e-12)
        assert escape.contact is not None
        assert escape.contact.id_a == escape.id
        end = [Fraction(coordinate) - start for coordinate, start in zip(escape.position, exact)]
        if end[0] ** 2 + end[1] ** 2 == min(squares(region, exact)):
            near = scene.near(MOVING, escape.position).array
            assert escape.id == near["a"][near["relation"] == gcv.TOUCHING].min()
            assert escape.contact.on_a == escape.contact.on_b
        else:
            assert escape.id in (1, *members)


# ----------------------------------------------------------------------- both, refused ---


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"moving": BOW_TIE}, "moving: edges 0 and 2 meet"),
        ({"moving": None}, "moving: None is not a polygon"),
        ({"layers": -1}, "layers: -1 is not a number of 32 bits"),
        ({"ignore": [2, 2.5]}, r"ignore\[1\]: 2.5 is not an id"),
        ({"threads": -1}, ".*threads"),
        ({"leave_out": "holes"}, "options: leave_out has 'holes'; "),
        ({"leave_out": "fit"}, "leave_out is 'fit', none of "),
        ({"there": None}, "(direction|positions): None is not a pair of numbers"),
        ({"there": (1, "2")}, r".*(\(1, '2'\)|: 1) is not a pair of numbers"),
        ({"there": (0, math.nan)}, "(direction|positions): .*nan.*not (a )?finite"),
        ({"there": (math.inf, 0)}, "(direction|positions): .*inf.*not (a )?finite"),
    ],
)
def test_refused(arguments: Any, message: str) -> None:
    for question in (gcv.Scene.best, gcv.Scene.penetration):
        asked = {"moving": PEG, "there": (1, 0), **arguments}
        with pytest.raises(gcv.InputError, match=f"^{message}"):
            question(shelf(), asked.pop("moving"), asked.pop("there"), **asked)


def test_no_direction() -> None:
    for direction in ((0, 0), (-0.0, 0.0)):
        with pytest.raises(gcv.InputError, match=r"^direction is 0 0") as raised:
            shelf().best(PEG, direction)
        assert raised.value.status_name == "GCV_ERR_INVALID_ARGUMENT"
    wrong: Any = (1, 2, 3)
    with pytest.raises(gcv.InputError, match=r"^direction: \(1, 2, 3\) is not a pair"):
        shelf().best(PEG, wrong)


def test_best_takes_a_container() -> None:
    scene = gcv.Scene()
    scene.add(PEG)
    unbounded: list[tuple[gcv.Scene, Any]] = [
        *((scene, {}), (shelf(), {"ignore": 1}), (shelf(), {"layers": 0})),
    ]
    for asked, query in unbounded:
        with pytest.raises(gcv.InputError, match="no container") as raised:
            asked.best(PEG, (-1, 0), **query)
        assert raised.value.status_name == "GCV_ERR_INVALID_ARGUMENT"
    scene.container = box(-9, -9, 9, 9)
    assert scene.best(PEG, (-1, 0)) == (-9, -9)


def test_beyond_the_largest_float() -> None:
    scene = gcv.Scene(HUGE.translated((5e307, 0)))
    moving = scaled(SQUARE, 1e307).translated((-1.7e308, 0))
    for call in (lambda: scene.best(moving, (1, 0)), lambda: scene.penetration(moving)):
        with pytest.raises(gcv.Error) as raised:
            call()
        assert raised.value.status_name == "GCV_ERR_RANGE"


def test_options_of_best() -> None:
    scene, _ = random_scene(1, YARD)
    reports: list[tuple[int, int]] = []
    position = scene.best(MOVING, (2, 1), threads=2, progress=lambda *s: reports.append(s))
    assert position == scene.best(MOVING, (2, 1))
    assert reports[-1][0] == reports[-1][1]


def test_copies_and_threads() -> None:
    scene, _ = random_scene(2, YARD)
    again = pickle.loads(pickle.dumps(scene))
    directions = [(math.cos(k), math.sin(k)) for k in range(40)]
    expected = [scene.best(MOVING, direction) for direction in directions]
    for asked in (scene, scene.copy(), again):
        with ThreadPoolExecutor(3) as pool:
            assert list(pool.map(asked.best, [MOVING] * 40, directions)) == expected
        found = asked.penetration(MOVING, POSITIONS)
        assert found.tobytes() == scene.penetration(MOVING, POSITIONS, threads=2).tobytes()

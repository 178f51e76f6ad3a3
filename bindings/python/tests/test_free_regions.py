# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where a polygon is free in a scene."""

from __future__ import annotations

import math
import pickle
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapes import BOW_TIE, FRAME, HUGE, SQUARE, SQUARE_2, U_SHAPE, box, facts, pairs, scaled
from test_properties import ExactPoint, polygons
from test_scene_questions import MOVING, random_scene

import gcv

PEG = gcv.Polygon(SQUARE_2)
YARD = [(-30, -30), (30, -30), (36, 0), (30, 30), (-30, 30), (-20, 0)]
HALVES = [(x / 2, y / 2) for x in range(-80, 81, 2) for y in range(-81, 80, 2)]


def shelf() -> gcv.Scene:
    """A box of 10 x 6, and in it squares of 2 x 2, members 2, 3 and 4."""
    scene = gcv.Scene(box(0, 0, 10, 6))
    scene.add(PEG, [(0, 0), (4, 0), (2, 3)])
    return scene


def check(scene: gcv.Scene, moving: Any, region: gcv.Region, places: Any, **query: Any) -> None:
    """Overlapping is outside, touching on the boundary, apart is inside."""
    assert (region.locate(places) == scene.relation(moving, places, **query)).all()


def test_known() -> None:
    region = shelf().free_region(PEG)
    assert isinstance(region, gcv.Region)
    assert region.wkt == "MULTIPOLYGON (((4 2, 6 2, 6 0, 8 0, 8 4, 4 4, 4 2)))"
    assert region.segments.tolist() == [[[0, 2], [0, 4]], [[2, 0], [2, 1]]]
    assert region.owners.tolist()[:6] == [3, 3, 1, 1, 1, 4]
    assert region.owners.dtype == np.int64
    assert region.owners.tolist()[7::2] == [0, 0]
    assert region.sources[2] == (gcv.EDGE_TRANSLATED, 0, 1)
    assert (region.area, region.error_bound, len(region)) == (12, 0, 1)
    # Without members it is the inner fit.
    free = gcv.Scene(U_SHAPE).free_region(PEG)
    inner = gcv.inner_fit_region(U_SHAPE, PEG)
    assert free == inner
    assert free.sources == inner.sources
    assert set(free.owners.tolist()) == {0, 1}


def test_whatever_makes_a_polygon() -> None:
    scene = shelf()
    same: list[Any] = [
        *(SQUARE_2, np.array(SQUARE_2), shapely.box(0, 0, 2, 2)),
        "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))",
    ]
    for moving in same:
        assert scene.free_region(moving) == scene.free_region(PEG)


def test_nowhere() -> None:
    region = shelf().free_region(box(0, 0, 5, 5))
    assert not region
    assert region.owners.tolist() == []
    assert not shelf().free_region(box(0, 0, 11, 1), ignore=[2, 3, 4])
    assert not shelf().free_region(PEG, (0, 0, 1, 1))


def test_layers_and_ignore() -> None:
    scene = shelf()
    scene.set_layers([2, 3, 4], [1, 2, 4])
    one, others_ignored = scene.free_region(PEG, layers=2), scene.free_region(PEG, ignore=[2, 4])
    assert facts(one) == facts(others_ignored)
    assert one.wkt == "MULTIPOLYGON (((0 0, 2 0, 2 2, 6 2, 6 0, 8 0, 8 4, 0 4, 0 0)))"
    assert set(one.owners.tolist()) == {1, 3}
    assert scene.free_region(PEG, ignore=list(scene)).wkt == (
        "MULTIPOLYGON (((0 0, 8 0, 8 4, 0 4, 0 0)))"
    )
    everywhere = scene.free_region(PEG, (-5, -5, 5, 5), layers=0)
    assert everywhere.bounds == (-5, -5, 5, 5)
    assert everywhere.owners.tolist() == [0] * 4
    assert scene.free_region(PEG, (-9, 0, -4, 4), ignore=1).owners.tolist() == [0] * 4


def test_changes() -> None:
    """The answer is about the members as they are now."""
    scene = shelf()
    scene.remove([2, 3])
    assert scene.free_region(PEG).area == 32 - 12
    scene.move(4, (4, 2))
    assert scene.free_region(PEG).area == 16
    assert scene.free_region(PEG).segments.tolist() == [[[2, 0], [6, 0]], [[2, 4], [6, 4]]]
    scene.container = box(0, 0, 10, 4)
    assert scene.free_region(PEG).area == 8
    scene.set(4, box(0, 0, 6, 1), (0, 0))
    assert scene.free_region(PEG).wkt == "MULTIPOLYGON (((0 1, 6 1, 6 0, 8 0, 8 2, 0 2, 0 1)))"


@pytest.mark.parametrize("seed", range(4))
def test_as_relation(seed: int) -> None:
    scene, _ = random_scene(seed, gcv.Polygon(YARD, [[(0, 0), (6, 0), (6, 6)]]))
    for moving in (MOVING, PEG):
        region = scene.free_region(moving)
        check(scene, moving, region, HALVES)
        check(scene, moving, region, region.vertices)


@given(
    polygons(),
    polygons(),
    st.lists(st.tuples(polygons(), st.tuples(*[st.integers(-30, 30)] * 2)), max_size=4),
)
def test_properties(container: gcv.Polygon, moving: gcv.Polygon, members: list[Any]) -> None:
    scene = gcv.Scene(container.affine([[5, 0, 0], [0, 5, 0]]))
    for polygon, place in members:
        scene.add(polygon, place)
    region = scene.free_region(moving)
    places = [*HALVES[::7], *region.vertices.tolist()] if region else HALVES[::7]
    check(scene, moving, region, places)
    again = pickle.loads(pickle.dumps(scene)).free_region(moving)
    assert facts(again) == facts(region)


@pytest.mark.parametrize("seed", range(3))
def test_owners(seed: int) -> None:
    """Alone, the owner of an edge touches somewhere on it."""
    scene, members = random_scene(seed, YARD)
    region = scene.free_region(MOVING)
    told = set()
    for part in region.exact_parts:
        corners = region.exact[part.start : part.stop]
        owners = region.owners[part.start : part.stop].tolist()
        sources = region.sources[part.start : part.stop]
        for k, (owner, source) in enumerate(zip(owners, sources)):
            is_edge = part.kind <= gcv.PART_HOLE or (part.kind == gcv.PART_SEGMENT and k == 0)
            assert (owner != 0) == (source.kind != 0) == is_edge
            if is_edge:
                told.add(owner)
                places = exact_places(corners[k], corners[(k + 1) % len(corners)])
                others = [id for id in (1, *members) if id != owner]
                found = scene.relation(MOVING, places, ignore=others)
                assert not places or gcv.TOUCHING in found
    assert told <= {1, *members}
    assert len(told) > 10


def exact_places(start: ExactPoint, end: ExactPoint) -> list[tuple[float, float]]:
    """Those of the points that divide an edge in eight that are floats."""
    places = []
    for k in range(9):
        exact = [a + (b - a) * k / 8 for a, b in zip(start, end)]
        x, y = map(float, exact)
        if [Fraction(x), Fraction(y)] == exact:
            places.append((x, y))
    return places


def test_owners_in_floats() -> None:
    """Of edges that rounding has moved, by exact_indices."""
    scene = gcv.Scene(box(0, 0, 1, 1))
    third = scene.add([(0, 0), (1, 0), (0, 3)], (0.1, 0.2))
    region = scene.free_region([(0, 0), (0.3, 0), (0, 0.7)])
    owners = region.owners[region.exact_indices]
    assert len(owners) == len(region.vertices)
    assert set(owners.tolist()) <= {0, 1, third}


# ------------------------------------------------------------------------------ windows --


@pytest.mark.parametrize("window", [(-7, -9, 12, 5), (-40, -40, 40, 40), (3, -50, 4, 50)])
@pytest.mark.parametrize("seed", range(2))
def test_windows(seed: int, window: tuple[float, float, float, float]) -> None:
    scene, _ = random_scene(seed, YARD)
    whole, region = scene.free_region(MOVING), scene.free_region(MOVING, window)
    xmin, ymin, xmax, ymax = window
    places = np.array(HALVES)
    x, y = places.T
    inner = places[(xmin < x) & (x < xmax) & (ymin < y) & (y < ymax)]
    check(scene, MOVING, region, inner)
    assert (region.locate(inner) == whole.locate(inner)).all()
    beyond = places[(x < xmin) | (x > xmax) | (y < ymin) | (y > ymax)]
    assert (region.locate(beyond) == gcv.OUTSIDE).all()
    # On the border, all of the region is free.
    border = [(x, y / 2) for x in (xmin, xmax) for y in range(-80, 81)]
    border += [(x / 2, y) for y in (ymin, ymax) for x in range(-80, 81)]
    on_border = region.locate(border) == gcv.BOUNDARY
    assert (scene.relation(MOVING, border)[on_border] != gcv.OVERLAPPING).all()
    assert on_border.any() == (xmin > -30)
    edges = {(source.kind == 0, owner == 0) for source, owner in zip(region.sources, region.owners)}
    assert edges <= {(False, False), (True, True)}
    if window[0] == -40:
        assert facts(region)[:5] == facts(whole)[:5]


@pytest.mark.parametrize(
    "window",
    [
        (0, 0, 5, 5),
        [0, 0, 5.0, 5],
        np.array([0, 0, 5, 5]),
        np.array([0, 0, 5, 5], "float32"),
        iter([0, 0, 5, 5]),
        (Fraction(0), -0.0, np.float64(5), True * 5),
    ],
)
def test_a_window_is_four_numbers(window: Any) -> None:
    region = shelf().free_region(PEG, window)
    assert region.wkt == "MULTIPOLYGON (((4 2, 5 2, 5 4, 4 4, 4 2)))"
    assert region.segments.tolist() == [[[0, 2], [0, 4]], [[2, 0], [2, 1]]]
    assert region.owners.tolist()[:4] == [3, 0, 1, 4]


def test_fits_on_the_border_of_a_window() -> None:
    region = shelf().free_region(PEG, (0, 1, 2, 3))
    assert len(region) == 0
    assert region.segments.tolist() == [[[0, 2], [0, 3]]]
    assert region.points.tolist() == [[2, 1]]


def test_windows_without_a_container() -> None:
    scene = gcv.Scene()
    scene.add(FRAME, (0.5, 0))
    region = scene.free_region(SQUARE, (-3, -3, 13, 13))
    assert region.area == 16 * 16 - 11 * 11 + 7 * 7
    check(scene, SQUARE, region, [(1.5, 1), (0, 0), (1.75, 1.25), (-0.5, -1), (-2.5, 12.5)])
    far = scene.free_region(SQUARE, (1e300, -1e307, 1e307, 0))
    assert far.bounds == (1e300, -1e307, 1e307, 0)


@pytest.mark.parametrize(
    ("window", "status", "message"),
    [
        ((0, 0, 0, 1), "INVALID_ARGUMENT", "window: xmin is 0, not less than xmax, 0"),
        ((0, 2, 1, 1), "INVALID_ARGUMENT", "window: ymin is 2, not less than ymax, 1"),
        ((0, 0, math.inf, 1), "NOT_FINITE", "window: xmax is inf, not a finite number"),
        (np.array([0, math.nan, 1, 1]), "NOT_FINITE", "window: ymin is nan, not a finite number"),
        ((0, 0, 1), "INVALID_ARGUMENT", r"window: \(0, 0, 1\) is not four numbers"),
        (box(0, 0, 1, 1), "INVALID_ARGUMENT", r"window: \[.*\] is not four numbers"),
        (5, "INVALID_ARGUMENT", "window: 5 is not four numbers"),
        ("1234", "INVALID_ARGUMENT", "window: '1234' is not four numbers"),
        ((0, 0, 1, 10**400), "NOT_FINITE", "window: .* is not a number that a finite float can"),
    ],
)
def test_refused_windows(window: Any, status: str, message: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{message}") as raised:
        shelf().free_region(PEG, window)
    assert raised.value.status_name == f"GCV_ERR_{status}"


def test_neither_window_nor_container() -> None:
    scene = gcv.Scene()
    scene.add(PEG)
    unbounded: list[tuple[gcv.Scene, Any]] = [
        *((scene, {}), (shelf(), {"ignore": 1}), (shelf(), {"layers": 0})),
    ]
    for asked, query in unbounded:
        with pytest.raises(gcv.InputError, match=r"^window\b.*no container"):
            asked.free_region(PEG, **query)


# -------------------------------------------------------------------- exact fits, options --


def test_parts_of_a_puzzle() -> None:
    """Each part fits its own place exactly, and no place beside it."""
    middle = [(2.0, 0.1), (3.3, 1.7), (1 / 3, 2.9), (-0.7, 1.1)]
    corners = box(-5, -4, 6, 7)
    parts = [gcv.Polygon(middle)] + [
        gcv.Polygon([corners[k], corners[(k + 1) % 4], middle[(k + 1) % 4], middle[k]])
        for k in range(4)
    ]
    scene = gcv.Scene(corners)
    scene.add(parts, (0, 0))
    for id, part in zip(scene, parts):
        region = scene.free_region(part, ignore=id)
        assert region.locate((0, 0)) is gcv.BOUNDARY
        assert scene.relation(part, (0, 0), ignore=id) is gcv.TOUCHING
        for place in ((5e-324, 0), (0, -5e-324), (1e-9, 1e-9)):
            assert region.locate(place) is gcv.OUTSIDE
        assert not scene.free_region(part)
    region = scene.free_region(parts[0], ignore=2)
    assert region.points.tolist() == [[0, 0]]
    assert repr(region) == "<gcv.Region of 1 point>"
    assert region.owners.tolist() == [0]


def test_leave_out() -> None:
    region = shelf().free_region(PEG, leave_out="fits")
    assert repr(region) == "<gcv.Region of 1 polygon>"
    wrong: Any = "fit"
    with pytest.raises(ValueError, match=r"^leave_out is 'fit', none of "):
        shelf().free_region(PEG, leave_out=wrong)
    with pytest.raises(gcv.InputError, match=r"leave_out has 'holes'"):
        shelf().free_region(PEG, leave_out="holes")


def test_rounding() -> None:
    scene = gcv.Scene(box(0, 0, 1, 1))
    scene.add([(0, 0), (0.3, 0), (0, 0.7)], [(0.1, 0.2), (0.6, 0.3)])
    moving = gcv.Polygon([(0, 0), (0.1, 0), (0, 0.1)])
    nearest, outward = (scene.free_region(moving, rounding=r) for r in ("nearest", "outward"))
    assert nearest.exact == outward.exact
    assert nearest.vertices.tolist() != outward.vertices.tolist()
    assert (scene.relation(moving, outward.vertices) != gcv.OVERLAPPING).all()
    assert (scene.relation(moving, nearest.vertices) == gcv.OVERLAPPING).any()
    wrong: Any = "up"
    with pytest.raises(ValueError, match=r"^rounding is 'up', none of "):
        scene.free_region(moving, rounding=wrong)


def test_options() -> None:
    scene, _ = random_scene(1, YARD)
    plain = scene.free_region(MOVING)
    reports: list[tuple[int, int]] = []
    region = scene.free_region(MOVING, threads=2, progress=lambda *steps: reports.append(steps))
    assert facts(region) == facts(plain)
    assert reports[-1][0] == reports[-1][1]
    with pytest.raises(gcv.InputError, match="threads"):
        scene.free_region(MOVING, threads=-1)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"moving": BOW_TIE}, "moving: edges 0 and 2 meet"),
        ({"moving": None}, "moving: None is not a polygon"),
        ({"layers": -1}, "layers: -1 is not a number of 32 bits"),
        ({"ignore": [2, 2.5]}, r"ignore\[1\]: 2.5 is not an id"),
    ],
)
def test_refused(arguments: Any, message: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        shelf().free_region(**{"moving": PEG, **arguments})


def test_beyond_the_largest_float() -> None:
    scene = gcv.Scene(HUGE.translated((5e307, 0)))
    with pytest.raises(gcv.Error) as raised:
        scene.free_region(scaled(SQUARE, 1e307).translated((-1.7e308, 0)))
    assert raised.value.status_name == "GCV_ERR_RANGE"


# ----------------------------------------------------------------------- copies, pickles --


def test_copies_and_pickles() -> None:
    scene, _ = random_scene(2, YARD)
    scene.set_layers([2, 3, 4, 12], [1, 2, 3, 0])
    region = scene.free_region(MOVING, layers=1)
    for other in (scene.copy(), pickle.loads(pickle.dumps(scene))):
        assert facts(other.free_region(MOVING, layers=1)) == facts(region)
    again = pickle.loads(pickle.dumps(region))
    assert facts(again) == facts(region)
    assert again.locate(HALVES[::50]).tolist() == region.locate(HALVES[::50]).tolist()


def test_regions_outlive_the_scene() -> None:
    scene = shelf()
    region = scene.free_region(PEG)
    scene.remove(scene.ids)
    del scene
    assert region.owners.tolist()[:6] == [3, 3, 1, 1, 1, 4]
    assert pairs(region.vertices)[:2] == [(4, 2), (6, 2)]

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What Python asks of all objects: weak references, equality, pickles of subclasses."""

from __future__ import annotations

import copy
import gc
import pickle
import subprocess
import sys
import weakref
from typing import Any, Callable

import pytest
from shapes import NOTCHED, ROOMS, SQUARE, SQUARE_2, TRIANGLE

import gcv


class Part(gcv.Polygon):
    """A polygon with a name."""

    name = "no name"


class SlottedPart(gcv.Polygon):
    __slots__ = ()


def scene() -> gcv.Scene:
    made = gcv.Scene(ROOMS)
    made.add(SQUARE, [(1, 1), (2, 1)])
    return made


@pytest.mark.parametrize("kind", [gcv.OuterFace, gcv.Region, gcv.PairList, gcv.ContactList])
@pytest.mark.parametrize("handle", [(), (5,), (b"abcdefgh",), (None,), (SQUARE,)])
def test_results_are_returned_alone(
    kind: Callable[..., object], handle: tuple[object, ...]
) -> None:
    with pytest.raises(TypeError, match=f"no {kind.__name__} can be made by itself"):
        kind(*handle)


@pytest.mark.parametrize("previous", [(), (5,), (b"abcdefgh",)])
def test_contacts_have_their_indices(previous: tuple[object, ...]) -> None:
    with pytest.raises(TypeError, match="can be made by itself"):
        gcv.ContactList(b"", *previous)


@pytest.mark.parametrize(
    "make",
    [
        lambda: gcv.Polygon(SQUARE),
        lambda: gcv.minkowski_sum(SQUARE, TRIANGLE),
        lambda: gcv.no_fit_region(ROOMS, SQUARE_2),
        scene,
        lambda: gcv.contacts(SQUARE, SQUARE, (1, 0)),
        lambda: scene().pairs(),
        lambda: gcv.Polygon.many([SQUARE]),
    ],
)
def test_weak_references(make: Callable[[], Any]) -> None:
    made = make()
    reference = weakref.ref(made)
    assert reference() is made
    del made
    gc.collect()
    assert reference() is None


def test_region_polygons() -> None:
    one, same = (gcv.no_fit_region(ROOMS, SQUARE_2).polygons[0] for _ in range(2))
    other = gcv.no_fit_region(ROOMS, SQUARE).polygons[0]
    assert one.holes
    assert one == same
    assert (one != same) is False
    assert one != other
    assert (one == other) is False
    assert one != one._replace(holes=[])
    assert one != 5
    assert len({one, same, other}) == 2
    assert one in [other, same]
    assert pickle.loads(pickle.dumps(one)) == one


def test_region_polygons_without_numpy() -> None:
    code = """
import sys
sys.modules["numpy"] = None
import gcv
one, same = (gcv.minkowski_sum_region([(0, 0), (1, 0), (0, 1)], [(0, 0), (1, 0), (0, 1)]).polygons
             for _ in range(2))
print(one == same, one != same, len({*one, *same}))
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "True False 1\n"


def test_lists_of_results_are_the_callers() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE)
    for result in (region, gcv.no_fit_polygon(ROOMS, SQUARE)):
        for name in ("exact", "sources", "parts", "exact_parts"):
            made = getattr(result, name, None)
            if made is not None:
                again = made.copy()
                made.clear()
                assert getattr(result, name) == again != []
    assert len(region) == len(list(region)) == len(region.polygons) > 0
    assert [region.polygon(k) for k in range(len(region))] == list(region)


@pytest.mark.parametrize("change", [lambda of: of, lambda of: pickle.loads(pickle.dumps(of))])
def test_arrays_of_rings_are_made_once(change: Callable[[Any], Any]) -> None:
    polygon, region = change(ROOMS), change(gcv.no_fit_region(ROOMS, SQUARE))
    asks: list[Callable[[], list[Any]]] = [
        lambda: polygon.rings,
        lambda: polygon.holes,
        lambda: [region.polygons[0].outer],
        lambda: region.polygons[0].holes,
    ]
    for ask in asks:
        made = ask()
        for ring, same in zip(made, ask()):
            assert ring is same
            with pytest.raises(ValueError, match="WRITEABLE"):
                ring.flags.writeable = True
        made.clear()
        assert len(ask()) > 0
    region.polygons.clear()
    assert len(region.polygons) > 0


def test_pickles_of_subclasses() -> None:
    part = Part([(9, 9), *NOTCHED[1:]])
    part.name = "bracket"
    moved = part.translated((1, 0.1))
    for one in (part, moved, SlottedPart(NOTCHED)):
        again = pickle.loads(pickle.dumps(one))
        assert type(again) is type(one)
        assert again == one
        assert getattr(again, "name", "") == getattr(one, "name", "")
        assert copy.deepcopy(one) is one
    assert gcv.contacts(pickle.loads(pickle.dumps(moved)), SQUARE, (1, 1), 9) == gcv.contacts(
        moved, SQUARE, (1, 1), 9
    )
    assert type(pickle.loads(pickle.dumps(gcv.Polygon(part)))) is gcv.Polygon


@pytest.mark.parametrize("ask", [gcv.inner_fit_region, gcv.Scene.free_region])
def test_what_cannot_be_left_out_has_its_name_in_python(ask: Callable[..., object]) -> None:
    first = ROOMS if ask is gcv.inner_fit_region else gcv.Scene(ROOMS)
    with pytest.raises(gcv.InputError, match=r"^options: leave_out has 'holes'; \w+ \w+ have all"):
        ask(first, SQUARE, leave_out="holes")


@pytest.mark.parametrize("name", ["__init__", "add", "relation", "penetration", "best", "near"])
def test_messages_name_methods_of_scenes(name: str) -> None:
    method = getattr(gcv.Scene, name)
    assert method.__qualname__ == f"Scene.{name}"
    assert pickle.loads(pickle.dumps(method)) is method

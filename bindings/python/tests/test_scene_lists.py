# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The pairs and the contacts of a scene."""

from __future__ import annotations

import copy
import math
import pickle
import tracemalloc
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from shapes import SQUARE, box
from test_scene_questions import BLOCK, random_scene, row

import gcv
from gcv import ContactKind

Key = tuple[int, int, int, int, int]


def key(contact: gcv.Contact) -> Key:
    return contact.id_a, contact.id_b, contact.kind, contact.a, contact.b


def test_pairs() -> None:
    scene = row()
    assert list(scene.pairs()) == []
    assert list(scene.pairs(1)) == [(2, 3, gcv.APART), (3, 4, gcv.APART)]
    assert list(scene.pairs(math.nextafter(1, 0))) == []
    scene.move(3, (1, 0))
    scene.move(4, (1.5, 0.5))
    assert list(scene.pairs()) == [
        *((2, 3, gcv.TOUCHING), (3, 4, gcv.OVERLAPPING)),
    ]
    assert [pair[:2] for pair in scene.pairs(3)] == [(2, 3), (2, 4), (3, 4)]
    scene.container = box(0, 0, 9, 9)
    first, second, third, *_ = scene.pairs()
    assert first == gcv.Pair(a=1, b=2, relation=gcv.TOUCHING)
    assert second == (1, 3, gcv.TOUCHING)
    assert third == (2, 3, gcv.TOUCHING)
    assert first.relation is gcv.TOUCHING
    assert list(gcv.Scene().pairs(9)) == []


def test_pairs_of_some() -> None:
    scene = row(box(-1, -1, 6, 6))
    assert [pair[:2] for pair in scene.pairs(1)] == [(1, 2), (1, 3), (1, 4), (2, 3), (3, 4)]
    assert [pair[:2] for pair in scene.pairs(1, ignore=[1, 2])] == [(3, 4)]
    scene.set_layers(4, 2)
    assert [pair[:2] for pair in scene.pairs(1, layers=1)] == [(1, 2), (1, 3), (2, 3)]
    assert not scene.pairs(1, layers=0)


def test_list_of_pairs() -> None:
    scene = row()
    pairs = scene.pairs(1)
    assert repr(pairs) == "<gcv.PairList of 2 pairs>"
    assert repr(scene.pairs(1, ignore=2)) == "<gcv.PairList of 1 pair>"
    first, second = pairs
    assert pairs[0] == first
    assert pairs[1:] == (second,)
    assert (3, 4, gcv.APART) in pairs
    with pytest.raises(IndexError):
        pairs[2]
    assert pairs == scene.pairs(1.5) != scene.pairs(1, ignore=2)
    assert pairs != [first, second]
    assert pairs != scene.contacts(1)
    assert len({pairs, scene.pairs(1)}) == 1
    assert copy.copy(pairs) is copy.deepcopy(pairs) is pairs
    assert pickle.loads(pickle.dumps(pairs)) == pairs
    array = pairs.array
    assert array.dtype == gcv.PAIR_DTYPE
    assert array[["a", "b", "relation"]].tolist() == [(2, 3, 1), (3, 4, 1)]
    assert not array.flags.writeable
    assert np.shares_memory(array, pairs.array)
    assert scene.pairs().array.shape == (0,)
    assert scene.pairs().array.dtype == gcv.PAIR_DTYPE


@pytest.mark.parametrize("seed", range(3))
def test_pairs_as_pair_by_pair(seed: int) -> None:
    scene, members = random_scene(seed, None)
    for distance in (0, 1, 4.5):
        expected = [
            (a, b, answer.relation)
            for a, b in combinations(members, 2)
            if (answer := gcv.distance(members[a], members[b])).distance <= distance
        ]
        assert list(scene.pairs(distance)) == expected
        assert list(scene.pairs(distance, threads=2)) == expected


def test_contacts() -> None:
    scene = gcv.Scene()
    peak = [(0.0, 1.0), (0.5, 0.0), (1.0, 1.0)]
    scene.add([SQUARE, peak], [(3, 0), (3, 1)])
    (contact,) = scene.contacts()
    assert contact == gcv.Contact(
        *(ContactKind.EDGE_VERTEX, 2, 1, 0.0),
        *((0.0, 1.0), (3.5, 1.0), (3.5, 1.0)),
        *(2, 3),
    )
    assert isinstance(scene.contacts(), gcv.ContactList)
    assert scene.contacts().array["id_b"].tolist() == [3]
    assert not scene.contacts(ignore=2)
    scene.container = box(3, 0, 9, 9)
    assert {contact[-2:] for contact in scene.contacts()} == {(1, 2), (1, 3), (2, 3)}
    assert {contact[-2:] for contact in scene.contacts(ignore=3)} == {(1, 2)}
    assert not scene.contacts(layers=0)


@pytest.mark.parametrize("seed", range(3))
def test_contacts_as_pair_by_pair(seed: int) -> None:
    scene, members = random_scene(seed, None)
    for distance, slope in ((0, 0), (1.5, 0), (1, 0.25)):
        expected = [
            contact._replace(id_a=a, id_b=b)
            for a, b in combinations(members, 2)
            for contact in gcv.contacts(members[a], members[b], (0, 0), distance, slope)
        ]
        found = scene.contacts(distance, slope)
        assert sorted(found, key=key) == sorted(expected, key=key)
        order = [(abs(contact.gap), *key(contact)) for contact in found]
        assert order == sorted(order)
        assert len(set(map(key, found))) == len(found) > 0
        assert found == scene.contacts(distance, slope, threads=2)
        assert set(found.previous) == {None}


def test_previous_pairs() -> None:
    scene, _ = random_scene(1, box(-40, -40, 40, 40))
    pairs = scene.pairs(2)
    assert scene.pairs(2, pairs) == pairs
    scene.move(scene.ids[:5], scene.positions(scene.ids[:5]) + 1)
    scene.remove(scene.ids[-1])
    scene.add(BLOCK, [(0, 0), (0, 1)])
    expected = scene.pairs(2)
    assert expected != pairs
    assert scene.pairs(2, pairs) == expected
    # Of another distance, other layers, or of a copy, it is of less use, but none is wrong.
    assert scene.pairs(3, pairs) == scene.pairs(3)
    assert scene.pairs(0, pairs, ignore=2) == scene.pairs(ignore=2)
    other = scene.copy()
    other.move(other.ids[0], (0, 0))
    assert other.pairs(2, pairs) == other.pairs(2)
    assert scene.pairs(2, other.pairs(2)) == expected
    other.container = None
    assert other.pairs(2, pairs) == other.pairs(2)


def test_previous_contacts() -> None:
    scene = row()
    before = scene.contacts(1)
    assert before.previous == (None,) * len(before)
    assert scene.contacts(1, previous=before).previous == tuple(range(len(before)))
    scene.move(4, (4, 0.25))
    scene.add(BLOCK, (6, 0))
    after = scene.contacts(1, 0, before)
    assert list(after) == list(scene.contacts(1))
    numbers = {key(contact): k for k, contact in enumerate(before)}
    assert after.previous == tuple(numbers.get(key(contact)) for contact in after)
    assert None in after.previous
    assert set(after.previous) != {None}
    again = pickle.loads(pickle.dumps(after))
    assert again == after
    assert again.previous == after.previous
    assert after != scene.contacts(1)


def test_lists_that_are_passed_on_are_not_copied() -> None:
    scene = gcv.Scene()
    scene.add(SQUARE, [(k % 40, k // 40) for k in range(1600)])
    before = scene.pairs(), scene.contacts()
    tracemalloc.start()
    try:
        pairs, contacts = scene.pairs(0, before[0]), scene.contacts(0, 0, before[1])
        assert [len(pairs), len(contacts)] == [len(one) for one in before]
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < min(pairs.array.nbytes, contacts.array.nbytes) / 4
    assert (pairs, list(contacts)) == (before[0], list(before[1]))


@pytest.mark.parametrize("first", [len, list, hash, pickle.dumps, repr, np.asarray])
def test_lists_are_the_same_whatever_is_asked_first(first: Callable[[Any], object]) -> None:
    scene = row()
    for ask in (scene.pairs, scene.contacts):
        found: Any = ask(1)
        first(found)
        assert found == ask(1)
        assert pickle.loads(pickle.dumps(found)) == found
        assert hash(found) == hash(ask(1))
        assert len(found) == len(list(found)) == len(found.array) > 0
        with pytest.raises(ValueError, match="WRITEABLE"):
            found.array.flags.writeable = True
    array = scene.contacts(1).array
    assert array.tobytes() == scene.contacts(1).array.tobytes()


def test_threads_read_one_list() -> None:
    contacts = gcv.contacts(SQUARE, SQUARE, (1, 0), 9)
    with ThreadPoolExecutor(8) as threads:
        read = list(threads.map(lambda _: (list(contacts), contacts.previous), range(64)))
    assert all(one == read[0] for one in read)


def test_previous_contacts_of_other_questions() -> None:
    """Of another distance or slope, or of other layers, a list still tells what was there."""
    scene, _ = random_scene(2, box(-40, -40, 40, 40))
    questions: list[dict[str, Any]] = [
        *({"distance": 1}, {"distance": 2}, {"distance": 1, "slope": 0.25}),
        *({"distance": 1, "ignore": [1, 5]}, {"distance": 1, "layers": 0}, {}),
    ]
    lists = [scene.contacts(**question) for question in questions]
    for before in lists:
        numbers = {key(contact): k for k, contact in enumerate(before)}
        for question, expected in zip(questions, lists):
            found = scene.contacts(previous=before, **question)
            assert list(found) == list(expected)
            assert found.previous == tuple(numbers.get(key(contact)) for contact in found)


def test_lists_that_are_refused() -> None:
    scene, other = row(), row()
    pairs, contacts = scene.pairs(1), scene.contacts(1)
    wrong: list[tuple[Any, Any, str]] = [
        (other.pairs(1), other.contacts(1), ".*"),
        (
            *(pickle.loads(pickle.dumps(pairs)), pickle.loads(pickle.dumps(contacts))),
            "previous: .* is not the list of a scene: it was pickled$",
        ),
        (contacts, pairs, r"previous: <gcv.\w+ of \d pairs|contacts> is not a gcv\.\w+List$"),
        (list(pairs), list(contacts), r"previous: .* is not a gcv\.\w+List$"),
    ]
    for previous, previous_contacts, message in wrong:
        with pytest.raises(gcv.InputError, match=f"^{message}") as raised:
            scene.pairs(1, previous)
        assert raised.value.status_name == "GCV_ERR_INVALID_ARGUMENT"
        with pytest.raises(gcv.InputError, match=f"^{message}"):
            scene.contacts(1, previous=previous_contacts)
    with pytest.raises(gcv.InputError):
        scene.contacts(1, previous=gcv.contacts(BLOCK, BLOCK, (1, 0)))
    with pytest.raises(gcv.InputError, match=r"^previous "):
        scene.pairs(1, scene.near(BLOCK, (1, 0), 1))
    again = pickle.loads(pickle.dumps(scene))
    with pytest.raises(gcv.InputError, match=r"^previous "):
        again.pairs(1, pairs)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0, -1), ".*slope"),
        ((0, math.nan), ".*slope"),
        ((0, "1"), "slope: '1' is not a number"),
    ],
)
def test_refused_slopes(arguments: Any, message: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{message}"):
        row().contacts(*arguments)


def test_lists_outlive_their_scene() -> None:
    scene = row()
    pairs, contacts = scene.pairs(1), scene.contacts(1)
    del scene
    assert len(pairs) == 2
    assert contacts.array["id_a"].min() == 2


@pytest.mark.parametrize("found", [row().pairs(1), row().contacts(1), row().pairs()])
def test_numpy_has_the_array(found: Any) -> None:
    for made in (np.asarray(found), np.array(found), np.asarray(found, found.array.dtype)):
        assert made.dtype == found.array.dtype
        assert made.tobytes() == found.array.tobytes()
    assert len(np.asarray(found, object)) == len(found)
    assert np.array(found).flags.writeable
    assert not np.asarray(found).flags.writeable

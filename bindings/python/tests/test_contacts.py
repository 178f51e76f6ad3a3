# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""All contacts of two polygons."""

from __future__ import annotations

import copy
import math
import pickle
from typing import Any

import numpy as np
import pytest
from shapes import BOW_TIE, FRAME, SQUARE, SQUARE_2, TRIANGLE, box

import gcv
from gcv import ContactKind

PEAK = [(0.0, 1.0), (0.5, 0.0), (1.0, 1.0)]


def keys(contacts: gcv.ContactList) -> list[tuple[ContactKind, int, int]]:
    return [contact[:3] for contact in contacts]


def test_a_vertex_on_an_edge() -> None:
    (contact,) = gcv.contacts(SQUARE, PEAK, (0, 1))
    assert contact == gcv.Contact(
        *(ContactKind.EDGE_VERTEX, 2, 1, 0.0),
        *((0.0, 1.0), (0.5, 1.0), (0.5, 1.0)),
    )
    (contact,) = gcv.contacts(PEAK, SQUARE, (0, -1))
    assert contact == gcv.Contact(
        *(ContactKind.VERTEX_EDGE, 1, 2, 0.0),
        *((0.0, -1.0), (0.5, 0.0), (0.5, 0.0)),
    )
    assert contact.kind is ContactKind.VERTEX_EDGE


def test_gap() -> None:
    assert len(gcv.contacts(SQUARE, PEAK, (0, 1.5), 0.25)) == 0
    for height, distance in ((1.5, 0.5), (0.75, 0.25), (1.5, 3)):
        first = gcv.contacts(SQUARE, PEAK, (0, height), distance)[0]
        assert first.gap == height - 1
        assert first[:3] == (ContactKind.EDGE_VERTEX, 2, 1)
        assert first.normal == (0, 1)


def test_parallel_edges() -> None:
    # Side 2 of the lower square and side 0 of the upper one share the part from 0.5 to 1.
    contacts = gcv.contacts(SQUARE, SQUARE, (0.5, 1))
    assert keys(contacts) == [(ContactKind.EDGE_VERTEX, 2, 0), (ContactKind.VERTEX_EDGE, 2, 0)]
    for contact, x in zip(contacts, (0.5, 1.0)):
        assert contact[3:] == (0, (0, 1), (x, 1), (x, 1), 0, 0)


def test_sides_parallel_but_for_rounding() -> None:
    tilted = [(0.0, 0.0), (1.0, 2**-52), (1.0, 1.0), (0.0, 1.0)]
    move = (0, 1)
    assert len(gcv.contacts(SQUARE, tilted, move, distance=1e-9)) < len(
        gcv.contacts(SQUARE, tilted, move, distance=1e-9, slope=1e-9)
    )


def test_two_vertices() -> None:
    contacts = gcv.contacts(SQUARE, SQUARE, (2, 2), math.sqrt(2))
    assert (ContactKind.VERTEX_VERTEX, 2, 0) in keys(contacts)
    contact = next(c for c in contacts if c.kind is ContactKind.VERTEX_VERTEX)
    assert contact.gap == math.sqrt(2)
    assert np.allclose(contact.normal, math.sqrt(0.5))
    contacts = gcv.contacts(SQUARE, SQUARE, (1, 1))
    contact = next(c for c in contacts if c.kind is ContactKind.VERTEX_VERTEX)
    assert contact[1:] == (2, 0, 0, (0, 0), (1, 1), (1, 1), 0, 0)


def test_holes() -> None:
    contacts = gcv.contacts(FRAME, SQUARE_2, (1, 1))
    assert contacts
    assert {contact.gap for contact in contacts} == {0}
    # Numbers run on through the rings as passed.
    assert all(contact.a >= 4 for contact in contacts)


def test_numbers_are_those_of_the_points_as_passed() -> None:
    outer = [(0, 0), (5, 0), (10, 0), (10, 10), (0, 10), (0, 0)]
    hole = [(8, 8), (8, 5), (8, 2), (8, 2), (2, 2), (2, 8)]
    points = [*outer, *hole]
    plate = gcv.Polygon(outer, [hole])
    corners = gcv.contacts(plate, SQUARE, (10, 10))
    assert {points[c.a] for c in corners if c.kind is ContactKind.VERTEX_VERTEX} == {(10, 10)}
    contacts = gcv.contacts(plate, box(0, 0, 6, 6), (2, 2))
    assert {(c.a, points[c.a]) for c in contacts if c.kind is ContactKind.EDGE_VERTEX} == {
        *((6, (8, 8)), (9, (8, 2)), (10, (2, 2)), (11, (2, 8)))
    }
    assert len(plate.vertices) + len(plate.holes[0]) == 8


def test_order() -> None:
    contacts = gcv.contacts(SQUARE, TRIANGLE, (0.25, 1.125), 2)
    order = [(abs(contact.gap), *contact[:3]) for contact in contacts]
    assert order == sorted(order)
    assert len(set(keys(contacts))) == len(contacts)
    nearest = gcv.distance(SQUARE, TRIANGLE, (0.25, 1.125))
    assert contacts[0].gap == nearest.distance == 0.125


def test_list() -> None:
    contacts = gcv.contacts(SQUARE, SQUARE, (0.5, 1))
    assert isinstance(contacts, gcv.ContactList)
    assert repr(contacts) == "<gcv.ContactList of 2 contacts>"
    assert repr(gcv.contacts(SQUARE, PEAK, (0, 1))) == "<gcv.ContactList of 1 contact>"
    first, second = contacts
    assert contacts[0] == first
    assert contacts[-1] == second
    assert contacts[:] == (first, second)
    assert list(reversed(contacts)) == [second, first]
    assert first in contacts
    with pytest.raises(IndexError):
        contacts[2]
    same = gcv.contacts(gcv.Polygon(SQUARE), SQUARE, np.array([0.5, 1]))
    assert same == contacts != gcv.contacts(SQUARE, SQUARE, (0.25, 1))
    assert contacts != [first, second]
    assert len({same, contacts}) == 1
    for copied in (copy.copy(contacts), copy.deepcopy(contacts)):
        assert copied is contacts
    assert pickle.loads(pickle.dumps(contacts)) == contacts
    assert contacts.previous == (None, None)
    with pytest.raises(AttributeError):
        first.gap = 1  # type: ignore[misc]


def test_array() -> None:
    contacts = gcv.contacts(SQUARE, SQUARE, (0.5, 1))
    array = contacts.array
    assert array.dtype == gcv.CONTACT_DTYPE
    assert array["kind"].tolist() == [1, 2]
    assert array["on_b"].tolist() == [[0.5, 1], [1, 1]]
    assert array["id_a"].tolist() == [0, 0]
    assert not array.flags.writeable
    assert np.shares_memory(array, contacts.array)


def test_none() -> None:
    contacts = gcv.contacts(SQUARE, SQUARE, (5, 5))
    assert not contacts
    assert list(contacts) == []
    assert contacts.array.shape == (0,)
    assert contacts.array.dtype == gcv.CONTACT_DTYPE
    assert repr(contacts) == "<gcv.ContactList of 0 contacts>"


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (((1, None),), r"translation: \(1, None\) is not a pair of numbers"),
        (([(0, 0), (1, 1)],), r"translation: .* is not a pair of numbers"),
        (((0, 0), None), r"distance: None is not a number"),
        (((0, 0), 1, "1"), r"slope: '1' is not a number"),
        (((0, math.nan),), r".*nan"),
        (((0, 0), -1), r".*distance"),
        (((0, 0), math.inf), r".*distance"),
        (((0, 0), 0, -0.5), r".*slope"),
        (((0, 0), 0, math.nan), r".*slope"),
    ],
)
def test_refused(arguments: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{reason}"):
        gcv.contacts(SQUARE, SQUARE, *arguments)


def test_what_is_no_polygon_is_named() -> None:
    with pytest.raises(gcv.InputError, match=r"^a: "):
        gcv.contacts(BOW_TIE, SQUARE)
    with pytest.raises(gcv.InputError, match=r"^b: "):
        gcv.contacts(SQUARE, BOW_TIE)


def test_options() -> None:
    reports: list[tuple[int, int]] = []
    contacts = gcv.contacts(
        *(SQUARE, box(0, 0, 9, 1), (0, 1), 2),
        threads=2,
        progress=lambda *steps: reports.append(steps),
    )
    assert contacts == gcv.contacts(SQUARE, box(0, 0, 9, 1), (0, 1), 2)
    assert reports
    with pytest.raises(gcv.InputError, match="threads"):
        gcv.contacts(SQUARE, SQUARE, threads=-1)

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The translations that questions about two polygons take, and the options."""

from __future__ import annotations

import math
import pickle
import threading
from array import array
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Callable

import numpy as np
import pytest
import shapely
from shapes import BOW_TIE, FRAME, ROOMS, SQUARE, SQUARE_2, star

import gcv

Question = Callable[..., Any]


def cast_down(a: Any, b: Any, translation: Any, **options: Any) -> Any:
    return gcv.cast(a, b, translation, (0.25, -3), **options)


QUESTIONS: list[Question] = [gcv.relation, gcv.distance, gcv.penetration, cast_down]
DTYPES = [np.dtype(np.int8), gcv.SEPARATION_DTYPE, gcv.ESCAPE_DTYPE, gcv.IMPACT_DTYPE]
MOVES = [(5.0, 5.0), (1.5, 1.5), (11.0, 3.0), (-7.0, 12.0), (30.5, 1.0)]


def as_records(answers: Iterable[Any]) -> list[Any]:
    """The records that elements of an array stand for."""
    return list(map(as_record, answers))


def as_record(answer: Any) -> Any:
    if answer.dtype == np.int8:
        return gcv.Relation(answer)
    relation = gcv.Relation(answer["relation"])
    if answer.dtype == gcv.SEPARATION_DTYPE:
        return gcv.Separation(answer["distance"].item(), relation, as_contact(answer["nearest"]))
    position, contact = tuple(answer["position"].tolist()), as_contact(answer["contact"])
    if answer.dtype == gcv.ESCAPE_DTYPE:
        way = tuple(answer["translation"].tolist())
        return gcv.Escape(answer["depth"].item(), way, position, relation, contact)
    assert answer.dtype == gcv.IMPACT_DTYPE
    return gcv.Impact(bool(answer["hit"]), relation, answer["time"].item(), position, contact)


def as_contact(contact: Any) -> Any:
    if contact["kind"] == 0:
        assert contact.tobytes() == bytes(contact.dtype.itemsize)
        return None
    kind, a, b, reserved, id_a, id_b, gap, *points = contact.tolist()
    assert reserved == id_a == id_b == 0
    assert all(point.shape == (2,) for point in points)
    normal, on_a, on_b = (tuple(point.tolist()) for point in points)
    return gcv.Contact(gcv.ContactKind(kind), a, b, gap, normal, on_a, on_b)


@pytest.mark.parametrize(("question", "dtype"), zip(QUESTIONS, DTYPES))
def test_many_are_as_one_by_one(question: Question, dtype: Any) -> None:
    singles = [question(ROOMS, SQUARE_2, move) for move in MOVES]
    sources: list[Any] = [
        *(MOVES, tuple(MOVES), iter(MOVES), list(map(list, MOVES)), map(list, MOVES)),
        *(np.array(MOVES), list(np.array(MOVES)), np.array(MOVES).data),
        *(np.array(MOVES, "float32"), np.repeat(np.array(MOVES), 3, axis=1)[:, ::3]),
        *(np.asfortranarray(MOVES), np.array(MOVES)[::-1][::-1], np.array(MOVES, ">f8")),
        np.array(MOVES, object),
    ]
    for source in sources:
        answers = question(ROOMS, SQUARE_2, source)
        assert answers.dtype == dtype
        assert answers.shape == (len(MOVES),)
        assert as_records(answers) == singles
    for move, single in zip(MOVES, singles):
        ones: list[Any] = [list(move), np.array(move), array("d", move), iter(move)]
        for one in ones:
            assert question(ROOMS, SQUARE_2, one) == single
        assert as_records(question(ROOMS, SQUARE_2, [move])) == [single]


@pytest.mark.parametrize("question", QUESTIONS)
def test_whole_numbers(question: Question) -> None:
    moves = [(5, 5), (-7, 12), (2**53 + 2, 0)]
    expected = [question(ROOMS, SQUARE_2, move) for move in moves]
    for source in (moves, np.array(moves), np.array(moves, object)):
        assert as_records(question(ROOMS, SQUARE_2, source)) == expected
    small = np.array(moves[:2], "int8")
    assert as_records(question(ROOMS, SQUARE_2, small)) == expected[:2]
    assert question(ROOMS, SQUARE_2, small[0]) == expected[0]


@pytest.mark.parametrize(("question", "dtype"), zip(QUESTIONS, DTYPES))
def test_none_at_all(question: Question, dtype: Any) -> None:
    sources: list[Any] = [[], (), iter([]), np.empty((0, 2)), np.empty((0, 2), int)]
    for source in sources:
        answers = question(SQUARE, SQUARE, source)
        assert answers.dtype == dtype
        assert answers.shape == (0,)


@pytest.mark.parametrize("count", range(5))
def test_arrays_of_records(count: int) -> None:
    pairs = [(k, 0.5) for k in range(count)]
    records = np.array(pairs, [("x", float), ("y", float)])
    answers = gcv.relation(SQUARE, SQUARE, records)
    assert answers.tolist() == [gcv.relation(SQUARE, SQUARE, pair) for pair in pairs]
    if count > 0:
        assert gcv.relation(SQUARE, SQUARE, records[0]) is gcv.relation(SQUARE, SQUARE, pairs[0])


@pytest.mark.parametrize("question", QUESTIONS)
def test_arrays_are_the_callers(question: Question) -> None:
    answers = question(SQUARE, SQUARE, MOVES)
    before = answers.copy()
    assert (question(SQUARE, SQUARE, MOVES[:1]).repeat(5) == before[:1]).all()
    assert (answers == before).all()
    answers[:] = before[::-1]
    assert (answers[::-1] == before).all()
    assert (pickle.loads(pickle.dumps(answers)) == answers).all()


def test_records_can_be_pickled() -> None:
    for question in QUESTIONS:
        answer = question(SQUARE, SQUARE, (0.0, 1.5))
        assert pickle.loads(pickle.dumps(answer)) == answer


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize(
    ("translation", "reason"),
    [
        (None, "translation: None is not a pair of numbers, nor a sequence of pairs"),
        (3, "translation: 3 is not a pair of numbers, nor a sequence of pairs"),
        ((1, None), r"translation: \(1, None\) is not a pair of numbers"),
        ((1, 2, 3), r"translation\[0\]: 1 is not a pair of numbers"),
        ([(0, 0), (1, 2, 3)], r"translation\[1\]: \(1, 2, 3\) is not a pair of numbers"),
        ([(0, 0), (1, "2")], r"translation\[1\]: \(1, '2'\) is not a pair of numbers"),
        ([(0, 0), (1, 10**400)], r"translation\[1\]: .* is not a number that a finite float"),
        (["12", "34"], r"translation\[0\]: '12' is not a pair of numbers"),
        (np.zeros((2, 3)), r"translation\[0\]: array.* is not a pair of numbers"),
        (np.zeros((4,)), r"translation\[0\]: .* is not a pair of numbers"),
        (np.zeros((2, 2, 2)), r"translation\[0\]: .* is not a pair of numbers"),
        (np.zeros((0, 3)), r"translation: .* is not a pair of numbers, nor a sequence of pairs"),
        (np.zeros((0, 3), int), r"translation: .* is not a pair of numbers, nor a sequence of"),
        (np.zeros((0, 5, 7)), r"translation: .* is not a pair of numbers, nor a sequence of pairs"),
        (np.ma.masked_equal(SQUARE, 1), "translation: some elements of the array are masked"),
        (
            np.ma.array([0, 0.5], mask=[False, True]),
            "translation: some elements of the array are masked",
        ),
        ([(1, 1), np.ma.array([0, 0.5], mask=[False, True])], r"translation\[1\]: .* are masked"),
        (
            shapely.MultiPoint([(0, 0)]),
            "translation: <MULTIPOINT .*> is not a pair of numbers, nor",
        ),
        ((0, math.nan), r"translation\b.*\b0\b.*nan"),
        ([(0, 0), (math.inf, 0)], r"translation\b.*\b1\b.*inf"),
        ([(0, 0)] * 700 + [(0, math.nan)], r"translation\b.*\b700\b.*nan"),
        (np.array([(0, 0), (1, 0), (-np.inf, 2)]), r"translation\b.*\b2\b.*inf"),
    ],
)
def test_refused(question: Question, translation: Any, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^{reason}"):
        question(SQUARE, SQUARE, translation)
    with pytest.raises(gcv.InputError, match=f"^{reason}"):
        question(SQUARE, SQUARE, translation, threads=2, progress=lambda *_: None)


@pytest.mark.parametrize("question", QUESTIONS)
def test_what_is_no_polygon_is_named(question: Question) -> None:
    for bad in (BOW_TIE, None, [(0, 0), (1, 1)]):
        with pytest.raises(gcv.InputError, match=r"^a: "):
            question(bad, SQUARE, (0, 0))
        with pytest.raises(gcv.InputError, match=r"^b: "):
            question(SQUARE, bad, MOVES)


@pytest.mark.parametrize("question", QUESTIONS)
def test_threads(question: Question) -> None:
    a, b = star(40, 1), star(30, 2)
    moves = np.random.default_rng(3).uniform(-2, 2, (5000, 2))
    alone = question(a, b, moves)
    for threads in (0, 2, 3):
        assert question(a, b, moves, threads=threads).tobytes() == alone.tobytes()
    with ThreadPoolExecutor(4) as pool:
        for answers in pool.map(lambda _: question(a, b, moves), range(8)):
            assert answers.tobytes() == alone.tobytes()
    with pytest.raises(gcv.InputError, match="threads"):
        question(a, b, moves, threads=-1)


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("question", QUESTIONS)
def test_progress(question: Question, threads: int) -> None:
    reports: list[tuple[int, int]] = []
    moves = np.zeros((3000, 2))
    answers = question(
        FRAME, SQUARE, moves, threads=threads, progress=lambda *steps: reports.append(steps)
    )
    assert reports[-1] == (3000, 3000)
    assert sorted(reports) == reports
    assert (answers == question(FRAME, SQUARE, moves)).all()
    one = question(FRAME, SQUARE, (0, 0), progress=lambda *steps: reports.append(steps))
    assert reports[-1] == (1, 1)
    assert as_records(answers[:1]) == [one]


@pytest.mark.parametrize("question", QUESTIONS)
def test_progress_that_raises_cancels(question: Question) -> None:
    a, b = star(2000, 1), star(2000, 2)
    moves = np.random.default_rng(4).uniform(-1.5, 1.5, (300000, 2))
    seen = []

    def progress(done: int, estimate: int) -> None:
        seen.append((done, estimate))
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        question(a, b, moves, progress=progress)
    assert threading.active_count() == 1
    ((done, estimate),) = seen
    assert done < estimate == len(moves)


class Frame:
    """As a frame of pandas: its elements are the names of its columns."""

    def __init__(self, rows: Any) -> None:
        self._rows = np.array(rows, float)
        self.shape = self._rows.shape

    def __iter__(self) -> Iterator[int]:
        return iter(range(self.shape[1]))

    def __len__(self) -> int:
        return len(self._rows)

    def to_numpy(self) -> Any:
        return self._rows


@pytest.mark.parametrize("question", QUESTIONS)
def test_frames_have_one_translation_a_row(question: Question) -> None:
    assert (question(SQUARE, SQUARE, Frame(MOVES)) == question(SQUARE, SQUARE, MOVES)).all()
    with pytest.raises(gcv.InputError, match=r"^translation\[0\]: .* is not a pair of numbers"):
        question(SQUARE, SQUARE, Frame(np.zeros((3, 5))))


@pytest.mark.parametrize("question", QUESTIONS)
def test_numbers_in_arrays_without_dimensions(question: Question) -> None:
    pair = [np.array(0.0), np.array(1.5)]
    assert question(SQUARE, SQUARE, pair) == question(SQUARE, SQUARE, (0.0, 1.5))

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What type checkers are told.

Strict mypy refuses functions that return Any, and arguments that types are too narrow for.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np
from shapes import SQUARE, SQUARE_2, SQUARE_3

import gcv

if TYPE_CHECKING:
    from numpy.typing import NDArray

MOVES = [(3.0, 0.0), (0.5, 0.5)]
BOX = gcv.Polygon(SQUARE)


def relations() -> NDArray[np.int8]:
    return gcv.relation(BOX, BOX, np.array(MOVES))


def relation_of_a_list() -> gcv.Relation:
    return gcv.relation(BOX, BOX, [3, 0])


def distances() -> NDArray[np.void]:
    return gcv.distance(BOX, BOX, MOVES)


def penetrations() -> NDArray[np.void]:
    return gcv.penetration(BOX, BOX, MOVES)


def casts() -> NDArray[np.void]:
    return gcv.cast(BOX, BOX, MOVES, (-1, 0))


def casts_by_many() -> NDArray[np.void]:
    return gcv.cast(BOX, BOX, (3, 0), MOVES)


def locations() -> NDArray[np.int8]:
    return gcv.no_fit_region(BOX, BOX).locate(MOVES)


def ids(scene: gcv.Scene) -> NDArray[np.uint64]:
    return scene.add(BOX, MOVES)


def id_of(scene: gcv.Scene) -> int:
    return scene.add(BOX, (9, 9))


def positions(scene: gcv.Scene) -> NDArray[np.float64]:
    return scene.positions()


def positions_of(scene: gcv.Scene) -> NDArray[np.float64]:
    return scene.positions(scene.ids)


def position(scene: gcv.Scene) -> tuple[float, float]:
    return scene.positions(2)


def scene_relations(scene: gcv.Scene) -> NDArray[np.int8]:
    return scene.relation(BOX, MOVES)


def scene_distances(scene: gcv.Scene) -> NDArray[np.void]:
    return scene.distance(BOX, MOVES)


def scene_casts(scene: gcv.Scene) -> NDArray[np.void]:
    return scene.cast(BOX, MOVES, MOVES)


def scene_penetrations(scene: gcv.Scene) -> NDArray[np.void]:
    return scene.penetration(BOX, MOVES)


def test_answers() -> None:
    assert relations().tolist() == [1, -1]
    assert relation_of_a_list() is gcv.APART
    assert locations().tolist() == [-1, 1]
    for answers in (distances(), penetrations(), casts(), casts_by_many()):
        assert len(answers) == 2


def test_answers_of_scenes() -> None:
    scene = gcv.Scene()
    assert ids(scene).tolist() == [2, 3]
    assert id_of(scene) == 4
    assert positions(scene).tolist() == positions_of(scene).tolist() == [*map(list, MOVES), [9, 9]]
    assert position(scene) == scene.positions(np.uint64(2)) == MOVES[0]
    assert scene_relations(scene).tolist() == [-1, -1]
    for answers in (scene_distances(scene), scene_casts(scene), scene_penetrations(scene)):
        assert len(answers) == 2


def test_numbers_of_all_kinds() -> None:
    one, half = np.float32(1), Fraction(1, 2)
    square = gcv.Polygon([(Fraction(0), Decimal(0)), (np.int64(1), 0), (one, one), (0, one)])
    assert square == BOX
    assert gcv.offset(square, one, Decimal(1)) == gcv.offset(square, 1, 1)
    assert gcv.relation(square, square, (Decimal(1), half)) is gcv.TOUCHING
    assert gcv.minkowski_sum(square, SQUARE_2, tolerance=np.float32(0)) == square + gcv.Polygon(
        SQUARE_2
    )
    assert gcv.contacts(square, square, (np.int64(1), half), one, half)
    assert square.translated((half, half)).simplified(np.float32(0)).error_bound == 0
    assert gcv.inner_fit_region(SQUARE_3, square, (half, one)).area == 4
    scene = gcv.Scene(SQUARE_3)
    assert scene.best(square, (np.int64(1), 0)) == (2, 0)
    assert scene.add(square, (half, one)) == 2
    assert scene.near(square, (half, 0), np.float32(0)).array["a"].tolist() == [1, 2]
    assert scene.free_region(square, (0, half, one, Decimal(2))).parts
    assert gcv.Polygon.disc((half, one), one, half).bounds[0] < 0

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Points of shapely, and what only numpy makes an array of."""

from __future__ import annotations

from typing import Any, Callable, Optional

import numpy as np
import pytest
import shapely
from shapes import SQUARE, TRIANGLE
from test_coordinates import check_refused, check_translation

import gcv


def series(points: list[Any]) -> Any:
    return pytest.importorskip("geopandas").GeoSeries(points)


@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("of", [list, np.array, series, lambda points: series(points).array])
def test_points_of_shapely(of: Callable[[Any], Any], count: int) -> None:
    places = [(0.5, 0.0), (1.0, 0.0), (3.0, 0.0)][:count]
    some: Any = of([shapely.Point(*place, 7) for place in places])
    assert (gcv.relation(SQUARE, SQUARE, some) == [-1, 0, 1][:count]).all()
    scene = gcv.Scene()
    scene.add(SQUARE, some)
    assert scene.positions().tolist() == list(map(list, places))
    assert (gcv.no_fit_region(SQUARE, SQUARE).locate(some) == [1, 0, -1][:count]).all()
    many = [SQUARE] * count
    made = gcv.no_fit_polygon_many(many, many, some)
    assert made == gcv.no_fit_polygon_many(many, many, places)


def test_a_point_of_shapely() -> None:
    point = shapely.Point(1, 0)
    assert gcv.relation(SQUARE, SQUARE, point) is gcv.TOUCHING
    made = gcv.no_fit_polygon(SQUARE, SQUARE, point)
    assert made == gcv.no_fit_polygon(SQUARE, SQUARE, (1, 0))
    assert gcv.Polygon(SQUARE).translated(point).bounds == (1, 0, 2, 1)
    ring = [shapely.Point(x, y) for x, y in TRIANGLE]
    assert gcv.Polygon(ring) == gcv.Polygon(TRIANGLE)


def test_geometries_that_are_no_points() -> None:
    reason = " is not a pair of numbers"
    check_translation(shapely.LineString(SQUARE), f".*{reason}, nor a sequence of pairs")
    check_translation(shapely.Point(), f".*{reason}, nor a sequence of pairs")
    check_translation([shapely.Point(1, 1), shapely.Point()], f".*EMPTY.*{reason}", r"\[1\]")
    check_translation(series([shapely.Point(1, 1), None]), f"None{reason}", r"\[1\]")


class Array:
    def __init__(self, values: Any) -> None:
        self._values = np.asarray(values)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> Any:
        return self._values


class Interface:
    def __init__(self, values: Any) -> None:
        self._values = np.asarray(values)
        self.__array_interface__ = self._values.__array_interface__


@pytest.mark.parametrize("kind", [Array, Interface])
def test_what_only_numpy_makes_an_array_of(kind: Callable[[Any], Any]) -> None:
    for dtype in (float, int, np.float32):
        ring = kind(np.array(TRIANGLE, dtype))
        assert gcv.Polygon(ring) == gcv.Polygon.many([ring])[0] == gcv.Polygon(TRIANGLE)
        assert gcv.Scene().add(ring) == 2
    assert gcv.relation(SQUARE, SQUARE, kind((1, 0))) is gcv.TOUCHING
    assert gcv.relation(SQUARE, SQUARE, kind([(1, 0)])).tolist() == [0]
    number, triple = kind(5.0), kind([1, 2, 3])
    check_refused(lambda: gcv.Polygon(number), "polygon: .* is not a polygon, and none .*")
    check_refused(lambda: gcv.Polygon(triple), "polygon: vertex 0: 1 is not a pair of numbers")

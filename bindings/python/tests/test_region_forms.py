# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Regions in other forms: polygons, arrays, geometries, pictures, pickles, copies."""

from __future__ import annotations

import copy
import pickle
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from matplotlib import pyplot
from shapes import DUMB_BELL, FRAME, NOTCHED, ROOMS, SQUARE, SQUARE_2, TRIANGLE, box, facts, scaled

import gcv

pyplot.switch_backend("Agg")


def test_polygons_for_the_next_sum() -> None:
    region = gcv.minkowski_sum_region(FRAME, SQUARE)
    polygon = region.polygon(0)
    assert polygon == gcv.Polygon(box(0, 0, 11, 11), [box(2, 2, 9, 9)])
    assert list(region) == [polygon]
    assert gcv.Polygon(region) == gcv.Polygon(region.wkt) == polygon
    assert gcv.Polygon(*region.polygons[0]) == polygon
    assert gcv.minkowski_sum_region(region, SQUARE).area == 12**2 - 6**2
    rooms = gcv.inner_fit_region(DUMB_BELL, SQUARE_2)
    assert [room.area for room in rooms] == [4, 4]
    assert rooms.polygon(1).bounds == (6, 0, 8, 2)
    for number in (2, -1):
        with pytest.raises(gcv.InputError, match=f"^polygon is {number}, the region has 2 poly"):
            rooms.polygon(number)
    with pytest.raises(
        gcv.InputError, match="a GeometryCollection of 2 Polygon, 1 LineString is not one polygon"
    ):
        gcv.Polygon(rooms)


def test_vertices_are_never_copied_or_changed() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    (polygon,) = region.polygons
    for array in (polygon.outer, *polygon.holes, region.segments, region.points):
        assert np.shares_memory(array, region.vertices)
        assert not array.flags.writeable
    assert not region.exact_indices.flags.writeable


def test_shapely() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    geometry = region.shapely()
    polygon, line, point = geometry.geoms
    assert polygon.equals(shapely.from_wkt(region.wkt).geoms[0])
    assert shapely.from_wkt(region.fits_wkt).equals(shapely.GeometryCollection([line, point]))
    assert geometry.is_valid
    assert shapely.area(geometry) == region.area
    assert geometry.bounds == region.bounds
    frame = gcv.minkowski_sum_region(FRAME, SQUARE)
    assert frame.shapely().geom_type == "MultiPolygon"
    assert frame.shapely().equals(shapely.box(0, 0, 11, 11) - shapely.box(2, 2, 9, 9))
    assert gcv.minkowski_sum_region(frame.shapely(), SQUARE).area == 108


def test_pickle() -> None:
    for region in (gcv.no_fit_region(ROOMS, SQUARE_2), gcv.minkowski_sum_region(NOTCHED, TRIANGLE)):
        duplicate = pickle.loads(pickle.dumps(region))
        assert facts(duplicate) == facts(region)
        assert duplicate == region
        assert hash(duplicate) == hash(region)
        assert pickle.loads(pickle.dumps(duplicate)) == region
        assert copy.copy(region) is copy.deepcopy(region) is region


def test_svg() -> None:
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    polygon, segment, point = ElementTree.fromstring(region._repr_svg_())
    rings = polygon.attrib["d"].strip("MZ").split("ZM")
    assert polygon.attrib["fill-rule"] == "evenodd"
    assert [len(ring.split("L")) for ring in rings] == [4, 4]
    # 400 pixels for 22 units.
    assert segment.attrib["d"] == "M228.18 119.09L264.55 119.09"
    assert (point.attrib["cx"], point.attrib["cy"]) == ("155.45", "119.09")
    assert float(point.attrib["r"]) > 0


@pytest.mark.parametrize(("size", "count"), [(2, 1), (1, 0), (2e-300, 1)])
def test_svg_without_polygons(size: float, count: int) -> None:
    moving = scaled(SQUARE, 2 * size if count == 0 else size)
    region = gcv.inner_fit_region(box(0, 0, size, size), moving)
    picture = ElementTree.fromstring(region._repr_svg_())
    assert len(picture) == count
    assert picture.attrib["viewBox"] == "0 0 20.00 20.00"


def test_plot() -> None:
    _, ax = pyplot.subplots()
    region = gcv.no_fit_region(ROOMS, SQUARE_2)
    assert region.plot(ax, facecolor="red") is ax
    (patch,) = ax.patches
    assert patch.get_facecolor()[:3] == (1, 0, 0)
    assert patch.get_path().codes.tolist().count(1) == 2
    assert [line.get_xydata().tolist() for line in ax.lines] == [
        region.segments[0].tolist(),
        region.points.tolist(),
    ]
    pyplot.close("all")
    empty = gcv.inner_fit_region(SQUARE, SQUARE_2).plot()
    assert not empty.patches
    assert not empty.lines
    pyplot.close("all")

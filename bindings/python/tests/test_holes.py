# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Polygons with holes: from every source, to every form."""

from __future__ import annotations

import copy
import json
import pickle
import re
import struct
from collections.abc import Iterator
from fractions import Fraction
from operator import neg as negative
from pathlib import Path
from typing import Any, Union

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from matplotlib import pyplot
from matplotlib.patches import PathPatch
from shapes import SQUARE, Points, pairs, points, star
from test_pictures import corners

import gcv

pyplot.switch_backend("Agg")

OUTER: Points = [(0, 0), (10, 0), (10, 10), (0, 10)]
HOLE: Points = [(1, 1), (4, 1), (4, 4)]
SLIT: Points = [(5, 5), (9, 5), (9, 6), (5, 6)]
RINGS = [OUTER, *([ring[0], *ring[:0:-1]] for ring in (HOLE, SLIT))]
SHAPELY = shapely.Polygon(OUTER, [HOLE, SLIT])
GEOMETRY = SHAPELY.__geo_interface__
FEATURE = {"type": "Feature", "properties": None, "geometry": GEOMETRY}
WKT = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (1 1, 4 4, 4 1, 1 1), (5 5, 5 6, 9 6, 9 5, 5 5))"
RAISED = shapely.Polygon([(*vertex, 3) for vertex in OUTER], [[(*vertex, 5) for vertex in HOLE]])


def rings_of(polygon: gcv.Polygon) -> list[Points]:
    return [pairs(ring) for ring in polygon.rings]


def area(rings: list[Points]) -> Fraction:
    """The area of the first ring without the others."""
    areas = []
    for ring in rings:
        exact = [(Fraction(x), Fraction(y)) for x, y in ring]
        cross = [a[0] * b[1] - a[1] * b[0] for a, b in zip(exact, exact[1:] + exact[:1])]
        areas.append(abs(sum(cross, Fraction(0))) / 2)
    return 2 * areas[0] - sum(areas, Fraction(0))


SOURCES: dict[str, Any] = {
    "shapely": SHAPELY,
    "shapely of one part": shapely.MultiPolygon([SHAPELY]),
    "shapely turned round": shapely.Polygon(OUTER[::-1], [HOLE[::-1], SLIT[::-1]]),
    "mapping": GEOMETRY,
    "feature": FEATURE,
    "collection": {"type": "FeatureCollection", "features": [FEATURE]},
    "text": WKT,
    "text of shapely": shapely.Polygon(OUTER, [HOLE, SLIT]).wkt,
    "bytes": WKT.encode(),
    "GeoJSON": json.dumps(GEOMETRY),
    "GeoJSON of shapely": shapely.to_geojson(SHAPELY),
    "polygon": gcv.Polygon(SHAPELY),
}


@pytest.mark.parametrize("name", SOURCES)
def test_source(name: str) -> None:
    polygon = gcv.Polygon(SOURCES[name])
    assert rings_of(polygon) == RINGS
    assert polygon.area == 100 - 4.5 - 4
    assert polygon == gcv.Polygon(OUTER, holes=[HOLE, SLIT])


@pytest.mark.parametrize(
    "hole",
    [
        HOLE,
        np.array(HOLE),
        shapely.Polygon(HOLE),
        shapely.LinearRing(HOLE),
        "POLYGON ((1 1, 4 1, 4 4))",
        gcv.Polygon(HOLE),
        iter(HOLE),
    ],
)
def test_explicit_hole(hole: Any) -> None:
    assert rings_of(gcv.Polygon(np.array(OUTER), [hole])) == RINGS[:2]


def test_holes_are_added_to_those_of_the_source() -> None:
    some = shapely.Polygon(OUTER, [HOLE])
    for source in (some, some.wkt, gcv.Polygon(some)):
        assert rings_of(gcv.Polygon(source, np.array([SLIT]))) == RINGS


def test_file(tmp_path: Path) -> None:
    file = tmp_path / "polygon.txt"
    for text in (WKT, json.dumps(GEOMETRY)):
        file.write_text(text)
        assert rings_of(gcv.Polygon(file)) == RINGS


def test_elevations_are_left_out() -> None:
    assert RAISED.has_z
    for source in (RAISED, RAISED.wkt, shapely.to_geojson(RAISED)):
        assert rings_of(gcv.Polygon(source)) == RINGS[:2]


def test_properties() -> None:
    polygon = gcv.Polygon(SHAPELY)
    assert polygon.ring_count == 3
    assert len(polygon) == 4
    assert points(polygon) == OUTER
    assert np.asarray(polygon).tolist() == [list(vertex) for vertex in OUTER]
    assert [hole.tolist() for hole in polygon.holes] == [r.tolist() for r in polygon.rings[1:]]
    assert polygon.bounds == (0, 0, 10, 10)
    assert repr(polygon) == "<gcv.Polygon of 4 vertices with 2 holes>"
    assert repr(gcv.Polygon(OUTER, [HOLE])) == "<gcv.Polygon of 4 vertices with 1 hole>"
    assert polygon.wkt == WKT
    geometry = shapely.geometry.shape(polygon)
    assert geometry.equals(SHAPELY)
    assert geometry.exterior.is_ccw
    assert not any(hole.is_ccw for hole in geometry.interiors)


def test_without_holes() -> None:
    polygon = gcv.Polygon(SQUARE)
    assert polygon.ring_count == 1
    assert rings_of(polygon) == [SQUARE]
    assert polygon.holes == []
    assert polygon.wkt == "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"


def test_rings_are_never_copied_or_changed() -> None:
    polygon = gcv.Polygon(SHAPELY)
    for ring, same in zip(polygon.rings, polygon.rings):
        assert np.shares_memory(ring, same)
        assert not ring.flags.writeable
    assert np.shares_memory(polygon.rings[0], polygon.vertices)


def test_copies_and_equality() -> None:
    polygon = gcv.Polygon(SHAPELY)
    for same in (
        pickle.loads(pickle.dumps(polygon)),
        gcv.Polygon(polygon.wkt),
        gcv.Polygon(polygon.__geo_interface__),
        gcv.Polygon(OUTER, [SLIT[::-1], HOLE]),
        negative(negative(polygon)),
    ):
        assert same == polygon
        assert hash(same) == hash(polygon)
        assert repr(same) == repr(polygon)
    assert copy.deepcopy(polygon) is copy.copy(polygon) is polygon
    others = [gcv.Polygon(OUTER), gcv.Polygon(OUTER, [HOLE]), gcv.Polygon(OUTER, [SLIT])]
    assert len({polygon, *others}) == 4


def test_pickles_of_version_0_1_are_read() -> None:
    doubles = struct.pack("6d", 0, 0, 1, 0, 0, 1)
    pickled = b"\x80\x03cgcv._shapes\n_polygon_of\nC0" + doubles + b"\x85R."
    assert pickle.loads(pickled) == gcv.Polygon([(0, 0), (1, 0), (0, 1)])


def test_pickles_that_name_the_former_module_are_read() -> None:
    polygon = gcv.Polygon(SHAPELY).translated((1, 0))
    face = polygon + polygon
    values: list[object] = [polygon, face, face.sources, face.stats, polygon.simplified(0.1)]
    for value in [*values, gcv.Polygon, gcv.OuterFace]:
        pickled = pickle.dumps(value, 3)
        earlier = re.sub(rb"cgcv\._\w+\n", rb"cgcv._shapes\n", pickled)
        assert earlier != pickled
        assert pickle.loads(earlier) == value


def test_negative() -> None:
    reflected = -gcv.Polygon(SHAPELY)
    assert reflected == gcv.Polygon(shapely.affinity.scale(SHAPELY, -1, -1, origin=(0, 0)))
    assert reflected.area == 91.5


def test_sums_are_those_of_the_outer_rings() -> None:
    polygon = gcv.Polygon(SHAPELY)
    assert polygon + polygon == gcv.minkowski_sum(OUTER, OUTER)
    assert (polygon + polygon).sources == gcv.minkowski_sum(OUTER, OUTER).sources


def test_simplified() -> None:
    ragged = gcv.Polygon(star(200, 1), [0.3 * star(200, 2).vertices])
    near, bound = ragged.simplified(0.05)
    assert near.ring_count == 2
    assert all(len(r) < len(s) for r, s in zip(near.rings, ragged.rings))
    for ring, given_ring in zip(rings_of(near), rings_of(ragged)):
        assert set(ring) <= set(given_ring)
    assert 0 < bound <= 0.05
    around = ragged.simplified(0.05, rounding="outward").polygon
    after, before = shapely.geometry.shape(around), shapely.geometry.shape(ragged)
    assert after.buffer(1e-12).contains(before)


@pytest.mark.parametrize(
    ("holes", "status", "reason"),
    [
        ([[(1, 1), (2, 2), (3, 3)]], "DEGENERATE", "ring 1"),
        ([HOLE, [(2, 2), (8, 2), (8, 3)]], "NOT_SIMPLE", "rings 1 and 2"),
        ([[(5, 5), (15, 5), (5, 6)]], "NOT_SIMPLE", "rings 0 and 1"),
        ([[(25, 5), (15, 5), (25, 6)]], "NOT_SIMPLE", "rings? .*1.* outside"),
        ([[(1, 1), (3, 3), (3, 1), (1, 3)]], "NOT_SIMPLE", "ring 1"),
        ([HOLE, [(0, 0), (1, float("nan"))]], "NOT_FINITE", "ring 2"),
        ([[(1, 1), 2]], "INVALID_ARGUMENT", "hole 0: vertex 1: 2 is not a pair"),
        ([HOLE, None], "INVALID_ARGUMENT", "hole 1: None is not a polygon"),
        ([SHAPELY], "INVALID_ARGUMENT", "hole 0 has 3 rings, not one"),
        ([WKT], "INVALID_ARGUMENT", "hole 0 has 3 rings, not one"),
        (["POLYGON ((0 0"], "PARSE", "hole 0: byte 13"),
    ],
)
def test_refused(holes: Any, status: str, reason: str) -> None:
    with pytest.raises(gcv.InputError, match=f"^polygon: {reason}") as raised:
        gcv.Polygon(OUTER, holes)
    assert raised.value.status_name == f"GCV_ERR_{status}"


def test_no_sequence_of_holes() -> None:
    assert gcv.Polygon(OUTER, None) == gcv.Polygon(OUTER, ()) == gcv.Polygon(OUTER)
    with pytest.raises(gcv.InputError, match=r"^holes: 5 is not a sequence of polygons$"):
        gcv.Polygon(OUTER, 5)  # type: ignore[arg-type]
    for text in ("POLYGON ((1 1, 2 1, 1 2))", b"POLYGON ((1 1, 2 1, 1 2))"):
        reason = r"^holes: b?'POLYGON .*' is not a sequence of polygons, for it is text$"
        with pytest.raises(gcv.InputError, match=reason):
            gcv.Polygon(OUTER, text)  # type: ignore[arg-type]
        assert gcv.Polygon(OUTER, [text]).ring_count == 2


def test_refused_with_the_ring_of_the_source() -> None:
    crossing = shapely.Polygon(OUTER, [HOLE, [(2, 2), (8, 2), (8, 3)]])
    for source in (crossing, crossing.wkt, shapely.to_geojson(crossing)):
        with pytest.raises(gcv.InputError, match=r"^polygon: rings 1 and 2"):
            gcv.Polygon(source)


def test_svg() -> None:
    rings = corners(gcv.Polygon(SHAPELY)._repr_svg_())
    assert [len(ring) for ring in rings] == [4, 3, 4]
    assert rings[1] == [(50, 370), (170, 250), (170, 370)]


def test_plot() -> None:
    figure, ax = pyplot.subplots(figsize=(2, 2), dpi=100)
    ax.set_position((0, 0, 1, 1))
    gcv.Polygon(SHAPELY).plot(ax, facecolor="red", alpha=1, edgecolor="none", zorder=7)
    (patch,) = ax.patches
    assert isinstance(patch, PathPatch)
    assert patch.get_zorder() == 7
    assert patch.get_facecolor() == (1, 0, 0, 1)
    figure.canvas.draw()
    picture = np.asarray(figure.canvas.buffer_rgba())  # type: ignore[attr-defined]
    for (x, y), filled in {(5, 2): True, (3, 2): False, (7, 5.5): False, (5, 8): True}.items():
        column, row = ax.transData.transform((x, y))
        colour = picture[int(200 - row), int(column), :3].tolist()
        assert colour == ([255, 0, 0] if filled else [255, 255, 255])
    pyplot.close(figure)


def test_colours_of_plots_follow_one_another() -> None:
    figure, (left, right) = pyplot.subplots(1, 2)
    for _ in range(3):
        gcv.Polygon(OUTER).plot(left)
        gcv.Polygon(SHAPELY).plot(right)
    colours = [[patch.get_facecolor() for patch in ax.patches] for ax in (left, right)]
    assert colours[0] == colours[1]
    assert len(set(colours[0])) == 3
    assert left.dataLim.bounds == right.dataLim.bounds
    pyplot.close(figure)


@st.composite
def plates(draw: st.DrawFn) -> list[Points]:
    """A box with holes in some cells of a grid: stars or triangles, of any orientation."""
    scale = draw(st.sampled_from([1.0, 0.1, 2.0**-40, 3e5]))
    holes = []
    for column in range(3):
        for row in range(2):
            kind = draw(st.integers(0, 3))
            if kind == 0:
                continue
            ring = points(star(draw(st.integers(3, 9)), kind)) if kind < 3 else SQUARE
            moved = [
                ((x + 2.5 * column) * scale, (y + 2.5 * row) * scale)
                for x, y in (ring if draw(st.booleans()) else ring[::-1])
            ]
            holes.append(moved)
    box = [(-2.0, -2.0), (8.0, -2.0), (8.0, 5.0), (-2.0, 5.0)]
    return [[(x * scale, y * scale) for x, y in box], *holes]


@given(plates(), st.booleans())
def test_any_plate(rings: list[Points], closed: bool) -> None:
    passed = [[*ring, ring[0]] if closed else ring for ring in rings]
    polygon = gcv.Polygon(passed[0], passed[1:])
    assert polygon.ring_count == len(rings)
    assert [set(ring) for ring in rings_of(polygon)] == [set(ring) for ring in rings]
    assert polygon.area == float(area(rings))
    for same in copies(polygon):
        assert same == polygon
        assert rings_of(same) == rings_of(polygon)
    text = polygon.wkt
    assert shapely.from_wkt(text).equals(shapely.geometry.shape(polygon))


def copies(polygon: gcv.Polygon) -> Iterator[gcv.Polygon]:
    sources: list[Union[str, shapely.Polygon]] = [polygon.wkt, shapely.geometry.shape(polygon)]
    for source in sources:
        yield gcv.Polygon(source)
    yield pickle.loads(pickle.dumps(polygon))
    yield gcv.Polygon(polygon, ())
    yield negative(negative(polygon))

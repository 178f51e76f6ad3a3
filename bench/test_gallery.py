# SPDX-License-Identifier: LGPL-3.0-or-later
"""Tests of the gallery, on small polygons."""

from __future__ import annotations

import os
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from random import Random
from xml.etree import ElementTree

import gallery
import gallery_contacts
import gallery_regions
import gallery_style
import gallery_witnesses
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import gcv

PAIRS = """\
# the first block
square cgal/square.wkt cgal/square.wkt
~notched cgal/notched.wkt cgal/speck.wkt
# the second block
unread none.wkt none.wkt
"""
POLYGONS = {
    "square": "POLYGON ((0 0, 1 0, 2 0, 2 2, 0 2, 0 0))",
    "notched": "POLYGON ((0 0, 0 7, 3 1, 8 6, 8 0, 0 0))",
    "speck": "POLYGON ((0 0, 0.5 0, 0 0.5, 0 0))",
}


@pytest.fixture
def pairs(tmp_path: Path) -> list[gallery.Pair]:
    (tmp_path / "cgal").mkdir()
    (tmp_path / "pairs.txt").write_text(PAIRS)
    for name, text in POLYGONS.items():
        (tmp_path / "cgal" / f"{name}.wkt").write_text(text)
    return gallery.read_pairs(tmp_path)


def texts(figure: Figure) -> set[str]:
    return {text.get_text() for text in figure.findobj(Text) if isinstance(text, Text)}


def test_gallery(pairs: list[gallery.Pair]) -> None:
    figure = gallery.gallery(pairs)
    assert texts(figure) >= {
        *("square", "A: square, 5 vertices", "B: square, 5 vertices", "A + B: 4 vertices"),
        *("notched, with substitutes", "A: notched, 5 vertices", "B: speck, 3 vertices"),
        "5 times larger",
    }
    assert sorted(len(ax.patches) for ax in figure.axes) == [3, 4]


def test_superset(pairs: list[gallery.Pair]) -> None:
    figure = gallery.superset(pairs[0])
    kinds = [edge.source.kind for edge in gcv.superset(pairs[0].a.polygon, pairs[0].b.polygon)]
    for kind, (_, name) in gallery.KINDS.items():
        assert f"{kinds.count(kind)} {name}" in texts(figure)
    assert f"{len(kinds)} edges of the superset" in texts(figure)


EXPECTED = {
    "A peg in its slot": "1 polygon, 1 segment",
    "Keyholes": "1 polygon, 2 holes, 1 point",
    "Combs that mesh": "1 polygon, 8 segments",
    "Pieces of a jigsaw": "1 polygon, 1 point",
    "A part in a sheet with flaws": "1 polygon, 1 hole, 1 segment",
}


def test_regions() -> None:
    examples = gallery_regions.examples()
    assert {e.name: gallery_regions.counts(e.region) for e in examples} == EXPECTED
    figure = gallery_regions.regions(examples)
    assert texts(figure) >= {*EXPECTED, *EXPECTED.values()}
    # The region twice and A, and B where it is placed; a line for each of its fits and places.
    for ax, example in zip(figure.axes, examples):
        placed = gallery_regions.places(example)
        assert len(ax.patches) == 3 + len(placed)
        region = example.region
        assert len(ax.lines) == 2 * (len(region.segments) + len(region.points)) + len(placed)
        locations = region.locate(placed)
        assert set(locations.tolist()) == {gcv.BOUNDARY}


def test_many_holes() -> None:
    grid = [[(3 * k + 1, 1), (3 * k + 3, 1), (3 * k + 3, 3), (3 * k + 1, 3)] for k in range(9)]
    plate = gcv.Polygon([(0, 0), (28, 0), (28, 4), (0, 4)], grid)
    example = gallery_regions.no_fit("plate", plate, gcv.Polygon([(0, 0), (1, 0), (0, 1)]))
    assert gallery_regions.counts(example.region) == "1 polygon, 9 holes"
    assert gallery_regions.places(example) == []


ANSWERS = {
    "relation": [
        *("APART", "B is outside", "TOUCHING", "B is at an edge", "OVERLAPPING", "B is on an edge"),
        *("APART", "B is in a hole", "TOUCHING", "B is at the edge of a hole"),
        *("OVERLAPPING", "B is on the edge of a hole"),
    ],
    "distance": [
        *("An edge and a vertex", "distance 2.89", "Two vertices", "distance 1.58"),
        *("In a hole", "distance 1"),
    ],
    "penetration": [
        *("Out of the plate", "depth 0.75", "Into a hole", "depth 0.75"),
        *("The same, without holes", "depth 2.75", "Into an exact fit", "depth 0.25"),
        *("The same, without fits", "depth 3"),
    ],
    "cast": [
        *("Up to the first hit", "hits, time 0.375", "Along a wall", "no hit, time 1"),
        *("Down a slot of its width", "hits, time 0.75"),
    ],
    "contacts": [
        *("Within a distance", "6 contacts", "Two turned bricks", "1 contact"),
        *("The same with a slope", "2 contacts"),
    ],
}


@pytest.mark.parametrize("name", gallery_contacts.PICTURES)
def test_contacts(name: str) -> None:
    """What the pictures say, in order; and what moves is drawn at its end too."""
    axes = gallery_contacts.PICTURES[name]().axes
    said = [text for ax in axes for text in (ax.get_title(), ax.texts[0].get_text())]
    assert said == ANSWERS[name]
    moves = name in ("penetration", "cast")
    assert {len(ax.patches) for ax in axes} == {3 if moves else 2}


def test_witnesses() -> None:
    """What is covered and what is left of the edge, and that the region says the same."""
    a, b = gallery_witnesses.A, gallery_witnesses.B
    region = gcv.minkowski_sum_region(a, b)
    line = gallery_witnesses.superset_edge(
        *(a, b, gcv.EDGE_TRANSLATED),
        *(gallery_witnesses.EDGE_OF_A, gallery_witnesses.VERTEX_OF_B),
    )
    witnesses, free = gallery_witnesses.cover(a, b, line)
    assert [(w.p.edges, w.q.edges) for w in witnesses] == [(1, 8), (1, 1), (1, 1)]
    assert free == [(Fraction(5, 7), Fraction(1))]

    def locate(t: Fraction) -> gcv.Location:
        x, y = line.at(t)
        return region.locate((float(x), float(y)))

    for low, high in free:
        assert {locate(low + (high - low) * k / 8) for k in range(9)} == {gcv.BOUNDARY}
    for found in witnesses:
        low, high = max(found.enter, Fraction(0)), min(found.leave, Fraction(1))
        inner = {locate(low + (high - low) * Fraction(k, 8)) for k in range(1, 8)}
        assert inner == {gcv.INSIDE}


@pytest.mark.parametrize("seed", range(8))
def test_witnesses_lie_in_the_open_sum(seed: int) -> None:
    """Those of chains too: the middles of what they cover of a line."""
    a, b = gallery_witnesses.A, gallery_witnesses.B
    region = gcv.minkowski_sum_region(a, b)
    random = Random(seed)
    start = (Fraction(random.randint(-32, 224), 8), Fraction(random.randint(-32, 160), 8))
    line = gallery_witnesses.Line(
        start, (Fraction(random.randint(-99, 99), 8), Fraction(random.randint(-99, 99), 8))
    )
    pairs = [(gallery_witnesses.chain_of(a), gallery_witnesses.chain_of(b))]
    found = []
    for p, q in pairs:
        covered = gallery_witnesses.witness(p, q, line)
        found += [covered] if covered else []
        if p.edges > 1:
            pairs += [(half, q) for half in p.halves()]
        elif q.edges > 1:
            pairs += [(p, half) for half in q.halves()]
    middles = [line.at((w.enter + w.leave) / 2) for w in found]
    assert {region.locate((float(x), float(y))) for x, y in middles} <= {gcv.INSIDE}
    assert found


def test_pictures_are_the_same_to_the_byte(pairs: list[gallery.Pair], tmp_path: Path) -> None:
    for name in "first", "second":
        gallery_style.save(gallery.superset(pairs[1]), name, tmp_path)
    for kind in "svg", "png":
        first, second = ((tmp_path / f"{name}.{kind}").read_bytes() for name in ("first", "second"))
        assert first == second
    assert ElementTree.parse(tmp_path / "first.svg").getroot().tag.endswith("svg")


def test_no_data(tmp_path: Path) -> None:
    run = subprocess.run(
        [sys.executable, gallery.__file__],
        env={**os.environ, "GCV_DATA_DIR": str(tmp_path / "none")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (run.returncode, run.stdout, run.stderr.count("\n")) == (1, "", 1)
    assert "GCV_DATA_DIR" in run.stderr

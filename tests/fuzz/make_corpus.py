#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes the hand-made inputs of corpus/, but for those of texts: bytes."""

import random
import struct
from pathlib import Path

from scene_call_bytes import scene_calls

CORPUS = Path(__file__).parent / "corpus"

# The first byte of a polygon, as fuzz_polygons.cpp reads it.
RAW, INTEGERS, STAR, COMB = range(4)
SAME_PLACEMENT, ROTATED, SCALED, SHIFTED, ULPS = 4, 8, 16, 32, 64


def doubles(*numbers: float) -> bytes:
    return struct.pack(f"<{len(numbers)}d", *numbers)


def raw(*xy: float) -> bytes:
    return bytes([RAW, len(xy) // 2]) + doubles(*xy)


def grid(*xy: int, how: int = INTEGERS, placement: bytes = b"") -> bytes:
    return bytes([how]) + placement + bytes([len(xy) // 2 - 3]) + struct.pack(f"{len(xy)}b", *xy)


def comb(*columns: tuple[int, int, int], how: int = 0, placement: bytes = b"") -> bytes:
    """Columns are (width, height, depth)."""
    body = b"".join(bytes([w - 1, h, d - 1]) for w, h, d in columns)
    return bytes([COMB | how]) + placement + bytes([len(columns) - 1]) + body


SLOT = ((2, 8, 1), (1, 0, 1), (2, 8, 1))
TOOTH = ((1, 6, 1),)


def polygons() -> dict[str, bytes]:
    reference = doubles(0.5, -0.25)
    turned = bytes([2])
    scaled = struct.pack("<h", -1040)
    shifted = bytes([53, 3, 256 - 5])
    jitter = bytes(range(0, 256, 7))
    inputs = {
        "empty": b"",
        "triangles": grid(0, 0, 4, 0, 0, 3) + grid(0, 0, 1, 0, 0, 2),
        "concave": grid(0, 0, 8, 8, 4, 6, 0, 8) + grid(0, 0, 6, 6, 0, 4) + reference,
        "bow_tie": grid(0, 0, 1, 1, 1, 0, 0, 1) + grid(0, 0, 4, 0, 0, 3),
        "collinear": grid(0, 0, 1, 0, 2, 0, 2, 2, 2, 2, 0, 2) + grid(0, 0, 4, 0, 0, 3),
        "exact_fit": comb(*SLOT) + comb(*TOOTH) + reference,
        "shifted_rotated_exact_fit": comb(*SLOT, how=ROTATED | SHIFTED, placement=turned + shifted)
        + comb(*TOOTH, how=ROTATED, placement=turned)
        + reference,
        "subnormal": comb(*SLOT, how=SCALED, placement=scaled)
        + comb(*TOOTH, how=SAME_PLACEMENT)
        + reference,
        "ulps": bytes([COMB | ULPS, 2, 1, 8, 0, 0, 0, 0, 1, 8, 0]) + jitter + jitter,
        "all_magnitudes": raw(-1e100, 1e-300, 3, -1e-310, 1e17, 1, 5e15, 1e30)
        + raw(0, 0, 1e-200, 1e-200, 1, 1e-308, 1e9, 1e-9, 0.1, 1e5)
        + reference,
        "overflow": raw(0, 0, 1.7e308, 1.7e308, 0, 1.7e308) + raw(0, 0, 1e308, 1e308, 0, 1e308),
        "not_finite": raw(0, 0, float("inf"), 1, 1, float("nan")) + raw(0, 0, 1, 0, 0, 1),
        "reference_not_finite": raw(0, 0, 1, 0, 0, 1) * 2 + doubles(0, float("nan")),
    }
    for eighths in (1, 2, 3, 5, 7, 11, 250):
        inputs[f"rotated_exact_fit_{eighths}"] = (
            comb(*SLOT, how=ROTATED, placement=bytes([eighths]))
            + comb(*TOOTH, how=SAME_PLACEMENT)
            + reference
        )
    for halvings in (1, 2, 3, 40):
        ring = (-9, 0, 1, -6, 9, -7, 8, 1, 9, 8, 3, 8, 0, 2, -3, 7)
        inputs[f"within_{halvings}"] = grid(*ring) * 2 + reference + bytes([halvings])
    dice = random.Random(1)
    for k, how in enumerate((0, ROTATED, SCALED, SHIFTED, ULPS, ROTATED | SHIFTED) * 2):
        inputs[f"stars_{k}"] = b"".join(bytes([STAR | how]) + dice.randbytes(40) for _ in "ab")
    return inputs


def calls() -> dict[str, bytes]:
    (
        create, create_wkt, sum_, no_fit, entrance, superset, face_polygon, polygon_numbers,
        face_numbers, polygon_vertices, face_vertices, exact_vertex, edge_sources, wkt, edges,
        stats, destroy, constants, simplified, create_rings, create_many, disc, affine, ring,
        sum_region, no_fit_region, entrance_region, inner_fit_region, region_many, region_numbers,
        region_lists, region_texts, region_polygon, locate, region_stats, exact_indices,
        relation, distance, cast, penetration, contacts, listed_contacts, listed_indices,
        destroy_contacts,
    ) = range(44)  # fmt: skip
    all_calls = range(44)

    def polygon(text: int, slot: int = 0) -> bytes:
        return bytes([create_wkt, text, 1, 1, slot, 1])

    options = bytes(6)
    made = bytes([0, 1])  # to slot 0, an output that is not NULL
    point = bytes([17, 18])
    ready = (
        polygon(0)
        + polygon(1, 1)
        + bytes([sum_, 0, 1]) + options + made
        + bytes([superset, 0, 1]) + made
    )  # fmt: skip
    with_regions = (
        ready
        + bytes([sum_region, 0, 1]) + options + made
        + bytes([no_fit_region, 1, 0]) + options + point + b"\1" + bytes([1, 1])
        + bytes([entrance_region, 0, 1]) + options + point + b"\1" + bytes([2, 1])
    )  # fmt: skip
    vertices = bytes([16, 16, 20, 16, 16, 19])
    numbers = bytes([polygon_numbers, 0, 1, 0, 1, 0, 1, face_numbers, 0, 1, 0, 1, 0, 1, 0, 1])
    inputs = {
        "empty": b"",
        "constants": bytes([constants, 9, 0, 0, 0, constants, 77, 0, 0, 0, destroy, 0, 1, 2]),
        "null_handles": b"".join(bytes([call] + 8 * [2]) for call in all_calls),
        "strides": b"".join(
            bytes([create, stride, 3]) + vertices + bytes([1, 1]) + made for stride in range(10)
        ),
        "counts": b"".join(
            bytes([create, 0, 3]) + vertices + bytes([0, count, 1]) + made for count in range(3)
        ),
        "special_numbers": b"".join(
            bytes([create, 0, 3, k]) + vertices[1:] + bytes([1, 1]) + made for k in range(12)
        ),
        "texts": b"".join(polygon(text) for text in range(7)),
        "rings": b"".join(
            bytes([create, 2, 4]) + b"\x10\x10\x14\x10\x14\x14\x10\x14"
            + bytes([3]) + b"\x11\x11\x12\x11\x11\x12" + bytes([1, 1]) + tail
            for create, tail in ((create_rings, bytes([1]) + made), (create_many, b""))
        )
        + b"".join(bytes([ring, 0, index, 3, 0]) for index in range(6)),
        "discs": b"".join(
            bytes([disc, 16, 17, 18, tolerance, rounding, 1]) + made
            for tolerance in range(6)
            for rounding in range(2)
        ),
        "maps": ready
        + bytes([affine, 0, 16, 31, 17, 17, 16, 16, 1, 0, 1, ring, 0, 0, 3, 0])
        + numbers,
        "numbers": ready + numbers,
        "no_fit": ready + bytes([no_fit, 0, 1]) + options + point + b"\1" + made + numbers,
        "entrance": ready + bytes([entrance, 0, 1]) + options + point + b"\1" + made + numbers,
        "references_not_finite": ready
        + b"".join(
            bytes([call, 0, 1]) + options + reference + b"\1" + made
            for call in (no_fit, entrance)
            for reference in (b"\x00\x11", b"\x11\x01", b"\x11\x02")
        ),
        "next_sum": ready
        + bytes([face_polygon, 0]) + made
        + bytes([sum_, 0, 0]) + options + made
        + numbers,
        "overflow": polygon(2) + bytes([sum_, 0, 0]) + options + made,
        "regions": with_regions
        + bytes([region_numbers, 0, 1, 0, 1, region_polygon, 0, 0, 0, 1])
        + b"".join(bytes([region_lists, list_, 0, 3, 0]) for list_ in range(6))
        + b"".join(bytes([region_texts, text, 0, 3, 0]) for text in (1, 2))
        + bytes([region_texts, 0, 0, 1, 3, 0])
        + bytes([exact_indices, 0, 3, 0]),
        "inner_fits": ready
        + b"".join(
            bytes([inner_fit_region, 0, 1, 1, 0, 0, 0, leave_out, 0]) + point + b"\1" + made
            for leave_out in range(8)
        ),
        "many_regions": ready
        + bytes([region_many, 3, 0, 1, 16, 17, 1, 0, 18, 0, 2, 0, 16, 16]) + options + b"\1"
        + bytes([region_numbers, 0, 1, 0, 1]),
        "places": with_regions
        + bytes([locate, 0, 4, 16, 16, 17, 20, 23, 28, 30, 31, 1])
        + bytes([locate, 0, 2, 16, 2, 17, 20, 1, locate, 0, 0, 0, locate, 0, 1, 16, 16, 0]),
        "region_stats": with_regions
        + b"".join(bytes([region_stats, 0, size, 1]) for size in range(9)) + bytes(3),
        "questions": ready
        + b"".join(
            bytes([call, a, b]) + options + bytes([2, 20, 16, 31, 17, null, null]) + motions
            for call, motions in (
                (relation, b""), (distance, b""), (cast, bytes([31, 16, 18, 30, 1]))
            )
            for a, b in ((0, 1), (1, 0), (0, 0), (0, 2))
            for null in (1, 16)
        ),
        "no_questions": ready
        + b"".join(
            bytes([call, 0, 1]) + options + bytes([0, null, null, null])
            for call in (relation, distance, cast)
            for null in (0, 1)
        ),
        "questions_not_finite": ready
        + b"".join(
            bytes([call, 0, 1]) + options + bytes([1, x, y, 1, 1]) + motions
            for call, motions in (
                (relation, b""), (distance, b""), (cast, b"\x10\x10\1"), (cast, b"\x10\2\1")
            )
            for x, y in ((0, 17), (2, 17), (16, 1), (16, 2), (16, 17))
        ),
        "questions_overflow": polygon(2)
        + b"".join(
            bytes([call, 0, 0]) + options + bytes([2, 16, 16, 3, 4, 1, 1]) + motions
            for call, motions in (
                (relation, b""), (distance, b""), (cast, bytes([16, 16, 3, 4, 1]))
            )
        ),
        "escapes": ready
        + b"".join(
            bytes([penetration, a, b, 1, 0, tolerance, 0, leave_out, 0])
            + bytes([count, *([16, 16, 20, 31][: 2 * count]), null, null])
            for a, b in ((0, 1), (1, 0), (0, 0), (0, 2))
            for tolerance, leave_out in ((0, 0), (3, 0), (0, 3), (0, 4), (0, 5), (0, 6), (5, 0))
            for count in (0, 1, 2)
            for null in (1, 16)
        ),
        "escapes_not_finite": ready
        + b"".join(
            bytes([penetration, 0, 1]) + options + bytes([1, x, y, 1, 1])
            for x, y in ((0, 17), (2, 17), (16, 1), (16, 2), (16, 17))
        ),
        "escapes_overflow": polygon(2)
        + bytes([penetration, 0, 0]) + options + bytes([2, 16, 16, 3, 4, 1, 1]),
        "contacts": ready
        + b"".join(
            bytes([contacts, a, b]) + options + bytes([16, 20, null, 1, near, 1, slope, 0, null])
            + b"".join(
                bytes([call, 0, kind, 0])
                for call in (listed_contacts, listed_indices)
                for kind in range(6)
            )
            + bytes([destroy_contacts, 0])
            for a, b in ((0, 1), (1, 0), (0, 0), (0, 2))
            for near, slope in ((16, 16), (20, 17), (5, 5))
            for null in (1, 16)
        ),
        "contacts_of_no_size": ready
        + b"".join(
            bytes([contacts, 0, 1]) + options + bytes([x, 16, 1, sign, near, sign, slope]) + made
            for x, near, slope in ((16, 0, 16), (16, 16, 2), (16, 17, 16), (16, 16, 17), (1, 16, 16))
            for sign in (0, 1)
        ),
        "contacts_overflow": polygon(2)
        + bytes([contacts, 0, 0]) + options + bytes([3, 4, 1, 1, 3, 1, 3]) + made,
        "underflow": polygon(3) + bytes([sum_, 0, 0]) + options + made + numbers,
        "stats": ready + b"".join(bytes([stats, 0, size, 1]) for size in range(7)) + bytes(3),
        "indices": ready
        + b"".join(
            bytes([exact_vertex, 0, index, kind, 0]) for index in range(6) for kind in range(6)
        ),
    }  # fmt: skip
    for k, name in enumerate(("sizes", "roundings", "tolerances", "threads", "leave_outs")):
        whole = bytes([1]) + options[1:]
        inputs[f"options_{name}"] = ready + b"".join(
            bytes([sum_, 0, 1]) + whole[:k] + bytes([value]) + whole[k + 1 :] + made
            for value in range(15)
        )
    for k, name in enumerate(("tolerances", "roundings")):
        arguments = bytes([3, 1])
        inputs[f"simplified_{name}"] = ready + b"".join(
            bytes([simplified, 1]) + arguments[:k] + bytes([value]) + arguments[k + 1 :]
            + b"\1\2\1"
            + bytes([sum_, 2, 0]) + options + made
            for value in range(8)
        )  # fmt: skip
    inputs["options_unknown"] = ready + bytes([sum_, 0, 1, 9, 0, 0, 0, 0, 1]) + made
    for name, call in (
        ("polygon_vertices", polygon_vertices), ("face_vertices", face_vertices),
        ("edge_sources", edge_sources), ("wkt", wkt), ("edges", edges),
    ):  # fmt: skip
        inputs[f"buffers_{name}"] = ready + b"".join(bytes([call, 0, kind, 0]) for kind in range(6))
    return inputs


def regions() -> dict[str, bytes]:
    """Bytes as fuzz_regions.cpp reads them: what to compute, then two polygons."""
    no_fit, fit = 0, 1
    points, rectangle, teeth, block = range(4)
    one_hole, two_holes, sheared = 4, 8, 64

    def ring(*xy: int) -> bytes:
        return bytes([len(xy) // 2 - 3, *xy])

    square = bytes([rectangle, 0, 0, 0, 0])
    domino = bytes([rectangle, 0, 0, 1, 0])
    slot = bytes([teeth, 2, 7, 1, 1, 1, 7, 1])
    frame = bytes([block | one_hole, rectangle, 1, 1, 4, 4])
    touching = bytes([block | two_holes, rectangle, 1, 1, 2, 2, rectangle, 4, 4, 2, 2])
    triangle = bytes([points]) + ring(0, 0, 5, 0, 0, 5)
    inputs = {
        "empty": b"",
        "triangle": bytes([no_fit]) + triangle * 2,
        "triangle_fit": bytes([fit]) + triangle + bytes([points]) + ring(0, 0, 1, 0, 0, 1),
        "reference": bytes([no_fit + 16 + 4]) + slot + square,
        "refused": bytes([no_fit, points]) + ring(0, 0, 1, 1, 1, 0, 0, 1) + square,
    }
    for name, a, b in (
        ("slot", slot, square), ("slot_exact", slot, domino), ("frame", frame, square),
        ("frame_exact", frame, bytes([rectangle, 0, 0, 4, 4])), ("touching", touching, square),
        ("touching_holes", touching, touching), ("combs", slot, slot),
        ("sheared", bytes([slot[0] | sheared]) + slot[1:] + b"\2", square),
    ):  # fmt: skip
        inputs[name] = bytes([no_fit]) + a + b
        inputs[name + "_fit"] = bytes([fit]) + a + b
    dice = random.Random(2)
    for k in range(60):
        shapes = (points, rectangle, teeth, block, block | one_hole, block | two_holes)
        a, b = (
            bytes([dice.choice(shapes) | dice.choice((0, sheared))]) + dice.randbytes(22)
            for _ in "ab"
        )
        inputs[f"random_{k}"] = bytes([k % 2]) + a + b
    return inputs


# Bytes as question_polygons.hpp reads them.
ANYWHERE, ON_GRID, TEETH = 0, 1, 3
POINTS, RECTANGLE, COLUMNS, BLOCK = range(4)
ONE_HOLE, TWO_HOLES, SHEARED = 4, 8, 64


def placed(body: bytes, how: int = ON_GRID, placement: bytes = b"") -> bytes:
    return bytes([how]) + placement + body


def ring(*xy: int) -> bytes:
    return bytes([POINTS, len(xy) // 2 - 3, *xy])


def with_hole(outer: bytes, hole: bytes) -> bytes:
    return bytes([outer[0] | ONE_HOLE]) + outer[1:] + hole


def vertex(number: int, eighths: int = 0, of_ring: int = 0) -> bytes:
    return bytes([of_ring, number, eighths])


def grid_vector(x: float, y: float) -> bytes:
    return struct.pack("<B2b", 0, int(4 * x), int(4 * y))


def contact(of_a: bytes, of_b: bytes) -> bytes:
    return b"\1" + of_a + of_b


def near(of_a: bytes, of_b: bytes, x: int, y: int) -> bytes:
    return b"\2" + of_a + of_b + struct.pack("2b", x, y)


def beside(of_a: bytes, of_b: bytes, x: int, y: int) -> bytes:
    return b"\3" + of_a + of_b + struct.pack("2b", 16 * x, 16 * y)


def along(start: bytes, end: bytes) -> bytes:
    return b"\4" + start + end


def vector(x: float, y: float) -> bytes:
    return b"\5" + doubles(x, y)


ZERO = grid_vector(0, 0)
SQUARE = bytes([RECTANGLE, 0, 0, 1, 1])
NOTCH = bytes([COLUMNS, 2, 7, 1, 1, 1, 7, 1])
FRAME = bytes([BLOCK | ONE_HOLE, RECTANGLE, 1, 1, 4, 4])
TOUCHING = bytes([BLOCK | TWO_HOLES, RECTANGLE, 1, 1, 2, 2, RECTANGLE, 4, 4, 2, 2])
TRIANGLE = ring(0, 0, 5, 0, 0, 5)
ROOM = bytes([BLOCK])


def any_shape(dice: random.Random) -> bytes:
    shape = dice.choice((RECTANGLE, COLUMNS, BLOCK, POINTS))
    if shape == POINTS:
        x, y = dice.choices(range(1, 9), k=2)
        return ring(
            *dice.choice(((x, 0, 9, y, x, 9, 0, y), (0, 0, 9, y, x, 4), (0, y, 9, 0, x, 9)))
        )
    if shape == BLOCK and dice.random() < 0.8:
        x, y, width, height = dice.choices(range(1, 5), k=4)
        hole = ring(x, y, x + width, 0, x + width, y + height)
        return bytes([BLOCK | ONE_HOLE]) + dice.choice(
            (hole, bytes([RECTANGLE, x, y, width, height]))
        )
    return bytes([shape]) + dice.randbytes(12)[: 4 if shape == RECTANGLE else 12]


def questions() -> dict[str, bytes]:
    """Bytes as fuzz_questions.cpp reads them: two polygons, then translations and motions."""

    def moves(*vectors: bytes) -> bytes:
        """Translations and motions in turn, an even number of at most eight."""
        return bytes([len(vectors) // 2 - 1]) + b"".join(vectors)

    far = vector(1.7e308, -1.7e308)
    corner = vertex(0)
    around = moves(
        *(step for x, y in ((8, 0), (8, 3), (-3, 8), (1, 1)) for step in (ZERO, grid_vector(x, y)))
    )
    many = moves(
        grid_vector(-5, 1), grid_vector(9, 0), grid_vector(12, 12), grid_vector(-12, -11),
        contact(vertex(2), corner), grid_vector(-1, -1), beside(vertex(1), corner, 1, -1),
        along(corner, vertex(1)),
    )  # fmt: skip
    inputs = {
        "empty": b"",
        "refused": placed(ring(0, 0, 1, 1, 1, 0, 0, 1)) + placed(SQUARE) + moves(ZERO, ZERO),
        "not_finite": placed(SQUARE) * 2
        + moves(vector(float("nan"), 0), ZERO, ZERO, vector(0, float("inf")), ZERO, ZERO),
        "overflow": placed(SQUARE) * 2 + moves(far, far, ZERO, far, far, vector(-1.7e308, 1.7e308)),
        "in_hole": placed(FRAME) + placed(SQUARE)
        + moves(
            grid_vector(2, 2), grid_vector(1, 0.5), grid_vector(3, 3), ZERO,
            contact(vertex(0, of_ring=1), corner), grid_vector(5, 0),
            grid_vector(2, 2), grid_vector(20, 11),
        ),
        "exact_fit": placed(FRAME) + placed(bytes([RECTANGLE, 0, 0, 4, 4]))
        + moves(grid_vector(1, 1), grid_vector(1, 1), grid_vector(-8, 1), grid_vector(9, 0)),
        "inscribed": placed(ring(4, 0, 8, 4, 4, 8, 0, 4)) + placed(ring(0, 0, 8, 0, 8, 8, 0, 8))
        + around,
        "inscribed_elsewhere": placed(ring(0, 0, 6, 0, 6, 6, 0, 6))
        + placed(ring(3, 0, 6, 3, 3, 6, 0, 3)) + around,
        # A has two parts that meet in two points. B goes through these points, between the parts
        # and round one of them.
        "rings_that_hold_each_other": placed(
            with_hole(ring(0, 0, 9, 0, 9, 4, 0, 4), ring(3, 0, 5, 2, 3, 4, 1, 2))
        )
        + placed(
            with_hole(ring(0, 4, 2, 0, 9, 0, 9, 8, 2, 8), ring(1, 6, 2, 4, 1, 2, 8, 1, 8, 7))
        )
        + moves(
            *(
                step
                for x, y in ((0, 4), (-3, 2), (2, 0), (-2, -2))
                for step in (grid_vector(2, -2), grid_vector(x, y))
            )
        ),
        "exact_slot": placed(NOTCH) + placed(bytes([RECTANGLE, 0, 0, 1, 1]))
        + moves(grid_vector(2, 9), grid_vector(0, -9), grid_vector(2, 2), grid_vector(0, 9)),
        "all_magnitudes": placed(doubles(-1e100, 1e-300, 3, -1e-310, 5e15, 1e30), ANYWHERE, b"\0")
        + placed(doubles(0, 0, 1e-200, 1e-200, 0.1, 1e5), ANYWHERE, b"\0")
        + moves(contact(corner, corner), vector(1e-300, 1), vector(1e300, 1), vector(-1e300, 0)),
        "teeth": placed(bytes([39, 8, 2, 5, 1]), TEETH) + placed(bytes([29, 3, 9, 1, 4]), TEETH)
        + moves(
            grid_vector(2, 20), grid_vector(1, -20), contact(vertex(9, 3), vertex(7)),
            grid_vector(-7, 3), near(vertex(50), vertex(40), 3, -2), along(vertex(2), vertex(9)),
            grid_vector(3, 9), grid_vector(9, 0.5),
        ),
    }  # fmt: skip
    for name, a, b in (
        ("squares", SQUARE, SQUARE), ("slot", NOTCH, SQUARE), ("frames", FRAME, FRAME),
        ("rings_that_touch", TOUCHING, TOUCHING), ("triangles", TRIANGLE, TRIANGLE),
        ("part_beside_holes", TOUCHING, SQUARE), ("sheared", NOTCH, SQUARE),
    ):  # fmt: skip
        if name == "sheared":
            a, b = bytes([a[0] | SHEARED]) + a[1:] + b"\2", bytes([b[0] | SHEARED]) + b[1:] + b"\2"
        inputs[name] = placed(a) + placed(b) + many
        for place, how, placement in (
            ("turned", ROTATED, b"\3"), ("subnormal", SCALED, struct.pack("<h", -1074)),
            ("huge", SCALED, struct.pack("<h", 1018)), ("far_away", SHIFTED, bytes([50, 3, 251])),
            ("tiny_and_far", SCALED | SHIFTED, struct.pack("<h", -1000) + bytes([53, 1, 1])),
        ):  # fmt: skip
            inputs[f"{name}_{place}"] = (
                placed(a, ON_GRID | how, placement) + placed(b, ON_GRID | SAME_PLACEMENT) + many
            )
    dice = random.Random(3)

    def any_point() -> bytes:
        return vertex(dice.randrange(12), dice.choice((0, 0, 4, 3)), dice.randrange(2))

    def any_vector() -> bytes:
        kind = dice.randrange(6)
        if kind == 0:
            return grid_vector(dice.randrange(-12, 13), dice.randrange(-12, 13))
        if kind == 1:
            return near(any_point(), any_point(), *dice.choices(range(-100, 100), k=2))
        if kind == 2:
            return beside(any_point(), any_point(), *dice.choices((-1, 0, 1), k=2))
        return contact(any_point(), any_point()) if kind < 5 else along(any_point(), any_point())

    for k in range(120):
        a, b = (
            placed(body, ON_GRID | how, b"" if how == 0 else dice.randbytes(1))
            for body, how in ((any_shape(dice), dice.choice((0, 0, ROTATED))) for _ in "ab")
        )
        inputs[f"random_{k}"] = a + b + moves(*(any_vector() for _ in range(8)))
    return inputs


def scenes() -> dict[str, bytes]:
    """Bytes as fuzz_scenes.cpp reads them: polygons, then calls. Each call names the scene."""
    (
        add, _also_add, move, reshape, change_both, set_layers, remove, container, copy, drop,
        bad_id, ask,
    ) = range(12)  # fmt: skip
    far_out, in_contact, anywhere = 2, 3, 5

    def shapes(*bodies: bytes) -> bytes:
        return bytes([len(bodies) - 1]) + b"".join(bodies)

    def at(x: float, y: float) -> bytes:
        return grid_vector(x, y)

    def far_at(x: float, y: float) -> bytes:
        return struct.pack("<BbBbB", far_out, int(4 * x), 1, int(4 * y), 0)

    def touching_member(member: int, of_member: bytes, of_shape: bytes) -> bytes:
        return bytes([in_contact, member]) + contact(of_member, of_shape)

    def added(*members: tuple[int, bytes], scene: int = 0) -> bytes:
        """One to three, each a shape and a position."""
        return bytes([scene, add, len(members) - 1]) + b"".join(
            bytes([shape]) + position for shape, position in members
        )

    def asked(
        shape: int, position: bytes, motion: bytes, query: bytes = b"\1", slope: int = 0,
        within_motion: bool = False, scene: int = 0, earlier: int = 0,
    ) -> bytes:  # fmt: skip
        return (
            bytes([scene, ask, shape]) + position + motion + query
            + bytes([slope, within_motion, earlier])
        )  # fmt: skip

    def members(chosen: str) -> bytes:
        """A member is chosen where there is an x, and comes first."""
        return b"".join(b"\0\0" if choice == "x" else b"\1" for choice in chosen)

    blocks = shapes(placed(SQUARE), placed(FRAME), placed(NOTCH), placed(ROOM))
    row = added((0, at(0, 0)), (0, at(2, 0)), (1, at(5, 5))) + added((2, at(-9, 0)), (0, at(3, 2)))
    all_around = b"".join(
        asked(0, at(x, y), at(10, 3), slope=2, within_motion=bool(x % 2))
        for x, y in ((0, 0), (2, 2), (-5, 1), (7, 7), (1, -9), (4, 0), (20, 20))
    )
    twice = asked(1, at(0, 3), at(4, -4), within_motion=True) * 2
    layers = b"\0" + bytes([1, 2, 3])  # the first layer, without member 3, twice
    inputs = {
        "empty": b"",
        "nothing_there": blocks + all_around,
        "row": blocks + row + all_around + twice,
        "in_container": blocks + row + bytes([0, container, 3]) + all_around + twice
        + bytes([0, container, 1]) + all_around + bytes([0, container, 4]) + twice,
        "in_hole": blocks + added((1, at(0, 0))) + asked(0, at(2, 2), at(3, 0))
        + asked(0, at(1, 1), at(1, 0)) + asked(0, at(3, 3), at(9, 9)),
        "contacts": blocks + added((0, at(0, 0)))
        + added(
            (0, touching_member(0, vertex(2), vertex(0))),
            (2, touching_member(0, vertex(1), vertex(0, 3))),
        )
        + asked(0, touching_member(1, vertex(2, 4), vertex(0)), at(-5, -5)) + twice,
        "far_out": blocks + added((0, far_at(0, 0)), (0, far_at(4, 0)), (1, far_at(8, 8)))
        + asked(0, far_at(0, 4), at(20, 0), slope=1) + asked(0, far_at(12, 0), at(-20, 1)),
        "changes": blocks + row + twice + bytes([0, move]) + members("xnnnn") + at(1, 0) + twice
        + bytes([0, reshape]) + members("nxnxn") + b"\2\1" + twice
        + bytes([0, change_both]) + members("nnxnn") + b"\0" + at(2, 2) + twice
        + bytes([0, remove]) + members("xxnnn") + twice + added((0, at(0, 0))) + twice,
        "layers": blocks + row + bytes([0, set_layers]) + members("xnxnx") + b"\1\2\0"
        + asked(0, at(1, 1), at(5, 0), layers) + asked(0, at(1, 1), at(5, 0)),
        "bad_ids": blocks + row
        + b"".join(
            bytes([0, bad_id]) + members("nxnxn") + bytes([bad, twice_or_not])
            for bad in range(4)
            for twice_or_not in range(2)
        )
        + twice,
        "copies": blocks + row + twice + bytes([0, copy]) + added((0, at(1, 2))) + twice
        + added((1, at(-4, -4)), scene=1) + asked(1, at(0, 3), at(4, -4), scene=1)
        + asked(1, at(0, 3), at(4, -4), scene=1, within_motion=True) + bytes([1, copy, 2, drop, 0])
        + asked(1, at(0, 3), at(4, -4), scene=1, within_motion=True, earlier=1),
        "not_finite": blocks + row
        + added((0, bytes([anywhere]) + doubles(float("nan"), 0)))
        + bytes([0, move]) + members("nnxnn") + bytes([anywhere]) + doubles(0, float("inf"))
        + twice + added((0, at(0, 0))) + twice,
        "refused_shape": shapes(placed(ring(0, 0, 1, 1, 1, 0, 0, 1)), placed(SQUARE)) + row + twice,
        "overflow": shapes(placed(SQUARE))
        + added((0, bytes([anywhere]) + doubles(1.7e308, -1.7e308)), (0, at(0, 0)))
        + asked(0, bytes([anywhere]) + doubles(-1.7e308, 1.7e308), at(1, 1))
        + asked(0, at(5, 0), bytes([anywhere]) + doubles(1.7e308, -1.7e308), within_motion=True),
    }  # fmt: skip
    for place, how, placement in (
        ("turned", ROTATED, b"\3"), ("subnormal", SCALED, struct.pack("<h", -1074)),
        ("huge", SCALED, struct.pack("<h", 1010)), ("far_away", SHIFTED, bytes([50, 3, 251])),
    ):  # fmt: skip
        turned = shapes(
            placed(SQUARE, ON_GRID | how, placement),
            *(placed(s, ON_GRID | SAME_PLACEMENT) for s in (FRAME, NOTCH, ROOM)),
        )
        inputs[f"row_{place}"] = turned + row + all_around + twice
        inputs[f"in_container_{place}"] = turned + row + bytes([0, container, 3]) + all_around
    dice = random.Random(4)
    for k in range(40):
        bodies = (placed(any_shape(dice), ON_GRID) for _ in range(4))
        inputs[f"random_{k}"] = shapes(*bodies) + row + dice.randbytes(200)
    return inputs


for target, inputs in (
    ("polygons", polygons()),
    ("calls", {**calls(), **scene_calls()}),
    ("questions", questions()),
    ("scenes", scenes()),
    ("regions", regions()),
):
    (CORPUS / target).mkdir(parents=True, exist_ok=True)
    for name, data in inputs.items():
        (CORPUS / target / name).write_bytes(data)

#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes the example polygons, one WKT file each, next to this script or into a
folder given as the only argument. The same bytes come out on every machine: the
seed is fixed, and coordinates are rounded to a decimal grid.
"""

import math
import random
import sys
from pathlib import Path


def arc(cx, cy, radius, start, end, steps):
    """Points on a circle, from angle `start` to `end` in degrees, both included."""
    angles = (math.radians(start + (end - start) * k / steps) for k in range(steps + 1))
    return [(cx + radius * math.cos(t), cy + radius * math.sin(t)) for t in angles]


def bezier(p, q, r, s, steps):
    """Points on a cubic Bezier curve from p to s, without s."""
    def at(t):
        weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
        return tuple(sum(w * c for w, c in zip(weights, axis)) for axis in zip(p, q, r, s))
    return [at(k / steps) for k in range(steps)]


def mirrored(half):
    """A symmetric outline: the given right half and its mirror image in the y axis."""
    return half + [(-x, y) for x, y in reversed(half) if x != 0]


def comb():
    """A hair comb with fourteen teeth that get shorter from left to right."""
    teeth, pitch = 14, 8
    points = []
    for k in range(teeth):
        left, tip = k * pitch, -44 + k
        points += [(left, 0), (left + 0.7, tip + 1.5), (left + 1.75, tip),
                   (left + 2.8, tip + 1.5), (left + 3.5, 0)]
    right = (teeth - 1) * pitch + 3.5
    back = bezier((right, 0), (right + 6, 22), (70, 26), (50, 26), 12)
    back += bezier((50, 26), (30, 26), (-6, 22), (0, 0), 12)
    return points[:-1] + back


def fork(tines, width, gap, length, handle, radius):
    """A fork with its tines up: `tines` of them, each `width` wide, `gap` apart."""
    span = tines * width + (tines - 1) * gap
    right = span / 2
    points = [(right, 0)]
    for k in range(tines):
        x = right - k * (width + gap)
        points += [(x - 0.1 * width, 0.9 * length), (x - width / 2, length),
                   (x - 0.9 * width, 0.9 * length), (x - width, 0)]
        if k < tines - 1:
            points += [(x - width - gap / 2, -gap / 2), (x - width - gap, 0)]
    neck, bottom = width / 2, -span - handle
    shoulder = bezier((-right, 0), (-right, -0.9 * span), (-neck, -0.5 * span), (-neck, -span), 8)
    end = arc(0, bottom, radius, 180 - 40, 360 + 40, 14)
    return points[:-1] + shoulder + [(-neck, -span)] + end + [(-x, y) for x, y in
                                                             reversed(shoulder[1:] + [(-neck, -span)])]


# How much higher the slot of the lock is than the key: 2^-40 mm, an exact double.
CLEARANCE = 2.0 ** -40


def key():
    """A key whose bit has teeth of three lengths. It goes into the lock from the left."""
    bow = arc(-15, 1.5, 15, 6, 354, 40)
    bit = [(34, 0), (34, -6), (39, -6), (39, -2), (43, -2), (43, -4.5), (48, -4.5), (48, -1),
           (52, -1), (52, -6), (56, -6), (56, 0), (58, 1.5), (56, 3)]
    return [(round(x, 3), round(y, 3)) for x, y in bow[:-1]] + [(0, 0)] + bit + [(0, 3)]


def lock():
    """A lock with a slot as high as the key (and CLEARANCE), a chamber behind it, and
    notches in the floor of the chamber for the teeth."""
    slot = [(70, -6), (92, -6), (92, -9)]
    notches = [(100, -9), (100, -11), (105 + CLEARANCE, -11), (105 + CLEARANCE, -9),
               (109, -9), (109, -9.5), (114 + CLEARANCE, -9.5), (114 + CLEARANCE, -9),
               (118, -9), (118, -11), (122 + CLEARANCE, -11), (122 + CLEARANCE, -9)]
    inside = [(130, -9), (130, 3 + CLEARANCE), (70, 3 + CLEARANCE)]
    body = arc(80, 21, 10, 180, 90, 8)[1:] + [(130, 31), (140, 21), (140, -29), (130, -39), (80, -39)]
    return slot + notches + inside + [(70, 21)] + body + [(70, -29)]


def robot():
    """A floor robot, 0.7 m wide: square behind, round in front."""
    return [(-0.35, -0.35), (0, -0.35)] + arc(0, 0, 0.35, -75, 75, 10) + [(0, 0.35), (-0.35, 0.35)]


def room():
    """A floor plan, in metres: the walls, built-in furniture, doors of 1 m, a front door of
    1.2 m, and the door of a store room of 0.6 m. The front door keeps it one simple polygon."""
    return [(0, 0), (5.3, 0), (5.3, 0.3), (4.6, 0.3), (4.6, 1.6), (4.4, 1.6), (4.4, 0.3), (0.3, 0.3),
            (0.3, 2), (1.2, 2), (1.2, 4), (0.3, 4), (0.3, 5), (2.9, 5), (2.9, 5.2), (0.3, 5.2),
            (0.3, 7), (2.2, 7), (2.2, 8.7), (4.4, 8.7), (4.4, 5.2), (3.9, 5.2), (3.9, 5), (4.4, 5),
            (4.4, 2.6), (4.6, 2.6), (4.6, 6), (5, 6), (5, 6.2), (4.6, 6.2), (4.6, 8.7), (7.2, 8.7),
            (7.2, 6.2), (6, 6.2), (6, 6), (7.2, 6), (7.2, 3.4), (7.4, 3.4), (7.4, 4.6), (9.2, 4.6),
            (9.2, 4.8), (7.4, 4.8), (7.4, 8.7), (11.7, 8.7), (11.7, 4.8), (9.8, 4.8), (9.8, 4.6),
            (11.7, 4.6), (11.7, 3.4), (10.9, 3.4), (10.9, 0.9), (9.2, 0.9), (9.2, 0.3), (7.4, 0.3),
            (7.4, 2.4), (7.2, 2.4), (7.2, 0.3), (6.5, 0.3), (6.5, 0), (12, 0), (12, 9), (0, 9)]


def coast(seed, corners, radius, halvings):
    """An island: a rough polygon whose edges are halved again and again, each time with the
    midpoint moved sideways by up to 30 % of the edge."""
    chance = random.Random(seed).random
    ring = []
    for k in range(corners):
        angle, r = 2 * math.pi * (k + 0.5 * chance()) / corners, radius * (0.55 + 0.45 * chance())
        ring.append((1.4 * r * math.cos(angle), r * math.sin(angle)))
    for _ in range(halvings):
        finer = []
        for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
            shift = 0.6 * (chance() - 0.5)
            finer += [(x0, y0), ((x0 + x1) / 2 - shift * (y1 - y0), (y0 + y1) / 2 + shift * (x1 - x0))]
        ring = finer
    return ring


def shirt_front():
    """The front of a shirt, in millimetres, with its straight edge at the left."""
    return ([(0, 40)] + bezier((0, 40), (70, -10), (190, 10), (245, 90), 10)
            + bezier((245, 90), (225, 220), (235, 330), (255, 470), 6)
            + bezier((255, 470), (180, 500), (190, 590), (205, 690), 12)
            + [(205, 690)] + bezier((80, 735), (75, 680), (40, 645), (0, 640), 8) + [(0, 640)])[1:]


def sleeve():
    """The sleeve that is sewn to it: a straight hem and a bell-shaped cap."""
    cap = bezier((0, 560), (70, 560), (95, 410), (195, 400), 14)
    return mirrored([(110, 0)] + [(x, y) for x, y in reversed(cap)] )


POLYGONS = {
    "comb": comb(),
    "fork_large": fork(tines=5, width=5, gap=11, length=90, handle=90, radius=8),
    "fork_small": fork(tines=3, width=2.5, gap=6.5, length=40, handle=50, radius=4),
    "key": key(),
    "lock": lock(),
    "robot": robot(),
    "room": room(),
    "coast": coast(seed=3, corners=10, radius=60, halvings=6),
    "islet": coast(seed=8, corners=6, radius=14, halvings=5),
    "shirt_front": shirt_front(),
    "sleeve": sleeve(),
}


def number(value):
    """A coordinate on the grid of 0.001, or the exact double where it is none of it."""
    rounded = round(value, 3)
    return repr(value if 0 < abs(value - rounded) == CLEARANCE else rounded + 0.0).removesuffix(".0")


def wkt(points):
    ring = [f"{number(x)} {number(y)}" for x, y in points + points[:1]]
    lines = [", ".join(ring[k:k + 6]) for k in range(0, len(ring), 6)]
    return "POLYGON ((" + ",\n  ".join(lines) + "))\n"


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for name, points in POLYGONS.items():
        (folder / f"{name}.wkt").write_text(wkt(points), encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes the example polygons, one WKT file each, next to this script or into the
folder given as its only argument. The same bytes come out on every machine: seeds
are fixed, and what is computed is rounded to three decimals.
"""

import math
import random
import sys
from pathlib import Path


def rounded(points):
    return [(round(x, 3), round(y, 3)) for x, y in points]


def arc(cx, cy, radius, start, end, steps):
    """Points on a circle, from the angle `start` to `end`, in degrees."""
    angles = [math.radians(start + (end - start) * k / steps) for k in range(steps + 1)]
    return rounded((cx + radius * math.cos(t), cy + radius * math.sin(t)) for t in angles)


def bezier(p, q, r, s, steps):
    """Points on a cubic Bezier curve from p to s."""
    def at(t):
        weights = (1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3
        return [sum(w * c for w, c in zip(weights, axis)) for axis in zip(p, q, r, s)]
    return rounded(at(k / steps) for k in range(steps + 1))


def mirrored(half):
    """An outline that is symmetric to the y axis, from its right half."""
    return half + [(-x, y) for x, y in reversed(half) if x != 0]


# ------------------------------------------------------------------ combs and forks --

def comb():
    """A hair comb: fourteen tapered teeth, shorter and shorter from left to right."""
    teeth, pitch = 14, 8
    points = []
    for k in range(teeth):
        x, tip = k * pitch, k - 44
        points += [(x, 0), (x + 0.7, tip + 1.5), (x + 1.75, tip), (x + 2.8, tip + 1.5),
                   (x + 3.5, 0)]
    end, _ = points.pop()
    middle = end / 2
    back = bezier((end, 0), (end + 4, 22), (middle + 22, 27), (middle, 27), 12)
    back += bezier((middle, 27), (middle - 22, 27), (-4, 22), (0, 0), 12)[1:-1]
    return rounded(points + back)


def hairpin():
    """A hairpin, its prongs three teeth of the comb apart and wavy in the middle."""
    wave = [(0, -20), (1.2, -23), (0, -26), (1.2, -29), (0, -32)]
    inside = arc(0, 0, 11.4, 90, 0, 10) + [(11.4 + dx, y) for dx, y in wave] + [(11.6, -50)]
    outside = [(12.4, -50)] + [(12.6 + dx, y) for dx, y in reversed(wave)]
    return rounded(mirrored(inside + outside + arc(0, 0, 12.6, 0, 90, 10)))


def fork(tines, width, gap, length, handle):
    """A fork that lies with its tines to the right."""
    span = tines * width + (tines - 1) * gap
    prongs = []
    for k in range(tines):
        y, end = span / 2 - k * (width + gap), length * (1 - 0.04 * abs(k - (tines - 1) / 2))
        prongs += [(end - 3 * width, y), (end, y - width / 2), (end - 3 * width, y - width)]
        if k < tines - 1:
            prongs += arc(0, y - width - gap / 2, gap / 2, 90, 270, 8)
    shoulder = bezier((0, -span / 2), (-0.6 * span, -span / 2),
                      (-0.4 * span, -width / 2), (-0.8 * span, -width / 2), 10)
    end = arc(-0.8 * span - handle, 0, 1.2 * width, -60, -300, 14)
    outline = prongs + shoulder + end + [(x, -y) for x, y in reversed(shoulder)]
    return rounded(reversed(outline))


# --------------------------------------------------------------------- key and lock --

# How much wider the passages of the lock are than the key: 2^-40 mm.
CLEARANCE = 2.0 ** -40


def key():
    """A key. Its bit has three teeth, and goes into the lock from the left."""
    bow = arc(-15, 1.5, 15, 6, 354, 40)
    bit = [(34, 0), (34, -6), (39, -6), (39, -2), (43, -2), (43, -4.5), (48, -4.5), (48, -1),
           (52, -1), (52, -6), (56, -6), (56, 0), (58, 1.5), (56, 3)]
    return bow + [(0, 0)] + bit + [(0, 3)]


def lock():
    """The lock: a slot as high as the key, a chamber behind it, and in the floor of the
    chamber notches for the teeth, where the key goes down the rest of its way."""
    wider = CLEARANCE
    slot = [(70, -6), (92, -6), (92, -9)]
    notches = [(100, -9), (100, -11), (105 + wider, -11), (105 + wider, -9),
               (109, -9), (109, -9.5), (114 + wider, -9.5), (114 + wider, -9),
               (118, -9), (118, -11), (122 + wider, -11), (122 + wider, -9)]
    chamber = [(126, -9), (126, 3 + wider), (70, 3 + wider)]
    body = (arc(80, 21, 10, 180, 90, 8) + arc(130, 21, 10, 90, 0, 8)
            + arc(130, -29, 10, 0, -90, 8) + arc(80, -29, 10, -90, -180, 8))
    return (slot + notches + chamber + body)[::-1]


# ------------------------------------------------------------------- robot and room --

def robot():
    """A floor robot, 70 cm wide: square behind, round in front."""
    return [(-35, -35)] + arc(0, 0, 35, -90, 90, 12) + [(-35, 35)]


def room():
    """A floor plan, in centimetres: walls and built-in furniture. Inner doors are 100 wide, the
    one of the store room 60. The front door joins the rooms with the outside. The dock of the
    robot, at the left, is 70 wide."""
    return [(0, 0), (530, 0), (530, 30), (460, 30), (460, 160), (440, 160), (440, 30),
            (30, 30), (30, 200), (120, 200), (120, 265), (40, 265), (40, 335), (120, 335),
            (120, 400), (30, 400), (30, 500), (290, 500), (290, 520), (30, 520), (30, 700),
            (220, 700), (220, 870), (440, 870), (440, 520), (390, 520), (390, 500), (440, 500),
            (440, 260), (460, 260), (460, 600), (500, 600), (500, 620), (460, 620), (460, 870),
            (720, 870), (720, 620), (600, 620), (600, 600), (720, 600), (720, 340), (740, 340),
            (740, 460), (920, 460), (920, 480), (740, 480), (740, 870), (1170, 870), (1170, 480),
            (980, 480), (980, 460), (1170, 460), (1170, 340), (1030, 340), (1030, 90), (920, 90),
            (920, 30), (740, 30), (740, 240), (720, 240), (720, 30), (650, 30), (650, 0),
            (1200, 0), (1200, 900), (0, 900)]


def lift():
    """The shaft of the lift: the robot fits in, and cannot move."""
    return [(75, 760), (145, 760), (145, 830), (75, 830)]


def light_well():
    """A light well without a door."""
    return [(1060, 70), (1170, 70), (1170, 310), (1060, 310)]


# ------------------------------------------------------------------ coast and islet --

def island(seed, corners, radius, halvings):
    """A rough polygon whose edges are halved again and again, each time with the midpoint
    moved sideways by up to 36 % of the edge."""
    chance = random.Random(seed).random
    ring = []
    for k in range(corners):
        angle, r = 2 * math.pi * (k + 0.5 * chance()) / corners, radius * (0.5 + 0.5 * chance())
        ring.append((1.4 * r * math.cos(angle), r * math.sin(angle)))
    for _ in range(halvings):
        finer = []
        for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
            shift = 0.72 * (chance() - 0.5)
            finer += [(x0, y0),
                      ((x0 + x1) / 2 - shift * (y1 - y0), (y0 + y1) / 2 + shift * (x1 - x0))]
        ring = finer
    return rounded(ring)


# ------------------------------------------------------------------- parts of a shirt --

def shirt_front():
    """The front of a shirt, in millimetres; its straight edge is the one with the buttons."""
    hem = bezier((0, 40), (70, -10), (190, 10), (245, 90), 10)
    side = bezier((245, 90), (225, 220), (235, 330), (255, 470), 6)
    armhole = bezier((255, 470), (180, 500), (190, 590), (205, 690), 12)
    neck = bezier((80, 735), (75, 680), (40, 645), (0, 640), 8)
    return hem + side[1:] + armhole[1:] + neck


def sleeve():
    """Its sleeve: a bell-shaped cap, tapered down to the cuff."""
    return mirrored([(110, 0)] + bezier((195, 400), (95, 410), (70, 560), (0, 560), 14))


# The rings of each polygon, the outer one first.
POLYGONS = {
    "comb": (comb(),),
    "hairpin": (hairpin(),),
    "fork_large": (fork(tines=5, width=4, gap=16, length=90, handle=60),),
    "fork_small": (fork(tines=2, width=2.5, gap=7.5, length=50, handle=50),),
    "key": (key(),),
    "lock": (lock(),),
    "robot": (robot(),),
    "room": (room(), lift(), light_well()),
    "coast": (island(seed=89, corners=10, radius=60, halvings=6),),
    "islet": (island(seed=24, corners=6, radius=14, halvings=5),),
    "shirt_front": (shirt_front(),),
    "sleeve": (sleeve(),),
}


def number(value):
    """The fewest digits that read back as the same double; 0 without a sign."""
    return repr(float(value) + 0.0).removesuffix(".0")


def ring(points):
    closed = [f"{number(x)} {number(y)}" for x, y in points + points[:1]]
    lines = [", ".join(closed[k:k + 6]) for k in range(0, len(closed), 6)]
    return "(" + ",\n  ".join(lines) + ")"


def wkt(rings):
    return "POLYGON (" + ",\n  ".join(map(ring, rings)) + ")\n"


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for name, rings in POLYGONS.items():
        (folder / f"{name}.wkt").write_text(wkt(rings), encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()

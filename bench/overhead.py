# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What Python adds to a sum of two arrays of ten vertices; fails above 25 microseconds.

A sum of arrays makes two polygons first. Both are counted as Python's here: what is
subtracted is the time of a sum alone, inside one call for many.
"""

import sys
import timeit
from typing import Callable

from shapes import star

import gcv

MOST_MICROSECONDS = 25
COUNT = 2000


def microseconds(action: Callable[[], object], sums: int = 1) -> float:
    """Of one sum, in the fastest of many runs."""
    seconds = timeit.repeat(action, number=COUNT // sums, repeat=50)
    return 1e6 * min(seconds) / COUNT


polygons = star(10, 1), star(10, 2)
arrays = [polygon.vertices for polygon in polygons]
many = [[polygon] * COUNT for polygon in polygons]

in_c = microseconds(lambda: gcv.minkowski_sum_many(*many), COUNT)
of_polygons = microseconds(lambda: gcv.minkowski_sum(*polygons))
of_arrays = microseconds(lambda: gcv.minkowski_sum(*arrays))
with_vertices = microseconds(lambda: gcv.minkowski_sum(*arrays).vertices)

print(f"one of many sums in C   {in_c:6.1f} microseconds")
print(f"sum of two polygons     {of_polygons:6.1f} {of_polygons - in_c:+6.1f}")
print(f"sum of two arrays       {of_arrays:6.1f} {of_arrays - in_c:+6.1f}")
print(f"  and its vertices      {with_vertices:6.1f} {with_vertices - in_c:+6.1f}")
sys.exit(of_arrays - in_c > MOST_MICROSECONDS)

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Polygons with a clearance: grown or shrunk by a distance."""

from __future__ import annotations

import math
from typing import Optional, SupportsFloat

from ._call import Progress
from ._coordinates import number, unfit_number
from ._ffi import INVALID_ARGUMENT, InputError
from ._polygon import Polygon, as_polygon
from ._region import Region
from ._region_sums import inner_fit_region, minkowski_sum_region
from ._sources import PolygonLike

# What the disc and the rounding take of the tolerance; a 16th is left for the rounding of shares.
_SHARE_OF_DISC = 7 / 8
_SHARE_OF_ROUNDING = 1 / 16


def offset(
    polygon: PolygonLike,
    distance: SupportsFloat,
    tolerance: SupportsFloat,
    *,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Region:
    """The polygon with a clearance: grown by the distance, or shrunk where it is below 0.

    Above 0, the region contains every point within the distance of the polygon, and none
    farther from it than distance + tolerance; holes shrink. Below 0, every point of the
    region is in the polygon and at least -distance from all outside of it, and every point
    farther from there than -distance + tolerance is in the region; holes grow, and there
    can be several polygons or none. So what is placed by the region keeps the distance.
    It has no segments and no points.

    For: a disc that contains the one of that radius, and is contained in one larger by 7/8
    of the tolerance, is added to the polygon, or moved inside of it, exactly; and rounding
    moves the boundary outwards, or inwards, by a 16th of the tolerance at most, which
    error_bound certifies.

    polygon: a polygon, or whatever Polygon can be made from, with its holes. distance and
    tolerance are in input units. For a distance of r or -r the disc has about
    2.4 sqrt(r / tolerance) vertices, up to twice as many. threads and progress are those of
    minkowski_sum; in the sources, a is a number of the polygon and b one of the disc.

    Raises as Polygon does; InputError for a distance that is 0 or not finite, and for a
    tolerance that is not above 0 or too small for floats; Error where coordinates are
    near the largest float. Takes version 0.2 of the library.
    """
    polygon = as_polygon(polygon, "polygon")
    distance, tolerance = number(distance, "distance"), number(tolerance, "tolerance")
    if not math.isfinite(distance) or distance == 0:
        raise unfit_number("distance", distance, "a finite number other than 0")
    if not 0 < tolerance < math.inf:
        raise unfit_number("tolerance", tolerance, "a finite number above 0")
    try:
        disc = Polygon.disc((0, 0), abs(distance), _SHARE_OF_DISC * tolerance, rounding="outward")
    except InputError:
        raise _too_small(tolerance) from None
    combine = minkowski_sum_region if distance > 0 else inner_fit_region
    region = combine(
        *(polygon, disc),
        rounding="outward",
        threads=threads,
        progress=progress,
        leave_out="fits",
    )
    if region.error_bound > _SHARE_OF_ROUNDING * tolerance:
        raise _too_small(tolerance)
    return region


def _too_small(tolerance: float) -> InputError:
    return InputError(
        INVALID_ARGUMENT,
        f"tolerance: {tolerance} is too small for the roundings of these coordinates to floats",
    )

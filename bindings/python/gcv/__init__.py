# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The outer face of the Minkowski sum of two polygons, exactly.

Every coordinate is a finite float and stands for exactly that number; nothing is
rounded but the coordinates that are handed back as floats, each once. Polygons and
outer faces never change, so any number of threads may share them; the work is done
outside Python's global lock. They can be pickled, and travel to other processes.
"""

from ._call import Progress, Rounding
from ._ffi import Error, InputError
from ._outer_face import (
    EDGE_CORNER,
    EDGE_TRANSLATED,
    EDGE_TRANSLATED_CORNER,
    EdgeSource,
    OuterFace,
    Stats,
)
from ._polygon import Polygon, Simplified
from ._sources import PolygonLike
from ._sums import (
    SupersetEdge,
    entrance_block,
    library_version,
    minkowski_sum,
    minkowski_sum_many,
    no_fit_polygon,
    superset,
)

__all__ = [
    "EDGE_CORNER",
    "EDGE_TRANSLATED",
    "EDGE_TRANSLATED_CORNER",
    "EdgeSource",
    "Error",
    "InputError",
    "OuterFace",
    "Polygon",
    "PolygonLike",
    "Progress",
    "Rounding",
    "Simplified",
    "Stats",
    "SupersetEdge",
    "entrance_block",
    "library_version",
    "minkowski_sum",
    "minkowski_sum_many",
    "no_fit_polygon",
    "superset",
]

__version__ = "0.2.0"

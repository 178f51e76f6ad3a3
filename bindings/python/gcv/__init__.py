# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Minkowski sums of two polygons, exactly: outer faces and whole regions.

And questions about two polygons, exactly: whether they touch or overlap,
how far they are from each other, and how far one can move. A scene answers them for
many polygons at positions, and tells where one more polygon is free.

Every coordinate is a finite float and stands for exactly that number; nothing is
rounded but the coordinates that are handed back as floats, each once. Polygons, outer
faces and regions never change, so any number of threads may share them; a scene can
change, and has a lock. The work is done outside Python's global lock. All of them can be
pickled, and travel to other processes.
"""

import typing as _typing
from importlib.util import find_spec as _find_spec

from ._call import LeaveOut, Progress, Rounding
from ._contact_list import ContactList, contacts
from ._contacts import DTYPES as _DTYPES
from ._contacts import (
    Contact,
    ContactKind,
    Escape,
    Impact,
    Pair,
    Relation,
    Separation,
)
from ._contacts import dtype_of as _dtype_of
from ._facts import (
    EDGE_CORNER,
    EDGE_TRANSLATED,
    EDGE_TRANSLATED_CORNER,
    EdgeSource,
    Stats,
)
from ._ffi import Error, InputError, OutOfMemoryError
from ._locating import Location
from ._offset import offset
from ._outer_face import OuterFace
from ._pair_list import PairList
from ._parts import (
    PART_HOLE,
    PART_OUTER,
    PART_POINT,
    PART_SEGMENT,
    RegionPart,
    RegionPolygon,
)
from ._polygon import Polygon, Simplified
from ._region import Region
from ._region_sums import (
    entrance_region,
    inner_fit_region,
    minkowski_sum_region,
    minkowski_sum_region_many,
    no_fit_region,
    no_fit_region_many,
)
from ._result_list import ResultList
from ._scene import Scene
from ._sources import PolygonLike, PolygonsLike
from ._sums import (
    SupersetEdge,
    entrance_block,
    library_version,
    minkowski_sum,
    minkowski_sum_many,
    no_fit_polygon,
    no_fit_polygon_many,
    superset,
)
from ._two_polygons import cast, distance, penetration, relation

if _typing.TYPE_CHECKING:
    import numpy

    CONTACT_DTYPE: numpy.dtype[numpy.void]
    """Of an array of contacts; its fields are the members of gcv_contact. It takes numpy."""
    SEPARATION_DTYPE: numpy.dtype[numpy.void]
    """Of an array of what distance gives, likewise of gcv_separation."""
    ESCAPE_DTYPE: numpy.dtype[numpy.void]
    """Of an array of what penetration gives, likewise of gcv_escape."""
    IMPACT_DTYPE: numpy.dtype[numpy.void]
    """Of an array of what cast gives, likewise of gcv_impact."""
    PAIR_DTYPE: numpy.dtype[numpy.void]
    """Of an array of pairs, likewise of gcv_pair."""
else:

    def __getattr__(name: str) -> object:
        """The dtypes, which are made when they are asked for: only then is numpy needed."""
        if name not in _DTYPES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        try:
            return _dtype_of(_DTYPES[name])
        except ImportError:
            raise AttributeError(f"{__name__}.{name} takes numpy, which is not here") from None

    def __dir__() -> list[str]:
        return sorted({*globals(), *__all__})


INSIDE, BOUNDARY, OUTSIDE = Location.INSIDE, Location.BOUNDARY, Location.OUTSIDE
APART, TOUCHING, OVERLAPPING = Relation.APART, Relation.TOUCHING, Relation.OVERLAPPING

__all__ = [
    "APART",
    "BOUNDARY",
    "EDGE_CORNER",
    "EDGE_TRANSLATED",
    "EDGE_TRANSLATED_CORNER",
    "INSIDE",
    "OUTSIDE",
    "OVERLAPPING",
    "PART_HOLE",
    "PART_OUTER",
    "PART_POINT",
    "PART_SEGMENT",
    "TOUCHING",
    "Contact",
    "ContactKind",
    "ContactList",
    "EdgeSource",
    "Error",
    "Escape",
    "Impact",
    "InputError",
    "LeaveOut",
    "Location",
    "OutOfMemoryError",
    "OuterFace",
    "Pair",
    "PairList",
    "Polygon",
    "PolygonLike",
    "PolygonsLike",
    "Progress",
    "Region",
    "RegionPart",
    "RegionPolygon",
    "Relation",
    "ResultList",
    "Rounding",
    "Scene",
    "Separation",
    "Simplified",
    "Stats",
    "SupersetEdge",
    "cast",
    "contacts",
    "distance",
    "entrance_block",
    "entrance_region",
    "inner_fit_region",
    "library_version",
    "minkowski_sum",
    "minkowski_sum_many",
    "minkowski_sum_region",
    "minkowski_sum_region_many",
    "no_fit_polygon",
    "no_fit_polygon_many",
    "no_fit_region",
    "no_fit_region_many",
    "offset",
    "penetration",
    "relation",
    "superset",
]
if _typing.TYPE_CHECKING or _find_spec("numpy"):
    __all__ += [
        "CONTACT_DTYPE",
        "ESCAPE_DTYPE",
        "IMPACT_DTYPE",
        "PAIR_DTYPE",
        "SEPARATION_DTYPE",
    ]

__version__ = "0.2.0"

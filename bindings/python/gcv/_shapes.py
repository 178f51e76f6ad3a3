# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The names in pickles of versions 0.1 and 0.2.0, which say that they are of this module."""

from ._outer_face import EdgeSource, OuterFace, Stats
from ._polygon import Polygon, Simplified, _polygon_of

__all__ = ["EdgeSource", "OuterFace", "Polygon", "Simplified", "Stats", "_polygon_of"]

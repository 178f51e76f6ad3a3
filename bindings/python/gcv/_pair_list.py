# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The pairs of a scene that are near to each other."""

from __future__ import annotations

from . import _ffi, _structs
from ._contacts import Pair
from ._record_list import RecordList


class PairList(RecordList[Pair]):
    """Pairs of ids, by a, then by b; it never changes.

    Made by Scene.pairs and Scene.near. It is a sequence of Pair, and array and numpy.asarray
    have all of them, of dtype PAIR_DTYPE. Two lists are equal when their pairs are. It can be
    pickled; a pickled list is none that Scene.pairs takes as previous.
    """

    __slots__ = ()

    _struct, _noun, _read = _structs.Pair, "pair", _ffi.pair_list_pairs

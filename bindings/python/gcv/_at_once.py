# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Changes of an object of the library, together with what Python notes about them."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from itertools import chain
from typing import Any, Callable

from . import _ffi

_SUCCESS = {0: 0}


def at_once(
    function: Callable[..., int], arguments: Iterable[Any], *notes: Iterator[object]
) -> None:
    """Call a function of the library that returns its status, then exhaust the notes.

    Python runs handlers of signals, such as the one that raises KeyboardInterrupt, between
    its own instructions: not within one call of C. This is one. So the notes have to be
    iterators of C over functions of C, such as map(setattr, ...).

    Raises as other functions of the library do, and then leaves the notes alone.
    """
    statuses = map(function, *zip(arguments))
    try:
        deque(chain(map(_SUCCESS.__getitem__, statuses), *notes), 0)
    except KeyError as error:
        (status,) = error.args
        raise _ffi.error(status, _ffi.last_error_message()) from None


def setting(instance: object, name: str, values: Iterable[object]) -> Iterator[object]:
    """A note: give an attribute the first of the values."""
    return map(object.__setattr__, (instance,), (name,), values)

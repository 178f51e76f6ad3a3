# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Calls of the library that can take long."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from contextlib import ExitStack, suppress
from typing import Any, Callable, Literal, Optional, SupportsFloat, TypeVar, Union

from . import _ffi, _structs
from ._coordinates import count, number

Rounding = Literal["nearest", "outward"]
LeaveOut = Union[Literal["holes", "fits"], Iterable[Literal["holes", "fits"]]]
"""What a region is to lack, to save time: its holes, its segments and points, or both."""
Progress = Callable[[int, int], object]

_T = TypeVar("_T")

# The superset has in the order of n m edges at most: below this, no call is long.
SHORT = 1 << 16
_SECONDS_BETWEEN_REPORTS = 0.1


def run(
    call: Callable[[Any], _T],
    pairs: int,
    rounding: Rounding,
    tolerance: SupportsFloat,
    threads: int,
    progress: Optional[Progress],
    leave_out: LeaveOut = (),
) -> _T:
    """Return call(options), interruptible where it can take long.

    pairs is the number of pairs of vertices. Python runs signal handlers, such as the
    one that raises KeyboardInterrupt, in the main thread and between two of its own
    instructions: not while that thread computes. So it waits here, and another thread
    computes. Whatever exception ends the waiting cancels the call. Where no thread can start,
    as when the interpreter ends, this one computes.
    """
    if progress is not None and not callable(progress):
        raise TypeError(f"progress: {progress!r} is not callable")
    short = pairs <= SHORT or threading.current_thread() is not threading.main_thread()
    if progress is None and short:
        return call(_options(rounding, tolerance, threads, leave_out))

    latest = (0, 0)
    cancelled = 0

    def report(_context: object, done: int, estimate: int) -> int:
        nonlocal latest
        latest = (done, estimate)
        return cancelled

    options = _options(rounding, tolerance, threads, leave_out, _structs.Progress(report))
    # An interrupt can come while the other thread starts: then the pool does not know it. Who takes
    # the turn first decides whether it computes at all.
    turn, ended = threading.Lock(), threading.Event()

    def compute() -> _T:
        if not turn.acquire(blocking=False):
            raise RuntimeError("interrupted before it began")
        try:
            return call(options)
        finally:
            ended.set()

    with ExitStack() as pools:
        future = None
        try:
            with suppress(RuntimeError):
                # When the interpreter ends, it cannot even be imported.
                from concurrent.futures import ThreadPoolExecutor, wait

                future = pools.enter_context(ThreadPoolExecutor(1)).submit(compute)
            if future and progress is not None:
                while not wait((future,), _SECONDS_BETWEEN_REPORTS).done:
                    progress(*latest)
            result = future.result() if future else compute()
        except BaseException:
            cancelled = 1
            while not (turn.acquire(blocking=False) or ended.is_set()):
                with suppress(KeyboardInterrupt):
                    ended.wait()
            raise
    if progress is not None:
        progress(*latest)
    return result


def value_of(rounding: Rounding) -> int:
    """The rounding as the library takes it."""
    if not isinstance(rounding, str) or rounding not in _ffi.ROUNDINGS:
        raise _ffi.InputError(
            _ffi.INVALID_ARGUMENT, f"rounding is {rounding!r}, none of {', '.join(_ffi.ROUNDINGS)}"
        )
    return _ffi.ROUNDINGS[rounding]


def _bits(leave_out: LeaveOut) -> int:
    """What to leave out as the library takes it."""
    parts: tuple[Any, ...] = (leave_out,)
    if isinstance(leave_out, Iterable) and not isinstance(leave_out, str):
        parts = tuple(leave_out)
    for part in parts:
        if not isinstance(part, str) or part not in _ffi.LEAVE_OUTS:
            raise _ffi.InputError(
                _ffi.INVALID_ARGUMENT,
                f"leave_out is {part!r}, none of {', '.join(_ffi.LEAVE_OUTS)}",
            )
    return sum(_ffi.LEAVE_OUTS[part] for part in set(parts))


def _options(
    rounding: Rounding,
    tolerance: SupportsFloat,
    threads: int,
    leave_out: LeaveOut,
    report: Any = None,
) -> Any:
    """The options as the library takes them; None for the defaults."""
    bits = _bits(leave_out)
    tolerance, threads = number(tolerance, "tolerance"), count(threads, "threads")
    if report is None and (rounding, tolerance, threads, bits) == ("nearest", 0, 1, 0):
        return None
    options = _structs.sized(
        _structs.Options,
        rounding=value_of(rounding),
        tolerance=tolerance,
        threads=threads,
        leave_out=bits,
    )
    if report is not None:
        options.progress = report
    return options

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The lock of a scene."""

from __future__ import annotations

import os
import threading
import time
from typing import Callable, Optional, TypeVar
from weakref import ref

_T = TypeVar("_T")

_SHORTEST_PAUSE, _LONGEST_PAUSE = 1e-4, 1e-2


class Gate:
    """Lets in any number of threads that ask, or one that changes.

    A change waits until no thread asks, and threads that come to ask wait until it is
    done. A thread that asks may ask more meanwhile, but not change: it would wait for
    itself. So that raises RuntimeError. A thread that changes may do neither.

    A handler of a signal can raise at any call of a function, at the begin of one, and
    when a loop goes round. So nothing that has to be undone is left to a function of
    Python: it is undone by the end of a with statement of a plain lock, or by a finally
    clause that begins with the only call of it, one of C. (Python 3.9 runs handlers between
    other instructions, too: there one can come in between, if rarely.)

    A process that comes of a fork has the thread alone that forked. What others asked at
    that time is over there. What one of them was changing may be changed in part: it lets
    nobody in.
    """

    def __init__(self) -> None:
        self._turnstile = threading.Lock()
        """What all pass that come to ask. One that changes is in it, or waits there."""
        self._is_broken = False
        self._asking: dict[object, int] = {}
        """The threads that ask at the moment, each as often as it does."""
        self._changing: Optional[int] = None
        """The thread that changes."""
        _GATES.add(ref(self, _GATES.discard))

    def ask(self, call: Callable[[], _T], caller: Optional[int] = None) -> _T:
        """Return call() while nothing changes.

        caller: the thread that waits for this one. Where it asks, this one need not wait.
        """
        thread = threading.get_ident()
        self._refuse_within_change(thread)
        question, end = object(), self._asking.pop
        try:
            if (caller or thread) in list(self._asking.values()):
                self._asking[question] = thread
            else:
                with self._turnstile:
                    self._asking[question] = thread
            return call()
        finally:
            end(question, None)

    def change(self, call: Callable[[], _T]) -> _T:
        """Return call() while nothing else goes on."""
        thread = threading.get_ident()
        self._refuse_within_change(thread)
        if thread in list(self._asking.values()):
            raise RuntimeError("the scene is being asked: it cannot change before that ends")
        with self._turnstile:
            pause = _SHORTEST_PAUSE
            while self._asking:
                time.sleep(pause)
                pause = min(2 * pause, _LONGEST_PAUSE)
            try:
                self._changing = thread
                return call()
            finally:
                self._changing = None

    def _refuse_within_change(self, thread: int) -> None:
        if self._is_broken:
            raise RuntimeError("another thread was changing the scene when the process forked")
        if self._changing == thread:
            raise RuntimeError("the scene is being changed: nothing else can be done meanwhile")

    def _after_fork(self) -> None:
        thread = threading.get_ident()
        for question, known in list(self._asking.items()):
            if known != thread:
                del self._asking[question]
        if self._changing != thread:
            self._turnstile = threading.Lock()
            self._is_broken = self._is_broken or self._changing is not None


# References that end by a function of C: no handler of a signal can raise meanwhile.
_GATES: set[ref[Gate]] = set()


def _after_fork() -> None:
    for reference in list(_GATES):
        gate = reference()
        if gate is not None:
            gate._after_fork()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)

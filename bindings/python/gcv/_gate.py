# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The lock of a scene."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Optional
from weakref import WeakSet


class Gate:
    """Lets in any number of threads that ask, or one that changes.

    A change waits until no thread asks, and threads that come to ask wait until it is
    done. A thread that asks may ask more meanwhile, but not change: it would wait for
    itself. So that raises RuntimeError. A thread that changes may do neither.

    A process that comes of a fork has the thread alone that forked. What others asked at
    that time is over there. What one of them was changing may be changed in part: it lets
    nobody in.
    """

    def __init__(self) -> None:
        self._state = threading.Condition()
        self._is_broken = False
        _GATES.add(self)
        self._asking: dict[int, int] = {}
        """How often each thread asks at the moment."""
        self._changing: Optional[int] = None
        """The thread that changes."""
        self._waiting = 0
        """The number of threads that wait to change."""

    @contextmanager
    def asking(self) -> Iterator[None]:
        thread = threading.get_ident()
        with self._state:
            self._refuse_within_change(thread)
            if thread not in self._asking:
                self._state.wait_for(lambda: self._changing is None and not self._waiting)
            self._asking[thread] = self._asking.get(thread, 0) + 1
        try:
            yield
        finally:
            with self._state:
                self._asking[thread] -= 1
                if not self._asking[thread]:
                    del self._asking[thread]
                    self._state.notify_all()

    @contextmanager
    def changing(self) -> Iterator[None]:
        thread = threading.get_ident()
        with self._state:
            self._refuse_within_change(thread)
            if thread in self._asking:
                raise RuntimeError("the scene is being asked: it cannot change before that ends")
            self._waiting += 1
            try:
                self._state.wait_for(lambda: self._changing is None and not self._asking)
                self._changing = thread
            finally:
                self._waiting -= 1
                self._state.notify_all()
        try:
            yield
        finally:
            with self._state:
                self._changing = None
                self._state.notify_all()

    def _refuse_within_change(self, thread: int) -> None:
        if self._is_broken:
            raise RuntimeError("another thread was changing the scene when the process forked")
        if self._changing == thread:
            raise RuntimeError("the scene is being changed: nothing else can be done meanwhile")

    def _after_fork(self) -> None:
        thread = threading.get_ident()
        self._state = threading.Condition()
        self._asking = {known: n for known, n in self._asking.items() if known == thread}
        self._is_broken = self._is_broken or self._changing not in (None, thread)
        self._waiting = 0


_GATES: WeakSet[Gate] = WeakSet()


def _after_fork() -> None:
    for gate in list(_GATES):
        gate._after_fork()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)

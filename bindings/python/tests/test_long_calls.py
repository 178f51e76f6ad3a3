# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Progress and interruption of calls that take long."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Callable

import numpy as np
import pytest
from shapes import SQUARE, scaled, star

import gcv
from gcv import _structs
from gcv._call import run

LARGE = star(60000, 1)
OTHER = star(60000, 2)
MANY = [LARGE] * 20
OTHERS = [OTHER] * 20
BRICKS = gcv.Scene()
BRICKS.add([SQUARE] * 1500, [(3 * (k % 40), 3 * (k // 40)) for k in range(1500)])
MOVES = np.random.default_rng(1).uniform(-2, 2, (100000, 2))
CALLS: list[Callable[[], object]] = [
    lambda: LARGE + OTHER,
    lambda: gcv.minkowski_sum(LARGE, OTHER, threads=2),
    lambda: gcv.no_fit_polygon(LARGE, OTHER, (0, 0)),
    lambda: gcv.entrance_block(LARGE, OTHER, (0, 0)),
    lambda: gcv.minkowski_sum_many(MANY, OTHERS),
    lambda: gcv.minkowski_sum_many(MANY, OTHERS, threads=2),
    lambda: gcv.no_fit_polygon_many(MANY, OTHERS),
    lambda: gcv.minkowski_sum_region(LARGE, OTHER),
    lambda: gcv.no_fit_region(LARGE, OTHER, threads=2),
    lambda: gcv.entrance_region(LARGE, OTHER),
    lambda: gcv.inner_fit_region(LARGE, OTHER),
    lambda: gcv.minkowski_sum_region_many(MANY, OTHERS),
    lambda: gcv.no_fit_region_many(MANY, OTHERS, threads=2),
    lambda: gcv.relation(LARGE, OTHER, MOVES),
    lambda: gcv.distance(LARGE, OTHER, MOVES, threads=2),
    lambda: gcv.penetration(LARGE, OTHER, MOVES),
    lambda: gcv.penetration(LARGE, OTHER),
    lambda: gcv.contacts(LARGE, OTHER, (0, 0), 1000),
    lambda: BRICKS.contacts(1000),
    lambda: BRICKS.pairs(1000),
    lambda: gcv.cast(LARGE, OTHER, MOVES, (1, 0)),
]


class TimeIsUpError(Exception):
    pass


@contextmanager
def interrupted() -> Iterator[None]:
    """Ctrl-C while the block runs, which must end with KeyboardInterrupt."""
    timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        yield
    timer.join()


def assert_alone() -> None:
    """No other thread is left, but for one that is about to end."""
    for _ in range(1000):
        if threading.active_count() == 1:
            return
        time.sleep(0.001)
    raise AssertionError(threading.enumerate())


@pytest.mark.parametrize("call", CALLS)
def test_keyboard_interrupt_cancels(call: Callable[[], object]) -> None:
    with interrupted():
        call()
    assert_alone()


def test_interruption_ends_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    answers: list[int] = []
    progress = _structs.Progress

    # Interrupts at the third report, and answers it only when the call is cancelled.
    def interrupting(report: Callable[[object, int, int], int]) -> object:
        def answer(context: object, done: int, estimate: int) -> int:
            if len(answers) == 2:
                os.kill(os.getpid(), signal.SIGINT)
                for _ in range(60000):
                    if report(context, done, estimate):
                        break
                    time.sleep(0.001)
            answers.append(report(context, done, estimate))
            return answers[-1]

        return progress(answer)

    monkeypatch.setattr(_structs, "Progress", interrupting)
    with pytest.raises(KeyboardInterrupt):
        gcv.minkowski_sum_many(MANY, OTHERS)
    assert answers == [0, 0, 1]


def test_other_signals_cancel_too() -> None:
    def time_is_up(_signal: int, _frame: object) -> None:
        raise TimeIsUpError

    before = signal.signal(signal.SIGALRM, time_is_up)
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    try:
        with pytest.raises(TimeIsUpError):
            gcv.minkowski_sum_many(MANY, OTHERS)
    finally:
        signal.signal(signal.SIGALRM, before)


def test_progress() -> None:
    reports: list[tuple[int, int]] = []
    thread = threading.get_ident()

    def progress(done: int, estimate: int) -> None:
        assert threading.get_ident() == thread
        reports.append((done, estimate))

    plain = LARGE + OTHER
    assert gcv.minkowski_sum(LARGE, OTHER, progress=progress) == plain
    assert len(reports) > 1
    steps = [done for done, _ in reports]
    assert steps == sorted(steps)
    assert all(done <= estimate for done, estimate in reports)
    assert reports[-1][0] == reports[-1][1] > 0

    reports.clear()
    gcv.minkowski_sum(SQUARE, SQUARE, progress=progress)
    assert len(reports) == 1


def test_progress_of_another_thread() -> None:
    threads = set()

    def work() -> None:
        gcv.minkowski_sum(LARGE, OTHER, progress=lambda *_: threads.add(threading.get_ident()))

    worker = threading.Thread(target=work)
    worker.start()
    worker.join()
    assert threads == {worker.ident}


def test_progress_that_is_no_function() -> None:
    """It is refused before anything is computed."""
    wrong: Any = 5
    for name in ("minkowski_sum", "no_fit_region", "relation", "contacts"):
        with pytest.raises(TypeError, match=r"^progress: 5 is not callable$"):
            getattr(gcv, name)(LARGE, OTHER, progress=wrong)
    with pytest.raises(TypeError, match=r"^progress: 5 is not callable$"):
        BRICKS.pairs(1, progress=wrong)
    begun: list[object] = []
    with pytest.raises(TypeError, match=r"^progress: 5 is not callable$"):
        run(begun.append, 1, "nearest", 0, 1, wrong)
    assert begun == []


def test_progress_that_raises_cancels() -> None:
    def progress(_done: int, _estimate: int) -> None:
        raise TimeIsUpError

    with pytest.raises(TimeIsUpError):
        gcv.minkowski_sum_many(MANY, OTHERS, progress=progress)
    assert_alone()


def test_failures_in_the_computing_thread() -> None:
    huge = scaled(SQUARE, 1e308)
    with pytest.raises(gcv.Error, match="coordinate") as raised:
        gcv.minkowski_sum(huge, huge, progress=print)
    assert raised.value.status_name == "GCV_ERR_RANGE"
    with pytest.raises(gcv.Error, match="pair 1: "):
        gcv.minkowski_sum_many([LARGE, huge], [LARGE, huge])


def test_an_interrupt_while_the_other_thread_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing goes on behind the caller's back."""
    start = threading.Thread.start

    def interrupted_start(thread: threading.Thread) -> None:
        start(thread)
        raise KeyboardInterrupt

    begun: list[int] = []
    ended: list[int] = []

    def call(_options: object) -> None:
        begun.append(1)
        time.sleep(0.2)
        ended.append(1)

    monkeypatch.setattr(threading.Thread, "start", interrupted_start)
    with pytest.raises(KeyboardInterrupt):
        run(call, 1 << 20, "nearest", 0, 1, None)
    assert begun == ended
    time.sleep(0.3)
    assert begun == ended


@pytest.mark.parametrize("before", ["", "import concurrent.futures.thread"])
@pytest.mark.parametrize(
    "call",
    [
        "gcv.minkowski_sum(a, a)",
        "gcv.minkowski_sum(a, a, progress=lambda *counts: calls.append(counts))",
    ],
)
def test_when_the_interpreter_ends(call: str, before: str) -> None:
    code = f"""
import atexit, gcv
{before}
a = gcv.Polygon([(k, k * k) for k in range(500)])
calls = []
atexit.register(lambda: print(len({call}), len(calls)))
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == f"500 {int('progress' in call)}\n"
    assert run.stderr == ""

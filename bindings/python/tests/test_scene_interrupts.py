# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Handlers of signals that raise, such as that of Ctrl-C, while a scene is in use."""

from __future__ import annotations

import gc
import pickle
import signal
import sys
import threading
import time
from collections.abc import Iterator
from functools import partial
from typing import Any, Callable

import numpy as np
import pytest
from shapes import SQUARE
from test_long_calls import TimeIsUpError
from test_scene_questions import BLOCK, row

import gcv
from gcv import _ffi

OTHER = gcv.Polygon([(0, 0), (5, 0), (5, 1), (2, 3), (0, 1)])
MANY = np.zeros((5, 2))
CHANGES: list[Callable[[gcv.Scene], object]] = [
    lambda scene: scene.add(OTHER),
    lambda scene: scene.add(OTHER, MANY),
    lambda scene: scene.set(2, OTHER),
    lambda scene: scene.set([2, 4], OTHER, (9, 9)),
    lambda scene: scene.move(2, (9, 9)),
    lambda scene: scene.set_layers([2, 3], 1),
    lambda scene: scene.remove([2, 4]),
    lambda scene: setattr(scene, "container", OTHER),
]
QUESTIONS: list[Callable[[gcv.Scene], object]] = [
    lambda scene: scene.relation(OTHER),
    lambda scene: scene.penetration(OTHER),
    lambda scene: scene.free_region(OTHER, (0, 0, 9, 9)),
    lambda scene: scene.pairs(1),
    lambda scene: scene.ids,
    lambda scene: scene.positions(),
    lambda scene: scene.copy(),
    lambda scene: scene._repr_svg_(),
    pickle.dumps,
]


@pytest.fixture(autouse=True)
def _no_collector() -> Iterator[None]:
    """What a handler raises is lost in functions of Python that the collector calls."""
    gc.disable()
    yield
    gc.enable()


def base() -> gcv.Scene:
    scene = row()
    scene.set_layers([3, 4], [2, 3])
    return scene


def state(scene: gcv.Scene) -> Any:
    """All that there is to know; the library and Python agree about it."""
    ids = scene.ids.tolist()
    assert ids == list(scene)
    polygons = [scene.polygon(id) for id in ids]
    known = [scene.relation(BLOCK, ignore=id) for id in ids]
    assert scene._vertices == sum(len(polygon) for polygon in polygons)
    new = scene.copy().add(BLOCK)
    places = scene.positions().tolist()
    return ids, places, list(map(id, polygons)), dict(scene._layers), scene.container, known, new


def assert_open(scene: gcv.Scene) -> None:
    """It can be changed, by this thread and by others."""
    scene.move(3, scene.positions(3))
    worker = threading.Thread(target=scene.move, args=(3, scene.positions(3)), daemon=True)
    worker.start()
    worker.join(2)
    assert not worker.is_alive()


def raises_at(number: int, call: Callable[[], object]) -> bool:
    """Whether the call comes to that place of those at which handlers run, and ends there.

    They run where functions of Python begin, and where functions end.
    """
    left = number

    def profile(_frame: object, event: str, _argument: object) -> None:
        nonlocal left
        if event in ("call", "return", "c_return"):
            left -= 1
            if left == 0:
                raise KeyboardInterrupt

    try:
        sys.setprofile(profile)
        call()
    except KeyboardInterrupt:
        return True
    finally:
        sys.setprofile(None)
    assert left > 0, "the interrupt was lost"
    return False


@pytest.mark.parametrize("change", CHANGES)
def test_an_interrupted_change_is_whole(change: Callable[[gcv.Scene], object]) -> None:
    before = state(base())
    scene = base()
    change(scene)
    after = state(scene)
    found: list[Any] = []
    while True:
        scene = base()
        if not raises_at(len(found) + 1, partial(change, scene)):
            break
        found.append(state(scene))
        assert found[-1] in (before, after)
        assert_open(scene)
    assert found[0] == before
    assert found[-1] == after
    assert found.count(before) + found.count(after) == len(found) > 10


@pytest.mark.parametrize("question", QUESTIONS)
def test_an_interrupted_question_is_over(question: Callable[[gcv.Scene], object]) -> None:
    scene = base()
    before, number = state(scene), 1
    while raises_at(number, partial(question, scene)):
        assert_open(scene)
        number += 1
    assert state(scene) == before


def ended_by_alarm(call: Callable[[], object], seconds: float) -> None:
    """Make the call. A handler that raises ends it in so many seconds, if not 0."""

    def time_is_up(_signal: int, _frame: object) -> None:
        raise TimeIsUpError

    before = signal.signal(signal.SIGALRM, time_is_up)
    try:
        with pytest.raises(TimeIsUpError):
            signal.setitimer(signal.ITIMER_REAL, seconds)
            call()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_an_interrupt_while_many_members_change() -> None:
    """It comes after the change."""
    scene = gcv.Scene()
    scene.add(BLOCK, np.zeros((30_000, 2)))

    def remove_all(scene: gcv.Scene) -> None:
        scene.remove(scene.ids)
        time.sleep(1)

    for seconds in np.linspace(1e-3, 2e-2, 12):
        changed = scene.copy()
        ended_by_alarm(partial(remove_all, changed), seconds)
        assert changed.ids.tolist() == list(changed)
        assert len(changed) in (0, 30_000)
        assert changed._vertices == 4 * len(changed)


def test_a_question_that_nobody_waits_for() -> None:
    """Nothing changes before the thread that computes is done, after however many interrupts."""
    scene, go = row(), threading.Event()
    ended: list[bool] = []

    def compute(_options: object) -> None:
        signal.setitimer(signal.ITIMER_REAL, 0.05, 0.05)
        assert go.wait(10)
        ended.append(True)

    ended_by_alarm(lambda: scene._ask(compute, 1 << 30, 1, None), 0)
    assert not ended
    threading.Timer(0.1, go.set).start()
    scene.move(2, (1, 1))
    assert ended


@pytest.mark.parametrize(
    "kind", [_ffi.Polygon, _ffi.Region, _ffi.Scene, _ffi.PairList, gcv.Polygon, gcv.Scene]
)
def test_no_python_runs_where_handles_end(kind: type[Any]) -> None:
    """What a handler raises there would be lost."""
    held: list[Any] = [kind(SQUARE) if kind in (gcv.Polygon, gcv.Scene) else kind()]
    frames: list[str] = []

    def profile(frame: Any, event: str, _argument: object) -> None:
        if event == "call":
            frames.append(frame.f_code.co_name)

    sys.setprofile(profile)
    held.clear()
    sys.setprofile(None)
    assert frames == []

# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Scenes that threads share, and questions to them that take long."""

from __future__ import annotations

import os
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any, Callable

import numpy as np
import pytest
from shapes import SQUARE, star
from test_long_calls import TimeIsUpError, assert_alone, interrupted
from test_scene_questions import BLOCK, row

import gcv
from gcv._gate import Gate

CROWD = gcv.Scene()
CROWD.add(
    [star(2000, seed) for seed in range(20)],
    np.random.default_rng(3).uniform(-5, 5, (20, 2)),
)
CROWDED_ROOM = CROWD.copy()
CROWDED_ROOM.container = [(-5, -5), (5, -5), (5, 5), (-5, 5)]
VISITOR = star(2000, 99)
PLACES = np.random.default_rng(1).uniform(-6, 6, (300000, 2))
LONG: list[Callable[..., object]] = [
    lambda **options: CROWD.relation(VISITOR, PLACES, **options),
    lambda **options: CROWD.distance(VISITOR, PLACES, threads=2, **options),
    lambda **options: CROWD.cast(VISITOR, PLACES, (1, 0), **options),
    lambda **options: CROWD.free_region(VISITOR, (-6, -6, 6, 6), threads=2, **options),
    lambda **options: CROWDED_ROOM.best(VISITOR, (-1, 0), **options),
    lambda **options: CROWD.penetration(VISITOR, PLACES, ignore=range(3, 22), **options),
]


def nothing() -> None:
    pass


@pytest.mark.parametrize("question", LONG)
def test_keyboard_interrupt_cancels(question: Callable[..., object]) -> None:
    with interrupted():
        question()
    assert_alone()
    CROWD.move(2, CROWD.positions(2))


@pytest.mark.parametrize("question", LONG)
def test_progress_that_raises_cancels(question: Callable[..., object]) -> None:
    def progress(_done: int, _estimate: int) -> None:
        raise TimeIsUpError

    with pytest.raises(TimeIsUpError):
        question(progress=progress)
    assert_alone()
    CROWD.move(2, CROWD.positions(2))


CHANGES: list[Callable[[gcv.Scene], object]] = [
    lambda scene: scene.add(BLOCK),
    lambda scene: scene.set(2, BLOCK),
    lambda scene: scene.move(2, (9, 9)),
    lambda scene: scene.set_layers(2, 1),
    lambda scene: scene.remove(2),
    lambda scene: setattr(scene, "container", SQUARE),
]


@pytest.mark.parametrize("change", CHANGES)
def test_progress_must_not_change_the_scene(change: Callable[[gcv.Scene], object]) -> None:
    scene = row()
    questions: list[Callable[[Any], object]] = [
        lambda progress: scene.relation(BLOCK, (1, 0), progress=progress),
        lambda progress: scene.distance(BLOCK, [(1, 0)], progress=progress),
        lambda progress: scene.cast(BLOCK, (1, 0), (1, 0), progress=progress),
        lambda progress: scene.near(BLOCK, (1, 0), 1, progress=progress),
        lambda progress: scene.free_region(BLOCK, (0, 0, 9, 9), progress=progress),
        lambda progress: scene.penetration(BLOCK, (1, 0), progress=progress),
        lambda progress: scene.pairs(1, progress=progress),
        lambda progress: scene.contacts(1, progress=progress),
    ]
    for question in questions:
        with pytest.raises(RuntimeError, match=r"^the scene is being asked: it cannot change "):
            question(lambda *_: change(scene))
    assert scene.ids.tolist() == [2, 3, 4]
    assert scene.positions(2) == (0, 0)
    assert scene.container is None
    change(scene)


def test_progress_may_ask_the_scene() -> None:
    scene = row()
    told: list[Any] = []

    def progress(_done: int, _estimate: int) -> None:
        told.append((scene.relation(BLOCK, (1, 0)), len(scene), scene.copy().ids.tolist()))

    scene.pairs(1, progress=progress)
    assert told == [(gcv.TOUCHING, 3, [2, 3, 4])]


def test_progress_may_change_another_scene() -> None:
    scene, other = row(), row()
    scene.pairs(1, progress=lambda *_: other.remove(other.ids))
    assert len(other) == 0


def test_threads() -> None:
    """Two members that move together are never seen apart."""
    scene = gcv.Scene()
    left, right = scene.add(BLOCK, [(0, 0), (1, 0)])
    stop = threading.Event()

    def look() -> int:
        looks = 0
        while not stop.is_set():
            assert list(scene.pairs()) == [(left, right, gcv.TOUCHING)]
            assert np.ptp(scene.positions()[:, 0]) == 1
            assert scene.distance(BLOCK, (0, 9)).id in (left, right)
            assert scene.free_region(BLOCK, (-9, 0, 400, 9)).area == 409 * 9 - 3
            looks += 1
        return looks

    with ThreadPoolExecutor(3) as pool:
        looking = [pool.submit(look) for _ in range(3)]
        for k in range(300):
            scene.move([left, right], [(k, 0), (k + 1, 0)])
            added = scene.add(BLOCK, (k, 20))
            scene.set_layers(added, 2)
            scene.remove(added)
        stop.set()
        assert all(done.result() > 0 for done in looking)


def test_threads_that_all_change() -> None:
    scene = gcv.Scene()

    def work(k: int) -> list[int]:
        kept = []
        for n in range(50):
            first, second = scene.add(BLOCK, [(3 * n, 3 * k), (3 * n, -3 * k)]).tolist()
            scene.remove(first)
            kept.append(second)
        return kept

    with ThreadPoolExecutor(4) as pool:
        kept = [id for ids in pool.map(work, range(4)) for id in ids]
    assert sorted(kept) == list(scene) == scene.ids.tolist()
    assert scene.add(BLOCK) == 402


def test_a_change_waits_for_questions() -> None:
    scene = row()
    changing, changed = threading.Event(), threading.Event()

    def change() -> None:
        changing.set()
        scene.remove(2)
        changed.set()

    worker = threading.Thread(target=change)

    def progress(_done: int, _estimate: int) -> None:
        worker.start()
        assert changing.wait(10)
        assert not changed.wait(0.05)
        # A thread that asks may go on while a change waits for it.
        assert scene.relation(BLOCK, (-1, 0)) is gcv.TOUCHING

    assert scene.pairs(1, progress=progress)[0][:2] == (2, 3)
    worker.join()
    assert changed.is_set()
    assert 2 not in scene


def test_an_interrupted_change_that_waits() -> None:
    """Questions go on where a change gave up waiting for others."""
    gate = Gate()
    asking, done = threading.Event(), threading.Event()

    def wait() -> None:
        asking.set()
        done.wait(10)

    worker = threading.Thread(target=gate.ask, args=(wait,))
    worker.start()
    asking.wait(10)

    def time_is_up(_signal: int, _frame: object) -> None:
        raise TimeIsUpError

    before = signal.signal(signal.SIGALRM, time_is_up)
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    try:
        with pytest.raises(TimeIsUpError):
            gate.change(nothing)
    finally:
        signal.signal(signal.SIGALRM, before)
    gate.ask(nothing)
    done.set()
    worker.join()
    gate.change(nothing)


def test_nothing_goes_on_within_a_change() -> None:
    gate = Gate()

    def refused(again: Callable[[Callable[[], None]], None], message: str) -> None:
        with pytest.raises(RuntimeError, match=f"^the scene is being {message}: "):
            again(nothing)

    for again in (gate.ask, gate.change):
        gate.change(partial(refused, again, "changed"))
    gate.ask(lambda: gate.ask(lambda: refused(gate.change, "asked")))
    gate.change(nothing)


def test_a_long_change_is_made_as_a_whole() -> None:
    """Ctrl-C comes meanwhile, and the scene knows all of its members."""
    scene = gcv.Scene()
    polygons = [star(3000, seed) for seed in range(100)]
    with interrupted():
        for _ in range(10000):
            scene.add(polygons)
    assert scene.ids.tolist() == list(scene)
    assert len(scene) % 100 == 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no forks here")
def test_forked_processes_do_not_wait_for_threads_of_their_parents() -> None:
    scene, changing = row(), row()
    asked, go = threading.Event(), threading.Event()

    def wait(*_: object) -> None:
        asked.set()
        assert go.wait(30)

    def change() -> None:
        changing._gate.change(wait)

    workers = [
        threading.Thread(target=lambda: scene.relation(BLOCK, (1, 0), progress=wait)),
        threading.Thread(target=change),
    ]
    for worker in workers:
        asked.clear()
        worker.start()
        assert asked.wait(30)
    child = os.fork()
    if child == 0:
        signal.alarm(30)  # it ends, whatever it waits for
        scene.move(2, (0, 5))
        is_right = scene.positions(2) == (0, 5)
        try:
            changing.relation(BLOCK, (1, 0))
        except RuntimeError as error:
            is_right = is_right and "when the process forked" in str(error)
            os._exit(not is_right)
        os._exit(2)
    _, status = os.waitpid(child, 0)
    go.set()
    for worker in workers:
        worker.join()
    assert status == 0
    scene.move(2, (0, 5))


def test_a_forked_process_goes_on_with_its_own_question() -> None:
    gate = Gate()

    def fork() -> None:
        gate._after_fork()
        with pytest.raises(RuntimeError, match=r"^the scene is being asked: "):
            gate.change(nothing)

    gate.ask(fork)
    gate.change(gate._after_fork)
    gate.ask(nothing)


QUESTIONS_ABOUT_ALL: list[Callable[[gcv.Scene, Any], object]] = [
    lambda scene, stop: scene.pairs(1e4, progress=stop),
    lambda scene, stop: scene.contacts(20, progress=stop),
    lambda scene, stop: scene.contacts(20, threads=2, progress=stop),
]


@pytest.mark.parametrize("question", QUESTIONS_ABOUT_ALL)
def test_questions_about_all_members_end_soon(question: Callable[..., object]) -> None:
    """Where one block of members takes long, too."""
    scene = gcv.Scene()
    scene.add([star(100, seed) for seed in range(60)], [(k % 8, k // 8) for k in range(60)])
    scene.add(SQUARE, [(30 + 2 * (k % 40), 2 * (k // 40)) for k in range(2000)])
    stopped: list[float] = []

    def stop(_done: int, _estimate: int) -> None:
        if not stopped and time.perf_counter() > begun + 0.05:
            stopped.append(time.perf_counter())
            raise TimeIsUpError

    begun = time.perf_counter()
    with pytest.raises(TimeIsUpError):
        question(scene, stop)
    assert time.perf_counter() < stopped[0] + 0.3

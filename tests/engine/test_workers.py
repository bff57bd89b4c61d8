"""Workers: they divide what there is to do, each part done once, and make no difference to the bits."""

from __future__ import annotations

import gc
import os
import threading
from pathlib import Path

import numpy as np
import pytest

import sandbox
from sandbox._atomics import atomic_load
from sandbox._compiling import weight_of
from sandbox._jit import Call, entry_point, jit_enabled, kernel_argument
from sandbox.engine import stepper
from sandbox.engine.joints import part_layout
from sandbox.engine.memory import limit
from sandbox.engine.records.workers import SIZE, workers_memory
from sandbox.engine.step import finish, solve
from sandbox.engine.workers.parallel_for import CLOSED, first_part, next_part, note_done, take
from sandbox.engine.workers.serve import serve
from sandbox.engine.workers.threads import WorkerThreads
from sandbox.engine.world import World
from sandbox.errors import ArgumentError
from sandbox.resources import find_scene
from tests.determinism import busy, jointed
from tests.shipped import FILES, shipped

compiled_only = pytest.mark.skipif(not jit_enabled(), reason="without the compiler there is one thread")
SOLE = 1
COUNTED = 100_000
HELPED = 60
"""A word that no task uses: 1 once a helper has done a part."""


@pytest.fixture
def share_all(monkeypatch):
    """Small worlds are shared as well."""
    monkeypatch.setattr(stepper, "_WORTH_SHARING", 0)


@entry_point
def offer(workers, marks):
    """Mark all numbers, with whoever else takes part, ten times; how many parts this worker did."""
    parts = 0
    for turn in range(10):
        first, end = first_part(workers, turn, 0, marks.shape[0])
        while first < end:
            for k in range(first, end):
                marks[k] += 1
            parts += 1
            first, end = next_part(workers, first, end)
    return parts


@entry_point
def help_out(workers, marks):
    """Mark what is left to take until the words say that it is over; how many parts that were."""
    parts = 0
    while atomic_load(workers.words, CLOSED) == 0:
        first, end = take(workers.words, workers.number)
        if first < end:
            for k in range(first, end):
                marks[k] += 1
            note_done(workers.words, end - first)
            parts += 1
            workers.words[HELPED] = 1
    return parts


@compiled_only
@pytest.mark.parametrize("helpers", [0, 1, 3])
def test_every_number_of_a_task_is_done_once(helpers):
    """By threads that run at the same time, as none of them has the interpreter's lock."""
    workers, marks = workers_memory(1 + helpers), np.zeros(COUNTED, np.int64)
    workers.words[SIZE] = 1 + helpers
    tables = kernel_argument((workers, marks))
    offering = Call(offer, tables, unlocked=True).bind()
    parts: list[int] = []
    numbered = [kernel_argument((workers._replace(number=number), marks)) for number in range(1, 1 + helpers)]
    helping = [Call(help_out, each, unlocked=True).bind() for each in numbered]
    threads = [threading.Thread(target=lambda run=run: parts.append(run())) for run in helping]
    for thread in threads:
        thread.start()
    turns = 0
    while turns == 0 or (helpers > 0 and workers.words[HELPED] == 0 and turns < 200):
        offering()
        turns += 1
    workers.words[CLOSED] = 1
    for thread in threads:
        thread.join()
    assert (marks == 10 * turns).all()
    assert (sum(parts) > 0) == (helpers > 0)


@compiled_only
@pytest.mark.parametrize("workers", [2, 4])
@pytest.mark.parametrize("name", ["box2d-large-pyramid", "box2d-compounds", "box2d-many-pyramids"])
def test_large_scenes_end_the_same(name, workers):
    loaded = sandbox.load_scene(find_scene(Path(name)))
    one, several = World(loaded), World(loaded, workers)
    for _ in range(4):
        one.step(2)
        several.step(2)
        assert several.digest() == one.digest()


@compiled_only
@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_shipped_scenes_go_the_same_way(name, share_all):
    one, several = World(shipped(name)), World(shipped(name), 3)
    for _ in range(12):
        one.step(10)
        several.step(10)
        assert several.digest() == one.digest()


@pytest.mark.parametrize("made", [busy, jointed])
def test_a_busy_scene_with_commands_goes_the_same_way(made, share_all):
    assert made.digests(World(made.scene(), 3)) == made.digests(World(made.scene()))


def net(size: int) -> sandbox.Scene:
    """A square net of boxes with joints of all kinds that lie in lanes. It hangs on the world and on a lift, and tears
    where that pulls."""
    kinds = ({"type": "revolute"}, {"type": "distance"}, {"type": "distance", "hertz": 8.0}, {"type": "weld"})
    lift = {"id": "lift", "type": "kinematic", "position": [2.0 * size, 2.0], "velocity": [4.0, 1.0]}
    bodies = [{**lift, "shapes": [{"box": [1, 1]}]}]
    joints: list[dict[str, object]] = []

    def join(above: str | None, below: str, x: float, y: float, **way: object) -> None:
        kind = kinds[len(joints) % 4]
        ends = {"anchors": [[x, y + 0.2], [x, y - 0.2]]} if kind["type"] == "distance" else {"anchor": [x, y]}
        names = [above, below] if above else [below]
        joints.append({"id": f"j{len(joints)}", "bodies": names, **kind, **ends, **way})

    for row in range(size):
        for column in range(size):
            name, x, y = f"b{row}-{column}", float(column), -float(row)
            bodies.append({"id": name, "position": [x, y], "shapes": [{"box": [0.6, 0.6], "mask": []}]})
            if row == 0:
                join("lift" if 2 * column > size else None, name, x, 0.5, break_force=60.0 if column % 3 else 1e6)
            else:
                join(f"b{row - 1}-{column}", name, x, y + 0.5)
            if column > 0:
                join(f"b{row}-{column - 1}", name, x - 0.5, y)
    return sandbox.Scene(bodies=bodies, joints=joints)


@compiled_only
def test_nets_that_hang_and_tear_go_the_same_way(share_all, monkeypatch):
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -1000)  # none is factorised
    one, several = World(net(12)), World(net(12), 3)
    assert len(one.scratch.joints.side_by_side.joints) == 12 * 23
    for _ in range(40):
        one.step()
        several.step()
        assert several.digest() == one.digest()
    broken = int(one.state.counters[0].broken_count)
    assert 0 < broken == int(several.state.counters[0].broken_count)
    assert float(one.body("lift").velocity[0]) == 4.0


@compiled_only
def test_who_leaves_the_world_in_free_flight_is_counted_once(share_all):
    """Each of the workers freezes some, as bodies fly and as their step ends."""
    discs = [
        {"id": f"disc-{k}", "position": [3.0 * k, 5.0 * k], "velocity": [1e6, 0.0], "shapes": [{"circle": 0.5}]}
        for k in range(400)
    ]
    one, several = (World(sandbox.Scene(gravity=[0, 0], bodies=discs), workers) for workers in (1, 3))
    for world in (one, several):
        world.state.bodies.center_x[::7] = 1e9 - 50_000.0
    for _ in range(8):
        one.step()
        several.step()
        assert several.digest() == one.digest()
        assert several.frozen == one.frozen
    assert len(one.frozen) == 58
    assert int(several.state.counters[0].frozen_count) == 58


@compiled_only
def test_growing_and_shrinking_worlds_go_the_same_way(share_all):
    def grown(workers):
        world = World(sandbox.Scene(bodies=[{"id": "floor", "type": "static", "shapes": [{"box": [90, 2]}]}]), workers)
        digests = []
        for turn in range(30):
            row = [{"id": f"{turn}-{k}", "position": [k - 20.0, 3.0], "shapes": [{"circle": 0.45}]} for k in range(40)]
            world.spawn(bodies=row)
            if turn % 5 == 4:
                world.delete(f"{turn - 3}-7")
            world.step(5)
            digests.append(world.digest())
        return digests

    assert grown(3) == grown(1)


@compiled_only
@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one processor")
def test_the_others_do_a_part(share_all, monkeypatch):
    done = []
    usual = WorkerThreads.serving

    def noting(self, workers, jobs):
        return usual(self, workers, [lambda job=job: done.append(job()) for job in jobs])

    monkeypatch.setattr(WorkerThreads, "serving", noting)
    world = World(sandbox.load_scene(find_scene(Path("box2d-large-pyramid"))), 2)
    while sum(done) == 0 and len(done) < 500:  # others may have the processors for a while
        world.step()
    assert sum(done) > 0


@compiled_only
def test_what_the_others_run_is_no_second_step_to_compile():
    """They call the parts of the step that the first worker has."""
    assert 20 * weight_of(serve) < weight_of(finish) + weight_of(solve)


@compiled_only
def test_a_world_that_is_gone_leaves_no_threads():
    before = set(threading.enumerate())
    world = World(sandbox.Scene(), 4)
    threads = set(threading.enumerate()) - before
    assert len(threads) == 3
    del world
    gc.collect()
    for thread in threads:
        thread.join(10.0)
        assert not thread.is_alive()


def test_a_pile_that_is_too_large_is_refused_with_workers_too(share_all, monkeypatch):
    monkeypatch.setattr(limit, "MAX_STEP_BYTES", 10**6)
    piled = [{"id": f"b{k}", "shapes": [{"circle": 1.0}]} for k in range(1100)]
    world = World(sandbox.Scene(bodies=piled), 2)
    with pytest.raises(sandbox.CapacityError):
        world.step()


@pytest.mark.parametrize("wrong", [0, -1, 1.5, True, "2", None, 65, 10**400])
def test_other_numbers_of_workers_are_refused(wrong):
    with pytest.raises(ArgumentError, match="World: takes a whole number of workers from 1 to 64, not "):
        World(sandbox.Scene(), wrong)


def test_a_world_tells_its_workers():
    assert World(sandbox.Scene()).workers == SOLE
    assert World(sandbox.Scene(), 2).workers == (2 if jit_enabled() else SOLE)

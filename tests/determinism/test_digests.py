"""The same scene and commands give the same bits: again, elsewhere, after a restore, and without the compiler."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatScene, FlatSettings
from tests.determinism.busy import STEPS, digests, scene
from tests.flat import body, box, circle, ground

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def expected() -> list[str]:
    """The digests of one run."""
    return digests(World(scene()))


def other_process(**environment: str) -> list[str]:
    """The digests of a run in a new process, with the kernels as users have them: not callable from Python."""
    user = {name: value for name, value in os.environ.items() if name != "SANDBOX_CALLABLE_KERNELS"}
    done = subprocess.run(
        [sys.executable, "-m", "tests.determinism.busy"],
        cwd=ROOT, env={**user, **environment}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return done.stdout.split()


def test_the_scene_is_busy():
    world = World(scene())
    kinds, awake = set(), []
    for step in range(STEPS):
        digests(world, step, step + 1)
        awake.append(world.body("sleeper").awake)
        kinds |= {(int(c.point_count), c.restitution > 0, c.rolling_resistance > 0) for c in world.contacts}
    assert len(kinds) >= 5
    assert world.state.counters[0].color_count > 1
    assert not all(awake)
    assert awake[-1]


def test_every_step_changes_the_digest(expected):
    assert len(set(expected)) == STEPS


def test_two_runs(expected):
    assert digests(World(scene())) == expected


def test_a_fresh_process(expected):
    assert other_process(PYTHONHASHSEED="77") == expected


def test_without_the_compiler(expected):
    assert other_process(NUMBA_DISABLE_JIT="1") == expected


def test_snapshot_and_restore_into_the_same_world_at_every_step(expected):
    world = World(scene())
    for step in range(STEPS):
        before = world.digest()
        saved = world.snapshot()
        digests(world, step, step + 1)
        world.restore(saved)
        assert world.digest() == before
        assert world.step_count == step
        assert digests(world, step, step + 1) == [expected[step]]


def test_snapshot_and_restore_into_a_fresh_world_at_every_step(expected):
    world = World(scene())
    for step in range(STEPS):
        saved = world.snapshot()
        world = World(scene())
        world.restore(saved)
        assert world.snapshot() == saved
        assert digests(world, step, step + 1) == [expected[step]]


def test_going_back_and_forward(expected):
    world = World(scene())
    saved = []
    for step in range(STEPS):
        saved.append(world.snapshot())
        digests(world, step, step + 1)
    for step in reversed(range(0, STEPS, 5)):
        world.restore(saved[step])
        assert digests(world, step) == expected[step:]


def test_step_n_is_n_steps():
    once, often = World(scene()), World(scene())
    once.step(25)
    for _ in range(25):
        often.step()
    assert once.digest() == often.digest()


def test_reading_changes_nothing(expected):
    world = World(scene())
    for step in range(STEPS):
        _ = world.bodies.position.sum(), len(world.contacts), world.snapshot(), world.time, repr(world.body("box"))
        assert digests(world, step, step + 1) == [expected[step]]


def crowd(sleeping: bool) -> FlatScene:
    """Towers that fall into each other and a wheel with more contacts than there are colours."""
    hub = body("hub", circle(4.0), position=(0.0, 4.0))
    count = 80
    turns = [2 * np.pi * k / count for k in range(count)]
    rim = [
        body(f"r{k}", circle(0.15), position=(float(4.14 * np.cos(t)), float(4.0 + 4.14 * np.sin(t))))
        for k, t in enumerate(turns)
    ]
    towers = [
        body(f"t{x}-{y}", box(0.5, 0.5), position=(6.0 + 1.5 * x + 0.05 * y, 0.25 + 0.5 * y))
        for x in range(3)
        for y in range(8)
    ]
    return FlatScene((ground(60.0), hub, *rim, *towers), settings=FlatSettings(sleeping=sleeping))


@pytest.mark.parametrize("sleeping", [True, False])
def test_scratch_that_has_grown_makes_no_difference(sleeping):
    """A fresh world has little room and grows; a restored one has what the snapshot needs: the same bits."""
    long = World(crowd(sleeping))
    for _ in range(200):
        saved = long.snapshot()
        long.step()
        if long.step_count % 5 == 0 or long.step_count < 10:
            fresh = World(crowd(sleeping))
            fresh.restore(saved)
            fresh.step()
            assert fresh.digest() == long.digest(), long.step_count


def test_the_crowd_needs_serial_blocks():
    world = World(crowd(False))
    world.step(3)
    assert world.state.counters[0].color_count == 63


def laden_plank() -> FlatScene:
    """A plank with 300 crates on it falls asleep and is struck: waking needs more memory than a fresh world has."""
    plank = body("plank", box(40.0, 0.5), position=(0.0, 0.25))
    crates = [body(f"c{k}", box(0.1, 0.1), position=(0.12 * (k - 150), 0.56)) for k in range(300)]
    visitor = body("visitor", circle(0.1), position=(-19.9, 60.0))
    return FlatScene((ground(60.0), plank, *crates, visitor), settings=FlatSettings())


def test_waking_a_crowd_does_not_depend_on_scratch_memory():
    world = World(laden_plank())
    asleep = woken = False
    before = 302
    for _ in range(230):
        saved = world.snapshot()
        world.step()
        now = int(world.bodies.awake.sum())
        asleep, woken = asleep or now < 10, woken or (before < 10 and now > 290)
        if now != before or world.step_count % 50 == 0:
            fresh = World(laden_plank())
            fresh.restore(saved)
            fresh.step()
            assert fresh.digest() == world.digest(), world.step_count
        before = now
    assert asleep
    assert woken


def falling_asleep() -> FlatScene:
    """Two stacks and a late visitor that wakes one of them."""
    stacks = [body(f"{x}-{y}", box(1.0, 1.0), position=(4.0 * x, 0.5 + y)) for x in range(2) for y in range(3)]
    visitor = body("visitor", circle(0.3, density=5.0), position=(0.2, 30.0))
    return FlatScene((ground(), *stacks, visitor), settings=FlatSettings(sleeping=True))


def test_sleep_and_waking_survive_a_restore():
    world = World(falling_asleep())
    asleep = woken = False
    for _ in range(240):
        saved = world.snapshot()
        before = int(world.bodies.awake.sum())
        world.step()
        now = int(world.bodies.awake.sum())
        asleep, woken = asleep or now < before, woken or now > before
        fresh = World(falling_asleep())
        fresh.restore(saved)
        fresh.step()
        assert fresh.digest() == world.digest(), world.step_count
    assert asleep
    assert woken


def test_a_digest_sees_every_bit_of_every_body():
    world = World(scene())
    world.step(20)
    first = world.digest()
    body = world.state.bodies[4]
    for name in ("position_x", "angle", "velocity_y", "sleep_time", "force_x"):
        before = float(body[name])
        body[name] = np.nextafter(before, np.inf)
        assert world.digest() != first, name
        body[name] = before
    assert world.digest() == first

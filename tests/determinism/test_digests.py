"""The same scene and commands give the same bits: again, elsewhere, after a restore, and without the compiler."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from tests.determinism.busy import STEPS, digests, scene
from tests.determinism.processes import other_process


@pytest.fixture(scope="module")
def expected() -> list[str]:
    """The digests of one run."""
    return digests(World(scene()))


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
    assert other_process("tests.determinism.busy", PYTHONHASHSEED="77") == expected


@pytest.mark.slow
def test_without_the_compiler(expected):
    assert other_process("tests.determinism.busy", NUMBA_DISABLE_JIT="1") == expected


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

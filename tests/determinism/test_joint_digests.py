"""Joints keep the contract: the same bits again, elsewhere, after a restore, and without the compiler."""

from __future__ import annotations

import pytest

from sandbox.engine.world import World
from tests.determinism.jointed import STEPS, digests, scene
from tests.determinism.processes import other_process


@pytest.fixture(scope="module")
def expected() -> list[str]:
    """The digests of one run."""
    return digests(World(scene()))


def test_the_machine_has_every_kind():
    world = World(scene())
    assert len({world.joint(name).type for name in world.joint_names}) == 10
    digests(world)
    assert world.frozen == []
    assert world.joint("chain-2").broken


def test_two_runs(expected):
    assert len(set(expected)) == STEPS
    assert digests(World(scene())) == expected


def test_a_fresh_process(expected):
    assert other_process("tests.determinism.jointed", PYTHONHASHSEED="77") == expected


@pytest.mark.slow(seconds=20)
def test_without_the_compiler(expected):
    assert other_process("tests.determinism.jointed", NUMBA_DISABLE_JIT="1") == expected


def test_snapshot_and_restore_at_every_step(expected):
    world, other = World(scene()), World(scene())
    for step in range(STEPS):
        saved = world.snapshot()
        other.restore(saved)
        assert other.snapshot() == saved
        assert digests(other, step, step + 1) == [expected[step]]
        digests(world, step, step + 1)
        world.restore(saved)
        assert digests(world, step, step + 1) == [expected[step]]


def test_going_back_across_a_break(expected):
    world = World(scene())
    saved = []
    for step in range(STEPS):
        saved.append(world.snapshot())
        digests(world, step, step + 1)
    for step in reversed(range(0, STEPS, 5)):
        world.restore(saved[step])
        assert digests(world, step) == expected[step:]


@pytest.mark.parametrize("field", ["impulse_0", "anchor_ax", "motor_speed", "force_x"])
def test_a_digest_sees_every_bit_of_every_joint(field):
    world = World(scene())
    world.step(5)
    before = world.digest()
    world.state.joints[field][4] += 1e-9
    assert world.digest() != before

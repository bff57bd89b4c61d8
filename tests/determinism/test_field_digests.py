"""Worlds with fields keep the determinism contract."""

from __future__ import annotations

import pytest

from sandbox.engine.world import World
from tests.determinism.floating import STEPS, digests, scene
from tests.determinism.processes import other_process


@pytest.mark.slow
def test_without_the_compiler_and_in_another_process():
    assert other_process("tests.determinism.floating", NUMBA_DISABLE_JIT="1") == digests(World(scene()))


def test_snapshot_and_restore_at_every_step():
    expected = digests(World(scene()))
    assert len(set(expected)) == STEPS
    world = World(scene())
    for step in range(STEPS):
        saved = world.snapshot()
        world = World(scene())
        world.restore(saved)
        world.step()
        assert world.digest() == expected[step]

"""Worlds with fields keep the determinism contract."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from sandbox.engine.world import World
from tests.determinism.floating import STEPS, digests, scene

ROOT = Path(__file__).parents[2]


def test_without_the_compiler_and_in_another_process():
    user = {name: value for name, value in os.environ.items() if name != "SANDBOX_CALLABLE_KERNELS"}
    done = subprocess.run(
        [sys.executable, "-m", "tests.determinism.floating"],
        cwd=ROOT, env={**user, "NUMBA_DISABLE_JIT": "1"}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout.split() == digests(World(scene()))


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

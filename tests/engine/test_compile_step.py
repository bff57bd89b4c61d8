"""An empty kernel cache is filled by two processes, and a step gives the same bits after it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from sandbox.engine import compile_step

ROOT = Path(__file__).parents[2]
SCRIPT = """
from sandbox.engine.compile_step import compile_continuous
from tests.flat import body, circle, ground, world
pile = world(ground(), body("ball", circle(0.5), position=(0.0, 0.6)))
pile.step(30)
compile_continuous()
print(pile.digest())
"""


@pytest.mark.slow
def test_a_cold_cache_is_filled_and_the_bits_are_the_same(tmp_path: Path) -> None:
    environment = os.environ | {"SANDBOX_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(ROOT)}
    cold, warm = (
        subprocess.run([sys.executable, "-c", SCRIPT], cwd=ROOT, env=environment, capture_output=True, text=True)
        for _ in range(2)
    )
    assert cold.returncode == 0, cold.stderr
    assert cold.stdout == warm.stdout
    # Each once: with two signatures a part would have been compiled twice.
    assert sorted(path.name.split("-")[0] for path in tmp_path.rglob("*.code")) == [
        "sandbox.engine.continuous_collision.solve_continuous.solve_continuous",
        "sandbox.engine.step.collide",
        "sandbox.engine.step.solve",
    ]


@pytest.mark.parametrize("executable", ["/no/such/python", ""])
def test_without_a_second_process_the_first_goes_on_alone(monkeypatch: pytest.MonkeyPatch, executable: str) -> None:
    monkeypatch.setattr(sys, "executable", executable)
    assert compile_step._start_helper() is None

"""An empty kernel cache is filled by two processes, which is told, and a step gives the same bits after it."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from sandbox.engine import compile_step

ROOT = Path(__file__).parents[2]
CHECK = """
from sandbox.cli import main
from sandbox.engine.compile_step import wait_for_all
try:
    main()
finally:
    wait_for_all()
"""
PILE = {
    "bodies": [
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 0.6]},
    ],
    "settings": {"steps": 30},
    "expect": [{"at": 30, "rests": "ball"}],
}


@pytest.mark.slow(seconds=25)
def test_a_cold_cache_is_filled_and_told_of_and_the_bits_are_the_same(tmp_path: Path) -> None:
    """The command of a user, who sees that it compiles, and at the next time nothing of it."""
    scene, cache = tmp_path / "pile.scene.json", tmp_path / "cache"
    scene.write_text(json.dumps(PILE))
    environment = os.environ | {"SANDBOX_CACHE_DIR": str(cache), "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", CHECK, "check", str(scene)]
    cold, warm = (subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True) for _ in range(2))
    assert (cold.returncode, warm.returncode) == (0, 0), cold.stdout + cold.stderr
    assert ("compiling" in cold.stderr, warm.stderr) == (True, "")
    assert _digest(cold.stdout) == _digest(warm.stdout)
    # Each once: with two signatures a part would have been compiled twice.
    assert sorted(path.name.split("-")[0] for path in cache.rglob("*.code")) == [
        "sandbox.engine.continuous_collision.solve_continuous.solve_continuous",
        "sandbox.engine.restitution.strike_batch.strike_batch",
        "sandbox.engine.run_step.run_step",
        "sandbox.engine.step.begin",
        "sandbox.engine.step.collide",
        "sandbox.engine.step.finish",
        "sandbox.engine.step.solve",
    ]


def _digest(table: str) -> str:
    (found,) = re.findall(r"\b[0-9a-f]{16}\b", table)
    return found


@pytest.mark.parametrize("executable", ["/no/such/python", ""])
def test_without_a_second_process_the_first_goes_on_alone(monkeypatch: pytest.MonkeyPatch, executable: str) -> None:
    monkeypatch.setattr(sys, "executable", executable)
    assert compile_step._start_helper(joints=False, impacts=False) is None

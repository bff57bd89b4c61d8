"""What a kernel cache lacks is filled in by two processes, which is told, and a step gives the same bits after it."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sandbox import _jit
from sandbox._compiling import weight_of
from sandbox._kernel_cache import cache_folder, cache_root
from sandbox.engine import compile_step
from sandbox.engine.compile_step import PARTS
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.joints.nets import do_nets
from sandbox.engine.joints.solve import do_joints
from sandbox.engine.restitution.jointed.strike import strike_through_joints
from sandbox.engine.restitution.strike_batch import strike_batch
from sandbox.engine.step import begin, collide, finish, solve
from sandbox.engine.world import World
from sandbox.scene import load_scene
from tests.determinism import busy, jointed
from tests.joints.nets import net

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


LACKING = ("begin", "finish", "solve_continuous", "strike_batch")
"""The lighter parts: two that a step needs, one for each process, and two that it may need later."""


@pytest.mark.slow(seconds=10)
def test_what_a_cache_lacks_is_compiled_and_told_of_and_the_bits_are_the_same(tmp_path: Path) -> None:
    """The command of a user, who sees that it compiles, and at the next time nothing of it."""
    scene, cache = tmp_path / "pile.scene.json", tmp_path / "cache"
    scene.write_text(json.dumps(PILE))
    World(load_scene(scene)).step()  # all but those that it lacks is there, by whichever tests were first
    mine = cache_folder().relative_to(cache_root())
    shutil.copytree(cache_folder(), cache / mine, ignore=lambda _, names: [each for each in names if not kept(each)])
    before = {path.name for path in cache.rglob("*.code")}
    environment = os.environ | {"SANDBOX_CACHE_DIR": str(cache), "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", CHECK, "check", str(scene)]
    cold, warm = (subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True) for _ in range(2))
    assert (cold.returncode, warm.returncode) == (0, 0), cold.stdout + cold.stderr
    assert ("compiling" in cold.stderr, warm.stderr) == (True, "")
    assert _digest(cold.stdout) == _digest(warm.stdout)
    # Each once: with two signatures a part would have been compiled twice.
    assert sorted(part(path.name) for path in cache.rglob("*.code") if path.name not in before) == sorted(LACKING)


def part(file: str) -> str:
    """The entry point whose machine code is kept under that name."""
    return file.split("-")[0].split(".")[-1]


def kept(file: str) -> bool:
    """Whether it is machine code that the cache does not lack; others may just be writing."""
    return file.endswith(".code") and part(file) not in LACKING


def _digest(table: str) -> str:
    (found,) = re.findall(r"\b[0-9a-f]{16}\b", table)
    return found


@pytest.mark.parametrize("executable", ["/no/such/python", ""])
def test_without_a_second_process_the_first_goes_on_alone(monkeypatch: pytest.MonkeyPatch, executable: str) -> None:
    monkeypatch.setattr(sys, "executable", executable)
    assert compile_step._start_helper(compile_step.PARTS) is None


@pytest.mark.skipif(not _jit.jit_enabled(), reason="there is no machine code without the compiler")
def test_where_plain_worlds_were_stepped_joints_lack_what_is_theirs_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    asked, started, run = [], [], []
    plain, with_joints, with_net = World(busy.scene()), World(jointed.scene()), net(16, 16, "hinge")
    for part in PARTS:
        monkeypatch.setattr(part, "_versions", {})
    monkeypatch.setattr(_jit, "read_kept", asked.append)
    calls = plain._stepper.calls
    needed, later = calls.lacking(impacts=False)
    assert [*needed, *later] == [collide, begin, solve, finish, solve_continuous, strike_batch]
    assert calls.lacking(impacts=True)[1] == [strike_batch, solve_continuous]
    monkeypatch.setattr(_jit, "read_kept", lambda file: ("n", b"") if file in asked else None)
    monkeypatch.setattr(_jit, "is_usable", lambda returns, code: True)
    monkeypatch.setattr(_jit, "Version", lambda code, returns: object())
    assert calls.lacking(impacts=True) == ({}, [])
    needed, later = with_joints._stepper.calls.lacking(impacts=True)
    assert [*needed, *later] == [do_joints, strike_through_joints]
    needed, later = with_net._stepper.calls.lacking(impacts=True)
    assert [*needed, *later] == [do_joints, do_nets, strike_through_joints]

    monkeypatch.setattr(os, "cpu_count", lambda: 2)
    monkeypatch.setattr(compile_step, "_start_helper", started.append)
    monkeypatch.setattr(compile_step, "_run_once", run.append)
    compile_step.compile_step(needed, later)
    assert run == [do_joints]
    assert started == [[do_nets, strike_through_joints]]
    compile_step.compile_step({}, [])
    assert len(started) == 1


@pytest.mark.skipif(not _jit.jit_enabled(), reason="there is no machine code without the compiler")
@pytest.mark.parametrize("joints", [False, True])
def test_an_empty_cache_is_filled_by_two_who_have_as_much_to_do(joints: bool) -> None:
    """By weights, as they are told to the user too."""
    parts = [collide, begin, solve, finish, *([do_joints] if joints else [])]
    weights = {part: weight_of(part) for part in parts}
    here, there = compile_step.halves(weights)
    assert sorted(here + there, key=parts.index) == parts
    assert 0.75 < sum(map(weights.get, there)) / sum(map(weights.get, here)) < 1.3

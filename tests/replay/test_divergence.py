"""Where two runs part: the step, the body, the number and the cause."""

from __future__ import annotations

import itertools
import math
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import ApplyImpulse
from sandbox.engine import arithmetic_version as arithmetic
from sandbox.replay.golden.divergence import ulps_between
from sandbox.replay.golden.heavy import Twin
from sandbox.resources import find_scene
from tests.replay.played import COMMANDS, STEPS, recording, scene


@given(st.floats(allow_nan=False), st.integers(0, 40))
def test_ulps_count_the_floats_between(start: float, count: int) -> None:
    there = start
    for _ in range(count):
        there = math.nextafter(there, math.inf)
    passed_zero = start < 0 < there or (start == 0 and math.copysign(1, start) < 0 and count > 0)
    expected = 0 if math.isinf(start) and start > 0 else count
    if not math.isinf(there):
        assert ulps_between(start, there) == expected + (1 if passed_zero or (start < 0 and there == 0) else 0)
        assert ulps_between(there, start) == ulps_between(start, there)


def test_zeroes_of_both_signs_are_one_apart() -> None:
    assert ulps_between(0.0, -0.0) == 1
    assert ulps_between(5e-324, -5e-324) == 3


def test_one_friction_in_a_shipped_scene_is_named() -> None:
    shipped = sandbox.load_scene(find_scene(Path("crates-on-a-ramp")))
    bodies = shipped.to_data()["bodies"]
    ball = next(body for body in bodies if body["id"] == "ball")
    ball["shapes"][0]["friction"] = 0.8
    edited = shipped.model_copy(update={"bodies": bodies})
    recorded = sandbox.record(shipped, 200)
    now = sandbox.rerun(replace(recorded, scene=replace(recorded.scene, content=edited)))
    assert (now.verdict, now.edits) == ("stale", ("body ball was edited",))
    first_touch = next(k for k in range(1, 200) if _touches(shipped, k, "ball"))
    assert now.divergence is not None
    assert (now.divergence.step, now.divergence.group) == (first_touch, "manifolds")
    found = sandbox.find_divergence(recorded, sandbox.Run(edited, 200))
    assert found is not None
    assert found.detail is not None
    detail = found.detail
    assert (detail.table, detail.body, detail.field) == ("shape", "ball", "friction")
    assert (detail.expected, detail.got) == (0.9, 0.8)


def _touches(shipped: sandbox.Scene, steps: int, name: str) -> bool:
    """Whether a body has a contact after so many steps."""
    world = sandbox.World(shipped)
    world.step(steps)
    row = world.names.index(name)
    return bool(((world.contacts.body_a == row) | (world.contacts.body_b == row)).any())


def test_one_command_that_differs_is_named() -> None:
    recorded = recording()
    other = [(12, ApplyImpulse("ball", (0.1, 0.75), point=(0.3, 1.0))) if k == 3 else c for k, c in enumerate(COMMANDS)]
    now = sandbox.rerun(replace(recorded, commands=tuple(other)))
    assert now.verdict == "diverged"
    assert now.divergence is not None
    assert now.divergence.step == 13
    assert now.divergence.time == pytest.approx(13 / 60)
    found = sandbox.find_divergence(recorded, sandbox.Run(scene(), STEPS, tuple(other)))
    assert found is not None
    assert found.detail is not None
    assert (found.step, found.detail.body) == (13, "ball")
    assert found.growth[0].body == "ball"
    assert [row.step - 13 for row in found.growth[:5]] == [0, 1, 2, 4, 8]
    assert found.growth[-1].step == STEPS


def test_runs_that_are_equal_have_no_divergence() -> None:
    assert sandbox.find_divergence(recording(), sandbox.Run(scene(), STEPS, COMMANDS)) is None
    assert sandbox.find_divergence(scene(), scene()) is None


@pytest.mark.parametrize(
    ("changes", "table", "body", "field"),
    [
        ({"gravity": [0, -9.8]}, "settings", "", "gravity_y"),
        ({"settings": {"substeps": 5}}, "settings", "", "substeps"),
    ],
)
def test_what_a_world_is_built_with_shows_at_step_0(changes: Any, table: str, body: str, field: str) -> None:
    found = sandbox.find_divergence(scene(), scene(**changes))
    assert found is not None
    assert found.detail is not None
    assert (found.step, found.group) == (0, "rest")
    assert (found.detail.table, found.detail.body, found.detail.field) == (table, body, field)


def test_a_body_that_is_only_in_one_scene() -> None:
    bodies = scene().to_data()["bodies"]
    more = [*bodies[:2], {"id": "extra", "shapes": [{"circle": 0.1}], "position": [9, 5]}, *bodies[2:]]
    for one, two, expected, got in ((bodies, more, None, 1), (more, bodies, 1, None)):
        found = sandbox.find_divergence(scene(bodies=one), scene(bodies=two))
        assert found is not None
        assert found.detail is not None
        assert (found.detail.table, found.detail.name) == ("body", "extra")
        assert (found.detail.expected, found.detail.got) == (expected, got)


def test_a_command_that_only_one_run_refuses() -> None:
    bodies = [body for body in scene().to_data()["bodies"] if body["id"] != "ball"]
    without = scene(bodies=bodies)
    found = sandbox.find_divergence(
        sandbox.Run(without, 9, ()), sandbox.Run(without, 9, ((5, ApplyImpulse("ball", (1.0, 0.0))),))
    )
    assert found is not None
    assert (found.step, found.group) == (5, "command")
    assert "no body 'ball'" in found.got


def test_heavy_finds_what_a_snapshot_forgets(monkeypatch: pytest.MonkeyPatch) -> None:
    recorded = recording()
    assert sandbox.rerun(recorded, heavy=True).passed
    faithful = Twin.step_from

    def forgetful(self: Twin, stepper: Any) -> str:
        if stepper.step == 33:
            self._stepper.restore(stepper.world.snapshot(), stepper.applied)
            self._stepper.world.state.bodies.velocity_x[2] += 1e-12
            self._stepper.advance()
            return self._stepper.world.digest()
        return faithful(self, stepper)

    monkeypatch.setattr(Twin, "step_from", forgetful)
    now = sandbox.rerun(recorded, heavy=True)
    assert now.divergence is not None
    assert (now.divergence.group, now.divergence.step) == ("state", 34)


def test_an_arithmetic_that_was_changed_on_purpose_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    from sandbox.replay.golden import rerun as room

    following = arithmetic.ARITHMETIC + 1
    monkeypatch.setitem(arithmetic.NOTES, following, "contacts are prepared in another order")
    monkeypatch.setattr(room, "ARITHMETIC", following)
    old = recording()
    assert sandbox.rerun(replace(old, arithmetic=1)).notes == ()
    now = sandbox.rerun(replace(old, arithmetic=1, digest="0" * 16))
    assert now.notes[-1] == f"arithmetic {following}: contacts are prepared in another order"
    later = sandbox.rerun(replace(old, arithmetic=following + 1, version="9.0", digest="0" * 16))
    assert "later version, sandbox 9.0" in later.notes[0]


@pytest.mark.slow
def test_one_line_of_the_solver_is_found_by_replay(tmp_path: Path) -> None:
    """A copy of the package in which friction is a little weaker, run without the compiler."""
    package = Path(sandbox.__file__).parent
    shutil.copytree(package, tmp_path / "sandbox", ignore=shutil.ignore_patterns("__pycache__"))
    source = tmp_path / "sandbox" / "engine" / "contact_solver" / "fill_lanes.py"
    text = source.read_text(encoding="utf-8")
    line = "store(v, cb.FRICTION, friction)\n"
    assert text.count(line) == 1
    source.write_text(text.replace(line, line.replace("friction)", "0.99 * friction)")), encoding="utf-8")
    slide = {
        "bodies": [
            {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
            {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.6], "velocity": [3, 0]},
        ],
        "settings": {"steps": 25},
    }
    recorded = sandbox.record(sandbox.Scene(**slide))
    recorded.save(tmp_path / "slide.replay.json")
    done = subprocess.run(
        [sys.executable, "-m", "sandbox", "replay", "--no-jit", "slide.replay.json"],
        cwd=tmp_path, env={"PATH": "", "PYTHONPATH": str(tmp_path)}, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 1, done.stderr
    assert f"step {_first_rub(slide)} (" in done.stdout
    assert "): impulses: expected" in done.stdout
    assert "ended elsewhere: crate by" in done.stdout


def _first_rub(data: dict[str, Any]) -> int:
    """The first step in which a contact rubs."""
    world = sandbox.World(sandbox.Scene(**data))
    for step in range(1, 25):
        world.step()
        if (world.contacts.tangent_impulse1 != 0).any():
            return step
    raise AssertionError("nothing rubs")


def test_bits_of_floats_order_like_floats() -> None:
    values = [-math.inf, -1.0, -5e-324, -0.0, 0.0, 5e-324, 1.0, math.inf]
    steps = [ulps_between(a, b) for a, b in itertools.pairwise(values)]
    assert all(step > 0 for step in steps)
    assert sum(steps) == ulps_between(-math.inf, math.inf)

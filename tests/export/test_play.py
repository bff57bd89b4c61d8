"""Scenes that are played, saved as scenes: driven bodies, rules and counters go on from where they are."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sandbox import (
    BreakJoint,
    Control,
    Delete,
    DeleteRegion,
    Scene,
    SetPath,
    SetPose,
    World,
    copy_of,
    scene_of,
)
from sandbox._jit import interpreted
from sandbox.engine.bodies.paths import place_after
from sandbox.engine.rules.paths import ways_of
from tests.export.worlds import entries, saved

BALL: dict[str, Any] = {"shapes": [{"circle": 0.3}]}
PATHS: dict[str, dict[str, Any]] = {
    "lift": {"to": [[0, 4]], "speed": 1.5, "pause": 1, "mode": "ping-pong", "easing": "smooth"},
    "door": {"to": [[0, 0], [3, 1]], "turn": [90, 45], "times": [1, 3]},
    "round": {"to": [[1, 0], [1, 1]], "speed": 2, "mode": "loop", "turn": [90, 180]},
    "late": {"to": [[1, 0]], "speed": 1, "time": 0.5},
}


def driven(kind: str) -> World:
    body = {"id": kind, "type": "kinematic", "position": [0.1, 0.2], "angle": 10, "path": PATHS[kind], **BALL}
    return World(Scene(bodies=[body, {"id": "ball", "position": [0, 40], **BALL}]))


def pose(world: World, name: str) -> tuple[float, ...]:
    return *world.body(name).position, world.body(name).angle


@pytest.mark.parametrize("kind", PATHS)
@pytest.mark.parametrize("steps", [1, 37, 150, 400])
def test_a_driven_body_goes_on_along_its_path(kind: str, steps: int, tmp_path: Path) -> None:
    world = driven(kind)
    world.step(steps)
    found, other = saved(world, tmp_path)
    assert found.remarks == ()
    for _ in range(60):
        assert pose(world, kind) == pose(other, kind)
        world.step()
        other.step()
        assert world.body(kind).velocity == other.body(kind).velocity


def test_a_copy_of_a_driven_body_goes_beside_it() -> None:
    world = driven("lift")
    world.step(100)
    world.spawn(*copy_of(world, ["lift"], offset=(20.0, 0.0)))
    world.step(50)
    x, y, angle = pose(world, "lift")
    assert pose(world, "lift-copy") == pytest.approx((x + 20.0, y, angle), abs=1e-12)


def test_a_body_that_waits_beside_its_path_is_told_of() -> None:
    """It has not begun, and stays where it was put until it is let go: a file has no words for that."""
    world = driven("lift")
    world.apply(SetPath("lift", enabled=False))
    world.apply(SetPose("lift", (5.0, 5.0), 0.0))
    assert scene_of(world).remarks == ("bodies that were put beside their paths begin on them: lift",)


def test_a_path_that_was_stopped_and_a_body_beside_it() -> None:
    world = driven("lift")
    world.step(100)
    world.apply(SetPath("lift", enabled=False))
    world.apply(SetPose("lift", (5.0, 5.0), 0.0))
    found = scene_of(world)
    assert entries(found.scene)["lift"]["path"] == {**PATHS["lift"], "to": [[0, 4]], "enabled": False, "time": 100 / 60}
    assert found.remarks == ("bodies that were put beside their paths begin on them: lift",)


def test_several_of_one_prefab_take_turns_and_joints_count_from_there() -> None:
    path = {"to": [[0, 4]], "speed": 1, "mode": "ping-pong"}
    bodies = [
        {"id": f"lift-{k}", "prefab": "lift", "position": [4 * k, 0], "path": {**path, "time": k}} for k in range(3)
    ]
    bob = {"id": "bob", "position": [8, 1], **BALL}
    hinge = {"id": "hinge", "type": "weld", "bodies": ["lift-2", "bob"], "anchor": [8, 2]}
    world = World(
        Scene(gravity=(0, 0), prefabs={"lift": {"type": "kinematic", **BALL}}, bodies=[*bodies, bob], joints=[hinge])
    )
    assert [world.body(f"lift-{k}").position for k in range(3)] == [(0.0, 0.0), (4.0, 1.0), (8.0, 2.0)]
    world.step(60)
    assert [world.body(f"lift-{k}").position[1] for k in range(3)] == pytest.approx([1.0, 2.0, 3.0])
    assert world.body("bob").position == pytest.approx((8.0, 2.0), abs=1e-3)


@pytest.mark.parametrize("kind", PATHS)
def test_a_path_is_worked_out_to_the_bit_as_in_the_steps_of_a_world(kind: str) -> None:
    path = driven(kind).flat.bodies[0].path
    assert path is not None
    ways, stops = ways_of([path])
    for seconds in np.linspace(0.0, 9.0, 700).tolist():
        assert path.after(seconds) == interpreted(place_after)(ways[0], stops, seconds)


def test_what_bad_numbers_froze_stays_where_it_was_on_its_path(tmp_path: Path) -> None:
    body = {"id": "lift", "type": "kinematic", "path": {"to": [[5e8, 0]], "times": [1]}, **BALL}
    world = World(Scene(bodies=[body]))
    world.step(5)
    assert (world.body("lift").position, world.body("lift").velocity) == ((0.0, 0.0), (0.0, 0.0))
    found, other = saved(world, tmp_path)
    other.step(5)
    assert other.body("lift").position == (0.0, 0.0)
    assert found.remarks == ("bodies that bad numbers froze are static for good: lift",)


def played(**parts: Any) -> World:
    """Two balls, a weld, a pool, and what is asked for beside them."""
    bodies = [{"id": name, "position": [2 * k, 2], **BALL} for k, name in enumerate(("a", "b"))]
    weld = {"id": "weld", "type": "weld", "bodies": ["a", "b"], "anchor": [1, 2]}
    return World(Scene(bodies=bodies, joints=[weld], regions=[{"id": "pool", "water": 1}], **parts))


GONE = "what rules, controls and the camera have to do with what is gone is left out"
EVERY = {"every": 5, "start": 5}


@pytest.mark.parametrize(
    ("rule", "left"),
    [
        ({"when": EVERY, "do": [{"delete": "a"}]}, None),
        ({"when": EVERY, "do": [{"delete": "a*"}]}, None),
        ({"when": EVERY, "do": [{"delete": ["a", "b"]}]}, [{"delete": ["b"]}]),
        ({"when": EVERY, "do": [{"delete": "a"}, {"delete": "b"}]}, [{"delete": "b"}]),
        ({"when": EVERY, "do": [{"put": "b", "at": "a"}, {"win": "won"}]}, [{"win": "won"}]),
        ({"when": EVERY, "do": [{"joint": "weld", "enabled": False}]}, None),
        ({"when": EVERY, "do": [{"region": ["pool"], "enabled": False}]}, None),
        ({"when": {"hit": ["a", "b"]}, "do": [{"win": "won"}]}, None),
        ({"when": {"hit": ["a", "b"]}, "do": [{"delete": "a"}]}, None),
        ({"when": {"joint_break": "weld"}, "do": [{"delete": "a"}]}, None),
        ({"when": EVERY, "if": {"touches": ["b", "a"]}, "do": [{"win": "won"}]}, None),
        ({"when": {"begin": ["b", "*"]}, "do": [{"win": "won"}]}, [{"win": "won"}]),
    ],
)
def test_rules_leave_out_who_is_gone(rule: dict[str, Any], left: Any, tmp_path: Path) -> None:
    world = played(rules=[rule, {"when": EVERY, "do": [{"delete": "b"}]}])
    world.apply(BreakJoint("weld"))
    world.apply(Delete("a"))
    world.apply(DeleteRegion("pool"))
    found, _ = saved(world, tmp_path)
    expected = [] if left is None else [left]
    assert [each.to_data()["do"] for each in found.scene.rules] == [*expected, [{"delete": "b"}]]
    assert (GONE in found.remarks) == (left is None or left != rule["do"])


def test_controls_and_the_camera_leave_out_who_is_gone(tmp_path: Path) -> None:
    push = {"impulse": [1, 0], "of": ["a", "b"]}
    jump = {"id": "jump", "keys": ["space"], "press": [push, {"delete": "a"}], "hold": [{"break_joint": "weld"}]}
    world = played(controls=[jump], view={"follow": "a", "height": 9})
    world.apply(Control("jump", 0.5))
    world.apply(Delete("a"))
    found, _ = saved(world, tmp_path)
    kept = {"id": "jump", "keys": ["space"], "press": [{**push, "of": ["b"]}], "hold": []}
    assert found.scene.controls[0].to_data() == kept
    assert found.scene.view is not None
    assert found.scene.view.to_data() == {"height": 9}
    assert found.remarks == ("controls are let go: jump", GONE)


def test_counters_times_and_limits_go_on(tmp_path: Path) -> None:
    """A rule that comes due every 0.4 s, one at 2 s, one that is over, and one that may be followed once more."""
    world = played(
        counters={"many": 0, "few": 0, "once": 0},
        rules=[
            {"when": {"every": 0.4, "start": 0.1}, "do": [{"counter": "many", "add": 1}]},
            {"when": {"every": 0.4}, "limit": 3, "do": [{"counter": "few", "add": 1}]},
            {"when": {"time": 0.5}, "do": [{"counter": "once", "add": 1}]},
            {"when": {"time": 2}, "do": [{"counter": "once", "add": 10}]},
        ],
    )
    world.step(55)
    found, other = saved(world, tmp_path)
    assert found.scene.counters == {"many": 3, "few": 2, "once": 1}
    assert len(found.scene.rules) == 3
    for _ in range(100):
        world.step()
        other.step()
        assert world.counters == other.counters
    assert dict(world.counters) == {"many": 7, "few": 3, "once": 11}


def test_how_a_game_ended_is_told_to_be_left_out() -> None:
    world = played(rules=[{"when": {"time": 0.1}, "do": [{"win": "won"}]}])
    world.step(20)
    assert scene_of(world).remarks == ("how the game ended is left out",)

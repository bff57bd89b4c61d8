"""Joints of every kind, written down in mid-motion: what they measure from the pose of the scene is shifted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sandbox import Scene, SetJoint, SetLimits, SetMotor, SetPose, SetSpring, SetTarget, World, scene_of
from tests.export.worlds import apart, difference, saved

PLANK = [{"box": [1, 0.3]}]


def two(a: str = "a", b: str = "b", at: float = 0.0, **motion: Any) -> list[dict[str, Any]]:
    """Two planks beside each other, of which the second moves."""
    first = {"id": a, "shapes": PLANK, "position": [at, 0.2]}
    return [first, {"id": b, "shapes": PLANK, "position": [at + 1, 0.3], "angle": 20, **motion}]


SPIN = {"angular_velocity": 90, "velocity": [0.5, 1]}
KINDS: dict[str, dict[str, Any]] = {
    "hinge": {"type": "revolute", "anchor": [0.5, 0.2]},
    "hinge with limits": {"type": "revolute", "anchor": [0.5, 0.2], "lower": -20, "upper": 30},
    "hinge with a spring": {"type": "revolute", "anchor": [0.5, 0.2], "hertz": 1, "rest": 25, "damping_ratio": 0.1},
    "hinge with a motor": {"type": "revolute", "anchor": [0.5, 0.2], "motor_speed": 90, "max_torque": 0.2},
    "slide": {"type": "prismatic", "anchor": [0.5, 0.2], "axis": [1, 0.5]},
    "slide with limits": {"type": "prismatic", "anchor": [0.5, 0.2], "axis": [1, 0.5], "lower": -0.1, "upper": 0.3},
    "slide with a spring": {"type": "prismatic", "anchor": [0.5, 0.2], "axis": [0, 1], "hertz": 1, "rest": 0.4},
    "wheel": {"type": "wheel", "anchor": [1, 0.3], "axis": [0, 1], "hertz": 1, "rest": 0.1, "motor_speed": 200,
              "max_torque": 0.05},
    "weld": {"type": "weld", "anchor": [0.5, 0.2]},
    "soft weld": {"type": "weld", "anchor": [0.5, 0.2], "hertz": 2, "angular_hertz": 1, "damping_ratio": 0.1},
    "weld of soft angle": {"type": "weld", "anchor": [0.5, 0.2], "angular_hertz": 1, "angular_damping_ratio": 0},
    "rod": {"type": "distance", "anchors": [[0, 0.2], [1.3, 0.3]]},
    "spring": {"type": "distance", "anchors": [[0, 0.2], [1.3, 0.3]], "length": 1.1, "hertz": 1},
    "rope": {"type": "distance", "anchors": [[0, 0.2], [1.3, 0.3]], "max": 1.5},
    "motor": {"type": "motor", "anchor": [0.6, 0.2], "offset": [0.3, 0.4], "angle": 30, "hertz": 1,
              "angular_hertz": 1, "max_force": 5, "max_torque": 2},
    "friction": {"type": "friction", "anchor": [0.6, 0.2], "max_force": 0.3, "max_torque": 0.1},
    "pulley": {"type": "pulley", "anchors": [[0, 0.3], [1, 0.4]], "wheels": [[0, 3], [1.5, 3]], "ratio": 1.5},
}  # fmt: skip
ROUNDING = 1e-6
"""What joints are off by in mid-motion, m: a scene begins without that, and without the impulse of friction."""


def running(kind: str, steps: int) -> World:
    joint = {"id": "joint", "bodies": ["a", "b"], **KINDS[kind]}
    world = World(Scene(gravity=(0, 0), bodies=two(**SPIN), joints=[joint]))
    world.step(steps)
    return world


@pytest.mark.parametrize("steps", [7, 40])
@pytest.mark.parametrize("kind", KINDS)
def test_it_goes_on_as_it_would_have(kind: str, steps: int, tmp_path: Path) -> None:
    world = running(kind, steps)
    found, other = saved(world, tmp_path)
    assert [line for line in found.remarks if "soft welds" not in line] == []
    assert difference(world, other) < 1e-12
    for _ in range(6):
        world.step(10)
        other.step(10)
        assert apart(world, other) < ROUNDING


@pytest.mark.parametrize("kind", KINDS)
def test_of_a_joint_that_a_command_changes_only_that_is_written(kind: str) -> None:
    world = running(kind, 0)
    world.apply(SetJoint("joint", break_force=77.0, collide=True))
    joint = scene_of(world).scene.joints[0]
    assert joint.to_data() == world.scene.joints[0].to_data() | {"break_force": 77, "collide": True}


def test_gears_go_on_from_the_pose_of_now(tmp_path: Path) -> None:
    bodies = [*two(at=0.0, **SPIN), *two("c", "d", at=4.0)]
    joints = [
        {"id": "one", "type": "revolute", "bodies": ["a", "b"], "anchor": [0.5, 0.2]},
        {"id": "two", "type": "prismatic", "bodies": ["c", "d"], "anchor": [4.5, 0.2], "axis": [0, 1]},
        {"id": "gear", "type": "gear", "joints": ["one", "two"], "ratio": 2},
    ]
    world = World(Scene(gravity=(0, 0), bodies=bodies, joints=[joints[2], *joints[:2]]))
    world.step(25)
    found, other = saved(world, tmp_path)
    assert found.remarks == ()
    for _ in range(6):
        world.step(10)
        other.step(10)
        assert apart(world, other) < ROUNDING


def test_what_commands_have_set_is_written() -> None:
    world = running("hinge", 0)
    world.apply(SetMotor("joint", 1.0, 5.0))
    world.apply(SetLimits("joint", -0.5, None))
    world.apply(SetSpring("joint", 2.0, 0.3, 0.25))
    word = scene_of(world).scene.joints[0].to_data()
    assert set(word) == {
        "id", "type", "bodies", "anchor", "motor_speed", "max_torque", "lower", "hertz", "damping_ratio", "rest",
    }  # fmt: skip
    assert (word["max_torque"], word["hertz"], word["damping_ratio"]) == (5, 2, 0.3)
    again = World(scene_of(world).scene)
    assert again.joint("joint").limits == (-0.5, None)
    assert again.joint("joint").motor_speed == 1.0
    world.apply(SetMotor("joint", None))
    world.apply(SetJoint("joint", enabled=False))
    word = scene_of(world).scene.joints[0].to_data()
    assert "motor_speed" not in word
    assert word["enabled"] is False


def test_a_suspension_without_a_spring_says_so() -> None:
    world = running("wheel", 0)
    world.apply(SetSpring("joint", None, 0.7))
    assert scene_of(world).scene.joints[0].to_data()["hertz"] is None


def test_a_target_stays_where_it_is_in_the_world(tmp_path: Path) -> None:
    pull = {"id": "pull", "type": "target", "bodies": ["b"], "anchor": [1.4, 0.3], "target": [2, 2], "hertz": 1}
    world = World(Scene(gravity=(0, 0), bodies=two(**SPIN), joints=[pull]))
    world.step(30)
    world.apply(SetTarget("pull", (1.0, -2.0)))
    found, other = saved(world, tmp_path)
    assert found.scene.joints[0].target == (1.0, -2.0)
    world.step(60)
    other.step(60)
    assert apart(world, other) < ROUNDING


def test_a_torn_joint_begins_with_its_bodies_where_they_are() -> None:
    world = running("hinge", 0)
    world.apply(SetPose("b", (3.0, 1.0), 0.0))
    found = scene_of(world)
    assert found.remarks == ("torn joints begin with their bodies where they are now: joint",)
    (ax, ay), (bx, by) = world.joint("joint").anchors
    assert found.scene.joints[0].anchor == pytest.approx((0.5 * (ax + bx), 0.5 * (ay + by)))


def test_a_hinge_on_the_world_stays_where_it_is_nailed() -> None:
    nail = {"id": "nail", "type": "revolute", "bodies": ["b"], "anchor": [0.5, 0.3]}
    world = World(Scene(bodies=two(), joints=[nail]))
    world.step(50)
    assert scene_of(world).scene.joints[0].anchor == (0.5, 0.3)

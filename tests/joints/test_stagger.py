"""Parts that nothing touches are relaxed once a step: the same positions, whoever shares their batch."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from sandbox import StartDrag
from sandbox.engine.world import World
from sandbox.scene.flat import FlatJoint, FlatSettings
from tests.flat import AWAKE, body, box
from tests.joints.jointed import joint, jointed, row

ONE_BY_ONE = FlatSettings(sleeping=False, step_rate=240.0, substeps=1)
"""Every substep of the usual settings is a step, and relaxed."""


def scissors(k: float = 0.0) -> tuple[list[Any], list[FlatJoint]]:
    """Two planks on a slide, a rod between one of them and a third that flies."""
    planks = [body(f"s{i}", box(1.0, 0.2), position=(k + i, 5.0 - 0.3 * i), angular_velocity=2.0 - i) for i in range(3)]
    joints = [
        joint("slide", "prismatic", "s0", "s1", (k + 0.5, 4.85), axis=(0.6, 0.8)),
        joint("rod", "distance", "s1", "s2", anchor_a=(k + 1.4, 4.7), anchor_b=(k + 1.8, 4.4)),
    ]
    return planks, joints


def springs() -> tuple[list[Any], list[FlatJoint]]:
    """Elastic welds, a spring and a wheel with a motor, one after another."""
    planks = [body(f"e{i}", box(1.0, 0.2), position=(i + 0.5, 5.0), velocity=(0.0, 0.5 * i)) for i in range(4)]
    joints = [
        joint("root", "weld", None, "e0", (0.0, 5.0), hertz=3.0, damping_ratio=0.2, angular_hertz=5.0),
        joint("weld", "weld", "e0", "e1", (1.0, 5.0), angular_hertz=4.0, angular_damping_ratio=0.1),
        joint("spring", "distance", "e1", "e2", anchor_a=(1.5, 5.0), anchor_b=(2.5, 5.0), hertz=4.0, damping_ratio=0.1),
        joint("wheel", "wheel", "e2", "e3", (3.0, 5.0), axis=(0.6, 0.8), hertz=3.0, motor_speed=2.0, max_motor=5.0),
    ]
    return planks, joints


def motion(world: World) -> Any:
    b = world.state.bodies
    return np.column_stack([b.center_x, b.center_y, b.angle, b.velocity_x, b.velocity_y, b.angular_velocity])


def is_staggered(world: World) -> list[int]:
    d = world.scratch.joints.direct
    return d.batches["staggered"][: int(d.found[0])].tolist()


@pytest.mark.parametrize("parts", [row(3), row(7), scissors(), springs()])
def test_positions_are_those_of_relaxing_every_substep(parts):
    bodies, joints = parts
    world = jointed(tuple(bodies), tuple(joints))
    judge = jointed(tuple(bodies), tuple(joints), settings=ONE_BY_ONE)
    for _ in range(20):
        world.step()
        judge.step(4)
        assert is_staggered(world) == [1]
    # The method errs by 1e-4 m; what is solved by one turn of Newton's method differs by what that leaves.
    assert motion(world)[:, :3] == pytest.approx(motion(judge)[:, :3], abs=5e-6)
    assert motion(world)[:, 3:] == pytest.approx(motion(judge)[:, 3:], abs=5e-4)


def test_velocities_keep_the_joints_when_the_step_ends():
    bodies, joints = row(5)
    world = jointed(tuple(bodies), tuple(joints))
    for _ in range(30):
        world.step()
        for k in range(5):
            one, other = world.joint(f"j{k}").anchors
            b = world.body(f"p{k}")
            if k == 0:
                assert speed_at(b, other) == pytest.approx((0.0, 0.0), abs=1e-3)
            else:
                a = world.body(f"p{k - 1}")
                assert speed_at(b, other) == pytest.approx(speed_at(a, one), abs=1e-3)


def speed_at(moving: Any, point: Any) -> tuple[float, float]:
    (x, y), (vx, vy), w = moving.center, moving.velocity, moving.angular_velocity
    return vx - w * (point[1] - y), vy + w * (point[0] - x)


def test_what_a_joint_gives_is_what_it_gives_when_every_substep_is_relaxed():
    bodies, joints = row(4)
    world = jointed(tuple(bodies), tuple(joints))
    judge = jointed(tuple(bodies), tuple(joints), settings=ONE_BY_ONE)
    for _ in range(10):
        world.step()
        forces = np.zeros((4, 2))
        for _ in range(4):
            judge.step()
            forces += 0.25 * np.array([judge.joint(f"j{k}").force for k in range(4)])
        found = np.array([world.joint(f"j{k}").force for k in range(4)])
        assert found == pytest.approx(forces, rel=5e-3, abs=0.05)


def test_who_shares_a_layout_does_not_matter():
    """One chain flies; another one of the same layout lies on the ground, or is not there."""
    bodies, joints = row(3, pin="start")
    flown = jointed(tuple(bodies), tuple(joints))
    lying = [body(f"q{k}", box(1.0, 0.25), position=(k + 0.5, -20.0 + 0.125)) for k in range(3)]
    links = [joint(f"i{k}", "revolute", f"q{k - 1}", f"q{k}", (float(k), -20.0)) for k in (1, 2)]
    links.append(joint("i0", "revolute", None, "q0", (0.0, -19.875)))
    floor = body("floor", box(40.0, 1.0), type="static", position=(0.0, -20.5))
    both = jointed((*bodies, floor, *lying), (*joints, *links))
    for _ in range(40):
        flown.step()
        both.step()
        assert motion(both)[:3].tobytes() == motion(flown).tobytes()
    assert sorted(is_staggered(both)) == [0, 1]


def test_what_a_hand_drags_is_relaxed_in_every_substep():
    bodies, joints = row(3)
    world = jointed(tuple(bodies), tuple(joints), settings=AWAKE)
    world.step()
    world.apply(StartDrag("p2", (2.5, 0.0)))
    world.step()
    assert is_staggered(world) == [0]

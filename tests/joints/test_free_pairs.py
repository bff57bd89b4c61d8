"""Joints between bodies that nothing else holds make neither momentum nor angular momentum."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from sandbox.engine.world import World
from tests.flat import body, box, circle
from tests.joints.jointed import joint, jointed

DRIVEN = {"motor_speed": 2.0, "max_motor": 40.0, "hertz": 2.0, "damping_ratio": 0.3, "rest": 0.4}
BOUND = {"lower": -0.2, "upper": 0.3}
PULLED: dict[str, Any] = {"points": ((2.0, 1.5),), "angle": 0.5, "hertz": 5.0, "damping_ratio": 1.0}
PULLED |= {"angular_hertz": 5.0, "angular_damping_ratio": 1.0}
APART = {"anchor_a": (-0.3, 0.2), "anchor_b": (1.0, 0.5)}
KINDS: dict[str, dict[str, Any]] = {
    "distance": APART,
    "distance spring": {**APART, "hertz": 3.0, "damping_ratio": 0.2, "length": 2.5},
    "distance rope": {**APART, "lower": 0.5, "upper": 1.2},
    "revolute": {},
    "revolute driven": DRIVEN,
    "revolute limited": {**DRIVEN, **BOUND},
    "prismatic": {"axis": (0.6, 0.8)},
    "prismatic driven": {"axis": (0.6, 0.8), **DRIVEN},
    "prismatic limited": {"axis": (0.6, 0.8), **DRIVEN, **BOUND},
    "weld": {},
    "weld soft": {"hertz": 4.0, "damping_ratio": 0.2, "angular_hertz": 3.0, "angular_damping_ratio": 0.5},
    "wheel": {"axis": (0.0, 1.0), "hertz": 3.0, "damping_ratio": 0.7},
    "wheel driven": {"axis": (0.0, 1.0), "hertz": 3.0, "motor_speed": 5.0, "max_motor": 8.0, **BOUND},
    "motor": PULLED,
    "motor weak": {**PULLED, "max_force": 5.0, "max_torque": 1.0},
    "motor rigid": {**PULLED, "hertz": 0.0, "angular_hertz": 0.0},
    "friction": {"max_force": 3.0, "max_torque": 0.5},
}
"""Every kind that leaves two bodies free: the world takes the reaction of targets and of the wheels of pulleys."""
MASSES = [1.0, 1000.0, 0.001]


def pair(name: str, ratio: float, seed: int, still: bool, **extra: Any) -> World:
    """Two bodies at random poses and, unless `still`, with random velocities that do not fit their joint."""
    random = np.random.default_rng(seed)
    speed = 0.0 if still else 1.0
    places = (float(random.uniform(-1.0, 0.0)), 0.4), (1.2, float(random.uniform(-1.0, 1.0)))
    parts = [
        body(
            f"{name}", box(0.8, 0.5), position=place, angle=float(random.uniform(-3.0, 3.0)), mass=mass,
            velocity=tuple(speed * random.normal(size=2)), angular_velocity=float(speed * random.normal()),
        )
        for name, place, mass in zip("ab", places, (1.0, ratio), strict=True)
    ]  # fmt: skip
    fields = KINDS[name]
    at = None if "anchor_a" in fields else (0.4, 0.3)
    return jointed(tuple(parts), (joint("j", name.split()[0], "a", "b", at, **fields, **extra),), gravity=(0.0, 0.0))


def momenta(world: World) -> tuple[np.ndarray, np.ndarray]:
    """Momentum (x, y) and angular momentum about the origin, and the sizes that they are sums of."""
    b = world.state.bodies
    px, py, spin = b.mass * b.velocity_x, b.mass * b.velocity_y, b.inertia * b.angular_velocity
    parts = [px, py, np.concatenate([b.center_x * py, -b.center_y * px, spin])]
    return np.array([part.sum() for part in parts]), np.array([np.abs(part).sum() for part in parts])


@pytest.mark.parametrize("ratio", MASSES)
@pytest.mark.parametrize("coupled", ["revolute", "wheel", "prismatic"])
def test_a_gear_between_free_bodies_keeps_both(coupled, ratio):
    random = np.random.default_rng(5)
    parts = tuple(
        body(
            name, box(0.8, 0.5, group=-1), position=(1.5 * k, 0.3 * k), angle=0.7 * k, mass=mass,
            velocity=tuple(random.normal(size=2)), angular_velocity=float(random.normal()),
        )
        for k, (name, mass) in enumerate(zip("abc", (1.0, 2.0, ratio), strict=True))
    )  # fmt: skip
    first, second = joint("first", coupled, "a", "b", (0.7, 0.3)), joint("second", "revolute", "b", "c", (2.2, 0.5))
    gear = joint("j", "gear", None, None, joints=("first", "second"), ratio=-1.5)
    world = jointed(parts, (first, second, gear), gravity=(0.0, 0.0))
    before, largest = momenta(world)
    for _ in range(30):
        world.step(4)
        now, sizes = momenta(world)
        largest = np.maximum(largest, sizes)
        assert np.all(np.abs(now - before) <= 1e-9 * largest)


@pytest.mark.parametrize("still", [False, pytest.param(True, marks=pytest.mark.slow)], ids=["moving", "still"])
@pytest.mark.parametrize("ratio", MASSES)
@pytest.mark.parametrize("name", KINDS)
def test_a_free_pair_keeps_its_momentum_and_its_angular_momentum(name, ratio, still):
    """To rounding, also where a soft weld is drawn apart by more than half its arm."""
    for seed in range(4):
        world = pair(name, ratio, seed, still)
        before, _ = momenta(world)
        largest = np.ones(3)
        for _ in range(30):
            world.step(4)
            now, sizes = momenta(world)
            largest = np.maximum(largest, sizes)
            assert np.all(np.abs(now - before) <= 1e-9 * largest)


def test_a_motor_brings_a_free_pair_to_its_pose_and_to_rest():
    world = pair("motor", 3.0, 1, True)
    (ax, ay), turn = world.body("a").position, world.body("a").angle
    x, y = 2.0 - ax, 1.5 - ay
    c, s = math.cos(turn), math.sin(turn)
    wanted = c * x + s * y, c * y - s * x
    world.step(600)
    a, b = world.body("a"), world.body("b")
    (px, py), (qx, qy) = world.joint("j").anchors[1], a.position
    c, s = math.cos(a.angle), math.sin(a.angle)
    assert (c * (px - qx) + s * (py - qy), c * (py - qy) - s * (px - qx)) == pytest.approx(wanted, abs=1e-6)
    assert world.joint("j").angle == pytest.approx(0.5, abs=1e-6)
    assert max(map(abs, (*a.velocity, *b.velocity, a.angular_velocity, b.angular_velocity))) < 1e-6


@pytest.mark.parametrize("spin", [0.0, 2.0, 20.0])
def test_a_spring_to_a_spinning_body_swings_as_it_should(spin):
    """About the centre of a body that does not give way, its spin makes no difference: an ellipse at 1 Hz."""
    hub = body("hub", circle(1.0), mass=1e8, angular_velocity=spin)
    ball = body("ball", circle(0.2), position=(1.0, 0.0), velocity=(0.0, 3.0), angular_velocity=spin)
    spring = joint("j", "motor", "hub", "ball", (1.0, 0.0), points=((0.0, 0.0),), hertz=1.0)
    world = jointed((hub, ball), (spring,), gravity=(0.0, 0.0))
    omega = 2.0 * math.pi
    for _ in range(600):
        world.step()
        t = omega * world.time
        assert world.body("ball").position == pytest.approx((math.cos(t), 3.0 / omega * math.sin(t)), abs=4e-4)


def test_the_rope_of_a_pulley_turns_nobody_about_its_wheel():
    crate, sack = body("crate", box(0.8, 0.5), angle=0.4), body("sack", circle(0.4), position=(3.0, 0.5), mass=5.0)
    wheels = (0.5, 3.0), (2.5, 3.0)
    rope = joint("rope", "pulley", "crate", "sack", anchor_a=(0.3, 0.2), anchor_b=(3.0, 0.8), points=wheels, ratio=1.5)
    world = jointed(
        (replace(crate, velocity=(2.0, 1.0)), replace(sack, velocity=(-1.0, 2.0))), (rope,), gravity=(0.0, 0.0)
    )

    def turning() -> np.ndarray:
        b = world.state.bodies
        x, y = b.center_x - [wheel[0] for wheel in wheels], b.center_y - [wheel[1] for wheel in wheels]
        return b.mass * (x * b.velocity_y - y * b.velocity_x) + b.inertia * b.angular_velocity

    before = turning()
    for _ in range(120):
        world.step()
        assert turning() == pytest.approx(before, abs=1e-9)


def test_a_target_gives_the_momentum_that_it_tells():
    crate = body("crate", box(0.8, 0.5), velocity=(1.0, -2.0), angular_velocity=3.0)
    pull = joint(
        "j", "target", None, "crate", (0.3, 0.1), points=((2.0, 1.0),), hertz=2.0, damping_ratio=0.7, max_force=9.0
    )
    world = jointed((crate,), (pull,), gravity=(0.0, 0.0))
    given = np.zeros(2)
    before, _ = momenta(world)
    for _ in range(120):
        world.step()
        given += np.array(world.joint("j").force) / 60.0
        assert momenta(world)[0][:2] - before[:2] == pytest.approx(given, abs=1e-9)

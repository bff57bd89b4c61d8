"""A spring has one stiffness, wherever its anchors are and however its bodies lie: that of their reduced mass."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from sandbox.engine.world import World
from tests.flat import body, box, ground
from tests.joints.jointed import joint, jointed
from tests.joints.nets import soft_parts

HERTZ = 2.0
PULL = (2.0 * math.pi * HERTZ) ** 2
"""Stiffness of a spring over the reduced mass of its bodies, 1/s^2."""
TURNED = [0.0, 30.0, 45.0, 90.0]


def turned(degrees: float, x: float, y: float) -> tuple[float, float]:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return c * x - s * y, s * x + c * y


@pytest.mark.parametrize("degrees", TURNED)
@pytest.mark.parametrize("kind", ["weld", "motor"])
def test_a_rod_on_a_soft_joint_at_its_end_sags_by_its_weight_over_the_stiffness(kind, degrees):
    """The whole scene turned, with its gravity: g / w^2 downward and nothing sideways."""
    rod = body("rod", box(2.0, 0.2), position=turned(degrees, 1.0, 0.0), angle=math.radians(degrees))
    fields: dict[str, Any] = {"hertz": HERTZ, "damping_ratio": 1.0, "angular_hertz": 3.0, "angular_damping_ratio": 1.0}
    if kind == "motor":
        fields["points"] = ((0.0, 0.0),)
    world = jointed((rod,), (joint("j", kind, None, "rod", (0.0, 0.0), **fields),), gravity=turned(degrees, 0.0, -3.0))
    world.step(400)
    (ax, ay), (bx, by) = world.joint("j").anchors
    assert turned(-degrees, bx - ax, by - ay) == pytest.approx((0.0, -3.0 / PULL), abs=1e-6)


@pytest.mark.parametrize("most", [math.inf, 2.0])
def test_a_target_pulls_a_rod_alike_in_all_directions(most):
    """Also with all the force that it has."""
    found = []
    for degrees in TURNED:
        rod = body("rod", box(2.0, 0.2), position=turned(degrees, 1.0, 0.0), angle=math.radians(degrees))
        fields = {"points": (turned(degrees, 2.2, 0.7),), "hertz": HERTZ, "damping_ratio": 0.3, "max_force": most}
        pull = joint("j", "target", None, "rod", turned(degrees, 1.8, 0.0), **fields)
        world = jointed((rod,), (pull,), gravity=(0.0, 0.0))
        world.step(40)
        rod_now = world.body("rod")
        found.append((*turned(-degrees, *rod_now.position), rod_now.angle - math.radians(degrees)))
    for other in found[1:]:
        assert other == pytest.approx(found[0], abs=1e-9)


SPRINGS: dict[str, dict[str, Any]] = {
    "weld": {"anchor_a": (0.0, 0.8), "anchor_b": (0.0, 0.8), "angular_hertz": 1.0},
    "motor": {"anchor_a": (0.0, 0.8), "anchor_b": (0.0, 0.8), "angular_hertz": 1.0, "points": ((0.0, 0.8),)},
    "distance": {"anchor_a": (-0.6, 0.9), "anchor_b": (0.6, 0.7)},
    "wheel": {"anchor_a": (0.0, 0.8), "anchor_b": (0.0, 0.8), "axis": (0.8, 0.6)},
    "prismatic": {"anchor_a": (0.0, 0.8), "anchor_b": (0.0, 0.8), "axis": (0.8, 0.6)},
}


def spinning_pair(kind: str, hertz: float, spin: float) -> World:
    """Two rods side by side on an undamped spring beside their centres, nearly turning as one."""
    rods = [
        body(
            name, box(2.0, 0.2, group=-1), position=(x, 0.0), angle=math.pi / 2, mass=mass,
            velocity=(0.0, spin * x - 0.5 * x), angular_velocity=spin * faster,
        )
        for name, x, mass, faster in (("a", -0.6, 0.4, 1.0), ("b", 0.6, 0.7, 1.3))
    ]  # fmt: skip
    spring = joint("j", kind, "a", "b", hertz=hertz, damping_ratio=0.0, angular_damping_ratio=0.0, **SPRINGS[kind])
    return jointed(tuple(rods), (spring,), gravity=(0.0, 0.0))


def energy_with(world: World, kind: str, hertz: float) -> float:
    """Kinetic energy, and that of a spring of one stiffness (J)."""
    b, j = world.state.bodies, world.joint("j")
    kinetic = b.mass * (b.velocity_x**2 + b.velocity_y**2) + b.inertia * b.angular_velocity**2
    (ax, ay), (bx, by) = j.anchors
    away = math.hypot(bx - ax, by - ay)
    if kind == "distance":
        away -= math.hypot(1.2, 0.2)
    elif kind in ("wheel", "prismatic"):
        away = j.translation
    turn = j.angle if kind in ("weld", "motor") else 0.0
    stiff, stiff_about = (1.0 / np.sum(1.0 / each) for each in (b.mass, b.inertia))
    stored = stiff * (2.0 * math.pi * hertz * away) ** 2 + stiff_about * (2.0 * math.pi * turn) ** 2
    return 0.5 * float(np.sum(kinetic) + stored)


@pytest.mark.parametrize("hertz", [0.5, 2.0])
@pytest.mark.parametrize("kind", SPRINGS)
def test_an_undamped_spring_gives_back_what_it_has_taken(kind, hertz):
    """However long, and however far the anchors part; angular momentum is kept to rounding."""
    world = spinning_pair(kind, hertz, 4.0)
    world.step()  # what a slide keeps from turning turns as one after it
    b = world.state.bodies
    about = b.mass * (b.center_x * b.velocity_y - b.center_y * b.velocity_x) + b.inertia * b.angular_velocity
    before, turning = energy_with(world, kind, hertz), float(np.sum(about))
    for _ in range(60):
        world.step(30)
        assert energy_with(world, kind, hertz) == pytest.approx(before, rel=0.01)
    about = b.mass * (b.center_x * b.velocity_y - b.center_y * b.velocity_x) + b.inertia * b.angular_velocity
    assert float(np.sum(about)) == pytest.approx(turning, rel=1e-9)


def net_of(kind: str, degrees: float) -> World:
    """A net of 9 x 9 boxes that hangs from three of them on springs beside their centres."""
    side, tilt = 9, math.radians(degrees)
    places = {(i, k): (0.5 * i, -0.5 * k) for i in range(side) for k in range(side)}
    bodies = [
        body(f"{i} {k}", box(0.4, 0.3, mask=0), position=turned(degrees, x, y), angle=tilt)
        for (i, k), (x, y) in places.items()
    ]
    soft = {"hertz": 6.0, "damping_ratio": 0.5, "angular_hertz": 4.0, "angular_damping_ratio": 0.5}
    joints = []
    for (i, k), (x, y) in places.items():
        at = turned(degrees, x + 0.15, y + 0.1)
        if k == 0 and i % 4 == 0:
            joints.append(joint(f"{i}", "weld", None, f"{i} {k}", at, **soft))
        for other in ((i + 1, k), (i, k + 1)):
            if other in places:
                points = (at,) if kind == "motor" else ()
                joints.append(
                    joint(f"{i} {k} {other}", kind, f"{i} {k}", "{} {}".format(*other), at, points=points, **soft)
                )
    return jointed(tuple(bodies), tuple(joints), gravity=turned(degrees, 0.0, -3.0))


@pytest.mark.parametrize("kind", ["weld", "motor"])
def test_nets_of_springs_hang_alike_in_all_directions(kind):
    found = []
    for degrees in (0.0, 35.0):
        world = net_of(kind, degrees)
        assert soft_parts(world) == 1
        world.step(40)
        found.append([turned(-degrees, *world.body(name).position) for name in ("8 8", "4 4", "2 7")])
    assert np.array(found[1]) == pytest.approx(np.array(found[0]), abs=1e-6 if kind == "weld" else 0.02)


@pytest.mark.parametrize("arm", [3.0, 50.0])
@pytest.mark.parametrize("hertz", [2.0, 8.0])
def test_springs_of_crates_on_the_ground_give_no_energy_however_long_their_levers(arm, hertz):
    """With a lever of 50 m, crates of 0.2 m swing some thousand times as fast as the spring says."""
    crates = [
        body(name, box(0.2, 0.2, friction=0.0), position=(x, 0.1), velocity=(0.2 * x, 0.0), mass=0.04)
        for name, x in (("a", 0.0), ("b", 1.0))
    ]
    fields = {"hertz": hertz, "angular_hertz": hertz, "damping_ratio": 0.0, "angular_damping_ratio": 0.0}
    world = jointed((ground(), *crates), (joint("j", "weld", "a", "b", (0.5, arm), **fields),))
    for _ in range(300):
        world.step()
        b = world.state.bodies
        kinetic = b.mass * (b.velocity_x**2 + b.velocity_y**2) + b.inertia * b.angular_velocity**2
        assert 0.5 * float(np.sum(kinetic)) < 1.1 * 0.5 * 0.04 * 0.2**2

"""Impacts on jointed bodies: as of the rigid body that welds make of them, as the textbook has it for what turns about
a hinge, and without more energy than there was."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings
from tests.flat import AWAKE, body, box, circle, ground, world
from tests.joints.jointed import energy, joint, jointed
from tests.physics.test_momentum import momentum

APART = 1.2
FINE = FlatSettings(step_rate=1000, sleeping=False)
FREE: dict[str, Any] = {"gravity": (0.0, 0.0)}
SHAPES = {"two discs": ("disc", 2), "five discs": ("disc", 5), "two boxes": ("box", 2)}


def shape(kind: str, x: float, **surface: Any):
    return circle(0.5, (x, 0.0), **surface) if kind == "disc" else box(1.0, 0.6, (x, 0.0), **surface)


def places(count: int, angle: float, height: float) -> list[tuple[float, float]]:
    """Of a straight row, whose middle is so high."""
    ways = [APART * (k - 0.5 * (count - 1)) for k in range(count)]
    return [(x * math.cos(angle), height + x * math.sin(angle)) for x in ways]


def row(kind: str, count: int, how: str, angle: float, height: float, velocity=(0.0, 0.0), **surface: Any):
    """Bodies and joints of a row of equal bodies."""
    at = places(count, angle, height)
    shapes = shape(kind, 0.0, **surface)
    bodies = [body(f"{k}", shapes, position=p, angle=angle, velocity=velocity) for k, p in enumerate(at)]
    joints = [
        joint(f"j{k}", how, f"{k}", f"{k + 1}", (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])))
        for k, (a, b) in enumerate(pairwise(at))
    ]
    return bodies, joints


def motion(w: World) -> np.ndarray:
    """Velocity of the centre of mass of all that moves, and angular velocity of the first such body."""
    b = w.state.bodies[1:]
    total = b.mass.sum()
    return np.array([b.mass @ b.velocity_x / total, b.mass @ b.velocity_y / total, b.angular_velocity[0]])


def after_first_blow(w: World) -> np.ndarray:
    before = motion(w)
    for _ in range(9):
        w.step()
        if abs(motion(w) - before).max() > 1e-3:
            return motion(w)
    raise AssertionError("nothing has struck")


@pytest.mark.parametrize("sliding", [0.0, 4.0])
@pytest.mark.parametrize("friction", [0.0, 0.2, 0.6])
@pytest.mark.parametrize("e", [1.0, 0.5])
@pytest.mark.parametrize("angle", [0.0, 0.3, 0.8, 1.5])
@pytest.mark.parametrize("shapes", SHAPES)
def test_welded_bodies_rebound_as_one(shapes, angle, e, friction, sliding):
    kind, count = SHAPES[shapes]
    surface = {"restitution": e, "friction": friction}
    tip = 0.5 if kind == "disc" else 0.5 * math.sin(angle) + 0.3 * math.cos(angle)
    height = 0.02 + 0.5 * APART * (count - 1) * math.sin(angle) + tip
    velocity = (sliding, -8.0)
    bodies, joints = row(kind, count, "weld", angle, height, velocity, **surface)
    welded = jointed((ground(**surface), *bodies), tuple(joints), settings=FINE, **FREE)
    whole = [shape(kind, x, **surface) for x, _ in places(count, 0.0, 0.0)]
    one = body("one", *whole, position=(0.0, height), angle=angle, velocity=velocity)
    wanted = after_first_blow(world(ground(**surface), one, settings=FINE, **FREE))
    lands_flat = kind == "box" and angle == 0.0  # then friction acts at four points at once, in parts of a thousandth
    assert after_first_blow(welded) == pytest.approx(wanted, abs=5e-3 if lands_flat and friction > 0.0 else 1e-3)


@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("e", [1.0, 0.5])
@pytest.mark.parametrize("mass", [0.2, 1.0, 5.0])
@pytest.mark.parametrize("arm", [0.4, 0.7, 1.0, 1.3, 1.6, 1.9])
def test_a_ball_strikes_a_rod_on_a_hinge(arm, mass, e, rate):
    """The rod's effective mass so far from its hinge is its inertia about that by the square of the distance; the hinge
    gives the rod what the ball has not."""
    surface = {"restitution": e, "friction": 0.0}
    rod = body("rod", box(0.1, 2.0, **surface), position=(0.0, -1.0), mass=1.0)
    ball = body("ball", circle(0.2, **surface), position=(-1.03, -arm), velocity=(5.0, 0.0), mass=mass)
    settings = FlatSettings(step_rate=rate, sleeping=False)
    w = jointed((rod, ball), (joint("hinge", "revolute", None, "rod", (0.0, 0.0)),), settings=settings, **FREE)
    for _ in range(rate):
        w.step()
        if w.body("ball").velocity[0] != pytest.approx(5.0, abs=1e-6):
            break
    inertia = (0.1**2 + 2.0**2) / 12.0 + 1.0
    push = (1.0 + e) * 5.0 / (1.0 / mass + arm**2 / inertia)
    assert w.body("ball").velocity == pytest.approx((5.0 - push / mass, 0.0), abs=1e-6)
    turns_on = 1e-6 if rate == 240 else 5e-5  # for the rest of the step, by up to 9 degrees
    assert w.body("rod").angular_velocity == pytest.approx(push * arm / inertia, abs=turns_on)
    passed = w.joint("hinge").force[0] / rate
    assert passed == pytest.approx(w.body("rod").mass * w.body("rod").velocity[0] - push, rel=1e-6, abs=turns_on)


def range_of_energy(count: int, angle: float, rate: int) -> tuple[float, float]:
    """Lowest and highest energy of a hinged chain that bounces for 4 s, by what it had."""
    surface = {"restitution": 1.0, "friction": 0.0}
    bodies, joints = row("disc", count, "revolute", angle, 4.0, **surface)
    settings = FlatSettings(step_rate=rate, sleeping=False)
    w = jointed((ground(**surface), *bodies), tuple(joints), settings=settings)
    found = [energy(w)]
    for _ in range(4 * rate):
        w.step()
        found.append(energy(w))
    return min(found) / found[0], max(found) / found[0]


@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("angle", [0.1, 0.3, 0.8, 1.5])
@pytest.mark.parametrize("count", [2, 3, 4])
def test_a_hinged_chain_keeps_its_energy(count, angle, rate):
    assert range_of_energy(count, angle, rate) == pytest.approx((1.0, 1.0), abs=0.01)


@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("count", [5, 6])
def test_hardly_a_longer_chain_loses_energy(count, rate):
    """One in thirty does: joints turn a disc so that it comes into reach after impacts have been looked for, and its
    contact stops it before it can strike."""
    least, most = np.transpose([range_of_energy(count, 0.1 * k + 0.1, rate) for k in range(15)])
    assert most.max() < 1.01
    assert np.sum(least < 0.99) <= 1


def struck_pair(how: str, e: float, friction: float, apart: float, settings: FlatSettings) -> World:
    """A ball that comes down on the first of two jointed boxes, off its middle, and is that far away."""
    bodies, joints = row("box", 2, how, 0.4, 0.0, restitution=e, friction=friction)
    x, y = bodies[0].position
    c, s = math.cos(0.4), math.sin(0.4)
    place = (x - 0.3 * c - (0.6 + apart) * s, y - 0.3 * s + (0.6 + apart) * c)
    ball = body("ball", circle(0.3, restitution=e, friction=friction), position=place, velocity=(1.0, -9.0))
    return jointed((*bodies, ball), tuple(joints), settings=settings, **FREE)


def opening(w: World, angle: float = 0.4) -> float:
    """How fast the ball leaves the place that it has struck, m/s, along the normal there at the beginning."""
    x = w.body("0").velocity[0] - w.body("ball").velocity[0]
    y = w.body("ball").velocity[1] - w.body("0").velocity[1]
    return x * math.sin(angle) + y * math.cos(angle) + 0.3 * w.body("0").angular_velocity


@pytest.mark.parametrize("friction", [0.0, 0.5])
@pytest.mark.parametrize("e", [1.0, 0.5])
@pytest.mark.parametrize("how", ["weld", "revolute"])
def test_a_blow_on_a_jointed_pair_keeps_momentum_and_rebounds(how, e, friction):
    """In touch from the first, as arms are those of the beginning of a step. Restitution is one of impulses: where the
    blow turns what slides round, it opens by a little less."""
    w = struck_pair(how, e, friction, 1e-9, FINE)
    before, closing = momentum(w), -opening(w)
    w.step()
    assert momentum(w) == pytest.approx(before, abs=1e-9)
    assert opening(w) == pytest.approx(e * closing, rel=1e-4 if friction == 0.0 else 0.04)


@pytest.mark.parametrize("e", [1.0, 0.5])
@pytest.mark.parametrize("how", ["weld", "revolute"])
def test_a_joint_tells_of_the_blow_that_it_passes_on(how, e):
    """Nothing else acts on the second body."""
    w = struck_pair(how, e, 0.3, 0.5, AWAKE)
    highest = 0.0
    for _ in range(10):
        before = np.array(w.body("1").velocity)
        w.step()
        passed = w.body("1").mass * (np.array(w.body("1").velocity) - before)
        assert np.array(w.joint("j0").force) / 60.0 == pytest.approx(passed, abs=1e-9)
        highest = max(highest, float(np.hypot(*passed)))
    assert highest > 0.1

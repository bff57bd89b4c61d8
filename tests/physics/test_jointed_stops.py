"""Blows that bring a joint to its stop, where that has some play left: as the joint goes on until it is just there,
which nothing pulls back. What strikes it rebounds as the exact solution has it, and in a mirror alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings, Vec
from tests.flat import body, box, circle
from tests.joints.jointed import energy, joint, jointed

RATE = 240
SETTINGS = FlatSettings(step_rate=RATE, substeps=1, sleeping=False)
FREE: dict[str, Any] = {"settings": SETTINGS, "gravity": (0.0, 0.0)}
RADIUS, THICK = 0.2, 0.2
FAR = 4.0
SEEDS = range(16)


@dataclass(frozen=True)
class Blow:
    """A ball that touches a body which has one way to move, in axes of that body, whose upper face it strikes.

    The way's inertia, its speed before, and its levers: the speeds that one of its own gives the face along x and y.
    `stop` is the speed that just gets to the stop, `below` or above.
    """

    mass: float
    velocity: Vec
    spin: float
    e: float
    friction: float
    inertia: float
    before: float
    levers: Vec
    stop: float
    below: bool

    def after(self, load: float, drag: float) -> np.ndarray:
        """Velocity of the ball, speed of its rim, and speed of the way, after such impulses (N s) on the ball."""
        x, y = self.levers
        way = self.before - (drag * x + load * y) / self.inertia
        way = max(way, self.stop) if self.below else min(way, self.stop)
        vx, vy = self.velocity
        rim = RADIUS * self.spin + 2.0 * drag / self.mass
        return np.array([vx + drag / self.mass, vy + load / self.mass, rim, way])

    def opening(self, load: float, drag: float) -> float:
        _, vy, _, way = self.after(load, drag)
        return float(vy - way * self.levers[1])

    def slip(self, load: float, drag: float) -> float:
        vx, _, rim, way = self.after(load, drag)
        return float(vx + rim - way * self.levers[0])

    def drag(self, load: float) -> float:
        """Coulomb's, of what slides or sticks in the end."""
        most = self.friction * load
        return bisected(lambda drag: self.slip(load, drag), -most, most)

    def solution(self) -> np.ndarray:
        """What there is after the blow."""
        wanted = -self.e * self.opening(0.0, 0.0)
        load = bisected(lambda load: self.opening(load, self.drag(load)) - wanted, 0.0, 1e3)
        return self.after(load, self.drag(load))


def bisected(rising: Callable[[float], float], low: float, high: float) -> float:
    """Where a function that rises is 0, or the nearer end."""
    if rising(low) >= 0.0:
        return low
    if rising(high) <= 0.0:
        return high
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if rising(middle) > 0.0 else (middle, high)
    return 0.5 * (low + high)


def blow_on(rng: np.random.Generator, rubs: bool, e: float, levers: Vec, inertia: float) -> Blow:
    """A ball that comes down on what moves slowly, the way that it would be struck further than to its stop."""
    free = Blow(
        mass=float(rng.uniform(0.2, 4.0)),
        velocity=(float(rng.uniform(-6.0, 6.0)), -float(rng.uniform(3.0, 8.0))),
        spin=float(rng.uniform(-20.0, 20.0)),
        e=e,
        friction=float(rng.uniform(0.1, 1.0)) if rubs else 0.0,
        inertia=inertia,
        before=0.0,
        levers=levers,
        stop=-math.inf,
        below=True,
    )
    free = replace(free, before=math.copysign(float(rng.uniform(0.0, 0.5)), free.solution()[3]))
    change = float(free.solution()[3]) - free.before
    return replace(free, stop=free.before + float(rng.uniform(0.1, 0.9)) * change, below=change < 0.0)


def turned(point: Vec, angle: float, side: float) -> Vec:
    """A point turned, and then seen in a mirror on the y axis if `side` is -1."""
    c, s = math.cos(angle), math.sin(angle)
    return side * (c * point[0] - s * point[1]), s * point[0] + c * point[1]


def limits(blow: Blow, side: float) -> tuple[float, float]:
    lower, upper = (blow.stop / RATE, FAR) if blow.below else (-FAR, blow.stop / RATE)
    return (lower, upper) if side > 0.0 else (-upper, -lower)


def world_of(blow: Blow, how: str, at: float, pivot: float, angle: float, side: float) -> World:
    """The ball at `at` along a body of 2 m that turns about its point `pivot`, or slides along an axis aslant, the
    levers."""
    surface = {"restitution": blow.e, "friction": blow.friction}
    hinged = how == "revolute"
    velocity = (0.0, -blow.before * pivot) if hinged else (blow.before * blow.levers[0], blow.before * blow.levers[1])
    turn = side * blow.before if hinged else 0.0
    struck = body(
        "struck", box(2.0, THICK, **surface), angle=side * angle, mass=1.0,
        velocity=turned(velocity, angle, side), angular_velocity=turn,
    )  # fmt: skip
    place = turned((at, 0.5 * THICK + RADIUS + 1e-7), angle, side)
    velocity = turned(blow.velocity, angle, side)
    ball = body(
        "ball", circle(RADIUS, **surface), position=place, mass=blow.mass,
        velocity=velocity, angular_velocity=side * blow.spin,
    )  # fmt: skip
    axis = turned(blow.levers, angle, side)
    lower, upper = limits(blow, side if hinged else 1.0)
    held = joint("joint", how, None, "struck", turned((pivot, 0.0), angle, side), axis=axis, lower=lower, upper=upper)
    return jointed((struck, ball), (held,), **FREE)


def struck(how: str, rubs: bool, e: float, seed: int) -> tuple[Blow, Callable[[float], World], float]:
    """A blow, the world of it, seen as it is or in a mirror, and the angle of its axes."""
    rng = np.random.default_rng(seed)
    aside = 1.0 if seed % 2 else -1.0
    pivot = -aside * float(rng.uniform(0.0, 1.0))
    at = pivot + aside * float(rng.uniform(0.3, 0.8))
    if how == "revolute":
        levers, inertia = (-0.5 * THICK, at - pivot), (2.0**2 + THICK**2) / 12.0 + pivot**2
    else:
        aslant = aside * float(rng.uniform(0.3, 2.8))
        levers, inertia = (math.cos(aslant), math.sin(aslant)), 1.0
    blow = blow_on(rng, rubs, e, levers, inertia)
    angle = float(rng.uniform(-3.0, 3.0))
    return blow, lambda side: world_of(blow, how, at, pivot, angle, side), angle


def ball_after(w: World, angle: float, side: float) -> np.ndarray:
    """Velocity of the ball in axes of what it strikes, and the speed of its rim, after a step."""
    w.step()
    ball = w.body("ball")
    vx, vy = ball.velocity
    return np.array([*turned((side * vx, vy), -angle, 1.0), RADIUS * side * ball.angular_velocity])


@pytest.mark.parametrize("e", [1.0, 0.5])
@pytest.mark.parametrize("rubs", [False, True], ids=["smooth", "rough"])
@pytest.mark.parametrize("how", ["revolute", "prismatic"])
def test_what_strikes_a_joint_to_its_stop_rebounds_as_it_should(how, rubs, e):
    errors = []
    for seed in SEEDS:
        blow, world, angle = struck(how, rubs, e, seed)
        wanted = blow.solution()[:3]
        errors.append(np.abs(ball_after(world(1.0), angle, 1.0) - wanted).max() / -blow.opening(0.0, 0.0))
    assert max(errors) < 1e-4


@pytest.mark.parametrize("rubs", [False, True], ids=["smooth", "rough"])
@pytest.mark.parametrize("how", ["revolute", "prismatic"])
def test_a_blow_to_a_stop_is_alike_in_a_mirror(how, rubs):
    for seed in SEEDS:
        _, world, angle = struck(how, rubs, 0.8, seed)
        assert ball_after(world(-1.0), angle, -1.0) == pytest.approx(ball_after(world(1.0), angle, 1.0), abs=1e-9)


@pytest.mark.parametrize("rubs", [False, True], ids=["smooth", "rough"])
@pytest.mark.parametrize("how", ["revolute", "prismatic"])
def test_no_blow_to_a_stop_gains_energy(how, rubs):
    for seed in SEEDS:
        _, world, _ = struck(how, rubs, 1.0, seed)
        w = world(1.0)
        before = energy(w)
        w.step()
        assert energy(w) <= before * (1.0 + 1e-9)

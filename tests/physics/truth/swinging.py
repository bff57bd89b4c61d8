"""Pendulums on a hinge, and two balls that circle each other on a rod."""

from __future__ import annotations

import math

from sandbox.scene.flat import FlatJoint, FlatScene
from tests.flat import body, circle, scene
from tests.physics.truth.experiment import RATE, Engine, Experiment, G, Run, experiment, off

LENGTH, RADIUS = 1.0, 0.1
"""m, from the hinge at the origin to the middle of the bob, a disc."""
INERTIA = LENGTH**2 + 0.5 * RADIUS**2
"""m^2, of the bob about the hinge, for each kilogram of it."""


def _pendulum(amplitude: float) -> FlatScene:
    place = (LENGTH * math.sin(amplitude), -LENGTH * math.cos(amplitude))
    hinge = FlatJoint("hinge", "revolute", None, "bob")
    return scene(body("bob", circle(RADIUS), position=place), joints=(hinge,))


def period(amplitude: float) -> float:
    """4 sqrt(I / (m g l)) K(sin(amplitude / 2)), the elliptic integral by the arithmetic-geometric mean (Gauss)."""
    a, b = 1.0, math.cos(0.5 * amplitude)
    while abs(a - b) > 1e-15:
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return 2.0 * math.pi / a * math.sqrt(INERTIA / (G * LENGTH))


def _swing(run: Run, seconds: float) -> list[float]:
    """The pendulum's angle at the start and after each step."""
    angles = [_angle(run)]
    for _ in range(math.ceil(seconds * RATE)):
        run.step()
        angles.append(_angle(run))
    return angles


def _angle(run: Run) -> float:
    x, y = run.place("bob")
    return math.atan2(x, -y)


def _downward_passes(angles: list[float]) -> list[float]:
    """Times (s) at which the angle falls through zero: the cubic through four samples, read backwards."""
    found = []
    for k in range(1, len(angles) - 2):
        if angles[k] > 0.0 >= angles[k + 1]:
            near, time = angles[k - 1 : k + 3], 0.0
            for i, angle in enumerate(near):
                weights = (other / (other - angle) for j, other in enumerate(near) if j != i)
                time += (k - 1 + i) * math.prod(weights)
            found.append(time / RATE)
    return found


def _period(amplitude: float, bound: float) -> Experiment:
    @experiment(f"pendulum at {amplitude:g} rad", "period, mean of 10", bound)
    def swings(start: Engine) -> float:
        truth = period(amplitude)
        passes = _downward_passes(_swing(start(_pendulum(amplitude)), 11.5 * truth))
        return off((passes[10] - passes[0]) / 10.0, truth)

    return swings


PERIODS = [_period(0.2, 1e-6), _period(1.0, 2e-6), _period(2.5, 4e-6)]


@experiment("pendulum at 1 rad keeps swinging", "amplitude after 30 s", bound=2e-7)
def amplitude_kept(start: Engine) -> float:
    """The greatest angle of a whole period, of the parabola through the three samples around it."""
    angles = _swing(start(_pendulum(1.0)), 30.0 + period(1.0))[30 * RATE :]
    k = max(range(1, len(angles) - 1), key=lambda i: angles[i])
    before, top, after = angles[k - 1 : k + 2]
    return off(top - (after - before) ** 2 / (8.0 * (before - 2.0 * top + after)), 1.0)


@experiment("two balls circle each other on a rod", "angle after 10 s (30 rad), length, speed", bound=5e-6)
def dumbbell(start: Engine) -> float:
    """Balls of masses 1:3 and a massless rod of 2 m: the angular momentum keeps the turn at 3 rad/s."""
    heavy = body("heavy", circle(0.1, density=3.0), position=(-0.5, 0.0), velocity=(0.0, -1.5))
    light = body("light", circle(0.1), position=(1.5, 0.0), velocity=(0.0, 4.5))
    rod = FlatJoint("rod", "distance", "heavy", "light", (-0.5, 0.0), (1.5, 0.0), length=2.0)
    run = start(scene(heavy, light, gravity=(0.0, 0.0), joints=(rod,)))
    run.step(10 * RATE)
    (hx, hy), (lx, ly), (vx, vy) = run.place("heavy"), run.place("light"), run.velocity("light")
    turned = math.remainder(math.atan2(ly - hy, lx - hx) - 30.0, 2.0 * math.pi)
    length, speed = off(math.hypot(lx - hx, ly - hy), 2.0), off(math.hypot(vx, vy), 4.5)
    return max(abs(turned) / 30.0, length, speed)

"""A blow with restitution that brings a joint to its stop, where that has some play left, against the complementarity
problem of contact, friction and stop, solved by trying who acts."""

from __future__ import annotations

import math
import random
from itertools import product
from typing import NamedTuple

import numpy as np
import pytest

import sandbox

STEP = 1.0 / 240.0
HALF = 0.05
"""Half the thickness of the door (m)."""


class Blow(NamedTuple):
    """A ball of a radius (m) and density that flies at `speed` (m/s) against a door of a height (m), `at` above its
    hinge; the stop lets the door turn by `play` (rad)."""

    height: float
    at: float
    radius: float
    density: float
    speed: tuple[float, float]
    restitution: float
    friction: float
    play: float

    @property
    def mass(self) -> float:
        return math.pi * self.radius**2 * self.density

    @property
    def inertia(self) -> float:
        """Of the door about its hinge."""
        mass = 2.0 * HALF * self.height
        return mass * ((self.height**2 + (2.0 * HALF) ** 2) / 12.0 + (0.5 * self.height) ** 2)


def some_blow(seed: int, friction: float) -> Blow:
    """One after which the door, free, would turn past its stop within a step."""
    r = random.Random(seed)
    height, speed = r.uniform(0.5, 1.5), r.uniform(3.0, 12.0)
    slant = r.uniform(-0.5, 0.5) * speed
    at = r.uniform(0.35, 0.95) * height
    blow = Blow(
        height, at, r.uniform(0.1, 0.3), r.uniform(0.3, 3.0), (speed, slant), r.choice([0.3, 0.9]), friction, 0.0
    )
    load = (1.0 + blow.restitution) * speed / (1.0 / blow.mass + at**2 / blow.inertia)
    return blow._replace(play=r.uniform(0.02, 0.9) * STEP * load * at / blow.inertia)


def simulated(blow: Blow, side: float) -> np.ndarray:
    """The velocity and spin of the ball after a step, from the left if `side` is 1, in a mirror if it is -1."""
    surface = {"restitution": blow.restitution, "friction": blow.friction}
    play = math.degrees(blow.play)
    bodies = [
        {"id": "door", "position": [0, blow.height / 2], "shapes": [{"box": [2 * HALF, blow.height], **surface}]},
        {
            "id": "ball",
            "position": [-side * (HALF + blow.radius + 1e-4), blow.at],
            "velocity": [side * blow.speed[0], blow.speed[1]],
            "shapes": [{"circle": blow.radius, "density": blow.density, **surface}],
        },
    ]
    stops = {"lower": -play, "upper": 30} if side > 0.0 else {"lower": -30, "upper": play}
    hinge = {"id": "hinge", "type": "revolute", "bodies": ["door"], "anchor": [0, 0], **stops}
    settings = {"step_rate": 240, "substeps": 1, "restitution_threshold": 0.1}
    world = sandbox.World(sandbox.Scene(bodies=bodies, joints=[hinge], gravity=[0, 0], settings=settings))
    world.step()
    ball = world.body("ball")
    return np.array([side * ball.velocity[0], ball.velocity[1], side * ball.angular_velocity])


def exact(blow: Blow) -> np.ndarray:
    """The same by the complementarity problem: impulses of the contact, of its friction and of the stop."""
    mass, inertia, radius = blow.mass, blow.inertia, blow.radius

    def after(load: float, drag: float, stop: float) -> np.ndarray:
        turn = (HALF * drag - blow.at * load + stop) / inertia
        spin = radius * drag / (0.5 * mass * radius**2)
        return np.array([blow.speed[0] - load / mass, blow.speed[1] + drag / mass, spin, turn])

    def speeds(*impulses: float) -> np.ndarray:
        x, y, spin, turn = after(*impulses)
        return np.array([-turn * blow.at - x, y + spin * radius + HALF * turn, turn + blow.play / STEP])

    begin = speeds(0.0, 0.0, 0.0)
    matrix = np.array([speeds(*unit) - begin for unit in np.eye(3)]).T
    asked = np.array([blow.restitution * blow.speed[0], 0.0, 0.0]) - begin
    for slides, holds in product((0.0, 1.0, -1.0), (True, False)):
        rows, wanted = matrix.copy(), asked.copy()
        if slides != 0.0 or blow.friction == 0.0:
            rows[1], wanted[1] = [slides * blow.friction, 1.0, 0.0], 0.0
        if not holds:
            rows[2], wanted[2] = [0.0, 0.0, 1.0], 0.0
        load, drag, stop = impulses = np.linalg.solve(rows, wanted)
        _, slip, beyond = begin + matrix @ impulses
        within = abs(drag) <= blow.friction * load + 1e-9 and slides * slip >= -1e-9
        if load >= 0.0 and stop >= -1e-9 and beyond >= -1e-9 and within:
            return after(*impulses)[:3]
    raise AssertionError("no solution")


@pytest.mark.parametrize("friction", [0.0, 0.3, 0.7])
def test_a_ball_rebounds_from_a_door_that_comes_to_its_stop(friction: float) -> None:
    for seed in range(60):
        blow = some_blow(seed, friction)
        found = simulated(blow, 1.0)
        assert found == pytest.approx(exact(blow), abs=1e-4), (seed, blow)
        assert simulated(blow, -1.0) == pytest.approx(found, abs=1e-9), (seed, blow)

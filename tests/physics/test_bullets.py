"""Bullets that touch each other go on as all others do: none hangs in mid-air with the speed that it came with."""

from __future__ import annotations

import dataclasses
import random

import numpy as np
import pytest

from sandbox import World
from sandbox.scene.flat import FlatJoint
from tests.flat import body, box, capsule, circle, polygon, world

BULLETS = {
    "box": box(1.0, 1.0),
    "disc": circle(0.5),
    "capsule": capsule(0.4, 0.2),
    "triangle": polygon((-0.5, -0.4), (0.5, -0.4), (0.0, 0.6)),
    "rod": box(0.1, 2.0),
    "needle": box(0.01, 1.0),
}


def hanging(w: World, steps: int) -> int:
    """How many steps in a row a body at most stays nearly where it is, as fast as it is."""
    longest = 0
    run = np.zeros(len(w.bodies.ids))
    for _ in range(steps):
        before = w.bodies.position.copy()
        w.step()
        speed = np.hypot(*w.bodies.velocity.T)
        went = 60.0 * np.hypot(*(w.bodies.position - before).T)
        run = np.where((speed > 3.0) & (went < 0.1 * speed), run + 1, 0)
        longest = max(longest, int(run.max()))
    return longest


@pytest.mark.parametrize("speed", [10.0, 30.0, 100.0])
@pytest.mark.parametrize("kind", BULLETS)
def test_a_heap_of_bullets_comes_to_rest(kind, speed):
    chance = random.Random(7)
    w = world(
        body("pit", box(14.0, 1.0, (0.0, -0.5)), box(1.0, 60.0, (-4.5, 30.0)), box(1.0, 60.0, (4.5, 30.0)),
             type="static"),
        *(
            body(f"b{k}", BULLETS[kind], bullet=True, velocity=(0.0, -speed), angle=chance.uniform(0.0, 6.0),
                 position=(chance.uniform(-3.0, 3.0), 3.0 + 1.3 * k))
            for k in range(20)
        ),
    )  # fmt: skip
    assert hanging(w, 360) <= 30
    assert np.hypot(*w.bodies.velocity.T).max() < 1.0
    assert w.bodies.position[1:, 1].min() > 0.0


@pytest.mark.parametrize("restitution", [0.0, 1.0])
@pytest.mark.parametrize("kind", BULLETS)
def test_bullets_that_meet_keep_their_momentum_and_gain_nothing(kind, restitution):
    chance = random.Random(3)
    shape = dataclasses.replace(BULLETS[kind], restitution=restitution)
    w = world(
        *(
            body(f"b{k}", shape, bullet=True, position=(2.2 * (k % 4), 2.2 * (k // 4)), angle=chance.uniform(0.0, 6.0),
                 velocity=(20.0 * (1.5 - k % 4), 20.0 * (1.5 - k // 4)), angular_velocity=chance.uniform(-30.0, 30.0))
            for k in range(16)
        ),
        gravity=(0.0, 0.0),
    )  # fmt: skip
    bodies = w.state.bodies
    total = float((bodies.mass * np.hypot(bodies.velocity_x, bodies.velocity_y)).sum())
    last = kinetic(w)
    for _ in range(60):
        w.step()
        bodies = w.state.bodies
        assert abs((bodies.mass * bodies.velocity_x).sum()) < 1e-9 * total
        assert abs((bodies.mass * bodies.velocity_y).sum()) < 1e-9 * total
        assert kinetic(w) < last * 1.002
        last = kinetic(w)


def kinetic(w: World) -> float:
    """The energy of motion, J."""
    bodies = w.state.bodies
    square = bodies.velocity_x**2 + bodies.velocity_y**2
    return float(0.5 * (bodies.mass * square + bodies.inertia * bodies.angular_velocity**2).sum())


def test_sheets_that_a_bullet_swings_up_go_on_swinging_and_let_nothing_through():
    """A sheet of 1 cm on a hinge, of twelve times the mass of what strikes it and goes on with it for a while."""
    w = world(
        body("sheet", box(0.01, 3.0, density=25.0), bullet=True, position=(0.0, -1.5)),
        body("ball", circle(0.07, density=4.0), bullet=True, position=(-5.0, -2.4), velocity=(900.0, 0.0)),
        joints=(FlatJoint("hem", "revolute", None, "sheet", (0.0, 0.0), (0.0, 0.0)),),
        gravity=(0.0, 0.0),
    )
    spins = []
    for _ in range(20):
        w.step()
        sheet, ball = w.body("sheet"), w.body("ball")
        spins.append(sheet.angular_velocity)
        along = -np.sin(sheet.angle), np.cos(sheet.angle)
        side = (ball.position[0] - sheet.position[0]) * along[1] - (ball.position[1] - sheet.position[1]) * along[0]
        beside = np.dot(np.subtract(ball.position, sheet.position), along)
        assert side < 0.0 or abs(beside) > 1.5
    assert sheet.angle > 0.5
    assert min(spins[1:]) > 0.0

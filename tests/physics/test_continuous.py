"""Fast bodies: what passes by goes on as it went, and what meets is stopped, however fast it comes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.flat import body, box, capsule, circle, polygon, segment, world

SHARES = np.linspace(0.0, 0.9, 7)
"""Where in its step a body is when it meets the other: luck must not matter."""


@pytest.mark.parametrize("radius", [0.1, 0.25, 0.5])
@pytest.mark.parametrize("speed", [1.0, 5.0, 20.0, 300.0])
@pytest.mark.parametrize("angle", [0.35, 0.8, 1.2])
def test_a_ball_that_passes_a_corner_is_not_deflected(radius, speed, angle):
    n, t = np.array([math.cos(angle), math.sin(angle)]), np.array([-math.sin(angle), math.cos(angle)])
    for gap in (0.001, 0.01, 0.1):
        for share in SHARES:
            start = np.array([0.5, 0.5]) + (radius + gap) * n - (2.0 + share * speed / 60) * t
            w = world(
                body("wall", box(1.0, 1.0), type="static"),
                body("ball", circle(radius), position=tuple(map(float, start)), velocity=tuple(map(float, speed * t))),
                gravity=(0.0, 0.0),
            )
            w.step(int(4 / speed * 60) + 10)
            assert w.body("ball").velocity == pytest.approx(tuple(speed * t), rel=1e-9)


@pytest.mark.parametrize("radius", [0.1, 0.5])
@pytest.mark.parametrize("speed", [2.0, 20.0])
def test_a_disc_that_passes_a_peg_is_not_deflected(radius, speed):
    for gap in (0.001, 0.05):
        for share in SHARES:
            place = -3.0 - share * speed / 60, 2 * radius + gap
            w = world(
                body("peg", circle(radius), type="static"),
                body("disc", circle(radius), position=place, velocity=(speed, 0.0)),
                gravity=(0.0, 0.0),
            )
            w.step(int(6 / speed * 60) + 10)
            assert w.body("disc").velocity == pytest.approx((speed, 0.0), abs=1e-9 * speed)


WALLS = {"thin box": box(0.1, 10.0), "line": segment((0.0, -5.0), (0.0, 5.0)), "post": circle(0.1)}
BULLETS = {"ball": circle(0.05), "box": box(0.1, 0.1), "capsule": capsule(0.1, 0.03)}


# The two points of a flat box leave a residue of some percent, which past 1 km/s is more than a thin wall.
SPEEDS = [(b, v) for b in BULLETS for v in (50.0, 500.0, 1e5) if (b, v) != ("box", 1e5)]


@pytest.mark.parametrize(("bullet", "speed"), SPEEDS)
@pytest.mark.parametrize("wall", WALLS)
def test_a_bullet_does_not_go_through_a_wall(wall, bullet, speed):
    for share in SHARES:
        place = -3.0 - float(share) * speed / 60, 0.01
        w = world(
            body("wall", WALLS[wall], type="static"),
            body("bullet", BULLETS[bullet], position=place, velocity=(speed, 0.0)),
            gravity=(0.0, 0.0),
        )
        w.step(15)
        assert w.body("bullet").velocity[0] < 0.5 * speed
        if wall != "post":
            assert w.body("bullet").position[0] < 0.0


def test_bullets_that_meet_do_not_swap_places():
    for share in SHARES:
        w = world(
            body("a", circle(0.1), position=(-4.0 - 5.0 * float(share), 0.0), velocity=(300.0, 0.0)),
            body("b", circle(0.1), position=(4.0, 0.0), velocity=(-300.0, 0.0)),
            gravity=(0.0, 0.0),
        )
        w.step(20)
        assert w.body("a").position[0] < w.body("b").position[0]


@pytest.mark.parametrize("speed", [20.0, 300.0])
def test_a_bouncing_bullet_comes_back_as_fast(speed):
    for share in SHARES:
        w = world(
            body("wall", box(0.1, 10.0, restitution=1.0), type="static"),
            body("ball", circle(0.05), position=(-3.0 - float(share) * speed / 60, 0.0), velocity=(speed, 0.0)),
            gravity=(0.0, 0.0),
        )
        w.step(int(8 / speed * 60) + 5)
        assert w.body("ball").velocity == pytest.approx((-speed, 0.0), rel=1e-9)


@pytest.mark.parametrize("density", [1.0, 5.0])
@pytest.mark.parametrize("speed", [0.0, 5.0, 60.0])
def test_a_body_under_a_blow_is_not_driven_through_the_floor(speed, density):
    """A heavy fast block lands on a block that lies on thin ground."""
    w = world(
        body("floor", box(40.0, 0.1, (0.0, -0.05)), type="static"),
        body("lower", box(0.5, 0.5), position=(0.0, 0.25)),
        body("upper", box(0.5, 0.5, density=density), position=(0.0, 4.0), velocity=(0.0, -speed)),
    )
    lowest = 1.0
    for _ in range(300):
        w.step()
        lowest = min(lowest, w.body("lower").position[1])
    assert lowest > 0.1
    assert min(w.bodies.position[1:, 1]) == pytest.approx(0.25, abs=0.01)


@pytest.mark.parametrize("speed", [20.0, 60.0])
def test_what_slides_fast_over_slight_bends_is_not_held(speed):
    """A sharp triangle that tips over a bend of 0.03 degrees: where it touches is not where it would hit."""
    ground = (
        (0.989238, -0.000955), (10.0, -3.0), (7.215531, -0.000631), (5.393395, 0.000629), (4.535033, 0.001033),
        (3.653066, 0.001316), (2.344738, 0.001597),
    )  # fmt: skip
    sharp = polygon((-0.5, -0.25), (0.5, -0.25), (0.1, 0.5), friction=0.0)
    moving = {"velocity": (speed, -0.164), "angular_velocity": -0.31}
    w = world(
        body("ground", polygon(*ground, friction=0.0), type="static"),
        body("slider", sharp, position=(4.99986, 0.25117), angle=0.00021, **moving),
    )
    lowest = 1.0
    for _ in range(int(4.0 / speed * 60.0) + 1):
        before = w.body("slider").position[0]
        w.step()
        assert w.body("slider").position[0] - before > 0.5 * speed / 60.0
        if w.body("slider").position[0] < 6.5:
            lowest = min(lowest, w.body("slider").position[1])
    assert lowest > 0.24


PUSHED = {
    "ball": circle(0.25, friction=0.0),
    "box": box(0.5, 0.5, friction=0.0),
    "triangle": polygon((-0.3, -0.25), (0.3, -0.25), (0.0, 0.35), friction=0.0),
}


@pytest.mark.parametrize("pushed", PUSHED)
@pytest.mark.parametrize("lean", [0.0, 0.3, 1.0, 2.0])
@pytest.mark.parametrize("speed", [2.0, 10.0, 40.0])
def test_what_is_pushed_into_the_ground_slides_on(pushed, lean, speed):
    """A pusher whose face leans over presses what it pushes into the ground: held there, it would be run over."""
    face = polygon((0.0, 0.01), (lean, 1.0), (-1.0, 1.0), (-1.0, 0.01))
    w = world(
        body("ground", box(400.0, 2.0, (0.0, -1.0)), type="static"),
        body("pushed", PUSHED[pushed], position=(0.31 + 1.5 * lean, 0.25)),
        body("pusher", face, type="kinematic", velocity=(speed, 0.0)),
    )
    for _ in range(90):
        w.step()
        assert w.body("pushed").position[0] > w.body("pusher").position[0] + 0.12
        assert w.body("pushed").position[1] > 0.12

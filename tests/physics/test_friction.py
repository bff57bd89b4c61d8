"""Coulomb friction, rolling, conveyors."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from sandbox.scene.flat import FlatSettings
from tests.flat import body, box, capsule, circle, ground, world

G = 9.81


def slope(angle: float, **surface) -> tuple:
    """Static ground turned by `angle`: its top runs through the origin, uphill to +x."""
    return (body("ground", box(400.0, 2.0, (0.0, -1.0), **surface), type="static", angle=angle),)


def on_slope(angle: float, shape, height: float, **fields):
    """A body resting on the slope at the origin, its middle `height` above the surface."""
    position = (-height * math.sin(angle), height * math.cos(angle))
    return body("rider", shape, position=position, angle=angle, **fields)


def way_down(w, steps: int, angle: float) -> float:
    """How far the rider has gone down the slope after `steps`."""
    start = w.body("rider").position
    w.step(steps)
    x, y = w.body("rider").position
    return -((x - start[0]) * math.cos(angle) + (y - start[1]) * math.sin(angle))


def slides(angle: float, mu: float, shape, height: float) -> bool:
    w = world(*slope(angle, friction=mu), on_slope(angle, shape, height))
    w.step(60)
    return way_down(w, 120, angle) > 1e-4


@pytest.mark.parametrize(
    ("shape", "height"),
    [(box(1.0, 0.3), 0.15), (box(0.8, 0.2, radius=0.05), 0.15), (capsule(0.5, 0.1), 0.1)],
    ids=["box", "rounded box", "capsule"],
)
@pytest.mark.parametrize("mu", [0.2, 0.5, 0.8])
def test_sliding_starts_at_the_friction_angle(mu, shape, height):
    rider = replace(shape, friction=mu)
    low, high = 0.0, math.radians(60.0)
    assert not slides(low, mu, rider, height)
    assert slides(high, mu, rider, height)
    while high - low > math.radians(0.02):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if slides(middle, mu, rider, height) else (middle, high)
    assert math.degrees(0.5 * (low + high)) == pytest.approx(math.degrees(math.atan(mu)), abs=0.1)


@pytest.mark.parametrize("mu", [0.1, 0.3, 0.7])
@pytest.mark.parametrize("speed", [2.0, 8.0])
def test_stopping_distance(mu, speed):
    w = world(
        ground(friction=mu),
        body("sled", box(1.0, 0.2, friction=mu), position=(0.0, 0.1)),
    )
    w.step(30)
    start = w.body("sled").position[0]
    w.body("sled").velocity = (speed, 0.0)
    w.step(60 + int(60 * speed / (mu * G)))
    assert w.body("sled").velocity[0] == pytest.approx(0.0, abs=1e-6)
    assert w.body("sled").position[0] - start == pytest.approx(speed**2 / (2 * mu * G), rel=5e-3)


def test_friction_of_a_pair_is_the_geometric_mean():
    w = world(ground(friction=0.9), body("sled", box(1.0, 0.2, friction=0.1), position=(0.0, 0.1), velocity=(5.0, 0.0)))
    w.step(300)
    assert w.body("sled").position[0] == pytest.approx(25.0 / (2 * 0.3 * G), rel=1e-2)


@pytest.mark.parametrize(("mu", "degrees"), [(0.2, 30.0), (0.0, 20.0), (0.5, 40.0)])
def test_sliding_down_a_slope(mu, degrees):
    angle = math.radians(degrees)
    w = world(*slope(angle, friction=mu), on_slope(angle, box(1.0, 0.2, friction=mu), 0.1))
    a = G * (math.sin(angle) - mu * math.cos(angle))
    assert way_down(w, 120, angle) == pytest.approx(0.5 * a * 4.0, rel=5e-3)


def test_sliding_up_a_slope_and_staying_there():
    angle, mu, speed = math.radians(20.0), 0.5, 6.0
    rider = box(1.0, 0.2, friction=mu)
    velocity = (speed * math.cos(angle), speed * math.sin(angle))
    w = world(*slope(angle, friction=mu), on_slope(angle, rider, 0.1, velocity=velocity))
    a = G * (math.sin(angle) + mu * math.cos(angle))
    assert -way_down(w, 240, angle) == pytest.approx(speed**2 / (2 * a), rel=5e-3)
    assert way_down(w, 240, angle) == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize("degrees", [5.0, 20.0])
def test_a_disc_rolls_down_without_slipping(degrees):
    angle = math.radians(degrees)
    w = world(*slope(angle, friction=1.0), on_slope(angle, circle(0.5, friction=1.0), 0.5))
    assert way_down(w, 180, angle) == pytest.approx(0.5 * (2.0 / 3.0 * G * math.sin(angle)) * 9.0, rel=5e-3)
    vx, vy = w.body("rider").velocity
    along, up = -(vx * math.cos(angle) + vy * math.sin(angle)), vy * math.cos(angle) - vx * math.sin(angle)
    assert w.body("rider").angular_velocity * 0.5 == pytest.approx(along, rel=1e-4)
    assert up == pytest.approx(0.0, abs=1e-3), "however fast it rolls, it stays on the slope"


def test_a_disc_on_a_steep_slope_slips():
    """Friction mu g cos is all it can have: a = g (sin - mu cos), and the spin grows by 2 mu g cos / r."""
    angle, mu = math.radians(50.0), 0.1
    w = world(*slope(angle, friction=mu), on_slope(angle, circle(0.5, friction=mu), 0.5))
    a = G * (math.sin(angle) - mu * math.cos(angle))
    assert way_down(w, 120, angle) == pytest.approx(0.5 * a * 4.0, rel=5e-3)
    assert w.body("rider").angular_velocity == pytest.approx(2 * mu * G * math.cos(angle) / 0.5 * 2.0, rel=2e-3)


def test_a_sliding_ball_ends_rolling_at_two_thirds_of_its_speed():
    w = world(ground(friction=0.4), body("ball", circle(0.5, friction=0.4), position=(0.0, 0.5), velocity=(6.0, 0.0)))
    w.step(240)
    assert w.body("ball").velocity[0] == pytest.approx(4.0, rel=5e-3)
    assert w.body("ball").angular_velocity == pytest.approx(-8.0, rel=5e-3)


@pytest.mark.parametrize("arm", [0.002, 0.01, 0.05])
def test_rolling_resistance_slows_a_disc(arm):
    """Torque arm * N against the roll, friction keeps it from slipping: a = g arm r / (r^2 + r^2 / 2)."""
    ball = circle(0.5, friction=1.0, rolling_resistance=arm)
    w = world(
        ground(friction=1.0),
        body("ball", ball, position=(0.0, 0.5), velocity=(3.0, 0.0), angular_velocity=-6.0),
    )
    w.step(60)
    assert w.body("ball").velocity[0] == pytest.approx(3.0 - G * arm * 0.5 / (1.5 * 0.25), rel=2e-3)


@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("substeps", [1, 4])
def test_rolling_resistance_slows_a_disc_from_the_first_step_on(rate, substeps):
    ball = circle(0.5, friction=1.0, rolling_resistance=0.05)
    w = world(
        ground(friction=1.0),
        body("ball", ball, position=(0.0, 0.5), velocity=(2.0, 0.0), angular_velocity=-4.0),
        settings=FlatSettings(sleeping=False, step_rate=rate, substeps=substeps),
    )
    w.step()
    assert (2.0 - w.body("ball").velocity[0]) * rate == pytest.approx(G * 0.05 * 0.5 / (1.5 * 0.25), rel=1e-4)


@pytest.mark.parametrize("mass", [1.0, 10.0])
def test_a_disc_that_rolls_on_a_loose_board_takes_it_along_from_the_first_step_on(mass):
    """Friction f slows the disc by f / m and speeds the smooth board by f / M; it grips: a = g b / (r + k (1 + m / M)),
    with k = I / (m r) = r / 2."""
    w = world(
        ground(friction=0.0),
        body("board", box(40.0, 0.2, friction=1.0), position=(0.0, 0.1), mass=mass),
        body(
            "ball",
            circle(0.5, friction=1.0, rolling_resistance=0.05),
            position=(-5.0, 0.7),
            mass=1.0,
            velocity=(2.0, 0.0),
            angular_velocity=-4.0,
        ),
    )
    w.step()
    slowed = G * 0.05 / (0.5 + 0.25 * (1.0 + 1.0 / mass)) / 60.0
    assert 2.0 - w.body("ball").velocity[0] == pytest.approx(slowed, rel=1e-3)
    assert w.body("board").velocity[0] == pytest.approx(slowed / mass, rel=1e-3)


@pytest.mark.parametrize("speed", [1.0, 6.0])
@pytest.mark.parametrize("arm", [0.05, 0.2])
def test_a_rolling_disc_that_lands_is_slowed_by_the_blow_and_grips(arm, speed):
    """The blow m v resists the roll by arm m v, and friction shares that with the way: v arm r / (r^2 + r^2 / 2)."""
    w = rolling_in(arm, speed, ground(friction=2.0, rolling_resistance=arm))
    w.step(30)
    ball = w.body("ball")
    assert 8.0 - ball.velocity[0] == pytest.approx(speed * arm * 0.5 / (1.5 * 0.25), rel=1e-6)
    assert ball.velocity[0] + 0.5 * ball.angular_velocity == pytest.approx(0.0, abs=1e-6)
    assert ball.velocity[1] == pytest.approx(0.0, abs=1e-6)


def test_a_disc_that_lands_on_a_loose_board_rolls_on_and_takes_it_along():
    """Both stop closing in, the disc by J = v m M / (m + M), and grip by F: as above with the momentum that is left."""
    board = body("board", box(40.0, 1.0, friction=2.0), position=(0.0, -0.5), mass=3.0, fixed_rotation=True)
    w = rolling_in(0.05, 6.0, board)
    w.step(30)
    blow = 6.0 * 3.0 / 4.0
    inertia = 0.5 * 0.25
    grip = blow * 0.05 * 0.5 / inertia / (1.0 + 1.0 / 3.0 + 0.25 / inertia)
    ball, board = w.body("ball"), w.body("board")
    assert ball.velocity == pytest.approx((8.0 - grip, -6.0 + blow), abs=5e-3)
    assert board.velocity == pytest.approx((grip / 3.0, -blow / 3.0), abs=5e-3)
    assert ball.angular_velocity == pytest.approx(-16.0 + (blow * 0.05 - grip * 0.5) / inertia, abs=5e-3)


def rolling_in(arm: float, speed: float, below):
    """A disc that rolls at 8 m/s comes down, without gravity, on what is below the origin."""
    ball = circle(0.5, friction=2.0, rolling_resistance=arm)
    way = {"position": (0.0, 0.6), "velocity": (8.0, -speed), "angular_velocity": -16.0, "mass": 1.0}
    return world(below, body("ball", ball, **way), gravity=(0.0, 0.0))


def test_rolling_resistance_brings_a_disc_to_rest_and_holds_it_on_a_gentle_slope():
    angle = 0.5 * math.atan(0.05 / 0.5)
    ball = circle(0.5, friction=1.0, rolling_resistance=0.05)
    w = world(*slope(angle, friction=1.0), on_slope(angle, ball, 0.5))
    w.step(60)
    assert way_down(w, 300, angle) == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("speed", [1.5, -3.0])
def test_a_conveyor_brings_a_crate_to_the_speed_of_the_belt(speed):
    """A belt moves clockwise around its shape: its upper side toward +x."""
    w = world(
        ground(friction=0.5, surface_speed=speed),
        body("crate", box(1.0, 0.5, friction=0.5), position=(0.0, 0.25)),
    )
    w.step(20)
    grip = math.copysign(0.5 * G * 20 / 60, speed)
    expected = grip if abs(grip) < abs(speed) else speed
    assert w.body("crate").velocity[0] == pytest.approx(expected, rel=1e-2)
    w.step(100)
    assert w.body("crate").velocity[0] == pytest.approx(speed, rel=1e-6)


def test_a_crate_with_a_tracked_underside_drives():
    """Clockwise around the crate its underside runs toward -x, so the crate drives toward +x."""
    w = world(ground(friction=0.5), body("tank", box(1.0, 0.5, surface_speed=2.0), position=(0.0, 0.25)))
    w.step(120)
    assert w.body("tank").velocity[0] == pytest.approx(2.0, rel=1e-6)


def test_friction_does_not_let_a_heavy_pusher_through():
    w = world(
        ground(friction=0.5),
        body("pusher", box(0.5, 1.0), type="kinematic", position=(-2.0, 0.6), velocity=(1.0, 0.0)),
        body("crate", box(1.0, 1.0), position=(0.0, 0.5)),
    )
    w.step(300)
    assert w.body("pusher").position[0] == pytest.approx(3.0)
    assert w.body("crate").position[0] == pytest.approx(3.0 + 0.25 + 0.5, abs=0.01)
    assert w.body("crate").velocity[0] == pytest.approx(1.0, abs=1e-2)

"""Wind against closed forms: plates, discs, boxes askew, spinning rods; strong winds throw nothing back."""

from __future__ import annotations

import math

import pytest

from sandbox.scene.flat import FlatRegion, FlatSettings
from tests.fields.pools import G, inside
from tests.flat import body, box, capsule, circle, ground, segment, world

STEP = 1.0 / 60.0


def air(velocity: tuple[float, float] = (0.0, 0.0), density: float = 0.1, **fields: object) -> FlatRegion:
    return FlatRegion("wind", flow=velocity, density=density, drag=2.0, **fields)


def kick(shape, wind, angle=0.0, density=1e-6, **fields):
    """Force and torque of a thin wind on a body, from what one step does to it."""
    made = world(body("it", shape, angle=angle, **fields), regions=(air(wind, density),), gravity=(0.0, 0.0))
    row = made.state.bodies[0].copy()
    made.step()
    now = made.state.bodies[0]
    change = now.velocity_x - row.velocity_x, now.velocity_y - row.velocity_y
    turn = now.angular_velocity - row.angular_velocity
    scale = 1.0 / (STEP * density)
    return float(row.mass * change[0] * scale), float(row.mass * change[1] * scale), float(row.inertia * turn * scale)


def test_a_plate_squarely():
    assert kick(box(0.5, 2.0), (10.0, 0.0)) == pytest.approx((2.0 * 100.0, 0.0, 0.0), rel=1e-4, abs=1e-7)


@pytest.mark.parametrize("angle", [0.1, 0.7, 2.0])
def test_a_box_askew_feels_the_two_faces_that_meet_the_air(angle):
    """Pressure rho u^2 cos^2 on each face, against its normal."""
    x = y = turn = 0.0
    for face, (length, out) in enumerate([(1.0, 1.5), (3.0, 0.5), (1.0, 1.5), (3.0, 0.5)]):
        normal = math.cos(angle + face * math.pi / 2), math.sin(angle + face * math.pi / 2)
        if normal[0] < 0.0:
            force = 100.0 * normal[0] ** 2 * length
            x, y = x - force * normal[0], y - force * normal[1]
            assert out > 0.0
    assert kick(box(3.0, 1.0), (10.0, 0.0), angle) == pytest.approx((x, y, turn), rel=1e-4, abs=1e-3)


def test_a_disc_has_two_thirds_of_a_plate():
    x, y, _ = kick(circle(1.0), (6.0, 8.0))
    assert math.hypot(x, y) == pytest.approx(100.0 * 2.0 * 2.0 / 3.0, rel=1e-4)
    assert (x / y) == pytest.approx(0.75, rel=1e-9)


def test_a_capsule_is_a_plate_and_half_a_disc():
    x, y, turn = kick(capsule(1.0, 0.5), (0.0, 10.0))
    assert y == pytest.approx(100.0 * (2.0 + 2.0 / 3.0), rel=1e-4)
    assert (x, turn) == pytest.approx((0.0, 0.0), abs=1e-6)


def test_a_spinning_rod_is_braked_by_the_cube_of_its_length():
    """A line of half length a: the torque is 2 * integral of rho (w r)^2 r dr = rho w^2 a^4 / 2, without end faces."""
    line = segment((-1.0, 0.0), (1.0, 0.0))
    _, _, turn = kick(line, (0.0, 0.0), mass=1.0, inertia=1.0, angular_velocity=5.0, density=1e-5)
    assert turn == pytest.approx(-25.0 * 0.5, rel=1e-3)


def test_a_disc_does_not_feel_its_own_spin():
    assert kick(circle(1.0), (0.0, 0.0), angular_velocity=9.0) == pytest.approx((0.0, 0.0, 0.0), abs=1e-6)


def test_only_the_faces_in_the_area_are_pressed():
    """A plate half in a jet: half the force, with a lever of a quarter of its height."""
    jet = FlatRegion("wind", inside(-50.0, 0.0, 50.0, 50.0), density=1e-5, drag=2.0, flow=(10.0, 0.0))
    made = world(body("it", box(0.5, 2.0)), regions=(jet,), gravity=(0.0, 0.0))
    made.step()
    row = made.state.bodies[0]
    assert row.velocity_x * row.mass / STEP == pytest.approx(1e-3, rel=1e-4)
    assert row.angular_velocity * row.inertia / STEP == pytest.approx(-0.5e-3, rel=1e-4)


def test_terminal_velocity_of_a_falling_plate():
    """m g = rho v^2 b, whatever the step."""
    made = world(body("it", box(2.0, 0.5), fixed_rotation=True), regions=(air(density=0.1),))
    made.step(1200)
    assert made.state.bodies[0].velocity_y == pytest.approx(-math.sqrt(1.0 * G / (0.1 * 2.0)), rel=1e-9)


def test_quadratic_drag_alone_decays_on_its_exact_way():
    """v' = -c v^2 has v = v0 / (1 + c v0 t)."""
    made = world(body("it", circle(0.5), velocity=(40.0, 0.0)), regions=(air(density=0.1),), gravity=(0.0, 0.0))
    made.step(120)
    c = 0.1 * (2.0 / 3.0) * 1.0 / (math.pi * 0.25)
    assert made.state.bodies[0].velocity_x == pytest.approx(40.0 / (1.0 + c * 40.0 * 2.0), rel=1e-12)


def test_a_storm_takes_a_feather_along_and_does_not_throw_it():
    made = world(
        body("feather", box(1.0, 0.02, density=0.01), angular_velocity=20.0),
        regions=(air((80.0, 30.0), 50.0),),
        gravity=(0.0, 0.0),
    )
    fastest = 0.0
    for _ in range(300):
        made.step()
        row = made.state.bodies[0]
        fastest = max(fastest, math.hypot(row.velocity_x, row.velocity_y))
    assert fastest < 90.0


def test_a_gust_wakes_what_sleeps_in_it_and_nobody_else():
    gust = FlatRegion("wind", inside(-5.0, -5.0, 5.0, 5.0), flow=(30.0, 0.0), density=0.1, drag=2.0, start=3.0, end=4.0)
    made = world(
        ground(), body("in", box(1.0, 1.0), position=(0.0, 0.5)), body("out", box(1.0, 1.0), position=(20.0, 0.5)),
        regions=(gust,), settings=FlatSettings(),
    )  # fmt: skip
    made.step(180)
    assert made.awake_count == 0
    made.step()
    assert made.body("in").awake
    assert not made.body("out").awake
    made.step(120)
    assert made.body("in").position[0] > 1.0
    made.step(120)
    assert made.awake_count == 0


def test_a_steady_wind_lets_sleep_what_it_does_not_move():
    made = world(
        ground(), body("crate", box(1.0, 1.0), position=(0.0, 0.5)), regions=(air((3.0, 0.0)),), settings=FlatSettings()
    )
    made.step(120)
    assert made.awake_count == 0

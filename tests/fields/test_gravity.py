"""Gravity zones, orbits and thrusters against closed forms."""

from __future__ import annotations

import math

import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatRegion, FlatScene, FlatSettings, FlatThruster
from tests.fields.pools import G, inside
from tests.flat import body, box, circle, ground, world


def test_a_zone_replaces_gravity_while_the_centre_is_in_it():
    zone = FlatRegion("gravity", inside(-1.0, -100.0, 1.0, 100.0), gravity=(0.0, -1.62))
    made = world(body("in", circle(0.5)), body("out", circle(0.5), position=(5.0, 0.0)), regions=(zone,))
    made.step(60)
    assert made.body("in").position == pytest.approx((0.0, -0.81), rel=1e-12)
    assert made.body("out").position == pytest.approx((5.0, -0.5 * G), rel=1e-12)


def test_zones_go_in_order_and_heed_the_bodies_gravity_scale():
    regions = FlatRegion("gravity", gravity=(2.0, 0.0)), FlatRegion("gravity_scale", disc=(0.0, 0.0, 9.0), scale=3.0)
    made = world(body("it", circle(0.5), gravity_scale=0.5), regions=regions)
    made.step(30)
    assert made.body("it").position == pytest.approx((0.5 * 3.0 * 0.25, 0.0), rel=1e-12)


@pytest.mark.parametrize("step_rate", [60.0, 120.0])
def test_a_circular_orbit_has_keplers_period(step_rate):
    """2 pi sqrt(r^3 / k) with k = 100, r = 4: 5.0265 s. The leapfrog method is off by (w h)^2 / 24 of it."""
    speed, period = math.sqrt(100.0 / 4.0), 2.0 * math.pi * math.sqrt(64.0 / 100.0)
    made = world(
        body("moon", circle(0.2), position=(4.0, 0.0), velocity=(0.0, speed)),
        regions=(FlatRegion("attraction", strength=100.0),),
        gravity=(0.0, 0.0), settings=FlatSettings(step_rate=step_rate),
    )  # fmt: skip
    turned, last = 0.0, 0.0
    steps = round(20 * period * step_rate)
    for _ in range(steps):
        made.step()
        x, y = (float(value) for value in made.body("moon").position)
        angle = math.atan2(y, x)
        turned += (angle - last + math.pi) % (2.0 * math.pi) - math.pi
        last = angle
    measured = steps / step_rate / (turned / (2.0 * math.pi))
    assert measured == pytest.approx(period, rel=6e-4 * (60.0 / step_rate) ** 2)
    assert math.hypot(x, y) == pytest.approx(4.0, rel=1e-3)


def test_an_eccentric_orbit_keeps_its_energy_over_a_hundred_rounds():
    made = world(
        body("comet", circle(0.1), position=(6.0, 0.0), velocity=(0.0, 2.5)),
        regions=(FlatRegion("attraction", strength=100.0),), gravity=(0.0, 0.0),
    )  # fmt: skip
    row = made.state.bodies[0]

    def energy() -> float:
        return 0.5 * float(row.velocity_x**2 + row.velocity_y**2) - 100.0 / math.hypot(row.center_x, row.center_y)

    start = energy()
    worst = 0.0
    for _ in range(30000):
        made.step()
        worst = max(worst, abs(energy() / start - 1.0))
    assert worst < 0.03
    assert abs(energy() / start - 1.0) < 0.03


@pytest.mark.parametrize("falloff", [0, 1, 2, 3])
def test_attraction_falls_with_its_power_and_ends_at_its_range(falloff):
    region = FlatRegion("attraction", center=(1.0, 1.0), strength=-6.0, falloff=falloff, range=10.0)
    near, far = body("near", circle(0.1), position=(3.0, 1.0)), body("far", circle(0.1), position=(1.0, 12.0))
    made = world(near, far, regions=(region,), gravity=(0.0, 0.0))
    made.step()
    assert made.body("near").velocity == pytest.approx((6.0 / 2.0**falloff / 60.0, 0.0), rel=1e-12)
    assert made.body("far").velocity == pytest.approx((0.0, 0.0), abs=0.0)


def test_within_the_core_attraction_falls_to_nothing():
    region = FlatRegion("attraction", strength=8.0, core=2.0)
    made = world(
        body("it", circle(0.1), position=(0.5, 0.0)), body("mid", circle(0.1)), regions=(region,), gravity=(0, 0)
    )
    made.step()
    assert made.body("it").velocity == pytest.approx((-8.0 / 4.0 * 0.25 / 60.0, 0.0), rel=1e-12)
    assert made.body("mid").velocity == pytest.approx((0.0, 0.0), abs=0.0)


def rocket(*thrusters: FlatThruster, **fields: object) -> World:
    scene = FlatScene(
        (body("rocket", box(1.0, 2.0), thrusters=thrusters, **fields),), (0.0, 0.0), FlatSettings(sleeping=False)
    )
    return World(scene)


def test_a_thruster_pushes_from_its_start_to_its_end():
    made = rocket(FlatThruster((0.0, 6.0), start=0.5, end=1.5))
    made.step(30)
    assert made.body("rocket").velocity == pytest.approx((0.0, 0.0), abs=0.0)
    made.step(90)
    assert made.body("rocket").velocity == pytest.approx((0.0, 3.0), rel=1e-12)
    assert made.body("rocket").position == pytest.approx((0.0, 1.5 + 1.5), rel=1e-12)


def test_a_thruster_turns_with_its_body_and_turns_it():
    made = rocket(FlatThruster((3.0, 0.0), at=(0.0, -1.0)), angle=math.pi / 2)
    made.step()
    row = made.state.bodies[0]
    assert made.body("rocket").velocity == pytest.approx((0.0, 1.5 / 60.0), rel=1e-12, abs=1e-15)
    assert row.angular_velocity == pytest.approx(3.0 / row.inertia / 60.0, rel=1e-12)


def test_a_thruster_wakes_its_sleeping_body_although_the_world_is_still():
    scene = FlatScene((
        ground(),
        body("crate", box(1.0, 1.0), position=(0.0, 0.5), thrusters=(FlatThruster((0.0, 20.0), start=3.0, end=4.0),)),
    ))  # fmt: skip
    made = World(scene)
    made.step(179)
    assert made.awake_count == 0
    made.step(31)
    assert made.body("crate").position[1] > 1.0
    made.step(300)
    assert made.awake_count == 0
    assert made.step_count == 510

"""Floating bodies settle where closed forms say, stand up or fall over as metacentres say, and then sleep."""

from __future__ import annotations

import math

import pytest

from sandbox import ApplyForce
from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatSettings
from tests.fields.pools import G, inside, water
from tests.flat import body, box, circle, polygon, world


def settled(floating: FlatBody, density: float = 1.0, steps: int = 3000, drag: float = 3.0) -> World:
    made = world(floating, regions=(water(density, drag=drag),))
    made.step(steps)
    return made


@pytest.mark.parametrize("share", [0.1, 0.37, 0.5, 0.9])
def test_a_box_floats_at_the_depth_of_its_density(share):
    made = settled(body("raft", box(4.0, 1.0, density=2.5 * share), position=(3.0, 0.4)), density=2.5)
    assert made.body("raft").position == pytest.approx((3.0, 0.5 - share), abs=1e-9)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_a_disc_floats_with_the_circular_segment_of_its_density_under_water(share):
    made = settled(body("ball", circle(0.7, density=share), position=(0.0, 0.3)))
    depth = -float(made.state.bodies[0].center_y)
    half = math.acos(max(-1.0, min(1.0, depth / 0.7)))  # of the arc that is dry
    dry = 0.7**2 * (half - math.sin(half) * math.cos(half))
    assert 1.0 - dry / (math.pi * 0.7**2) == pytest.approx(share, abs=1e-9)


def test_a_rounded_box_floats_where_its_area_under_water_weighs_as_much_as_it():
    made = settled(body("raft", box(3.0, 0.6, radius=0.2, density=0.5), position=(0.0, 0.3)))
    assert made.state.bodies[0].center_y == pytest.approx(0.0, abs=1e-9)


def test_a_wedge_floats_on_its_point():
    """A triangle, point down: the area under water grows with the square of the depth."""
    wedge = polygon((0.0, 0.0), (1.0, 0.5), (-1.0, 0.5), density=0.25)
    made = settled(body("wedge", wedge, position=(0.0, 0.1)))
    assert made.body("wedge").position == pytest.approx((0.0, -0.25), abs=1e-9)


def test_oil_on_water_adds_up():
    """Density 0.9 between water (1) below 0 and oil (0.8) up to 0.2 above: half of it in each."""
    oil = water(0.8, 0.2, drag=3.0)
    oil = type(oil)("water", (*oil.edges, (0.0, -1.0, 0.0)), density=0.8, drag=3.0, angular_drag=3.0)
    made = world(body("raft", box(2.0, 0.2, density=0.9), position=(0.0, 0.1)), regions=(water(drag=3.0), oil))
    made.step(3000)
    assert made.state.bodies[0].center_y == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("stretch", [0.9, 1.1])
def test_a_log_stands_upright_only_if_it_is_wide_enough(share, stretch):
    """A box of width b, height h and relative density s is stable where b^2 > 6 s (1 - s) h^2 (metacentric height)."""
    width = stretch * math.sqrt(6.0 * share * (1.0 - share))
    made = world(
        body("log", box(width, 1.0, density=share), position=(0.0, 0.5 - share), angle=0.01),
        regions=(water(drag=0.5),),
    )
    made.step(1800)
    angle = abs(float(made.body("log").angle))
    assert angle < 1e-3 if stretch > 1.0 else angle > 0.1


def test_a_bobbing_box_keeps_its_period_and_its_height():
    """Without drag it swings as a harmonic oscillator of w^2 = g / draught, and loses and gains nothing."""
    made = world(body("raft", box(4.0, 1.0, density=0.5), position=(0.0, 0.1)), regions=(water(),))
    heights = []
    for _ in range(6000):
        made.step()
        heights.append(float(made.state.bodies[0].center_y))
    period = 2.0 * math.pi / math.sqrt(G / 0.5)
    crossings = [
        k - heights[k] / (heights[k] - heights[k - 1]) for k in range(1, 6000) if heights[k - 1] < 0.0 <= heights[k]
    ]
    measured = (crossings[-1] - crossings[0]) / (len(crossings) - 1) / 60.0
    assert measured == pytest.approx(period, rel=3e-4)
    assert max(heights[-600:]) == pytest.approx(0.1, rel=1e-3)


def test_a_heavy_body_sinks_as_if_it_weighed_less():
    made = world(body("stone", box(0.5, 0.5, density=4.0), position=(0.0, -10.0)), regions=(water(),))
    made.step(60)
    assert made.state.bodies[0].center_y == pytest.approx(-10.0 - 0.5 * G * (1.0 - 0.25), rel=1e-9)


def test_drag_leads_to_the_terminal_velocity_exactly():
    made = world(body("stone", box(0.5, 0.5, density=4.0), position=(0.0, 0.0)), regions=(water(1.0, 900.0, drag=2.0),))
    made.step(3000)
    assert made.state.bodies[0].velocity_y == pytest.approx(-G * (4.0 - 1.0) / 2.0, rel=1e-9)


def test_a_river_carries_what_floats():
    made = world(body("raft", box(2.0, 0.5, density=0.5)), regions=(water(drag=1.0, flow=(1.5, 0.0)),))
    made.step(1200)
    assert made.body("raft").velocity == pytest.approx((1.5, 0.0), abs=1e-4)
    assert made.body("raft").awake


def test_spin_in_water_goes_at_its_rate():
    made = world(
        body("wheel", circle(1.0, density=1.0), position=(0.0, -5.0), angular_velocity=3.0), regions=(water(drag=1.0),)
    )
    made.step(60)
    assert made.state.bodies[0].angular_velocity == pytest.approx(3.0 * math.exp(-1.0), rel=0.01)


def test_what_floats_still_falls_asleep_and_stays():
    made = world(
        body("raft", box(4.0, 1.0, density=0.5), position=(0.0, 0.1)),
        regions=(water(drag=3.0),), settings=FlatSettings(),
    )  # fmt: skip
    made.step(900)
    assert not made.body("raft").awake
    assert made.state.bodies[0].center_y == pytest.approx(0.0, abs=0.002)
    digest = made.digest()
    made.apply(ApplyForce("raft", (0.0, -50.0)))
    assert made.body("raft").awake
    made.step(900)
    assert not made.body("raft").awake
    assert made.digest() != digest


def test_what_sinks_slowly_does_not_fall_asleep():
    made = world(
        body("stone", box(0.5, 0.5, density=1.01), position=(0.0, -1.0)),
        regions=(water(drag=20.0),), settings=FlatSettings(),
    )  # fmt: skip
    made.step(600)
    assert made.body("stone").awake
    assert 0.0 < -made.state.bodies[0].velocity_y < 0.05


def test_only_the_part_in_the_area_is_lifted():
    """A long plank half over a pool: lifted at the middle of its wet half."""
    pool = type(water())("water", inside(-10.0, -5.0, 0.0, 5.0), density=1.0)
    made = world(body("plank", box(4.0, 0.5, density=1.0), position=(0.0, -1.0)), regions=(pool,))
    made.step()
    row = made.state.bodies[0]
    assert row.velocity_y == pytest.approx(-0.5 * G / 60.0, rel=1e-12)
    assert row.angular_velocity == pytest.approx(-(G * 1.0) * 1.0 / row.inertia / 60.0, rel=1e-12)

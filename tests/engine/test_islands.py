"""Sleep and waking, as one sees it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import ApplyForce, SetPose, SetVelocity
from sandbox.scene.flat import FlatSettings
from tests.engine.stages import island_roots
from tests.flat import body, box, circle, ground, world
from tests.naive.islands import islands

SLEEPY = FlatSettings(sleeping=True)


def tower(count: int = 3, *others, **fields):
    """A tower of crates that has fallen asleep."""
    crates = [body(f"{i}", box(1.0, 1.0), position=(0.0, 0.5 + i)) for i in range(count)]
    w = world(ground(), *crates, *others, settings=SLEEPY, **fields)
    w.step(240)
    assert not any(w.body(f"{i}").awake for i in range(count))
    return w


@given(st.integers(1, 12), st.data())
def test_islands_are_what_flood_fill_finds(count, data):
    body_ids = st.integers(0, count - 1)
    links = data.draw(st.lists(st.tuples(body_ids, body_ids), max_size=20))
    active = data.draw(st.lists(st.booleans(), min_size=count, max_size=count))
    links = [(a, b) for a, b in links if a != b]
    assert island_roots(count, links, active) == islands(count, links, active)


def test_a_sleeping_world_does_not_change():
    w = tower()
    before = w.bodies.position.copy(), w.bodies.angle.copy(), len(w.contacts)
    w.step(500)
    assert np.array_equal(w.bodies.position, before[0])
    assert np.array_equal(w.bodies.angle, before[1])
    assert len(w.contacts) == before[2] == 3
    assert (w.bodies.velocity == 0.0).all()


def test_contacts_stay_sorted_while_some_bodies_sleep():
    w = tower(3, body("ball", circle(0.3, restitution=1.0), position=(5.0, 3.0)))
    for _ in range(120):
        w.step()
        keys = list(zip(w.contacts.shape_a.tolist(), w.contacts.shape_b.tolist(), strict=True))
        assert keys == sorted(set(keys))
        assert len(keys) >= 3


def test_a_blow_wakes_the_whole_island_and_no_other():
    far = [body(f"far{i}", box(1.0, 1.0), position=(20.0, 0.5 + i)) for i in range(2)]
    w = tower(3, *far, body("ball", circle(0.3), position=(-8.0, 60.0)))
    w.apply(SetPose("ball", (-3.0, 2.5), 0.0))
    w.apply(SetVelocity("ball", (10.0, 0.0), 0.0))
    w.step(20)
    assert all(w.body(f"{i}").awake for i in range(3))
    assert not any(w.body(f"far{i}").awake for i in range(2))


@pytest.mark.parametrize("gone", ["ground", "0"])
def test_what_loses_its_support_falls(gone):
    w = tower()
    w.apply(SetPose(gone, (50.0, -20.0), 0.0))
    w.step(60)
    assert w.body("2").position[1] < 2.0


def test_a_force_wakes():
    w = tower()
    w.apply(ApplyForce("2", (500.0, 0.0)))
    w.step()
    assert w.body("2").awake
    assert w.body("2").velocity[0] > 0.0


def test_a_platform_that_starts_to_move_wakes_its_rider():
    w = world(
        body("lift", box(4.0, 1.0), type="kinematic", position=(0.0, -0.5)),
        body("crate", box(1.0, 1.0), position=(0.0, 0.5)),
        settings=SLEEPY,
    )
    w.step(200)
    assert not w.body("crate").awake
    w.apply(SetVelocity("lift", (0.0, 1.0), 0.0))
    w.step(60)
    assert w.body("crate").position[1] == pytest.approx(1.5, abs=0.01)


def test_nobody_sleeps_when_sleeping_is_off():
    w = world(ground(), body("crate", box(1.0, 1.0), position=(0.0, 0.5)))
    w.step(600)
    assert w.body("crate").awake
    assert w.state.counters[0].awake_count == 1


def test_sleep_leaves_the_rest_of_the_world_as_it_would_be_without():
    """A ball far from the sleepers takes the same way to the bit, whether they sleep or not."""
    ball = body("ball", circle(0.3, restitution=0.9), position=(30.0, 9.0), velocity=(1.0, 0.0))
    ways = []
    for sleeping in (True, False):
        crates = [body(f"{i}", box(1.0, 1.0), position=(0.0, 0.5 + i)) for i in range(3)]
        w = world(ground(), *crates, ball, settings=FlatSettings(sleeping=sleeping))
        w.step(300)
        ways.append((w.body("ball").position, w.body("0").awake))
    assert ways[0][0] == ways[1][0]
    assert (ways[0][1], ways[1][1]) == (False, True)


def test_a_kinematic_pusher_wakes_what_it_meets():
    w = world(
        ground(),
        body("crate", box(1, 1), position=(0.0, 0.5)),
        body("pusher", box(0.5, 0.5), type="kinematic", position=(-6.0, 0.6), velocity=(1.0, 0.0)),
        settings=SLEEPY,
    )
    w.step(100)
    assert not w.body("crate").awake
    w.step(800)
    assert w.body("crate").position[0] == pytest.approx(w.body("pusher").position[0] + 0.75, abs=0.02)


@pytest.mark.parametrize("kind", ["static", "kinematic"])
def test_a_body_put_into_a_sleeping_one_wakes_it(kind):
    w = world(
        ground(),
        body("crate", box(1, 1), position=(0.0, 0.5)),
        body("wall", box(1, 1), type=kind, position=(0.0, 9.0)),
        settings=SLEEPY,
    )
    w.step(200)
    assert not w.body("crate").awake
    w.apply(SetPose("wall", (0.4, 0.5), 0.0))
    w.step(60)
    assert w.body("crate").position[0] < -0.4


def test_free_flight_is_not_rest():
    w = world(body("a", circle(0.5), velocity=(0.0, 0.04)), gravity=(0.0, -0.01), settings=SLEEPY)
    w.step(600)
    assert w.body("a").position[1] == pytest.approx(0.04 * 10 - 0.5 * 0.01 * 100)
    w = world(body("a", circle(0.5), velocity=(0.02, 0.0)), gravity=(0.0, 0.0), settings=SLEEPY)
    w.step(600)
    assert w.body("a").position[0] == pytest.approx(0.2)


def test_a_slow_conveyor_keeps_carrying():
    w = world(ground(surface_speed=0.03), body("crate", box(1, 1), position=(0.0, 0.5)), settings=SLEEPY)
    w.step(600)
    assert w.body("crate").position[0] == pytest.approx(0.3, rel=0.02)


def test_a_still_world_steps_as_one_that_takes_every_step():
    skipping, stepping = tower(), tower()
    for _ in range(50):
        skipping.step()
        stepping.state.counters["still"][0] = 0
        stepping.step()
        assert skipping.digest() == stepping.digest()
    for w in (skipping, stepping):
        w.apply(ApplyForce("2", (50.0, 0.0)))
        w.step(20)
    assert skipping.digest() == stepping.digest()
    assert skipping.body("2").position[0] > 0.0


def test_a_still_world_takes_many_steps_at_once():
    w = tower()
    w.step(10**9)
    assert w.step_count == 10**9 + 240
    assert w.awake_count == 0


def test_a_driven_body_keeps_the_world_going():
    w = tower(1, body("lift", box(1.0, 1.0), type="kinematic", position=(20.0, 5.0), velocity=(0.0, 0.1)))
    w.step(60)
    assert w.body("lift").position[1] == pytest.approx(5.5)


def test_each_body_says_how_slow_it_has_to_be_to_sleep():
    restless = body("restless", box(1.0, 1.0), position=(3.0, 0.5), sleep_speed=0.0)
    tired = body("tired", box(1.0, 1.0), position=(-3.0, 0.5))
    w = world(ground(), restless, tired, settings=SLEEPY)
    w.step(60)
    assert w.body("restless").awake
    assert not w.body("tired").awake
    assert w.awake_count == 1

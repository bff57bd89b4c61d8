"""Whole scenes in both engines: closed forms as they are measured, and what is carried over to pymunk."""

from __future__ import annotations

import math
from typing import Any

import pytest

import sandbox
from sandbox.reference.measures import Measurer
from sandbox.reference.space import build_space, left_out
from sandbox.reference.twin import simulate_twin
from tests import flat

G = 9.81


def test_the_ruler_measures_by_definition() -> None:
    world = flat.world(
        flat.ground(),
        flat.body("box", flat.box(1, 2, density=3.0), position=(0, 0.9), velocity=(2.0, 0.0), angular_velocity=0.5),
        flat.body("ball", flat.circle(1.0, density=1.0), position=(9, 5)),
        flat.body("lift", flat.box(1, 1), type="kinematic", position=(-9, 50), velocity=(0.0, 1.0)),
    )
    got = Measurer(world.state).measure(world.state.bodies)
    box_inertia = 6.0 * (1.0 + 4.0) / 12.0
    kinetic = 0.5 * 6.0 * 4.0 + 0.5 * box_inertia * 0.25
    assert got.energy == pytest.approx(kinetic + G * (6.0 * 0.9 + math.pi * 5.0), rel=1e-14)
    assert got.penetration == pytest.approx(0.1, rel=1e-12)
    assert got.height == pytest.approx((6.0 * 0.9 + math.pi * 5.0) / (6.0 + math.pi), rel=1e-14)
    assert got.top == 5.0


def test_sleeping_bodies_still_overlap() -> None:
    world = flat.world(flat.ground(), flat.body("a", flat.box(1, 1), position=(0, 0.25)))
    world.state.bodies.awake[:] = 0
    assert Measurer(world.state).measure(world.state.bodies).penetration == pytest.approx(0.25)


def test_a_scene_without_dynamic_bodies_measures_nothing() -> None:
    twin = simulate_twin(flat.scene(flat.ground()), 2)
    assert {(each.energy, each.penetration, each.height, each.top) for each in twin.ours} == {(0.0, 0.0, 0.0, 0.0)}


def test_free_fall_is_the_same_in_both_but_for_the_order_of_the_method() -> None:
    twin = simulate_twin(flat.scene(flat.body("a", flat.box(1, 1), position=(1, 100), angular_velocity=2.0)), 60)
    assert twin.times == pytest.approx([k / 60 for k in range(61)])
    assert twin.ours[-1].height == pytest.approx(100.0 - 0.5 * G, abs=1e-9)
    # pymunk moves a body before it gains speed, so it lags by half a step's fall.
    assert twin.theirs[-1].height == pytest.approx(100.0 - 0.5 * G * (1 - 1 / 60), abs=1e-9)
    assert twin.ours[-1].energy == pytest.approx(twin.ours[0].energy, rel=1e-12)


def test_samples_are_taken_every_so_often_and_at_the_end() -> None:
    scene = flat.scene(flat.body("a", flat.circle(1)))
    assert simulate_twin(scene, 10, every=4).times == pytest.approx([0, 4 / 60, 8 / 60, 10 / 60])
    heard: list[int] = []
    simulate_twin(scene, 40, every=10, on_steps=heard.append)
    assert heard == [0, 16, 32]


def test_a_body_off_its_origin_is_measured_at_its_centre_of_mass() -> None:
    off = flat.body("a", flat.box(1, 1, (2.0, 0.0)), position=(0, 10), angle=math.pi / 2)
    twin = simulate_twin(flat.scene(off, gravity=(0, 0)), 1)
    for side in (twin.ours, twin.theirs):
        assert side[-1].top == pytest.approx(12.0)


def test_gravity_scale_and_damping_are_carried_over() -> None:
    slow = flat.body("a", flat.circle(1), gravity_scale=0.25, linear_damping=0.5, angular_damping=2.0,
                     velocity=(3.0, 0.0), angular_velocity=4.0)  # fmt: skip
    space, (body,) = build_space(flat.scene(slow))
    for _ in range(1000):
        space.step(1e-3)
    assert body.angular_velocity == pytest.approx(4.0 * math.exp(-2.0), rel=1e-9)
    assert body.velocity.x == pytest.approx(3.0 * math.exp(-0.5), rel=1e-9)
    assert body.velocity.y == pytest.approx(-0.25 * G * (1 - math.exp(-0.5)) / 0.5, rel=1e-3)


def test_what_pymunk_does_not_know_is_told() -> None:
    plain = left_out(flat.scene(flat.body("a", flat.circle(1))))
    assert len(plain) == 1
    shape = flat.circle(1, restitution=0.5, rolling_resistance=0.1, surface_speed=1.0, group=3)
    told = " ".join(left_out(flat.scene(flat.body("a", shape))))
    for word in ("restitutions", "rolling", "surface", "groups"):
        assert word in told
        assert word not in plain[0]


def test_joints_hold_and_lifts_go_in_the_twin_as_well() -> None:
    """A pendulum and a crate on a lift; what sprung or ruled things it lacks is told."""
    words: dict[str, Any] = {
        "bodies": [
            {"id": "bob", "position": [2, 9], "shapes": [{"circle": 0.2}]},
            {"id": "lift", "type": "kinematic", "shapes": [{"box": [3, 0.5], "one_way": [0, 1]}], "position": [9, 0],
             "path": {"to": [[0, 3]], "speed": 1}},
            {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [9, 0.75]},
        ],
        "joints": [
            {"id": "pin", "type": "revolute", "bodies": ["bob"], "anchor": [0, 9]},
            {"id": "hand", "type": "target", "bodies": ["crate"], "anchor": [9, 0.75], "max_force": 0.001,
             "target": [9, 0.75]},
        ],
        "regions": [{"water": 1, "inside": [50, 50, 60, 60]}],
    }  # fmt: skip
    twin = simulate_twin(sandbox.Scene(**words), 120, every=30)
    for ours, theirs in zip(twin.ours, twin.theirs, strict=True):
        assert theirs.height == pytest.approx(ours.height, abs=0.15)
        assert theirs.top == pytest.approx(ours.top, abs=0.15)
    assert max(each.height for each in twin.theirs) > min(each.height for each in twin.theirs) + 0.5
    told = " ".join(twin.notes)
    for words_of_it in ("regions are left out", "joints of the kind target are left out", "solid from both sides"):
        assert words_of_it in told

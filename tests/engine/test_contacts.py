"""Contacts of whole scenes: all that touch and no others, mixed surfaces, and what carries over from the last step."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from sandbox.engine.world import World
from tests.engine.stages import Paused
from tests.flat import body, box, circle, ground, world
from tests.naive import convex
from tests.physics.test_momentum import crowd
from tests.physics.test_stacks import falling_pile

WORLDS = {"pile": lambda: falling_pile(0.5, 7), "crowd": lambda: crowd(5)}


def gaps(p: Paused) -> dict[tuple[int, int], float]:
    """Exact gap of every pair of shapes of two bodies, one of them dynamic, that are near each other."""
    s = p.state
    cores = []
    for shape in s.shapes:
        b = s.bodies[shape.body]
        rows = p.scratch.colliders.cores[shape.vertex_start : shape.vertex_start + shape.vertex_count]
        cores.append(convex.exact([(float(r.x), float(r.y)) for r in rows], float(b.center_x), float(b.center_y)))
    found = {}
    for i, j in itertools.combinations(range(len(s.shapes)), 2):
        a, b = s.shapes[i], s.shapes[j]
        body_a, body_b = s.bodies[a.body], s.bodies[b.body]
        if a.body == b.body or body_a.inverse_mass + body_b.inverse_mass == 0.0:
            continue
        way = math.hypot(body_a.center_x - body_b.center_x, body_a.center_y - body_b.center_y)
        if way < 1.5 + (body_a.extent if body_a.extent > 5 else 0) + (body_b.extent if body_b.extent > 5 else 0):
            found[i, j] = convex.separation(cores[i], cores[j]) - float(a.radius + b.radius)
    return found


@pytest.mark.parametrize("name", WORLDS)
@pytest.mark.parametrize("steps", [20, 80])
def test_every_pair_that_touches_has_a_contact(name, steps):
    w = WORLDS[name]()
    w.step(steps)
    p = Paused(w)
    p.detect()
    contacts = {(int(c.shape_a), int(c.shape_b)): c for c in p.scratch.contacts.now[: p.count]}
    truth = gaps(p)
    assert sum(gap < 0.0 for gap in truth.values()) >= 3
    for pair, gap in truth.items():
        if gap < -1e-9:
            assert pair in contacts, (pair, gap)
    for pair, contact in contacts.items():
        deepest = min(contact.separation1, contact.separation2 if contact.point_count == 2 else math.inf)
        assert truth[pair] < 0.5
        assert deepest >= min(truth[pair], 0.0) - 1e-3
        speed = 0.0
        for index in (contact.body_a, contact.body_b):
            b = p.state.bodies[index]
            speed += math.hypot(b.velocity_x, b.velocity_y) + abs(b.angular_velocity) * min(b.extent, 2.0)
        assert truth[pair] <= 0.02 + speed * p.seconds + 1e-9, "nothing far away"


@pytest.mark.parametrize("name", WORLDS)
def test_contacts_are_sorted_and_consistent(name):
    w = WORLDS[name]()
    for _ in range(60):
        w.step()
        keys = list(zip(w.contacts.shape_a.tolist(), w.contacts.shape_b.tolist(), strict=True))
        assert keys == sorted(set(keys))
        assert all(a < b for a, b in keys)
    p = Paused(w)
    p.detect()
    for c in p.scratch.contacts.now[: p.count]:
        a, b = p.state.bodies[c.body_a], p.state.bodies[c.body_b]
        assert math.hypot(c.normal_x, c.normal_y) == pytest.approx(1.0, abs=1e-12)
        velocity = np.array([b.velocity_x - a.velocity_x, b.velocity_y - a.velocity_y])
        for k in range(1, int(c.point_count) + 1):
            on_a = np.array([a.center_x + c[f"anchor_ax{k}"], a.center_y + c[f"anchor_ay{k}"]])
            on_b = np.array([b.center_x + c[f"anchor_bx{k}"], b.center_y + c[f"anchor_by{k}"]])
            # One and the same place once the bodies have moved to where they touch; now, for those that touch.
            apart = np.hypot(*(on_b - on_a))
            assert apart <= 1e-12 + p.seconds * np.hypot(*velocity) * (2.0 if c.separation1 > 0.0 else 1e-9)


def test_surfaces_are_mixed():
    one = {"friction": 0.9, "restitution": 0.2, "rolling_resistance": 0.01, "surface_speed": 1.0}
    two = {"friction": 0.4, "restitution": 0.6, "rolling_resistance": 0.03, "surface_speed": -0.25}
    w = world(ground(**one), body("a", circle(0.5, **two), position=(0.0, 0.5)))
    w.step()
    (contact,) = w.contacts
    assert contact.friction == pytest.approx(math.sqrt(0.36))
    assert (contact.restitution, contact.rolling_resistance, contact.surface_speed) == (0.6, 0.03, 0.75)


def test_impulses_carry_over_by_feature():
    w = World(falling_pile(0.5, 2).scene)
    w.step(80)
    p = Paused(w)
    old = {}
    for number, c in enumerate(w.contacts):
        c.rolling_impulse = 1000.0 + number
        if number % 2 and c.point_count == 2:
            # The points may come in the other order when the reference face has changed.
            c.feature1, c.feature2 = int(c.feature2), int(c.feature1)
        for k in range(1, int(c.point_count) + 1):
            c[f"normal_impulse{k}"], c[f"tangent_impulse{k}"] = 10.0 * number + k, -10.0 * number - k
            old[int(c.shape_a), int(c.shape_b), int(c[f"feature{k}"])] = 10.0 * number + k
        old[int(c.shape_a), int(c.shape_b)] = 1000.0 + number
    p.detect()
    carried = 0
    for c in p.scratch.contacts.now[: p.count]:
        pair = int(c.shape_a), int(c.shape_b)
        assert c.rolling_impulse == old.get(pair, 0.0)
        for k in range(1, int(c.point_count) + 1):
            expected = old.get((*pair, int(c[f"feature{k}"])), 0.0)
            assert (c[f"normal_impulse{k}"], c[f"tangent_impulse{k}"]) == (expected, -expected)
            carried += expected != 0.0
    assert carried > 20


def test_filters_and_shapes_of_one_body():
    w = world(
        ground(category=4),
        body("a", circle(0.5), circle(0.5, at=(0.2, 0.0)), position=(0.0, 0.4)),
        body("ghost", circle(0.5, mask=2), position=(0.3, 0.4)),
        body("twin 1", circle(0.5, group=-1), position=(5.0, 0.4)),
        body("twin 2", circle(0.5, group=-1), position=(5.3, 0.4)),
        body("friend 1", circle(0.5, group=2, mask=0), position=(9.0, 5.0)),
        body("friend 2", circle(0.5, group=2, mask=0), position=(9.3, 5.0)),
    )
    w.step()
    pairs = {(w.names[c.body_a], w.names[c.body_b]) for c in w.contacts}
    assert pairs == {("ground", "a"), ("ground", "twin 1"), ("ground", "twin 2"), ("friend 1", "friend 2")}


def test_static_and_kinematic_bodies_do_not_touch_each_other():
    w = world(ground(), body("lift", box(1.0, 1.0), type="kinematic"), body("wall", box(1.0, 1.0), type="static"))
    w.step()
    assert len(w.contacts) == 0


def test_a_world_that_needs_more_room_gets_it():
    bodies = [body(f"{i}", circle(0.5), position=(0.01 * (i % 9), 0.01 * (i // 9))) for i in range(60)]
    w = world(*bodies, gravity=(0.0, 0.0))
    w.step()
    assert len(w.contacts) == 60 * 59 // 2
    assert np.isfinite(w.bodies.position).all()

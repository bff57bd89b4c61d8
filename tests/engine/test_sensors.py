"""Sensors against the exact test of shapes, pair by pair, and against the same world without them."""

from __future__ import annotations

import random

import pytest

import sandbox
from sandbox import SetPose
from tests.flat import body, box, capsule, circle, ground, polygon, scene, world


def crowd(seed: int, **sensor):
    """Bodies of all kinds that tumble through sensors that stand, drift, and ride on another body."""
    roll = random.Random(seed)
    shapes = [circle(0.4), box(0.8, 0.5), capsule(0.4, 0.2), polygon((0.0, 0.0), (0.9, 0.1), (0.3, 0.8))]
    tumblers = [
        body(f"it-{k}", roll.choice(shapes), position=(roll.uniform(-4, 4), roll.uniform(1, 12)),
             angle=roll.uniform(0, 6), velocity=(roll.uniform(-3, 3), 0.0))
        for k in range(25)
    ]  # fmt: skip
    rider = body("rider", box(1.0, 1.0), *([circle(1.5, **sensor)] if sensor else []), position=(0.0, 14.0))
    gates = [
        body("gate", box(3.0, 1.0, (0.0, 2.0), **sensor), type="static"),
        body("drifter", polygon((0.0, 0.0), (3.0, 0.0), (1.0, 2.0), **sensor), type="kinematic", velocity=(-0.7, 0.3),
             position=(2.0, 1.0), angular_velocity=0.5),
    ] if sensor else []  # fmt: skip
    return [ground(), *tumblers, rider, *gates]


def truth(w):
    """(sensor's body, other body) by the exact test over all pairs of shapes."""
    found = set()
    for a in w.flat.bodies:
        for i, sensor in enumerate(a.shapes):
            for b in w.flat.bodies:
                solid = [k for k, shape in enumerate(b.shapes) if not shape.sensor]
                if sensor.sensor and a.id != b.id and {a.type, b.type} != {"static"}:
                    mine = w.body(a.id).shapes[i]
                    if any(sandbox.collide(mine, w.body(b.id).shapes[k]) for k in solid):
                        found.add((a.id, b.id))
    return found


@pytest.mark.parametrize("seed", range(4))
def test_sensors_feel_what_overlaps_them(seed):
    w = world(*crowd(seed, sensor=True))
    inside, turns = set(), 0
    for _ in range(120):
        w.step()
        now = set(w.sensed)
        if w.step_count % 5 == 0:
            assert now == truth(w)
        names = w.names
        entered = {(names[row.sensor_body], names[row.body]) for row in w.events.enter}
        left = {(names[row.sensor_body], names[row.body]) for row in w.events.leave}
        assert (entered, left) == (now - inside, inside - now)
        turns += len(entered) + len(left)
        inside = now
    assert turns > 10


@pytest.mark.parametrize("seed", range(2))
def test_sensors_push_nothing_and_weigh_nothing(seed):
    felt, free = world(*crowd(seed, sensor=True)), world(*crowd(seed))
    for _ in range(120):
        felt.step()
        free.step()
        for name in free.names:
            assert felt.body(name).position == free.body(name).position
            assert felt.body(name).angle == free.body(name).angle
    assert felt.state.bodies.mass[: len(free.names)].tolist() == free.state.bodies.mass.tolist()


def test_filters_hold_for_sensors():
    gate = body("gate", box(2.0, 2.0, sensor=True, mask=2), type="static")
    w = world(gate, body("seen", circle(0.5, category=2)), body("other", circle(0.5)), gravity=(0.0, 0.0))
    w.step()
    assert w.sensed == (("gate", "seen"),)


def test_sensors_do_not_feel_sensors_nor_their_own_body():
    both = body("both", circle(0.5), circle(2.0, sensor=True))
    w = world(both, body("gate", box(2.0, 2.0, sensor=True), type="static"), gravity=(0.0, 0.0))
    w.step()
    assert w.sensed == (("gate", "both"),)


def test_a_body_lifted_out_leaves_and_one_asleep_stays():
    gate = body("gate", box(4.0, 4.0, sensor=True), type="static")
    flat = scene(
        ground(), gate, body("crate", box(1.0, 1.0), position=(0.0, 0.5)), settings=sandbox.scene.FlatSettings()
    )
    w = sandbox.World(flat)
    w.step(100)
    assert not w.body("crate").awake
    assert w.sensed == (("gate", "crate"),)
    w.apply(SetPose("crate", (0.0, 50.0), 0.0))
    w.step()
    assert w.sensed == ()
    assert [event["event"] for event in w.events if "sensor" in event] == ["leave"]


def test_a_restore_knows_what_is_inside():
    gate = body("gate", box(4.0, 4.0, sensor=True), type="static")
    w = world(gate, body("ball", circle(0.5), position=(0.0, 5.0)))
    start = w.snapshot()
    w.step(60)
    within = w.snapshot()
    w.restore(start)
    assert w.sensed == ()
    w.restore(within)
    assert w.sensed == (("gate", "ball"),)
    w.step()
    assert len(w.events.enter) == 0


def test_rays_pass_through_sensors_unless_asked_to_see_them():
    gate = body("gate", box(2.0, 2.0, sensor=True), type="static")
    w = world(gate, body("wall", box(1.0, 9.0), type="static", position=(5.0, 0.0)))
    hit = w.query.ray((-5.0, 0.0), (20.0, 0.0))
    assert hit is not None
    assert hit.body == "wall"
    seen = w.query.ray((-5.0, 0.0), (20.0, 0.0), sandbox.Filter(sensors=True))
    assert seen is not None
    assert seen.body == "gate"


def test_a_body_of_sensors_alone_has_no_mass():
    text = '{"format": 1, "bodies": [{"id": "ghost", "shapes": [{"circle": 1, "sensor": true}]}]}'
    with pytest.raises(sandbox.SceneError, match="without mass"):
        sandbox.scene.loads_scene(text)


def test_worlds_without_sensors_sense_nothing():
    assert world(ground()).sensed == ()

"""Events against momentum, and against what the tables of every step say when they are compared one by one."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sandbox
from sandbox import BreakJoint, SetPose, SetVelocity
from sandbox.engine.events.events import HIT_SPEED, KINDS
from sandbox.scene import loads_scene
from sandbox.scene.flat import FlatSettings
from sandbox.world.records import DYNAMIC
from tests.determinism.busy import STEPS, digests
from tests.determinism.busy import scene as busy_scene
from tests.flat import body, box, circle, ground, scene, world

SLEEPY = FlatSettings()
G, DT = 9.81, 1 / 60


@pytest.mark.parametrize("restitution", [0.0, 0.4, 1.0])
@pytest.mark.parametrize("shape", [circle(0.5), box(1.0, 0.6), box(1.0, 0.6, (0.1, 0.2))], ids=["ball", "box", "odd"])
def test_the_impulse_of_a_contact_is_the_change_of_momentum(shape, restitution):
    """Over one step: sum of the impulses = m (v1 - v0 + g dt). A flat fall, so that all impulses point upwards."""
    shape = type(shape)(**{**vars(shape), "restitution": restitution, "friction": 0.0})
    w = world(ground(), body("it", shape, position=(0.0, 3.0)))
    mass = float(w.state.bodies[1].mass)
    for _ in range(200):
        before = float(w.bodies.velocity[1][1])
        w.step()
        gained = mass * (float(w.bodies.velocity[1][1]) - before + G * DT)
        assert sum(w.contact_impulses) == pytest.approx(gained, rel=1e-9, abs=1e-9)


def test_a_fall_begins_hits_and_stays():
    w = world(ground(), body("ball", circle(0.5), position=(0.0, 2.0)))
    told = []
    for _ in range(120):
        w.step()
        told += list(w.events)
    assert [(event["event"], event["a"], event["b"]) for event in told] == [
        ("begin", "ground", "ball"), ("hit", "ground", "ball"),
    ]  # fmt: skip
    hit = told[1]
    fallen = math.sqrt(2.0 * G * 1.5)
    assert fallen - G * DT <= hit["speed"] <= fallen
    assert hit["normal"] == [0.0, 1.0]
    assert hit["point"] == pytest.approx([0.0, 0.0], abs=2e-3)


def test_a_soft_landing_is_no_hit():
    w = world(ground(), body("ball", circle(0.5), position=(0.0, 0.5 + 0.4 * HIT_SPEED**2 / (2 * G))))
    kinds = []
    for _ in range(60):
        w.step()
        kinds += [event["event"] for event in w.events]
    assert kinds == ["begin"]


def test_a_corner_that_lands_later_hits_too():
    w = world(ground(), body("plank", box(2.0, 0.1), position=(0.0, 3.0), angle=0.5))
    hits = []
    for _ in range(120):
        w.step()
        hits += [(event["step"], event["point"][0]) for event in w.events if event["event"] == "hit"]
    assert len(hits) >= 2
    assert hits[0][1] < 0.0 < hits[1][1]


def _touching(w):
    return {(int(c.shape_a), int(c.shape_b)) for c in w.contacts if c.touching}


def _asleep(w):
    bodies = w.state.bodies
    return {i for i in range(len(bodies)) if bodies[i].type == DYNAMIC and not bodies[i].awake}


def test_events_are_the_differences_of_the_steps():
    w = world(*busy_scene().bodies, settings=SLEEPY)
    touching, asleep = _touching(w), _asleep(w)
    seen = dict.fromkeys(KINDS, 0)
    for step in range(400):
        if step == 250:
            w.apply(SetVelocity(w.names[-1], (3.0, 6.0), 1.0))
        w.step()
        events, now, sleepers = w.events, _touching(w), _asleep(w)
        pairs = {kind: list(zip(*(getattr(events, kind)[f"shape_{s}"].tolist() for s in "ab"), strict=True))
                 for kind in ("begin", "end")}  # fmt: skip
        assert pairs == {"begin": sorted(now - touching), "end": sorted(touching - now)}
        assert events.sleep.tolist() == sorted(sleepers - asleep)
        assert events.wake.tolist() == sorted(asleep - sleepers)
        assert len(events) == len(list(events)) == sum(events.counts.values())
        assert events.step == w.step_count
        seen = {kind: count + events.counts[kind] for kind, count in seen.items()}
        touching, asleep = now, sleepers
    assert min(seen[kind] for kind in ("begin", "end", "hit", "sleep")) > 0


def test_who_sleeps_still_touches():
    w = world(ground(), body("crate", box(1.0, 1.0), position=(0.0, 0.5)), settings=SLEEPY)
    told = []
    for _ in range(90):
        w.step()
        told += [event["event"] for event in w.events]
    assert told == ["begin", "sleep"]
    w.step(1000)
    assert len(w.events) == 0
    assert w.contacts.touching.tolist() == [1]
    w.apply(SetPose("crate", (0.0, 5.0), 0.0))
    w.step()
    assert [event["event"] for event in w.events] == ["end", "wake"]


def test_asking_changes_nothing():
    asked, silent = world(*busy_scene().bodies), world(*busy_scene().bodies)
    for step in range(STEPS):
        digests(silent, step, step + 1)
        digests(asked, step, step + 1)
        assert list(asked.events) == list(asked.events)
        assert asked.snapshot() == silent.snapshot()


def test_events_are_values():
    w = world(ground(), body("ball", circle(0.5), position=(0.0, 0.52)))
    while not len(w.events):
        w.step()
    kept, told = w.events, list(w.events)
    w.step(30)
    assert list(kept) == told


def test_a_restore_is_no_event():
    w = world(ground(), body("ball", circle(0.5), position=(0.0, 0.505)))
    start = w.snapshot()
    w.step(20)
    later = w.snapshot()
    w.restore(start)
    assert len(w.events) == 0
    w.restore(later)
    w.step()
    assert w.events.counts["begin"] == 0
    w.restore(start)
    first = []
    for _ in range(20):
        w.step()
        first += list(w.events)
    assert [event["event"] for event in first] == ["begin"]


def test_a_frozen_body_is_told_once():
    w = world(body("lost", circle(0.5), velocity=(9e5, 0.0), position=(9.99e8, 0.0)), gravity=(0.0, 0.0))
    told = []
    for _ in range(60 * 60):
        w.step()
        told += w.events.freeze.tolist()
        if w.frozen:
            break
    assert told == [0]


def test_no_events_before_the_first_step():
    assert not np.any(list(world(ground()).events.counts.values()))
    assert scene(ground()).bodies


def test_a_joint_that_breaks_is_told_once():
    text = """{"format": 1,
      "bodies": [{"id": "lamp", "position": [0, -1], "shapes": [{"circle": 0.3}]},
                 {"id": "bell", "position": [5, -1], "shapes": [{"circle": 0.3}]}],
      "joints": [
        {"id": "thread", "type": "distance", "bodies": ["lamp"], "anchors": [[0, -1], [0, 0]], "break_force": 1},
        {"id": "rope", "type": "distance", "bodies": ["bell"], "anchors": [[5, -1], [5, 0]]}
      ]}"""
    w = sandbox.World(loads_scene(text))
    told = []
    for step in range(30):
        if step == 20:
            w.apply(BreakJoint("rope"))
        w.step()
        told += list(w.events)
    assert [(event["event"], event["joint"]) for event in told] == [("joint_break", "thread"), ("joint_break", "rope")]
    assert told[1]["step"] == 21
    assert w.joint("thread").broken_step == told[0]["step"] - 1


def test_what_is_put_elsewhere_afterwards_struck_where_it_was():
    told = []
    for late in (False, True):
        w = world(ground(), body("ball", circle(0.5), position=(0.0, 0.8)))
        w.step(15)
        if not late:
            told = list(w.events)
        for x in (3.0, 40.0):
            w.apply(SetPose("ground", (x, -9.0), 0.3))
            w.apply(SetPose("ball", (x, 9.0), 0.3))
        assert list(w.events) == told
    assert "hit" in {event["event"] for event in told}
    w.step()
    assert w.events.end[0].x == pytest.approx(40.0, abs=3.0)


def test_a_step_in_which_all_sleep_is_told_of_as_it_was_whoever_comes_afterwards():
    w = world(ground(), body("ball", circle(0.5), position=(0.0, 0.5)), settings=FlatSettings(sleeping=True))
    w.step(120)
    assert w.awake_count == 0
    w.spawn({"id": "late", "shapes": [{"circle": 0.5}], "position": [5, 5]})
    told = w.events
    assert (told.step, told.names, len(told)) == (w.step_count, ("ground", "ball"), 0)
    w.step()
    assert w.events.step == told.step + 1
    assert w.events.names == ("ground", "ball", "late")

"""What comes, goes and wakes costs what comes, goes and wakes: counted work, and the same as by a look at all."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import ApplyImpulse, Delete, DeleteJoint, SetPose, Spawn
from sandbox.engine.active.bearable_mass import WITH_GONE
from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.events.event_log import _put_back
from sandbox.engine.narrow_phase.kept_runs import rows_in_doubt
from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings
from sandbox.tables import plain
from sandbox.world.contact_rows import contacts_of
from sandbox.world.joined import Joined
from sandbox.world.joint_records import JOINT
from sandbox.world.records import DYNAMIC
from tests.examples import examples
from tests.flat import body, box, circle, ground, scene

BALL = {"id": "ball", "shapes": [{"circle": 0.3}], "position": [0, 20]}


def sleepers(stacks: int) -> World:
    """Stacks of two boxes, each on a tile of its own, all asleep."""
    tiles = [body(f"tile{k}", box(2.0, 1.0), type="static", position=(3.0 * k, -0.5)) for k in range(stacks)]
    boxes = [
        body(f"box{k}.{n}", box(0.8, 0.8), position=(3.0 * k, 0.4 + 0.8 * n)) for k in range(stacks) for n in range(2)
    ]
    w = World(scene(*tiles, *boxes, settings=FlatSettings(sleeping=True)))
    w.step(150)
    assert w.awake_count == 0
    return w


def by_looking(w: World, rows: list[int]) -> list[int]:
    return [k for k, contact in enumerate(w.contacts) if contact.body_a in rows or contact.body_b in rows]


@pytest.mark.parametrize("stacks", [10, 80])
def test_contacts_of_a_sleeper_are_in_lists(stacks):
    w = sleepers(stacks)
    for row in range(len(w.names)):
        found = w.state.resting.contacts_of(w.state.contacts, len(w.contacts), np.array([row]))
        assert found.tolist() == by_looking(w, [row])


def test_those_of_a_sleeper_and_one_who_moves_are_listed():
    w = sleepers(20)
    w.apply(ApplyImpulse("box7.1", (0.5, 0.0)))
    w.step(3)
    assert w.awake_count == 2
    rows = [w.directory.body(name) for name in ("box7.1", "box8.0", "tile7")]
    found = w.state.resting.contacts_of(w.state.contacts, len(w.contacts), np.array(rows))
    assert found.tolist() == by_looking(w, rows)


@pytest.mark.parametrize("stacks", [10, 80])
def test_what_comes_and_goes_behind_sleepers_gives_them_no_new_numbers(stacks):
    w = sleepers(stacks)
    numbers = []
    for _ in range(5):
        w.apply(Spawn(BALL))
        w.step(2)
        w.apply(Delete("ball"))
        w.step(2)
        numbers.append(int(w.scratch.contacts.cursor[0].next))
    assert numbers == [2 * stacks] * 5
    w.apply(Delete(f"box{stacks - 1}.1"))  # the last row: the box below wakes, and its contact is another one
    w.step(100)
    w.apply(Spawn(BALL))  # where all sleep, nobody looks
    w.step()
    assert int(w.scratch.contacts.cursor[0].next) == 2 * stacks + 1
    assert w.scratch.contacts.cursor[0].era0 == w.scratch.contacts.cursor[0].era1 == w.scratch.active.info[0].era


def test_events_look_at_what_the_runs_do_not_vouch_for():
    w = sleepers(40)
    w.apply(ApplyImpulse("box7.1", (0.5, 0.0)))
    w.step(2)
    counter = w.state.counters[0]
    counts = int(counter.old_contact_count), int(counter.contact_count)
    old, now = rows_in_doubt(w.scratch.active, w.scratch.contacts, *counts)
    rows = [w.directory.body(f"box7.{n}") for n in range(2)]
    assert now.tolist() == by_looking(w, rows)
    assert len(old) == 2 < counts[0]


def test_who_goes_leaves_the_others_weighed_where_masses_do_not_differ():
    w = sleepers(10)
    w.apply(Spawn(BALL))
    w.step()
    w.apply(Delete("ball"))
    w.step()
    assert w.scratch.active.info[0].weighed == WITH_GONE
    w.apply(Spawn({**BALL, "shapes": [{"circle": 0.3, "density": 1e5}]}))
    w.step()
    assert w.scratch.active.info[0].weighed == 1  # now they do
    w.apply(Delete("ball"))
    w.step()
    info = w.scratch.active.info[0]
    assert (info.weighed, info.heaviest) == (1, w.state.bodies.mass[-1])


def test_commands_in_one_frame_find_what_those_before_have_left():
    w = sleepers(12)
    w.apply(Delete("box11.1"))
    w.apply(Spawn(BALL))
    w.apply(Delete("box11.0"))
    w.apply(SetPose("box3.1", (9.0, 5.0), 0.0))
    count = len(w.contacts)
    for row in range(len(w.names)):
        found = contacts_of(w.state.contacts, count, np.array([row]), w.state.resting)
        assert found.tolist() == by_looking(w, [row])
    asleep = {
        name for name, body in zip(w.names, w.state.bodies, strict=True) if body.type == DYNAMIC and not body.awake
    }
    woken = wake_bodies(w.state, [w.directory.body("box5.1")])
    assert {w.names[row] for row in woken} == {"box5.0", "box5.1"} < asleep


def test_names_of_events_are_those_of_the_step_whoever_goes_before_they_are_asked():
    w = World(scene(ground(), *(body(f"b{k}", circle(0.3), position=(2.0 * k, 0.3)) for k in range(6))))
    w.step(2)
    names = w.names
    w.apply(Delete(["b1", "b4"]))
    w.apply(Spawn(BALL))
    w.apply(Delete(["b0", "ball"]))
    assert w.events.names == names
    w.step()
    assert w.events.names == (*w.names, "b1", "b4", "b0")  # whose contacts have ended
    assert [event["a"] for event in w.events if event["event"] == "end"] == ["ground"] * 3


@given(st.lists(st.text(max_size=2), max_size=12), st.data())
@examples(50)
def test_names_come_back_to_their_rows(names, data):
    rows = sorted(data.draw(st.sets(st.integers(0, len(names) - 1)) if names else st.just(set())))
    left = [name for row, name in enumerate(names) if row not in rows]
    assert _put_back(left, rows, [names[row] for row in rows]) == names


joint_lists = st.lists(st.tuples(st.integers(-1, 8), st.integers(0, 8)), max_size=12)


def table_of(pairs):
    table = JOINT.zeros(len(pairs))
    for row, (a, b) in zip(table, pairs, strict=True):
        row.body_a, row.body_b = a, b
    return table


@given(joint_lists, joint_lists, st.integers(0, 9), st.integers(0, 12), st.lists(st.integers(0, 8), min_size=1))
@examples(60)
def test_who_is_joined_to_whom(pairs, more, first_body, first_joint, rows):
    rows = np.unique(rows)
    table = table_of(pairs + more)
    known = Joined.of(table_of(pairs))
    expected = sorted(two for a, b in pairs + more for one, two in ((a, b), (b, a)) if one in rows)
    assert sorted(known.others_of(rows, table).tolist()) == expected
    before = known.before(first_body, first_joint)
    assert before.joints <= first_joint
    assert all(max(pair) < first_body for pair in pairs[: before.joints])
    assert sorted(before.others_of(rows, table).tolist()) == expected


def test_a_joint_goes_and_what_it_held_wakes():
    boxes = [body(f"b{k}", box(0.8, 0.8), position=(2.0 * k, 0.4)) for k in range(6)]
    w = World(scene(ground(), *boxes, settings=FlatSettings(sleeping=True)))
    for k in range(0, 6, 2):
        ids = [f"b{k}", f"b{k + 1}"]
        w.spawn(joints=[{"id": f"j{k}", "type": "revolute", "bodies": ids, "anchor": [2.0 * k + 1.0, 0.4]}])
    w.step(150)
    assert w.awake_count == 0
    w.apply(ApplyImpulse("b2", (0.0, 0.0)))
    assert {w.names[row] for row in np.flatnonzero(plain(w.state.bodies)["awake"])} == {"ground", "b2", "b3"}
    w.apply(DeleteJoint("j4"))
    assert {w.names[row] for row in np.flatnonzero(plain(w.state.bodies)["awake"])} >= {"b2", "b3", "b4", "b5"}
    assert w.state.bodies.awake[w.directory.body("b0")] == 0


@pytest.mark.parametrize("steps", [0, 20])
def test_who_goes_after_a_restore_is_found_in_what_was_restored(steps):
    """What the last step has listed is of another state."""
    w, fresh = sleepers(3), World(sleepers(3).scene)
    fresh.step(steps)
    w.restore(fresh.snapshot())
    for each in (w, fresh):
        each.apply(Delete("box1.1"))
        each.step(30)
    assert w.digest() == fresh.digest()

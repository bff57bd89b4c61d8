"""What rests costs nothing: lists, grid and contacts of sleepers are kept, and never change a bit of what happens."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import ApplyImpulse, Delete, MoveDrag, SetGravity, SetPose, SetSurface, SetVelocity, StartDrag
from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.scene.flat import FlatScene, FlatSettings
from tests.examples import examples
from tests.flat import body, box, circle, ground, scene

STACKS = 14


def town(sleeping: bool = True) -> FlatScene:
    """Stacks that will sleep, on tiles, with a pusher, a spinner in the air and a ball in free_motion."""
    tiles = [
        body(f"tile{i}", box(2.0, 1.0), type="static", position=(2.0 * i - 40.0, -0.5 - 0.5 * (i % 3 == 0)))
        for i in range(70)
    ]
    stacks = [
        body(f"crate{i}.{k}", box(0.8, 0.8, restitution=0.1 * (i % 3)), position=(2.0 * i - 13.0, 0.41 + 0.81 * k))
        for i in range(STACKS)
        for k in range(1 + i % 3)
    ]
    return scene(
        *tiles,
        *stacks[: len(stacks) // 2],
        body("pusher", box(0.5, 0.5), type="kinematic", position=(-15.0, 0.6)),
        body("spinner", box(1.0, 0.2), position=(0.0, 9.0), gravity_scale=0.0, angular_velocity=3.0),
        *stacks[len(stacks) // 2 :],
        ground(),
        body("ball", circle(0.3), position=(1.0, 5.0), velocity=(2.0, 0.0)),
        settings=FlatSettings(sleeping=sleeping),
    )


crates = st.builds("crate{}.{}".format, st.integers(0, STACKS - 1), st.just(0))
anybody = st.sampled_from(["ball", "spinner", "pusher", "tile5", "tile6"]) | crates
places = st.tuples(st.floats(-14, 14), st.floats(0, 4))
speeds = st.tuples(st.floats(-20, 20), st.floats(-20, 20))
commands = st.one_of(
    st.builds(SetPose, anybody, places, st.floats(-1, 1)),
    st.builds(SetVelocity, anybody, speeds, st.floats(-5, 5)),
    st.builds(ApplyImpulse, anybody, speeds, st.floats(-1, 1)),
    st.builds(SetSurface, anybody, st.floats(0, 1)),
    st.builds(SetGravity, st.tuples(st.floats(-1, 1), st.floats(-12, 0))),
    st.builds(Delete, anybody),
)
sequences = st.lists(st.tuples(st.integers(1, 60), commands), max_size=8)


def events(world: World) -> list[Any]:
    """All events of the last step as plain data."""
    return list(world.events)


def tell(worlds: list[World], command: Any) -> None:
    """Apply a command to all, or to none."""
    try:
        for each in worlds:
            each.apply(command)
    except SandboxError:
        assert len({each.digest() for each in worlds}) == 1


@given(sequences)
@examples(25)
def test_what_is_kept_is_what_would_be_found(sequence):
    kept, anew = World(town()), World(town())
    worlds = [kept, anew]
    for each in worlds:
        each.step(90)
    for steps, command in [*sequence, (40, SetVelocity("pusher", (3.0, 0.0), 0.0))]:
        anew._stepper.forget()  # what it touches is found by a look at all contacts and bodies
        tell(worlds, command)
        for _ in range(steps):
            anew._stepper.forget()
            for each in worlds:
                each.step()
            assert events(kept) == events(anew)
        assert kept.digest() == anew.digest()  # a bit that differs once does so for ever


def test_most_of_the_town_sleeps_and_one_shape_is_bounded():
    w = World(town())
    w.step(400)
    active_set, counts = w.scratch.active.info[0], w.state.counters[0]
    assert w.awake_count == 1  # the spinner
    assert active_set.moving == 1
    assert active_set.generation > active_set.anew == 1  # who fell asleep changed nothing for those
    assert w.scratch.contacts.active.contact[0] == 0
    assert counts.contact_count > STACKS
    cursor = w.scratch.contacts.cursor[0]
    before = cursor.generation0, cursor.generation1
    w.step(10)
    assert (cursor.generation0, cursor.generation1) == before == (active_set.generation, active_set.generation)


def test_who_is_awake_is_dragged_without_a_new_active_set():
    kept, anew = World(town()), World(town())
    for each in (kept, anew):
        each.step(400)
        each.apply(StartDrag("spinner", (0.2, 9.0)))
    kept.step(1)
    anew.step(1)
    generation = int(kept.scratch.active.info[0].generation)
    for k in range(30):
        tell([kept, anew], MoveDrag("spinner", (0.1 * k, 9.0)))
        tell([kept, anew], ApplyImpulse("spinner", (0.0, 0.1), 0.0))
        anew._stepper.forget()
        kept.step(1)
        anew.step(1)
        assert kept.digest() == anew.digest()
    assert kept.scratch.active.info[0].generation == generation


@pytest.mark.parametrize("name", ["crate3.0", "tile20", "ball"])
def test_a_snapshot_in_the_middle_changes_nothing(name):
    w = World(town())
    w.step(300)
    saved = w.snapshot()
    w.apply(SetPose(name, (0.0, 3.0), 0.5))
    w.step(50)
    digest = w.digest()
    w.restore(saved)
    w.step(7)
    w.restore(saved)
    w.apply(SetPose(name, (0.0, 3.0), 0.5))
    w.step(50)
    assert w.digest() == digest


def test_kept_contacts_are_there_for_who_asks():
    w = World(town())
    w.step(400)
    before = w.contacts.copy()
    w.step(1)
    odd = w.contacts.copy()
    w.step(1)
    assert len(before) == len(odd) == len(w.contacts)
    for rows in (odd, w.contacts):
        assert np.array_equal(rows["shape_a"], before["shape_a"])
        assert np.array_equal(rows["normal_impulse1"], before["normal_impulse1"])

"""Random commands: none poisons a world, and none raises anything but an error of the package."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sandbox import (
    ApplyForce,
    ApplyImpulse,
    Delete,
    DeleteJoint,
    EndDrag,
    Explode,
    MoveDrag,
    SetGravity,
    SetPose,
    SetSettings,
    SetSurface,
    SetVelocity,
    StartDrag,
)
from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.replay.recording.command_words import decode
from sandbox.scene.flat import FlatSettings
from tests.examples import examples
from tests.flat import body, box, capsule, circle, ground, scene

BAD = [math.nan, math.inf, -math.inf]
HUGE = [1e300, -1e300, 1e10]

names = st.sampled_from(["ground", "platform", "crate", "ball", "nobody"])
numbers = (
    st.floats() | st.floats(-20, 20) | st.integers(-(10**6), 10**6) | st.sampled_from([*BAD, *HUGE, 0.0, -0.0, 1e308])
)
pairs = st.tuples(numbers, numbers)
commands = st.one_of(
    st.builds(SetPose, names, pairs, numbers),
    st.builds(SetVelocity, names, pairs, numbers),
    st.builds(ApplyForce, names, pairs, numbers, st.none() | pairs),
    st.builds(ApplyImpulse, names, pairs, numbers, st.none() | pairs),
    st.builds(SetSurface, names, *[st.none() | numbers] * 4, st.none() | st.integers(-2, 3), st.none() | numbers),
    st.builds(SetGravity, pairs),
    st.builds(
        SetSettings, st.none() | st.integers(-1, 70), *[st.none() | numbers] * 4, *[st.none() | st.booleans()] * 6
    ),
    st.builds(Explode, pairs, numbers, numbers),
    st.builds(StartDrag, names, pairs, st.none() | numbers),
    st.builds(MoveDrag, names, pairs),
    st.builds(EndDrag, names),
    st.integers(1, 5),
)


def finite(w: World) -> bool:
    """Whether every number of the state that can move is finite."""
    tables = (w.state.bodies, w.contacts, w.state.drags)
    return all(np.isfinite(table[name]).all() for table in tables for name in table.dtype.names)


@given(st.lists(commands, max_size=25), st.booleans())
@example([Explode((0.0, -1e-271), 1.0, 5.0)], False)  # so near to an edge that its square is no number
@examples(150)
def test_no_sequence_of_commands_poisons_the_world(sequence, sleeping):
    parts = (
        ground(),
        body("platform", box(2.0, 0.2), type="kinematic", position=(1.0, 1.5), angular_velocity=1.0),
        body("crate", box(1.0, 1.0), position=(0.0, 0.5)),
        body("ball", circle(0.3, restitution=0.9), capsule(0.4, 0.1), position=(0.0, 2.0)),
    )
    w = World(scene(*parts, settings=FlatSettings(sleeping=sleeping)))
    for command in sequence:
        if isinstance(command, int):
            w.step(command)
            assert finite(w)
            continue
        before = w.digest()
        try:
            w.apply(command)
        except SandboxError:
            assert w.digest() == before
        assert finite(w)
    w.step(3)
    assert finite(w)


@pytest.mark.parametrize("command", [DeleteJoint([{"id": "x"}] * 5000), EndDrag("x" * 100_000), Delete("x" * 100_000)])
def test_what_is_refused_is_not_repeated_at_length(command):
    w = World(scene(ground(), body("ball", circle(0.3), position=(0.0, 2.0))))
    with pytest.raises(SandboxError) as caught:
        w.apply(command)
    assert len(str(caught.value)) < 500


@pytest.mark.parametrize("bodies", [3, "ball", [3], [[]], None])
def test_what_a_file_spawns_is_an_object_or_a_list_of_objects(bodies):
    command, found = decode([0, "Spawn", {"bodies": bodies}], ("commands", 0))
    assert command is None
    assert [finding.message for finding in found] == ["bodies must be an object or a list of objects"]

"""Copies of bodies, with the joints among them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import Delete, Scene, ShapeError, Spawn, UnknownBodyError, World, copy_of, paste_of
from tests.examples import examples
from tests.shipped import FILES, shipped

AWAY = 1024.0
SHOWN = ("velocity_x", "velocity_y", "angular_velocity", "angle", "center_y", "mass", "inertia")
MACHINE = Scene(
    gravity=(0, 0),
    prefabs={"arm": {"shapes": [{"box": [2, 0.2]}]}},
    bodies=[
        {"id": "hub", "shapes": [{"circle": 0.5}]},
        {"id": "arm", "prefab": "arm", "position": [1, 0], "velocity": [0, 1]},
        {"id": "ground", "type": "static", "shapes": [{"box": [9, 1]}], "position": [0, -9]},
        {"id": "sled", "prefab": "arm", "position": [0, 3]},
    ],
    joints=[
        {"id": "axle", "type": "revolute", "bodies": ["hub"], "anchor": [0, 0]},
        {"id": "shoulder", "type": "revolute", "bodies": ["hub", "arm"], "anchor": [0, 0], "upper": 60},
        {"id": "rail", "type": "prismatic", "bodies": ["ground", "sled"], "anchor": [0, 3], "axis": [1, 0]},
        {"id": "gear", "type": "gear", "joints": ["shoulder", "rail"]},
        {"id": "clutch", "type": "gear", "joints": ["axle", "shoulder"], "ratio": -2},
    ],
)


def test_joints_among_the_bodies_and_to_the_world_come_along() -> None:
    world = World(MACHINE)
    bodies, joints = copy_of(world, ["arm", "hub", "arm"], (5.0, 1.0))
    assert bodies == [
        {"id": "arm-copy", "prefab": "arm", "position": [6, 1], "velocity": [0, 1]},
        {"id": "hub-copy", "shapes": [{"circle": 0.5}], "position": [5, 1]},
    ]
    assert joints == [
        {"id": "axle-copy", "type": "revolute", "bodies": ["hub-copy"], "anchor": [5, 1]},
        {"id": "shoulder-copy", "type": "revolute", "bodies": ["hub-copy", "arm-copy"], "anchor": [5, 1], "upper": 60},
        {"id": "clutch-copy", "type": "gear", "joints": ["axle-copy", "shoulder-copy"], "ratio": -2},
    ]
    world.apply(Spawn(bodies, joints))
    assert copy_of(world, "ground")[1] == []
    assert copy_of(world, "sled")[1] == []
    assert [entry["id"] for entry in copy_of(world, ["hub", "hub-copy"])[0]] == ["hub-copy-2", "hub-copy-3"]


def test_a_copy_can_be_pasted_again_after_the_bodies_are_gone() -> None:
    world = World(MACHINE)
    entries = copy_of(world, ["hub", "arm"])
    world.apply(Delete(["hub", "arm"]))
    for k in range(3):
        world.apply(Spawn(*paste_of(world, *entries, (4.0 * k, 0.0))))
    assert set(world.names) == {"ground", "sled"} | {
        f"{name}-copy{end}" for name in ("hub", "arm") for end in ("", "-2", "-3")
    }
    assert world.body("arm-copy-3").position == (9.0, 0.0)
    assert world.joint("shoulder-copy-3").bodies == ("hub-copy-3", "arm-copy-3")


def test_ids_stay_within_their_length() -> None:
    name = "x" * 100
    world = World(Scene(bodies=[{"id": name, "shapes": [{"circle": 1}]}]))
    for _ in range(12):
        world.apply(Spawn(*copy_of(world, name, (5.0, 0.0))))
    assert len(set(world.names)) == 13
    assert max(map(len, world.names)) == 100


def test_who_is_not_there_cannot_be_copied() -> None:
    with pytest.raises(UnknownBodyError, match="did you mean"):
        copy_of(World(MACHINE), ["hub", "armm"])


@pytest.mark.parametrize("offset", [(float("nan"), 0.0), (0.0, float("inf")), "up", 3.0, (1.0,)])
def test_copies_go_to_a_place(offset: object) -> None:
    with pytest.raises(ShapeError, match=r"copy_of: .*the offset"):
        copy_of(World(MACHINE), ["hub"], offset)  # type: ignore[arg-type]


@given(st.data())
@examples(40)
def test_copies_are_like_the_bodies_as_they_are_now(data: st.DataObject) -> None:
    """Places at 1024 m are rounded to 2e-13 m."""
    names = [name for name in FILES if len(shipped(name).flatten().bodies) <= 200]
    world = World(shipped(data.draw(st.sampled_from(names))))
    world.step(data.draw(st.integers(0, 120)))
    chosen = data.draw(st.lists(st.sampled_from(world.names), min_size=1, max_size=20, unique=True))
    before = np.asarray(world.state.bodies)[[world.directory.body(name) for name in chosen]]
    count = len(world.names)
    world.apply(Spawn(*copy_of(world, chosen, (AWAY, 0.0))))
    after = np.asarray(world.state.bodies)[count:]
    assert np.abs(after["center_x"] - before["center_x"] - AWAY).max() < 1e-12
    for name in SHOWN:
        assert np.abs(after[name] - before[name]).max() < 1e-12
    joints = world.state.joints
    assert (joints.broken_step[len(world.scene.flatten().joints) :] < 0).all()

"""Every world of a batch goes the way that it would go alone, to the bit."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import ApplyForce, Batch, BreakJoint, SetPose, SetSurface, SetVelocity, Spawn, World
from tests.shipped import shipped

GROUND = {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]}


def scene(*bodies: dict[str, Any], **fields: Any) -> sandbox.Scene:
    return sandbox.Scene(bodies=[GROUND, *bodies], **fields)


def crate(name: str, x: float, y: float, **fields: Any) -> dict[str, Any]:
    return {"id": name, "shapes": [{"box": [1, 1]}], "position": [x, y], **fields}


def digests(batch: Batch) -> list[str]:
    return [batch.digest(k) for k in range(len(batch))]


class Alone:
    """The same worlds, each a `World`."""

    def __init__(self, of: sandbox.Scene, count: int) -> None:
        self.worlds = [World(of) for _ in range(count)]

    def apply(self, command: sandbox.Command, which: int) -> None:
        self.worlds[which].apply(command)

    def step(self, n: int) -> list[str]:
        for world in self.worlds:
            world.step(n)
        return [world.digest() for world in self.worlds]


@pytest.mark.parametrize("name", ["cart-pole", "bullets", "rocket", "card-house", "wrecking-ball", "lift", "pinball"])
def test_worlds_go_as_they_would_alone(name: str) -> None:
    loaded = shipped(name)
    batch, alone = Batch(loaded, 3, threads=1), Alone(loaded, 3)
    moving = next(body.id for body in loaded.flatten().bodies if body.type == "dynamic")
    for k in range(3):
        command = SetVelocity(moving, (0.5 * k, 0.25), 0.1 * k)
        batch.apply(command, k)
        alone.apply(command, k)
    for n in (1, 2, 41):
        batch.step(n)
        assert digests(batch) == alone.step(n)
    assert len(set(digests(batch))) > 1


def test_it_makes_no_difference_how_many_threads_there_are() -> None:
    loaded = shipped("cart-pole")
    one, two = Batch(loaded, 100, threads=1), Batch(loaded, 100, threads=2)
    speeds = np.linspace(-1.0, 1.0, 100)
    for batch in (one, two):
        batch.set_velocity("cart", np.column_stack([speeds, 0 * speeds]))
        batch.step(20)
    assert digests(one) == digests(two)
    assert len(set(digests(one))) == 100


def test_columns_follow_the_worlds() -> None:
    batch = Batch(scene(crate("low", 0, 0.5), crate("high", 3, 9)), 4)
    positions, speeds = batch.positions, batch.velocities
    batch.step(30)
    world = batch.world(2)
    assert np.array_equal(positions[2], world.bodies.position)
    assert np.array_equal(speeds[2], world.bodies.velocity)
    assert np.array_equal(batch.angles[2], world.bodies.angle)
    assert np.array_equal(batch.angular_velocities[2], world.bodies.angular_velocity)
    assert positions.shape == (4, 3, 2)
    assert list(batch.step_counts) == [30] * 4
    assert batch.row("high") == 2
    with pytest.raises(ValueError, match="read-only"):
        positions[0, 0, 0] = 1.0


def test_a_world_that_is_taken_out_goes_on_by_itself() -> None:
    batch = Batch(scene(crate("a", 0, 3)), 2)
    batch.step(10)
    own = batch.world(0)
    own.step(20)
    assert batch.step_counts[0] == 10
    batch.step(20)
    assert own.digest() == batch.digest(0)


def test_more_contacts_than_there_was_room_for() -> None:
    balls = [
        {"id": f"b{k}", "shapes": [{"circle": 0.3}], "position": [0.02 * (k % 3), 1 + 0.55 * k]} for k in range(24)
    ]
    walls = [{"id": f"w{x}", "type": "static", "shapes": [{"box": [1, 20]}], "position": [x, 10]} for x in (-2, 2)]
    loaded = scene(*balls, *walls)
    batch, alone = Batch(loaded, 2), Alone(loaded, 2)
    # Into one heap: more pairs than rows were taken for.
    for k in range(24):
        batch.apply(SetPose(f"b{k}", (0.01 * k, 1.0), 0.0), 1)
        alone.apply(SetPose(f"b{k}", (0.01 * k, 1.0), 0.0), 1)
    for n in (1, 5, 60):
        batch.step(n)
        assert digests(batch) == alone.step(n)
    assert not batch._fleet.apart
    batch.reset()
    batch.step(3)
    assert digests(batch) == Alone(loaded, 2).step(3)


def test_a_world_whose_joint_breaks() -> None:
    pin = {"id": "pin", "type": "revolute", "bodies": ["a"], "anchor": [0, 5]}
    loaded = scene(crate("a", 1, 5), joints=[pin])
    batch, alone = Batch(loaded, 3), Alone(loaded, 3)
    for one in (batch, alone):
        one.apply(BreakJoint("pin"), 1)
    for n in (1, 30):
        batch.step(n)
        assert digests(batch) == alone.step(n)
    assert batch.positions[1, 1, 1] == alone.worlds[1].body("a").position[1]
    kept = batch.snapshot()
    batch.step(5)
    later = digests(batch)
    batch.reset(1)
    batch.restore(kept)
    batch.step(5)
    assert digests(batch) == later


def test_a_world_in_which_a_joint_breaks_by_itself() -> None:
    rope = {"id": "rope", "type": "distance", "bodies": [None, "a"], "anchors": [[0, 9], [0, 6]], "break_force": 100}
    loaded = scene(crate("a", 0, 6), joints=[rope])
    batch, alone = Batch(loaded, 2), Alone(loaded, 2)
    batch.apply(SetVelocity("a", (0.0, -20.0), 0.0), 1)
    alone.apply(SetVelocity("a", (0.0, -20.0), 0.0), 1)
    batch.step(10)
    assert digests(batch) == alone.step(10)
    assert [world.joint("rope").broken for world in alone.worlds] == [False, True]


def test_a_world_with_other_bodies_is_shown_by_itself() -> None:
    loaded = scene(crate("a", 0, 0.5))
    batch, alone = Batch(loaded, 2), Alone(loaded, 2)
    command = Spawn(crate("b", 5, 4))
    batch.apply(command, 1)
    alone.apply(command, 1)
    batch.step(9)
    assert digests(batch) == alone.step(9)
    with pytest.raises(sandbox.ArgumentError, match="world 1 has other bodies"):
        _ = batch.positions
    assert batch.world(1).body("b").position[1] < 4
    batch.reset(1)
    assert batch.positions.shape == (2, 2, 2)


def test_tiles_and_surfaces_that_commands_change() -> None:
    tiles = [{"id": f"t{k}", "type": "static", "shapes": [{"box": [2, 1]}], "position": [2 * k, 2]} for k in range(3)]
    loaded = scene(*tiles, crate("a", 0, 3.2, velocity=[4, 0]))
    batch, alone = Batch(loaded, 4), Alone(loaded, 4)
    for k, command in enumerate(
        [SetPose("t1", (2.0, 1.9), 0.0), SetSurface("t1", friction=2.0), SetSurface("a", density=3.0)]
    ):
        batch.apply(command, k)
        alone.apply(command, k)
    for n in (1, 40):
        batch.step(n)
        assert digests(batch) == alone.step(n)
    assert len(set(digests(batch))) == 4


def test_sleepers_are_woken_as_a_command_would() -> None:
    loaded = scene(crate("a", 0, 0.5), crate("b", 0, 1.5), crate("far", 9, 0.5))
    batch, alone = Batch(loaded, 2), Alone(loaded, 2)
    batch.step(200)
    alone.step(200)
    assert alone.worlds[0].awake_count == 0
    for k in range(2):
        alone.apply(ApplyForce("a", (900.0 * k, 20.0), 1.0), k)
    batch.apply_force("a", [[0.0, 20.0], [900.0, 20.0]], 1.0)
    for n in (1, 3, 90):
        batch.step(n)
        assert digests(batch) == alone.step(n)


@given(
    numbers=st.lists(st.floats(-300, 300, allow_subnormal=False), min_size=6, max_size=6),
    which=st.lists(st.integers(0, 3), max_size=6),
)
def test_commands_by_columns_are_the_commands(numbers: list[float], which: list[int]) -> None:
    x, y, angle, u, v, rate = numbers
    loaded = scene({"id": "plate", "shapes": [{"box": [2, 1], "at": [0.4, 0.1]}], "position": [0, 50]})
    batch, alone = Batch(loaded, 4), Alone(loaded, 4)
    batch.set_pose("plate", (x, abs(y) + 9), angle, which)
    batch.set_velocity("plate", (u, v), rate, which)
    batch.apply_force("plate", (v, u), x, which)
    for k in which:
        alone.apply(SetPose("plate", (x, abs(y) + 9), angle), k)
        alone.apply(SetVelocity("plate", (u, v), rate), k)
        alone.apply(ApplyForce("plate", (v, u), x), k)
    batch.step(3)
    assert digests(batch) == alone.step(3)


class TestSeveralScenes:
    def test_other_masses_and_materials_share_memory(self) -> None:
        scenes = []
        for k in range(4):
            shape = {"box": [1, 1], "density": 1.0 + k, "friction": 0.1 * k}
            scenes.append(scene({**crate("a", 0.1 * k, 1.0, velocity=[3, 0]), "shapes": [shape]}))
        batch = Batch(scenes)
        batch.step(50)
        assert not batch._fleet.apart
        alone = [World(each) for each in scenes]
        for world in alone:
            world.step(50)
        assert digests(batch) == [world.digest() for world in alone]

    def test_other_shapes_and_names_do_not(self) -> None:
        scenes = [scene(crate("a", 0, 2)), scene({**crate("a", 0, 2), "shapes": [{"box": [1, 2]}]}), scene()]
        batch = Batch(scenes)
        batch.step(20)
        assert sorted(batch._fleet.apart) == [1, 2]
        for k, each in enumerate(scenes):
            world = World(each)
            world.step(20)
            assert batch.digest(k) == world.digest()


class TestRefusals:
    def test_what_is_no_batch(self) -> None:
        for given_scene, count in (("x", 3), ([], None), ([3], None)):
            with pytest.raises(sandbox.ArgumentError, match="Batch: takes a Scene"):
                Batch(given_scene, count)  # type: ignore[arg-type]
        with pytest.raises(sandbox.ArgumentError, match="whole number of worlds from 1"):
            Batch(scene(), 0)

    def test_what_is_not_there(self) -> None:
        batch = Batch(scene(crate("crate", 0, 1)), 3)
        with pytest.raises(sandbox.ArgumentError, match="did you mean 'crate'"):
            batch.row("crat")
        for worlds in ([3], [-1], [True, False], "all", [0.5]):
            with pytest.raises(sandbox.ArgumentError, match="numbers from 0 to 2, or 3 truths"):
                batch.reset(worlds)

    def test_numbers_that_do_not_fit(self) -> None:
        batch = Batch(scene(crate("crate", 0, 1)), 3)
        before = digests(batch)
        for force in ([[1, 2, 3]], "x", [[0, 0], [1, 1]]):
            with pytest.raises(sandbox.ArgumentError, match="force takes 3 x 2 numbers"):
                batch.apply_force("crate", force)
        with pytest.raises(sandbox.ArgumentError, match="finite"):
            batch.apply_force("crate", (float("nan"), 0))
        with pytest.raises(sandbox.ArgumentError, match="up to 1e"):
            batch.set_velocity("crate", (1e7, 0))
        with pytest.raises(sandbox.CommandError, match="only a dynamic body"):
            batch.apply_force("ground", (1, 0))
        with pytest.raises(sandbox.ArgumentError, match="2 commands for 3 worlds"):
            batch.apply([SetPose("crate", (0, 1), 0)] * 2)
        with pytest.raises(sandbox.ArgumentError, match="snapshot of this batch"):
            batch.restore(b"")  # type: ignore[arg-type]
        assert digests(batch) == before


@pytest.mark.slow
def test_without_the_compiler() -> None:
    program = (
        "import sandbox; from tests.shipped import shipped; b = sandbox.Batch(shipped('cart-pole'), 2);"
        "b.set_velocity('cart', [[0, 0], [1, 0]]); b.step(5); print(b.digest(0), b.digest(1))"
    )
    environment = os.environ | {"NUMBA_DISABLE_JIT": "1"}
    plain = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
    batch = Batch(shipped("cart-pole"), 2)
    batch.set_velocity("cart", [[0, 0], [1, 0]])
    batch.step(5)
    assert plain.stdout.split() == digests(batch)

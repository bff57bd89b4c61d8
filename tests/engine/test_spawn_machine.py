"""Random lives: bodies, joints and regions come and go among steps and restores, and all that must hold holds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st
from hypothesis.stateful import Bundle, RuleBasedStateMachine, consumes, invariant, rule

import sandbox
from sandbox import Delete, DeleteJoint, DeleteRegion, SetPose, SetVelocity, Spawn
from sandbox.engine.world import World
from sandbox.errors import SandboxError, UnknownBodyError
from sandbox.world.joint_records import GEAR
from tests.engine.test_spawn import tables
from tests.examples import examples

SCENE = sandbox.Scene(
    prefabs={
        "crate": {"shapes": [{"box": [1, 1]}]},
        "dent": {"shapes": [{"polygon": [[0, 0], [1, 0], [1, 1], [0.5, 0.3], [0, 1]]}]},
        "club": {"shapes": [{"circle": 0.3}, {"capsule": [[0, 0], [1, 0]], "radius": 0.1}]},
        "tile": {"type": "static", "shapes": [{"box": [2, 1]}]},
        "rail": {"type": "static", "shapes": [{"chain": [[-2, 0], [0, -0.2], [2, 0]]}]},
        "mill": {"type": "kinematic", "angular_velocity": 60, "shapes": [{"box": [2, 0.2]}]},
        "eye": {"type": "static", "shapes": [{"box": [2, 2], "sensor": True}]},
        "rocket": {"shapes": [{"circle": 0.4}], "thrusters": [{"force": [0, 4], "end": 0.2}]},
    },
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [30, 1]}], "position": [0, -0.5]},
        {"id": "a", "prefab": "crate", "position": [0, 0.5]},
        {"id": "b", "prefab": "crate", "position": [0, 1.5]},
    ],
    joints=[{"id": "tie", "type": "weld", "bodies": ["a", "b"], "anchor": [0, 1]}],
    regions=[{"id": "pool", "water": 2.0, "surface": 1.0}, {"wind": [1, 0], "disc": [0, 2, 3]}],
)
IDS = [*"abcdefgh", "ground"]
REGION_IDS = ["pool", "air", "moon"]
JOINT_IDS = ["tie", "j1", "j2", "cogs"]
places = st.tuples(st.integers(-8, 8), st.integers(0, 8)).map(list)
bodies = st.builds(
    lambda name, prefab, at, angle: {"id": name, "prefab": prefab, "position": at, "angle": angle},
    st.sampled_from(IDS), st.sampled_from(sorted(SCENE.prefabs)), places, st.sampled_from([0, 30, 90]),
)  # fmt: skip
pairs = st.tuples(st.sampled_from(IDS), st.sampled_from([*IDS, None])).map(list)
joints = st.one_of(
    st.builds(
        lambda name, both, at: {"id": name, "type": "revolute", "bodies": both, "anchor": at},
        st.sampled_from(JOINT_IDS), pairs, places,
    ),
    st.just({"id": "cogs", "type": "gear", "joints": ["j1", "j2"]}),
)  # fmt: skip


areas = st.sampled_from(
    [
        {},
        {"inside": [-3, 0, 3, 4]},
        {"disc": [1, 1, 2]},
        {"outline": [[0, 0], [4, 0], [2, 3]]},
        {"start": 0.1, "end": 1},
    ]
)
kinds = st.sampled_from([{"water": 1.5, "surface": 2.0}, {"water": 0.5}, {"wind": [5, 1]}, {"gravity": [0, -1.6]}])
regions = st.builds(lambda name, kind, area: {"id": name, **kind, **area}, st.sampled_from(REGION_IDS), kinds, areas)


class Lives(RuleBasedStateMachine):
    """A world, what ids it should have, and snapshots of it."""

    snapshots = Bundle("snapshots")

    def __init__(self) -> None:
        super().__init__()
        self.world = World(SCENE)
        self.names = list(self.world.names)
        self.held: dict[str, tuple[Any, int]] = {}

    def try_to(self, command: Any) -> bool:
        """Whether a command was taken; if not, nothing has changed."""
        before = self.world.snapshot()
        try:
            self.world.apply(command)
        except SandboxError:
            assert self.world.snapshot() == before
            return False
        return True

    @rule(some=st.lists(bodies, min_size=1, max_size=3), ties=st.lists(joints, max_size=2))
    def spawn(self, some: list[dict[str, Any]], ties: list[dict[str, Any]]) -> None:
        rows = tables(self.world)["body"]
        if self.try_to(Spawn(some, ties)):
            self.names += [each["id"] for each in some]
            assert (tables(self.world)["body"]["position_x"][: len(rows)] == rows["position_x"]).all()

    @rule(ties=st.lists(joints, min_size=1, max_size=2))
    def join(self, ties: list[dict[str, Any]]) -> None:
        self.try_to(Spawn(joints=ties))

    @rule(some=st.lists(st.sampled_from(IDS), min_size=1, max_size=3))
    def delete(self, some: list[str]) -> None:
        poses = {name: self.world.body(name).position for name in self.names}
        done = self.try_to(Delete(some))
        assert done == (set(some) <= set(poses))
        if done:
            self.names = [name for name in self.names if name not in some]
            assert {name: self.world.body(name).position for name in self.names} == {n: poses[n] for n in self.names}

    @rule(some=st.lists(st.sampled_from(JOINT_IDS), min_size=1, max_size=2))
    def part(self, some: list[str]) -> None:
        known = set(self.world.joint_names)
        assert self.try_to(DeleteJoint(some)) == (set(some) <= known)

    @rule(some=st.lists(regions, min_size=1, max_size=2))
    def flood(self, some: list[dict[str, Any]]) -> None:
        there = len(self.world.state.regions)
        taken = {each["id"] for each in some} & set(self.world.state.census.regions.names)
        done = self.try_to(Spawn(regions=some))
        assert done == (not taken and len({each["id"] for each in some}) == len(some))
        assert len(self.world.state.regions) == there + done * len(some)

    @rule(some=st.lists(st.sampled_from(REGION_IDS), min_size=1, max_size=2))
    def drain(self, some: list[str]) -> None:
        known = set(self.world.state.census.regions.names)
        assert self.try_to(DeleteRegion(some)) == (set(some) <= known)

    @rule(n=st.sampled_from([1, 2, 10, 60]))
    def step(self, n: int) -> None:
        """As a world steps that was restored: nothing counts but what a snapshot holds."""
        restored = World(SCENE)
        restored.restore(self.world.snapshot())
        self.world.step(n)
        restored.step(n)
        assert self.world.snapshot() == restored.snapshot()

    @rule(name=st.sampled_from(IDS), at=places)
    def push(self, name: str, at: list[int]) -> None:
        if self.try_to(SetPose(name, (float(at[0]), float(at[1])), 0.5)):
            self.try_to(SetVelocity(name, (1.0, 2.0), 3.0))

    @rule(target=snapshots)
    def save(self) -> tuple[bytes, str, list[str]]:
        return self.world.snapshot(), self.world.digest(), list(self.names)

    @rule(saved=consumes(snapshots), fresh=st.booleans())
    def restore(self, saved: tuple[bytes, str, list[str]], fresh: bool) -> None:
        data, digest, names = saved
        world = World(SCENE)
        world.restore(data)
        if fresh:
            world, self.world = self.world, world
        self.world.restore(data)
        world.restore(data)
        assert self.world.digest() == world.digest() == digest
        assert self.world.snapshot() == world.snapshot() == data
        self.names = list(names)
        self.world.step(3)
        world.step(3)
        assert self.world.digest() == world.digest()
        self.world.restore(data)

    @rule(name=st.sampled_from(IDS))
    def hold(self, name: str) -> None:
        if name in self.names:
            self.held[name] = self.world.body(name), self.world.state.roster.bodies.serials[self.names.index(name)]

    @invariant()
    def names_lead_to_bodies(self) -> None:
        world = self.world
        assert list(world.names) == self.names == list(world.bodies.ids)
        assert [body.id for body in world.flat.bodies] == self.names
        for row, name in enumerate(self.names):
            assert world.body(name).position == tuple(world.bodies.position[row])
        for view, serial in self.held.values():
            if view._world is world and serial not in world.state.roster.bodies.serials:
                with pytest.raises(UnknownBodyError):
                    _ = view.position

    @invariant()
    def rows_point_at_rows(self) -> None:
        state = self.world.state
        count, shapes = len(state.bodies), len(state.shapes)
        assert (np.diff(state.shapes.body) >= 0).all()
        assert [int(n) for n in np.bincount(state.shapes.body, minlength=count)] == [
            len(body.shapes) for body in self.world.flat.bodies
        ]
        contacts = self.world.contacts
        assert (contacts.shape_a < contacts.shape_b).all()
        assert (np.diff(contacts.shape_a * shapes + contacts.shape_b) > 0).all()
        assert (state.shapes.body[contacts.shape_a] == contacts.body_a).all()
        assert (state.shapes.body[contacts.shape_b] == contacts.body_b).all()
        assert ((state.bodies.island >= 0) & (state.bodies.island <= count)).all()
        asleep = state.bodies.island > 0
        assert (state.bodies.island[state.bodies.island[asleep] - 1] == state.bodies.island[asleep]).all()
        for row, joint in zip(state.joints, self.world.flat.joints, strict=True):
            assert (row.kind == GEAR) == (joint.joints is not None)
            ends = [None if k < 0 else self.names[k] for k in (row.body_a, row.body_b)]
            assert ends == [joint.body_a, joint.body_b]
            parents = tuple(self.world.joint_names[k] for k in (row.joint_1, row.joint_2) if k >= 0)
            assert parents == (joint.joints or ())

    @invariant()
    def shapes_are_those_of_a_world_from_nothing(self) -> None:
        never = World(self.world.flat)
        ours, theirs = tables(self.world), tables(never)
        for name in ("vertex", "outline", "edge"):
            assert ours[name].tobytes() == theirs[name].tobytes(), name
        for column in ours["shape"].dtype.names:
            if column != "traits":  # tiles that have been moved abut others
                assert (ours["shape"][column] == theirs["shape"][column]).all(), column
        for column in ours["region"].dtype.names:
            if column not in ("start_step", "end_step"):  # times count from when it came
                assert (ours["region"][column] == theirs["region"][column]).all(), column
        for column in ("mass", "inertia", "local_center_x", "extent"):
            assert (ours["body"][column] == theirs["body"][column]).all(), column
        if self.world.step_count == 0 and not self.world.state.bodies.posed.any():
            assert (ours["body"]["position_x"] == theirs["body"]["position_x"]).all()

    @invariant()
    def everything_is_a_number(self) -> None:
        assert all(np.isfinite(self.world.state.bodies[name]).all() for name in self.world.state.bodies.dtype.names)


TestLives = Lives.TestCase
TestLives.settings = examples(30, stateful_step_count=25)

"""What rests stays laid out from question to question, and the answers are those of an index that is made anew."""

from __future__ import annotations

import contextlib
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import (
    ApplyImpulse,
    Box,
    Circle,
    Delete,
    Explode,
    Filter,
    SetGravity,
    SetPose,
    SetSurface,
    SetVelocity,
    Spawn,
)
from sandbox.engine.events.sensors import SensorOverlaps
from sandbox.engine.queries.queries import Queries
from sandbox.engine.queries.spatial_index import SpatialIndex
from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.scene.flat import FlatScene, FlatSettings
from sandbox.tables import plain
from tests.examples import examples
from tests.flat import body, box, circle, ground, scene

STACKS = 10


def town() -> FlatScene:
    """Tiles and stacks that fall asleep, a pusher, a spinner of two shapes, a sensor, and a ball."""
    tiles = [
        body(f"tile{i}", box(2.0, 1.0), type="static", position=(2.0 * i - 40.0, -0.5 - 0.5 * (i % 3 == 0)))
        for i in range(40)
    ]
    stacks = [
        body(f"crate{i}.{k}", box(0.8, 0.8), position=(2.0 * i - 11.0, 0.41 + 0.81 * k))
        for i in range(STACKS)
        for k in range(1 + i % 3)
    ]
    return scene(
        *tiles,
        *stacks[:7],
        body("pusher", box(0.5, 0.5), type="kinematic", position=(-15.0, 0.6)),
        body("spinner", box(1.0, 0.2), circle(0.3), position=(0.0, 9.0), gravity_scale=0.0, angular_velocity=3.0),
        body("eye", circle(2.0, sensor=True), type="static", position=(0.0, 1.0)),
        *stacks[7:],
        ground(),
        body("ball", circle(0.3), position=(1.0, 5.0), velocity=(2.0, 0.0)),
        settings=FlatSettings(sleeping=True),
    )


def answers(query: Queries) -> list[Any]:
    """What is found by questions of all kinds, two of which see every shape."""
    rays = query.rays([(-45.0, 0.3 * k) for k in range(8)], (90.0, 0.5), Filter(sensors=True))
    return [
        query.overlap_box((-1e5, -1e5), (1e5, 1e5), Filter(sensors=True)),
        query.ray_all((-45.0, 0.4), (90.0, 0.1)),
        [column.tolist() for column in (rays.shape, rays.point, rays.normal, rays.fraction)],
        [query.ray((2.0 * k - 11.0, 20.0), (0.1, -40.0)) for k in range(STACKS)],
        [query.nearest((3.0 * k - 15.0, 1.5)) for k in range(10)],
        query.nearest((900.0, 40.0)),
        query.cast(Box(0.5, 0.5, (-20.0, 0.7), 0.3), (40.0, 0.3)),
        query.overlap_shape(Circle((0.0, 1.0), 3.0), Filter(exclude=("ground",))),
    ]


def sensed(overlaps: SensorOverlaps) -> list[Any]:
    """What the sensors of a world overlap."""
    overlaps.update()
    return np.asarray(overlaps.now).tolist()


class Asked:
    """A world that is asked all along."""

    def __init__(self, flat: FlatScene) -> None:
        self.world = World(flat)
        self.overlaps = SensorOverlaps(self.world.state)
        self.saved = self.world.snapshot()
        self.born = 0

    def do(self, what: str, value: Any) -> None:
        """Step, keep, go back, spawn, or apply a command that may be refused."""
        if what == "step":
            self.world.step(value)
        elif what == "keep":
            self.saved = self.world.snapshot()
        elif what == "go back":
            self.world.restore(self.saved)
        elif what == "spawn":
            self.born += 1
            kind, x = value
            shapes = [{"circle": 0.2}, {"box": [0.3, 0.3], "at": [0.5, 0.0]}]
            new = {"id": f"new{self.born}", "type": kind, "position": [x, 3.0], "shapes": shapes}
            self.world.apply(Spawn([new]))
        else:
            with contextlib.suppress(SandboxError):
                self.world.apply(value)

    def check(self) -> None:
        """An index made anew, and a world restored anew, answer the same."""
        found = answers(self.world.query)
        assert found == answers(Queries(self.world))
        again = World(self.world.scene)
        again.restore(self.world.snapshot())
        assert found == answers(again.query)
        assert sensed(self.overlaps) == sensed(SensorOverlaps(self.world.state))


crates = st.builds("crate{}.{}".format, st.integers(0, STACKS - 1), st.just(0))
anybody = st.sampled_from(["ball", "spinner", "pusher", "tile5", "tile6", "eye", "new1", "new2"]) | crates
places = st.tuples(st.floats(-14, 14), st.floats(0, 4))
put = st.builds(SetPose, anybody, places, st.floats(-1, 1))
few = st.one_of(
    put,
    st.builds(SetVelocity, anybody, places, st.floats(-5, 5)),
    st.builds(Delete, anybody),
    st.builds(Explode, places, st.floats(0.5, 3.0), st.floats(0.1, 5.0)),
)
all_of_them = st.one_of(
    st.builds(SetSurface, anybody, density=st.floats(0.5, 2.0)),
    st.builds(SetGravity, st.tuples(st.floats(-1, 1), st.floats(-12, 0))),
)
doings = st.one_of(
    st.tuples(st.just("step"), st.integers(1, 60)),
    st.tuples(st.just("step"), st.just(1)),
    st.tuples(st.just("command"), put),
    st.tuples(st.just("command"), few),
    st.tuples(st.just("command"), all_of_them),
    st.tuples(st.just("spawn"), st.tuples(st.sampled_from(["dynamic", "static"]), st.floats(-12.0, 12.0))),
    st.tuples(st.sampled_from(["keep", "go back"]), st.none()),
)


@given(st.lists(st.tuples(doings, st.booleans()), max_size=16))
@examples(30)
def test_what_is_kept_is_what_would_be_laid_out(sequence):
    asked = Asked(town())
    asked.world.step(120)
    asked.check()
    for (what, value), check in sequence:
        asked.do(what, value)
        if check:
            asked.check()
    asked.world.step()
    asked.check()


def watched() -> FlatScene:
    """The town among many sensors, some of which move."""
    eyes = [
        body(f"eye{k}", circle(0.7, sensor=True), type="static", position=(1.1 * k - 20.0, 0.3 * (k % 5)))
        for k in range(36)
    ]
    drones = [
        body(f"drone{k}", circle(0.2), circle(1.5, sensor=True), position=(5.0 * k - 10.0, 6.0), gravity_scale=0.0,
             velocity=(0.5, -0.4), angular_velocity=1.0)
        for k in range(3)
    ]  # fmt: skip
    flat = town()
    return scene(*flat.bodies[:30], *eyes, *drones, *flat.bodies[30:], settings=flat.settings)


eyes = st.sampled_from([f"eye{k}" for k in range(36)] + ["drone1", "eye"])
watching = st.one_of(
    doings,
    st.tuples(st.just("command"), st.builds(SetPose, eyes, places, st.floats(-1, 1))),
    st.tuples(st.just("command"), st.builds(Delete, eyes)),
)


@given(st.lists(watching, max_size=16), st.integers(1, 200))
@examples(40)
def test_what_sensors_still_overlap_is_what_they_would_be_found_to(sequence, steps):
    asked = Asked(watched())
    asked.world.step(steps)
    for what, value in sequence:
        asked.do(what, value)
        asked.world.step()
        overlaps = asked.world._events.sensed
        assert overlaps is not None
        assert np.asarray(overlaps).tolist() == sensed(SensorOverlaps(asked.world.state)) == sensed(asked.overlaps)


def test_sensors_that_rest_ask_for_nobody():
    """Who moves is held against the sensors in its box, whatever else there is of them."""
    tiles = [body(f"eye{k}", circle(0.3, sensor=True), type="static", position=(1.0 * k, 0.0)) for k in range(300)]
    made = World(
        scene(*tiles, body("ball", circle(0.4), position=(20.2, 0.1), velocity=(3.0, 0.0)), gravity=(0.0, 0.0))
    )
    made.step(2)
    for _ in range(30):
        made.step()
        walk = made._events._sensors._index.memory.walk[0]
        x = made.body("ball").position[0]
        assert float(walk.x) == pytest.approx(x)  # the last walk, which was the only one, began at the ball
        assert {name for name, _ in made.sensed} == {f"eye{k}" for k in range(300) if abs(k - x) ** 2 + 0.01 < 0.49}


def known(world: World) -> Any:
    """What the index of a world that has just been asked knows of its grid."""
    world.query.ray((0.0, 30.0), (0.0, -1.0))
    return plain(world.query._index.memory.info)[0].copy()


def tile(name: str, x: float) -> dict[str, Any]:
    """A static disc to spawn."""
    return {"id": name, "type": "static", "position": [x, 0.0], "shapes": [{"circle": 1.0}]}


def test_what_only_pushes_has_nothing_laid_out(monkeypatch):
    world = World(town())
    world.step(3)
    known(world)
    asked, update = [], SpatialIndex.update
    monkeypatch.setattr(SpatialIndex, "update", lambda index: asked.append(index) or update(index))
    moved = (
        ApplyImpulse("ball", (1.0, 0.0)), SetVelocity("ball", (1.0, 0.0), 0.0), SetPose("ball", (3.0, 9.0), 0.0),
        Delete("ball"),
    )  # fmt: skip
    for command, laid_out in zip(moved, (0, 0, 1, 2), strict=True):
        world.apply(command)
        known(world)
        assert len(asked) == laid_out
    world.step()
    known(world)
    assert asked.count(world.query._index) == 3  # sensors have one of their own


def test_a_question_lays_out_what_moves_and_no_more():
    world = World(town())
    known(world)
    world.spawn([tile("early", -60.0)])  # memory for many more is taken
    known(world)
    world.step(400)
    before = known(world)
    moving, resting = 2, len(world.state.shapes) - 2  # the spinner has two shapes
    for _ in range(3):
        world.step()
        assert known(world)["loose"] == moving
        assert known(world)["kept"] == resting
    world.apply(SetPose("tile5", (-30.0, -0.5), 0.1))
    assert known(world)["loose"] == moving + 1
    world.spawn([tile("late", 60.0)])
    assert known(world)["loose"] == moving + 2
    world.step()
    world.delete("late")
    info = known(world)
    assert (info["loose"], info["kept"], info["taken"]) == (moving + 1, resting, 1)
    assert (info["kept_regions"], info["kept_sparse"]) == (before["kept_regions"], before["kept_sparse"])


def test_what_has_come_to_rest_is_kept_again():
    world = World(town())
    world.step(400)
    known(world)
    world.apply(SetPose("tile5", (-30.0, -0.5), 0.1))
    shapes, asked = len(world.state.shapes), 0
    while (info := known(world))["loose"] == 3:
        world.step()
        asked += 1
    assert shapes <= asked <= shapes + 2  # in one step it counts as moving
    assert (info["loose"], info["kept"], info["taken"]) == (2, shapes - 2, 0)


@pytest.mark.parametrize(("resting", "kept"), [(3, 0), (4, 4), (40, 40)])
def test_nothing_is_kept_where_most_of_all_moves(resting: int, kept: int):
    moving = [body(f"ball{k}", circle(0.3), position=(2.0 * k, 5.0), velocity=(0.0, 1.0)) for k in range(4)]
    tiles = [body(f"tile{k}", box(1.0, 1.0), type="static", position=(2.0 * k, 0.0)) for k in range(resting)]
    world = World(scene(*moving, *tiles))
    for _ in range(50):
        world.step()
        assert known(world)["kept"] == kept
    assert len(world.query.ray_all((-9.0, 0.0), (99.0, 0.0))) == resting

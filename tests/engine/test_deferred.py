"""Bodies that go and come wait for each other until somebody looks: it comes to what each by itself comes to."""

from __future__ import annotations

import copy
import random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import Delete, DeleteJoint, SetPose, SetVelocity, Spawn
from sandbox.engine.world import World
from sandbox.errors import CommandError, SandboxError, UnknownBodyError, UnknownJointError
from sandbox.world import rows
from tests.engine.test_spawn import GROUND, JOINTS, ZOO, make, same
from tests.examples import examples

FEELER: dict[str, Any] = {"id": "feeler", "type": "static", "shapes": [{"box": [9, 1], "sensor": True}]}


def ball(name: str, x: float = 0.0, y: float = 4.0) -> dict[str, Any]:
    return {"id": name, "shapes": [{"circle": 0.3}], "position": [x, y]}


def crate(name: str, x: float = 0.0, y: float = 4.0) -> dict[str, Any]:
    return {"id": name, "prefab": "crate", "position": [x, y]}


def sensor(name: str, x: float = 0.0, y: float = 1.0) -> dict[str, Any]:
    return {"id": name, "shapes": [{"circle": 1.0, "sensor": True}, {"circle": 0.2}], "position": [x, y]}


def paddle(name: str, x: float = 0.0, y: float = 0.5) -> dict[str, Any]:
    return {"id": name, "type": "kinematic", "shapes": [{"box": [1, 0.2]}], "position": [x, y], "velocity": [1, 0]}


KINDS = (ball, crate, ball, crate, sensor, paddle)


def heap() -> World:
    world = make([GROUND, FEELER, *(ball(f"b{k}", 0.61 * (k % 5) - 1.2, 0.3 + 0.62 * (k // 5)) for k in range(25))], [])
    world.apply(Spawn([kind("first", 30.0) | {"id": kind.__name__} for kind in set(KINDS)]))
    world.step(120)
    return world


def same_told(one: World, two: World) -> None:
    assert list(one.events) == list(two.events)
    assert (one.sensed, one.events.names) == (two.sensed, two.events.names)
    same(one, two)
    assert one.snapshot() == two.snapshot()


def commands(chance: random.Random, there: list[str], number: int) -> list[Any]:
    """Some commands to bodies that are there, come and go; `there` is brought up to date."""
    found: list[Any] = []
    for k in range(chance.randrange(8)):
        if there and chance.random() < 0.5:
            names = chance.sample(there, min(len(there), chance.choice((1, 1, 3))))
            there[:] = [name for name in there if name not in names]
            found.append(Delete(names))
        elif there and chance.random() < 0.2:
            name = chance.choice(there)
            found.append(chance.choice((SetVelocity(name, (1.0, 3.0), 0.0), SetPose(name, (1.0, 5.0), 0.0))))
        else:
            fresh = [f"n{number}-{k}-{n}" for n in range(chance.choice((1, 1, 2)))]
            kind = chance.choice(KINDS)
            there += fresh
            found.append(Spawn([kind(name, chance.uniform(-3, 3), chance.uniform(1, 6)) for name in fresh]))
    return found


@examples(20)
@given(st.integers(0, 1 << 30))
def test_what_waits_comes_to_what_each_comes_to_by_itself(seed: int) -> None:
    chance = random.Random(seed)
    one = heap()
    two = copy.deepcopy(one)
    there = [f"b{k}" for k in range(25)]
    for number in range(25):
        for command in commands(chance, there, number):
            one.apply(command)
            assert len(one.bodies) == len(one.state.bodies)  # looks, and has it done
            two.apply(command)
        if chance.random() < 0.5:
            same_told(one, two)
        one.step()
        two.step()
        same_told(one, two)


def test_the_tables_are_gone_through_once_for_all(monkeypatch: pytest.MonkeyPatch) -> None:
    world, calls = heap(), []
    for name in ("remove_rows", "add_rows"):
        own = getattr(rows, name)
        for place in ("world", "commands.delete", "commands.spawn"):
            told = lambda *given, own=own, name=name: calls.append(name) or own(*given)  # noqa: E731
            monkeypatch.setattr(f"sandbox.engine.{place}.{name}", told, raising=False)
    for k in range(5):
        world.spawn(ball(f"n{k}"))
        world.delete(f"b{k}")
    assert calls == []
    world.step()
    assert calls == ["remove_rows", "add_rows"]


def test_what_is_refused_changes_nothing_that_waits() -> None:
    one = heap()
    two = copy.deepcopy(one)
    for world in (one, two):
        world.delete(["b3", "b4", "b3"])
        world.spawn(ball("new"))
        if world is one:
            for command, error in (
                (Delete(["b5", "b3"]), UnknownBodyError),  # gone
                (Delete(["b5", "nobody"]), UnknownBodyError),
                (Spawn([ball("more"), ball("new")]), CommandError),  # taken by what waits
                (Spawn([ball("more"), ball("b6")]), CommandError),
                (SetVelocity("b3", (0.0, 1.0), 0.0), UnknownBodyError),
            ):
                with pytest.raises(error):
                    world.apply(command)
        world.spawn(ball("b3", 3.0))  # an id that is free again
        world.step()
    same_told(one, two)


def test_what_has_just_come_can_go_and_come_again() -> None:
    world = heap()
    world.spawn(ball("new", 1.0))
    world.delete(["new", "b0"])
    world.spawn(ball("new", 2.0))
    assert world.body("new").position[0] == 2.0
    assert "b0" not in world.names
    assert world.names.count("new") == 1
    world.delete("new")
    with pytest.raises(UnknownBodyError):
        world.body("new")


def test_joints_of_who_waits_to_go_are_gone() -> None:
    world = make(ZOO, JOINTS)
    world.step(3)
    world.delete("bob")
    with pytest.raises(UnknownJointError):
        world.apply(DeleteJoint("cogs"))
    assert world.joint_names == ("hinge",)


def test_who_stays_is_held_by_joints_as_ever_when_others_go_right_before_a_step() -> None:
    """The calls of the step know already that rows have come, and not yet that joints go with those who wait to."""
    balls = [ball("a", 0.0), ball("b", 1.0), ball("c", 3.0), ball("d", 4.0)]
    hinges = [
        {"id": "ab", "type": "revolute", "bodies": ["a", "b"], "anchor": [0.5, 4.0]},
        {"id": "cd", "type": "revolute", "bodies": ["c", "d"], "anchor": [3.5, 4.0]},
    ]
    one, two = make([GROUND, *balls], hinges), make([GROUND, *balls], hinges)
    for world in (one, two):
        world.spawn(ball("first", 20.0))
        world.step()
        world.spawn(ball("new", 21.0))
        assert "new" in world.names
        world.delete(["a", "b"])
        if world is one:
            assert "a" not in world.names
        world.step(30)
    same_told(one, two)


LOOKS: dict[str, Any] = {
    "state": lambda world: world.state.names,
    "directory": lambda world: [world.directory.has_body(name) for name in ("b1", "new")],
    "events": lambda world: [(event["event"], event.get("a")) for event in world.events],
    "untold": lambda world: len(world.untold.deleted[0]),
    "scratch": lambda world: int(world.scratch.active.bodies[0]),
    "query": lambda world: [hit.body for hit in world.query.ray_all((-3.0, 0.3), (6.0, 0.0))],
    "columns": lambda world: world.bodies.position.tolist(),
    "digest": lambda world: world.digest(),
    "copy": lambda world: copy.deepcopy(world).digest(),
    "sensed": lambda world: world.sensed,
    "contacts": lambda world: (len(world.contacts), world.contact_impulses.tolist()),
}


@pytest.mark.parametrize("look", LOOKS)
def test_nobody_sees_that_it_waits(look: str) -> None:
    one = heap()
    two = copy.deepcopy(one)
    held = one.state, one.bodies, one.query, one.body("b2")
    for world in (one, two):
        world.delete("b1")
        if world is one:
            assert held[0].names is one.state.names  # has it done, and so does what was held
        world.spawn(ball("new", 0.2, 0.9))
        if world is one:
            assert len(held[1]) == len(one.state.bodies)
    assert LOOKS[look](two) == LOOKS[look](one)


def test_what_was_asked_for_before_sees_it() -> None:
    world = heap()
    state, columns, query, view = world.state, world.bodies, world.query, world.body("b2")
    directory = world.directory
    at, count = view.position, len(columns)
    query.ray((-3.0, 0.3), (6.0, 0.0))
    world.delete(["b0", "b1"])
    assert view.position == at
    world.delete("b2")
    assert len(state.bodies) == count - 3
    world.delete("b3")
    assert len(columns) == count - 4
    world.delete("b5")
    assert world.names[directory.body("b9")] == "b9"
    world.delete("b4")
    hit = query.ray((-3.0, 0.3), (6.0, 0.0))
    assert hit is None or hit.body not in {f"b{k}" for k in range(5)}
    with pytest.raises(UnknownBodyError):
        _ = view.position


def test_a_rewind_goes_back_to_before() -> None:
    world = heap()
    before = world.snapshot()
    digest = world.digest()
    world.delete("b1")
    world.spawn(ball("new"))
    world.restore(before)
    assert world.digest() == digest
    assert "b1" in world.names
    assert "new" not in world.names
    world.delete("b1")
    with pytest.raises(SandboxError):
        world.restore(b"nothing")
    assert "b1" not in world.names


def test_a_recording_has_each_command() -> None:
    recorder = sandbox.Recorder(make([GROUND, ball("a"), ball("b", 1.0)], []))
    recorder.apply(Delete("a"))
    recorder.apply(Spawn(ball("a", 3.0)))
    recorder.step(5)
    assert recorder.world.names == ("ground", "b", "a")

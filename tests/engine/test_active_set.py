"""Who comes is put into the lists of what a step looks at, and nobody else is looked at for it."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import Delete, SetGravity, SetPose, SetSettings, SetSurface, SetVelocity, Spawn
from sandbox.engine.world import World
from tests.examples import examples

GROUND: dict[str, Any] = {"id": "ground", "type": "static", "shapes": [{"box": [60, 1]}], "position": [0, -0.5]}
CHANGES = ("delete", "steps", "pose", "velocity", "surface", "gravity", "settings")
KINDS = ("ball", "pair", "sleeper", "tile", "goal", "platform")


def entry(kind: str, number: int) -> dict[str, Any]:
    """A body of that kind, beside the others and near the ground."""
    name, place = f"{kind}-{number}", [float(3 * (number % 15) - 20), 0.6 + 0.2 * (number % 3)]
    return {
        "ball": {"id": name, "shapes": [{"circle": 0.5}], "position": place, "velocity": [4, 0]},
        "pair": {"id": name, "shapes": [{"box": [1, 0.5]}, {"circle": 0.4}], "position": place},
        "sleeper": {"id": name, "shapes": [{"circle": 0.4}], "position": [place[0], 0.4]},
        "tile": {"id": name, "type": "static", "shapes": [{"box": [1, 1]}], "position": [float(number), 0.5]},
        "goal": {"id": name, "type": "static", "shapes": [{"box": [2, 2], "sensor": True}], "position": place},
        "platform": {"id": name, "type": "kinematic", "shapes": [{"box": [2, 0.2]}], "position": [place[0], 2.0],
                     "velocity": [1, 0]},
    }[kind]  # fmt: skip


def check(world: World) -> None:
    """The lists hold everybody once, in the order that they promise."""
    active, shapes = world.scratch.active, world.state.shapes
    info, activity = active.info[0], active.activity[: len(world.names)]
    bodies: Any = world.state.bodies
    slept = np.flatnonzero(activity == 2)
    assert bodies.type[slept].tolist() == [2] * len(slept)
    assert info.asleep == len(slept)
    assert np.flatnonzero(activity == 1).tolist() == active.bodies[1 : 1 + active.bodies[0]].tolist()
    assert active.shapes[: info.moving].tolist() == np.flatnonzero(activity[shapes.body] == 1).tolist()
    assert info.static == (bodies.type == 0).sum()
    check_islands(world)


def check_islands(world: World) -> None:
    """Every sleeping island has the list of its members."""
    active, bodies = world.scratch.active, world.state.bodies
    for island in set(bodies.island[bodies.awake == 0].tolist()) - {0}:
        row, members = int(active.last_member[island - 1]), []
        while row >= 0:
            members.append(row)
            row = int(active.member_before[row])
        assert members[::-1] == np.flatnonzero((bodies.island == island) & (bodies.awake == 0)).tolist()


def changed(world: World, what: str, number: int) -> None:
    """Do one thing to a world of `GROUND` and others."""
    name = world.names[number % len(world.names)]
    if what == "steps":
        world.step(number)
    elif what == "pose":
        world.apply(SetPose(name, (float(number % 13) - 6.0, 0.3 * (number % 5)), 0.1 * (number % 3)))
    elif what == "velocity" and not name.startswith(("ground", "tile", "goal")):
        world.apply(SetVelocity(name, (float(number % 5) - 2.0, 0.0), 0.0))
    elif what == "surface":
        world.apply(SetSurface(name, restitution=0.1 * (number % 9), surface_speed=float(number % 2)))
    elif what == "gravity":
        world.apply(SetGravity((0.1 * (number % 3), -9.81)))
    elif what == "settings":
        world.apply(SetSettings(substeps=3 + number % 3))
    elif what == "delete" and name != "ground":
        world.apply(Delete(name))


@examples(300)
@given(st.lists(st.tuples(st.sampled_from((*KINDS, *CHANGES)), st.integers(0, 40)), max_size=25), st.booleans())
def test_it_goes_on_as_if_everybody_had_been_looked_at(changes, sleeping):
    one, two = (World(sandbox.Scene(bodies=[GROUND], settings={"sleeping": sleeping})) for _ in range(2))
    for turn, (what, number) in enumerate(changes):
        for world in (one, two):
            if what in KINDS:
                world.apply(Spawn(entry(what, 50 * turn + number)))
            else:
                changed(world, what, number)
        if number % 4 != 0:  # else changes come together
            continue
        two._stepper.forget()
        two.scratch.grid.cache.info.valid = 0
        for world in (one, two):
            world.step()
            check(world)
        assert one.digest() == two.digest()


def test_nobody_is_looked_at_who_stays():
    tiles = [entry("tile", number) for number in range(20)]
    world = World(sandbox.Scene(bodies=[GROUND, *tiles, entry("ball", 1)]))
    world.apply(Spawn(entry("ball", 5)))  # memory for more of them, of which all is new
    world.step(2)
    info = world.scratch.active.info[0]
    before = info.anew
    for number, kind in enumerate(("ball", "pair", "sleeper", "ball", "tile", "platform")):
        world.apply(Spawn([entry(kind, 50 * number + 10), entry(kind, 50 * number + 11)]))
        if number % 2:
            world.step(3)
    world.apply(SetPose("tile-3", (-20.0, 5.0), 0.1))
    world.apply(SetGravity((0.0, -5.0)))
    world.step(3)
    world.apply(SetSettings(substeps=5))
    world.step(3)
    assert len(world.names) - world.names.index("ball-5") < len(world.scratch.active.touched)
    for name in ("ball-5", "tile-210", "tile-3"):
        world.apply(Delete(name))
        world.step(3)
        check(world)
    assert info.anew == before


def test_all_are_looked_at_anew_where_many_are_touched():
    world = World(sandbox.Scene(bodies=[GROUND, entry("platform", 1)]))  # in which steps are taken
    world.apply(Spawn([entry("tile", number) for number in range(300)]))
    world.step(3)
    info = world.scratch.active.info[0]
    for count, anew in ((5, False), (300, True), (5, False)):
        before = int(info.anew)
        for number in range(count):
            world.apply(SetPose(f"tile-{number}", (float(number), 1.5 + 0.1 * count), 0.0))
        world.step(3)
        check(world)
        assert (info.anew > before) == anew


def crowd(count: int = 200) -> World:
    """Crates that sleep side by side, and a spinner in the air that does not."""
    crates = [
        {"id": f"crate-{k}", "shapes": [{"box": [1, 1]}], "position": [2.0 * k - count, 0.5]} for k in range(count)
    ]
    spinner = {"id": "spinner", "shapes": [{"box": [1, 1]}], "position": [0, 90], "gravity_scale": 0}
    spinner["angular_velocity"] = 90
    ground = {"id": "ground", "type": "static", "shapes": [{"box": [600, 1]}], "position": [0, -0.5]}
    world = World(sandbox.Scene(bodies=[ground, *crates, spinner], settings={"sleeping": True}))
    world.step(100)
    assert world.awake_count == 1
    return world


def test_who_sleeps_is_not_looked_at_when_others_wake_come_and_fall_asleep():
    world = crowd()
    boxes, info = world.scratch.colliders.boxes, world.scratch.active.info[0]
    row = world.names.index("crate-150")
    shape = int(np.flatnonzero(world.state.shapes.body == row)[0])
    mark, anew = float(boxes.lower_x[shape]) + 0.001, int(info.anew)
    boxes.lower_x[shape] = mark
    for k in range(60):
        world.apply(SetVelocity(f"crate-{k}", (0.02, 0.0), 0.0))
        if k % 20 == 5:
            world.apply(Spawn(entry("ball", 100 + k)))
        world.step()
        assert info.listed <= world.awake_count + 2
    assert float(boxes.lower_x[shape]) == mark or info.anew > anew  # more memory, in which all is new
    world.step(100)
    check(world)


def test_contacts_of_sleepers_stay_where_they_are_when_others_wake():
    world = crowd()
    world.step(3)
    for k in range(8):
        world.apply(SetVelocity(f"crate-{k}", (0.02, 0.0), 0.0))
        table = world.scratch.contacts.now  # of two steps ago, which is written now
        row = int(np.flatnonzero(table.body_b[:200] == world.names.index("crate-150"))[0])
        if k > 1:
            table.friction[row] = 0.25 + k
        world.step()
        if k > 1:  # nothing was copied
            assert world.contacts["friction"][row] == 0.25 + k


def test_who_has_come_may_be_changed_at_once():
    world = crowd(100)
    for turn in range(2):  # the first brings memory for more, in which all is new
        balls = [{**entry("ball", 10 * turn + k), "position": [2.0 * k, 30.0 + 2.0 * turn]} for k in range(10)]
        world.apply(Spawn(balls))
        for k in (3, 7):
            world.apply(SetPose(f"ball-{10 * turn + k}", (2.0 * k, 20.0), 0.0))
        world.step()
        check(world)


def test_an_island_keeps_its_members_when_rows_between_them_go():
    ids = ("a", "x", "b", "y", "c")
    places = {"a": 0.0, "b": 0.9, "c": 1.8, "x": 20.0, "y": 30.0}
    bodies = [{"id": i, "shapes": [{"circle": 0.45}], "position": [places[i], 0.45]} for i in ids]
    pillar = {"id": "ball-1", "shapes": [{"circle": 0.5}], "position": [-20, 9], "gravity_scale": 0, "velocity": [0, 1]}
    joints = [
        {"id": two, "type": "revolute", "bodies": list(two), "anchor": [places[two[0]] + 0.45, 0.45]}
        for two in ("ab", "bc")
    ]
    world = World(sandbox.Scene(bodies=[GROUND, *bodies, pillar], joints=joints, settings={"sleeping": True}))
    world.step(100)
    assert world.awake_count == 1
    for name in ("x", "y"):
        world.apply(Delete(name))
        world.step()
        check_islands(world)
    world.apply(Spawn(entry("ball", 5)))
    world.step()
    world.apply(sandbox.SetVelocity("c", (0.5, 0.0), 0.0))
    assert world.body("a").awake

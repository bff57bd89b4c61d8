"""Pairs that persist are those of a look at all boxes, after any step, whoever moves, comes, goes, sleeps or wakes."""

from __future__ import annotations

import contextlib
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import ApplyImpulse, Delete, DeleteJoint, SetGravity, SetJoint, SetPose, SetVelocity, Spawn
from sandbox.engine.broad_phase.moved_boxes import END
from sandbox.engine.broad_phase.proxies import ACTIVE, DRIVEN, SLEEPS
from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.tables import plain
from tests.examples import examples
from tests.naive.grid import Box, may_meet

TILES, DISCS, LINKS = 60, 24, 5


def hinge(name: str, one: str, other: str, at: tuple[float, float] = (0.0, 0.0)) -> dict[str, Any]:
    return {"id": name, "type": "revolute", "bodies": [one, other], "anchor": list(at)}


def crowd(hinged: bool = True) -> sandbox.Scene:
    """Discs of many sizes fall on static tiles, past a chain and a driven bar; one of them only meets tiles."""
    tiles = [
        {"id": f"tile{k}", "type": "static", "shapes": [{"box": [1, 1]}], "position": [1.1 * k - 33, -0.5]}
        for k in range(TILES)
    ]
    discs = [
        {
            "id": f"disc{k}",
            "shapes": [{"circle": 0.05 * 1.25 ** (k % 12), "mask": 1 if k == 7 else 0xFFFF, "category": 1 + k % 2}],
            "position": [1.7 * (k % 8) - 6, 1.5 + 1.7 * (k // 8)],
        }
        for k in range(DISCS)
    ]
    links = [{"id": f"link{k}", "shapes": [{"box": [0.6, 0.2]}], "position": [12 + 0.5 * k, 4]} for k in range(LINKS)]
    hinges = [hinge(f"hinge{k}", f"link{k}", f"link{k + 1}", (12.25 + 0.5 * k, 4)) for k in range(LINKS - 1)]
    bar = {"id": "bar", "type": "kinematic", "shapes": [{"box": [4, 0.2]}], "position": [0, 8], "angular_velocity": 90}
    return sandbox.Scene(bodies=[*tiles, *discs, *links, bar], joints=hinges if hinged else [])


names = st.sampled_from([f"disc{k}" for k in range(DISCS)] + ["bar", "link0", "tile30", "tile31"])
hinges = st.sampled_from([f"hinge{k}" for k in range(LINKS)])
places = st.tuples(st.floats(-40, 40), st.floats(-3, 30))
speeds = st.tuples(st.floats(-60, 60), st.floats(-60, 60))
commands = st.one_of(
    st.builds(SetPose, names, places, st.floats(-3, 3)),
    st.builds(SetVelocity, names, speeds, st.floats(-20, 20)),
    st.builds(ApplyImpulse, names, speeds, st.floats(-1, 1)),
    st.builds(SetGravity, st.tuples(st.floats(-1, 1), st.floats(-12, 2))),
    st.builds(Delete, names),
    st.builds(
        lambda at, size: Spawn({"id": "one", "shapes": [{"circle": size}], "position": list(at)}),
        places,
        st.floats(0.02, 8),
    ),
    st.builds(Delete, st.just("one")),
    st.builds(SetJoint, hinges, enabled=st.booleans()),
    st.builds(SetJoint, hinges, collide=st.booleans()),
    st.builds(SetJoint, hinges, break_force=st.just(1e-3)),
    st.builds(DeleteJoint, hinges),
    st.builds(lambda name, one, other: Spawn(joints=hinge(name, one, other)), hinges, names, names),
)
sequences = st.lists(st.tuples(st.integers(1, 30), commands), max_size=10)


def proposed(world: World) -> list[tuple[int, int]]:
    pairs = plain(world.scratch.grid.pairs)[: int(world.state.counters[0].pair_count)]
    return list(zip(pairs["shape_a"].tolist(), pairs["shape_b"].tolist(), strict=True))


def bonds_of(world: World) -> set[tuple[int, int]]:
    return {(int(each.low), int(each.high)) for each in world.scratch.joint_filter.bonds}


def overlapping(world: World, bonds: set[tuple[int, int]]) -> list[tuple[int, int]]:
    """All pairs of boxes that overlap and matter, by looking at all of them, without those of joined bodies."""
    count = len(world.state.shapes)
    boxes, filters = plain(world.scratch.colliders.boxes)[:count], plain(world.scratch.colliders.filters)[:count]
    meets = np.ones((count, count), bool)
    for low, high in (("lower_x", "upper_x"), ("lower_y", "upper_y")):
        meets &= (boxes[low][:, None] <= boxes[high][None, :]) & (boxes[low][None, :] <= boxes[high][:, None])
    return [pair for pair in zip(*map(np.ndarray.tolist, np.nonzero(np.triu(meets, 1))), strict=True)
            if _matters(*(filters[k] for k in pair), bonds)]  # fmt: skip


def _matters(a: Any, b: Any, bonds: set[tuple[int, int]]) -> bool:
    bodies = sorted((int(a["body"]), int(b["body"])))
    moves = int(a["moves"]) | int(b["moves"])
    lively = moves & ACTIVE or moves == SLEEPS | DRIVEN
    one, other = (
        Box((0, 0), (0, 0), 0, True, int(each["category"]), int(each["mask"]), int(each["group"])) for each in (a, b)
    )
    return bool(bodies[0] != bodies[1] and lively and may_meet(one, other) and tuple(bodies) not in bonds)


def check(world: World, steps: int) -> None:
    for _ in range(steps):
        bonds = bonds_of(world)  # one may break at the end of the step
        world.step()
        assert proposed(world) == overlapping(world, bonds)
        assert laid(world) == list(range(len(world.state.shapes)))


def laid(world: World) -> list[int]:
    """Whose boxes are in the grid: those of `ordered` that are not taken out, and those in the lists."""
    grid = world.scratch.grid
    count, ordered = int(grid.info[0].shapes), plain(grid.ordered)[: grid.heads[-1]]
    rows: list[int] = ordered["shape_index"][ordered["lower_x"] <= ordered["upper_x"]].tolist()
    for row in grid.moved_heads.tolist():
        while row != END:
            assert len(rows) <= count, "a list leads back into itself"
            rows.append(row)
            row = int(grid.moved_next[row])
    return sorted(rows)


def tell(world: World, command: Any) -> None:
    with contextlib.suppress(SandboxError):  # that body is not there
        world.apply(command)


@given(sequences, st.integers(0, 200), st.booleans())
@examples(60)
def test_cached_pairs_are_those_of_all_boxes(sequence: list[tuple[int, Any]], before: int, hinged: bool) -> None:
    world = World(crowd(hinged))
    world.step(before)
    for steps, command in [*sequence, (30, SetVelocity("disc3", (30.0, 5.0), 9.0))]:
        tell(world, command)
        check(world, steps)


@given(sequences)
@examples(15)
def test_a_restored_world_finds_the_pairs_of_its_boxes(sequence: list[tuple[int, Any]]) -> None:
    world = World(crowd())
    world.step(40)
    snapshot = world.snapshot()
    for steps, command in sequence:
        tell(world, command)
        world.step(steps)
    world.restore(snapshot)
    check(world, 5)


@pytest.mark.parametrize("name", ["last", "heap3", "disc5", "tile50"])
def test_what_goes_leaves_nothing_in_the_grid(name: str) -> None:
    world = World(crowd(hinged=False))
    world.spawn([
        {"id": each, "shapes": [{"circle": 0.5}], "position": [-20.0 + 0.9 * k, 0.5]}
        for k, each in enumerate(["heap1", "heap2", "heap3", "last"])
    ])  # fmt: skip
    check(world, 60)
    world.delete(name)
    assert world.scratch.grid.cache.info[0].valid == 1
    check(world, 3)
    world.spawn({"id": "later", "shapes": [{"circle": 0.5}], "position": [-19.0, 3.0]})
    check(world, 60)


def test_nobody_meets_where_all_go_that_memory_was_just_taken_for() -> None:
    boxes = [{"id": f"{k}", "shapes": [{"box": [1, 1]}], "position": [0, 0.99 * k]} for k in range(2)]
    world = World(sandbox.Scene(bodies=boxes))
    world.step()
    assert len(world.contacts) == 1
    world.spawn({"id": "more", "type": "static", "shapes": [{"circle": 1}], "position": [9, 0]})
    world.delete(["0", "1", "more"])
    world.step()
    assert len(world.contacts) == 0


CHAIN = [f"new{k}" for k in range(3)]
CHANGES: list[Any] = [
    SetJoint("hinge1", enabled=False),
    SetJoint("hinge1", enabled=True),
    SetJoint("hinge2", collide=True),
    SetJoint("hinge0", break_force=1e-3),
    DeleteJoint("hinge3"),
    Spawn(
        [{"id": name, "shapes": [{"box": [0.6, 0.2]}], "position": [2 + 0.5 * k, 20]} for k, name in enumerate(CHAIN)],
        [hinge(f"pin{k}", *CHAIN[k : k + 2], (2.25 + 0.5 * k, 20)) for k in range(2)],
    ),
    Delete("new2"),
    Delete(["new0", "new1"]),
    Delete("disc3"),
]


def test_whatever_becomes_of_joints_the_grid_stays() -> None:
    world = World(crowd())
    world.spawn({"id": "one", "shapes": [{"circle": 0.5}], "position": [30, 30]})  # takes memory for more
    check(world, 30)
    pairs = len(proposed(world))
    for command in CHANGES:
        world.apply(command)
        assert world.scratch.grid.cache.info[0].valid == 1
        check(world, 3)
    assert world.joint("hinge0").broken
    assert len(proposed(world)) > pairs  # links meet that were joined


def rebuilt(world: World, steps: int) -> list[bool]:
    """Whether the grid was rebuilt, step by step."""
    found = []
    for _ in range(steps):
        age = int(world.scratch.grid.cache.info[0].age)
        world.step()
        found.append(int(world.scratch.grid.cache.info[0].age) <= age)
    return found


def test_a_pyramid_at_rest_needs_the_grid_once() -> None:
    pyramid = sandbox.Scene(
        bodies=[{"id": "ground", "type": "static", "shapes": [{"box": [60, 1]}], "position": [0, -0.5]}],
        generate=[{"id": "p", "pyramid": "box", "rows": 10, "at": [0, 0.5]}],
        prefabs={"box": {"shapes": [{"box": [1, 1]}]}},
        settings={"sleeping": False},
    )
    world = World(pyramid)
    world.step(20)
    assert not any(rebuilt(world, 200))


def test_one_that_moves_is_looked_up_alone() -> None:
    world = World(crowd())
    world.step(400)
    assert world.awake_count < 10
    tell(world, SetVelocity("disc3", (0.0, 8.0), 0.0))
    assert not any(rebuilt(world, 60))
    assert world.scratch.grid.info[0].moved > 0


@pytest.mark.parametrize("size", [0.01, 1.0, 300.0])
def test_where_all_sizes_are_one_a_box_may_become_any_other(size: float) -> None:
    """A level that had few boxes when the grid was built gets many: all discs are thrown at once, ever faster."""
    discs = [
        {"id": f"disc{k}", "shapes": [{"circle": size}], "position": [3 * size * (k % 10), 3 * size * (k // 10)]}
        for k in range(60)
    ]
    world = World(sandbox.Scene(bodies=discs, gravity=[0, 0]))
    for round in range(4):
        for k in range(10 * round, 10 * round + 10):
            speed = size * 4.0**round
            world.apply(SetVelocity(f"disc{k}", (speed, 0.3 * speed * (-1) ** k), 0.0))
        check(world, 8)

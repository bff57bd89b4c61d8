"""Seams as shapes come and go: the tables are those of a world that is built of what is left, byte for byte."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import Delete, SetPose, Spawn
from sandbox.engine.lanes.lane_world import LaneWorld
from sandbox.engine.world import World
from sandbox.world import tiling
from sandbox.world.records import SEAMED
from tests.engine.test_spawn import tables
from tests.examples import examples

DENT = [[0, 0], [2, 0], [2, 2], [1, 0.5], [0, 2]]
PREFABS: dict[str, Any] = {
    "tile": {"type": "static", "shapes": [{"box": [1, 1]}]},
    "slab": {"type": "static", "shapes": [{"box": [4, 1]}]},
    "pair": {"type": "static", "shapes": [{"box": [1, 1]}, {"box": [1, 1], "at": [1, 0]}]},
    "goal": {"type": "static", "shapes": [{"circle": 0.2}, {"box": [3, 1], "sensor": True}]},
    "rock": {"type": "static", "shapes": [{"polygon": DENT}]},
    "dent": {"shapes": [{"polygon": DENT}]},
    "rail": {"type": "static", "shapes": [{"chain": [[-2, 0], [0, -0.2], [2, 0]]}]},
    "wire": {"type": "static", "shapes": [{"segment": [[0, 0], [2, 0]]}]},
    "bar": {"type": "static", "shapes": [{"capsule": [[0, 0], [1, 0]], "radius": 0.5}]},
    "crate": {"shapes": [{"box": [1, 1]}]},
    "cross": {"shapes": [{"box": [2, 0.5]}, {"box": [0.5, 2]}]},
    "deck": {
        "type": "kinematic",
        "shapes": [{"box": [1, 1]}, {"box": [1, 1], "at": [1, 0]}, {"segment": [[1.5, 0.5], [3, 0.5]]}],
    },
}
entries = st.tuples(st.sampled_from(["tile", "tile", "tile", *sorted(PREFABS)]), st.integers(-5, 5), st.integers(-2, 2))
changes = st.lists(
    st.one_of(st.lists(entries, min_size=1, max_size=6), st.lists(st.integers(0, 50), min_size=1, max_size=4)),
    min_size=1, max_size=8,
)  # fmt: skip


def change(world: World, what: list[Any], turn: int) -> None:
    """Spawn entries, or delete the bodies of those numbers."""
    if isinstance(what[0], int):
        names = sorted({world.names[k % len(world.names)] for k in what}) if world.names else []
        if names:
            world.apply(Delete(names))
        return
    world.apply(
        Spawn([
            {"id": f"{turn}-{k}", "prefab": prefab, "position": [0.5 * x, float(y)]}
            for k, (prefab, x, y) in enumerate(what)
        ])
    )  # fmt: skip


@given(st.lists(entries, max_size=6), changes)
@examples(150)
def test_tables_are_those_of_a_world_from_nothing(begin: list[Any], what: list[Any]) -> None:
    bodies = [{"id": f"{k}", "prefab": name, "position": [0.5 * x, y]} for k, (name, x, y) in enumerate(begin)]
    world = World(sandbox.Scene(prefabs=PREFABS, bodies=bodies))
    for turn, each in enumerate(what):
        change(world, each, turn)
        ours, theirs = tables(world), tables(World(world.flat))
        for name in ("body", "shape", "vertex", "outline", "seam"):
            if name == "body":  # where there were sleepers, newcomers are marked
                ours[name]["posed"] = 0
            assert ours[name].tobytes() == theirs[name].tobytes(), name


def test_many_tiles_are_joined_where_some_come_and_go() -> None:
    floor = [{"id": f"f{k}", "prefab": "tile", "position": [float(k), 0]} for k in range(200)]
    world = World(sandbox.Scene(prefabs=PREFABS, bodies=floor))
    for gone, name in ((["f50", "f51"], "lid"), (["f0"], "other"), ([f"f{k}" for k in range(100, 130)], "third")):
        world.apply(Delete(gone))
        world.apply(Spawn({"id": name, "prefab": "slab", "position": [50.5, 1.0]}))
        ours, theirs = tables(world), tables(World(world.flat))
        assert [ours[table].tobytes() for table in ("shape", "seam")] == [
            theirs[table].tobytes() for table in ("shape", "seam")
        ]
        world.apply(Delete(name))


def restored(world: World, other: World) -> None:
    world.restore(other.snapshot())


def loaded(world: LaneWorld, other: LaneWorld) -> None:
    world.load(other.words, other.contact_words, other.last_switch)


@pytest.mark.parametrize(("kind", "put_back"), [(World, restored), (LaneWorld, loaded)])
def test_tiles_that_are_put_back_are_joined_where_they_are_then(kind: type, put_back: Callable[..., None]) -> None:
    floor = [{"id": f"f{k}", "prefab": "tile", "position": [float(k), 0]} for k in range(100)]
    world, other, fresh = (kind(sandbox.Scene(prefabs=PREFABS, bodies=floor)) for _ in range(3))
    world.apply(SetPose("f10", (10.0, 5.0), 0.0))
    put_back(world, other)
    for each in (world, fresh):
        each.apply(SetPose("f40", (10.0, 1.0), 0.0))
        assert each.state.shapes.traits[10] & SEAMED
    assert world.state.seams.tobytes() == fresh.state.seams.tobytes()
    assert world.state.shapes.tobytes() == fresh.state.shapes.tobytes()


def test_tiles_that_were_moved_are_joined_where_they_are() -> None:
    floor = [{"id": f"f{k}", "prefab": "tile", "position": [float(k), 0]} for k in range(100)]
    world, other = (World(sandbox.Scene(prefabs=PREFABS, bodies=floor)) for _ in range(2))
    for each in (world, other):
        each.apply(SetPose("f10", (10.0, 5.0), 0.0))
    world.apply(Spawn({"id": "lid", "prefab": "tile", "position": [11.0, 5.0]}))
    joined = world.state.shapes.traits & SEAMED
    assert joined[10]
    assert joined[100]
    world.apply(Delete("lid"))
    assert (world.state.shapes.traits == other.state.shapes.traits).all()
    assert not world.state.shapes.traits[10] & SEAMED
    rows = np.flatnonzero(world.state.shapes.traits & SEAMED)
    for row in rows.tolist():
        start = int(world.state.shapes.seam_start[row])
        assert world.state.seams[start : start + 4].tobytes() == other.state.seams[start : start + 4].tobytes()


def test_a_tile_that_lies_alone_joins_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    """So it costs no more to be moved than to find out that it is alone."""
    tiles = [{"id": f"t{k}", "prefab": "tile", "position": [3.0 * k, 0.0]} for k in range(9)]
    world = World(sandbox.Scene(bodies=tiles, prefabs=PREFABS))
    joined: list[int] = []
    real = tiling.join_some
    monkeypatch.setattr(tiling, "join_some", lambda *arguments: (joined.append(len(arguments[4])), real(*arguments)))
    world.apply(SetPose("t4", (13.0, 0.0), 0.1))
    assert joined == []
    world.apply(SetPose("t4", (10.0, 0.0), 0.0))  # beside t3
    assert joined == [2]
    assert (world.state.shapes.traits[[3, 4]] & SEAMED).all()
    world.apply(SetPose("t4", (13.0, 0.0), 0.0))
    assert not (world.state.shapes.traits & SEAMED).any()


BESIDE = {"id": "e", "type": "static", "shapes": [{"box": [4, 1]}], "position": [4, 0]}


@pytest.mark.parametrize(
    ("far", "command"),
    [
        (40.0, SetPose("b", (4.0, 0.0), 0.0)),
        (4.0, SetPose("b", (40.0, 0.0), 0.0)),
        (40.0, Spawn(BESIDE)),
        (4.0, Delete("b")),
    ],
)
def test_who_comes_to_abut_others_collides_as_one_who_does(far: float, command: sandbox.Command) -> None:
    """Also a tile that nobody has touched: a box stands over its end."""
    slab = [{"box": [4, 1]}]
    scene = sandbox.Scene(
        bodies=[
            {"id": "a", "type": "static", "shapes": slab},
            {"id": "box", "shapes": [{"box": [0.5, 0.5]}], "position": [1.9, 0.755], "velocity": [0.5, 0]},
            {"id": "b", "type": "static", "shapes": slab, "position": [far, 0]},
        ]
    )
    world, restored = World(scene), World(scene)
    world.spawn([{"id": f"{k}", "shapes": [{"circle": 0.5}], "position": [90 + 2 * k, 0]} for k in range(2)])
    world.step(3)  # there is room for more rows now
    world.apply(command)
    restored.restore(world.snapshot())
    for _ in range(30):
        world.step()
        restored.step()
        traits = world.scratch.colliders.proxies.traits[: len(world.state.shapes)]
        assert (traits & SEAMED == world.state.shapes.traits & SEAMED).all()
        assert world.snapshot() == restored.snapshot()

"""Snapshots with a few numbers changed and the checksum mended: refused, or the world goes on without a crash."""

from __future__ import annotations

import struct
from contextlib import suppress
from functools import cache
from random import Random
from typing import Any

import numpy as np

from sandbox.engine.world import World
from sandbox.errors import CapacityError, SandboxError, SnapshotError
from sandbox.world.records import TABLES
from sandbox.world.snapshot import checksum
from tests.shipped import shipped

STEPS = {
    "pyramid-10": 90, "gears-and-pulley": 20, "harbour": 60, "rocket": 30, "wrecking-ball": 60, "ragdolls": 60,
    "rolling-hills": 40, "tiles": 50, "tumbler": 5, "zigzag": 60, "wind-tunnel": 20, "planets": 10, "one-way": 30,
    "cantilevers": 10, "bullets": 5,
}  # fmt: skip
"""Scenes with contacts, sleepers, joints, fields, chains, concave shapes and sensors, and when they are taken."""
LATE = {
    "bodies": [
        {"id": "late", "shapes": [{"polygon": [[0, 0], [2, 0], [2, 2], [1, 0.5], [0, 2]]}], "position": [0, 40]},
        {"id": "late-floor", "type": "static", "shapes": [{"box": [4, 1]}], "position": [0, 60]},
    ],
    "joints": [{"id": "late-tie", "type": "weld", "bodies": ["late"], "anchor": [0, 40]}],
}
_HEADER = 20
_WHOLE = [-(1 << 63), -(1 << 31), -2, -1, 0, 1, 2, 3, 63, 64, 65, 1 << 31, 1 << 40, (1 << 53) + 1, 1 << 62]
_REAL = [0.0, -0.0, 5e-324, 1e-308, 1e-9, -1.0, 1.0, 1e9, -1e9, 1e30, 1.7e308, -1.7e308]
_NO_NUMBER = [float("nan"), float("inf"), float("-inf")]


def make(random: Random) -> dict[str, Any]:
    """A scene, and which numbers of its snapshot are changed to what."""
    name, spawned = random.choice(list(STEPS)), random.random() < 0.3
    _, saved, places = _base(name, spawned)
    tables = [table for table in TABLES if places[table.name][1]]
    changes = []
    for _ in range(random.choice((1, 1, 1, 2, 4, 8))):
        table = random.choice(tables)
        fields = [field for field in table.fields if field.kind == "i8"] if random.random() < 0.6 else table.fields
        field = random.choice(fields or table.fields)
        row = random.randrange(places[table.name][1])
        changes.append([table.name, row, field.name, _value(random, field.kind, places)])
    del saved
    return {"scene": name, "spawned": spawned, "changes": changes}


def warm() -> None:
    """Compile and load what cases need."""
    for name in STEPS:
        world, _, _ = _base(name, False)
        _use(world)


def run(case: dict[str, Any]) -> int:
    """Restore it; if it is taken, three steps must come out finite. Returns how many bodies there are."""
    world, saved, places = _base(case["scene"], case["spawned"])
    payload = bytearray(saved[_HEADER:])
    tables = {table.name: table for table in TABLES}
    for name, row, field, number in case["changes"]:
        offset, _ = places[name]
        column = tables[name].dtype.names.index(field)
        place = offset + row * tables[name].dtype.itemsize + 8 * column
        payload[place : place + 8] = struct.pack("<d" if isinstance(number, float) else "<q", number)
    try:
        _try(world, saved, payload)
    except BaseException:
        _base.cache_clear()  # the next case needs a sound world
        raise
    return len(world.state.bodies)


def _try(world: World, saved: bytes, payload: bytearray) -> None:
    before = world.snapshot()
    try:
        world.restore(saved[:12] + checksum(payload) + saved[16:20] + bytes(payload))
    except SnapshotError as error:
        message = str(error)
        assert "\n" not in message
        assert world.snapshot() == before, "a refused snapshot has changed the world"
        return
    try:
        for _ in range(3):
            world.step()
            _use(world)
    except CapacityError:
        pass
    world.restore(saved)
    assert world.snapshot() == saved, "the sound snapshot does not come back"


def _use(world: World) -> None:
    """Ask what people ask of a world."""
    list(world.events)
    with suppress(SandboxError):
        world.query.ray((-20.0, 30.0), (40.0, -35.0))
    for name in ("center_x", "center_y", "velocity_x", "velocity_y", "angular_velocity"):
        assert np.isfinite(world.state.bodies[name]).all(), f"{name} is not finite"


@cache
def _base(name: str, spawned: bool) -> tuple[World, bytes, dict[str, tuple[int, int]]]:
    """A world, its snapshot, and where each table lies in its payload, with how many rows."""
    world = World(shipped(name))
    world.step(STEPS[name])
    if spawned:
        world.delete([body.id for body in world.flat.bodies if body.type == "dynamic"][:1])
        world.spawn(LATE["bodies"], LATE["joints"])
        world.step(3)
    saved = world.snapshot()
    places, offset = {}, 0
    for table in TABLES:
        (count,) = struct.unpack_from("<q", saved, _HEADER + offset)
        places[table.name] = (offset + 8, count)
        offset += 8 + count * table.dtype.itemsize
    return world, saved, places


def _value(random: Random, kind: str, places: dict[str, tuple[int, int]]) -> int | float:
    if kind == "f8":
        return random.choice(_NO_NUMBER) if random.random() < 0.1 else random.choice(_REAL) * random.choice((1, 1, 0.7))
    if random.random() < 0.5:
        count = random.choice([count for _, count in places.values()])
        return count + random.randint(-1, 1)
    return random.choice(_WHOLE) if random.random() < 0.6 else random.randint(-3, 70)

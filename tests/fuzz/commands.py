"""Commands with damaged fields, as files and as Python give them: done, or one error and nothing changed."""

from __future__ import annotations

import dataclasses
from functools import cache
from random import Random
from typing import Any

from sandbox.engine.commands.registry import COMMAND_CLASSES
from sandbox.engine.world import World
from sandbox.errors import CapacityError, SandboxError
from sandbox.replay.recording.command_words import decode
from tests.fuzz.mutations import damaged, value
from tests.fuzz.scenes import check_finite
from tests.shipped import shipped

SCENES = (
    "gears-and-pulley",
    "harbour",
    "rocket",
    "cart",
    "zigzag",
    "seesaw",
    "tetrominoes",
    "pendulums",
    "wind-tunnel",
)
MOST_ROWS = 300
_VECTORS = {"position", "velocity", "point", "force", "impulse", "gravity", "target", "offset", "flow", "wind", "at"}
_PAIRS = [[0.0, 0.0], [1.0, 2.0], [-3.0, 0.5], [1e9, 0.0], [1e300, -1e300], [float("nan"), 0.0], [0.0, float("inf")]]

_LATE = [
    {"id": "late", "shapes": [{"circle": 0.5}], "position": [0, 30]},
    {"id": "later", "type": "static", "shapes": [{"box": [1, 1]}], "position": [3, 30]},
    {"id": "star", "shapes": [{"polygon": [[0, 0], [2, 0], [2, 2], [1, 0.5], [0, 2]]}], "position": [6, 30]},
]
_TIES = [{"id": "tie", "type": "weld", "bodies": ["late", "later"], "anchor": [1, 30]}]


def warm() -> None:
    """Compile and load what cases need."""
    for name in SCENES:
        world, _ = _base(name)
        world.spawn(_LATE, _TIES)
        world.step(2)
    _base.cache_clear()


def make(random: Random) -> dict[str, Any]:
    """A scene and what is done to it: steps, and commands by name and fields."""
    name = random.choice(SCENES)
    world, _ = _base(name)
    todo: list[Any] = []
    for _ in range(random.randint(1, 6)):
        kind = random.choice(list(COMMAND_CLASSES))
        fields = [field.name for field in dataclasses.fields(COMMAND_CLASSES[kind])]
        given = {field: _given(random, world, field) for field in fields if random.random() < 0.8}
        if kind == "Spawn":
            given["bodies"] = damaged(random, _LATE) if random.random() < 0.6 else _LATE
        todo.append([kind, damaged(random, given) if random.random() < 0.3 else given, random.random() < 0.5])
        if random.random() < 0.4:
            todo.append(random.choice((1, 1, 3)))
    return {"scene": name, "todo": todo}


def run(case: dict[str, Any]) -> int:
    """Do it; returns how many bodies and joints there are."""
    world, saved = _base(case["scene"])
    try:
        world.restore(saved)
        for what in case["todo"]:
            _do(world, what)
        world.step(2)
        check_finite(world)
    except CapacityError:
        pass
    except BaseException:
        _base.cache_clear()
        raise
    return len(world.state.bodies) + len(world.state.joints)


def _do(world: World, what: Any) -> None:
    if isinstance(what, int):
        if len(world.state.shapes) < MOST_ROWS:
            world.step(what)
        return
    kind, given, as_file = what
    before = world.digest()
    try:
        if as_file:
            found, wrong = decode([0, kind, given], ("commands", 0))
            assert (found is None) == bool(wrong)
            command = found[1] if found else None
        else:
            command = COMMAND_CLASSES[kind](**given)
    except TypeError:  # Python's own: fields that are missing or that there are not
        return
    if command is not None:
        refused = ""
        try:
            world.apply(command)
        except SandboxError as error:
            refused = str(error) or "no words"
        assert len(refused) < 60_000
        assert not refused or world.digest() == before, f"{kind} was refused and has changed the world: {refused}"


def _given(random: Random, world: World, field: str) -> Any:
    """A value that may do for a field, or not."""
    if random.random() < 0.1:
        return value(random)
    if field in ("body", "bodies") and random.random() < 0.9:
        return random.choice([*world.names, "late", "nobody"]) if field == "body" else [random.choice(world.names)]
    if field == "joint":
        return random.choice([*world.joint_names, "tie", "nobody"])
    if field == "region":
        return random.choice([*(region.id for region in world.flat.regions), "nowhere"])
    if field == "joints":
        return damaged(random, _TIES) if random.random() < 0.5 else []
    if field in _VECTORS:
        return random.choice(_PAIRS)
    return random.choice([0.0, 1.0, -1.0, 0, 1, 2.5, 100.0, 1e-9, 1e7, 1e300, True, None])


@cache
def _base(name: str) -> tuple[World, bytes]:
    world = World(shipped(name))
    world.step(5)
    return world, world.snapshot()

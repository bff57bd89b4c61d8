"""What can be collected from a world: a registry of readings, each of one number or of two."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from sandbox.engine.world import World
from sandbox.world.records import DYNAMIC

Numbers: TypeAlias = tuple[float, ...]
Read: TypeAlias = Callable[[Any], Numbers]


@dataclass(frozen=True)
class Reading:
    """How something is read of a body, a joint or a world, and what its parts are called: ("x", "y") or ("",)."""

    read: Read
    parts: tuple[str, ...] = ("",)


def _number(name: str) -> Reading:
    return Reading(lambda thing: (float(getattr(thing, name)),))


def _vector(name: str) -> Reading:
    return Reading(lambda thing: tuple(getattr(thing, name)), ("x", "y"))


def _speed(body: Any) -> Numbers:
    return (float(np.hypot(*body.velocity)),)


BODY: Mapping[str, Reading] = {
    "position": _vector("position"),
    "x": Reading(lambda body: (body.position[0],)),
    "y": Reading(lambda body: (body.position[1],)),
    "angle": _number("angle"),
    "velocity": _vector("velocity"),
    "speed": Reading(_speed),
    "angular_velocity": _number("angular_velocity"),
    "center": _vector("center"),
    "mass": _number("mass"),
    "awake": _number("awake"),
}
"""Of a body: m, rad, m/s, rad/s, kg; `speed` is that of the centre of mass, `x` and `y` the position's."""

JOINT: Mapping[str, Reading] = {
    "force": _vector("force"),
    "torque": _number("torque"),
    "angle": _number("angle"),
    "translation": _number("translation"),
    "broken": _number("broken"),
}
"""Of a joint: N and N m over the last step, rad, m."""


def energy(world: World) -> Numbers:
    """Kinetic and potential energy of the dynamic bodies, J; zero at rest at the world's origin."""
    rows = world.state.bodies[world.state.bodies.type == DYNAMIC]
    kinetic = 0.5 * (rows["mass"] * (rows["velocity_x"] ** 2 + rows["velocity_y"] ** 2))
    turning = 0.5 * (rows["inertia"] * rows["angular_velocity"] ** 2)
    gravity = world.gravity
    lift = rows["mass"] * rows["gravity_scale"] * (gravity[0] * rows["center_x"] + gravity[1] * rows["center_y"])
    return (float((kinetic + turning - lift).sum()),)


def _outcome(world: World) -> Numbers:
    ending = world.outcome
    return (0.0 if ending is None else 1.0 if ending.result == "won" else -1.0,)


WORLD: Mapping[str, Reading] = {
    "energy": Reading(energy),
    "contacts": Reading(lambda world: (float(np.count_nonzero(world.contacts.touching)),)),
    "awake": _number("awake_count"),
    "bodies": Reading(lambda world: (float(len(world.bodies)),)),
    "frozen": Reading(lambda world: (float(len(world.frozen)),)),
    "outcome": Reading(_outcome),
    "time": _number("time"),
}
"""Of a world: `contacts` that touch, bodies `awake`, all `bodies`, those `frozen` for bad numbers; `outcome` is 1 for
won, -1 for lost, 0 while it is open; `time` in s."""


def counter(name: str) -> Reading:
    """The counter of that name."""
    return Reading(lambda world: (float(world.counters[name]),))

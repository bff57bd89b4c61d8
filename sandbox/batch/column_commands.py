"""Commands to one body of many worlds by columns: what `ApplyForce`, `SetPose` and `SetVelocity` do, in one go.

A world in which somebody sleeps, or which is apart, gets the command itself: those bits are the measure of these.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from sandbox._jit import interpreted
from sandbox.arguments import shown
from sandbox.batch.fleet import Fleet
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.checks import LIMITS
from sandbox.engine.commands.motion import SetPose, SetVelocity
from sandbox.engine.commands.pushes import ApplyForce
from sandbox.errors import ArgumentError
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Floats, Integers
from sandbox.world.records import DYNAMIC

Write: TypeAlias = Callable[[Any, Integers, Any], None]
"""Writes into the columns of a body, at some worlds, what those of the arguments say that are chosen."""
_cos_sin = interpreted(cos_sin)


def push(fleet: Fleet, body: tuple[str, int], forces: Floats, torques: Floats, worlds: Integers) -> None:
    """Push a body, given by id and row: `forces` (worlds, 2) in N, `torques` (worlds,) in N m."""

    def write(one: Any, at: Integers, chosen: Any) -> None:
        one["force_x"][at] += forces[chosen, 0]
        one["force_y"][at] += forces[chosen, 1]
        one["torque"][at] += torques[chosen]

    def command(k: int) -> Command:
        return ApplyForce(body[0], _pair(forces, k), float(torques[k]))

    _apply(fleet, body[1], worlds, write, command)


def pose(fleet: Fleet, body: tuple[str, int], positions: Floats, angles: Floats, worlds: Integers) -> None:
    """Put a body, given by id and row: `positions` (worlds, 2) in m, `angles` (worlds,) in rad."""

    def write(one: Any, at: Integers, chosen: Any) -> None:
        x, y = one["local_center_x"][at], one["local_center_y"][at]
        c, s = np.array([_cos_sin(angle) for angle in angles[chosen].tolist()]).reshape(-1, 2).T
        one["posed"][at] = 1
        one["angle"][at], one["rotation_cos"][at], one["rotation_sin"][at] = angles[chosen], c, s
        one["center_x"][at] = positions[chosen, 0] + (c * x - s * y)
        one["center_y"][at] = positions[chosen, 1] + (s * x + c * y)
        one["position_x"][at] = one["center_x"][at] - (c * x - s * y)
        one["position_y"][at] = one["center_y"][at] - (s * x + c * y)

    def command(k: int) -> Command:
        return SetPose(body[0], _pair(positions, k), float(angles[k]))

    _apply(fleet, body[1], worlds, write, command)


def velocity(fleet: Fleet, body: tuple[str, int], velocities: Floats, rates: Floats, worlds: Integers) -> None:
    """Give a body, told by id and row, `velocities` (worlds, 2) in m/s and `rates` (worlds,) in rad/s."""

    def write(one: Any, at: Integers, chosen: Any) -> None:
        one["velocity_x"][at], one["velocity_y"][at] = velocities[chosen, 0], velocities[chosen, 1]
        one["angular_velocity"][at] = rates[chosen]

    def command(k: int) -> Command:
        return SetVelocity(body[0], _pair(velocities, k), float(rates[k]))

    _apply(fleet, body[1], worlds, write, command)


def numbers(call: str, field: str, value: Any, shape: tuple[int, ...]) -> Floats:
    """`value` as numbers of that shape, one for all repeated, within the limits of the `field` of a command.

    Raises `ArgumentError`.
    """
    try:
        given = np.asarray(value, np.float64)
        found: Floats = np.broadcast_to(given, shape)
    except (TypeError, ValueError, OverflowError):
        sizes = " x ".join(map(str, shape))
        raise ArgumentError(f"{call}: {field} takes {sizes} numbers, or one for all, not {shown(value)}") from None
    limit = LIMITS.get(field, math.inf)
    if not np.isfinite(given).all() or (np.abs(given) > limit).any():
        most = "" if math.isinf(limit) else f" up to {limit:g}"
        raise ArgumentError(f"{call}: {field} takes finite numbers{most}")
    return found


def _apply(fleet: Fleet, row: int, worlds: Integers, write: Write, command: Callable[[int], Command]) -> None:
    """Write at once where that is all there is to it, and apply the command elsewhere."""
    bodies, counters = (fleet.layout.columns(fleet.rows.words, name) for name in ("bodies", "counters"))
    simple = _are_simple(fleet, bodies, row, worlds)
    at, one = worlds[simple], bodies[:, row]
    write(one, at, simple)
    one["sleep_time"][at] = 0.0
    counters["still"][at, 0] = counters["substep_watch"][at, 0] = 0
    for k in np.flatnonzero(~simple).tolist():
        fleet.apply(int(worlds[k]), command(k))


def _are_simple(fleet: Fleet, bodies: Any, row: int, worlds: Integers) -> Any:
    """The worlds that are rows, each once, in which the body is dynamic and nobody sleeps who could be woken."""
    one = bodies[worlds, row]
    awake = (one["awake"] == 1) & (one["type"] == DYNAMIC) & (bodies["island"][worlds] == 0).all(axis=1)
    first = np.zeros(len(worlds), np.bool_)
    first[np.unique(worlds, return_index=True)[1]] = True
    rows = ~np.isin(worlds, list(fleet.apart)) if fleet.apart else True
    return awake & first & rows


def _pair(values: Floats, k: int) -> tuple[float, float]:
    return float(values[k, 0]), float(values[k, 1])

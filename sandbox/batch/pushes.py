"""Forces on one body of many worlds, by columns: what the command `ApplyForce` does to each, in one go."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.arguments import shown
from sandbox.batch.fleet import Fleet
from sandbox.engine.commands.pushes import ApplyForce
from sandbox.errors import ArgumentError
from sandbox.tables import Floats, Integers
from sandbox.world.records import DYNAMIC


def push(fleet: Fleet, body: str, row: int, forces: Floats, torques: Floats, worlds: Integers) -> None:
    """Push a body in each of `worlds`: `forces` (worlds, 2) in N, `torques` (worlds,) in N m."""
    bodies, counters = (fleet.layout.columns(fleet.rows.words, name) for name in ("bodies", "counters"))
    simple = _are_simple(fleet, bodies, row, worlds)
    at = worlds[simple]
    one = bodies[:, row]
    one["force_x"][at] += forces[simple, 0]
    one["force_y"][at] += forces[simple, 1]
    one["torque"][at] += torques[simple]
    one["sleep_time"][at] = 0.0
    counters["still"][at, 0] = counters["substep_watch"][at, 0] = 0
    for k in np.flatnonzero(~simple).tolist():
        command = ApplyForce(body, (float(forces[k, 0]), float(forces[k, 1])), float(torques[k]))
        fleet.change(int(worlds[k]), lambda world, command=command: world.apply(command))  # type: ignore[misc]


def numbers(call: str, value: Any, shape: tuple[int, ...], unit: str) -> Floats:
    """`value` as finite numbers of that shape, repeated where it has fewer dimensions. Raises `ArgumentError`."""
    try:
        found: Floats = np.broadcast_to(np.asarray(value, np.float64), shape)
    except (TypeError, ValueError):
        sizes = " x ".join(map(str, shape))
        raise ArgumentError(f"{call}: takes {sizes} numbers ({unit}), not {shown(value)}") from None
    if not np.isfinite(found).all():
        raise ArgumentError(f"{call}: takes finite numbers ({unit})")
    return found


def _are_simple(fleet: Fleet, bodies: Any, row: int, worlds: Integers) -> Any:
    """The worlds that are rows and in which nobody sleeps, so that the push wakes nobody."""
    rows = ~np.isin(worlds, list(fleet.apart)) if fleet.apart else np.full(len(worlds), True)
    one = bodies[worlds, row]
    awake = (one["awake"] == 1) & (one["type"] == DYNAMIC) & (bodies["island"][worlds] == 0).all(axis=1)
    return rows & awake

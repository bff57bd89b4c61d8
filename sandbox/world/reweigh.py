"""Other densities for the shapes of a body that is there: mass, inertia, and all that is measured from its centre."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from sandbox.scene.solidity import faults
from sandbox.tables import Integers, as_table, plain
from sandbox.world.body_rows import body_rows
from sandbox.world.contact_rows import contacts_of
from sandbox.world.records import DYNAMIC

if TYPE_CHECKING:
    from sandbox.world.state import State

_WEIGHT = ("mass", "inertia", "inverse_mass", "inverse_inertia")


def reweigh(state: State, index: int, first: int, densities: Sequence[float]) -> str | None:
    """Give the shapes of body `index`, which lie from row `first` on, those densities (kg/m^2), as if it had been built
    with them at its pose of now.

    Its origin stays where it is, and its points keep their velocities. If no body could be so, it says why and changes
    nothing.
    """
    old = state.census.bodies.items[index]
    body = replace(old, shapes=state.patterns.weighed(old.shapes, tuple(densities)))
    fault = next(iter(faults({**vars(body), "velocity": (0.0, 0.0), "angular_velocity": 0.0})), None)
    if fault is not None:
        return f"{fault[0]}: {fault[1]}"
    bodies, fresh_shapes, vertices, outlines, _ = body_rows((body,), state.patterns)
    row, fresh_row = state.bodies[index], as_table(bodies)[0]
    _move_center(state, index, row, fresh_row)
    for name in _WEIGHT if row.type == DYNAMIC else ():
        row[name] = fresh_row[name]
    shapes = plain(state.shapes)[first : first + len(densities)]
    shapes["density"] = densities
    for shape, fresh in zip(shapes, fresh_shapes, strict=True):
        _copy(state.vertices, shape["vertex_start"], vertices, fresh["vertex_start"], shape["vertex_count"])
        _copy(state.outlines, shape["outline_start"], outlines, fresh["outline_start"], shape["outline_count"])
    state.layout += 1  # pictures and queries measure from the centre, too
    return None


def _copy(table: Any, start: int, source: Any, first: int, count: int) -> None:
    plain(table)[start : start + count] = source[first : first + count]


def _move_center(state: State, index: int, row: Any, fresh: Any) -> None:
    """Put the centre of mass to its new place, and measure from there what hangs on the body."""
    cx, cy = fresh.local_center_x, fresh.local_center_y
    x, y = cx - row.local_center_x, cy - row.local_center_y
    for table in map(plain, (state.thrusters, state.drags)):
        _shift(table, np.flatnonzero(table["body"] == index), "local_", "", x, y)
    joints = plain(state.joints)
    for side in "ab":
        _shift(joints, np.flatnonzero(joints[f"body_{side}"] == index), f"anchor_{side}", "", x, y)
    c, s = float(row.rotation_cos), float(row.rotation_sin)
    dx, dy = c * x - s * y, s * x + c * y
    contacts, count = plain(state.contacts), int(plain(state.counters)["contact_count"][0])
    near = contacts_of(state.contacts, count, np.array([index]), state.resting)
    for side in "ab":
        own = near[contacts[f"body_{side}"][near] == index]
        for point in "12":
            _shift(contacts, own, f"anchor_{side}", point, dx, dy)
    row.local_center_x, row.local_center_y = cx, cy
    row.center_x, row.center_y = row.position_x + (c * cx - s * cy), row.position_y + (s * cx + c * cy)
    row.velocity_x, row.velocity_y = (
        row.velocity_x - row.angular_velocity * dy,
        row.velocity_y + row.angular_velocity * dx,
    )
    row.extent = fresh.extent


def _shift(table: Any, rows: Integers, column: str, point: str, x: float, y: float) -> None:
    """Measure places from a point that is (x, y) farther."""
    if len(rows):
        table[f"{column}x{point}"][rows] -= x
        table[f"{column}y{point}"][rows] -= y

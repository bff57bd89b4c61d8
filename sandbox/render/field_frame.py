"""The regions that act in a frame, and the thrusters that burn."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sandbox.render.camera import Floats
from sandbox.world.state import State


@dataclass(frozen=True)
class RegionMark:
    """One region that acts: its `kind`, the half-planes (k, 3) it lies in (unit normal, offset), its `disc` (x, y,
    radius; 0 for none), all in metres, and the velocity (2,) of what flows in it, m/s.
    """

    kind: int
    edges: Floats
    disc: Floats
    flow: Floats


@dataclass(frozen=True)
class FieldMarks:
    """What of the fields is to be seen. `flames` (k, 4): where a thruster pushes, m, and the unit way its jet goes."""

    regions: tuple[RegionMark, ...] = ()
    flames: Floats = field(default_factory=lambda: np.zeros((0, 4)))


def capture_fields(state: State) -> FieldMarks:
    """The fields of the coming step."""
    if len(state.regions) == 0 and len(state.thrusters) == 0:
        return FieldMarks()
    step = int(state.counters[0].step_count)
    return FieldMarks(_regions(state, step), _flames(state, step))


def region_mark(state: State, number: int) -> RegionMark:
    """The region of that row, whether it acts or not."""
    row: Any = state.regions[number]
    edges: Any = state.edges[row.first_edge : row.first_edge + row.edge_count]
    return RegionMark(
        int(row.kind),
        np.column_stack([edges.normal_x, edges.normal_y, edges.offset]),
        np.array([row.disc_x, row.disc_y, row.disc_radius]),
        np.array([row.flow_x, row.flow_y]),
    )


def _regions(state: State, step: int) -> tuple[RegionMark, ...]:
    acting = np.flatnonzero((state.regions.start_step <= step) & (step < state.regions.end_step))
    return tuple(region_mark(state, row) for row in acting.tolist())


def _flames(state: State, step: int) -> Floats:
    thrusters, bodies = state.thrusters, state.bodies
    burning = np.flatnonzero((thrusters.start_step <= step) & (step < thrusters.end_step))
    index = thrusters.body[burning]
    c, s = bodies.rotation_cos[index], bodies.rotation_sin[index]
    x, y = thrusters.local_x[burning], thrusters.local_y[burning]
    fx, fy = thrusters.force_x[burning], thrusters.force_y[burning]
    size = np.maximum(np.hypot(fx, fy), 1e-300)
    flames: Floats = np.column_stack(
        [
            bodies.center_x[index] + c * x - s * y, bodies.center_y[index] + s * x + c * y,
            -(c * fx - s * fy) / size, -(s * fx + c * fy) / size,
        ]
    )  # fmt: skip
    return flames

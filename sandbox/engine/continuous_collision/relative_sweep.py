"""The relative sweep of two bodies through a step, and its time of impact."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.broad_phase.margins import allowed_depth
from sandbox.engine.records.ccd import Ccd
from sandbox.geometry.core import core_of
from sandbox.geometry.time_of_impact import time_of_impact
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC


class SweepTables(NamedTuple):
    """What sweeps are made of: bodies at the end of the step, `cores` at its beginning, `motions` lie between. A metre
    is so many units of length."""

    bodies: Records
    shapes: Records
    motions: Records
    cores: Records
    ccd_bodies: Records
    ccd: Ccd
    units_per_meter: float


class Interval(NamedTuple):
    """When the sweeps of two bodies begin and end, as shares of the step."""

    start_a: float
    start_b: float
    end_a: float
    end_b: float


@kernel
def set_relative_sweep(tables: SweepTables, a: int, b: int, interval: Interval) -> None:
    """Lay the relative sweep of bodies a and b, each between two times of the step, into `ccd.sweep`."""
    s = tables.ccd.sweep[0]
    motion_a = tables.motions[a]
    motion_b = tables.motions[b]
    x = tables.bodies[b].center_x - tables.bodies[a].center_x
    y = tables.bodies[b].center_y - tables.bodies[a].center_y
    back_a = 1.0 - interval.start_a
    back_b = 1.0 - interval.start_b
    s.x = x - back_b * motion_b.delta_x + back_a * motion_a.delta_x
    s.y = y - back_b * motion_b.delta_y + back_a * motion_a.delta_y
    long_a = interval.end_a - interval.start_a
    long_b = interval.end_b - interval.start_b
    s.translation_x = long_b * motion_b.delta_x - long_a * motion_a.delta_x
    s.translation_y = long_b * motion_b.delta_y - long_a * motion_a.delta_y
    s.angle_a = interval.start_a * motion_a.delta_angle
    s.angle_b = interval.start_b * motion_b.delta_angle
    s.rotation_a = long_a * motion_a.delta_angle
    s.rotation_b = long_b * motion_b.delta_angle


@kernel
def sweep_time_of_impact(tables: SweepTables, i: int, j: int) -> float:
    """When shapes i and j touch on the sweep laid in `ccd.sweep`, as a share of it; -1 if they do not."""
    a = tables.shapes[i]
    b = tables.shapes[j]
    sweep = tables.ccd.sweep
    sweep[0].deep = allowed_depth(a, b, tables.units_per_meter)
    sweep[0].thin = a.thin + b.thin
    dynamic_a = tables.bodies[a.body].type == DYNAMIC
    sweep[0].half = a.thin if dynamic_a else b.thin
    sweep[0].yields = 1 if dynamic_a and tables.bodies[b.body].type == DYNAMIC else 0
    t = time_of_impact(tables.cores, core_of(a), core_of(b), sweep, tables.ccd.posed, tables.ccd.manifold)
    return float(t)

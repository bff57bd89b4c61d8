"""The impact of a fast body at one that stays where it is."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.broad_phase.margins import allowed_depth
from sandbox.engine.continuous_collision.center_sweep import sweep_center
from sandbox.engine.continuous_collision.contact_impulse import record_impact
from sandbox.engine.continuous_collision.hit import list_hit
from sandbox.engine.continuous_collision.relative_sweep import (
    Interval,
    SweepTables,
    set_relative_sweep,
    sweep_time_of_impact,
)
from sandbox.engine.narrow_phase.one_way import front_side, holds, leads_on
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, SEAMED, STATIC


@kernel
def stop_at_static(tables: SweepTables, pair: Records, round: int) -> bool:
    """Stop the fast body of a pair at the other one, if that is immovable and it is swept in this round; whether the
    pair is for `stop_bullets`."""
    sweep = tables.ccd.sweep[0]
    a = tables.shapes[pair.shape_a].body
    b = tables.shapes[pair.shape_b].body
    if tables.ccd_bodies[a].fast + tables.ccd_bodies[b].fast == 0:
        return False
    if tables.bodies[a].type != STATIC and tables.bodies[b].type != STATIC:
        meets = tables.bodies[a].bullet + tables.bodies[b].bullet > 0
        if meets:
            list_hit(tables.ccd, a)
            list_hit(tables.ccd, b)
        return bool(meets)
    mover = b if tables.bodies[a].type == STATIC else a
    if tables.ccd.impacts[mover].round != round:
        return False
    set_relative_sweep(tables, a, b, Interval(0.0, 0.0, 1.0, 1.0))
    t = _time_of_stop(tables, pair.shape_a, pair.shape_b, mover == b)
    if t >= 0.0 and t < tables.ccd.impacts[mover].time:
        list_hit(tables.ccd, mover)
        tables.ccd.impacts[mover].time = t
        shape_a = tables.shapes[pair.shape_a]
        shape_b = tables.shapes[pair.shape_b]
        record_impact(tables.ccd.impacts[mover], sweep, shape_a, shape_b, mover == b, t)
    return False


@kernel
def _time_of_stop(tables: SweepTables, i: int, j: int, second: bool) -> float:
    """When the sweep of two shapes that is laid in `ccd.sweep` is to stop, as a share of the step; -1 if it is not.

    `second` if it is shape j that moves, and shape i that is static.
    """
    sweep = tables.ccd.sweep[0]
    a = tables.shapes[i]
    b = tables.shapes[j]
    one_way = (a.traits | b.traits) & ONE_WAY > 0
    # What is caught may sink on.
    slop = 2.0 * allowed_depth(a, b, tables.units_per_meter)
    way_x = sweep.translation_x
    way_y = sweep.translation_y
    held = True
    if one_way:
        held = holds(tables.bodies, tables.shapes, tables.cores, i, j, sweep.x, sweep.y, way_x, way_y, slop)
    t = sweep_time_of_impact(tables, i, j) if held else -1.0
    if t >= 0.0 and one_way and not leads_on(tables.bodies, tables.shapes, i, j, sweep.normal_x, sweep.normal_y):
        t = -1.0
    line = a if second else b
    shape = b if second else a
    front = front_side(tables.bodies[line.body], line, tables.cores) if line.vertex_count == 2 else 0
    if line.vertex_count != 2 or shape.thin == 0.0 or not (held or (front != 0 and line.traits & SEAMED)):
        return float(t)
    center = sweep_center(tables, line, shape, second, front, t if t >= 0.0 else 1.0)
    return float(center if center >= 0.0 else t)

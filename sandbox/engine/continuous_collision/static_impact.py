"""The impact of a fast body at one that stays where it is."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.broad_phase.margins import allowed_depth
from sandbox.engine.continuous_collision.contact_impulse import record_impact
from sandbox.engine.continuous_collision.relative_sweep import (
    Interval,
    SweepTables,
    set_relative_sweep,
    sweep_time_of_impact,
)
from sandbox.engine.narrow_phase.one_way import comes_from_front
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, STATIC


@kernel
def stop_at_static(tables: SweepTables, pair: Records) -> int:
    """Stop the fast body of a pair at the other one, if that is immovable; 1 if the pair is for `stop_bullet`."""
    sweep = tables.ccd.sweep[0]
    a = tables.shapes[pair.shape_a].body
    b = tables.shapes[pair.shape_b].body
    if tables.ccd.bodies[a].fast + tables.ccd.bodies[b].fast == 0:
        return 0
    if tables.bodies[a].type != STATIC and tables.bodies[b].type != STATIC:
        return int(tables.bodies[a].bullet + tables.bodies[b].bullet > 0)
    mover = b if tables.bodies[a].type == STATIC else a
    set_relative_sweep(tables, a, b, Interval(0.0, 0.0, 1.0, 1.0))
    if (tables.shapes[pair.shape_a].traits | tables.shapes[pair.shape_b].traits) & ONE_WAY:
        # What is caught may sink on.
        slop = 2.0 * allowed_depth(tables.shapes[pair.shape_a], tables.shapes[pair.shape_b])
        if not comes_from_front(
            tables.bodies, tables.shapes, tables.cores, pair.shape_a, pair.shape_b, sweep.x, sweep.y, slop
        ):
            return 0
    t = sweep_time_of_impact(tables, pair.shape_a, pair.shape_b)
    if t >= 0.0 and t < tables.ccd.impacts[mover].time:
        tables.ccd.impacts[mover].time = t
        shape_a = tables.shapes[pair.shape_a]
        shape_b = tables.shapes[pair.shape_b]
        record_impact(tables.ccd.impacts[mover], sweep, shape_a, shape_b, mover == b, t)
    return 0

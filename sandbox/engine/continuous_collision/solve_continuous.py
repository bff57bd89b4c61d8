"""Stage: continuous collision. What would have come out on the other side is stopped at its time of impact.

The solver stops what the narrow phase has foreseen. What it could not foresee (a spinning rod, a body that another
one shot off in mid-step, a press of contacts that disagree) is caught here: each body whose displacement in the step
was long enough to matter is swept along it, and stopped where it first touches if it would have come through, or deep
into, something immovable. It keeps its velocity, but for what gravity added on the part that is rolled back, so that
the next step finds it touching and does the bounce, at the energy that belongs to the height.
Static bodies hold all dynamic ones, moving bodies hold only those marked as bullets.
"""

from __future__ import annotations

from sandbox._jit import entry_point, kernel
from sandbox.engine.broad_phase.grid import boxes_overlap
from sandbox.engine.broad_phase.margins import allowed_depth
from sandbox.engine.broad_phase.pairs import propose
from sandbox.engine.broad_phase.proxies import ACTIVE, SLEEPS
from sandbox.engine.continuous_collision.bullets import carry_bullet, stop_bullet
from sandbox.engine.continuous_collision.contact_impulse import apply_contact_impulse, record_impact
from sandbox.engine.continuous_collision.relative_sweep import (
    Interval,
    SweepTables,
    set_relative_sweep,
    sweep_time_of_impact,
)
from sandbox.engine.continuous_collision.roll_back import roll_back, roll_back_energy
from sandbox.engine.joints.pair_filter import JointFilter, are_joined
from sandbox.engine.narrow_phase.one_way import comes_from_front
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.ccd import Ccd
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.engine.records.state import StateTables
from sandbox.geometry.bounds import core_bounds
from sandbox.geometry.core import core_of
from sandbox.tables import Integers, Records
from sandbox.world.records import ONE_WAY, STATIC


@entry_point
def solve_continuous(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    colliders: Colliders,
    grid: Grid,
    ccd: Ccd,
    joint_filter: JointFilter,
) -> None:
    """Roll the bodies that `mark_fast` marked back to where they first touch what they may not pass.

    The bodies are at the end of the step, cores and boxes of its beginning, the motions lie between.
    """
    tables = SweepTables(state.bodies, state.shapes, solver.motions, colliders.cores, ccd)
    fast = grid.sorted_pairs
    rows = active.bodies[1 : 1 + active.bodies[0]]
    count = _list_fast(ccd.bodies, colliders.filters, grid.pairs, state.counters[0].pair_count, fast)
    _forget_impacts(colliders.filters, rows, ccd.impacts, fast, count)
    for k in range(count):
        carry_bullet(tables, fast[k])
    bullets = 0
    for k in range(count):
        bullets += _stop_at_static(tables, fast[k])
    _stop_strays(tables, active, colliders, fast, count, joint_filter)
    changed = bullets > 0
    turn = 0
    while changed:
        changed = False
        for k in range(count):
            if stop_bullet(tables, fast[k], turn):
                changed = True
        turn += 1
    _roll_back_all(state, rows, solver.motions, ccd.impacts)


@kernel
def _stop_strays(
    tables: SweepTables,
    active: ActiveSet,
    colliders: Colliders,
    fast: Records,
    count: int,
    joint_filter: JointFilter,
) -> None:
    """Stop the fast shapes that have left the box which the grid knew: at what is not among their pairs.

    `fast[count]` is scratch.
    """
    boxes = colliders.boxes
    filters = colliders.filters
    shape_count = tables.shapes.shape[0]
    info = active.info[0]
    known = info.shapes_generation == info.generation  # otherwise somebody has woken in this step
    for k in range(info.moving if known else shape_count):
        i = active.shapes[k]
        if tables.ccd.bodies[filters[i].body].fast == 0:
            continue
        woke = filters[i].moves == SLEEPS  # the grid has asked for no pairs of sleepers with what does not move
        filters[i].moves = ACTIVE
        if _strays(tables, boxes, i) or woke:
            for j in range(shape_count):
                if not boxes_overlap(boxes[i], boxes[j]) or are_joined(joint_filter, filters[i].body, filters[j].body):
                    continue
                if propose(filters, i, j, fast, count) > count:
                    _stop_at_static(tables, fast[count])


@kernel
def _roll_back_all(state: StateTables, rows: Integers, motions: Records, impacts: Records) -> None:
    """Roll all bodies back to their times of impact."""
    for i in rows:
        body = state.bodies[i]
        impact = impacts[i]
        if impact.time < 1.0:
            share = 1.0 - impact.time
            roll_back(body, motions[i], share)
            if impact.bounces == 1:
                roll_back_energy(body, motions[i], share, state.settings[0])
            if impact.touched == 1:
                apply_contact_impulse(body, impact, state.settings[0].restitution_threshold)


@kernel
def _forget_impacts(filters: Records, rows: Integers, impacts: Records, fast: Records, count: int) -> None:
    """Nobody is stopped yet: neither those that move, nor the sleepers that something fast may meet."""
    for i in rows:
        _forget_impact(impacts[i])
    for k in range(count):
        _forget_impact(impacts[filters[fast[k].shape_a].body])
        _forget_impact(impacts[filters[fast[k].shape_b].body])


@kernel
def _forget_impact(impact: Records) -> None:
    impact.time = 1.0
    impact.bounces = impact.touched = 0


@kernel
def _list_fast(ccd_bodies: Records, filters: Records, pairs: Records, pair_count: int, fast: Records) -> int:
    """List the pairs of which a body is fast, in order; return how many. The rest of the table stays free for one."""
    count = 0
    for k in range(pair_count):
        if ccd_bodies[filters[pairs[k].shape_a].body].fast + ccd_bodies[filters[pairs[k].shape_b].body].fast > 0:
            fast[count] = pairs[k]
            count += 1
    return count


@kernel
def _strays(tables: SweepTables, boxes: Records, i: int) -> bool:
    """Whether a shape has left the box that the grid knew: its box becomes that of its true displacement then."""
    shape = tables.shapes[i]
    body = tables.bodies[shape.body]
    motion = tables.motions[shape.body]
    swing = abs(motion.delta_angle)
    grow = shape.radius + body.extent * (swing if swing < 2.0 else 2.0)
    lower_x, lower_y, upper_x, upper_y = core_bounds(tables.cores, core_of(shape))
    dx = motion.delta_x
    dy = motion.delta_y
    lower_x = body.center_x + lower_x - grow - (dx if dx > 0.0 else 0.0)
    lower_y = body.center_y + lower_y - grow - (dy if dy > 0.0 else 0.0)
    upper_x = body.center_x + upper_x + grow - (dx if dx < 0.0 else 0.0)
    upper_y = body.center_y + upper_y + grow - (dy if dy < 0.0 else 0.0)
    box = boxes[i]
    inside_x = lower_x >= box.lower_x and upper_x <= box.upper_x
    if inside_x and lower_y >= box.lower_y and upper_y <= box.upper_y:
        return False
    box.lower_x = lower_x
    box.lower_y = lower_y
    box.upper_x = upper_x
    box.upper_y = upper_y
    return True


@kernel
def _stop_at_static(tables: SweepTables, pair: Records) -> int:
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

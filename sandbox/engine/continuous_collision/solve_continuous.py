"""Stage: continuous collision. What would have come out on the other side is stopped at its time of impact.

The solver stops what the narrow phase has foreseen. What it could not foresee (a spinning rod, a body that another
one shot off in mid-step, a press of contacts that disagree) is caught here: each body whose displacement in the step
was long enough to matter is swept along it, and stopped where it first touches if it would have come through, or deep
into, something immovable. It keeps its velocity, but for what gravity added on the part that is rolled back, so that
the next step finds it touching and does the bounce, at the energy that belongs to the height.
Static bodies hold all dynamic ones, moving bodies hold only those marked as bullets.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import entry_point, kernel
from sandbox.engine.active.active_set import AWAKE
from sandbox.engine.broad_phase.proxies import BULLET, FIXED
from sandbox.engine.contact_solver.closing_speed import bounce_threshold
from sandbox.engine.continuous_collision.bullets import carry_bullet, stop_bullets
from sandbox.engine.continuous_collision.contact_impulse import strike_static
from sandbox.engine.continuous_collision.hit import forget_hits
from sandbox.engine.continuous_collision.relative_sweep import SweepTables
from sandbox.engine.continuous_collision.roll_back import roll_back, roll_back_energy
from sandbox.engine.continuous_collision.slide import SLIDES, slide_all
from sandbox.engine.continuous_collision.static_impact import stop_at_static
from sandbox.engine.continuous_collision.strays import stop_strays
from sandbox.engine.joints.pair_filter import JointFilter
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.ccd import Ccd
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.engine.records.state import StateTables
from sandbox.tables import Records


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
    unit = state.settings[0].units_per_meter
    tables = SweepTables(state.bodies, state.shapes, solver.motions, colliders.cores, solver.ccd, ccd, unit)
    swept = grid.cache.spare
    count = _list_swept(solver.ccd, colliders.proxies, grid.pairs, state.counters[0].pair_count, swept)
    forget_hits(ccd)
    for k in range(count):
        carry_bullet(tables, swept[k])
    bullets = False
    threshold = bounce_threshold(state.settings[0])
    for round in range(SLIDES + 1):
        for k in range(count):
            bullets |= stop_at_static(tables, swept[k], round)
        stop_strays(tables, active, colliders, grid, count, joint_filter, round)
        if round == SLIDES or not slide_all(state.bodies, solver.motions, ccd, threshold, round):
            break
    if bullets:
        found: Any = swept[:count]
        stop_bullets(tables, found, threshold)
    _roll_back_all(state, active, solver.motions, ccd, threshold)


@kernel
def _roll_back_all(state: StateTables, active: ActiveSet, motions: Records, ccd: Ccd, threshold: float) -> None:
    """Roll all bodies back to their times of impact, but those that slept when the step began."""
    for i in ccd.hit[1 : 1 + ccd.hit[0]]:
        body = state.bodies[i]
        impact = ccd.impacts[i]
        if impact.time < 1.0 and active.activity[i] == AWAKE:
            share = 1.0 - impact.time
            roll_back(body, motions[i], share)
            if impact.bounces == 1:
                roll_back_energy(body, motions[i], share, state.settings[0])
            if impact.touched == 1:
                strike_static(state.bodies, i, impact, threshold)


@kernel
def _list_swept(ccd_bodies: Records, proxies: Records, pairs: Records, pair_count: int, swept: Records) -> int:
    """List the pairs of which a body is fast and one is static or a bullet, in order; return how many.

    The rest of the table stays free for one.
    """
    count = 0
    for k in range(pair_count):
        a = proxies[pairs[k].shape_a]
        b = proxies[pairs[k].shape_b]
        holds = (a.traits | b.traits) & (FIXED | BULLET) != 0
        if holds and ccd_bodies[a.body].fast + ccd_bodies[b.body].fast > 0:
            swept[count] = pairs[k]
            count += 1
    return count

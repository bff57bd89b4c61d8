"""Stage: the substeps. Velocities from forces, impacts, joints and contacts; then positions; then the relax pass."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.active.body_flags import is_active
from sandbox.engine.active.quarantine import guard_velocities
from sandbox.engine.bodies.integrate import begin_pulls, integrate_positions, integrate_velocities
from sandbox.engine.contact_solver.soft_constraint import soft_coefficients
from sandbox.engine.contact_solver.solve import solve_contacts, warm_start
from sandbox.engine.joints.mouse_joint import solve_drags
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.solve import let_members_move, relax_joints, select_parts, solve_joints
from sandbox.engine.restitution.impacts import resolve_impacts, resolve_late_impacts
from sandbox.tables import Floats, Integers, Records

WAIT = 1e30
"""Speed (m/s) that a relax pass grants contacts which may bounce: the next substep decides on their impact."""

RELAX_DEEP = 8
"""Relax passes where bodies overlap deeply: 40 boxes thrown into one place part at 3 m/s instead of 12."""


@kernel
def some_fresh(bodies: Records, active: Integers, flights: Records, holds: Records, pace: int) -> bool:
    """Whether some body of a pace touches something new."""
    found = False
    for i in active:
        if holds[i].fresh == 1 and flights[i].pace == pace and is_active(bodies[i]):
            found = True
    return found


@kernel
def run_substeps(
    bodies: Records,
    active: Integers,
    motions: Records,
    flights: Records,
    pulls: Records,
    drags: Records,
    setting: Records,
    census: Records,
    counters: Records,
    contacts: Records,
    bouncy: Integers,
    bouncy_count: int,
    slots: Records,
    blocks: Records,
    block_count: int,
    lanes: Floats,
    gathered: Floats,
    pace: int,
    relaxes: int,
    fresh: bool,
    joints: JointWork | None,
) -> None:
    """Integrate, solve and relax the islands of one pace, in as many substeps as it asks for.

    If some contact is `fresh`, a rigid pass comes first, once.
    """
    substeps = setting.substeps << pace
    seconds = setting.step_seconds / substeps
    rate = 1.0 / seconds
    hertz = setting.contact_hertz * (1 << pace)
    hertz = hertz if hertz < 0.25 * rate else 0.25 * rate
    bias, mass_scale, impulse_scale = soft_coefficients(hertz, setting.contact_damping_ratio, seconds)
    slowest = -setting.push_out_speed
    gravity = math.sqrt(setting.gravity_x * setting.gravity_x + setting.gravity_y * setting.gravity_y)

    if joints is not None:
        select_parts(joints, flights, pace)
    begin_pulls(bodies, active, flights, pulls, pace, setting.gravity_x, setting.gravity_y, seconds)
    for substep in range(substeps):
        integrate_velocities(active, motions, flights, pulls)
        guard_velocities(bodies, active, motions, pulls, census, counters)
        resolve_impacts(
            bodies, motions, flights, contacts, bouncy, bouncy_count, setting.restitution_threshold, seconds
        )
        solve_drags(bodies, motions, flights, drags, pace, seconds)
        warm_start(motions, slots, blocks, block_count, lanes, gathered)
        if joints is not None:
            solve_joints(joints, bodies, motions, flights, seconds)
        if fresh and substep == 0:
            # What was just put there has no impulses yet, and soft contacts alone would let it slip until it has.
            solve_contacts(motions, slots, blocks, block_count, lanes, gathered, rate, 0.0, 1.0, 0.0, 0.0, 0.0)
        solve_contacts(
            motions,
            slots,
            blocks,
            block_count,
            lanes,
            gathered,
            rate,
            bias,
            mass_scale,
            impulse_scale,
            slowest,
            0.0,
        )
        if joints is not None:
            let_members_move(joints, motions, flights, seconds)
        integrate_positions(active, motions, flights, pulls, gravity, seconds)
        resolve_late_impacts(
            bodies,
            active,
            motions,
            flights,
            contacts,
            bouncy,
            bouncy_count,
            pace,
            setting.restitution_threshold,
            seconds,
        )
        if joints is not None:
            relax_joints(joints, bodies, motions, flights, seconds)
        for _pass in range(relaxes):
            solve_contacts(motions, slots, blocks, block_count, lanes, gathered, rate, 0.0, 1.0, 0.0, 0.0, WAIT)

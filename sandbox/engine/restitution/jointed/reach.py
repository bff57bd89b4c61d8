"""What a group of impacts reaches by joints, and how these pass it on.

`solver.motions` has what pushes on the bodies that are struck make of the velocities at the start of the substep.
Joints pass that on at once, to all bodies of the factorised parts that are reached (`joints/direct/transmit.py`).
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.joints.direct.records import HAS_MATRIX, PASSED_THROUGH
from sandbox.engine.joints.direct.transmit import (
    come_to_stops,
    holds_stop,
    report_blow,
    set_struck,
    transmit,
    transmit_push,
)
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import ALONE
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.jointed.parts import LAST, NO_PART, factorised_part
from sandbox.engine.restitution.worklist import END, next_contact
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

_BEGIN, _MEASURE, _ADD, _FINISH = 0, 1, 2, 3
_MOST_WORK = 256
"""Through so many parts the impacts of a substep are passed on: of a crowd of jointed bodies that bounce some are
passed on exactly, the others are left to what joints take of them."""
_PASSES_OF_PART = 64
"""Passes over contacts that take as long as a part."""


class Reach(NamedTuple):
    """The parts that a group reaches, listed from `head` on (`parts.py`), their batches from `batch` on, and the length
    of a substep (s)."""

    work: JointWork
    head: int
    batch: int
    seconds: float


@kernel
def begin_pushes(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, reach: Reach) -> None:
    """Write the velocities at the start of the substep to `solver.motions`, of all that the group reaches that is
    linked from impact `first` on."""
    _for_all(bodies, solver, impacts, first, reach, _BEGIN)


@kernel
def energy_in_motions(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, reach: Reach) -> float:
    """The kinetic energy (J) of all that the group reaches, by the velocities in `solver.motions`."""
    return float(_for_all(bodies, solver, impacts, first, reach, _MEASURE))


@inlined_kernel
def work_left(reach: Reach) -> int:
    """Through how many parts impacts of the substep may still be passed on; less than 0 after a long round."""
    return int(_MOST_WORK - reach.work.direct.level[PASSED_THROUGH])


@inlined_kernel
def count_passes(reach: Reach, passes: int) -> None:
    """Count passes over contacts as work."""
    reach.work.direct.level[PASSED_THROUGH] += passes // _PASSES_OF_PART


@inlined_kernel
def hold_matrix(reach: Reach) -> None:
    """From now on the matrix is that of the group."""
    reach.work.direct.level[HAS_MATRIX] = 1


@inlined_kernel
def holds_matrix(reach: Reach) -> bool:
    """Whether the matrix is still that of the group."""
    return bool(reach.work.direct.level[HAS_MATRIX] == 1)


@kernel
def pass_on(solver: SolverBodies, reach: Reach) -> None:
    """Let joints pass on what was pushed, in `solver.motions`. They keep the velocities at the start of the substep."""
    p = reach.head
    while p != LAST:
        part = reach.work.parts[p - 1]
        set_struck(reach.work.direct, part.lane, _is_pushed(solver, reach.work, part))
        p = part.next_struck
    _transmit(solver, reach)


@kernel
def keep_joints(solver: SolverBodies, reach: Reach) -> None:
    """Let joints pass on also what they do not keep at the start of the substep."""
    p = reach.head
    while p != LAST:
        part = reach.work.parts[p - 1]
        set_struck(reach.work.direct, part.lane, True)
        p = part.next_struck
    _transmit(solver, reach)
    reach.work.direct.level[HAS_MATRIX] = 0


@kernel
def pass_on_from(solver: SolverBodies, contact: Records, reach: Reach) -> None:
    """Let joints pass on what was pushed at one contact, with the stops that hold."""
    d = reach.work.direct
    p = reach.head
    while p != LAST:
        part = reach.work.parts[p - 1]
        set_struck(d, part.lane, False)
        p = part.next_struck
    for i in (contact.body_a, contact.body_b):
        q = factorised_part(reach.work, i)
        if q != NO_PART:
            set_struck(d, reach.work.parts[q].lane, True)
    n = reach.batch
    while n != LAST:
        transmit_push(d, n - 1, solver.motions, solver.free_motions, reach.seconds)
        n = d.batches[n - 1].next_struck


@kernel
def reach_stops(solver: SolverBodies, reach: Reach) -> bool:
    """Let the stops that hold take what they do where nothing is pushed; whether any holds."""
    d = reach.work.direct
    held = False
    p = reach.head
    while p != LAST:
        part = reach.work.parts[p - 1]
        holds = holds_stop(d, part.lane)
        set_struck(d, part.lane, holds)
        held = held or holds
        p = part.next_struck
    n = reach.batch if held else LAST
    while n != LAST:
        come_to_stops(d, n - 1, solver.motions, solver.free_motions, reach.seconds)
        n = d.batches[n - 1].next_struck
    return held


@kernel
def forget_push(solver: SolverBodies, contact: Records, reach: Reach) -> None:
    """Go back to the velocities at the start of the substep after a push at one contact."""
    work = reach.work
    for i in (contact.body_a, contact.body_b):
        q = factorised_part(work, i)
        if q != NO_PART:
            for m in range(work.parts[q].first_member, work.parts[q].member_end):
                _start(solver, work.members[m].body)
        else:
            _start(solver, i)


@inlined_kernel
def _start(solver: SolverBodies, i: int) -> None:
    """Let a body have its velocity at the start of the substep."""
    free = solver.free_motions[i]
    _set(solver.motions[i], free.start_x, free.start_y, free.start_w)


@kernel
def _is_pushed(solver: SolverBodies, work: JointWork, part: Records) -> bool:
    """Whether a body of a part has another velocity than at the start of the substep."""
    for m in range(part.first_member, part.member_end):
        i = work.members[m].body
        motion = solver.motions[i]
        free = solver.free_motions[i]
        if (
            motion.velocity_x != free.start_x
            or motion.velocity_y != free.start_y
            or motion.angular_velocity != free.start_w
        ):
            return True
    return False


@kernel
def _transmit(solver: SolverBodies, reach: Reach) -> None:
    """Let the joints of the parts that are struck pass it on."""
    d = reach.work.direct
    n = reach.batch
    while n != LAST:
        if transmit(d, n - 1, solver.motions, solver.free_motions, reach.seconds):
            d.level[HAS_MATRIX] = 0
        n = d.batches[n - 1].next_struck


@kernel
def take_over(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, reach: Reach) -> None:
    """Make what changed in `solver.motions` part of the velocities, and tell it of joints."""
    _for_all(bodies, solver, impacts, first, reach, _ADD)
    p = reach.head
    while p != LAST:
        part = reach.work.parts[p - 1]
        report_blow(reach.work.direct, part.lane)
        p = part.next_struck


@kernel
def end_pushes(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, reach: Reach) -> None:
    """Let the solver go on with the velocities at the end of the substep."""
    _for_all(bodies, solver, impacts, first, reach, _FINISH)


@kernel
def _for_all(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, reach: Reach, what: int) -> float:
    """Do `what` is to be done with the velocities of each body that the group reaches, once; returns the sum of what
    that gives."""
    work = reach.work
    found = 0.0
    p = reach.head
    while p != LAST:
        part = work.parts[p - 1]
        for m in range(part.first_member, part.member_end):
            i = work.members[m].body
            found += _do(bodies[i], solver.free_motions[i], solver.motions[i], what)
        p = part.next_struck
    k = first
    while k != END:
        slot = impacts.slots[k]
        for i in (slot.body_a, slot.body_b):
            free = bodies[i].type == DYNAMIC and factorised_part(work, i) == NO_PART
            if free and _strikes_first(solver, impacts, k, i):
                found += _do(bodies[i], solver.free_motions[i], solver.motions[i], what)
        k = impacts.rows[k].next
    return found


@kernel
def _strikes_first(solver: SolverBodies, impacts: ImpactList, k: int, i: int) -> bool:
    """Whether impact k is the first of body i that has struck."""
    j = solver.first_impact[i]
    while impacts.rows[j].group == ALONE:
        j = next_contact(impacts.slots[j], i)
    return bool(j == k)


@kernel
def _do(body: Records, free: Records, motion: Records, what: int) -> float:
    """The same for a body."""
    if what == _BEGIN:
        _set(motion, free.start_x, free.start_y, free.start_w)
    elif what == _MEASURE:
        return _energy(body, motion)
    elif what == _ADD:
        x = motion.velocity_x - free.start_x
        y = motion.velocity_y - free.start_y
        w = motion.angular_velocity - free.start_w
        free.start_x += x
        free.start_y += y
        free.start_w += w
        free.free_x += x
        free.free_y += y
        free.free_w += w
    else:
        _set(motion, free.free_x, free.free_y, free.free_w)
    return 0.0


@inlined_kernel
def _energy(body: Records, motion: Records) -> float:
    """The kinetic energy (J) of a body."""
    mass = 1.0 / body.inverse_mass if body.inverse_mass > 0.0 else 0.0
    inertia = 1.0 / body.inverse_inertia if body.inverse_inertia > 0.0 else 0.0
    square = motion.velocity_x * motion.velocity_x + motion.velocity_y * motion.velocity_y
    turning = motion.angular_velocity * motion.angular_velocity
    return float(0.5 * (mass * square + inertia * turning))


@inlined_kernel
def _set(motion: Records, x: float, y: float, w: float) -> None:
    """Write the velocity of a body."""
    motion.velocity_x = x
    motion.velocity_y = y
    motion.angular_velocity = w

"""Stage: the active set. Most bodies of a large world rest: the stages go through lists of those that do not.

What Box2D v3 keeps in its awake and its sleeping solver sets, these lists tell of one set of tables.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.bearable_mass import weigh
from sandbox.engine.active.sleeping_islands import begin_member, touch_row
from sandbox.engine.bodies.flags import IMMOVABLE, disturbs
from sandbox.engine.contact_solver.closing_speed import stops_by_several
from sandbox.engine.records.active_set import ACTIVE_SET, ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, STATIC

AWAKE, ASLEEP, TOUCHED = 1, 2, 4
"""What `activity` says of a body that a step may move, and of one that sleeps; 0 of those that stay where they are.
`TOUCHED` is only there while the lists are made."""


def new_active_set() -> Records:
    """One row of `ACTIVE_SET` that knows nothing yet."""
    info = ACTIVE_SET.zeros(1)
    info.stale = 1
    return info


def most_touched(bodies: int) -> int:
    """How many of so many bodies may be listed as touched: so many that to list all anew, once there are more, costs
    little for each of them."""
    return 64 + bodies // 16


@kernel
def update_active_set(bodies: Records, active: ActiveSet, solver: SolverBodies) -> bool:
    """List the bodies that a step may move; lay those to rest in the scratch memory that it no longer does, as no stage
    looks after them.

    Nothing is done as long as nobody has come, woken, fallen asleep, or been changed by a command: returns whether.
    What rests is only looked at when it comes or is `touched`, or when all are listed anew.
    """
    info = active.info[0]
    if info.stale == 0 and info.shifted == 0 and active.touched[0] == 0 and info.bodies == bodies.shape[0]:
        return False
    info.generation += 1
    info.posed = 0
    if info.stale == 0:
        _list_new_rows(bodies, active)
        _drop_resting(bodies, active)
    if info.stale == 0:
        _order_touched(active)
        _list_woken(active, _settle_touched(bodies, active, solver))
    else:
        _list_all(bodies, active, solver)
    info.shifted = info.posed  # who was put somewhere is active for one step
    info.stale = 0
    return True


@kernel
def _list_all(bodies: Records, active: ActiveSet, solver: SolverBodies) -> None:
    """Look at everybody, as if all had come."""
    info = active.info[0]
    info.static = info.asleep = info.weighed = active.touched[0] = 0
    info.anew = info.generation
    info.era += 1
    info.bodies = bodies.shape[0]
    count = 0
    for i in range(bodies.shape[0]):
        info.static += 1 if bodies[i].type == STATIC else 0
        begin_member(bodies, active, i)
        active.activity[i] = 0
        if _settle(bodies, active, i, solver):
            count += 1
            active.bodies[count] = i
            active.activity[i] = AWAKE
    active.bodies[0] = count


@kernel
def _list_new_rows(bodies: Records, active: ActiveSet) -> None:
    """Who has come is touched, and so is who has another row."""
    info = active.info[0]
    for i in range(info.bodies, bodies.shape[0]):
        info.static += 1 if bodies[i].type == STATIC else 0
        begin_member(bodies, active, i)
        active.activity[i] = 0
        touch_row(active, i)
    info.bodies = bodies.shape[0]


@kernel
def _drop_resting(bodies: Records, active: ActiveSet) -> None:
    """Take out of the list who no longer moves, who is touched by that."""
    for i in active.touched[1 : 1 + active.touched[0]]:
        active.activity[i] |= TOUCHED
    count = 0
    for i in active.bodies[1 : 1 + active.bodies[0]]:
        body = bodies[i]
        if disturbs(body):
            active.info[0].posed |= body.posed
            count += 1
            active.bodies[count] = i
        elif active.activity[i] & TOUCHED == 0:
            touch_row(active, i)
    active.bodies[0] = count


@kernel
def _settle_touched(bodies: Records, active: ActiveSet, solver: SolverBodies) -> int:
    """Lay to rest who of the touched ones does not move, and note that; returns how many do and are not listed yet, as
    `activity` says of them."""
    info = active.info[0]
    more = 0
    for i in active.touched[1 : 1 + active.touched[0]]:
        was = active.activity[i] & ~TOUCHED
        info.asleep -= 1 if was == ASLEEP else 0
        active.activity[i] = AWAKE
        if not _settle(bodies, active, i, solver):
            _note_settled(active, i)
        elif was != AWAKE:
            active.activity[i] = TOUCHED
            more += 1
    return more


@inlined_kernel
def _note_settled(active: ActiveSet, i: int) -> None:
    """A body rests where it may not have been before."""
    settled = active.settled
    settled[1 + settled[0] % (settled.shape[0] - 1)] = i
    settled[0] += 1


@kernel
def _settle(bodies: Records, active: ActiveSet, i: int, solver: SolverBodies) -> bool:
    """Whether a step may move a body, which is laid to rest otherwise."""
    info = active.info[0]
    body = bodies[i]
    if body.type == DYNAMIC:
        weigh(info, body)
    if disturbs(body):
        info.posed |= body.posed
        return True
    active.activity[i] = 0
    if body.type == DYNAMIC:
        active.activity[i] = ASLEEP
        info.asleep += 1
        body.stirred = body.was_asleep - 1
        body.was_asleep = 1
    _lay_to_rest(bodies, i, solver)
    return False


@kernel
def _list_woken(active: ActiveSet, more: int) -> None:
    """Put those of the touched ones that are to be listed among the others: from the end, as there is room behind."""
    listed: Any = active.bodies[1:]
    n = active.bodies[0] - 1
    active.bodies[0] += more
    k = active.touched[0]
    while more > 0:
        i = active.touched[k]
        k -= 1
        if active.activity[i] != TOUCHED:
            continue
        while n >= 0 and listed[n] > i:
            listed[n + more] = listed[n]
            n -= 1
        listed[n + more] = i
        active.activity[i] = AWAKE
        more -= 1


@kernel
def _order_touched(active: ActiveSet) -> None:
    """Sort the touched rows, each once: who has come may have been touched as well."""
    rows: Any = active.touched[1 : 1 + active.touched[0]]
    sort_rows(rows)
    count = 0
    for i in rows:
        if count == 0 or rows[count - 1] != i:
            rows[count] = i
            count += 1
    active.touched[0] = count


@kernel
def sort_rows(rows: Integers) -> None:
    """Sort a few rows: Shell's method with Knuth's gaps (The Art of Computer Programming 3, 5.2.1)."""
    gap = 1
    while 3 * gap + 1 < rows.shape[0]:
        gap = 3 * gap + 1
    while gap > 0:
        for n in range(gap, rows.shape[0]):
            row = rows[n]
            k = n - gap
            while k >= 0 and rows[k] > row:
                rows[k + gap] = rows[k]
                k -= gap
            rows[k + gap] = row
        gap //= 3


@kernel
def first_from(rows: Integers, row: int) -> int:
    """Where a row is among ascending ones, or where it would be."""
    low = 0
    high = rows.shape[0]
    while low < high:
        middle = (low + high) // 2
        if rows[middle] < row:
            low = middle + 1
        else:
            high = middle
    return low


@kernel
def _lay_to_rest(bodies: Records, i: int, solver: SolverBodies) -> None:
    _rest(bodies[i], solver.motions[i], solver.free_motions[i])
    solver.forces[i].moves = 0.0
    solver.flags[i] = 0
    solver.colors[i] = IMMOVABLE
    solver.batches[i] = 0
    ccd_body = solver.ccd[i]
    ccd_body.deep = ccd_body.unsettled = ccd_body.fast = 0


@kernel
def _rest(body: Records, motion: Records, free_motion: Records) -> None:
    motion.velocity_x = free_motion.start_x = free_motion.free_x = body.velocity_x
    motion.velocity_y = free_motion.start_y = free_motion.free_y = body.velocity_y
    motion.angular_velocity = free_motion.start_w = free_motion.free_w = body.angular_velocity
    motion.delta_x = motion.delta_y = motion.delta_angle = motion.delta_sin = 0.0
    motion.delta_cos = 1.0
    free_motion.substep_level = 0


@inlined_kernel
def list_contact(contact: Records, row: int, contacts: Contacts) -> None:
    """List one contact that the solver will look at; it may have an impact if it has restitution or stops by
    several impulses."""
    may_impact = contact.restitution > 0.0 or stops_by_several(contact.point_count, contact.rolling_resistance)
    list_row(row, contact.body_a, contact.body_b, may_impact, contacts)


@inlined_kernel
def list_row(row: int, body_a: int, body_b: int, may_impact: bool, contacts: Contacts) -> None:
    """List the row of a contact that the solver will look at."""
    last = contacts.active[0].contact + 1
    contacts.active[0].contact = last
    slot = contacts.active[last]
    slot.contact = row
    slot.body_a = body_a
    slot.body_b = body_b
    if may_impact:
        candidates = contacts.impact_candidates
        candidates[0] += 1
        candidates[candidates[0]] = row

"""Stage: the active set. Most bodies of a large world rest: the stages go through lists of those that do not.

What Box2D v3 keeps in its awake and its sleeping solver sets, these lists tell of one set of tables.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.flags import IMMOVABLE, disturbs, is_active
from sandbox.engine.contact_solver.closing_speed import stops_by_several
from sandbox.engine.records.active_set import ACTIVE_SET, ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, STATIC

AWAKE, ASLEEP = 1, 2
"""What `activity` says of a body that a step may move, and of one that sleeps; 0 of those that stay where they are."""


def new_active_set() -> Records:
    """One row of `ACTIVE_SET` that knows nothing yet."""
    info = ACTIVE_SET.zeros(1)
    info.stale = 1
    return info


def most_touched(bodies: int) -> int:
    """How many of so many bodies may be listed among the loose ones though they stay where they are: so many that to
    list all anew, once there are more, costs little for each of them."""
    return 64 + bodies // 16


@kernel
def update_active_set(bodies: Records, active: ActiveSet, solver: SolverBodies) -> bool:
    """List the bodies that a step may move; lay the others to rest in the scratch memory, as no stage looks after them.

    Nothing is done as long as nobody has come, woken, fallen asleep, or been changed by a command: returns whether.
    Bodies that stay where they are are only looked at when they come or are `touched`, or when all are listed anew.
    """
    info = active.info[0]
    if info.stale == 0 and info.shifted == 0 and active.touched[0] == 0 and info.bodies == bodies.shape[0]:
        return False
    info.generation += 1
    anew = info.stale == 1 or info.fixed >= active.touched.shape[0]
    anew = anew or info.fixed_generation > info.shapes_generation  # the shapes of all are not in order yet
    if anew:
        info.static = info.bodies = active.loose[0] = active.touched[0] = 0
        info.fixed_generation = info.generation
    _list_touched(active)
    _list_loose(bodies, active, solver, anew)
    count = 0
    asleep = 0
    fixed = 0
    posed = 0
    for i in active.loose[1 : 1 + active.loose[0]]:
        body = bodies[i]
        posed |= body.posed
        active.activity[i] = AWAKE if disturbs(body) else 0
        if active.activity[i] == AWAKE:
            count += 1
            active.bodies[count] = i
            continue
        if body.type == DYNAMIC:
            active.activity[i] = ASLEEP
            asleep += 1
            body.stirred = body.was_asleep - 1
            body.was_asleep = 1
        else:
            fixed += 1
        _lay_to_rest(bodies, i, solver)
    active.bodies[0] = count
    info.asleep = asleep
    info.fixed = fixed
    info.posed = posed
    info.shifted = posed  # who was put somewhere is active for one step
    info.stale = 0
    return True


@kernel
def _list_touched(active: ActiveSet) -> None:
    """List the touched bodies that the lists know, but not among the loose ones. `active.touched` has these alone then,
    for `order_shapes`."""
    loose: Any = active.loose[1 : 1 + active.loose[0]]
    touched: Any = active.touched[1:]
    count = 0
    for k in range(active.touched[0]):
        if touched[k] < active.info[0].bodies and not _holds(loose, touched[k]):
            touched[count] = touched[k]
            count += 1
    _merge_rows(active.loose[1:], active.loose[0], touched, count)
    active.loose[0] += count
    active.touched[0] = count


@kernel
def _list_loose(bodies: Records, active: ActiveSet, solver: SolverBodies, anew: bool) -> None:
    """List the bodies that may move or sleep, of those that the lists do not know yet; lay the others to rest, but list
    them as well if they have come since all were listed `anew`."""
    info = active.info[0]
    count = active.loose[0]
    for i in range(info.bodies, bodies.shape[0]):
        info.static += 1 if bodies[i].type == STATIC else 0
        if not anew or bodies[i].type == DYNAMIC or disturbs(bodies[i]):
            count += 1
            active.loose[count] = i
        else:
            active.activity[i] = 0
            _lay_to_rest(bodies, i, solver)
    active.loose[0] = count
    info.bodies = bodies.shape[0]


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
def _holds(rows: Integers, row: int) -> bool:
    """Whether a row is among ascending ones."""
    place = first_from(rows, row)
    return bool(place < rows.shape[0] and rows[place] == row)


@kernel
def _merge_rows(rows: Integers, count: int, fresh: Integers, more: int) -> None:
    """Put so many fresh rows among the first `count` ones, both ascending: from the end, as there is room behind."""
    n = count - 1
    k = more - 1
    while k >= 0:
        if n >= 0 and rows[n] > fresh[k]:
            rows[n + k + 1] = rows[n]
            n -= 1
        else:
            rows[n + k + 1] = fresh[k]
            k -= 1


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


@kernel
def list_active_contacts(bodies: Records, contacts: Contacts, count: int) -> None:
    """List the contacts with an active body, and those of them that may have an impact.

    The narrow phase has made these lists; they are made anew after somebody has woken.
    """
    contacts.active[0].contact = 0
    contacts.impact_candidates[0] = 0
    for i in range(count):
        contact = contacts.now[i]
        if is_active(bodies[contact.body_a]) or is_active(bodies[contact.body_b]):
            list_contact(contact, i, contacts)


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

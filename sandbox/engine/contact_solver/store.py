"""Stage: copy what the solver has accumulated back into the contacts, and report on the step."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._prefetch import AHEAD, prefetch_head
from sandbox._vectors import Vector, load, select, spread, store
from sandbox.engine.bodies.flags import flag_contact
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.closing_speed import closing_speed
from sandbox.engine.contact_solver.contact_rows import KEPT_OF_POINT_1, KEPT_OF_POINT_2, contact_rows
from sandbox.engine.contact_solver.rest_length import next_length
from sandbox.engine.contact_solver.soft_constraint import Spring
from sandbox.engine.midpoint.contacts_ahead import move_row_back
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.gather_fields import Rows, gather_fields, scatter_fields
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import color_count, first_part_of_color, next_part
from sandbox.engine.workers.task_kinds import LEVEL, STORE_IMPULSES
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES
_ROUNDING = 1e-9
"""Where the normal impulse of a point in a substep changes its normal velocity by less than so many m/s it bears
nothing: what rounding leaves of one must not decide where friction acts, nor what is supported."""


@kernel
def clear_reports(reports: Records, count: int) -> None:
    """Contacts that are not solved, such as those among sleepers, have nothing to report."""
    for i in range(count):
        reports[i].total_impulse = 0.0
        reports[i].hit_speed = 0.0


@kernel
def store_impulses(
    state: StateTables,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    block_count: int,
    workers: Workers,
    spring: Spring,
) -> None:
    """Copy the accumulated impulses back into the contacts, with all workers, as `store_blocks` does."""
    workers.numbers[LEVEL] = spring.level
    for color in range(color_count(workers, blocks)):  # whose contacts share no flags
        first, end = first_part_of_color(workers, STORE_IMPULSES, blocks, color, (0, block_count))
        while first < end:
            store_blocks(state, solver, contacts, blocks, first, end, spring)
            first, end = next_part(workers, first, end)


@kernel
def store_blocks(
    state: StateTables,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    first: int,
    end: int,
    spring: Spring,
) -> None:
    """Copy the impulses of the blocks first..end-1 back into the contacts, to warm start the next step, and report.

    The contacts keep what a substep of level 0 would have given, as the next step may have another level.

    The bodies still have the velocities with which the step began: a point that begins to push has closed in at them.
    What they bear is flagged as supported.
    """
    bodies = state.bodies
    half_step = 0.5 * state.settings[0].step_seconds
    for n in range(first, end):
        block = blocks.blocks[n]
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        _drop_rounding(v, _ROUNDING * spring.units_per_meter)
        for at in range(block.first + AHEAD, block.first + AHEAD + LANES):
            if at < blocks.slots.shape[0]:
                prefetch_head(contacts.now, blocks.slots[at].contact)
        for k in range(block.count):
            slot = blocks.slots[block.first + k]
            contact = contacts.now[slot.contact]
            move_row_back(bodies, solver, slot, contact, half_step)
            _report(bodies, contact, contacts.reports[slot.contact], v[k:])
            pushes = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] > 0.0 or v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] > 0.0
            flag_contact(solver.flags, slot.body_a, slot.body_b, pushes, contact.surface_speed)
        _keep(block, v, contacts.now, contact_rows(block, blocks.slots), spring)


@inlined_kernel
def _drop_rounding(v: Floats, slow: float) -> None:
    """Let the points of a block whose impulses change velocities by less than `slow` (m/s) bear nothing, and sum up
    what both bore in the step."""
    first = load(v, cb.POINT_1 + cb.NORMAL_IMPULSE)
    second = load(v, cb.POINT_2 + cb.NORMAL_IMPULSE)
    total = load(v, cb.TOTAL_IMPULSE) + (first + second)
    least1 = slow * load(v, cb.POINT_1 + cb.NORMAL_MASS)
    least2 = slow * load(v, cb.POINT_2 + cb.NORMAL_MASS)
    store(v, cb.POINT_1 + cb.NORMAL_IMPULSE, select(first > least1, first, 0.0))
    store(v, cb.POINT_2 + cb.NORMAL_IMPULSE, select(second > least2, second, 0.0))
    store(v, cb.TOTAL_IMPULSE, select(total > least1 + least2, total, 0.0))


@inlined_kernel
def _report(bodies: Records, contact: Records, report: Records, v: Floats) -> None:
    """Report on a contact with lane `v`, which still has the impulses of the step before."""
    impulse = float(contact.impact_impulse + v[cb.TOTAL_IMPULSE])
    report.total_impulse = impulse
    if impulse > 0.0:
        contact.touching = 1
        if contact.impact_impulse > 0.0 or contact.normal_impulse1 == 0.0 or contact.normal_impulse2 == 0.0:
            report.hit_speed = _hit_speed(bodies[contact.body_a], bodies[contact.body_b], contact)
    elif contact.separation1 < 0.0 or contact.separation2 < 0.0:
        contact.touching = 1


@inlined_kernel
def _keep(block: Records, v: Floats, contacts: Records, rows: Rows, spring: Spring) -> None:
    """Write what the contacts of a block keep for the next step: impulses, and lengths of springs that suit them."""
    substeps = 1.0 / spring.share
    load1 = substeps * load(v, cb.POINT_1 + cb.NORMAL_IMPULSE)
    load2 = substeps * load(v, cb.POINT_2 + cb.NORMAL_IMPULSE)
    _, tangent1, length1, feature = gather_fields(contacts, rows, KEPT_OF_POINT_1)
    _, tangent2, length2, rolling = gather_fields(contacts, rows, KEPT_OF_POINT_2)
    yields = spread(spring.yields)
    if block.jointed == 1:
        yields = select(load(v, cb.JOINTED) > 0.0, spring.yields_jointed, yields)
    length1 = next_length(length1, load1, yields, load(v, cb.POINT_1 + cb.NORMAL_MASS))
    length2 = next_length(length2, load2, yields, load(v, cb.POINT_2 + cb.NORMAL_MASS))
    bears = load1 + load2 > 0.0
    if block.frictional == 1:
        tangent = select(bears, substeps * load(v, cb.TANGENT_IMPULSE), 0.0)
        tangent1, tangent2 = _share_friction(tangent, load1, load2)
    if block.rolling == 1:
        rolling = select(bears, substeps * load(v, cb.ROLLING_IMPULSE), 0.0)
    scatter_fields(contacts, rows, KEPT_OF_POINT_1, (load1, tangent1, length1, feature), 0, block.count)
    scatter_fields(contacts, rows, KEPT_OF_POINT_2, (load2, tangent2, length2, rolling), 0, block.count)


@inlined_kernel
def _share_friction(tangent: Vector, load1: Vector, load2: Vector) -> tuple[Vector, Vector]:
    """The friction of both points (N s) at each, by what it bears."""
    total = load1 + load2
    total = select(total > 0.0, total, 1.0)
    return tangent * (load1 / total), tangent * (load2 / total)


@kernel
def _hit_speed(a: Records, b: Records, contact: Records) -> float:
    """Speed (m/s) at which the points that did not push before have closed in; 0 if they did not."""
    struck = contact.impact_impulse > 0.0
    speed = 0.0
    if struck or contact.normal_impulse1 == 0.0:
        speed = closing_speed(a, b, contact, 1)
    if contact.point_count == 2 and (struck or contact.normal_impulse2 == 0.0):
        other = closing_speed(a, b, contact, 2)
        speed = other if other > speed else speed
    return speed if speed > 0.0 else 0.0

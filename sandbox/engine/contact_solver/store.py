"""Stage: copy what the solver has accumulated back into the contacts, and report on the step."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._prefetch import AHEAD, prefetch_head
from sandbox.engine.bodies.flags import flag_contact
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.closing_speed import closing_speed
from sandbox.engine.contact_solver.rest_length import keep_length
from sandbox.engine.contact_solver.soft_constraint import Spring
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import color_count, first_part_of_color, next_part
from sandbox.engine.workers.task_kinds import LEVEL, STORE_IMPULSES
from sandbox.tables import Integers, Records

BLOCK_SIZE = cb.BLOCK_SIZE


@kernel
def clear_reports(reports: Records, count: int) -> None:
    """Contacts that are not solved, such as those among sleepers, have nothing to report."""
    for i in range(count):
        reports[i].total_impulse = 0.0
        reports[i].hit_speed = 0.0


@kernel
def store_impulses(
    bodies: Records,
    flags: Integers,
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
            store_blocks(bodies, flags, contacts, blocks, first, end, spring)
            first, end = next_part(workers, first, end)


@kernel
def store_blocks(
    bodies: Records,
    flags: Integers,
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
    lanes = blocks.lanes
    substeps = 1.0 / spring.share
    for n in range(first, end):
        for k in range(blocks.blocks[n].count):
            slot = blocks.slots[blocks.blocks[n].first + k]
            contact = contacts.now[slot.contact]
            if blocks.blocks[n].first + k + AHEAD < blocks.slots.shape[0]:
                prefetch_head(contacts.now, blocks.slots[blocks.blocks[n].first + k + AHEAD].contact)
            report = contacts.reports[slot.contact]
            at = n * BLOCK_SIZE + k
            normal1 = lanes[at + cb.POINT_1 + cb.NORMAL_IMPULSE]
            normal2 = lanes[at + cb.POINT_2 + cb.NORMAL_IMPULSE]
            total = lanes[at + cb.TOTAL_IMPULSE] + normal1 + normal2
            report.total_impulse = contact.impact_impulse + (total if total > 0.0 else 0.0)
            if report.total_impulse > 0.0:
                contact.touching = 1
                if contact.impact_impulse > 0.0 or contact.normal_impulse1 == 0.0 or contact.normal_impulse2 == 0.0:
                    report.hit_speed = _hit_speed(bodies[contact.body_a], bodies[contact.body_b], contact)
            elif contact.separation1 < 0.0 or contact.separation2 < 0.0:
                contact.touching = 1
            if blocks.blocks[n].rolling == 1:
                contact.rolling_impulse = substeps * lanes[at + cb.ROLLING_IMPULSE]
            contact.normal_impulse1 = substeps * normal1
            contact.normal_impulse2 = substeps * normal2
            keep_length(contact, spring, lanes[at:])
            if blocks.blocks[n].frictional == 1:
                _share_friction(contact, substeps * lanes[at + cb.TANGENT_IMPULSE])
            pushes = normal1 > 0.0 or normal2 > 0.0
            flag_contact(flags, slot.body_a, slot.body_b, pushes, contact.surface_speed)


@inlined_kernel
def _share_friction(contact: Records, tangent: float) -> None:
    """Report the friction of both points (N s) at each, by what it bears."""
    load = contact.normal_impulse1 + contact.normal_impulse2
    both = contact.point_count == 2
    contact.tangent_impulse1 = tangent * (contact.normal_impulse1 / load if load > 0.0 else (0.5 if both else 1.0))
    contact.tangent_impulse2 = tangent * (contact.normal_impulse2 / load if load > 0.0 else (0.5 if both else 0.0))


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

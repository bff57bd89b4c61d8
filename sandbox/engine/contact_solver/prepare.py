"""Stage: copy contacts into solver blocks before the substeps."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._prefetch import AHEAD as ROWS_AHEAD
from sandbox._prefetch import prefetch_row
from sandbox.engine.bodies.flags import AHEAD, JOINTED
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.contact_rows import contact_rows
from sandbox.engine.contact_solver.fill_lanes import fill_lanes
from sandbox.engine.contact_solver.four_contacts import moved_by, read_contacts
from sandbox.engine.contact_solver.gather import PairRows, note_rows, rows_of
from sandbox.engine.contact_solver.impact_criteria import ImpactCriteria, may_impact, note_impact
from sandbox.engine.contact_solver.law import PairMass
from sandbox.engine.contact_solver.rest_length import change_level
from sandbox.engine.contact_solver.soft_constraint import Spring
from sandbox.engine.midpoint.contacts_ahead import axis_owners, move_row, ways_of
from sandbox.engine.records.bodies import INVERSE_MASS, SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.gather_fields import gather_fields
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import IMPACT_SPEED, IMPACTS, LEVEL, PREPARE_CONTACTS, STRUCK_BLOCKS
from sandbox.tables import Floats, Integers, Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES


@kernel
def prepare_contacts(
    state: StateTables,
    solver: SolverBodies,
    contacts: Records,
    blocks: ContactBlocks,
    block_count: int,
    workers: Workers,
    spring: Spring,
    criteria: ImpactCriteria,
) -> None:
    """Fill the lanes of all blocks, with all workers, as `prepare_blocks` does."""
    workers.numbers[LEVEL] = spring.level
    workers.numbers[IMPACTS] = 1.0 if criteria.some else 0.0
    workers.numbers[STRUCK_BLOCKS] = criteria.struck_blocks
    workers.numbers[IMPACT_SPEED] = criteria.speed
    first, end = first_part(workers, PREPARE_CONTACTS, 0, block_count)
    while first < end:
        prepare_blocks(state, solver, contacts, blocks, first, end, spring, criteria)
        first, end = next_part(workers, first, end)


@kernel
def prepare_blocks(
    state: StateTables,
    solver: SolverBodies,
    contacts: Records,
    blocks: ContactBlocks,
    first: int,
    end: int,
    spring: Spring,
    criteria: ImpactCriteria,
) -> None:
    """Fill the lanes of the blocks first..end-1: axes, anchors, effective masses and the impulses to start from.

    Those are what a substep of the level gives, while contacts keep what one of level 0 would.
    """
    bodies = state.bodies
    half_step = 0.5 * state.settings[0].step_seconds
    for n in range(first, end):
        block = blocks.blocks[n]
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for at in range(block.first + ROWS_AHEAD, block.first + ROWS_AHEAD + LANES):
            if at < blocks.slots.shape[0]:
                prefetch_row(contacts, blocks.slots[at].contact)
        _note_bodies(block, blocks.slots)
        rows = contact_rows(block, blocks.slots)
        mass = _masses_of(bodies, rows_of(block))
        four = read_contacts(contacts, rows)
        flags = _flags_of(solver.flags, block, blocks.slots)
        if flags & AHEAD:
            owners = axis_owners(bodies, solver.flags, block, blocks.slots, contacts)
            four = moved_by(four, ways_of(block, solver.motions), owners)
        fill_lanes(block, v, contacts, rows, four, mass, spring.share)
        for k in range(block.count, LANES):
            _clear(v[k:])
        block.jointed = 1 if flags & JOINTED else 0
        if block.jointed == 1:
            _note_jointed(block, v, solver.flags, blocks.slots)
        block.strikes = 0
        for k in range(block.count):
            slot = blocks.slots[block.first + k]
            contact = contacts[slot.contact]
            if contact.substep_level != spring.level:
                change_level(contact, block, v[k:], spring)
            struck = n < criteria.struck_blocks
            a = bodies[slot.body_a]
            b = bodies[slot.body_b]
            if criteria.some and may_impact(a, b, contact, criteria.speed, struck):
                note_impact(block, v, k)
                if contact.restitution > 0.0:
                    move_row(bodies, solver, slot, contacts, half_step)


@inlined_kernel
def _note_bodies(block: Records, slots: Records) -> None:
    """Note the bodies of the lanes of a block; those that are not used have those of the first one."""
    first = block.first
    one = slots[first]
    two = slots[first + 1 if block.count > 1 else first]
    three = slots[first + 2 if block.count > 2 else first]
    four = slots[first + 3 if block.count > 3 else first]
    a = (one.body_a, two.body_a, three.body_a, four.body_a)
    note_rows(block, PairRows(a, (one.body_b, two.body_b, three.body_b, four.body_b)))


@inlined_kernel
def _masses_of(bodies: Records, rows: PairRows) -> PairMass:
    """The inverse masses of four pairs of bodies."""
    mass_a, inertia_a, _, _ = gather_fields(bodies, rows.a, INVERSE_MASS)
    mass_b, inertia_b, _, _ = gather_fields(bodies, rows.b, INVERSE_MASS)
    return PairMass(mass_a, inertia_a, mass_b, inertia_b)


@inlined_kernel
def _flags_of(flags: Integers, block: Records, slots: Records) -> int:
    """The flags that some body of the contacts of a block has."""
    bits = 0
    for slot in slots[block.first : block.first + block.count]:
        bits |= flags[slot.body_a] | flags[slot.body_b]
    return bits


@inlined_kernel
def _note_jointed(block: Records, v: Floats, flags: Integers, slots: Records) -> None:
    """Note which contacts of a block are of bodies that joints hold."""
    for k in range(block.count):
        slot = slots[block.first + k]
        v[cb.JOINTED + k] = 1.0 if (flags[slot.body_a] | flags[slot.body_b]) & JOINTED else 0.0


@inlined_kernel
def _clear(v: Floats) -> None:
    """Zero a lane that no contact fills but the arithmetic runs over."""
    for field in range(0, BLOCK_SIZE - LANES + 1, LANES):
        v[field] = 0.0

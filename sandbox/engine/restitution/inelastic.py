"""Hard impacts without restitution: all contacts of what is struck, and of what that is pressed on, stop together.

Their impulses are found before the contact solver's, from none, and are not what the next substep begins with: the
solver would have to take a blow back that it began with, and what bears it would fly apart meanwhile. What is solved
is Newton's law with the restitution 0 for all contacts at once, with Coulomb friction: a gap may close and no more.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.closing_speed import SLOW, closing_beyond_gap, gap_of
from sandbox.engine.contact_solver.nesterov import ROUNDING, Effort, count_contacts, list_bodies, solve_until_agreed
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.tables import Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES
MOST_PASSES = 1024
MOST_WORK = 24_000
"""Passes times contacts: in large heaps impacts are not solved as far, which only what is heavy on light would need."""
SMALL_HEAP = 3_200
"""Contacts, up to which it is more, the more the fewer there are: four times as much for a quarter of them."""
AGREED = 0.5 * SLOW
"""Up to so many m/s passes agree: what they leave is slow, however heavy what closes in may be."""


@kernel
def stop_struck(
    bodies: Records,
    solver: SolverBodies,
    struck: Records,
    blocks: ContactBlocks,
    block_count: int,
    workers: Workers,
    rigid: SoftContact,
    unit: float,
) -> bool:
    """Solve the inelastic impacts of a substep, if there are any in the first blocks of contacts, and return whether
    there were; `struck` is scratch.

    A metre is so many units of length. It works on the velocities with which the substep began, and changes those after
    its forces, in `solver.motions`, by as much: what forces do in a substep is what contacts at rest bear.
    """
    if not _is_struck(solver, blocks, block_count, rigid, SLOW * unit):
        return False
    count = list_bodies(solver, struck, blocks, block_count)
    moved: Any = struck[:count]
    for here in moved:
        _take_start(solver, here.body)
    _put_aside(blocks, block_count)
    contacts = count_contacts(blocks, block_count)
    more = SMALL_HEAP // contacts
    effort = Effort(MOST_PASSES, MOST_WORK * (more if more > 1 else 1), AGREED * unit, ROUNDING * unit)
    solve_until_agreed(bodies, solver.motions, moved, blocks, block_count, workers, rigid, effort)
    _bring_back(blocks, block_count)
    for here in moved:
        _add_impact(solver, here.body)
    return True


@kernel
def stop_late(
    bodies: Records,
    solver: SolverBodies,
    struck: Records,
    blocks: ContactBlocks,
    block_count: int,
    workers: Workers,
    rigid: SoftContact,
    unit: float,
) -> bool:
    """The same for what has come to touch in the substep that is over.

    Small gaps, which come of positions that follow a mean velocity, count as closed for the rest of the step.
    """
    near = SLOW * unit / rigid.inverse_seconds
    for n in range(block_count):
        block = blocks.blocks[n]
        for k in range(block.count):
            v = blocks.lanes[n * BLOCK_SIZE + k : (n + 1) * BLOCK_SIZE]
            slot = blocks.slots[block.first + k]
            for point in (cb.POINT_1, cb.POINT_2):
                gap = gap_of(solver.motions[slot.body_a], solver.motions[slot.body_b], block, v, point)
                v[point + cb.SEPARATION] -= gap if 0.0 < gap < near else 0.0
    return bool(stop_struck(bodies, solver, struck, blocks, block_count, workers, rigid, unit))


@kernel
def _take_start(solver: SolverBodies, i: int) -> None:
    """Let a body have the velocity with which the substep began."""
    motion = solver.motions[i]
    free_motion = solver.free_motions[i]
    motion.velocity_x = free_motion.start_x
    motion.velocity_y = free_motion.start_y
    motion.angular_velocity = free_motion.start_w


@kernel
def _add_impact(solver: SolverBodies, i: int) -> None:
    """Add what the impact has changed to the velocities at the start of the substep and after its forces."""
    motion = solver.motions[i]
    free_motion = solver.free_motions[i]
    free_motion.free_x += motion.velocity_x - free_motion.start_x
    free_motion.free_y += motion.velocity_y - free_motion.start_y
    free_motion.free_w += motion.angular_velocity - free_motion.start_w
    free_motion.start_x = motion.velocity_x
    free_motion.start_y = motion.velocity_y
    free_motion.start_w = motion.angular_velocity
    motion.velocity_x = free_motion.free_x
    motion.velocity_y = free_motion.free_y
    motion.angular_velocity = free_motion.free_w


@kernel
def _is_struck(solver: SolverBodies, blocks: ContactBlocks, block_count: int, rigid: SoftContact, slow: float) -> bool:
    """Whether some contact closes in by more than its gap within the substep; those with restitution have rebounded."""
    for n in range(block_count):
        block = blocks.blocks[n]
        for k in range(block.count):
            v = blocks.lanes[n * BLOCK_SIZE + k : (n + 1) * BLOCK_SIZE]
            slot = blocks.slots[block.first + k]
            if closing_beyond_gap(solver, slot, block, v, rigid.inverse_seconds) > slow:
                return True
    return False


@kernel
def _put_aside(blocks: ContactBlocks, block_count: int) -> None:
    """Begin with no impulses; those accumulated are kept."""
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for k in range(blocks.blocks[n].count):
            v[cb.RESTING_IMPULSES + k] = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k]
            v[cb.RESTING_IMPULSES + LANES + k] = v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
            v[cb.RESTING_IMPULSES + 2 * LANES + k] = v[cb.TANGENT_IMPULSE + k]
            v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] = 0.0
            v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] = 0.0
            v[cb.TANGENT_IMPULSE + k] = 0.0
            if blocks.blocks[n].rolling == 1:
                v[cb.RESTING_IMPULSES + 3 * LANES + k] = v[cb.ROLLING_IMPULSE + k]
                v[cb.ROLLING_IMPULSE + k] = 0.0


@kernel
def _bring_back(blocks: ContactBlocks, block_count: int) -> None:
    """Report the impulses of the impact, and go on with those accumulated before."""
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for k in range(blocks.blocks[n].count):
            v[cb.TOTAL_IMPULSE + k] += v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
            v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] = v[cb.RESTING_IMPULSES + k]
            v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] = v[cb.RESTING_IMPULSES + LANES + k]
            v[cb.TANGENT_IMPULSE + k] = v[cb.RESTING_IMPULSES + 2 * LANES + k]
            if blocks.blocks[n].rolling == 1:
                v[cb.ROLLING_IMPULSE + k] = v[cb.RESTING_IMPULSES + 3 * LANES + k]

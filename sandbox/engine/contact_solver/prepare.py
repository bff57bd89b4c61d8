"""Stage: copy contacts into solver blocks before the substeps."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._prefetch import AHEAD, prefetch_row
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.closing_speed import both_meet
from sandbox.engine.contact_solver.law import (
    Anchors,
    PairMass,
    anchors_of,
    bearing_anchors,
    effective_mass,
    levers_of,
    pair_mass,
    separation_of,
)
from sandbox.engine.contact_solver.rest_length import change_level, rest_length_of
from sandbox.engine.contact_solver.soft_constraint import Spring
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import IMPACT_SPEED, IMPACTS, LEVEL, PREPARE_CONTACTS, STRUCK_BLOCKS
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES


class ImpactCriteria(NamedTuple):
    """Which contacts may have an impact in this step, if `some` may: those with restitution, and without it those in
    the first `struck_blocks`, of bodies that impacts reach, whose points meet faster than `speed` (m/s)."""

    some: bool
    struck_blocks: int
    speed: float


@kernel
def prepare_contacts(
    bodies: Records,
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
        prepare_blocks(bodies, contacts, blocks, first, end, spring, criteria)
        first, end = next_part(workers, first, end)


@kernel
def prepare_blocks(
    bodies: Records,
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
    for n in range(first, end):
        block = blocks.blocks[n]
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        if block.count < LANES:
            _clear(v)
        _begin_block(block)
        for k in range(block.count):
            at = block.first + k
            if at + AHEAD < blocks.slots.shape[0]:
                prefetch_row(contacts, blocks.slots[at + AHEAD].contact)
            slot = blocks.slots[at]
            contact = contacts[slot.contact]
            _note_bodies(block, k, slot.body_a, slot.body_b)
            _note_traits(block, contact)
            _prepare_lane(bodies[slot.body_a], bodies[slot.body_b], contact, spring.share, v[k:])
            if contact.substep_level != spring.level:
                change_level(contact, spring, v[k:])
        for k in range(block.count):
            slot = blocks.slots[block.first + k]
            a = bodies[slot.body_a]
            b = bodies[slot.body_b]
            contact = contacts[slot.contact]
            _prepare_traits(block, a, b, contact, spring.share, v[k:])
            if criteria.some and _may_impact(a, b, contact, criteria.speed, n < criteria.struck_blocks):
                _note_impact(block, v, k)


@inlined_kernel
def _clear(v: Floats) -> None:
    """Zero a block with lanes that no contact fills but the arithmetic runs over."""
    for k in range(BLOCK_SIZE):
        v[k] = 0.0


@inlined_kernel
def _begin_block(block: Records) -> None:
    block.frictional = 0
    block.rolling = 0
    block.driven = 0
    block.rounded = 0
    block.strikes = 0
    block.single = 1


@inlined_kernel
def _note_bodies(block: Records, k: int, a: int, b: int) -> None:
    """Let lane k and all behind it have these bodies: those that are not used are gathered as well."""
    if k == 0:
        block.a0 = a
        block.b0 = b
    if k <= 1:
        block.a1 = a if k == 1 else block.a0
        block.b1 = b if k == 1 else block.b0
    if k <= 2:
        block.a2 = a if k == 2 else block.a0
        block.b2 = b if k == 2 else block.b0
    block.a3 = a if k == 3 else block.a0
    block.b3 = b if k == 3 else block.b0


@inlined_kernel
def _note_traits(block: Records, contact: Records) -> None:
    """Note what some contact of a block has, and all others need not be asked for."""
    if _has_friction(contact):
        block.frictional = 1
    if contact.rolling_resistance > 0.0 or contact.rolling_impulse != 0.0:
        block.rolling = 1
    if contact.surface_speed != 0.0:
        block.driven = 1
    if contact.radius_a != 0.0 or contact.radius_b != 0.0:
        block.rounded = 1
    if contact.point_count == 2:
        block.single = 0


@inlined_kernel
def _prepare_traits(block: Records, a: Records, b: Records, contact: Records, share: float, v: Floats) -> None:
    """Fill what some contact of a block has, for one of them with lane `v`."""
    if block.rolling == 1:
        turning = a.inverse_inertia + b.inverse_inertia
        v[cb.ROLLING_RESISTANCE] = contact.rolling_resistance
        v[cb.ROLLING_MASS] = 1.0 / turning if turning > 0.0 else 0.0
        v[cb.ROLLING_IMPULSE] = share * contact.rolling_impulse
    if block.driven == 1:
        v[cb.SURFACE_SPEED] = contact.surface_speed
    if block.rounded == 1:
        v[cb.RADIUS_A] = contact.radius_a
        v[cb.RADIUS_B] = contact.radius_b


@inlined_kernel
def _may_impact(a: Records, b: Records, contact: Records, speed: float, struck: bool) -> bool:
    """Whether a contact of bodies a and b may have an impact, if one of them is `struck` also without restitution."""
    return bool(contact.restitution > 0.0 or (struck and both_meet(a, b, contact, speed)))


@inlined_kernel
def _note_impact(block: Records, v: Floats, k: int) -> None:
    """Note that lane k may have an impact; of the others of its block none has so far."""
    if block.strikes == 0:
        block.strikes = 1
        for lane in range(LANES):
            v[cb.MAY_IMPACT + lane] = 0.0
    v[cb.MAY_IMPACT + k] = 1.0


@inlined_kernel
def _prepare_lane(a: Records, b: Records, contact: Records, share: float, v: Floats) -> None:
    mass = pair_mass(a, b)
    v[cb.NORMAL_X] = contact.normal_x
    v[cb.NORMAL_Y] = contact.normal_y
    v[cb.INVERSE_MASS_A] = mass.mass_a
    v[cb.INVERSE_INERTIA_A] = mass.inertia_a
    v[cb.INVERSE_MASS_B] = mass.mass_b
    v[cb.INVERSE_INERTIA_B] = mass.inertia_b
    v[cb.FRICTION] = contact.friction
    # The first warm start applies what the last step accumulated; that belongs to no substep of this one.
    v[cb.TOTAL_IMPULSE] = -share * (contact.normal_impulse1 + contact.normal_impulse2)
    one = contact.point_count == 1
    second = 1 if one else 2  # a second point at the place of the first, without mass, never pushes
    v[cb.TANGENT_IMPULSE] = v[cb.TANGENT_MASS] = v[cb.TANGENT_LEVER_A] = v[cb.TANGENT_LEVER_B] = 0.0
    if _has_friction(contact):
        _prepare_friction(mass, contact, second, share, v)
    _prepare_point(mass, contact, 1, v[cb.POINT_1 :])
    _prepare_point(mass, contact, second, v[cb.POINT_2 :])
    if one:
        v[cb.POINT_2 + cb.NORMAL_MASS] = 0.0
    v[cb.POINT_1 + cb.NORMAL_IMPULSE] = share * contact.normal_impulse1
    v[cb.POINT_2 + cb.NORMAL_IMPULSE] = share * contact.normal_impulse2


@inlined_kernel
def _has_friction(contact: Records) -> bool:
    """Whether there is friction at a contact, or was in the step before."""
    return bool(contact.friction > 0.0 or contact.tangent_impulse1 != 0.0 or contact.tangent_impulse2 != 0.0)


@inlined_kernel
def _prepare_friction(mass: PairMass, contact: Records, second: int, share: float, v: Floats) -> None:
    r = _friction_anchors(contact, second)
    levers = levers_of(r, contact.normal_y, -contact.normal_x)
    v[cb.TANGENT_IMPULSE] = share * (contact.tangent_impulse1 + contact.tangent_impulse2)
    v[cb.TANGENT_MASS] = effective_mass(mass, r, contact.normal_y, -contact.normal_x)
    v[cb.TANGENT_LEVER_A] = levers.a
    v[cb.TANGENT_LEVER_B] = levers.b


@inlined_kernel
def _friction_anchors(contact: Records, second: int) -> Anchors:
    """Where the friction of a contact acts in a step: in the middle of what its points bore in the step before; where
    they bore nothing, at the one that is nearer, or midway."""
    load1 = contact.normal_impulse1
    load2 = contact.normal_impulse2
    if load1 + load2 <= 0.0 and second == 2:
        gap1 = separation_of(contact, 1) - rest_length_of(contact, 1)
        gap2 = separation_of(contact, 2) - rest_length_of(contact, 2)
        load1 = 1.0 if gap1 <= gap2 else 0.0
        load2 = 1.0 if gap2 <= gap1 else 0.0
    return bearing_anchors(anchors_of(contact, 1), anchors_of(contact, second), load1, load2)


@inlined_kernel
def _prepare_point(mass: PairMass, contact: Records, point: int, v: Floats) -> None:
    nx = contact.normal_x
    ny = contact.normal_y
    r = anchors_of(contact, point)
    v[cb.ANCHOR_AX] = r.ax
    v[cb.ANCHOR_AY] = r.ay
    v[cb.ANCHOR_BX] = r.bx
    v[cb.ANCHOR_BY] = r.by
    # During the substeps the gap is this plus the displacement of two points of the cores along the normal. The core
    # turns with the body; the rounding around it does not: wherever a disc has turned to, it touches below its middle.
    cores = (r.bx - r.ax) * nx + (r.by - r.ay) * ny + contact.radius_a + contact.radius_b
    v[cb.SEPARATION] = separation_of(contact, point) - cores - rest_length_of(contact, point)
    v[cb.NORMAL_MASS] = effective_mass(mass, r, nx, ny)

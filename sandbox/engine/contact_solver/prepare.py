"""Stage: copy contacts into solver blocks before the substeps."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._prefetch import AHEAD as ROWS_AHEAD
from sandbox._prefetch import prefetch_row
from sandbox._vectors import Mask, Vector, any_lane, select, spread, store
from sandbox.engine.bodies.flags import AHEAD, JOINTED
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.closing_speed import fastest_closing, stops_by_several
from sandbox.engine.contact_solver.contact_rows import (
    ANCHOR_AND_SEPARATION_2,
    ANCHORS_1,
    AXIS,
    KEPT_OF_POINT_1,
    KEPT_OF_POINT_2,
    MIXED_SURFACE,
    SEPARATION_1_AND_ANCHOR_2,
    contact_rows,
    point_counts,
)
from sandbox.engine.contact_solver.gather import PairPose, PairRows, note_rows, rows_of
from sandbox.engine.contact_solver.law import Anchors, PairMass, bearing_anchors, effective_mass, levers_of
from sandbox.engine.contact_solver.rest_length import change_level
from sandbox.engine.contact_solver.soft_constraint import Spring
from sandbox.engine.midpoint.contacts_ahead import axis_owners, move_row, ways_of
from sandbox.engine.midpoint.move_contact import Axis, moved_axis, moved_point
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.gather_fields import Rows, gather_fields
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import IMPACT_SPEED, IMPACTS, LEVEL, PREPARE_CONTACTS, STRUCK_BLOCKS
from sandbox.tables import Floats, Integers, Records
from sandbox.world.records import BODY

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES
_INVERSE_MASS = BODY.run("inverse_mass", "inverse_inertia", "force_x", "force_y")
"""Four are read at once, of which the first two are asked for."""


class ImpactCriteria(NamedTuple):
    """Which contacts may have an impact in this step, if `some` may: those with restitution, and without it those in
    the first `struck_blocks`, of bodies that impacts reach, whose points meet faster than `speed` (m/s)."""

    some: bool
    struck_blocks: int
    speed: float


class Points(NamedTuple):
    """One of the two points of each of four contacts: its anchors and its gap (m), and what it kept of the step
    before: impulses (N s) in a substep of level 0, the rest length (m)."""

    anchors: Anchors
    separation: Vector
    load: Vector
    tangent: Vector
    rest_length: Vector


class FourContacts(NamedTuple):
    """What the lanes of a block are filled from; `both` tells which contacts have two points."""

    axes: Axis
    one: Points
    two: Points
    both: Mask
    rolling_impulse: Vector


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
        four = _read_contacts(contacts, rows)
        flags = _flags_of(solver.flags, block, blocks.slots)
        if flags & AHEAD:
            owners = axis_owners(bodies, solver.flags, block, blocks.slots, contacts)
            four = _moved(four, ways_of(block, solver.motions), owners)
        _fill_lanes(block, v, contacts, rows, four, mass, spring.share)
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
            if criteria.some and _may_impact(a, b, contact, criteria.speed, struck):
                _note_impact(block, v, k)
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
    mass_a, inertia_a, _, _ = gather_fields(bodies, rows.a, _INVERSE_MASS)
    mass_b, inertia_b, _, _ = gather_fields(bodies, rows.b, _INVERSE_MASS)
    return PairMass(mass_a, inertia_a, mass_b, inertia_b)


@inlined_kernel
def _read_contacts(contacts: Records, rows: Rows) -> FourContacts:
    """What four contacts have; a second point that is not there lies at the place of the first."""
    axes = Axis(*gather_fields(contacts, rows, AXIS))
    anchors = Anchors(*gather_fields(contacts, rows, ANCHORS_1))
    separation1, ax, _, _ = gather_fields(contacts, rows, SEPARATION_1_AND_ANCHOR_2)
    ay, bx, by, separation2 = gather_fields(contacts, rows, ANCHOR_AND_SEPARATION_2)
    load, tangent, rest_length, _ = gather_fields(contacts, rows, KEPT_OF_POINT_1)
    one = Points(anchors, separation1, load, tangent, rest_length)
    load, tangent, rest_length, rolling_impulse = gather_fields(contacts, rows, KEPT_OF_POINT_2)
    both = point_counts(contacts, rows) == 2.0
    anchors = Anchors(
        select(both, ax, one.anchors.ax),
        select(both, ay, one.anchors.ay),
        select(both, bx, one.anchors.bx),
        select(both, by, one.anchors.by),
    )
    separation2 = select(both, separation2, separation1)
    two = Points(anchors, separation2, load, tangent, select(both, rest_length, one.rest_length))
    return FourContacts(axes, one, two, both, rolling_impulse)


@inlined_kernel
def _moved(four: FourContacts, way: PairPose, owners: Vector) -> FourContacts:
    """The same after the bodies have moved so far."""
    axes = moved_axis(four.axes, four.one.anchors, way, owners)
    one = _moved_points(four.one, four.axes, axes, way, owners)
    two = _moved_points(four.two, four.axes, axes, way, owners)
    return FourContacts(axes, one, two, four.both, four.rolling_impulse)


@inlined_kernel
def _moved_points(of: Points, before: Axis, after: Axis, way: PairPose, owners: Vector) -> Points:
    anchors, separation = moved_point(of.anchors, of.separation, before, after, way, owners)
    return Points(anchors, separation, of.load, of.tangent, of.rest_length)


@inlined_kernel
def _fill_lanes(
    block: Records,
    v: Floats,
    contacts: Records,
    rows: Rows,
    four: FourContacts,
    mass: PairMass,
    share: float,
) -> None:
    """Fill the lanes of a block from its contacts."""
    axes, one, two, both, rolling_impulse = four
    _, surface_speed, friction, rolling_resistance = gather_fields(contacts, rows, MIXED_SURFACE)
    # A second point at the place of the first, without mass, never pushes.
    block.single = 0 if any_lane(both) else 1
    store(v, cb.NORMAL_X, axes.x)
    store(v, cb.NORMAL_Y, axes.y)
    store(v, cb.INVERSE_MASS_A, mass.mass_a)
    store(v, cb.INVERSE_INERTIA_A, mass.inertia_a)
    store(v, cb.INVERSE_MASS_B, mass.mass_b)
    store(v, cb.INVERSE_INERTIA_B, mass.inertia_b)
    # The first warm start applies what the last step accumulated; that belongs to no substep of this one.
    store(v, cb.TOTAL_IMPULSE, -share * (one.load + two.load))
    store(v, cb.POINT_1 + cb.NORMAL_MASS, _fill_points(v, cb.POINT_1, one, axes, mass, share))
    store(v, cb.POINT_2 + cb.NORMAL_MASS, select(both, _fill_points(v, cb.POINT_2, two, axes, mass, share), 0.0))
    _fill_friction(block, v, friction, one, two, both, axes, mass, share)
    _fill_traits(block, v, surface_speed, rolling_resistance, rolling_impulse, axes, mass, share)


@inlined_kernel
def _fill_points(v: Floats, point: int, of: Points, axes: Axis, mass: PairMass, share: float) -> Vector:
    """Fill `POINT_1` or `POINT_2` of a block, but for the effective masses (kg), which are returned."""
    r = of.anchors
    store(v, point + cb.ANCHOR_AX, r.ax)
    store(v, point + cb.ANCHOR_AY, r.ay)
    store(v, point + cb.ANCHOR_BX, r.bx)
    store(v, point + cb.ANCHOR_BY, r.by)
    # During the substeps the gap is this plus the displacement of two points of the cores along the normal. The core
    # turns with the body; the rounding around it does not: wherever a disc has turned to, it touches below its middle.
    cores = (r.bx - r.ax) * axes.x + (r.by - r.ay) * axes.y + axes.radius_a + axes.radius_b
    store(v, point + cb.SEPARATION, of.separation - cores - of.rest_length)
    store(v, point + cb.NORMAL_IMPULSE, share * of.load)
    return effective_mass(mass, r, axes.x, axes.y)


@inlined_kernel
def _fill_friction(
    block: Records,
    v: Floats,
    friction: Vector,
    one: Points,
    two: Points,
    both: Mask,
    axes: Axis,
    mass: PairMass,
    share: float,
) -> None:
    """Fill what friction asks for, or zeros where there is none and was none in the step before."""
    rubs = (friction > 0.0) | (one.tangent != 0.0) | (two.tangent != 0.0)
    block.frictional = 1 if any_lane(rubs) else 0
    r = _friction_anchors(one, two, both)
    levers = levers_of(r, axes.y, -axes.x)
    store(v, cb.FRICTION, friction)
    store(v, cb.TANGENT_IMPULSE, select(rubs, share * (one.tangent + two.tangent), 0.0))
    store(v, cb.TANGENT_MASS, select(rubs, effective_mass(mass, r, axes.y, -axes.x), 0.0))
    store(v, cb.TANGENT_LEVER_A, select(rubs, levers.a, 0.0))
    store(v, cb.TANGENT_LEVER_B, select(rubs, levers.b, 0.0))


@inlined_kernel
def _friction_anchors(one: Points, two: Points, both: Mask) -> Anchors:
    """Where the friction of contacts acts in a step: in the middle of what their points bore in the step before; where
    they bore nothing, at the one that is nearer, or midway."""
    gap1 = one.separation - one.rest_length
    gap2 = two.separation - two.rest_length
    idle = both & (one.load + two.load <= 0.0)
    load1 = select(idle, select(gap1 <= gap2, spread(1.0), 0.0), one.load)
    load2 = select(idle, select(gap2 <= gap1, spread(1.0), 0.0), two.load)
    return bearing_anchors(one.anchors, two.anchors, load1, load2)


@inlined_kernel
def _fill_traits(
    block: Records,
    v: Floats,
    surface_speed: Vector,
    rolling_resistance: Vector,
    rolling_impulse: Vector,
    axes: Axis,
    mass: PairMass,
    share: float,
) -> None:
    """Fill what few contacts have, if some of the block has it: the others need not be asked for it."""
    block.rolling = 1 if any_lane((rolling_resistance > 0.0) | (rolling_impulse != 0.0)) else 0
    block.driven = 1 if any_lane(surface_speed != 0.0) else 0
    block.rounded = 1 if any_lane((axes.radius_a != 0.0) | (axes.radius_b != 0.0)) else 0
    if block.rolling == 1:
        turning = mass.inertia_a + mass.inertia_b
        turns = turning > 0.0
        store(v, cb.ROLLING_RESISTANCE, rolling_resistance)
        store(v, cb.ROLLING_MASS, select(turns, 1.0 / select(turns, turning, 1.0), 0.0))
        store(v, cb.ROLLING_IMPULSE, share * rolling_impulse)
    if block.driven == 1:
        store(v, cb.SURFACE_SPEED, surface_speed)
    if block.rounded == 1:
        store(v, cb.RADIUS_A, axes.radius_a)
        store(v, cb.RADIUS_B, axes.radius_b)


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


@inlined_kernel
def _may_impact(a: Records, b: Records, contact: Records, speed: float, struck: bool) -> bool:
    """Whether a contact of bodies a and b may have an impact, if one of them is `struck` also without restitution."""
    if contact.restitution > 0.0 or not struck:
        return bool(contact.restitution > 0.0)
    several = stops_by_several(contact.point_count, contact.rolling_resistance)
    return bool(several and fastest_closing(a, b, contact) > speed)


@inlined_kernel
def _note_impact(block: Records, v: Floats, k: int) -> None:
    """Note that lane k may have an impact; of the others of its block none has so far."""
    if block.strikes == 0:
        block.strikes = 1
        for lane in range(LANES):
            v[cb.MAY_IMPACT + lane] = 0.0
    v[cb.MAY_IMPACT + k] = 1.0

"""The lanes of a block, filled from its contacts: effective masses, anchors, and the impulses to start from.

Friction, rolling resistance, surface speeds and rounding are filled in only where some contact of the block has them.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox._vectors import Mask, Vector, any_lane, select, spread, store
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.contact_rows import MIXED_SURFACE
from sandbox.engine.contact_solver.four_contacts import FourContacts, Points
from sandbox.engine.contact_solver.law import Anchors, PairMass, bearing_anchors, effective_mass, levers_of
from sandbox.engine.midpoint.move_contact import Axis
from sandbox.engine.records.gather_fields import Rows, gather_fields
from sandbox.tables import Floats, Records


@inlined_kernel
def fill_lanes(
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

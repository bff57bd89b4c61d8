"""Stages: copy contacts into solver blocks before the substeps, and their impulses back after."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.body_flags import mark_resting
from sandbox.engine.contact_solver import blocks as cb
from sandbox.tables import Floats, Integers, Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES
VECTOR = cb.VECTOR

DEEP = 0.1
"""Share of the smaller body's extent past which an overlap is deep."""
HARD = 2.0
"""Speed (m/s) past which a contact of two points that closes in has an impact, whatever its restitution."""
_SHALLOW = -1e-3
"""Separation (m) that spares the question how large the bodies are."""


@kernel
def prepare_contacts(
    bodies: Records,
    contacts: Records,
    slots: Records,
    blocks: Records,
    block_count: int,
    bouncy: bool,
    lanes: Floats,
) -> bool:
    """Fill the lanes of every block: axes, anchors, effective masses and the impulses to start from.

    Returns whether bodies overlap deeply somewhere.
    """
    deep = False
    for n in range(block_count):
        block = blocks[n]
        base = n * BLOCK_SIZE
        _clear_last_vector(block, lanes, base)
        block.rolling = 0
        for k in range(block.count):
            slot = slots[block.first + k]
            contact = contacts[slot.contact]
            at = base + k * block.stride
            _prepare_lane(bodies[slot.body_a], bodies[slot.body_b], contact, lanes[at:])
            if contact.separation1 < _SHALLOW or contact.separation2 < _SHALLOW:
                deep = deep or _is_deep(bodies[slot.body_a], bodies[slot.body_b], contact)
            strikes = bouncy and (contact.restitution > 0.0 or closes_hard(bodies, contact))
            lanes[at + cb.BOUNCY] = 1.0 if strikes else 0.0
            if contact.rolling_resistance > 0.0:
                block.rolling = 1
    return deep


@kernel
def _is_deep(a: Records, b: Records, contact: Records) -> bool:
    limit = -DEEP * (a.extent if a.extent < b.extent else b.extent)
    return bool(contact.separation1 < limit or (contact.point_count == 2 and contact.separation2 < limit))


@kernel
def _clear_last_vector(block: Records, lanes: Floats, base: int) -> None:
    """Zero the lanes that no contact fills but the arithmetic runs over."""
    first = 0 if block.stride > 1 else block.count & ~(VECTOR - 1)
    end = LANES if block.stride > 1 or block.count > LANES - VECTOR else first + VECTOR
    for field in range(0, BLOCK_SIZE, LANES):
        for k in range(first, end):
            lanes[base + field + k] = 0.0


@inlined_kernel
def _prepare_lane(a: Records, b: Records, contact: Records, v: Floats) -> None:
    v[cb.NORMAL_X] = contact.normal_x
    v[cb.NORMAL_Y] = contact.normal_y
    v[cb.INVERSE_MASS_A] = a.inverse_mass
    v[cb.INVERSE_INERTIA_A] = a.inverse_inertia
    v[cb.INVERSE_MASS_B] = b.inverse_mass
    v[cb.INVERSE_INERTIA_B] = b.inverse_inertia
    v[cb.FRICTION] = contact.friction
    v[cb.SURFACE_SPEED] = contact.surface_speed
    v[cb.ROLLING_RESISTANCE] = contact.rolling_resistance
    v[cb.RADIUS_A] = contact.radius_a
    v[cb.RADIUS_B] = contact.radius_b
    turning = a.inverse_inertia + b.inverse_inertia
    v[cb.ROLLING_MASS] = 1.0 / turning if turning > 0.0 else 0.0
    v[cb.ROLLING_IMPULSE] = contact.rolling_impulse
    # The first warm start applies what the last step accumulated; that belongs to no substep of this one.
    v[cb.TOTAL_IMPULSE] = -(contact.normal_impulse1 + contact.normal_impulse2)
    _prepare_point(
        a,
        b,
        contact,
        contact.anchor_ax1,
        contact.anchor_ay1,
        contact.anchor_bx1,
        contact.anchor_by1,
        contact.separation1,
        contact.normal_impulse1,
        contact.tangent_impulse1,
        v,
        cb.POINT_1,
    )
    _prepare_point(
        a,
        b,
        contact,
        contact.anchor_ax2,
        contact.anchor_ay2,
        contact.anchor_bx2,
        contact.anchor_by2,
        contact.separation2,
        contact.normal_impulse2,
        contact.tangent_impulse2,
        v,
        cb.POINT_2,
    )
    if contact.point_count == 1:
        v[cb.POINT_2 + cb.NORMAL_MASS] = 0.0
        v[cb.POINT_2 + cb.TANGENT_MASS] = 0.0


@inlined_kernel
def _prepare_point(
    a: Records,
    b: Records,
    contact: Records,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    separation: float,
    normal_impulse: float,
    tangent_impulse: float,
    v: Floats,
    point: int,
) -> None:
    nx = contact.normal_x
    ny = contact.normal_y
    v[point + cb.ANCHOR_AX] = ax
    v[point + cb.ANCHOR_AY] = ay
    v[point + cb.ANCHOR_BX] = bx
    v[point + cb.ANCHOR_BY] = by
    # During the substeps the gap is this plus the way of two points of the cores along the normal. The core turns with
    # the body; the rounding around it does not: wherever a disc has turned to, it touches below its middle.
    way = (bx - ax) * nx + (by - ay) * ny + contact.radius_a + contact.radius_b
    v[point + cb.SEPARATION] = separation - way
    v[point + cb.NORMAL_MASS] = effective_mass(a, b, ax, ay, bx, by, nx, ny)
    v[point + cb.TANGENT_MASS] = effective_mass(a, b, ax, ay, bx, by, ny, -nx)
    v[point + cb.NORMAL_IMPULSE] = normal_impulse
    v[point + cb.TANGENT_IMPULSE] = tangent_impulse


@kernel
def effective_mass(a: Records, b: Records, ax: float, ay: float, bx: float, by: float, nx: float, ny: float) -> float:
    """Effective mass (kg) of two bodies along the unit axis (nx, ny) at anchors a and b; 0 if neither moves."""
    turn_a = ax * ny - ay * nx
    turn_b = bx * ny - by * nx
    inverse = (
        a.inverse_mass + b.inverse_mass + a.inverse_inertia * turn_a * turn_a + b.inverse_inertia * turn_b * turn_b
    )
    return 1.0 / inverse if inverse > 0.0 else 0.0


@kernel
def closes_hard(bodies: Records, contact: Records) -> bool:
    """Whether two points of a contact meet, one of them faster than `HARD` as the step begins.

    A single point the solver stops exactly.
    """
    if contact.point_count < 2:
        return False
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    first = _closing_speed(
        a, b, contact, contact.anchor_ax1, contact.anchor_ay1, contact.anchor_bx1, contact.anchor_by1
    )
    second = _closing_speed(
        a, b, contact, contact.anchor_ax2, contact.anchor_ay2, contact.anchor_bx2, contact.anchor_by2
    )
    return bool(first > HARD or second > HARD)


@kernel
def clear_reports(reports: Records, count: int) -> None:
    """Contacts that are not solved, such as those among sleepers, have nothing to report."""
    for i in range(count):
        reports[i].total_impulse = 0.0
        reports[i].hit_speed = 0.0


@kernel
def store_impulses(
    bodies: Records,
    marks: Integers,
    contacts: Records,
    slots: Records,
    blocks: Records,
    block_count: int,
    lanes: Floats,
    reports: Records,
) -> None:
    """Copy the accumulated impulses back into the contacts, to warm start the next step, and report on this one.

    The bodies still have the velocities with which the step began: a point that begins to push has closed in at them.
    What they bear is marked as resting.
    """
    for n in range(block_count):
        for k in range(blocks[n].count):
            slot = slots[blocks[n].first + k]
            contact = contacts[slot.contact]
            report = reports[slot.contact]
            at = n * BLOCK_SIZE + k * blocks[n].stride
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
            contact.rolling_impulse = lanes[at + cb.ROLLING_IMPULSE]
            contact.normal_impulse1 = normal1
            contact.tangent_impulse1 = lanes[at + cb.POINT_1 + cb.TANGENT_IMPULSE]
            if contact.point_count == 2:
                contact.normal_impulse2 = normal2
                contact.tangent_impulse2 = lanes[at + cb.POINT_2 + cb.TANGENT_IMPULSE]
            pushes = normal1 > 0.0 or normal2 > 0.0
            mark_resting(marks, slot.body_a, slot.body_b, pushes, contact.surface_speed)


@kernel
def _hit_speed(a: Records, b: Records, contact: Records) -> float:
    """Speed (m/s) at which the points that did not push before have closed in; 0 if they did not."""
    struck = contact.impact_impulse > 0.0
    speed = 0.0
    if struck or contact.normal_impulse1 == 0.0:
        speed = _closing_speed(
            a, b, contact, contact.anchor_ax1, contact.anchor_ay1, contact.anchor_bx1, contact.anchor_by1
        )
    if contact.point_count == 2 and (struck or contact.normal_impulse2 == 0.0):
        other = _closing_speed(
            a, b, contact, contact.anchor_ax2, contact.anchor_ay2, contact.anchor_bx2, contact.anchor_by2
        )
        speed = other if other > speed else speed
    return speed if speed > 0.0 else 0.0


@kernel
def _closing_speed(a: Records, b: Records, contact: Records, ax: float, ay: float, bx: float, by: float) -> float:
    """Speed (m/s) at which two points of the bodies approach along the normal."""
    x = b.velocity_x - b.angular_velocity * by - a.velocity_x + a.angular_velocity * ay
    y = b.velocity_y + b.angular_velocity * bx - a.velocity_y - a.angular_velocity * ax
    closing: float = -(x * contact.normal_x + y * contact.normal_y)
    return closing

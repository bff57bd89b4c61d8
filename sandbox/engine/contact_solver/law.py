"""The laws of a contact point, written once: relative velocity, impulse, effective mass and Coulomb's cone.

An impulse p at the anchors r_a and r_b changes v_b by p / m_b and w_b by (r_b x p) / I_b, and a by the opposite.
Most of them take single numbers as well as vectors, of contacts side by side.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox._vectors import Number, select
from sandbox.tables import Records


class PairVelocity(NamedTuple):
    """Velocities (m/s) and angular velocities (rad/s) of two bodies."""

    ax: Number
    ay: Number
    aw: Number
    bx: Number
    by: Number
    bw: Number


class PairMass(NamedTuple):
    """Inverse masses (1/kg) and inverse inertias (1/(kg m^2)) of two bodies."""

    mass_a: Number
    inertia_a: Number
    mass_b: Number
    inertia_b: Number


class Anchors(NamedTuple):
    """A contact point as seen from the centres of two bodies, world axes, m."""

    ax: Number
    ay: Number
    bx: Number
    by: Number


class Levers(NamedTuple):
    """How far an axis through a contact point passes by the centres of two bodies: r x axis, m."""

    a: Number
    b: Number


class PointImpulses(NamedTuple):
    """Normal impulses (N s) at the two points of a contact."""

    first: Number
    second: Number


@inlined_kernel
def relative_velocity(v: PairVelocity, r: Anchors) -> tuple[Number, Number]:
    """Velocity (m/s) of b's point against that of a."""
    x = (v.bx - v.ax) - (v.bw * r.by - v.aw * r.ay)
    y = (v.by - v.ay) + (v.bw * r.bx - v.aw * r.ax)
    return x, y


@inlined_kernel
def levers_of(r: Anchors, x: Number, y: Number) -> Levers:
    """The levers of the unit axis (x, y) through a point."""
    return Levers(r.ax * y - r.ay * x, r.bx * y - r.by * x)


@inlined_kernel
def speed_of_centers(v: PairVelocity, x: Number, y: Number) -> Number:
    """Speed (m/s) of b's centre against that of a along the unit axis (x, y)."""
    return (v.bx - v.ax) * x + (v.by - v.ay) * y


@inlined_kernel
def speed_of_turning(v: PairVelocity, levers: Levers) -> Number:
    """What the spins add to it at a point, m/s."""
    return v.bw * levers.b - v.aw * levers.a


@inlined_kernel
def velocity_change(m: PairMass, r: Anchors, px: Number, py: Number) -> PairVelocity:
    """What the impulse (px, py) N s on b at its anchor, and the opposite on a at its own, add to the velocities."""
    return PairVelocity(
        -(m.mass_a * px),
        -(m.mass_a * py),
        (m.inertia_a * r.ay) * px - (m.inertia_a * r.ax) * py,
        m.mass_b * px,
        m.mass_b * py,
        (m.inertia_b * r.bx) * py - (m.inertia_b * r.by) * px,
    )


@inlined_kernel
def apply_impulse(v: PairVelocity, m: PairMass, r: Anchors, px: Number, py: Number) -> PairVelocity:
    """The velocities after the impulse (px, py) N s on b at its anchor, and the opposite on a at its own."""
    change = velocity_change(m, r, px, py)
    return PairVelocity(
        v.ax + change.ax, v.ay + change.ay, v.aw + change.aw, v.bx + change.bx, v.by + change.by, v.bw + change.bw
    )


@inlined_kernel
def push_along(v: PairVelocity, m: PairMass, levers: Levers, impulse: Number, x: Number, y: Number) -> PairVelocity:
    """The velocities after an impulse (N s) along the unit axis (x, y) with these levers."""
    return PairVelocity(
        v.ax - m.mass_a * (impulse * x),
        v.ay - m.mass_a * (impulse * y),
        v.aw - (m.inertia_a * levers.a) * impulse,
        v.bx + m.mass_b * (impulse * x),
        v.by + m.mass_b * (impulse * y),
        v.bw + (m.inertia_b * levers.b) * impulse,
    )


@inlined_kernel
def push_along_both(
    v: PairVelocity, m: PairMass, levers1: Levers, levers2: Levers, impulses: PointImpulses, x: Number, y: Number
) -> PairVelocity:
    """The velocities after impulses along the axis at both points of a contact, whichever is called the first."""
    px = (impulses.first + impulses.second) * x
    py = (impulses.first + impulses.second) * y
    return PairVelocity(
        v.ax - m.mass_a * px,
        v.ay - m.mass_a * py,
        v.aw - ((m.inertia_a * levers1.a) * impulses.first + (m.inertia_a * levers2.a) * impulses.second),
        v.bx + m.mass_b * px,
        v.by + m.mass_b * py,
        v.bw + ((m.inertia_b * levers1.b) * impulses.first + (m.inertia_b * levers2.b) * impulses.second),
    )


@inlined_kernel
def push_both(
    v: PairVelocity, m: PairMass, r1: Anchors, r2: Anchors, normal: PointImpulses, nx: Number, ny: Number
) -> PairVelocity:
    """The same for normal impulses at these anchors."""
    return push_along_both(v, m, levers_of(r1, nx, ny), levers_of(r2, nx, ny), normal, nx, ny)


@inlined_kernel
def effective_mass(m: PairMass, r: Anchors, x: Number, y: Number) -> Number:
    """Effective mass (kg) of two bodies along the unit axis (x, y) at a point; 0 if neither moves."""
    turn_a = r.ax * y - r.ay * x
    turn_b = r.bx * y - r.by * x
    inverse = m.mass_a + m.mass_b + m.inertia_a * turn_a * turn_a + m.inertia_b * turn_b * turn_b
    moves = inverse > 0.0
    return select(moves, 1.0 / select(moves, inverse, 1.0), 0.0)


@inlined_kernel
def coupling(m: PairMass, levers1: Levers, levers2: Levers) -> Number:
    """Change of normal velocity at one point of a contact for a normal impulse at the other, 1/kg."""
    return m.mass_a + m.mass_b + m.inertia_a * (levers1.a * levers2.a) + m.inertia_b * (levers1.b * levers2.b)


@inlined_kernel
def bearing_anchors(r1: Anchors, r2: Anchors, load1: Number, load2: Number) -> Anchors:
    """Where the friction of two points acts, that bear so much (N s): in the middle of what they bear.

    Their tangents are on one line, or nearly so; where along it makes no difference.
    """
    load = load1 + load2
    bears = load > 0.0
    load = select(bears, load, 1.0)
    share1 = select(bears, load1 / load, 0.5)
    share2 = select(bears, load2 / load, 0.5)
    return Anchors(
        share1 * r1.ax + share2 * r2.ax,
        share1 * r1.ay + share2 * r2.ay,
        share1 * r1.bx + share2 * r2.bx,
        share1 * r1.by + share2 * r2.by,
    )


@inlined_kernel
def clamp_to_cone(impulse: Number, limit: Number) -> Number:
    """A tangent impulse (N s) within Coulomb's cone, whose half width is friction times normal impulse, the `limit`."""
    impulse = select(impulse < limit, impulse, limit)
    return select(impulse > -limit, impulse, -limit)


@inlined_kernel
def pair_mass(a: Records, b: Records) -> PairMass:
    """The inverse masses of two rows of the body table."""
    return PairMass(a.inverse_mass, a.inverse_inertia, b.inverse_mass, b.inverse_inertia)


@inlined_kernel
def pair_velocity(a: Records, b: Records) -> PairVelocity:
    """The velocities of two rows of the body table, or of the motion table."""
    return PairVelocity(a.velocity_x, a.velocity_y, a.angular_velocity, b.velocity_x, b.velocity_y, b.angular_velocity)


@inlined_kernel
def set_pair_velocity(a: Records, b: Records, v: PairVelocity) -> None:
    """Write the velocities of two rows of the body table, or of the motion table."""
    a.velocity_x = v.ax
    a.velocity_y = v.ay
    a.angular_velocity = v.aw
    b.velocity_x = v.bx
    b.velocity_y = v.by
    b.angular_velocity = v.bw


@inlined_kernel
def start_velocity(free_motions: Records, contact: Records) -> PairVelocity:
    """The velocities of a contact's bodies at the start of the substep, impacts so far included."""
    a = free_motions[contact.body_a]
    b = free_motions[contact.body_b]
    return PairVelocity(a.start_x, a.start_y, a.start_w, b.start_x, b.start_y, b.start_w)


@inlined_kernel
def anchors_of(contact: Records, point: int) -> Anchors:
    """The anchors of point 1 or 2 of a contact."""
    first = point == 1
    return Anchors(
        contact.anchor_ax1 if first else contact.anchor_ax2,
        contact.anchor_ay1 if first else contact.anchor_ay2,
        contact.anchor_bx1 if first else contact.anchor_bx2,
        contact.anchor_by1 if first else contact.anchor_by2,
    )


@inlined_kernel
def separation_of(contact: Records, point: int) -> float:
    """The gap (m) at point 1 or 2 of a contact when the step began; negative where they overlap."""
    return float(contact.separation1 if point == 1 else contact.separation2)

"""What the impact of one contact does to its two bodies: along the normal, and by friction along the tangent.

Their velocities are taken out of the tables once, changed by all impulses of the impact, and put back.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.law import (
    Anchors,
    PairMass,
    PairVelocity,
    PointImpulses,
    anchors_of,
    apply_impulse,
    bearing_anchors,
    effective_mass,
    pair_mass,
    push_both,
    relative_velocity,
    separation_of,
    start_velocity,
)
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Records
from sandbox.world.records import STATIC


class Struck(NamedTuple):
    """Velocities of two bodies that an impact changes alike: at the start of the substep and free at its end."""

    start: PairVelocity
    free: PairVelocity


class Rub(NamedTuple):
    """Where and how a contact rubs: the anchors on both surfaces (m), the effective mass (kg) along the tangent."""

    anchors: Anchors
    tangent_x: float
    tangent_y: float
    mass: float


@inlined_kernel
def take(free_motions: Records, contact: Records) -> Struck:
    """The velocities of a contact's bodies, impacts so far included."""
    return Struck(start_velocity(free_motions, contact), free_velocity(free_motions, contact))


@kernel
def put_back(solver: SolverBodies, contact: Records, struck: Struck) -> None:
    """Make the velocities after an impact those of the bodies, for the solver too."""
    v = struck.start
    u = struck.free
    _write(solver.motions[contact.body_a], solver.free_motions[contact.body_a], v.ax, v.ay, v.aw, u.ax, u.ay, u.aw)
    _write(solver.motions[contact.body_b], solver.free_motions[contact.body_b], v.bx, v.by, v.bw, u.bx, u.by, u.bw)


@inlined_kernel
def push(struck: Struck, mass: PairMass, r: Anchors, px: float, py: float) -> Struck:
    """The velocities after the impulse (px, py) N s on b at its anchor and the opposite on a at its own."""
    return Struck(apply_impulse(struck.start, mass, r, px, py), apply_impulse(struck.free, mass, r, px, py))


@inlined_kernel
def push_points(struck: Struck, contact: Records, mass: PairMass, load1: float, load2: float) -> Struck:
    """The velocities after normal impulses (N s) at both points of a contact."""
    r1 = anchors_of(contact, 1)
    r2 = anchors_of(contact, 2)
    loads = PointImpulses(load1, load2)
    nx = contact.normal_x
    ny = contact.normal_y
    return Struck(
        push_both(struck.start, mass, r1, r2, loads, nx, ny), push_both(struck.free, mass, r1, r2, loads, nx, ny)
    )


@inlined_kernel
def rub_of(a: Records, b: Records, contact: Records, load1: float, load2: float) -> Rub:
    """Where a contact between bodies a and b rubs, whose points bear so much (N s)."""
    r = bearing_anchors(_touching_anchors(a, b, contact, 1), _touching_anchors(a, b, contact, 2), load1, load2)
    tx = contact.normal_y
    ty = -contact.normal_x
    return Rub(r, tx, ty, effective_mass(pair_mass(a, b), r, tx, ty))


@inlined_kernel
def rub_between(a: Records, b: Records, contact: Records) -> Rub:
    """The same in the middle of its points, which are on one line with all that they could bear."""
    return rub_of(a, b, contact, 1.0, 1.0 if contact.point_count == 2 else 0.0)


@inlined_kernel
def slip_speed(v: PairVelocity, rub: Rub) -> float:
    """The speed (m/s) at which b slides over a."""
    vx, vy = relative_velocity(v, rub.anchors)
    return float(vx * rub.tangent_x + vy * rub.tangent_y)


@inlined_kernel
def free_velocity(free_motions: Records, contact: Records) -> PairVelocity:
    """The velocities of a contact's bodies at the end of the substep if nothing else touches them."""
    a = free_motions[contact.body_a]
    b = free_motions[contact.body_b]
    return PairVelocity(a.free_x, a.free_y, a.free_w, b.free_x, b.free_y, b.free_w)


@inlined_kernel
def _touching_anchors(a: Records, b: Records, contact: Records, point: int) -> Anchors:
    """Anchors (m) of a point on both surfaces, from the centres of a and b.

    A contact of two bodies that move has them half way between the surfaces, which were apart when it was found;
    but the impact falls when they have met, and half a gap would be a longer arm for its friction.
    """
    r = anchors_of(contact, point)
    if a.type == STATIC or b.type == STATIC:
        return r
    # The contact was found where b had come nearer by this: the gap is what was left there.
    nearer = (b.center_x + r.bx - a.center_x - r.ax) * contact.normal_x
    nearer = nearer + (b.center_y + r.by - a.center_y - r.ay) * contact.normal_y
    half = 0.5 * (separation_of(contact, point) - nearer)
    half = half if half > 0.0 else 0.0
    x = half * contact.normal_x
    y = half * contact.normal_y
    return Anchors(r.ax - x, r.ay - y, r.bx + x, r.by + y)


@inlined_kernel
def _write(
    motion: Records, free_motion: Records, x: float, y: float, w: float, free_x: float, free_y: float, free_w: float
) -> None:
    """Write a body's velocities at the start of the substep and at its end."""
    free_motion.start_x = x
    free_motion.start_y = y
    free_motion.start_w = w
    free_motion.free_x = motion.velocity_x = free_x
    free_motion.free_y = motion.velocity_y = free_y
    free_motion.free_w = motion.angular_velocity = free_w

"""What the impact of one contact does to its two bodies: along the normal, and by friction along the tangent."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import (
    Anchors,
    PairVelocity,
    anchors_of,
    clamp_to_cone,
    effective_mass,
    pair_mass,
    relative_velocity,
    separation_of,
    velocity_change,
)
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Records


@kernel
def apply_normal_impulse(bodies: Records, solver: SolverBodies, contact: Records, impulse: float, point: int) -> None:
    """Apply a normal impulse (N s) at point 1 or 2."""
    r = _touching_anchors(bodies[contact.body_a], bodies[contact.body_b], contact, point)
    _apply(bodies, solver, contact, r, impulse * contact.normal_x, impulse * contact.normal_y)


@kernel
def apply_friction(
    bodies: Records, solver: SolverBodies, contact: Records, load: float, before: float, point: int
) -> float:
    """Coulomb friction of the impact: stop the sliding at a point, as far as the normal impulse `load` (N s) allows.

    `before` (N s) has been applied already; returns what has been after this.
    """
    if contact.friction <= 0.0:
        return 0.0
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    r = _touching_anchors(a, b, contact, point)
    tx = contact.normal_y
    ty = -contact.normal_x
    vx, vy = relative_velocity(start_velocity(solver.free_motions, contact), r)
    speed = vx * tx + vy * ty - contact.surface_speed
    mass = effective_mass(pair_mass(a, b), r, tx, ty)
    after = clamp_to_cone(before - mass * speed, contact.friction * load)
    impulse = after - before
    _apply(bodies, solver, contact, r, impulse * tx, impulse * ty)
    return float(after)


@kernel
def start_velocity(free_motions: Records, contact: Records) -> PairVelocity:
    """The velocities of a contact's bodies at the start of the substep, impacts so far included."""
    a = free_motions[contact.body_a]
    b = free_motions[contact.body_b]
    return PairVelocity(a.start_x, a.start_y, a.start_w, b.start_x, b.start_y, b.start_w)


@kernel
def free_velocity(free_motions: Records, contact: Records) -> PairVelocity:
    """The velocities of a contact's bodies at the end of the substep if nothing else touches them."""
    a = free_motions[contact.body_a]
    b = free_motions[contact.body_b]
    return PairVelocity(a.free_x, a.free_y, a.free_w, b.free_x, b.free_y, b.free_w)


@kernel
def _touching_anchors(a: Records, b: Records, contact: Records, point: int) -> Anchors:
    """Anchors (m) of a point on both surfaces, from the centres of a and b.

    The contact has them half way between the surfaces, which were apart still when it was found; but the impact falls
    when they have met, and half a gap would be a longer arm for its friction.
    """
    r = anchors_of(contact, point)
    # The contact was found where b had come nearer by this: the gap is what was left there.
    nearer = (b.center_x + r.bx - a.center_x - r.ax) * contact.normal_x
    nearer = nearer + (b.center_y + r.by - a.center_y - r.ay) * contact.normal_y
    half = 0.5 * (separation_of(contact, point) - nearer)
    half = half if half > 0.0 else 0.0
    x = half * contact.normal_x
    y = half * contact.normal_y
    return Anchors(r.ax - x, r.ay - y, r.bx + x, r.by + y)


@kernel
def _apply(bodies: Records, solver: SolverBodies, contact: Records, r: Anchors, px: float, py: float) -> None:
    """Apply the impulse (px, py) N s to b at its anchor and the opposite to a at its own."""
    ia = contact.body_a
    ib = contact.body_b
    change = velocity_change(pair_mass(bodies[ia], bodies[ib]), r, px, py)
    _add(solver.motions[ia], solver.free_motions[ia], change.ax, change.ay, change.aw)
    _add(solver.motions[ib], solver.free_motions[ib], change.bx, change.by, change.bw)


@kernel
def _add(motion: Records, free_motion: Records, x: float, y: float, w: float) -> None:
    """Change a body's velocity at the start of the substep and everything derived from it."""
    free_motion.start_x += x
    free_motion.start_y += y
    free_motion.start_w += w
    free_motion.free_x += x
    free_motion.free_y += y
    free_motion.free_w += w
    motion.velocity_x = free_motion.free_x
    motion.velocity_y = free_motion.free_y
    motion.angular_velocity = free_motion.free_w

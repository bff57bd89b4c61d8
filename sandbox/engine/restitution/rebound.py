"""How impacts that strike together rebound: by 1 + e times the impulses that would stop them, scaled.

The scale is that with which they take the most energy: so the group keeps all of it with e = 1 and never gains any,
however exact the impulses are.

Source: J. J. Moreau 1985; B. Smith, D. Kaufman, E. Vouga, R. Tamstorf and E. Grinspun, "Reflections on simultaneous
impact", ACM Transactions on Graphics 31 (2012).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import pair_mass, pair_velocity, start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import next_of
from sandbox.engine.restitution.impulses import friction_impulse, push, push_points, put_back, rub_of, take
from sandbox.tables import Records


@kernel
def rebound(bodies: Records, solver: SolverBodies, contacts: Records, group: Records) -> None:
    """Apply the impulses with restitution to the velocities of the substep, and then the friction that they allow.

    In: the loads of the group, and `solver.motions` after them.
    """
    scale = _scale(solver, contacts, group)
    k = 0
    while k >= 0:
        slot = group[k]
        contact = contacts[slot.contact]
        slot.load1 *= scale
        slot.load2 *= scale
        mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
        struck = push_points(take(solver.free_motions, contact), contact, mass, slot.load1, slot.load2)
        put_back(solver, contact, struck)
        contact.impact_impulse += slot.load1 + slot.load2
        k = next_of(group, k)
    k = 0
    while k >= 0:
        slot = group[k]
        _rub(bodies, solver, contacts[slot.contact], slot.load1, slot.load2)
        k = next_of(group, k)


@kernel
def _rub(bodies: Records, solver: SolverBodies, contact: Records, load1: float, load2: float) -> None:
    """Apply the friction that normal impulses (N s) at the points of a contact allow, after they have acted."""
    if contact.friction <= 0.0 or load1 + load2 <= 0.0:
        return
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    rub = rub_of(a, b, contact, load1, load2)
    struck = take(solver.free_motions, contact)
    drag = friction_impulse(struck, rub, contact.surface_speed, contact.friction * (load1 + load2), 0.0)
    put_back(solver, contact, push(struck, pair_mass(a, b), rub.anchors, drag * rub.tangent_x, drag * rub.tangent_y))


@kernel
def _scale(solver: SolverBodies, contacts: Records, group: Records) -> float:
    """By how much to multiply the loads.

    With loads p, u at the start and w when they have been applied, p u is the work per unit of scale and p (w - u) the
    square: the scale -p u / p (w - u) takes the most energy. Restitution is the mean over what closes, by its work.
    """
    work = square = closed = given = 0.0
    k = 0
    while k >= 0:
        slot = group[k]
        contact = contacts[slot.contact]
        start = start_velocity(solver.free_motions, contact)
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        restitution = contact.restitution if contact.restitution < 1.0 else 1.0
        for point in range(1, contact.point_count + 1):
            load = slot.load1 if point == 1 else slot.load2
            before = opening_speed(start, contact, point)
            work += load * before
            square += load * (opening_speed(now, contact, point) - before)
            closed += load * before if before < 0.0 else 0.0
            given += restitution * load * before if before < 0.0 else 0.0
        k = next_of(group, k)
    return (1.0 + given / closed) * (-work / square) if work < 0.0 < square else 0.0

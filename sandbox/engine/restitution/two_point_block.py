"""The normal impulses of a contact's two points that together give the wanted changes of velocity."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.prepare import effective_mass
from sandbox.tables import Records

_SINGULAR = 1e-9


@kernel
def pair_impulses(a: Records, b: Records, contact: Records, change1: float, change2: float) -> tuple[float, float]:
    """Normal impulses (N s) at the two points that give both wanted changes, none of them pulling."""
    mass1 = effective_mass(
        a,
        b,
        contact.anchor_ax1,
        contact.anchor_ay1,
        contact.anchor_bx1,
        contact.anchor_by1,
        contact.normal_x,
        contact.normal_y,
    )
    if change1 <= 0.0 and change2 <= 0.0:
        return 0.0, 0.0
    if change2 <= 0.0:
        return mass1 * change1, 0.0
    mass2 = effective_mass(
        a,
        b,
        contact.anchor_ax2,
        contact.anchor_ay2,
        contact.anchor_bx2,
        contact.anchor_by2,
        contact.normal_x,
        contact.normal_y,
    )
    if change1 <= 0.0:
        return 0.0, mass2 * change2
    if mass1 <= 0.0 or mass2 <= 0.0:
        return 0.0, 0.0
    k11 = 1.0 / mass1
    k22 = 1.0 / mass2
    turn_a1 = contact.anchor_ax1 * contact.normal_y - contact.anchor_ay1 * contact.normal_x
    turn_a2 = contact.anchor_ax2 * contact.normal_y - contact.anchor_ay2 * contact.normal_x
    turn_b1 = contact.anchor_bx1 * contact.normal_y - contact.anchor_by1 * contact.normal_x
    turn_b2 = contact.anchor_bx2 * contact.normal_y - contact.anchor_by2 * contact.normal_x
    k12 = a.inverse_mass + b.inverse_mass
    k12 = k12 + a.inverse_inertia * turn_a1 * turn_a2 + b.inverse_inertia * turn_b1 * turn_b2
    determinant = k11 * k22 - k12 * k12
    if determinant > _SINGULAR * k11 * k22:
        impulse1 = (k22 * change1 - k12 * change2) / determinant
        impulse2 = (k11 * change2 - k12 * change1) / determinant
        if impulse1 >= 0.0 and impulse2 >= 0.0:
            return impulse1, impulse2
    if change1 >= change2:
        return mass1 * change1, 0.0
    return 0.0, mass2 * change2

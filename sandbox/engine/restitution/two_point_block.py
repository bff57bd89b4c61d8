"""Block solver of a contact's two points: the normal impulses that together give the wanted changes of velocity.

E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005, solves two points so; here it is done for impacts.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import anchors_of, effective_mass, pair_mass
from sandbox.tables import Records

_SINGULAR = 1e-9


@kernel
def pair_impulses(a: Records, b: Records, contact: Records, change1: float, change2: float) -> tuple[float, float]:
    """Normal impulses (N s) at the two points that give both wanted changes, none of them pulling."""
    mass = pair_mass(a, b)
    r1 = anchors_of(contact, 1)
    r2 = anchors_of(contact, 2)
    nx = contact.normal_x
    ny = contact.normal_y
    mass1 = effective_mass(mass, r1, nx, ny)
    if change1 <= 0.0 and change2 <= 0.0:
        return 0.0, 0.0
    if change2 <= 0.0:
        return mass1 * change1, 0.0
    mass2 = effective_mass(mass, r2, nx, ny)
    if change1 <= 0.0:
        return 0.0, mass2 * change2
    if mass1 <= 0.0 or mass2 <= 0.0:
        return 0.0, 0.0
    k11 = 1.0 / mass1
    k22 = 1.0 / mass2
    turn_a1 = r1.ax * ny - r1.ay * nx
    turn_a2 = r2.ax * ny - r2.ay * nx
    turn_b1 = r1.bx * ny - r1.by * nx
    turn_b2 = r2.bx * ny - r2.by * nx
    k12 = mass.mass_a + mass.mass_b
    k12 = k12 + mass.inertia_a * turn_a1 * turn_a2 + mass.inertia_b * turn_b1 * turn_b2
    determinant = k11 * k22 - k12 * k12
    if determinant > _SINGULAR * k11 * k22:
        impulse1 = (k22 * change1 - k12 * change2) / determinant
        impulse2 = (k11 * change2 - k12 * change1) / determinant
        if impulse1 >= 0.0 and impulse2 >= 0.0:
            return impulse1, impulse2
    if change1 >= change2:
        return mass1 * change1, 0.0
    return 0.0, mass2 * change2

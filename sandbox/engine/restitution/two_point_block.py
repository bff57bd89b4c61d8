"""Block solver of a contact's two points: the normal impulses that together give the wanted changes of velocity.

E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005, solves two points so; here it is done for impacts.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox.engine.contact_solver.law import Anchors, PairMass, anchors_of, effective_mass
from sandbox.tables import Records

_SINGULAR = 1e-9


class Block(NamedTuple):
    """Effective masses (kg) of two points along the normal, and the matrix (1/kg) of both with its determinant."""

    mass1: float
    mass2: float
    k11: float
    k12: float
    k22: float
    determinant: float


@inlined_kernel
def block_of(contact: Records, mass: PairMass) -> Block:
    """The block of a contact of bodies with these masses, of as many points as it has."""
    r1 = anchors_of(contact, 1)
    if contact.point_count == 2:
        return two_points(contact, mass, r1, anchors_of(contact, 2))
    return one_point(contact, mass, r1)


@inlined_kernel
def one_point(contact: Records, mass: PairMass, r1: Anchors) -> Block:
    """The block of a contact that has but point 1."""
    return Block(effective_mass(mass, r1, contact.normal_x, contact.normal_y), 0.0, 0.0, 0.0, 0.0, 0.0)


@inlined_kernel
def two_points(contact: Records, mass: PairMass, r1: Anchors, r2: Anchors) -> Block:
    """The block of two points of bodies with these masses."""
    nx = contact.normal_x
    ny = contact.normal_y
    mass1 = effective_mass(mass, r1, nx, ny)
    mass2 = effective_mass(mass, r2, nx, ny)
    k11 = 1.0 / mass1 if mass1 > 0.0 else 0.0
    k22 = 1.0 / mass2 if mass2 > 0.0 else 0.0
    turn_a1 = r1.ax * ny - r1.ay * nx
    turn_a2 = r2.ax * ny - r2.ay * nx
    turn_b1 = r1.bx * ny - r1.by * nx
    turn_b2 = r2.bx * ny - r2.by * nx
    k12 = mass.mass_a + mass.mass_b
    k12 = k12 + mass.inertia_a * turn_a1 * turn_a2 + mass.inertia_b * turn_b1 * turn_b2
    return Block(mass1, mass2, k11, k12, k22, k11 * k22 - k12 * k12)


@inlined_kernel
def pair_impulses(block: Block, change1: float, change2: float) -> tuple[float, float]:
    """Normal impulses (N s) at the two points that give both wanted changes, none of them pulling."""
    if change1 <= 0.0 and change2 <= 0.0:
        return 0.0, 0.0
    if change2 <= 0.0:
        return block.mass1 * change1, 0.0
    if change1 <= 0.0:
        return 0.0, block.mass2 * change2
    if block.mass1 <= 0.0 or block.mass2 <= 0.0:
        return 0.0, 0.0
    if block.determinant > _SINGULAR * block.k11 * block.k22:
        impulse1 = (block.k22 * change1 - block.k12 * change2) / block.determinant
        impulse2 = (block.k11 * change2 - block.k12 * change1) / block.determinant
        if impulse1 >= 0.0 and impulse2 >= 0.0:
            return impulse1, impulse2
    if change1 >= change2:
        return block.mass1 * change1, 0.0
    return 0.0, block.mass2 * change2


@inlined_kernel
def bearing_impulses(block: Block, ask1: float, ask2: float) -> tuple[float, float]:
    """Normal impulses (N s) of which none pulls, that change each velocity (m/s) by what is asked or more, and by no
    more where they push: the complementarity problem of two points, by trying who pushes."""
    if ask1 <= 0.0 and ask2 <= 0.0:
        return 0.0, 0.0
    if block.determinant > _SINGULAR * block.k11 * block.k22:
        impulse1 = (block.k22 * ask1 - block.k12 * ask2) / block.determinant
        impulse2 = (block.k11 * ask2 - block.k12 * ask1) / block.determinant
        if impulse1 >= 0.0 and impulse2 >= 0.0:
            return impulse1, impulse2
        if impulse1 >= 0.0 and ask1 > 0.0:
            return block.mass1 * ask1, 0.0
        if ask2 > 0.0:
            return 0.0, block.mass2 * ask2
    if ask1 >= ask2:
        return block.mass1 * ask1, 0.0
    return 0.0, block.mass2 * ask2

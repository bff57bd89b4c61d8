"""Friction within a blow: by how much it changes the normal impulse that restitution asks for, and what it gives.

A blow at one point passes through its normal impulse P in straight pieces: while the point slides, friction grows with
P against the sliding; once that has stopped, the point sticks, or slides back where friction cannot hold it. Along
each piece the normal and the tangent velocity change evenly with P. Restitution multiplies the impulse at which the
point no longer closes (Poisson), so that no blow gains energy.

Source: E. J. Routh, Dynamics of a System of Rigid Bodies (1905), articles 187 to 199; Y. Wang, M. Mason,
"Two-dimensional rigid-body collisions with friction", Journal of Applied Mechanics 59 (1992).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.law import PairMass, PairVelocity, levers_of, relative_velocity
from sandbox.engine.restitution.impulses import Rub
from sandbox.tables import Records


class RoughBlow(NamedTuple):
    """By how much to multiply the normal impulse of a blow without friction, and the tangent impulse (N s)."""

    scale: float
    tangent: float


class Piece(NamedTuple):
    """A piece of a blow: what one more N s of normal impulse gives along the tangent (N s), and by how much it slows
    the closing (m/s)."""

    drag: float
    slowing: float


class RubMatrix(NamedTuple):
    """What 1 N s along the normal and along the tangent changes the speeds along both (1/kg), where a contact rubs."""

    nn: float
    nt: float
    tt: float


@inlined_kernel
def rub_matrix(contact: Records, mass: PairMass, rub: Rub) -> RubMatrix:
    """The matrix of a contact of free bodies."""
    normal = levers_of(rub.anchors, contact.normal_x, contact.normal_y)
    tangent = levers_of(rub.anchors, rub.tangent_x, rub.tangent_y)
    linear = mass.mass_a + mass.mass_b
    k_nn = linear + mass.inertia_a * normal.a * normal.a + mass.inertia_b * normal.b * normal.b
    k_tt = linear + mass.inertia_a * tangent.a * tangent.a + mass.inertia_b * tangent.b * tangent.b
    return RubMatrix(k_nn, mass.inertia_a * normal.a * tangent.a + mass.inertia_b * normal.b * tangent.b, k_tt)


@kernel
def rough_blow(start: PairVelocity, contact: Records, rub: Rub, k: RubMatrix, load: float) -> RoughBlow:
    """The blow at the point where a contact rubs, which without friction would have a normal impulse `load` (N s)."""
    friction = contact.friction
    vx, vy = relative_velocity(start, rub.anchors)
    closing = -(vx * contact.normal_x + vy * contact.normal_y)
    slip = vx * rub.tangent_x + vy * rub.tangent_y - contact.surface_speed
    side = 1.0 if slip > 0.0 else -1.0
    sliding = Piece(-side * friction, k.nn - side * friction * k.nt)
    stops = _when_sliding_stops(slip, k.nt - side * friction * k.tt)
    after = _after_sliding(friction, k)
    scale = 1.0
    if closing > 0.0:
        scale = _compression(closing, sliding, stops, after) * k.nn / closing
    load *= scale
    if load <= stops:
        return RoughBlow(scale, sliding.drag * load)
    return RoughBlow(scale, sliding.drag * stops + after.drag * (load - stops))


@inlined_kernel
def _when_sliding_stops(slip: float, rate: float) -> float:
    """The normal impulse (N s) at which a slip (m/s) that changes at this rate (1/kg) has come to an end."""
    if slip == 0.0:
        return 0.0
    return -slip / rate if slip * rate < 0.0 else math.inf


@inlined_kernel
def _after_sliding(friction: float, k: RubMatrix) -> Piece:
    """The point sticks where friction is enough for that; else it slides where the blow drives it."""
    if abs(k.nt) <= friction * k.tt:
        return Piece(-k.nt / k.tt, k.nn - k.nt * k.nt / k.tt)
    return Piece(-friction if k.nt > 0.0 else friction, k.nn - friction * abs(k.nt))


@inlined_kernel
def _compression(closing: float, sliding: Piece, stops: float, after: Piece) -> float:
    """The normal impulse (N s) at which a point that closes at such a speed (m/s) no longer does."""
    if closing <= sliding.slowing * stops:
        return closing / sliding.slowing
    return stops + (closing - sliding.slowing * stops) / after.slowing

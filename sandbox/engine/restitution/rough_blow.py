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
from sandbox.engine.contact_solver.law import PairMass, levers_of, relative_velocity
from sandbox.engine.restitution.impulses import Rub, Struck
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


@kernel
def rough_blow(struck: Struck, contact: Records, mass: PairMass, rub: Rub, load: float) -> RoughBlow:
    """The blow at the point where a contact rubs, which without friction would have a normal impulse `load` (N s)."""
    friction = contact.friction
    normal = levers_of(rub.anchors, contact.normal_x, contact.normal_y)
    tangent = levers_of(rub.anchors, rub.tangent_x, rub.tangent_y)
    linear = mass.mass_a + mass.mass_b
    k_nn = linear + mass.inertia_a * normal.a * normal.a + mass.inertia_b * normal.b * normal.b
    k_tt = linear + mass.inertia_a * tangent.a * tangent.a + mass.inertia_b * tangent.b * tangent.b
    k_nt = mass.inertia_a * normal.a * tangent.a + mass.inertia_b * normal.b * tangent.b
    vx, vy = relative_velocity(struck.start, rub.anchors)
    closing = -(vx * contact.normal_x + vy * contact.normal_y)
    slip = vx * rub.tangent_x + vy * rub.tangent_y - contact.surface_speed
    side = 1.0 if slip > 0.0 else -1.0
    sliding = Piece(-side * friction, k_nn - side * friction * k_nt)
    stops = _when_sliding_stops(slip, k_nt - side * friction * k_tt)
    after = _after_sliding(friction, k_nn, k_nt, k_tt)
    scale = 1.0
    if closing > 0.0:
        scale = _compression(closing, sliding, stops, after) * k_nn / closing
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
def _after_sliding(friction: float, k_nn: float, k_nt: float, k_tt: float) -> Piece:
    """The point sticks where friction is enough for that; else it slides where the blow drives it."""
    if abs(k_nt) <= friction * k_tt:
        return Piece(-k_nt / k_tt, k_nn - k_nt * k_nt / k_tt)
    return Piece(-friction if k_nt > 0.0 else friction, k_nn - friction * abs(k_nt))


@inlined_kernel
def _compression(closing: float, sliding: Piece, stops: float, after: Piece) -> float:
    """The normal impulse (N s) at which a point that closes at such a speed (m/s) no longer does."""
    if closing <= sliding.slowing * stops:
        return closing / sliding.slowing
    return stops + (closing - sliding.slowing * stops) / after.slowing

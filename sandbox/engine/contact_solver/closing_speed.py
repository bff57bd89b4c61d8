"""How fast the points of a contact close in."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import anchors_of, pair_velocity, relative_velocity
from sandbox.tables import Records

HARD = 2.0
"""Speed (m/s) past which a contact of two points that closes in has an impact, whatever its restitution."""


@kernel
def closing_speed(a: Records, b: Records, contact: Records, point: int) -> float:
    """Speed (m/s) at which point 1 or 2 of two bodies approaches along the normal."""
    x, y = relative_velocity(pair_velocity(a, b), anchors_of(contact, point))
    closing: float = -(x * contact.normal_x + y * contact.normal_y)
    return closing


@kernel
def closes_hard(bodies: Records, contact: Records) -> bool:
    """Whether two points of a contact meet, one of them faster than `HARD` as the step begins.

    A single point the solver stops exactly.
    """
    if contact.point_count < 2:
        return False
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    return bool(closing_speed(a, b, contact, 1) > HARD or closing_speed(a, b, contact, 2) > HARD)

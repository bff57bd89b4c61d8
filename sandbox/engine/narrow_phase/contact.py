"""A contact from a manifold, and what it keeps of the same contact in the last step."""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel
from sandbox.engine.broad_phase.proxies import FIXED
from sandbox.geometry.closest_features import FACE_OF_A, FACE_OF_B
from sandbox.tables import Records


@inlined_kernel
def fill_contact(
    proxies: Records, i: int, j: int, shift_x: float, shift_y: float, m: Records, contact: Records
) -> None:
    """Copy a manifold into a fresh contact and mix the surfaces of its shapes.

    The manifold is of the moment when b has moved against a by (shift_x, shift_y) metres: gaps are taken back to now.

    Its points lie in the middle of an overlap. Friction acts at the surface of what moves where the other is immovable:
    the overlap under load must not shorten the arm by which a disc rolls.
    """
    a = proxies[i]
    b = proxies[j]
    dx = b.center_x - a.center_x + shift_x
    dy = b.center_y - a.center_y + shift_y
    ahead = -(shift_x * m.normal_x + shift_y * m.normal_y)
    contact.shape_a = i
    contact.shape_b = j
    contact.body_a = a.body
    contact.body_b = b.body
    contact.normal_x = m.normal_x
    contact.normal_y = m.normal_y
    contact.friction = math.sqrt(a.friction * b.friction)
    contact.restitution = a.restitution if a.restitution > b.restitution else b.restitution
    rolling = a.rolling_resistance if a.rolling_resistance > b.rolling_resistance else b.rolling_resistance
    contact.rolling_resistance = rolling
    contact.surface_speed = a.surface_speed + b.surface_speed
    contact.radius_a = a.radius
    contact.radius_b = b.radius
    contact.rolling_impulse = 0.0
    contact.impact_impulse = 0.0
    contact.touching = 0
    contact.axis_owner = m.axis_owner
    contact.point_count = m.point_count
    contact.substep_level = 0
    off = (0.5 if a.traits & FIXED else 0.0) - (0.5 if b.traits & FIXED else 0.0)
    x = m.x1 + off * m.separation1 * m.normal_x
    y = m.y1 + off * m.separation1 * m.normal_y
    contact.anchor_ax1 = x
    contact.anchor_ay1 = y
    contact.anchor_bx1 = x - dx
    contact.anchor_by1 = y - dy
    contact.separation1 = m.separation1 + ahead
    contact.feature1 = m.feature1
    contact.normal_impulse1 = 0.0
    contact.tangent_impulse1 = 0.0
    contact.rest_length1 = 0.0
    two = m.point_count == 2
    x = m.x2 + off * m.separation2 * m.normal_x
    y = m.y2 + off * m.separation2 * m.normal_y
    contact.anchor_ax2 = x if two else 0.0
    contact.anchor_ay2 = y if two else 0.0
    contact.anchor_bx2 = x - dx if two else 0.0
    contact.anchor_by2 = y - dy if two else 0.0
    contact.separation2 = m.separation2 + ahead if two else 0.0
    contact.feature2 = m.feature2 if two else -1
    contact.normal_impulse2 = 0.0
    contact.tangent_impulse2 = 0.0
    contact.rest_length2 = 0.0


@inlined_kernel
def match_contact(old: Records, contact: Records) -> None:
    """Carry impulses and rest lengths over from points of the last step with the same feature ids: warm starting.

    A single point stays the same as long as it is at the same vertex, whatever that meets: faces are called by the
    vertex where they begin, so that by their ids alone a disc that rolls over a corner would keep its load on one side.
    """
    contact.touching = old.touching
    contact.rolling_impulse = old.rolling_impulse
    contact.substep_level = old.substep_level
    if contact.feature1 == old.feature1:
        contact.normal_impulse1 = old.normal_impulse1
        contact.tangent_impulse1 = old.tangent_impulse1
        contact.rest_length1 = old.rest_length1
    elif contact.point_count == 1 and old.point_count == 1 and _is_at_same_vertex(old, contact):
        contact.normal_impulse1 = old.normal_impulse1
        contact.tangent_impulse1 = old.tangent_impulse1
        contact.rest_length1 = old.rest_length1
    elif contact.feature1 == old.feature2 and old.point_count == 2:
        contact.normal_impulse1 = old.normal_impulse2
        contact.tangent_impulse1 = old.tangent_impulse2
        contact.rest_length1 = old.rest_length2
    if contact.point_count == 2:
        if contact.feature2 == old.feature2 and old.point_count == 2:
            contact.normal_impulse2 = old.normal_impulse2
            contact.tangent_impulse2 = old.tangent_impulse2
            contact.rest_length2 = old.rest_length2
        elif contact.feature2 == old.feature1:
            contact.normal_impulse2 = old.normal_impulse1
            contact.tangent_impulse2 = old.tangent_impulse1
            contact.rest_length2 = old.rest_length1


@inlined_kernel
def _is_at_same_vertex(old: Records, contact: Records) -> bool:
    """Whether a vertex that is at the only point of a contact was at its only point before, too."""
    of_a = old.axis_owner != FACE_OF_A and contact.axis_owner != FACE_OF_A
    of_b = old.axis_owner != FACE_OF_B and contact.axis_owner != FACE_OF_B
    same_a = old.feature1 // 64 == contact.feature1 // 64
    same_b = old.feature1 % 64 == contact.feature1 % 64
    return bool((of_a and same_a) or (of_b and same_b))

"""The contacts of a block as four rows of their table, read and written side by side."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox._vectors import Vector, spread, transpose
from sandbox.engine.records.gather_fields import Rows
from sandbox.tables import Records
from sandbox.world.records import CONTACT

KEPT_OF_POINT_1 = CONTACT.run("normal_impulse1", "tangent_impulse1", "rest_length1", "feature2")
KEPT_OF_POINT_2 = CONTACT.run("normal_impulse2", "tangent_impulse2", "rest_length2", "rolling_impulse")
MIXED_SURFACE = CONTACT.run("restitution", "surface_speed", "friction", "rolling_resistance")
AXIS = CONTACT.run("normal_x", "normal_y", "radius_a", "radius_b")
ANCHORS_1 = CONTACT.run("anchor_ax1", "anchor_ay1", "anchor_bx1", "anchor_by1")
SEPARATION_1_AND_ANCHOR_2 = CONTACT.run("separation1", "anchor_ax2", "anchor_ay2", "anchor_bx2")
ANCHOR_AND_SEPARATION_2 = CONTACT.run("anchor_ay2", "anchor_bx2", "anchor_by2", "separation2")
"""Columns that are read, or written, four at a time."""


@inlined_kernel
def contact_rows(block: Records, slots: Records) -> Rows:
    """The contacts of a block; lanes that are not used have the first one."""
    first = block.first
    return (
        slots[first].contact,
        slots[first + 1 if block.count > 1 else first].contact,
        slots[first + 2 if block.count > 2 else first].contact,
        slots[first + 3 if block.count > 3 else first].contact,
    )


@inlined_kernel
def point_counts(contacts: Records, rows: Rows) -> Vector:
    """How many points each of four contacts has."""
    counts, _, _, _ = transpose(
        spread(float(contacts[rows[0]].point_count)),
        spread(float(contacts[rows[1]].point_count)),
        spread(float(contacts[rows[2]].point_count)),
        spread(float(contacts[rows[3]].point_count)),
    )
    return counts

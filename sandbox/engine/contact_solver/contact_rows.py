"""The contacts of a block as four rows of their table, read and written side by side."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox._vectors import Vector, spread, transpose
from sandbox.engine.records.gather_fields import Rows
from sandbox.tables import Records
from sandbox.world.records import CONTACT

KEPT_OF_POINT_1, KEPT_OF_POINT_2, RESTITUTION, NORMAL, ANCHORS_1, SEPARATION_1, ANCHOR_AY_2 = CONTACT.places(
    (
        "normal_impulse1",
        "normal_impulse2",
        "restitution",
        "normal_x",
        "anchor_ax1",
        "separation1",
        "anchor_ay2",
    ),
    8,
)
"""Numbers of fields, from which on four are read at once. What is kept of a point are its normal impulse, its tangent
impulse and its rest length; the fourth is a feature id behind those of point 1 and the rolling impulse behind the
others."""


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

"""The contacts of bodies that are ahead: as lanes, and as rows where impacts with restitution ask for those."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Vector, spread, transpose
from sandbox.engine.bodies.flags import AHEAD, moves
from sandbox.engine.contact_solver.gather import PairPose, gather_poses, gather_velocities, rows_of
from sandbox.engine.contact_solver.law import anchors_of, separation_of
from sandbox.engine.midpoint.move_contact import STAYS, Axis, moved_axis, moved_point
from sandbox.engine.midpoint.poses import pair_way
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records

_MOVED = 4
"""Added to the `axis_owner` of a row of the contact table while it is that of the middle of the step."""
_MOVED_ON = 8
"""The same where it lasts."""


@inlined_kernel
def ways_of(block: Records, motions: Records) -> PairPose:
    """How far ahead the bodies of a block are: so far are they back where the step begins."""
    rows = rows_of(block)
    pose = gather_poses(motions, rows, gather_velocities(motions, rows))
    return PairPose(-pose.x, -pose.y, pose.cos_a, -pose.sin_a, pose.cos_b, -pose.sin_b)


@inlined_kernel
def axis_owners(bodies: Records, flags: Integers, block: Records, slots: Records, contacts: Records) -> Vector:
    """What the axes of the contacts of a block are of, `STAYS` where they do not last."""
    first = block.first
    owners, _, _, _ = transpose(
        spread(float(_owner(bodies, flags, slots[first], contacts))),
        spread(float(_owner(bodies, flags, slots[first + 1 if block.count > 1 else first], contacts))),
        spread(float(_owner(bodies, flags, slots[first + 2 if block.count > 2 else first], contacts))),
        spread(float(_owner(bodies, flags, slots[first + 3 if block.count > 3 else first], contacts))),
    )
    return owners


@kernel
def _owner(bodies: Records, flags: Integers, slot: Records, contacts: Records) -> int:
    contact = contacts[slot.contact]
    a = slot.body_a
    b = slot.body_b
    lasts = contact.touching == 1 and _keeps_up(bodies[a], flags[a]) and _keeps_up(bodies[b], flags[b])
    return int(contact.axis_owner) if lasts else STAYS


@inlined_kernel
def _keeps_up(body: Records, flags: int) -> bool:
    """Whether a body is where it will be in the middle of the step."""
    return bool(flags & AHEAD or not moves(body))


@kernel
def move_row(bodies: Records, solver: SolverBodies, slot: Records, contacts: Records, seconds: float) -> None:
    """Let a row be that of the middle of the step, `seconds` after its beginning, if its bodies are."""
    flags = solver.flags
    if (flags[slot.body_a] | flags[slot.body_b]) & AHEAD:
        contact = contacts[slot.contact]
        owner = _owner(bodies, flags, slot, contacts)
        move_contact(contact, pair_way(bodies, flags, slot.body_a, slot.body_b, seconds), owner)
        contact.axis_owner += _MOVED if owner == STAYS else _MOVED_ON


@kernel
def move_row_back(bodies: Records, solver: SolverBodies, slot: Records, contact: Records, seconds: float) -> None:
    """Let it be that of the beginning of the step again, to rounding, or to what its gap has turned by."""
    owner = contact.axis_owner
    if owner < _MOVED:
        return
    contact.axis_owner -= _MOVED_ON if owner >= _MOVED_ON else _MOVED
    owner = owner - _MOVED_ON if owner >= _MOVED_ON else STAYS
    move_contact(contact, pair_way(bodies, solver.flags, slot.body_a, slot.body_b, -seconds), owner)


@kernel
def move_contact(contact: Records, way: PairPose, owner: int) -> None:
    """Let a row be that of its bodies after they have moved so far."""
    before = Axis(contact.normal_x, contact.normal_y, contact.radius_a, contact.radius_b)
    one = anchors_of(contact, 1)
    after = moved_axis(before, one, way, owner)
    contact.normal_x = after.x
    contact.normal_y = after.y
    one, contact.separation1 = moved_point(one, separation_of(contact, 1), before, after, way, owner)
    contact.anchor_ax1 = one.ax
    contact.anchor_ay1 = one.ay
    contact.anchor_bx1 = one.bx
    contact.anchor_by1 = one.by
    if contact.point_count == 2:
        gap = separation_of(contact, 2)
        two, contact.separation2 = moved_point(anchors_of(contact, 2), gap, before, after, way, owner)
        contact.anchor_ax2 = two.ax
        contact.anchor_ay2 = two.ay
        contact.anchor_bx2 = two.bx
        contact.anchor_by2 = two.by

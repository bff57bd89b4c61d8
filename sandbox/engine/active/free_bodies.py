"""Which bodies of a batch are touched by something, held by joints alone, or free."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.blocks import MAX_COLORS
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import has_joints
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records


@kernel
def put_free_last(
    rows: Integers, solver: SolverBodies, drags: Records, joints: JointWork, color_count: int
) -> tuple[int, int]:
    """Put the bodies of `rows` that something touches first, and the free ones last, which no joint or hand holds
    either: how many are touched, and how many are not free.

    What has a contact has a colour, unless contacts have run out of them: then all count as touched. While a hand holds
    one, none is free.
    """
    count: int = rows.shape[0]
    if color_count > MAX_COLORS:
        return count, count
    touched = 0
    for k in range(count):
        i = rows[k]
        if solver.colors[i] != 0:
            rows[k] = rows[touched]
            rows[touched] = i
            touched += 1
    for k in range(drags.shape[0]):
        if drags[k].body >= 0:
            return touched, count
    held = touched
    if not has_joints(joints):
        return touched, held
    for k in range(touched, count):
        i = rows[k]
        if joints.part_of[i] >= 0:
            rows[k] = rows[held]
            rows[held] = i
            held += 1
    return touched, held

"""Which bodies of a batch are free: nothing touches them, and no joint or hand holds them."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.blocks import MAX_COLORS
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records


@kernel
def put_free_last(
    rows: Integers, solver: SolverBodies, drags: Records, joints: JointWork | None, color_count: int
) -> int:
    """Put the free bodies of `rows` behind all others, which keep their order; returns how many others there are.

    What has a contact has a colour, unless contacts have run out of them: then all count as held.
    """
    if color_count > MAX_COLORS:
        return int(rows.shape[0])
    for k in range(drags.shape[0]):
        if drags[k].body >= 0:
            return int(rows.shape[0])
    held = 0
    for k in range(rows.shape[0]):
        i = rows[k]
        if solver.colors[i] != 0 or (joints is not None and joints.part_of[i] >= 0):
            rows[k] = rows[held]
            rows[held] = i
            held += 1
    return held

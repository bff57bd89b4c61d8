"""Which bodies may pass through something in a step: those that go, swing or turn far for their size."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.broad_phase.margins import shape_margin
from sandbox.tables import Integers, Records

FAST_SHARE = 0.5
"""A body that moves or swings farther in a step than this share of its half width is swept."""


@kernel
def mark_fast(
    bodies: Records, active_bodies: Integers, motions: Records, ccd_bodies: Records, seconds: float, unit: float
) -> int:
    """Mark the active bodies that may have passed through something in this step; return how many.

    `bodies` are still those of its beginning. Those that set out to go or swing far, or to turn past their margin, are
    marked as well: one that is stopped in mid-step ends near to where it began, and may have turned deep into
    something. So are bullets, always: something fast may have passed over them.
    """
    count = 0
    for i in active_bodies:
        body = bodies[i]
        motion = motions[i]
        ccd_body = ccd_bodies[i]
        lever = body.extent - ccd_body.thin
        most = FAST_SHARE * ccd_body.thin
        turn = seconds * abs(body.angular_velocity)
        ahead = seconds * (abs(body.velocity_x) + abs(body.velocity_y)) + turn * lever
        went = abs(motion.delta_x) + abs(motion.delta_y) + abs(motion.delta_angle) * lever
        far = ahead > most or went > most or 0.5 * turn * (turn * lever) > shape_margin(body.extent, unit)
        fast = (far or ccd_body.deep == 1 or body.bullet == 1) and is_active(body)
        ccd_body.fast = 1 if fast else 0
        count += 1 if fast else 0
    return count

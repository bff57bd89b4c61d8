"""Which bodies may pass through something in a step: those that go, swing or turn far for their size."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.broad_phase.margins import shape_margin
from sandbox.tables import Integers, Records

FAST_SHARE = 0.5
"""A body that moves or swings farther in a step than this share of its half width is swept."""


@kernel
def mark_fast_at_start(bodies: Records, active_bodies: Integers, ccd_bodies: Records, seconds: float) -> None:
    """Mark the bodies that set out to go or swing far, or to turn past their margin; `mark_fast` adds others.

    One that is stopped in mid-step ends near to where it began, and may have turned deep into something.
    """
    for i in active_bodies:
        body = bodies[i]
        turn = seconds * abs(body.angular_velocity)
        swing = turn * (body.extent - ccd_bodies[i].thin)
        travel = seconds * (abs(body.velocity_x) + abs(body.velocity_y))
        far = travel + swing > FAST_SHARE * ccd_bodies[i].thin or 0.5 * turn * swing > shape_margin(body.extent)
        ccd_bodies[i].fast = 1 if far else 0


@kernel
def mark_fast(bodies: Records, active_bodies: Integers, motions: Records, ccd_bodies: Records) -> int:
    """Mark the active bodies that may have passed through something in this step; return how many.

    Bullets always: something fast may have passed over them. `mark_fast_at_start` has marked some already.
    """
    count = 0
    for i in active_bodies:
        body = bodies[i]
        motion = motions[i]
        ccd_body = ccd_bodies[i]
        swing = abs(motion.delta_angle) * (body.extent - ccd_body.thin)
        far = ccd_body.fast == 1 or abs(motion.delta_x) + abs(motion.delta_y) + swing > FAST_SHARE * ccd_body.thin
        ccd_body.fast = 0
        if (far or ccd_body.deep == 1 or body.bullet == 1) and is_active(body):
            ccd_body.fast = 1
            count += 1
    return count

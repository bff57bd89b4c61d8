"""Which bodies may pass through something in a step: those that go, swing or turn far for their size."""

from __future__ import annotations

from sandbox._jit import ZERO, kernel
from sandbox.engine.active.body_flags import is_active
from sandbox.engine.broad_phase.proxies import shape_margin
from sandbox.tables import Integers, Records

FAST_SHARE = 0.5
"""A body that moves or swings farther in a step than this share of its half width is swept."""


@kernel
def expect_fast(bodies: Records, movers: Integers, holds: Records, seconds: float) -> None:
    """Mark the bodies that set out to go or swing far, or to turn past what `look_ahead` sees; `mark_fast` adds others.

    One that is stopped in mid-step ends near to where it began, and may have turned deep into something.
    """
    for i in movers:
        body = bodies[i]
        turn = seconds * abs(body.angular_velocity)
        swing = turn * (body.extent - holds[i].thin)
        way = seconds * (abs(body.velocity_x) + abs(body.velocity_y))
        far = way + swing > FAST_SHARE * holds[i].thin or 0.5 * turn * swing > shape_margin(body.extent)
        holds[i].fast = 1 if far else 0


@kernel
def mark_fast(bodies: Records, movers: Integers, motions: Records, holds: Records) -> int:
    """Mark the active bodies that may have passed through something in this step; return how many.

    Bullets always: something fast may have passed over them. `expect_fast` has marked some already.
    """
    count = ZERO
    for i in movers:
        body = bodies[i]
        motion = motions[i]
        hold = holds[i]
        swing = abs(motion.delta_angle) * (body.extent - hold.thin)
        far = hold.fast == 1 or abs(motion.delta_x) + abs(motion.delta_y) + swing > FAST_SHARE * hold.thin
        hold.fast = 0
        if (far or hold.deep == 1 or body.bullet == 1) and is_active(body):
            hold.fast = 1
            count += 1
    return count

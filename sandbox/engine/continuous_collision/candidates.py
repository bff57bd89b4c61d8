"""Which bodies may pass through something in a step: those that go, swing or turn far for their size."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.broad_phase.margins import shape_margin
from sandbox.tables import Records

FAST_SHARE = 0.5
"""A body that moves or swings farther in a step than this share of its half width is swept."""


@inlined_kernel
def mark_fast(body: Records, motion: Records, ccd_body: Records, seconds: float, unit: float) -> bool:
    """Mark a body if it may have passed through something in this step; returns whether.

    `body` is still that of its beginning. One that set out to go or swing far, or to turn past its margin, is marked as
    well: if it is stopped in mid-step it ends near to where it began, and may have turned deep into something. So is a
    bullet, always: something fast may have passed over it.
    """
    lever = body.extent - ccd_body.thin
    most = FAST_SHARE * ccd_body.thin
    turn = seconds * abs(body.angular_velocity)
    ahead = seconds * (abs(body.velocity_x) + abs(body.velocity_y)) + turn * lever
    went = abs(motion.delta_x) + abs(motion.delta_y) + abs(motion.delta_angle) * lever
    far = (ahead > most) | (went > most) | (0.5 * turn * (turn * lever) > shape_margin(body.extent, unit))
    fast = (far | (ccd_body.deep == 1) | (body.bullet == 1)) and is_active(body)
    ccd_body.fast = 1 if fast else 0
    return bool(fast)

"""Roll a body back along its motion through the step."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.bodies.integrate import place_origin
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records


@kernel
def roll_back(body: Records, motion: Records, share: float) -> None:
    """Take back that share of a body's motion through the step."""
    body.center_x -= share * motion.delta_x
    body.center_y -= share * motion.delta_y
    if motion.delta_angle != 0.0:
        angle: float = body.angle - share * motion.delta_angle
        body.angle = angle
        body.rotation_cos, body.rotation_sin = cos_sin(angle)
    place_origin(body)


@kernel
def roll_back_energy(body: Records, motion: Records, share: float, setting: Records) -> None:
    """Give a body that was taken back the speed along gravity that belongs to the height where it is now.

    Or every catch of a bouncing body would lift or lower it for nothing. What stopped it in mid-step knows nothing of
    heights: the speed changes by no more than twice what gravity does in the time taken back.
    """
    ax = body.gravity_scale * setting.gravity_x
    ay = body.gravity_scale * setting.gravity_y
    square = ax * ax + ay * ay
    if square == 0.0:
        return
    size = math.sqrt(square)
    before = (body.velocity_x * ax + body.velocity_y * ay) / size
    after = before * before - 2.0 * share * (motion.delta_x * ax + motion.delta_y * ay)
    after = math.sqrt(after) if after > 0.0 else 0.0
    change = after - abs(before)
    most = 2.0 * share * setting.step_seconds * size
    change = change if change < most else most
    change = change if change > -most else -most
    change = change if before > 0.0 else -change
    body.velocity_x += change * ax / size
    body.velocity_y += change * ay / size

"""What touches something immovable from the start of the step slides along it, rather than stand still."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.integrate import place_origin
from sandbox.engine.continuous_collision.contact_impulse import strike_static
from sandbox.engine.records.ccd import Ccd
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records

SLIDES = 3
"""A body slides so often in a step; what stops it once more is a wedge, and it is rolled back there."""


@kernel
def slide_all(bodies: Records, motions: Records, ccd: Ccd, threshold: float, round: int) -> bool:
    """Let all bodies slide along what they have touched all the while in this round; whether there was one.

    Only these are to be swept again: along the motion that is left they may come to something else.
    """
    slides = False
    for i in ccd.hit[1 : 1 + ccd.hit[0]]:
        impact = ccd.impacts[i]
        if impact.time < 1.0 and impact.touched == 1:
            _slide(bodies[i], motions[i], impact)
            strike_static(bodies, i, impact, threshold)
            impact.time = 1.0
            impact.bounces = impact.touched = 0
            impact.round = round + 1
            slides = True
    return slides


@kernel
def _slide(body: Records, motion: Records, impact: Records) -> None:
    """Take back what, past the time of impact, leads along its normal into what stops the body, and the turn."""
    rest = 1.0 - impact.time
    into = rest * (motion.delta_x * impact.normal_x + motion.delta_y * impact.normal_y)
    into = into if into < 0.0 else 0.0
    motion.delta_x -= into * impact.normal_x
    motion.delta_y -= into * impact.normal_y
    body.center_x -= into * impact.normal_x
    body.center_y -= into * impact.normal_y
    if motion.delta_angle != 0.0:
        angle: float = body.angle - rest * motion.delta_angle
        motion.delta_angle *= impact.time
        body.angle = angle
        body.rotation_cos, body.rotation_sin = cos_sin(angle)
    place_origin(body)

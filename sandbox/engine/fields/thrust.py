"""Thrusters: a force fixed to a body, switched on and off by the scene's schedule."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.fields.area import acts
from sandbox.tables import Records


@kernel
def thrust(thrusters: Records, pushes: Records, step: int) -> None:
    """Add the forces of the thrusters that burn in this step, at the angles of mid-step."""
    for k in range(thrusters.shape[0]):
        thruster = thrusters[k]
        push = pushes[thruster.body]
        if push.active == 0 or not acts(thruster, step):
            continue
        fx = push.cos * thruster.force_x - push.sin * thruster.force_y
        fy = push.sin * thruster.force_x + push.cos * thruster.force_y
        push.force_x += fx
        push.force_y += fy
        push.torque += thruster.local_x * thruster.force_y - thruster.local_y * thruster.force_x

"""All commands by their names."""

from __future__ import annotations

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.control import Control
from sandbox.engine.commands.delete import Delete, DeleteJoint, DeleteRegion
from sandbox.engine.commands.drags import EndDrag, MoveDrag, StartDrag
from sandbox.engine.commands.explode import Explode
from sandbox.engine.commands.joint_parts import BreakJoint, SetLimits, SetMotor, SetSpring, SetTarget
from sandbox.engine.commands.motion import SetPose, SetVelocity
from sandbox.engine.commands.pushes import ApplyForce, ApplyImpulse
from sandbox.engine.commands.set_gravity import SetGravity
from sandbox.engine.commands.set_joint import SetJoint
from sandbox.engine.commands.set_path import SetPath
from sandbox.engine.commands.set_region import SetRegion
from sandbox.engine.commands.set_settings import SetSettings
from sandbox.engine.commands.set_surface import SetSurface
from sandbox.engine.commands.set_thruster import SetThruster
from sandbox.engine.commands.spawn import Spawn

COMMAND_CLASSES: dict[str, type[Command]] = {
    kind.__name__: kind
    for kind in (
        ApplyForce, ApplyImpulse, SetPose, SetVelocity, SetSurface, SetThruster, StartDrag, MoveDrag, EndDrag,
        SetMotor, SetLimits, SetSpring, SetTarget, SetJoint, BreakJoint,
        SetGravity, SetSettings, Explode, SetRegion, Spawn, Delete, DeleteJoint, DeleteRegion,
        Control, SetPath,
    )
}  # fmt: skip
"""Every command that a world takes, by the name that recordings call it."""

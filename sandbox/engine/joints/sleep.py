"""What joints say about sleep: which bodies rest by them, and which are kept awake."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import KEPT_AWAKE, MOVING_KINEMATIC, SUPPORTED
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Integers


@kernel
def flag_joined(flags: Integers, joints: JointWork) -> None:
    """Flag the bodies that rest or are kept awake by joints."""
    _flag_supported(flags, joints)
    _keep_awake_at_kinematic(flags, joints)


@kernel
def _flag_supported(flags: Integers, joints: JointWork) -> None:
    """What hangs from something that does not move rests as well, and what hangs together rests together."""
    for i in range(1, joints.members.shape[0]):
        member = joints.members[i]
        if member.part >= 0 and (joints.parts[member.part].anchored == 1 or joints.parts[member.part].supported == 1):
            flags[member.body] |= SUPPORTED


@kernel
def _keep_awake_at_kinematic(flags: Integers, joints: JointWork) -> None:
    """Bodies that a joint ties to a driven body do not fall asleep."""
    for i in range(joints.ties.shape[0]):
        a = joints.ties[i].low
        b = joints.ties[i].high
        if (flags[a] | flags[b]) & MOVING_KINEMATIC:
            flags[a] |= KEPT_AWAKE
            flags[b] |= KEPT_AWAKE

"""Joints as an author writes them: one model a kind, told apart by `type`."""

from __future__ import annotations

from sandbox.scene.joints.any_joint import JOINTS, AnyJoint
from sandbox.scene.joints.base import Joint

__all__ = ["JOINTS", "AnyJoint", "Joint"]

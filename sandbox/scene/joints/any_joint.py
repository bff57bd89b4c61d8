"""All kinds of joint by their name, and the union of them."""

from __future__ import annotations

from typing import Annotated

from pydantic import Tag

from sandbox.scene.joints.base import Joint
from sandbox.scene.joints.drives import Friction, Motor, Target
from sandbox.scene.joints.gear import Gear
from sandbox.scene.joints.revolute import Revolute, Weld
from sandbox.scene.joints.ropes import DistanceJoint, Pulley
from sandbox.scene.joints.slides import Prismatic, Wheel
from sandbox.scene.union import TAG, by_value

JOINTS: dict[str, type[Joint]] = {
    "distance": DistanceJoint,
    "revolute": Revolute,
    "prismatic": Prismatic,
    "weld": Weld,
    "wheel": Wheel,
    "gear": Gear,
    "pulley": Pulley,
    "motor": Motor,
    "target": Target,
    "friction": Friction,
}
"""Every kind of joint by its `type`."""

AnyJoint = Annotated[
    Annotated[DistanceJoint, Tag(TAG + "distance")]
    | Annotated[Revolute, Tag(TAG + "revolute")]
    | Annotated[Prismatic, Tag(TAG + "prismatic")]
    | Annotated[Weld, Tag(TAG + "weld")]
    | Annotated[Wheel, Tag(TAG + "wheel")]
    | Annotated[Gear, Tag(TAG + "gear")]
    | Annotated[Pulley, Tag(TAG + "pulley")]
    | Annotated[Motor, Tag(TAG + "motor")]
    | Annotated[Target, Tag(TAG + "target")]
    | Annotated[Friction, Tag(TAG + "friction")],
    by_value("joint", "type", JOINTS),
]
"""Any joint; its `type` tells which."""

"""Prefabs: patterns for bodies, and for groups of bodies and joints."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from sandbox.scene.body import Body, BodyFields
from sandbox.scene.constraints import Listed
from sandbox.scene.generators import AnyGenerator
from sandbox.scene.joints import AnyJoint
from sandbox.scene.limits import MAX_BODIES, MAX_GENERATORS, MAX_JOINTS
from sandbox.scene.quantities import Name, Number


class Prefab(BodyFields):
    """A body without id and position, or several bodies with what joins them: a pattern for bodies and generators."""

    params: dict[Name, Number] = Field(
        default={}, description="Numbers that its expressions may ask for, by name, and their defaults."
    )
    bodies: Annotated[tuple[Body, ...], Listed("of bodies", 0, MAX_BODIES)] = Field(
        default=(), description="Bodies in the prefab's frame; their ids begin with that of the copy: ID.wheel."
    )
    joints: Annotated[tuple[AnyJoint, ...], Listed("of joints", 0, MAX_JOINTS)] = Field(
        default=(), description="What joins these bodies, with anchors in the prefab's frame."
    )
    generate: Annotated[tuple[AnyGenerator, ...], Listed("of generators", 0, MAX_GENERATORS)] = Field(
        default=(), description="Copies of other prefabs in this one."
    )

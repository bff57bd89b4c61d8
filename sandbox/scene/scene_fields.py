"""The fields of a scene, as they stand in a file."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.body import Body
from sandbox.scene.constraints import Exactly, Listed
from sandbox.scene.expect import AnyExpectation
from sandbox.scene.generators import AnyGenerator
from sandbox.scene.joints import AnyJoint
from sandbox.scene.limits import (
    MAX_BODIES,
    MAX_CATEGORIES,
    MAX_CONTROLS,
    MAX_EXPECTATIONS,
    MAX_GENERATORS,
    MAX_INCLUDES,
    MAX_JOINTS,
    MAX_REGIONS,
    MAX_RULES,
)
from sandbox.scene.material import Material
from sandbox.scene.objects import known_as
from sandbox.scene.play.control import InputControl
from sandbox.scene.play.rule import Rule
from sandbox.scene.prefab import Prefab
from sandbox.scene.quantities import Acceleration2, Name, Number
from sandbox.scene.regions import AnyRegion
from sandbox.scene.settings import LintSettings, Settings, View


@known_as("the scene itself")
class SceneFields(Model):
    """All that an author writes; `Scene` adds what can be done with it."""

    schema_uri: str | None = Field(default=None, alias="$schema", description="For editors; not read.")
    format: Annotated[Literal[1], Exactly(1)] = Field(default=1, description="Version of the format.")
    title: str = Field(default="", description="A line for people.")
    about: str = Field(default="", description="What to watch for.")
    include: Annotated[tuple[str, ...], Listed('["FILE.json", ...]', 0, MAX_INCLUDES)] = Field(
        default=(), description='Files whose vars, materials and prefabs are there too; "sandbox:materials" is one.'
    )
    vars: dict[Name, Number] = Field(
        default={}, description='Numbers by name, for expressions such as "=2 * rows" where a number is allowed.'
    )
    gravity: Acceleration2 = Field(default=(0.0, -9.81), description="[x, y], m/s^2; y points up.")
    categories: Annotated[tuple[Name, ...], Listed('["name", ...]', 0, MAX_CATEGORIES)] = Field(
        default=(), description='Names of collision categories; "default" is one already.'
    )
    materials: dict[Name, Material] = Field(default={}, description="Materials by name.")
    prefabs: dict[Name, Prefab] = Field(default={}, description="Patterns for bodies and generators, by name.")
    bodies: Annotated[tuple[Body, ...], Listed("of bodies", 0, MAX_BODIES)] = Field(
        default=(), description="The bodies."
    )
    generate: Annotated[tuple[AnyGenerator, ...], Listed("of generators", 0, MAX_GENERATORS)] = Field(
        default=(), description="Bodies made by rule, after the written ones."
    )
    joints: Annotated[tuple[AnyJoint, ...], Listed("of joints", 0, MAX_JOINTS)] = Field(
        default=(), description="What holds bodies together."
    )
    regions: Annotated[tuple[AnyRegion, ...], Listed("of regions", 0, MAX_REGIONS)] = Field(
        default=(), description="Areas in which a field pushes: water, gravity, wind."
    )
    counters: dict[Name, Number] = Field(
        default={}, description="Numbers that rules count with, by name: what they start with."
    )
    controls: Annotated[tuple[InputControl, ...], Listed("of controls", 0, MAX_CONTROLS)] = Field(
        default=(), description="What a player presses, and what it does."
    )
    rules: Annotated[tuple[Rule, ...], Listed("of rules", 0, MAX_RULES)] = Field(
        default=(), description="What is done when something happens."
    )
    settings: Settings = Field(default=Settings(), description="How the scene is simulated.")
    view: View | None = Field(
        default=None, description="What the camera shows at first; default: what can move, and what is static near it."
    )
    expect: Annotated[tuple[AnyExpectation, ...], Listed("of expectations", 0, MAX_EXPECTATIONS)] = Field(
        default=(), description="What must hold when the scene runs."
    )
    lint: LintSettings = Field(default=LintSettings(), description="What `sandbox lint` passes over in this scene.")

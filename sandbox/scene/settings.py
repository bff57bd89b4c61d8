"""How a scene is simulated and looked at. Every field has a default that a scene need not touch."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.limits import MAX_SUBSTEPS
from sandbox.scene.objects import known_as
from sandbox.scene.quantities import Hertz, Name, Point, Ratio, Size, Speed, Units


@known_as('"settings"')
class Settings(Model):
    """Simulation settings."""

    step_rate: Hertz = Field(default=60.0, description="Steps per second.")
    substeps: Annotated[int, Range(1, MAX_SUBSTEPS)] = Field(default=4, description="Solver substeps in a step.")
    contact_hertz: Hertz = Field(default=57.0, description="Stiffness of contacts, Hz.")
    contact_damping_ratio: Ratio = Field(default=1.5, description="Damping of contacts; 1 is critical.")
    push_out_speed: Speed = Field(default=3.0, description="Fastest recovery of an overlap, m/s.")
    restitution_threshold: Speed = Field(default=0.2, description="Slower impacts do not bounce, m/s.")
    units_per_meter: Units | None = Field(
        default=None,
        description="Units of length to a metre, as 100 where they are pixels; default: 1, or, where gravity is beyond "
        "any planet's, as many as make it 9.81 m/s^2. Speeds of these settings and sleep_speed stay in m/s.",
    )
    sleeping: bool = Field(default=True, description="false: resting bodies never fall asleep.")
    warm_starting: bool = Field(
        default=True, description="false: a substep does not begin with the last one's impulses."
    )
    accumulate: bool = Field(
        default=True, description="false: each impulse is clamped by itself instead of their sum, and none is kept."
    )
    soft: bool = Field(
        default=True, description="false: contacts are rigid, and a fifth of an overlap is taken back in a substep."
    )
    relax: bool = Field(default=True, description="false: the speed that pushes overlaps apart stays.")
    speculative: bool = Field(default=True, description="false: contacts push only where shapes overlap already.")
    steps: Annotated[int, Range(1, 1_000_000)] = Field(
        default=300,
        description="How many steps a headless check runs; more if an expectation names a later step.",
    )


@known_as('"view"')
class View(Model):
    """What the camera shows at first."""

    center: Point = Field(default=(0.0, 0.0), description="Middle of the picture, m.")
    height: Size | None = Field(default=None, description="Height of the picture, m; default: as without a view.")
    follow: Name | None = Field(default=None, description='Body that the camera goes with; "moving": whatever moves.')
    color_by: Literal["theme", "material", "group", "speed", "sleep", "island", "mass", "density"] = Field(
        default="theme", description="What the colours of bodies mean."
    )


@known_as('"lint"')
class LintSettings(Model):
    """What `sandbox lint` is asked to pass over in this scene."""

    ignore: Annotated[tuple[Name, ...], Listed('["rule", ...]', 0, 100)] = Field(
        default=(), description="Names of rules that find what is meant here."
    )

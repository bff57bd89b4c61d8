"""What a scene comes down to once generators, prefabs, materials and defaults are expanded.

Plain values in SI units and radians, independent of files and of the engine: `scene.flatten()` returns a
`FlatScene`, and `world.build` turns it into records.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from sandbox.scene.flat_body import INFINITE, FlatBody, FlatPath, FlatShape, FlatThruster, SeamRow, Vec
from sandbox.scene.flat_rules import FlatControl, FlatCounter, FlatRule

__all__ = [
    "INFINITE",
    "FlatBody",
    "FlatJoint",
    "FlatPath",
    "FlatRegion",
    "FlatScene",
    "FlatSettings",
    "FlatShape",
    "FlatThruster",
    "JointKind",
    "RegionKind",
    "SeamRow",
    "Vec",
]

RegionKind = Literal["water", "gravity", "gravity_scale", "attraction", "wind"]


@dataclass(frozen=True)
class FlatRegion:
    """A force field. It lies within all half-planes `edges` (unit normal x, y and offset: n . p <= offset) and within
    the `disc` (x, y, radius) if there is one; without either it is everywhere.

    `start` and `end` in seconds; `density` in kg/m^2, `flow` in m/s; `drag` and `angular_drag` in 1/s for water, the
    pressure coefficient for wind; `gravity` in m/s^2; an attraction of `strength` m/s^2 at 1 m from `center` falls with
    the power `falloff` of the distance, to nothing within `core` m and beyond `range` m. The last edge of water that is
    `surfaced` is its surface. `id` is empty for a region without one.
    """

    kind: RegionKind
    edges: tuple[tuple[float, float, float], ...] = ()
    disc: tuple[float, float, float] | None = None
    start: float = 0.0
    end: float = INFINITE
    density: float = 0.0
    flow: Vec = (0.0, 0.0)
    drag: float = 0.0
    angular_drag: float = 0.0
    gravity: Vec = (0.0, 0.0)
    scale: float = 1.0
    center: Vec = (0.0, 0.0)
    strength: float = 0.0
    falloff: int = 2
    core: float = 0.1
    range: float = INFINITE
    surfaced: bool = False
    id: str = ""


JointKind = Literal[
    "distance", "revolute", "prismatic", "weld", "wheel", "gear", "pulley", "motor", "target", "friction"
]
"""All kinds, in the order of their numbers in a world's table: a new one comes last."""


@dataclass(frozen=True)
class FlatJoint:
    """One joint. `body_a` and `body_b` are ids, None for the world; anchors and the unit `axis` are in world axes.

    Lengths in metres, angles in radians, measured from the pose that the scene starts with. A spring is there if
    `hertz` is not None, a limit if `lower` or `upper` is not infinite, a motor if `motor_speed` is not None.
    `angular_hertz` 0 is rigid. `joints` are the two that a gear couples. `points`: the wheels of a pulley, the target
    of a target joint, the wanted place of a motor's anchor b.
    """

    id: str
    kind: JointKind
    body_a: str | None
    body_b: str | None
    anchor_a: Vec = (0.0, 0.0)
    anchor_b: Vec = (0.0, 0.0)
    axis: Vec = (1.0, 0.0)
    joints: tuple[str, str] | None = None
    ratio: float = 1.0
    points: tuple[Vec, ...] = ()
    length: float | None = None
    hertz: float | None = None
    damping_ratio: float = 0.0
    rest: float = 0.0
    angular_hertz: float = 0.0
    angular_damping_ratio: float = 0.0
    angle: float = 0.0
    lower: float = -INFINITE
    upper: float = INFINITE
    motor_speed: float | None = None
    max_motor: float = INFINITE
    max_force: float = INFINITE
    max_torque: float = INFINITE
    break_force: float = INFINITE
    break_torque: float = INFINITE
    collide: bool = False
    enabled: bool = True
    pointer: str = ""


@dataclass(frozen=True)
class FlatSettings:
    """Simulation settings; the defaults are the ones a scene gets when it says nothing.

    The last five switch a technique of the contact solver off; `scenes/solver/README.md` explains them.
    """

    step_rate: float = 60.0
    substeps: int = 4
    contact_hertz: float = 57.0
    contact_damping_ratio: float = 1.5
    push_out_speed: float = 3.0
    restitution_threshold: float = 0.2
    units_per_meter: float = 1.0
    sleeping: bool = True
    warm_starting: bool = True
    accumulate: bool = True
    soft: bool = True
    relax: bool = True
    speculative: bool = True


@dataclass(frozen=True)
class FlatScene:
    """A scene with nothing left to look up. `gravity` in m/s^2."""

    bodies: tuple[FlatBody, ...]
    gravity: Vec = (0.0, -9.81)
    settings: FlatSettings = field(default_factory=FlatSettings)
    joints: tuple[FlatJoint, ...] = ()
    regions: tuple[FlatRegion, ...] = ()
    counters: tuple[FlatCounter, ...] = ()
    controls: tuple[FlatControl, ...] = ()
    rules: tuple[FlatRule, ...] = ()

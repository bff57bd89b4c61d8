"""A Box2D world as plain values, whatever file it came from. Lengths in metres, angles in radians."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from sandbox.formats.numbers import Vec

BodyType = Literal["static", "kinematic", "dynamic"]


@dataclass
class Outline:
    """The shape of a fixture: a circle about its point, a polygon, or lines with the points before and after them."""

    kind: Literal["circle", "polygon", "chain"]
    points: list[Vec]
    radius: float = 0.0
    closed: bool = False
    before: Vec | None = None
    after: Vec | None = None


@dataclass
class Fixture:
    """A shape with its surface and filter; the defaults are those of Box2D."""

    place: str
    outline: Outline
    density: float = 0.0
    friction: float = 0.2
    restitution: float = 0.0
    sensor: bool = False
    category: int = 1
    mask: int = 0xFFFF
    group: int = 0


@dataclass(frozen=True)
class MassData:
    """Mass (kg), its centre (m), and the inertia about the body's origin (kg m^2), as `b2MassData` has it."""

    mass: float
    center: Vec
    inertia: float


@dataclass
class Body:
    """A body; velocities of the centre of mass in m/s and rad/s."""

    place: str
    name: str
    type: BodyType = "static"
    position: Vec = (0.0, 0.0)
    angle: float = 0.0
    velocity: Vec = (0.0, 0.0)
    spin: float = 0.0
    linear_damping: float = 0.0
    angular_damping: float = 0.0
    gravity_scale: float = 1.0
    fixed_rotation: bool = False
    bullet: bool = False
    allow_sleep: bool = True
    awake: bool = True
    active: bool = True
    mass_data: MassData | None = None
    fixtures: list[Fixture] = field(default_factory=list)


@dataclass
class Spring:
    """Frequency (Hz) and damping ratio, or stiffness and damping (N/m and N s/m, of angles N m and N m s)."""

    hertz: float = 0.0
    damping_ratio: float = 0.0
    stiffness: float = 0.0
    damping: float = 0.0


@dataclass
class Joint:
    """A joint between the bodies of numbers `a` and `b`. Anchors and the axis in the frames of their bodies.

    `lower` and `upper` are there where the limit is on, `motor_speed` where the motor is. `ground` are the wheels of
    a pulley, `joints` the numbers of those that a gear couples, `offset` and `angle` where a motor joint drives to.
    """

    place: str
    name: str
    kind: str
    a: int
    b: int
    collide: bool = False
    anchor_a: Vec = (0.0, 0.0)
    anchor_b: Vec = (0.0, 0.0)
    axis: Vec = (1.0, 0.0)
    reference_angle: float = 0.0
    lower: float | None = None
    upper: float | None = None
    motor_speed: float | None = None
    max_motor: float = 0.0
    length: float = 0.0
    spring: Spring = field(default_factory=Spring)
    ratio: float = 1.0
    ground: tuple[Vec, Vec] = ((0.0, 0.0), (0.0, 0.0))
    lengths: Vec | None = None
    joints: tuple[int, int] = (0, 0)
    target: Vec = (0.0, 0.0)
    offset: Vec = (0.0, 0.0)
    angle: float = 0.0
    max_force: float = 0.0
    max_torque: float = 0.0
    correction: float = 0.3


@dataclass
class World:
    """All of a file. `step_rate` in steps per second, 0 where the file does not say."""

    gravity: Vec = (0.0, 0.0)
    sleeping: bool = True
    warm_starting: bool = True
    step_rate: float = 0.0
    bodies: list[Body] = field(default_factory=list)
    joints: list[Joint] = field(default_factory=list)

"""A Box2D world as plain values, whatever file it came from. Lengths in metres, angles in radians."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from sandbox.formats.numbers import Vec

BodyType = Literal["static", "kinematic", "dynamic"]


@dataclass
class Outline:
    """The shape of a fixture: a circle about its point, a capsule about two, a polygon, or lines with the points before
    and after them. `radius` rounds a polygon outwards; `one_sided` lines are solid from the left of them.
    """

    kind: Literal["circle", "capsule", "polygon", "chain"]
    points: list[Vec]
    radius: float = 0.0
    closed: bool = False
    before: Vec | None = None
    after: Vec | None = None
    one_sided: bool = False


@dataclass
class Fixture:
    """A shape with its surface and filter; the defaults are those of Box2D 2. `everything` is its mask of all bits.

    `rolling_resistance` is a lever arm, m; `surface_speed` in m/s, positive to the right on top.
    """

    place: str
    outline: Outline
    density: float = 0.0
    friction: float = 0.2
    restitution: float = 0.0
    sensor: bool = False
    category: int = 1
    mask: int = 0xFFFF
    group: int = 0
    everything: int = 0xFFFF
    rolling_resistance: float = 0.0
    surface_speed: float = 0.0


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
    sleep_speed: float | None = None
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
    a pulley, `rest` where the spring of a hinge or slide pulls to (rad or m), `joints` the numbers of
    those that a gear couples, `offset` and `angle` where a motor joint drives to.
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
    linear_spring: Spring = field(default_factory=Spring)
    rest: float | None = None
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
    """All of a file. `step_rate` in steps per second, 0 where the file does not say; slower impacts than
    `restitution_threshold` (m/s) do not bounce: 1 in Box2D 2 (`b2_velocityThreshold`). `settings` as a scene has them.
    """

    gravity: Vec = (0.0, 0.0)
    sleeping: bool = True
    warm_starting: bool = True
    step_rate: float = 0.0
    restitution_threshold: float = 1.0
    settings: dict[str, float] = field(default_factory=dict)
    bodies: list[Body] = field(default_factory=list)
    joints: list[Joint] = field(default_factory=list)

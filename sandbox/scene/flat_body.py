"""What the bodies of a scene come down to: shapes, thrusters, and the path of one that is driven."""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import dataclass, field
from typing import Literal

Vec = tuple[float, float]
INFINITE = float("inf")
SeamRow = tuple[float, float, float, float, float, float]
"""What the whole looks like at a vertex of a part of it: the columns of `records.SEAM`."""


@dataclass(frozen=True)
class FlatShape:
    """A convex core of 1..64 vertices plus a radius, in the body's frame, with its surface and its filter.

    `vertices` are metres from the body's origin, counter-clockwise; one for a circle, two for a capsule or a
    segment; `clockwise` remembers that the author numbered them the other way round. `density` in kg/m^2,
    `rolling_resistance` in metres, `surface_speed` in m/s.

    A concave polygon is several shapes in a row: `part` counts them from 1 and is 0 for every other shape, `outline`
    is the whole polygon's (a counter-clockwise ring, then one for each hole, clockwise), and `shown[i]` is the stretch
    of the edge from vertex i to the next on which sides of the whole lie, as shares of its length; (1, 0) if none do.

    A link of a chain says in `seam`, a row for each vertex, what joins it. `one_way` is the unit direction in which
    bodies pass through; (0, 0) for what is solid. `material` is the author's name for the surface; nothing that moves
    asks for it.
    """

    kind: Literal["circle", "box", "capsule", "segment", "polygon"]
    vertices: tuple[Vec, ...]
    radius: float = 0.0
    density: float = 1.0
    friction: float = 0.5
    restitution: float = 0.0
    rolling_resistance: float = 0.0
    surface_speed: float = 0.0
    category: int = 1
    mask: int = 0xFFFFFFFF
    group: int = 0
    sensor: bool = False
    clockwise: bool = False
    part: int = 0
    shown: tuple[Vec, ...] = ()
    outline: tuple[tuple[Vec, ...], ...] = ()
    seam: tuple[SeamRow, ...] = ()
    one_way: Vec = (0.0, 0.0)
    material: str = field(default="", compare=False)


@dataclass(frozen=True)
class FlatThruster:
    """A force (N) at a point (m), both in the frame of its body, from `start` to `end` seconds."""

    force: Vec
    at: Vec = (0.0, 0.0)
    start: float = 0.0
    end: float = INFINITE


@dataclass(frozen=True)
class FlatPath:
    """The way of a kinematic body: `points` (x and y in m, angle in rad), from where the body is placed, the first of
    which is where it starts, and the `times` (s) at which it is there, beginning with 0 and never falling.

    One that `loops` begins anew after the last. `smooth` legs begin and end at rest; one not `enabled` waits. The body
    has gone along it for `time` seconds when the scene begins.
    """

    points: tuple[tuple[float, float, float], ...]
    times: tuple[float, ...]
    loops: bool = False
    smooth: bool = False
    enabled: bool = True
    time: float = 0.0

    def after(self, seconds: float) -> tuple[float, float, float]:
        """Where it is after so many seconds, from where the body is placed: x and y (m) and angle (rad).

        To the bit as in the steps of a world (`engine/bodies/paths.py`).
        """
        whole = self.times[-1]
        if self.loops:
            seconds -= whole * math.floor(seconds / whole)
        if seconds >= whole:
            return self.points[-1]
        leg = bisect_right(self.times, seconds)
        if leg == 0:
            return self.points[0]
        begin, end = self.times[leg - 1], self.times[leg]
        share = (seconds - begin) / (end - begin)
        if self.smooth:
            share = share * share * (3.0 - 2.0 * share)
        (x, y, angle), to = self.points[leg - 1], self.points[leg]
        return x + share * (to[0] - x), y + share * (to[1] - y), angle + share * (to[2] - angle)


@dataclass(frozen=True)
class FlatBody:
    """One body. Angles in radians; `mass`, `inertia` and `center` override what the shapes give when not None.

    Bodies made by one prefab share one `shapes` tuple, so that builders may cache by its identity. `pointer` is
    the JSON pointer of what made the body in the scene file, and `prefab` the name of what it is made after.
    """

    id: str
    type: Literal["static", "kinematic", "dynamic"]
    shapes: tuple[FlatShape, ...]
    position: Vec = (0.0, 0.0)
    angle: float = 0.0
    velocity: Vec = (0.0, 0.0)
    angular_velocity: float = 0.0
    linear_damping: float = 0.0
    angular_damping: float = 0.0
    gravity_scale: float = 1.0
    fixed_rotation: bool = False
    sleep_speed: float = 0.05
    bullet: bool = False
    mass: float | None = None
    inertia: float | None = None
    center: Vec | None = None
    color: str | None = None
    thrusters: tuple[FlatThruster, ...] = ()
    path: FlatPath | None = None
    pointer: str = ""
    prefab: str = field(default="", compare=False)

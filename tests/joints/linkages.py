"""Random bodies with random joints, for hypothesis, and what the naive twin is told of a world."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from hypothesis import strategies as st

from sandbox.engine.world import World
from sandbox.scene.flat import FlatJoint, FlatSettings
from tests.flat import body, box
from tests.joints.jointed import G, joint, jointed
from tests.naive import islands
from tests.naive.joint_rows import Array, slots
from tests.naive.joints import Jointed

SETTINGS = FlatSettings(sleeping=False, substeps=1, step_rate=240.0)
MOTOR = {"motor_speed": 1.5, "max_motor": 3.0}
SPRING = {"hertz": 2.0, "damping_ratio": 0.3}
SOFT = {"hertz": 4.0, "damping_ratio": 0.2, "angular_hertz": 3.0, "angular_damping_ratio": 0.5}
STOPS = {"lower": -0.005, "upper": 0.004}
APART = {"anchor_a": (0.1, 0.2), "anchor_b": (0.9, -0.3)}
AXIS = {"axis": (0.6, 0.8)}
KINDS: dict[str, dict[str, Any]] = {
    "revolute": {},
    "revolute motor": MOTOR,
    "revolute spring": {**SPRING, "rest": 0.4},
    "revolute stops": STOPS,
    "revolute motor stops": {**MOTOR, **STOPS},
    "revolute all": {**MOTOR, **SPRING, **STOPS, "rest": -0.3},
    "weld": {},
    "weld soft": SOFT,
    "prismatic": AXIS,
    "prismatic motor": {**AXIS, **MOTOR},
    "prismatic stops": {**AXIS, **STOPS},
    "prismatic all": {**AXIS, **MOTOR, **SPRING, **STOPS, "rest": 0.2},
    "prismatic clamped": {**AXIS, "lower": 0.002, "upper": 0.002},
    "wheel": {**AXIS, **SPRING},
    "wheel motor": {**AXIS, **SPRING, **MOTOR, **STOPS},
    "distance": APART,
    "distance spring": {**APART, **SPRING, "length": 1.1},
    "distance rope": {**APART, "lower": 0.5, "upper": 0.9434},
    "pulley": {**APART, "points": ((0.0, 3.0), (1.0, 3.5)), "ratio": 1.3},
    "motor": {**APART, **SOFT, "points": ((0.8, -0.2),), "angle": 0.3},
    "motor rigid": {**APART, "points": ((0.9004, -0.3),), "angle": 0.0},
    "motor weak to turn": {**APART, **SOFT, "points": ((0.8, -0.2),), "angle": 2.0, "max_torque": 0.2},
    "target": {"points": ((1.0, 0.5),), **SPRING},
    "friction": {"max_force": 1e6, "max_torque": 0.4},
}


@dataclass(frozen=True)
class Linkage:
    """A random world: poses, velocities and masses of bodies, and joints (kind, a, b); -1 is the world."""

    places: tuple[tuple[float, float, float], ...]
    speeds: tuple[tuple[float, float, float], ...]
    masses: tuple[float, ...]
    joints: tuple[tuple[str, int, int], ...]
    gear: bool = False

    def world(self) -> World:
        """The world of it; nothing collides."""
        bodies = [
            body(
                f"b{k}", box(0.8, 0.5, mask=0), position=place[:2], angle=place[2], velocity=speed[:2],
                angular_velocity=speed[2], mass=mass,
            )
            for k, (place, speed, mass) in enumerate(zip(self.places, self.speeds, self.masses, strict=True))
        ]  # fmt: skip
        joints = [self._joint(k, *each) for k, each in enumerate(self.joints)]
        if self.gear:
            joints.append(joint("gear", "gear", None, None, joints=("j0", "j1"), ratio=-1.5))
        return jointed(tuple(bodies), tuple(joints), settings=SETTINGS)

    def _joint(self, k: int, kind: str, a: int, b: int) -> FlatJoint:
        fields = dict(KINDS[kind])
        names = [f"b{i}" if i >= 0 else None for i in (a, b)]
        x, y = (0.0, 0.0) if b < 0 else self.places[b][:2]
        for name in ("anchor_a", "anchor_b"):
            dx, dy = fields.pop(name, (0.3, 0.2))
            fields[name] = x + dx, y + dy
        if "points" in fields:
            fields["points"] = tuple((x + px, y + py) for px, py in fields["points"])
        if kind == "target":
            return joint(f"j{k}", "target", None, names[1], **fields)
        return joint(f"j{k}", kind.split()[0], *names, **fields)

    def still(self) -> Linkage:
        """The same, at rest."""
        return replace(self, speeds=tuple((0.0, 0.0, 0.0) for _ in self.speeds))


SPEED = st.floats(-1.0, 1.0)


@st.composite
def linkages(draw: st.DrawFn, kinds: list[str], most: int = 3) -> Linkage:
    """Up to `most` bodies in a tree, the first of them free or joined to the world, and a joint that closes a loop."""
    count = draw(st.integers(1, most))
    places = tuple((1.2 * k, draw(st.floats(-1.0, 1.0)), draw(st.floats(-math.pi, math.pi))) for k in range(count))
    speeds = tuple((draw(SPEED), draw(SPEED), 2.0 * draw(SPEED)) for _ in range(count))
    masses = tuple(draw(st.sampled_from([0.3, 1.0, 4.0])) for _ in range(count))
    joints = []
    if count == 1 or draw(st.booleans()):
        joints.append((draw(st.sampled_from(kinds)), -1, 0))
    for k in range(1, count):
        joints.append((draw(st.sampled_from([kind for kind in kinds if kind != "target"])), k - 1, k))
    if count > 1 and draw(st.booleans()):
        joints.append((draw(st.sampled_from(kinds)), draw(st.integers(-1, count - 2)), count - 1))
    geared = len(joints) > 1 and all(name.split()[0] in ("revolute", "prismatic", "wheel") for name, *_ in joints[:2])
    return Linkage(places, speeds, masses, tuple(joints), geared and draw(st.booleans()))


def twin(world: World) -> Jointed:
    """What the naive twin needs of a world, between two steps."""
    bodies, joints = world.state.bodies, world.state.joints
    rows = [(j, slot) for j, each in enumerate(joints) for slot in slots(each)]
    halves = np.array([0.5 * float(joints[j][f"impulse_{slot}"]) for j, slot in rows])
    return Jointed(
        joints=joints.copy(),
        rows=rows,
        pose=_columns(bodies.center_x, bodies.center_y, bodies.angle),
        velocity=_columns(bodies.velocity_x, bodies.velocity_y, bodies.angular_velocity),
        inverse=_columns(bodies.inverse_mass, bodies.inverse_mass, bodies.inverse_inertia),
        before=halves,
        after=halves.copy(),
    )


def force(world: World) -> Array:
    """Acceleration of every body by gravity."""
    bodies = world.state.bodies
    return _columns(0.0 * bodies.mass, np.full(len(bodies), -G), 0.0 * bodies.mass)


def parts(world: World) -> list[list[int]]:
    """The bodies that hang together."""
    joints, count = world.state.joints, len(world.names)
    sides = [(int(each.body_a), int(each.body_b)) for each in joints]
    for each in joints:
        if each.joint_1 >= 0:
            first, second = sides[int(each.joint_1)], sides[int(each.joint_2)]
            sides.append((max(first), max(second)))
    links = [(a, b) for a, b in sides if a >= 0 and b >= 0]
    roots = islands.islands(count, links, [True] * count)
    return [[k for k in range(count) if roots[k] == root] for root in sorted(set(roots))]


def _columns(*columns: Any) -> Array:
    return np.stack([np.asarray(column, float) for column in columns], axis=1).ravel()

"""A frame: where everything is at one moment, as read-only arrays. Painters see frames, never a world."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.render.camera import Bounds, Floats
from sandbox.render.field_frame import FieldMarks, capture_fields
from sandbox.render.geometry import Ints, Mesh, build_mesh
from sandbox.render.joint_frame import JointMarks, blend_joints, capture_joints
from sandbox.scene.flat import FlatBody
from sandbox.world.records import STATIC
from sandbox.world.roster import Register
from sandbox.world.state import State


@dataclass(frozen=True)
class Frame:
    """Poses and conditions of all bodies at `time` seconds.

    `center` (n, 2) in metres, `angle` (n,) in radians, `rotation` (n, 2) as (cos, sin), `type`, `awake`, `frozen` (n,),
    `speed` (n,) of the fastest point in m/s; `mesh` says what hangs on the bodies, `joints` what holds them together,
    `fields` what pushes them, `roster` who they are.
    """

    mesh: Mesh
    joints: JointMarks
    center: Floats
    angle: Floats
    rotation: Floats
    type: Ints
    awake: NDArray[np.bool_]
    frozen: NDArray[np.bool_]
    roster: Register[FlatBody]
    speed: Floats
    fields: FieldMarks = field(default_factory=FieldMarks)
    step: int = 0
    time: float = 0.0

    def shape_poses(self) -> tuple[Floats, Floats]:
        """Origin (m, 2) in metres and x axis (m, 2) of every shape frame in the world."""
        mesh = self.mesh
        c, s = self.rotation[mesh.body, 0], self.rotation[mesh.body, 1]
        u, v = mesh.offset[:, 0], mesh.offset[:, 1]
        origin = self.center[mesh.body] + np.column_stack([c * u - s * v, s * u + c * v])
        u, v = mesh.axis[:, 0], mesh.axis[:, 1]
        return origin, np.column_stack([c * u - s * v, s * u + c * v])


def _read_only(array: Any) -> Any:
    copy = np.array(array)
    copy.flags.writeable = False
    return copy


def _speed(bodies: Any) -> Floats:
    """Of the fastest point of each body, m/s."""
    speed: Floats = np.hypot(bodies.velocity_x, bodies.velocity_y) + np.abs(bodies.angular_velocity) * bodies.extent
    return speed


def capture(state: State, mesh: Mesh | None = None) -> Frame:
    """The frame of a world as it stands. The `mesh` of an earlier frame is used again unless bodies came or went."""
    bodies, counters = state.bodies, state.counters[0]
    if mesh is None or mesh.layout != state.layout:
        mesh = build_mesh(state.shapes, state.vertices, state.outlines, state.layout)
    step_seconds = float(state.settings[0].step_seconds)
    return Frame(
        mesh=mesh,
        roster=state.roster.bodies,
        joints=capture_joints(state),
        center=_read_only(np.column_stack([bodies.center_x, bodies.center_y])),
        angle=_read_only(bodies.angle),
        rotation=_read_only(np.column_stack([bodies.rotation_cos, bodies.rotation_sin])),
        type=_read_only(bodies.type),
        awake=_read_only(bodies.awake != 0),
        frozen=_read_only(bodies.frozen_step >= 0),
        speed=_read_only(_speed(bodies)),
        fields=capture_fields(state),
        step=int(counters.step_count),
        time=int(counters.step_count) * step_seconds,
    )


def blend(previous: Frame, current: Frame, alpha: float) -> Frame:
    """The frame between two: 0 is `previous`, 1 is `current`. Angles are not wrapped: spins stay whole.

    If bodies came or went in between, it is the later one.
    """
    if alpha >= 1.0 or previous.mesh.layout != current.mesh.layout:
        return current
    center = previous.center + (current.center - previous.center) * alpha
    angle = previous.angle + (current.angle - previous.angle) * alpha
    turned = current.angle != previous.angle
    rotation = np.where(turned[:, None], np.column_stack([np.cos(angle), np.sin(angle)]), current.rotation)
    time = previous.time + (current.time - previous.time) * alpha
    joints = blend_joints(previous.joints, current.joints, alpha)
    return replace(current, joints=joints, center=center, angle=angle, rotation=rotation, time=time)


def shape_bounds(frame: Frame) -> Floats:
    """Axis-aligned bounds (m, 4) of every shape in metres: min x, min y, max x, max y."""
    origin, axis = frame.shape_poses()
    half, c, s = frame.mesh.half, np.abs(axis[:, 0]), np.abs(axis[:, 1])
    reach_x = c * half[:, 0] + s * half[:, 1] + frame.mesh.radius
    reach_y = s * half[:, 0] + c * half[:, 1] + frame.mesh.radius
    reach = np.column_stack([reach_x, reach_y])
    return np.hstack([origin - reach, origin + reach])


NEAR, BELOW = 0.15, 2.0
"""How far around and below the moving bodies static ones count, in parts of the extent of the moving."""
FAR_BELOW = 40.0
"""How far below the nearest one is looked for, if there is none: what falls from there is still some pixels large."""


def interesting_bounds(frame: Frame) -> Bounds:
    """What a person wants to see: all moving bodies, and of the static what lies near or catches them."""
    boxes = shape_bounds(frame)
    moving = (frame.type != STATIC)[frame.mesh.body]
    if len(boxes) == 0:
        return -5.0, -5.0, 5.0, 5.0
    subject = boxes[moving] if moving.any() else boxes
    low, high = _hull(subject)
    extent = float((high - low).max())
    near = max(NEAR * extent, float(np.median(subject[:, 2:] - subject[:, :2])))
    below = _depth_shown(boxes[~moving], low, high, extent)
    clipped = np.hstack([np.maximum(boxes[:, :2], low - (near, below + near)), boxes[:, 2:]])
    clipped[:, 2:] = np.minimum(clipped[:, 2:], high + near)
    clipped[:, 1] = np.maximum(clipped[:, 1], clipped[:, 3] - near)  # of thick ground, the surface is enough
    visible = clipped[~moving & (clipped[:, :2] <= clipped[:, 2:]).all(axis=1)]
    low, high = _hull(np.vstack([visible, [[*low - near / 2, *high + near / 2]]]))
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def _depth_shown(static: Floats, low: Floats, high: Floats, extent: float) -> float:
    """How far (m) below the moving bodies, which lie within `low..high`, static ones are shown: down to the surface
    onto which they will fall."""
    under = (static[:, 0] <= high[0]) & (static[:, 2] >= low[0])
    depths = (low[1] - static[:, 3])[under]
    nearest = float(depths[depths >= 0.0].min(initial=np.inf))
    return nearest if BELOW * extent < nearest <= FAR_BELOW * extent else BELOW * extent


def _hull(boxes: Floats) -> tuple[Floats, Floats]:
    return boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)

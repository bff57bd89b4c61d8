"""Which body lies under a point of the plane: a point-in-shape test on the data of a frame."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sandbox.render.camera import Floats, Vec
from sandbox.render.frame import Frame
from sandbox.render.geometry import Ints
from sandbox.world.records import DYNAMIC


def pick(frame: Frame, point: Vec, slack: float = 0.0, types: Sequence[int] = (DYNAMIC,)) -> int | None:
    """The body of one of `types` at `point`, the topmost if there are several; None if there is none.

    A body up to `slack` metres away counts as well where none is hit, so that small ones can be caught.
    """
    origin, axis = frame.shape_poses()
    local = _to_shape_frames(np.asarray(point) - origin, axis)
    near = _near(frame, local, slack, types)
    if len(near) == 0:
        return None
    distance = np.array([shape_distance(frame, int(i), local[i]) for i in near])
    inside = near[distance <= 0.0]
    best = inside[-1] if len(inside) else near[int(distance.argmin())]
    return int(frame.mesh.body[best]) if len(inside) or distance.min() <= slack else None


def _to_shape_frames(offset: Floats, axis: Floats) -> Floats:
    x, y, c, s = offset[:, 0], offset[:, 1], axis[:, 0], axis[:, 1]
    return np.column_stack([c * x + s * y, c * y - s * x])


def _near(frame: Frame, local: Floats, slack: float, types: Sequence[int]) -> Ints:
    """Shapes of bodies of `types` whose box in the shape frame, widened by `slack`, holds the point."""
    mesh = frame.mesh
    beyond = np.abs(local) - mesh.half - mesh.radius[:, None] - slack
    return np.flatnonzero((beyond <= 0.0).all(axis=1) & np.isin(frame.type[mesh.body], types))


def shape_distance(frame: Frame, shape: int, point: Floats) -> float:
    """Signed distance (m) of `point` (2,), given in the shape frame, from the shape; negative inside."""
    if shape in frame.mesh.outlines:
        return frame.mesh.outlines[shape].distance(point)
    core, radius = frame.mesh.core(shape), float(frame.mesh.radius[shape])
    following = np.roll(core, -1, axis=0)
    along, to = following - core, point - core
    length = np.maximum((along * along).sum(axis=1), 1e-300)
    off = to - along * np.clip((to * along).sum(axis=1) / length, 0.0, 1.0)[:, None]
    distance = float(np.hypot(off[:, 0], off[:, 1]).min())
    outside = to[:, 0] * along[:, 1] - to[:, 1] * along[:, 0] > 0.0
    inside = len(core) >= 3 and not outside.any()
    return (-distance if inside else distance) - radius

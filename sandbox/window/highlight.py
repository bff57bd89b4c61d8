"""The outline around what is selected."""

from __future__ import annotations

import numpy as np

from sandbox.render.camera import Camera, Floats
from sandbox.render.contour import contour
from sandbox.render.field_drawing import area
from sandbox.render.field_frame import region_mark
from sandbox.render.frame import Frame
from sandbox.render.marks import Marks
from sandbox.render.strokes import joined, strokes
from sandbox.render.theme import Color
from sandbox.window.tools.joint_pick import joint_spans
from sandbox.world.state import State

WIDTH, GAP = 2.0, 3.0
"""Pixels."""
RING = 9.0
"""Pixels of the radius of a ring around an anchor."""
MOST = 300
"""Outlines that are drawn at most."""


_TURN = np.linspace(0.0, 2.0 * np.pi, 25)
_CIRCLE = np.column_stack([np.cos(_TURN), np.sin(_TURN)])


def highlight(frame: Frame, camera: Camera, names: tuple[str, ...], color: Color) -> Marks:
    """An outline a little outside of every shape of the bodies of these ids."""
    wanted = set(names)
    bodies = [row for row, name in enumerate(frame.roster.names) if name in wanted] if names else []
    if not bodies:
        return Marks()
    origin, axis = frame.shape_poses()
    shapes = np.flatnonzero(np.isin(frame.mesh.body, bodies))[:MOST]
    lines = []
    for shape in shapes.tolist():
        corners = camera.to_screen(origin[shape] + _turned(_contour(frame, shape, camera.scale), axis[shape]))
        lines.append(strokes(corners, np.roll(corners, -1, axis=0), WIDTH, color, 0.95))
    return Marks(strokes=joined(lines))


def highlight_joint(state: State, frame: Frame, camera: Camera, name: str | None, color: Color) -> Marks:
    """Rings around the anchors of the joint of that id, and a line along what it spans."""
    rows, starts, ends = joint_spans(state, frame)
    mine = rows == state.joint_names.index(name) if name in state.joint_names else np.zeros(len(rows), np.bool_)
    if not mine.any():
        return Marks()
    first, last = camera.to_screen(starts[mine]), camera.to_screen(ends[mine])
    rings = np.concatenate([first, last])[:, None, :] + RING * _CIRCLE
    around = strokes(rings[:, :-1].reshape(-1, 2), rings[:, 1:].reshape(-1, 2), WIDTH, color, 0.95)
    return Marks(strokes=joined([strokes(first, last, WIDTH, color, 0.95), around]))


def highlight_region(state: State, camera: Camera, row: int | None, color: Color) -> Marks:
    """An outline around the region of that row, if it has an area."""
    region = None if row is None else region_mark(state, row)
    if region is None or not (len(region.edges) or region.disc[2] > 0.0):
        return Marks()
    corners = camera.to_screen(area(region, camera))
    return Marks(strokes=strokes(corners, np.roll(corners, -1, axis=0), WIDTH, color, 0.95))


def _contour(frame: Frame, shape: int, scale: float) -> Floats:
    """The outline of a shape in its own frame, in metres; of a concave one, that of the box around it."""
    mesh, gap = frame.mesh, GAP / scale
    if shape in mesh.outlines:
        x, y = mesh.half[shape] + gap
        return np.array([[-x, -y], [x, -y], [x, y], [-x, y]])
    return contour(mesh.core(shape), float(mesh.radius[shape]) + gap, 0.25 / scale)


def _turned(points: Floats, axis: Floats) -> Floats:
    c, s = axis
    return np.column_stack([c * points[:, 0] - s * points[:, 1], s * points[:, 0] + c * points[:, 1]])

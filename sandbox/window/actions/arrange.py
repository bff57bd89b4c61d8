"""Actions that put what is selected in line."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from sandbox.engine.commands.motion import SetPose
from sandbox.render.camera import Floats
from sandbox.render.frame import Frame, shape_bounds
from sandbox.window.actions.action import Action
from sandbox.window.workspace import Workspace

Shifts: TypeAlias = Callable[[Floats], Floats]
"""Boxes (n, 4) of bodies, metres -> how far each is to go (n, 2)."""


def body_boxes(frame: Frame, rows: list[int]) -> Floats:
    """Axis-aligned boxes (n, 4) of bodies in metres: min x, min y, max x, max y."""
    shapes, owner = shape_bounds(frame), frame.mesh.body
    boxes = [shapes[owner == row] for row in rows]
    return np.array([[*box[:, :2].min(axis=0), *box[:, 2:].max(axis=0)] for box in boxes])


def _arrange(title: str, shifts: Shifts) -> Callable[[Workspace], None]:
    def run(workspace: Workspace) -> None:
        world = workspace.session.world
        names = workspace.selection.present(world)
        if len(names) < 2:
            workspace.say("select two bodies or more first: Shift adds to what is selected")
            return
        rows = [world.names.index(name) for name in names]
        by = shifts(body_boxes(workspace.session.current, rows))
        views = [world.body(name) for name in names]
        poses = [
            SetPose(view.id, (view.position[0] + float(x), view.position[1] + float(y)), view.angle)
            for view, (x, y) in zip(views, by, strict=True)
        ]
        workspace.do(title, *poses)

    return run


def _to_side(column: int, extreme: Callable[[Floats], float]) -> Shifts:
    """All to where the one goes whose side is the extreme one."""

    def shifts(boxes: Floats) -> Floats:
        by = np.zeros((len(boxes), 2))
        by[:, column % 2] = extreme(boxes[:, column]) - boxes[:, column]
        return by

    return shifts


def _to_middle(axis: int) -> Shifts:
    def shifts(boxes: Floats) -> Floats:
        by = np.zeros((len(boxes), 2))
        middle = (boxes[:, axis] + boxes[:, axis + 2]) / 2
        by[:, axis] = middle.mean() - middle
        return by

    return shifts


def _spread(axis: int) -> Shifts:
    """The same gap between neighbours; the first and the last stay."""

    def shifts(boxes: Floats) -> Floats:
        order = np.argsort(boxes[:, axis], kind="stable")
        size = boxes[:, axis + 2] - boxes[:, axis]
        room = boxes[order[-1], axis + 2] - boxes[order[0], axis] - size.sum()
        starts = boxes[order[0], axis] + np.cumsum([0.0, *(size[order[:-1]] + room / (len(boxes) - 1))])
        by = np.zeros((len(boxes), 2))
        by[order, axis] = starts - boxes[order, axis]
        return by

    return shifts


_WAYS: tuple[tuple[str, str, str, Shifts], ...] = (
    ("align-left", "Align left", "Left sides in line.", _to_side(0, lambda v: float(v.min()))),
    ("align-middle", "Align middles", "Middles above each other.", _to_middle(0)),
    ("align-right", "Align right", "Right sides in line.", _to_side(2, lambda v: float(v.max()))),
    ("align-top", "Align top", "Tops in line.", _to_side(3, lambda v: float(v.max()))),
    ("align-level", "Align level", "Middles beside each other.", _to_middle(1)),
    ("align-bottom", "Align bottom", "Bottoms in line.", _to_side(1, lambda v: float(v.min()))),
    ("spread-across", "Spread across", "The same gaps from left to right.", _spread(0)),
    ("spread-up", "Spread up", "The same gaps from bottom to top.", _spread(1)),
)
ACTIONS = tuple(
    Action(
        name, title, "Arrange", (), help_line, _arrange(title, shifts), enabled=lambda w: len(w.selection.bodies) > 1
    )
    for name, title, help_line, shifts in _WAYS
)

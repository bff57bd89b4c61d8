"""Which joint lies under the pointer."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.render.frame import Frame
from sandbox.tables import Floats, Integers, plain
from sandbox.window.tools.tool import GRAB_PIXELS, Pointer
from sandbox.window.workspace import Workspace
from sandbox.world.joint_records import GEAR, PULLEY, TARGET
from sandbox.world.state import State


def joint_under(workspace: Workspace, pointer: Pointer, lines: bool = True) -> str | None:
    """The id of the joint whose anchors, or with `lines` what it spans, are nearest; None beyond `GRAB_PIXELS`."""
    state = workspace.session.world.state
    rows, starts, ends = joint_spans(state, workspace.session.frame())
    if not len(rows):
        return None
    point = np.asarray(pointer.point)
    if lines:
        distance = _from_spans(point, starts, ends)
    else:
        distance = np.minimum(_length(point - starts), _length(point - ends))
    nearest = int(distance.argmin())
    found = distance[nearest] <= GRAB_PIXELS / workspace.viewport.camera.scale
    return state.joint_names[rows[nearest]] if found else None


def joint_spans(state: State, frame: Frame) -> tuple[Integers, Floats, Floats]:
    """Of joints that hold: their rows, and the two ends of what is between their anchors where a frame shows it, m.

    A pulley has three, two lengths of rope and what is between its wheels; a gear has none.
    """
    joints: Any = plain(state.joints)
    rows = np.flatnonzero((joints["broken_step"] < 0) & (joints["kind"] != GEAR))
    table = joints[rows]
    a, b = _anchors(frame, table, "a"), _anchors(frame, table, "b")
    wheel_a, wheel_b = (np.column_stack([table[f"point_{side}x"], table[f"point_{side}y"]]) for side in "ab")
    to_target, roped = table["kind"] == TARGET, table["kind"] == PULLEY
    a = np.where(to_target[:, None], wheel_a, a)
    first_ends = np.where(roped[:, None], wheel_a, b)
    starts = np.concatenate([a, wheel_a[roped], b[roped]])
    ends = np.concatenate([first_ends, wheel_b[roped], wheel_b[roped]])
    return np.concatenate([rows, rows[roped], rows[roped]]), starts, ends


def _anchors(frame: Frame, joints: Any, side: str) -> Floats:
    """Where the anchors on one side are in the world; those on the world itself are there already."""
    body = joints[f"body_{side}"]
    x, y = joints[f"anchor_{side}x"], joints[f"anchor_{side}y"]
    held = body >= 0
    c, s = (np.where(held, frame.rotation[body, k], (1.0, 0.0)[k]) for k in range(2))
    center = np.where(held[:, None], frame.center[body], 0.0)
    anchors: Floats = center + np.column_stack([c * x - s * y, s * x + c * y])
    return anchors


def _from_spans(point: Floats, starts: Floats, ends: Floats) -> Floats:
    """How far a point is from each line between two ends, in metres."""
    along, to = ends - starts, point - starts
    square = np.maximum((along * along).sum(axis=1), 1e-300)
    share = np.clip((to * along).sum(axis=1) / square, 0.0, 1.0)
    return _length(to - along * share[:, None])


def _length(vectors: Floats) -> Floats:
    return np.asarray(np.hypot(vectors[:, 0], vectors[:, 1]))

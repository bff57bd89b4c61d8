"""Which joint lies under the pointer."""

from __future__ import annotations

import numpy as np

from sandbox.window.tools.tool import GRAB_PIXELS, Pointer
from sandbox.window.workspace import Workspace


def joint_under(workspace: Workspace, pointer: Pointer) -> str | None:
    """The id of the joint whose anchors, or the line between them, are nearest; None beyond `GRAB_PIXELS`."""
    world, best = workspace.session.world, (GRAB_PIXELS / workspace.viewport.camera.scale, "")
    for joint in world.joints:
        if not joint.id or joint.broken:
            continue
        distance = min((_distance(pointer.point, part) for part in _parts(joint.anchors)), default=np.inf)
        best = min(best, (distance, joint.id))
    return best[1] or None


def _parts(anchors: object) -> list[tuple[np.ndarray, np.ndarray]]:
    points = np.atleast_2d(np.asarray(anchors, float))
    return list(zip(points, [*points[1:], points[-1]], strict=True)) if points.size else []


def _distance(point: tuple[float, float], part: tuple[np.ndarray, np.ndarray]) -> float:
    """Of a point from the line between two points, in metres."""
    start, along = part[0], part[1] - part[0]
    square = float(along @ along)
    share = 0.0 if square == 0.0 else min(max(float((point - start) @ along) / square, 0.0), 1.0)
    return float(np.hypot(*(point - start - share * along)))

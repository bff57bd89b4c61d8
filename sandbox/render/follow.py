"""The camera that goes along: with a body, or with whatever moves."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from sandbox.render.camera import Bounds, Camera, Vec, fit
from sandbox.render.frame import Frame, shape_bounds
from sandbox.scene.references import MOVING

CATCH_UP_SECONDS = 0.35
"""In so much time the camera covers about two thirds of the way to what it follows."""
SEEN_PIXELS = 4.0
"""Pixels a second from which on a body counts as moving: less is not seen."""
WIDEST = 4.0
"""How many times more than at home is shown at most, so that what flies away is let go."""
_FEW = 20
"""Of more bodies than these, the outermost are not waited for."""


def followed(camera: Camera, frame: Frame, target: str, home: Camera, seconds: float | None = None) -> Camera:
    """The camera `seconds` later, on its way to the body of the id `target`, or to what moves if it is "moving".

    None arrives at once. `home` is the camera that nothing is followed with: its height is kept, unless what moves
    needs more. Where there is nothing to follow the camera stays.
    """
    aim = _aim(frame, target, home)
    if aim is None:
        return camera
    share = 1.0 if seconds is None else 1.0 - math.exp(-seconds / CATCH_UP_SECONDS)
    (x, y), (goal_x, goal_y) = camera.center, aim.center
    scale = camera.scale * (aim.scale / camera.scale) ** share
    return replace(camera, center=(x + share * (goal_x - x), y + share * (goal_y - y)), scale=scale)


def _aim(frame: Frame, target: str, home: Camera) -> Camera | None:
    """Where the camera would be if it had arrived."""
    names = frame.roster.names
    if target in names:
        x, y = frame.center[names.index(target)].tolist()
        return replace(home, center=(x, y))
    bounds = moving_bounds(frame, home.scale) if target == MOVING else None
    if bounds is None:
        return None
    wide = fit(bounds, home.size, margin=0.2)
    scale = min(home.scale, max(wide.scale, home.scale / WIDEST))
    return replace(home, center=_middle(bounds), scale=scale)


def moving_bounds(frame: Frame, scale: float) -> Bounds | None:
    """What holds all that is seen to move at `scale` pixels a metre, in metres; None if nothing does."""
    moving = (frame.speed * scale > SEEN_PIXELS) & frame.awake & (frame.type > 0)
    rows = np.flatnonzero(moving[frame.mesh.body])
    if len(rows) == 0:
        return None
    boxes = shape_bounds(frame)[rows]
    low, high = boxes[:, :2], boxes[:, 2:]
    share = 0.0 if len(rows) <= _FEW else 0.05
    x0, y0 = np.quantile(low, share, axis=0).tolist()
    x1, y1 = np.quantile(high, 1.0 - share, axis=0).tolist()
    return x0, y0, x1, y1


def _middle(bounds: Bounds) -> Vec:
    return (bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2

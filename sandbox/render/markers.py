"""Rings around bodies that are too small to see, such as planets in their orbits."""

from __future__ import annotations

import numpy as np

from sandbox.render.camera import Camera, Floats
from sandbox.render.frame import Frame
from sandbox.render.geometry import Ints
from sandbox.render.marks import Marks
from sandbox.render.strokes import joined, strokes
from sandbox.world.records import STATIC

LARGEST_PIXELS, FULL_PIXELS = 4.0, 2.0
"""Radius below which a body gets a marker, and below which it is drawn fully."""
RING, DOT = 7.0, 2.2
"""Pixels: radius of the ring, least radius of the dot in it."""
APART_PIXELS = 16.0
"""Bodies that are closer to each other get none: a crowd is seen anyway."""
MOST = 2000
"""More small bodies than that are a crowd."""
_TURN = np.linspace(0.0, 2.0 * np.pi, 21)
_CIRCLE = np.column_stack([np.cos(_TURN), np.sin(_TURN)])


def markers(frame: Frame, camera: Camera, fill: Floats) -> Marks:
    """A dot and a ring for each small body that is by itself, in its own colour of `fill` (n, 3) sRGB."""
    mesh = frame.mesh
    extent = np.zeros(len(frame.type))
    np.maximum.at(extent, mesh.body, np.where(mesh.sensor, 0.0, np.hypot(*mesh.offset.T) + mesh.reach) * camera.scale)
    small = np.flatnonzero((extent < LARGEST_PIXELS) & (extent > 0.0) & (frame.type != STATIC))
    if not 0 < len(small) <= MOST:
        return Marks()
    at = camera.to_screen(frame.center[small])
    seen = ((at > -RING) & (at < np.asarray(camera.size) + RING)).all(axis=1)
    small, at = small[seen], at[seen]
    alone = _alone(at)
    small, at = small[alone], at[alone]
    if len(small) == 0:
        return Marks()
    share = np.clip((LARGEST_PIXELS - extent[small]) / (LARGEST_PIXELS - FULL_PIXELS), 0.0, 1.0)
    dots = strokes(at, at, 2.0 * DOT, fill[small], share)
    corners = at[:, None] + RING * _CIRCLE
    each = len(_CIRCLE) - 1
    starts, ends = corners[:, :-1].reshape(-1, 2), corners[:, 1:].reshape(-1, 2)
    rings = strokes(starts, ends, 1.2, np.repeat(fill[small], each, axis=0), np.repeat(0.6 * share, each))
    return Marks(strokes=joined([dots, rings]))


def _alone(at: Floats) -> Ints:
    """Which of the pixels (n, 2) have no other within about `APART_PIXELS`: none in their cell and those around it."""
    cells = np.floor(at / APART_PIXELS).astype(np.int64)
    cells -= cells.min(axis=0, initial=0) - 1
    wide = int(cells[:, 0].max(initial=0)) + 2
    count = np.bincount(cells[:, 1] * wide + cells[:, 0], minlength=wide * (int(cells[:, 1].max(initial=0)) + 2))
    around = sum(count[(cells[:, 1] + y) * wide + cells[:, 0] + x] for x in (-1, 0, 1) for y in (-1, 0, 1))
    return np.flatnonzero(np.asarray(around) == 1)

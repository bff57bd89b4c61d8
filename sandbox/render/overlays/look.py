"""What an overlay is, and what it looks at."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.world import World
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera, Floats
from sandbox.render.frame import Frame
from sandbox.render.geometry import Ints, gather
from sandbox.render.marks import Marks
from sandbox.render.overlays.contact_points import ContactPoints, read_contact_points
from sandbox.render.overlays.palette import Palette, palette_for
from sandbox.render.theme import Theme
from sandbox.render.trails import Trails
from sandbox.tables import plain

USUAL_PIXELS = 16.0, 44.0
"""Extents of bodies between which marks have their usual size."""
MARK_SCALES = 0.4, 1.6


@dataclass(frozen=True)
class Look:
    """A moment of a world as it is seen: the world is only read. What several overlays ask for is worked out once."""

    world: World
    frame: Frame
    camera: Camera
    theme: Theme
    trails: Trails | None = None
    """Where bodies were, if somebody keeps it."""
    scale: float = 1.0
    """How many times as large as usual words are, and lines and marks that have their size in pixels."""

    @cached_property
    def colors(self) -> Floats:
        """The colours of the bodies by themselves (n, 3), sRGB."""
        return body_colors_of(self.world.state, self.theme).base

    @cached_property
    def palette(self) -> Palette:
        """The colours that overlays use, for this theme."""
        return palette_for(self.theme)

    @cached_property
    def points(self) -> ContactPoints:
        """The contact points in sight."""
        return read_contact_points(self.world, self.frame, self.camera)

    @cached_property
    def shape_boxes(self) -> Floats:
        """Axis-aligned boxes (s, 4) of all shapes of the engine, metres: min x, min y, max x, max y."""
        state, frame = self.world.state, self.frame
        shapes, vertices = plain(state.shapes), plain(state.vertices)
        if len(shapes) == 0:
            return np.zeros((0, 4))
        rows, first = gather(shapes["vertex_start"], shapes["vertex_count"])
        body = np.repeat(shapes["body"], shapes["vertex_count"])
        (c, s), (u, v) = frame.rotation[body].T, (vertices["x"][rows], vertices["y"][rows])
        corners = frame.center[body] + np.column_stack([c * u - s * v, s * u + c * v])
        radius = shapes["radius"][:, None]
        low, high = np.minimum.reduceat(corners, first), np.maximum.reduceat(corners, first)
        return np.hstack([low - radius, high + radius])

    @cached_property
    def mark_scale(self) -> float:
        """`scale`, less where bodies are small on the picture, so that marks do not hide them, more where they are
        large.
        """
        rows = self.visible_bodies()
        if len(rows) == 0:
            return self.scale
        pixels = float(np.median(plain(self.world.state.bodies)["extent"][rows])) * self.camera.scale
        small, large = (bound * self.scale for bound in USUAL_PIXELS)
        return self.scale * float(np.clip(pixels / np.clip(pixels, small, large), *MARK_SCALES))

    def visible(self, points: Floats, margin: float = 60.0) -> NDArray[np.bool_]:
        """Which of the pixels (n, 2) are in the picture, or at most `margin` pixels beside it."""
        inside = (points >= -margin) & (points <= np.asarray(self.camera.size) + margin)
        return inside[:, 0] & inside[:, 1]

    def visible_boxes(self, boxes: Floats) -> NDArray[np.bool_]:
        """Which boxes (n, 4), in metres, reach into the picture."""
        x0, y0, x1, y1 = self.camera.bounds
        seen: NDArray[np.bool_] = (boxes[:, 0] <= x1) & (boxes[:, 2] >= x0) & (boxes[:, 1] <= y1) & (boxes[:, 3] >= y0)
        return seen

    def visible_bodies(self, moving: bool = True) -> Ints:
        """Rows of the bodies whose centre is in sight; only those that are not static, if `moving`."""
        seen = self.visible(self.camera.to_screen(self.frame.center))
        return np.flatnonzero(seen & (self.frame.type > 0) if moving else seen)


@dataclass(frozen=True)
class Overlay:
    """One overlay: a stable `name` for options and files, a `title` for menus, a line of `help`, and what it draws."""

    name: str
    title: str
    help: str
    draw: Callable[[Look], Marks]

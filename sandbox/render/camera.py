"""The camera: which part of the plane is seen. World: metres, y up. Screen: pixels, y down."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats: TypeAlias = NDArray[np.float64]
Vec: TypeAlias = tuple[float, float]
Size: TypeAlias = tuple[int, int]
Bounds: TypeAlias = tuple[float, float, float, float]
"""min x, min y, max x, max y in metres."""

MIN_SCALE, MAX_SCALE = 1e-7, 1e6


def _clamp_scale(scale: float) -> float:
    return min(max(scale, MIN_SCALE), MAX_SCALE)


@dataclass(frozen=True)
class Camera:
    """A view without rotation: `center` in metres is the middle of `size` pixels, `scale` pixels a metre."""

    center: Vec = (0.0, 0.0)
    scale: float = 40.0
    size: Size = (1280, 800)

    def to_screen(self, points: ArrayLike) -> Floats:
        """World points (..., 2) in metres -> pixels (..., 2)."""
        offset = np.asarray(points, dtype=np.float64) - self.center
        return offset * (self.scale, -self.scale) + (self.size[0] / 2, self.size[1] / 2)

    def to_world(self, pixels: ArrayLike) -> Floats:
        """Pixels (..., 2) -> world points (..., 2) in metres."""
        offset = np.asarray(pixels, dtype=np.float64) - (self.size[0] / 2, self.size[1] / 2)
        return offset / (self.scale, -self.scale) + self.center

    def point(self, pixel: Vec) -> Vec:
        """One pixel -> one world point, as plain floats."""
        x, y = self.to_world(pixel)
        return float(x), float(y)

    @property
    def bounds(self) -> Bounds:
        """The visible rectangle in metres."""
        half_x, half_y = self.size[0] / 2 / self.scale, self.size[1] / 2 / self.scale
        x, y = self.center
        return x - half_x, y - half_y, x + half_x, y + half_y

    def zoomed(self, factor: float, about: Vec) -> Camera:
        """Zoom in (`factor` > 1) or out; the world point under the pixel `about` stays under it."""
        scale = _clamp_scale(self.scale * factor)
        world_x, world_y = self.point(about)
        dx, dy = about[0] - self.size[0] / 2, about[1] - self.size[1] / 2
        return replace(self, scale=scale, center=(world_x - dx / scale, world_y + dy / scale))

    def panned(self, dx: float, dy: float) -> Camera:
        """Move the picture by (dx, dy) pixels, as a hand moves a sheet of paper."""
        x, y = self.center
        return replace(self, center=(x - dx / self.scale, y + dy / self.scale))

    def resized(self, size: Size) -> Camera:
        """The same view in a window of another size; the visible height in metres stays."""
        return replace(self, size=size, scale=_clamp_scale(self.scale * size[1] / self.size[1]))


def fit(bounds: Bounds, size: Size, margin: float = 0.1) -> Camera:
    """A camera that shows all of `bounds` with `margin` (a part of the window) free on every side."""
    x0, y0, x1, y1 = bounds
    free = 1.0 - 2.0 * margin
    wide = free * size[0] / max(x1 - x0, 1e-9)
    high = free * size[1] / max(y1 - y0, 1e-9)
    return Camera(((x0 + x1) / 2, (y0 + y1) / 2), _clamp_scale(min(wide, high)), size)


def look_at(center: Vec, height: float, size: Size) -> Camera:
    """A camera centred on `center` that shows `height` metres from bottom to top."""
    return Camera((float(center[0]), float(center[1])), _clamp_scale(size[1] / height), size)


def scene_camera(view: Any, bounds: Bounds, size: Size) -> Camera:
    """The camera a scene asks for (`view.center`, `view.height`); where it is silent, fit `bounds`."""
    height = getattr(view, "height", None)
    center = getattr(view, "center", None)
    fitted = fit(bounds, size)
    return look_at(center or fitted.center, height or size[1] / fitted.scale, size)

"""What everything that the inspector draws has at hand."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.geometry.sat_rows import Vec
from sandbox.render.camera import Camera
from sandbox.window.sat.colors import SatColors
from sandbox.window.sat.inspection import Inspection
from sandbox.window.sat.pen import Pen


@dataclass(frozen=True)
class Sheet:
    """A pen, what it draws in which colours, and the camera that sees it."""

    pen: Pen
    seen: Inspection
    colors: SatColors
    camera: Camera


def middle_of(points: tuple[Vec, ...]) -> Vec:
    """The mean of some points."""
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)

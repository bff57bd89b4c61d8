"""Regions in one line each."""

from __future__ import annotations

from typing import Any

from sandbox.scene.flat import FlatRegion

G = 9.81


def water(density: float = 1.0, surface: float = 0.0, drag: float = 0.0, **fields: Any) -> FlatRegion:
    """Water everywhere below a surface."""
    return FlatRegion("water", ((0.0, 1.0, surface),), density=density, drag=drag, angular_drag=drag, **fields)


def inside(left: float, bottom: float, right: float, top: float) -> tuple[tuple[float, float, float], ...]:
    """The edges of a box."""
    return (-1.0, 0.0, -left), (0.0, -1.0, -bottom), (1.0, 0.0, right), (0.0, 1.0, top)

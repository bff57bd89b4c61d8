"""A stroke, the simplest thing a painter draws."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.render.camera import Vec
from sandbox.render.theme import Color


@dataclass(frozen=True)
class Line:
    """A stroke with round ends: pixels, pixel width, sRGB and opacity 0..1."""

    start: Vec
    end: Vec
    width: float
    color: Color
    opacity: float = 1.0

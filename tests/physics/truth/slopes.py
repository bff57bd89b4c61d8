"""Ground and slopes for the experiments."""

from __future__ import annotations

import math
from typing import Any

from sandbox.scene.flat import FlatBody, FlatShape, Vec
from tests.flat import body, box
from tests.physics.truth.experiment import Run


def slope(angle: float, **surface: Any) -> FlatBody:
    """Static ground of 100 m turned by `angle`: its top runs through the origin, uphill to +x."""
    return body("ground", box(100.0, 2.0, (0.0, -1.0), **surface), type="static", angle=angle)


def rider(angle: float, shape: FlatShape, height: float, speed: float = 0.0, **fields: Any) -> FlatBody:
    """A body that touches the slope at the origin, its middle `height` above, going up it by `speed`."""
    cosine, sine = math.cos(angle), math.sin(angle)
    place, velocity = (-height * sine, height * cosine), (speed * cosine, speed * sine)
    return body("rider", shape, position=place, angle=angle, velocity=velocity, **fields)


def up_the_slope(angle: float, vector: Vec) -> float:
    """The part of a vector that points up the slope."""
    return vector[0] * math.cos(angle) + vector[1] * math.sin(angle)


def way_up(run: Run, angle: float) -> float:
    """How far up the slope the rider is from where it was put."""
    return up_the_slope(angle, run.place("rider"))

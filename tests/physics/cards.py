"""Houses of cards."""

from __future__ import annotations

import math

from sandbox.scene.flat import FlatScene
from tests.flat import body, box, ground


def house(levels: int, friction: float, gap: float) -> FlatScene:
    """Tents of cards of 1 m on lying cards, each card `gap` metres above what it will land on."""
    lean, thick = math.radians(20.0), 0.02
    height, width = math.cos(lean), math.sin(lean)
    pitch = 2.0 * width + 3.0 * thick
    bodies, floor = [ground(400.0, friction=friction)], 0.0
    for tents in range(levels, 0, -1):
        for k in range(tents):
            middle = (k - 0.5 * (tents - 1)) * pitch
            for side, name in ((-1, "left"), (1, "right")):
                place = (middle + side * (0.5 * width + 0.6 * thick), floor + gap + 0.5 * (height + thick * width))
                card = box(thick, 1.0, friction=friction)
                bodies.append(body(f"{name} {k} of {tents}", card, position=place, angle=side * lean))
        floor += height + 2.0 * gap + thick * width + thick
        for k in range(tents - 1):
            place = ((k - 0.5 * (tents - 2)) * pitch, floor - 0.5 * thick)
            bodies.append(body(f"card {k} on {tents}", box(0.98 * pitch, thick, friction=friction), position=place))
        floor += gap
    return FlatScene(tuple(bodies))

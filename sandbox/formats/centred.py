"""A body that stands at the middle of its only shape."""

from __future__ import annotations

import math

from sandbox.formats.numbers import tidy_point, turned
from sandbox.formats.outlines import Words


def centred(words: Words) -> Words:
    """The same body, with the shape's `at` made part of its position."""
    (shape,) = words["shapes"]
    if "at" not in shape:
        return words
    x, y = turned((shape["at"][0], shape["at"][1]), math.radians(words.get("angle", 0.0)))
    rest = {key: value for key, value in shape.items() if key != "at"}
    px, py = words["position"]
    return words | {"position": tidy_point((px + x, py + y)), "shapes": [rest]}

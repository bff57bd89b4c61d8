"""Something that a recording has made."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from sandbox.formats.numbers import Vec

Values = dict[str, Any]


@dataclass
class Made:
    """What it is, its definition as it is now, and the body that it is on."""

    kind: str
    values: Values
    body: int = 0


def angle_of(rotation: Vec) -> float:
    """Of cosine and sine, rad."""
    return math.atan2(rotation[1], rotation[0])

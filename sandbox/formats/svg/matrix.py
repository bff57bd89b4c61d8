"""Affine maps, as SVG writes them.

Source: CSS Transforms 1, section 8 (the `transform` attribute), and SVG 2, section 8.2 (`viewBox`).
"""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from sandbox.formats.numbers import Vec

_FUNCTION = re.compile(r"\s*,?\s*(\w+)\s*\(([^()]*)\)")
_NUMBER = re.compile(r"[\s,]*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)([a-zA-Z%]*)[\s,]*")
_LONGEST = 4000
"""Characters of a transform."""
_UNITS = {"": 1.0, "px": 1.0, "deg": 1.0, "rad": 180.0 / math.pi, "grad": 0.9, "turn": 360.0}
"""Of lengths in pixels, and of angles in degrees."""


class Matrix(NamedTuple):
    """x' = a x + c y + e, y' = b x + d y + f."""

    a: float = 1.0
    b: float = 0.0
    c: float = 0.0
    d: float = 1.0
    e: float = 0.0
    f: float = 0.0

    def of(self, point: Vec) -> Vec:
        """A point under the map."""
        x, y = point
        return self.a * x + self.c * y + self.e, self.b * x + self.d * y + self.f

    def after(self, first: Matrix) -> Matrix:
        """The map that does `first` and then this one."""
        (a, b), (c, d) = (self._turned(first.a, first.b), self._turned(first.c, first.d))
        return Matrix(a, b, c, d, *self.of((first.e, first.f)))

    @property
    def scale(self) -> float:
        """The greatest factor by which it makes something longer."""
        half, rest = (self.a + self.d) / 2.0, (self.b - self.c) / 2.0
        return math.hypot(half, rest) + math.hypot((self.a - self.d) / 2.0, (self.b + self.c) / 2.0)

    @property
    def is_similar(self) -> bool:
        """Whether it keeps circles round."""
        size = max(self.scale, 1e-30)
        direct = abs(self.a - self.d) + abs(self.b + self.c)
        mirrored = abs(self.a + self.d) + abs(self.b - self.c)
        return min(direct, mirrored) < 1e-6 * size

    def _turned(self, x: float, y: float) -> Vec:
        return self.a * x + self.c * y, self.b * x + self.d * y


def parse_transform(text: str) -> Matrix | None:
    """The map of a `transform` attribute; None if it is none."""
    found, at = Matrix(), 0
    if len(text) > _LONGEST:
        return None
    while text[at:].strip():
        match = _FUNCTION.match(text, at)
        values = _values(match[2]) if match else None
        made = _made(match[1], values) if match and values is not None else None
        if not match or made is None:
            return None
        found, at = found.after(made), match.end()
    return found if all(map(math.isfinite, found)) else None


def _values(text: str) -> list[float] | None:
    """Arguments with the units of CSS, or None where one is none."""
    found, at = [], 0
    while text[at:].strip():
        match = _NUMBER.match(text, at)
        if match is None or match[2] not in _UNITS:
            return None
        found.append(float(match[1]) * _UNITS[match[2]])
        at = match.end()
    return found


def _made(name: str, numbers: list[float]) -> Matrix | None:
    match name, numbers:
        case "matrix", [a, b, c, d, e, f]:
            return Matrix(a, b, c, d, e, f)
        case "translate", [x, *rest] if len(rest) < 2:
            return Matrix(e=x, f=rest[0] if rest else 0.0)
        case ("translateX", [x]) | ("translateY", [x]):
            return Matrix(e=x) if name == "translateX" else Matrix(f=x)
        case ("scaleX", [x]) | ("scaleY", [x]):
            return Matrix(a=x) if name == "scaleX" else Matrix(d=x)
        case "scale", [x, *rest] if len(rest) < 2:
            return Matrix(a=x, d=rest[0] if rest else x)
        case "rotate", [angle]:
            cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            return Matrix(cosine, sine, -sine, cosine)
        case "rotate", [angle, x, y]:
            turn = _made("rotate", [angle])
            return turn and Matrix(e=x, f=y).after(turn).after(Matrix(e=-x, f=-y))
        case "skewX", [angle]:
            return Matrix(c=math.tan(math.radians(angle)))
        case "skewY", [angle]:
            return Matrix(b=math.tan(math.radians(angle)))
    return None


def fitted(box: tuple[float, float, float, float], size: Vec, way: str) -> Matrix:
    """The map of a `viewBox` (x, y, width, height) into an area of this size, as `preserveAspectRatio` says."""
    x, y, width, height = box
    across, down = size[0] / width, size[1] / height
    if not way.startswith("none"):
        across = down = max(across, down) if way.endswith("slice") else min(across, down)
    shares = [0.0 if f"{axis}Min" in way else 1.0 if f"{axis}Max" in way else 0.5 for axis in "xY"]
    left, top = shares[0] * (size[0] - across * width), shares[1] * (size[1] - down * height)
    return Matrix(across, 0.0, 0.0, down, left - across * x, top - down * y)

"""Affine maps, as SVG writes them.

Source: CSS Transforms 1, section 8 (the `transform` attribute), and SVG 2, section 8.2 (`viewBox`).
"""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from sandbox.formats.numbers import Vec

_FUNCTION = re.compile(r"\s*,?\s*(\w+)\s*\(([^()]*)\)")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")


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
    while text[at:].strip():
        match = _FUNCTION.match(text, at)
        made = match and _made(match[1], [float(number) for number in _NUMBER.findall(match[2])])
        if not match or made is None:
            return None
        found, at = found.after(made), match.end()
    return found if all(map(math.isfinite, found)) else None


def _made(name: str, numbers: list[float]) -> Matrix | None:
    match name, numbers:
        case "matrix", [a, b, c, d, e, f]:
            return Matrix(a, b, c, d, e, f)
        case "translate", [x, *rest] if len(rest) < 2:
            return Matrix(e=x, f=rest[0] if rest else 0.0)
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


def fitted(box: tuple[float, float, float, float], size: Vec, stretched: bool) -> Matrix:
    """The map of a `viewBox` (x, y, width, height) into an area of this size: amid it, or stretched to fill it."""
    x, y, width, height = box
    across, down = size[0] / width, size[1] / height
    if not stretched:
        across = down = min(across, down)
    left, top = (size[0] - across * width) / 2.0, (size[1] - down * height) / 2.0
    return Matrix(across, 0.0, 0.0, down, left - across * x, top - down * y)

"""Shapes that are placed in the world, about a point of their own."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sandbox.formats.numbers import Vec, tidy_point, tidy_points, turned
from sandbox.formats.outlines import Words

_LISTS = ("polygon", "chain", "segment")


def extent(shapes: Sequence[Words]) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of shapes, m; rounding that grows outwards is not counted."""
    points = [point for words in shapes for point in _reach(words)]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def moved(words: Words, origin: Vec) -> Words:
    """A shape seen from another origin."""

    def seen(points: Sequence[Sequence[float]]) -> list[list[float]]:
        return tidy_points((x - origin[0], y - origin[1]) for x, y in points)

    found = dict(words)
    for key in _LISTS:
        if key in found:
            found[key] = seen(found[key])
    if "holes" in found:
        found["holes"] = [seen(hole) for hole in found["holes"]]
    if "at" in found:
        found["at"] = tidy_point((found["at"][0] - origin[0], found["at"][1] - origin[1]))
        if found["at"] == [0.0, 0.0]:
            del found["at"]
    return found


def _reach(words: Words) -> Iterator[Vec]:
    for key in _LISTS:
        if key in words:
            yield from ((x, y) for x, y in words[key])
            return
    (x, y), angle = words["at"], math.radians(words.get("angle", 0.0))
    if "box" in words:
        width, height = words["box"]
    elif "circle" in words:
        width = height = 2.0 * words["circle"]
    else:
        (ax, ay), (bx, by) = words["capsule"]
        width, height = (abs(b - a) + 2.0 * words["radius"] for a, b in ((ax, bx), (ay, by)))
    for sx, sy in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
        dx, dy = turned((sx * width, sy * height), angle)
        yield x + dx, y + dy

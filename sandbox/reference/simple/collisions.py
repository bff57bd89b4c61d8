"""Which shapes touch, or may within the step: every pair whose boxes overlap is asked of the project's own geometry."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sandbox.geometry.pair import pair_of
from sandbox.reference.brute_force import overlapping_pairs
from sandbox.reference.simple.bodies import Body
from sandbox.reference.simple.contacts import Contact, Point
from sandbox.reference.simple.vectors import Vec, vec

MARGIN = 0.02
"""Contacts begin this far (m) before their shapes touch."""


class Placed(NamedTuple):
    """A rounded core where it lies in the world, as the geometry takes it; `moves` says whether it can be pushed."""

    vertices: tuple[Vec, ...]
    radius: float
    moves: bool = True

    def box(self, more: float = 0.0) -> tuple[float, float, float, float]:
        """Left, bottom, right and top, `more` m farther out."""
        xs, ys = [x for x, _ in self.vertices], [y for _, y in self.vertices]
        grow = self.radius + more
        return min(xs) - grow, min(ys) - grow, max(xs) + grow, max(ys) + grow


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """A convex core from the centre of its body, in the body's frame, and a radius (m); its surface and its filter."""

    body: Body
    core: tuple[complex, ...]
    radius: float
    friction: float
    restitution: float
    rolling_resistance: float
    surface_speed: float
    category: int
    mask: int
    group: int

    def placed(self) -> Placed:
        """Where its body has it now."""
        turn = self.body.rotation
        corners = [self.body.center + turn * corner for corner in self.core]
        return Placed(tuple(vec(corner) for corner in corners), self.radius, self.body.dynamic)

    def collides(self, other: Shape) -> bool:
        """Whether filters and bodies let two shapes collide."""
        a, b = self.body, other.body
        if a is b or a.inverse_mass + b.inverse_mass + a.inverse_inertia + b.inverse_inertia == 0.0:
            return False
        if self.group == other.group != 0:
            return self.group > 0
        return bool(self.category & other.mask and other.category & self.mask)


def find_contacts(shapes: list[Shape], seconds: float) -> dict[tuple[int, int], Contact]:
    """Contacts by the numbers of their shapes, in that order. What closes in within `seconds` counts as near."""
    placed = [shape.placed() for shape in shapes]
    reach = [0.5 * MARGIN + seconds * _fastest(shape) for shape in shapes]
    boxes = np.array([core.box(more) for core, more in zip(placed, reach, strict=True)]).reshape(-1, 4)
    found: dict[tuple[int, int], Contact] = {}
    for i, j in overlapping_pairs(boxes).tolist():
        if shapes[i].collides(shapes[j]):
            contact = _touch(shapes[i], placed[i], shapes[j], placed[j], reach[i] + reach[j])
            if contact is not None:
                found[i, j] = contact
    return found


def keep_impulses(contacts: dict[tuple[int, int], Contact], old: dict[tuple[int, int], Contact]) -> None:
    """Points of the step before pass their impulses on to the points between the same features."""
    for key, contact in contacts.items():
        if key in old:
            contact.rolling = old[key].rolling
            before = {point.feature: point for point in old[key].points}
            for point in contact.points:
                if point.feature in before:
                    point.normal, point.tangent = before[point.feature].normal, before[point.feature].tangent


def _touch(a: Shape, at_a: Placed, b: Shape, at_b: Placed, margin: float) -> Contact | None:
    pair = pair_of(at_a, at_b)
    # The kernel takes its margin as a share of the pair's size, which is at least half of the two boxes' together.
    row = pair.manifold(2.0 * margin / (_size(at_a) + _size(at_b)))[2]
    points = []
    for k in range(1, int(row.point_count) + 1):
        place = complex(*pair.in_world(float(row[f"x{k}"]), float(row[f"y{k}"])))
        gap, feature = float(row[f"separation{k}"]), int(row[f"feature{k}"])
        if gap <= margin:
            points.append(Point(place - a.body.center, place - b.body.center, gap, feature=feature))
    if not points:
        return None
    return Contact(
        a.body, b.body, complex(row.normal_x, row.normal_y), points, math.sqrt(a.friction * b.friction),
        max(a.restitution, b.restitution), a.surface_speed + b.surface_speed,
        max(a.rolling_resistance, b.rolling_resistance), radius_a=a.radius, radius_b=b.radius,
    )  # fmt: skip


def _fastest(shape: Shape) -> float:
    body = shape.body
    return abs(body.velocity) + abs(body.angular) * (max(abs(corner) for corner in shape.core) + shape.radius)


def _size(core: Placed) -> float:
    left, bottom, right, top = core.box()
    return max(right - left, top - bottom)

"""What must hold for every pair of shapes, judged by the exact referee."""

from __future__ import annotations

import math
from fractions import Fraction

from sandbox import Contact, Shape, collide, distance
from sandbox.geometry.pair import pair_of
from tests.naive.minkowski import Separation, separation

TOUCH = 1e-12
"""Share of a pair's size within which the kernels alone need not tell a touch from an overlap."""
RIGHT = 1e-9
"""Relative error allowed to a depth or a distance, however small it is."""


def judge(a: Shape, b: Shape) -> int:
    """Check everything that is said of a pair; returns 1 if it collides, -1 if it is apart, 0 if it touches."""
    truth = separation(a, b)
    contact = collide(a, b)
    assert (contact is not None) == (truth.sign < 0), "wrong verdict"
    judge_kernel(a, b, truth)
    if contact is None:
        judge_distance(a, b, truth)
    else:
        judge_contact(a, b, contact, truth)
        assert distance(a, b).value == 0.0
        assert distance(a, b).points is None
    return -truth.sign


def judge_kernel(a: Shape, b: Shape, truth: Separation) -> None:
    """The narrow phase by itself: verdict right outside the touch tolerance, and depth to the same."""
    found, _, _ = pair_of(a, b).manifold(0.0)
    size = size_of(a, b)
    assert found <= TOUCH * size or found == 1e300
    exact = float(truth.value)
    if exact < -TOUCH * size:
        assert abs(found - exact) < TOUCH * size, "the kernel's depth"
    if exact > TOUCH * size:
        sharp = a.radius + b.radius == 0.0 and len(a.vertices) + len(b.vertices) > 4
        # Beyond the tip of a sliver its faces separate by less than rounding: without a radius that may look a touch.
        assert found == 1e300 or (sharp and found >= -TOUCH * size), "the kernel sees a collision"


def judge_contact(a: Shape, b: Shape, contact: Contact, truth: Separation) -> None:
    """Depth, normal, mtv and points of a collision."""
    nx, ny = contact.normal
    assert contact.depth > 0.0
    assert abs(contact.depth + truth.value) <= RIGHT * abs(truth.value), "wrong depth"
    assert abs(math.hypot(nx, ny) - 1.0) < 1e-15
    assert contact.mtv == (contact.depth * nx, contact.depth * ny)
    assert separation(a, b, contact.mtv).sign >= 0, "mtv does not part them"
    judge_points(a, b, contact)
    after = collide(a, b.moved(contact.mtv))
    assert after is None or after.depth <= 8 * rounding(a, b), "mtv does not part the rounded shapes"
    other = collide(b, a)
    assert other is not None
    assert abs(other.depth - contact.depth) <= RIGHT * contact.depth


def judge_points(a: Shape, b: Shape, contact: Contact) -> None:
    """Every point lies within the overlap of the two intervals along the normal."""
    normal = Fraction(contact.normal[0]), Fraction(contact.normal[1])
    slack = 1e-12 * size_of(a, b) + 8 * rounding(a, b)

    def along(point: tuple[float, float]) -> Fraction:
        return Fraction(point[0]) * normal[0] + Fraction(point[1]) * normal[1]

    low = min(along(v) for v in b.vertices) - Fraction(b.radius) - Fraction(slack)
    high = max(along(v) for v in a.vertices) + Fraction(a.radius) + Fraction(slack)
    assert 1 <= len(contact.points) <= 2
    assert all(low <= along(point) <= high for point in contact.points), "a point outside the overlap"


def judge_distance(a: Shape, b: Shape, truth: Separation) -> None:
    """Distance and closest points of two shapes that are apart or touch."""
    found = distance(a, b)
    # Floats end at 5e-324: a smaller distance, of discs beside each other, can only be told as 0.
    assert abs(found.value - truth.value) <= RIGHT * abs(truth.value) + 5e-324, "wrong distance"
    assert found.points is not None
    (ax, ay), (bx, by) = found.points
    slack = 1e-12 * size_of(a, b) + 8 * rounding(a, b)
    assert abs(math.hypot(bx - ax, by - ay) - found.value) <= slack, "points that are not that far apart"
    for point, shape in zip(found.points, (a, b), strict=True):
        assert abs(separation(shape, Spot((point,))).value) <= slack, "a closest point off the outline"


def size_of(a: Shape, b: Shape) -> float:
    """Largest extent of a pair (m), wherever it lies."""
    sides = [[v[k] for v in (*a.vertices, *b.vertices)] for k in (0, 1)]
    return max(max(side) - min(side) for side in sides) + a.radius + b.radius


def rounding(a: Shape, b: Shape) -> float:
    """Half the spacing of floats at the farthest coordinate of a pair."""
    return math.ulp(max(abs(part) for v in (*a.vertices, *b.vertices) for part in v) + a.radius + b.radius)


class Spot:
    """A point as a core."""

    radius = 0.0

    def __init__(self, vertices: tuple[tuple[float, float], ...]) -> None:
        self.vertices = vertices

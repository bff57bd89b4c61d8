"""Pairs of shapes, each family made to hurt in its own way. One source for seeded runs and for Hypothesis.

A family takes a `random.Random` and gives two shapes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random

from hypothesis import strategies as st

from sandbox import Box, Capsule, Circle, Polygon, Segment, Shape, ShapeError, distance
from sandbox.geometry.collide import collide

Pair = tuple[Shape, Shape]


def around(rng: Random, at: tuple[float, float], way: float) -> tuple[float, float]:
    """A point up to `way` metres from `at` along each axis."""
    return at[0] + rng.uniform(-way, way), at[1] + rng.uniform(-way, way)


def direction(rng: Random) -> tuple[float, float]:
    """A unit vector, often along an axis."""
    turn = rng.choice([0.25 * math.pi * rng.randrange(8), rng.uniform(0.0, 2 * math.pi)])
    return math.cos(turn), math.sin(turn)


def polygon(rng: Random, at: tuple[float, float], size: float, flat: float = 1.0, radius: float = 0.0) -> Polygon:
    """Corners on an ellipse of half axes `size` and `size * flat`, turned, in either winding."""
    c, s = direction(rng)
    count = rng.choice([3, 3, 4, 5, 6, 8, rng.randint(3, 24)])
    while True:
        turns = sorted(rng.uniform(0.0, 2 * math.pi) for _ in range(count))
        ring = [(size * math.cos(t), size * flat * math.sin(t)) for t in turns]
        vertices = [(at[0] + c * x - s * y, at[1] + s * x + c * y) for x, y in ring]
        try:
            return Polygon(vertices[:: rng.choice([1, -1])], radius)
        except ShapeError:
            count = max(3, count - 1)
            size, flat = size * 1.1, min(1.0, flat * 1.1)


def shape(rng: Random, at: tuple[float, float], size: float, flat: float = 1.0) -> Shape:
    """Any kind of shape about `at`, about `size` metres wide; `flat` is how thin it may be."""
    x, y = direction(rng)
    p, q = (at[0] - size * x, at[1] - size * y), (at[0] + size * x, at[1] + size * y)
    thin = max(1e-6, size * flat)
    radius = rng.choice([size, thin, max(1e-6, thin * rng.random())])
    kind = rng.randrange(6)
    if kind == 0:
        return Circle(at, radius)
    if kind == 1:
        return Capsule(p, q, radius)
    if kind == 2:
        return Segment(p, q)
    if kind == 3:
        return Box(size * rng.uniform(0.5, 2.0), thin, at, rng.choice([0.0, rng.uniform(-4.0, 4.0)]))
    return polygon(rng, at, size, flat, 0.0 if kind == 4 else radius)


def scale(rng: Random) -> float:
    """A size between millimetres and kilometres, mostly a metre."""
    return rng.choice([1.0, 10.0 ** rng.uniform(-3.0, 4.0)])


def general(rng: Random) -> Pair:
    """Anything near anything."""
    size, place = scale(rng), around(rng, (0.0, 0.0), 10.0)
    return shape(rng, place, size), shape(rng, around(rng, place, 2.0 * size), size * rng.uniform(0.2, 2.0))


def brought_near(rng: Random, a: Shape, b: Shape) -> Pair:
    """The pair with b moved until the two touch, give or take a share of 0 to 1e-5 of their size."""
    off = rng.choice([0.0, 10.0 ** rng.uniform(-18.0, -5.0)]) * rng.choice([1.0, -1.0])
    contact = collide(a, b)
    if contact:
        return a, b.moved([(1.0 + off) * part for part in contact.mtv])
    points = distance(a, b).points
    assert points is not None
    (ax, ay), (bx, by) = points
    return a, b.moved(((ax - bx) * (1.0 + off), (ay - by) * (1.0 + off)))


def near_touching(rng: Random) -> Pair:
    """Two shapes that all but touch, or do."""
    return brought_near(rng, *general(rng))


def containing(rng: Random) -> Pair:
    """A small shape in or across the outline of a large one, in either order."""
    size, place = scale(rng), around(rng, (0.0, 0.0), 10.0)
    big = shape(rng, place, size)
    small = shape(rng, around(rng, place, 0.7 * size), max(1e-5, size * 10.0 ** rng.uniform(-3.0, -0.5)))
    return (big, small) if rng.random() < 0.5 else (small, big)


def identical(rng: Random) -> Pair:
    """A shape and itself, or itself moved by next to nothing."""
    a = shape(rng, around(rng, (0.0, 0.0), 10.0), scale(rng))
    step = rng.choice([0.0, 0.0, 10.0 ** rng.uniform(-20.0, -6.0)])
    return a, a.moved(around(rng, (0.0, 0.0), step)) if step else a


def sharing_edges(rng: Random) -> Pair:
    """A polygon and another one on the outside, or the inside, of one of its edges: they share two vertices."""
    a = polygon(rng, around(rng, (0.0, 0.0), 10.0), scale(rng))
    i = rng.randrange(len(a.vertices))
    (px, py), (qx, qy) = a.vertices[i], a.vertices[(i + 1) % len(a.vertices)]
    side, along = rng.choice([1.0, 1.0, -0.5]), rng.choice([0.5, rng.uniform(-1.0, 2.0)])
    height = side * rng.uniform(0.1, 2.0)
    apex = px + along * (qx - px) + height * (qy - py), py + along * (qy - py) - height * (qx - px)
    try:
        return a, Polygon([(px, py), (qx, qy), apex])
    except ShapeError:
        return a, a


def slivers(rng: Random) -> Pair:
    """Long thin things, crossing, in line, or all but touching."""
    size, place = 10.0 ** rng.uniform(-1.0, 6.5), around(rng, (0.0, 0.0), 10.0)
    flat = max(10.0 ** rng.uniform(-9.0, -3.0), 3e-6 / size)
    a = shape(rng, place, size, flat)
    b = shape(rng, around(rng, place, size * rng.choice([1.0, flat])), size * rng.uniform(0.1, 2.0), flat)
    return brought_near(rng, a, b) if rng.random() < 0.5 else (a, b)


def in_line(rng: Random) -> Pair:
    """Thin things one behind the other on a line: no face separates them by more than rounding."""
    (c, s), size, place = direction(rng), 10.0 ** rng.uniform(-1.0, 5.0), around(rng, (0.0, 0.0), 10.0)
    gap = size * rng.choice([0.0, 10.0 ** rng.uniform(-12.0, 0.0)])

    def thin(start: float, end: float) -> Shape:
        p, q = ((place[0] + t * c, place[1] + t * s) for t in (start, end))
        radius = max(1e-6, gap * rng.uniform(0.1, 1.0))
        kind, width = rng.randrange(4), 4e-6
        if kind == 0:
            return Circle(rng.choice([p, q]), radius)
        if kind == 1:
            return Segment(p, q)
        if kind == 2:
            return Polygon([p, q, (p[0] - width * s, p[1] + width * c)], rng.choice([0.0, radius]))
        return Capsule(p, q, radius)

    return thin(0.0, size), thin(size + gap, (size + gap) * rng.uniform(1.5, 3.0))


def far_from_origin(rng: Random) -> Pair:
    """A pair of another family, 1e4 to 1e7 m away; still a thousand roundings wide."""
    c, s = direction(rng)
    way = 10.0 ** rng.uniform(4.0, 7.0)
    at = way * c, way * s
    size = rng.choice([1.0, 10.0 ** rng.uniform(-4.0, 3.0)])
    a, b = shape(rng, at, size), shape(rng, around(rng, at, 2.0 * size), size)
    return brought_near(rng, a, b) if rng.random() < 0.5 else (a, b)


def rounded(rng: Random) -> Pair:
    """Rounded shapes whose cores touch, overlap or are apart, at every ratio of radius to size."""
    size, place = scale(rng), around(rng, (0.0, 0.0), 10.0)
    radius = max(1e-6, size * 10.0 ** rng.uniform(-6.0, 1.0))
    a = polygon(rng, place, size, 1.0, radius)
    b = shape(rng, around(rng, place, 2.0 * size + radius), size)
    return brought_near(rng, a, b) if rng.random() < 0.5 else (a, b)


def on_a_grid(rng: Random) -> Pair:
    """Small whole numbers: corners on corners, faces on faces, equal depths, exact touches."""

    def point() -> tuple[float, float]:
        return float(rng.randint(-3, 3)), float(rng.randint(-3, 3))

    def one() -> Shape:
        while True:
            kind, radius = rng.randrange(5), rng.choice([0.5, 1.0, 2.0])
            try:
                if kind == 0:
                    return Circle(point(), radius)
                if kind == 1:
                    return Capsule(point(), point(), radius)
                if kind == 2:
                    return Segment(point(), point())
                if kind == 3:
                    return Box(rng.randint(1, 4), rng.randint(1, 4), point())
                return Polygon([point() for _ in range(rng.randint(3, 5))], rng.choice([0.0, 0.0, radius]))
            except ShapeError:
                continue

    return one(), one()


FAMILIES: dict[str, Callable[[Random], Pair]] = {
    family.__name__: family
    for family in (
        general, near_touching, containing, identical, sharing_edges, slivers, in_line, far_from_origin, rounded,
        on_a_grid,
    )
}  # fmt: skip

randoms = st.randoms(use_true_random=False)
pairs = st.sampled_from(sorted(FAMILIES)).flatmap(lambda name: st.builds(FAMILIES[name], randoms))
"""A pair of any family, that Hypothesis searches and shrinks."""

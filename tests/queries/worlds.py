"""Worlds for queries: shapes of all kinds, in odd places, and ways through them that meet edges and corners."""

from __future__ import annotations

import math

from hypothesis import strategies as st

from sandbox.engine.world import World
from tests.flat import body, box, capsule, circle, polygon, segment, world

halves = st.integers(-12, 12).map(lambda k: 0.5 * k)
places = st.tuples(halves, halves) | st.tuples(st.floats(-8.0, 8.0), st.floats(-8.0, 8.0))
angles = st.sampled_from([0.0, 0.0, math.pi / 2, math.pi / 4, 0.3]) | st.floats(-4.0, 4.0)
sizes = st.sampled_from([0.5, 1.0, 2.0]) | st.floats(0.05, 3.0)
far = st.sampled_from([(0.0, 0.0), (0.0, 0.0), (1e4, -3e4), (1e7, 1e7), (-1e7, 0.25)])


@st.composite
def regular(draw: st.DrawFn):
    """A regular polygon, perhaps rounded."""
    count, size = draw(st.integers(3, 8)), draw(sizes)
    corners = [
        (size * math.cos(2 * math.pi * k / count), size * math.sin(2 * math.pi * k / count)) for k in range(count)
    ]
    shape = polygon(*corners)
    return shape if draw(st.booleans()) else rounded(shape, draw(sizes))


def rounded(shape, radius: float):
    """The same core with a radius."""
    return type(shape)(shape.kind, shape.vertices, 0.25 * radius)


shapes = (
    st.builds(circle, sizes)
    | st.builds(box, sizes, sizes)
    | st.builds(capsule, sizes, sizes)
    | st.builds(lambda half: segment((-half, 0.0), (half, 0.5 * half)), sizes)
    | regular()
)


@st.composite
def bodies(draw: st.DrawFn, at: tuple[float, float], number: int):
    """A body of one or two shapes near a place."""
    x, y = draw(places)
    parts = draw(st.lists(shapes, min_size=1, max_size=2))
    kind = draw(st.sampled_from(["dynamic", "dynamic", "static", "kinematic"]))
    return body(f"b{number}", *parts, type=kind, position=(x + at[0], y + at[1]), angle=draw(angles))


@st.composite
def worlds(draw: st.DrawFn, most: int = 12) -> tuple[World, tuple[float, float]]:
    """A small world, and the place around which it lies."""
    at = draw(far)
    count = draw(st.integers(0, most))
    return world(*(draw(bodies(at, k)) for k in range(count))), at


def corners(of: World) -> list[tuple[float, float]]:
    """The corners of a world's shapes as floats, and the centres of its bodies."""
    found = [(float(b.center_x), float(b.center_y)) for b in of.state.bodies]
    for shape in of.state.shapes:
        b = of.state.bodies[int(shape.body)]
        for v in of.state.vertices[int(shape.vertex_start) : int(shape.vertex_start + shape.vertex_count)]:
            x = b.center_x + (b.rotation_cos * v.x - b.rotation_sin * v.y)
            y = b.center_y + (b.rotation_sin * v.x + b.rotation_cos * v.y)
            found.append((float(x), float(y)))
    return found


@st.composite
def spots(draw: st.DrawFn, of: World, at: tuple[float, float]) -> tuple[float, float]:
    """A point near a world, often a corner of it."""
    known = corners(of)
    if known and draw(st.booleans()):
        return draw(st.sampled_from(known))
    x, y = draw(places)
    return x + at[0], y + at[1]


@st.composite
def ways(draw: st.DrawFn, of: World, at: tuple[float, float]):
    """(origin, translation): between any spots, along edges, past them, very long, of no length."""
    start, goal = draw(spots(of, at)), draw(spots(of, at))
    way = goal[0] - start[0], goal[1] - start[1]
    kind = draw(st.sampled_from(["to", "past", "through", "long", "level", "plumb"]))
    if kind == "past":
        way = 2.0 * way[0], 2.0 * way[1]
    if kind == "through":
        start = start[0] - way[0], start[1] - way[1]
        way = 3.0 * way[0], 3.0 * way[1]
    if kind == "long":
        start, way = (start[0] - 1e5 * way[0], start[1] - 1e5 * way[1]), (2e5 * way[0], 2e5 * way[1])
    if kind in ("level", "plumb"):
        way = (20.0, 0.0) if kind == "level" else (0.0, -20.0)
        start = start[0] - draw(st.sampled_from([0.0, 0.5])) * way[0], start[1] - 0.5 * way[1]
    return start, way

"""Points, overlaps, casts and distances against exact rationals."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

import sandbox
from tests.examples import examples
from tests.naive.queries import Solid, gap, solids, swept, unit
from tests.queries.worlds import angles, places, sizes, spots, ways, worlds

TOLERANCE = 40.0
"""In units of rounding."""


@st.composite
def query_shapes(draw: st.DrawFn, at: tuple[float, float]) -> sandbox.Shape:
    """A shape to ask about, near a world."""
    x, y = draw(places)
    place = x + at[0], y + at[1]
    kind = draw(st.sampled_from(["circle", "box", "box", "capsule", "segment", "polygon"]))
    size = draw(sizes)
    end = place[0] + size, place[1] + draw(st.sampled_from([0.0, 0.5, -1.0]))
    if kind == "circle":
        return sandbox.Circle(place, size)
    if kind == "box":
        return sandbox.Box(size, draw(sizes), place, draw(angles))
    if kind == "capsule":
        return sandbox.Capsule(place, end, 0.25 * draw(sizes))
    if kind == "segment":
        return sandbox.Segment(place, end)
    corners = [place, end, (place[0] + 0.25 * size, place[1] + 2.0 * size)]
    return sandbox.Polygon(corners, draw(st.sampled_from([0.0, 0.25])))


def middle(shape: sandbox.Shape) -> tuple[float, float]:
    """Where a shape is."""
    return shape.vertices[0]


def size_of(shape: sandbox.Shape) -> float:
    """An upper bound of how far a shape reaches from `middle`."""
    x, y = shape.vertices[0]
    return max(abs(u - x) + abs(v - y) for u, v in shape.vertices) + shape.radius


def check_normal(solid: Solid, normal, point, tolerance: float) -> None:
    """A unit normal, with all of the shape behind it, but no farther."""
    assert abs(math.hypot(*normal) - 1.0) < 1e-9
    assert abs(solid.behind(normal, point)) <= tolerance


@given(st.data())
@examples(300)
def test_which_shapes_hold_a_point(data):
    world, at = data.draw(worlds())
    point = data.draw(spots(world, at))
    hits = world.query.point(point)
    assert [hit.shape for hit in hits] == sorted({hit.shape for hit in hits})
    found = {hit.shape: hit for hit in hits}
    for solid in solids(world.state):
        apart = gap(swept([point], (0.0, 0.0)), 0.0, solid.core, solid.radius)
        assert apart > 0.0 or solid.index in found, "missed"
        if solid.index in found:
            hit = found[solid.index]
            tolerance = TOLERANCE * unit(solid, point)
            assert abs(hit.distance - apart) <= tolerance
            check_normal(solid, hit.normal, hit.point, tolerance + 2.0**-50 * (abs(point[0]) + abs(point[1])))


@given(st.data(), st.just(math.inf) | st.floats(0.0, 5.0))
@examples(300)
def test_the_nearest_shape(data, within):
    world, at = data.draw(worlds())
    point = data.draw(spots(world, at))
    hit = world.query.nearest(point, within)
    ranked = [(gap(swept([point], (0.0, 0.0)), 0.0, s.core, s.radius), s) for s in solids(world.state)]
    if not ranked:
        assert hit is None
        return
    least, first = min(ranked, key=lambda row: row[0])
    tolerance = TOLERANCE * unit(first, point)
    if hit is None:
        assert least > within - tolerance
        return
    solid = next(s for _, s in ranked if s.index == hit.shape)
    tolerance += TOLERANCE * unit(solid, point)
    assert abs(hit.distance - least) <= tolerance
    assert hit.distance <= within
    check_normal(solid, hit.normal, hit.point, tolerance + 2.0**-50 * (abs(point[0]) + abs(point[1])))


def check_overlaps(world, shape, hits) -> None:
    """Exactly the shapes that touch are found, and the way out is the least one."""
    assert [hit.shape for hit in hits] == sorted({hit.shape for hit in hits})
    found = {hit.shape: hit for hit in hits}
    core, size = swept(shape.vertices, (0.0, 0.0)), size_of(shape)
    for solid in solids(world.state):
        apart = gap(core, shape.radius, solid.core, solid.radius)
        assert apart > 0.0 or solid.index in found, "missed"
        if solid.index in found:
            hit = found[solid.index]
            tolerance = TOLERANCE * unit(solid, middle(shape), size=size)
            assert abs(hit.depth + apart) <= tolerance
            away = (hit.depth * hit.normal[0], hit.depth * hit.normal[1])
            moved = [(u + away[0], v + away[1]) for u, v in shape.vertices]
            far = 2.0**-50 * sum(abs(value) for value in middle(shape))
            assert abs(gap(swept(moved, (0.0, 0.0)), shape.radius, solid.core, solid.radius)) <= tolerance + far
            check_normal(solid, hit.normal, hit.point, tolerance + far + 1e-9 * (solid.extent + size))


@given(st.data())
@examples(200)
def test_which_shapes_a_shape_overlaps(data):
    world, at = data.draw(worlds(8))
    shape = data.draw(query_shapes(at))
    check_overlaps(world, shape, world.query.overlap_shape(shape))


@given(st.data())
@examples(150)
def test_which_shapes_a_box_overlaps(data):
    world, at = data.draw(worlds(8))
    p, q = data.draw(spots(world, at)), data.draw(spots(world, at))
    lower, upper = (min(p[0], q[0]), min(p[1], q[1])), (max(p[0], q[0]), max(p[1], q[1]))
    hits = world.query.overlap_box(lower, upper)
    corners = swept([lower, (upper[0], lower[1]), upper, (lower[0], upper[1])], (0.0, 0.0))
    found = {hit.shape: hit for hit in hits}
    for solid in solids(world.state):
        apart = gap(corners, 0.0, solid.core, solid.radius)
        tolerance = TOLERANCE * unit(solid, lower, size=upper[0] - lower[0] + upper[1] - lower[1])
        assert apart > 0.0 or solid.index in found, "missed"
        assert solid.index not in found or abs(found[solid.index].depth + apart) <= tolerance


@given(st.data())
@examples(200)
def test_shape_casts(data):
    world, at = data.draw(worlds(8))
    shape = data.draw(query_shapes(at))
    _origin, way = data.draw(ways(world, at))
    hits = world.query.cast_all(shape, way)
    assert world.query.cast(shape, way) == (hits[0] if hits else None)
    assert list(hits) == sorted(hits, key=lambda hit: (hit.fraction, hit.shape))
    found = {hit.shape: hit for hit in hits}
    path, size = swept(shape.vertices, way), size_of(shape)
    for solid in solids(world.state):
        apart = gap(path, shape.radius, solid.core, solid.radius)
        tolerance = TOLERANCE * unit(solid, middle(shape), way, size)
        assert apart > 0.0 or solid.index in found, "missed"
        if solid.index in found:
            assert apart <= tolerance, "invented"
            check_cast(found[solid.index], shape, way, solid, tolerance, size)


def check_cast(hit, shape, way, solid: Solid, tolerance: float, size: float) -> None:
    """Up to the hit the shapes just touch, there, and all of the other lies behind the normal."""
    far = 2.0**-48 * (sum(abs(value) for value in (*middle(shape), *way)) + size)
    if hit.normal == (0.0, 0.0):
        assert hit.fraction == 0.0
        assert gap(swept(shape.vertices, (0.0, 0.0)), shape.radius, solid.core, solid.radius) <= 0.0
        return
    before = swept(shape.vertices, way, hit.fraction)
    assert abs(gap(before, shape.radius, solid.core, solid.radius)) <= tolerance
    spot = swept([hit.point], (0.0, 0.0))
    inexact = 4.0 * tolerance + far + 1e-9 * (solid.extent + size)
    assert abs(gap(spot, 0.0, solid.core, solid.radius)) <= inexact
    there = [(u + hit.fraction * way[0], v + hit.fraction * way[1]) for u, v in shape.vertices]
    assert abs(gap(spot, 0.0, swept(there, (0.0, 0.0)), shape.radius)) <= inexact
    check_normal(solid, hit.normal, hit.point, inexact)


@given(st.data())
@examples(300)
def test_the_distance_of_two_bodies(data):
    world, _at = data.draw(worlds())
    if len(world.names) < 2:
        return
    a, b = data.draw(st.permutations(range(len(world.names))))[:2]
    answer = world.query.distance(world.names[a], world.names[b])
    parts = solids(world.state)
    pairs = [
        (gap(s.core, s.radius, t.core, t.radius), s, t) for s in parts for t in parts if (s.body, t.body) == (a, b)
    ]
    least = min(row[0] for row in pairs)
    s, t = next((s, t) for _, s, t in pairs if (s.index, t.index) == (answer.shape_a, answer.shape_b))
    tolerance = TOLERANCE * unit(t, s.center, size=s.extent)
    assert abs(answer.distance - least) <= tolerance
    far = 2.0**-50 * sum(abs(value) for value in (*s.center, *t.center)) + 1e-9 * (s.extent + t.extent)
    normal = answer.normal
    check_normal(s, normal, answer.point_a, tolerance + far)
    check_normal(t, (-normal[0], -normal[1]), answer.point_b, tolerance + far)
    if answer.distance > 0.0:
        for solid, point in ((s, answer.point_a), (t, answer.point_b)):
            assert abs(gap(swept([point], (0.0, 0.0)), 0.0, solid.core, solid.radius)) <= tolerance + far


def test_equal_shapes_far_away_give_the_same_answer_as_at_the_origin():
    """Lengths are measured from the bodies' centres: only the point itself is rounded by the distance."""
    from tests.flat import body, box, world

    for far in (0.0, 2.0**23, -(2.0**23)):
        there = world(
            body("a", box(1.0, 1.0), position=(far, far)), body("b", box(1.0, 1.0), position=(far + 3.0, far))
        )
        assert there.query.distance("a", "b").distance == 2.0
        hit = there.query.cast(sandbox.Box(1.0, 1.0, (far - 4.0, far + 0.25)), (8.0, 0.0))
        assert hit is not None
        assert (hit.fraction, hit.normal, hit.point) == (0.375, (-1.0, 0.0), (far - 0.5, far + 0.125))

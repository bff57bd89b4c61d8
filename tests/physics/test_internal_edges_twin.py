"""Contacts with what is made of parts against a naive twin that knows the whole alone."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from hypothesis import assume, given
from hypothesis import strategies as st

import sandbox
from tests.examples import examples
from tests.naive.outline import (
    TURN,
    Vec,
    along,
    corners,
    distance,
    height,
    holds,
    leads_out,
    opening,
    outward,
    sides,
    ways_out,
)

SLANT = 2e-3
"""How far off (rad) a normal may be: twice what the engine allows itself."""
FLAT = 0.03
"""A face whose gap is as large but for 0.1 mm is taken for a corner: next to a disc, so many radians away from it."""
NEAR = 0.02
"""Bodies look so far ahead (m), and a side that ends in a dent is taken to go on for as much."""
RADIUS = 0.25
ROUND = {"circle": RADIUS}
SHARP: dict[str, tuple[dict[str, Any], list[Vec], float]] = {
    "box": ({"box": [0.5, 0.5]}, [(-0.25, -0.25), (0.25, -0.25), (0.25, 0.25), (-0.25, 0.25)], 0.0),
    "plank": ({"box": [2.0, 0.3]}, [(-1.0, -0.15), (1.0, -0.15), (1.0, 0.15), (-1.0, 0.15)], 0.0),
    "triangle": ({"polygon": [[-0.4, -0.2], [0.4, -0.3], [0, 0.5]]}, [(-0.4, -0.2), (0.4, -0.3), (0.0, 0.5)], 0.0),
    "capsule": ({"capsule": [[-0.3, 0], [0.3, 0]], "radius": 0.2}, [(-0.3, 0.0), (0.3, 0.0)], 0.2),
}
"""Shapes, their cores and how these are rounded."""


@dataclass(frozen=True)
class Whole:
    """Shapes of a static body, the rings that they are together, and where parts meet within a side."""

    shapes: tuple[dict[str, Any], ...]
    rings: tuple[tuple[Vec, ...], ...]
    joints: tuple[Vec, ...] = ()


@st.composite
def stars(draw: st.DrawFn) -> Whole:
    """Concave polygons around the origin."""
    count = draw(st.integers(5, 9))
    turn = draw(st.floats(0.0, 1.0))
    reaches = draw(st.lists(st.floats(0.8, 3.0), min_size=count, max_size=count))
    ring = tuple(
        (reach * math.cos(2 * math.pi * (k + turn) / count), reach * math.sin(2 * math.pi * (k + turn) / count))
        for k, reach in enumerate(reaches)
    )
    return Whole(({"polygon": list(ring)},), (ring,))


@st.composite
def grounds(draw: st.DrawFn) -> Whole:
    """Ground with a top that goes up and down: polygon, or chain."""
    steps = draw(st.lists(st.tuples(st.floats(0.4, 1.5), st.floats(-0.6, 0.6)), min_size=4, max_size=8))
    flat = draw(st.sampled_from([1.0, 1e-3]))
    top, x = [], -3.0
    for step, rise in steps:
        top.append((x, flat * rise))
        x += step
    if draw(st.booleans()):
        return Whole(({"chain": top},), ((*top[::-1], *top[1:-1]),))
    ring = ((top[0][0], -2.0), (top[-1][0], -2.0), *top[::-1])
    return Whole(({"polygon": list(ring)},), (ring,))


@st.composite
def floors(draw: st.DrawFn) -> Whole:
    """Tiles of 1 m side by side, each column with a height of its own and made of two boxes."""
    heights = draw(st.lists(st.sampled_from([0.0, 0.0, 0.5, 1.0]), min_size=3, max_size=6))
    shapes: list[dict[str, Any]] = []
    top: list[Vec] = []
    for k, high in enumerate(heights):
        shapes.append({"box": [1, 1], "at": [k + 0.5, high - 0.5]})
        shapes.append({"box": [1, 2], "at": [k + 0.5, high - 2.0]})
        if k == 0 or heights[k - 1] != high:
            top += [(float(k), heights[k - 1])] * (k > 0) + [(float(k), high)]
    end = float(len(heights))
    top.append((end, heights[-1]))
    # The soles are steps, too, but nothing comes there.
    ring = ((0.0, -9.0), (end, -9.0), *top[::-1])
    flush = [(float(k), heights[k]) for k in range(1, len(heights)) if heights[k - 1] == heights[k]]
    return Whole(tuple(shapes), (ring,), tuple(flush))


wholes = st.one_of(stars(), grounds(), floors())


def place(draw: Any, whole: Whole) -> tuple[Vec, Vec]:
    """A point of the whole where parts may meet, or next to it, and the normal of a side there."""
    spots = [(point, side) for side in sides(whole.rings) for point in (*side, *whole.joints) if _is_on(point, side)]
    spots = [(point, side) for point, side in spots if min(side[0][1], side[1][1]) > -1.9]
    if whole.joints and draw(st.booleans()):
        spots = [spot for spot in spots if spot[0] in whole.joints]
    point, (start, end) = draw(st.sampled_from(spots))
    normal, slide = outward(start, end), draw(st.just(0.0) | st.floats(-0.01, 0.01) | st.floats(-0.2, 0.2))
    return (point[0] - slide * normal[1], point[1] + slide * normal[0]), normal


def _is_on(point: Vec, side: tuple[Vec, Vec]) -> bool:
    along_it = -1e-9 <= along(point, *side) <= math.dist(*side) + 1e-9
    return along_it and abs(height(point, *side)) <= 1e-9


def contacts(whole: Whole, shape: dict[str, Any], at: Vec, angle: float = 0.0, velocity: Vec = (0.0, 0.0)) -> list[Any]:
    """(normal away from the whole, points in the world, least gap) of every contact of a body there."""
    scene = sandbox.Scene(
        bodies=[
            {"id": "whole", "type": "static", "shapes": list(whole.shapes)},
            {"id": "body", "shapes": [shape], "position": at, "angle": math.degrees(angle), "velocity": velocity},
        ],
        gravity=(0, 0),
        settings={"sleeping": False},
    )
    world = sandbox.World(scene)
    x, y = (float(value) for value in world.state.bodies[0][["center_x", "center_y"]])
    world.step()
    found = []
    for row in world.contacts:
        assert int(row.body_a) == 0
        points = [(x + float(row[f"anchor_ax{k}"]), y + float(row[f"anchor_ay{k}"])) for k in (1, 2)]
        count = int(row.point_count)
        gap = min(float(row[f"separation{k}"]) for k in range(1, count + 1))
        found.append(((float(row.normal_x), float(row.normal_y)), points[:count], gap))
    return found


def differ(first: Vec, second: Vec) -> float:
    """Distance of two unit vectors."""
    return math.dist(first, second)


@given(wholes, st.data())
@examples(150)
def test_a_disc_is_pushed_along_its_shortest_ways_out_and_no_others(whole, data):
    """They are the ways to the nearest points of the whole around; all that it overlaps have a contact."""
    point, normal = place(data.draw, whole)
    far, lean = RADIUS - data.draw(st.floats(-0.01, 0.01)), data.draw(st.just(0.0) | st.floats(-0.8, 0.8))
    c, s = math.cos(lean), math.sin(lean)
    center = point[0] + far * (c * normal[0] - s * normal[1]), point[1] + far * (s * normal[0] + c * normal[1])
    assume(not holds(whole.rings, center) and distance(whole.rings, center) > RADIUS - 0.015)
    ways = ways_out(whole.rings, center, RADIUS + NEAR)
    speed = data.draw(st.sampled_from([0.0, 0.0, 0.9, -0.9]))
    found = contacts(whole, ROUND, center, velocity=(-speed * normal[1], speed * normal[0]))
    for axis, points, _gap in found:
        near = any(differ(axis, way.normal) <= SLANT for way in ways)
        assert near or leads_out(whole.rings, axis, points[0], NEAR, SLANT), (axis, ways)
    for way in ways:
        if way.distance < RADIUS - 1e-3 and speed != 0.0:
            assert found  # what slides over a corner may be pushed by a side of it
        elif way.distance < RADIUS - 1e-3:
            assert any(differ(axis, way.normal) <= FLAT for axis, _points, _gap in found), (way, found)


@given(wholes, st.data())
@examples(150)
def test_a_disc_at_a_corner_is_pushed_straight_away_from_it(whole, data):
    """In any direction between the normals of its sides; whether it is at rest or comes right at it."""
    sharp = [each for each in corners(whole.rings) if each[1][1] > -1.9 and 0.05 < opening(*each) < math.pi - 0.05]
    assume(sharp)
    before, corner, after = data.draw(st.sampled_from(sharp))
    angle = data.draw(st.floats(0.1, 0.9)) * opening(before, corner, after)
    c, s = math.cos(angle), math.sin(angle)
    x, y = outward(before, corner)
    normal, far = (c * x - s * y, s * x + c * y), RADIUS - data.draw(st.floats(0.002, 0.01))
    center = corner[0] + far * normal[0], corner[1] + far * normal[1]
    assume(not holds(whole.rings, center) and distance(whole.rings, center) > RADIUS - 0.015)
    speed = data.draw(st.sampled_from([0.0, 0.9]))
    found = contacts(whole, ROUND, center, velocity=(-speed * normal[0], -speed * normal[1]))
    assert any(differ(axis, normal) <= FLAT for axis, _points, _gap in found), (normal, found)


def test_a_disc_just_past_a_side_is_pushed_by_its_corner() -> None:
    """The side of this star is upright; the disc overlaps its upper end by 8 mm, 7e-5 m less than the side's line."""
    ring = tuple((math.cos(k * TURN / 9), math.sin(k * TURN / 9)) for k in range(9))
    ring = (*ring[:2], (0.35, 1.97), (-0.75, 1.3), *ring[4:])
    normal = math.cos(math.pi - 0.0245), math.sin(math.pi - 0.0245)
    center = tuple(place + (RADIUS - 0.008) * way for place, way in zip(ring[4], normal, strict=True))
    assert contacts(Whole(({"polygon": list(ring)},), (ring,)), ROUND, center)


@given(wholes, st.sampled_from(list(SHARP)), st.data())
@examples(150)
def test_every_normal_leads_out_of_the_whole_where_it_touches(whole, shape, data):
    """Of bodies that hardly overlap it; at rest, and sliding along."""
    point, normal = place(data.draw, whole)
    angle = math.atan2(normal[1], normal[0]) - 0.5 * math.pi + data.draw(st.just(0.0) | st.floats(-math.pi, math.pi))
    outline, core, radius = SHARP[shape]
    c, s = math.cos(angle), math.sin(angle)
    turned = [(c * x - s * y, s * x + c * y) for x, y in core]
    lowest = min(turned, key=lambda v: normal[0] * v[0] + normal[1] * v[1] + data.draw(st.sampled_from([0.0, 1e-9])))
    far = radius - data.draw(st.floats(-0.005, 0.006))
    center = point[0] + far * normal[0] - lowest[0], point[1] + far * normal[1] - lowest[1]
    speed = data.draw(st.sampled_from([0.0, 0.0, 1.0, -3.0]))
    found = contacts(whole, outline, center, angle, (-speed * normal[1], speed * normal[0]))
    assume(found and all(gap > -0.015 for _axis, _points, gap in found))
    for axis, points, gap in found:
        reach = NEAR + abs(gap) + abs(speed) / 60.0
        assert any(leads_out(whole.rings, axis, at, reach, SLANT) for at in points), (axis, points)

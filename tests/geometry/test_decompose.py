"""Concave polygons in convex parts: shapely judges what they cover, pymunk and the least number how many they are."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pymunk.autogeometry import convex_decomposition

from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import MIN_EDGE, convex_corners
from tests.examples import examples
from tests.geometry.concave_cases import simple, with_holes
from tests.naive.partition import least_parts

SLOW = settings(suppress_health_check=list(HealthCheck))
FEW = examples(40, suppress_health_check=list(HealthCheck))
L_SHAPE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
FRAME = [(0, 0), (4, 0), (4, 4), (0, 4)]
WINDOW = [(1, 1), (3, 1), (3, 3), (1, 3)]


def gear(teeth: int) -> list[tuple[float, float]]:
    places = ((0, 0.8), (0.2, 1), (0.5, 1), (0.7, 0.8))
    turns = [(2 * math.pi * (k + part) / teeth, r) for k in range(teeth) for part, r in places]
    return [(r * math.cos(t), r * math.sin(t)) for t, r in turns]


def pairs(ring):
    return list(zip(ring, [*ring[1:], ring[0]], strict=True))


def area(ring) -> float:
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs(ring)) / 2


def dents(rings) -> int:
    """Corners at which the polygon is wider than a half-plane."""
    found = 0
    for ring in rings:
        for k in range(len(ring)):
            (ax, ay), (bx, by), (cx, cy) = ring[k - 2], ring[k - 1], ring[k]
            found += (bx - ax) * (cy - by) - (by - ay) * (cx - bx) < 0
    return found


@SLOW
@given(with_holes())
def test_the_parts_cover_the_polygon_once(polygon):
    outline, holes = polygon
    whole = shapely.Polygon(outline, holes)
    parts = [shapely.Polygon(part.vertices) for part in decompose(outline, holes).parts]
    union = shapely.union_all(parts)
    assert union.symmetric_difference(whole).area <= 1e-9 * whole.length**2
    assert sum(part.area for part in parts) == pytest.approx(whole.area, rel=1e-9)


@SLOW
@given(with_holes())
def test_every_part_is_a_clean_convex_polygon(polygon):
    corners = {vertex for ring in (polygon[0], *polygon[1]) for vertex in ring}
    for part in decompose(*polygon).parts:
        assert set(part.vertices) <= corners
        assert sorted(convex_corners(part.vertices)) == list(range(len(part.vertices)))
        assert len(part.vertices) <= 64
        assert len(part.shown) == len(part.vertices)
        assert min(math.dist(a, b) for a, b in pairs(part.vertices)) >= MIN_EDGE


@SLOW
@given(with_holes())
def test_what_shows_of_an_edge_is_where_sides_of_the_polygon_lie(polygon):
    found = decompose(*polygon)
    sides = [[shapely.Point(p) for p in side] for ring in found.rings for side in pairs(ring)]
    for part in found.parts:
        for shown, ends in zip(part.shown, pairs(part.vertices), strict=True):
            edge = shapely.LineString(ends)
            on = [end for side in sides if max(map(edge.distance, side)) < 1e-8 for end in side]
            places = [edge.project(end, normalized=True) for end in on]
            expected = (min(places), max(places)) if places else (1.0, 0.0)
            assert shown == pytest.approx(expected, abs=1e-7)


@SLOW
@given(with_holes(), st.randoms(use_true_random=False))
def test_winding_and_first_vertex_make_no_difference(polygon, random):
    outline, holes = polygon
    expected = decompose(outline, holes)
    turned = []
    for ring in (outline, *holes):
        by = random.randrange(len(ring))
        other = [*ring[by:], *ring[:by]]
        turned.append(other[::-1] if random.random() < 0.5 else other)
    found = decompose(turned[0], turned[1:])
    if len(expected.parts) > 1:
        assert found.parts == expected.parts
    assert [set(ring) for ring in found.rings] == [set(ring) for ring in expected.rings]
    assert area(found.rings[0]) > 0 > max((area(ring) for ring in found.rings[1:]), default=-1)


@SLOW
@given(simple, st.data())
def test_repeated_and_straight_vertices_make_no_difference(outline, data):
    expected = decompose(outline).parts
    place = data.draw(st.integers(0, len(outline) - 1))
    (ax, ay), (bx, by) = outline[place], outline[(place + 1) % len(outline)]
    extra = data.draw(st.sampled_from([[(ax, ay)], [((ax + bx) / 2, (ay + by) / 2)], [(bx, by), (bx, by)]]))
    found = decompose([*outline[: place + 1], *extra, *outline[place + 1 :]]).parts
    assert {frozenset(part.vertices) for part in found} == {frozenset(part.vertices) for part in expected}


@FEW
@given(simple)
def test_no_more_parts_than_hertel_and_mehlhorn_promise(outline):
    found = decompose(outline)
    least = math.ceil(dents(found.rings) / 2) + 1
    assert least <= len(found.parts) <= 2 * dents(found.rings) + 1


@examples(25, suppress_health_check=list(HealthCheck))
@given(simple.filter(lambda outline: len(outline) <= 14))
def test_never_twice_as_many_parts_as_there_can_be(outline):
    """Four times are promised by Hertel and Mehlhorn; six where four do have been seen."""
    found = decompose(outline)
    assert len(found.parts) < max(2 * least_parts(list(found.rings[0])), 2)


@pytest.mark.slow
def test_nearly_as_few_parts_as_there_can_be():
    """In the mean: of stars with up to 12 corners, the same in every run."""
    random = np.random.default_rng(5)
    found = least = 0
    for corners in random.integers(5, 13, 150):
        angles = 2.0 * math.pi * (np.arange(corners) + random.uniform(0.0, 0.4, corners)) / corners
        radii = random.uniform(0.2, 5.0, corners)
        parts = decompose([(r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, angles, strict=True)])
        found += len(parts.parts)
        least += least_parts(list(parts.rings[0]))
    assert least <= found <= 1.02 * least


@pytest.mark.parametrize(
    ("outline", "holes", "count"),
    [(L_SHAPE, [], 2), (FRAME, [WINDOW], 4), (gear(12), [], 13), ([(0, 0), (4, 0), (4, 4), (2, 1)], [], 2)],
)
def test_well_known_shapes_have_the_fewest_parts(outline, holes, count):
    assert len(decompose(outline, holes).parts) == count


def test_a_t_is_two_boxes():
    bar = [(0, 2), (1, 2), (1, 0), (2, 0), (2, 2), (3, 2), (3, 3), (0, 3)]
    parts = decompose(bar).parts
    assert [len(part.vertices) for part in parts] == [4, 4]
    assert sorted(part.shown.count((1.0, 0.0)) for part in parts) == [0, 1]


def test_fewer_parts_than_pymunk():
    """Over gears and stars of fixed shape, where pymunk adds no vertices either: never more, and fewer in sum."""
    ours = theirs = 0
    for outline in [gear(8), gear(12), gear(20), L_SHAPE, *(wave(k) for k in range(5, 15))]:
        parts = len(decompose(outline).parts)
        closed = [*outline, outline[0]]
        ours, theirs = ours + parts, theirs + len(convex_decomposition(closed, 0.0))
    assert ours < theirs


def wave(k: int) -> list[tuple[float, float]]:
    radii = [1.0 + 0.4 * math.sin(1.7 * i * k) for i in range(3 * k)]
    turns = [2 * math.pi * i / (3 * k) for i in range(3 * k)]
    return [(r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, turns, strict=True)]


def test_a_convex_polygon_is_one_part_that_begins_where_the_author_did():
    found = decompose(FRAME[2:] + FRAME[:2])
    corners = ((4, 4), (0, 4), (0, 0), (4, 0))
    assert found == ((corners,), ((corners, ((0.0, 1.0),) * 4),))


def test_a_round_polygon_of_many_vertices_is_cut_into_parts_of_64():
    circle = [(math.cos(k * math.pi / 100), math.sin(k * math.pi / 100)) for k in range(200)]
    parts = decompose(circle).parts
    assert max(len(part.vertices) for part in parts) <= 64
    assert len(parts) <= 5
    assert sum(area(part.vertices) for part in parts) == pytest.approx(area(circle), rel=1e-14)

"""What is no polygon with holes is refused, with the ring and the vertex to look at."""

from __future__ import annotations

import math

import pytest
import shapely
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import PolygonError
from tests.examples import examples

BOX = [(0, 0), (10, 0), (10, 10), (0, 10)]
DENTED = [(0, 0), (10, 0), (5, 1), (10, 10), (0, 10)]
SMALL = [(1, 4), (2, 4), (2, 5)]


@pytest.mark.parametrize(
    ("outline", "holes", "told", "index", "hole"),
    [
        ([(0, 0), (4, 0), (1, 0), (5, 0)], [], "the polygon has no area", None, None),
        (BOX, [[(1, 1), (2, 2), (3, 3)]], "the hole has no area", None, 0),
        (BOX, [SMALL, [(7, 7)] * 3], "the hole has no area", None, 1),
        ([(0, 0), (4, 4), (4, 0), (2, 1), (0, 4)], [], "the polygon intersects itself", 0, None),
        ([(0, 0), (8, 0), (8, 8), (4, 0), (0, 8)], [], "the polygon intersects itself", 0, None),
        ([(0, 0), (8, 0), (8, 4), (12, 4), (8, 4), (8, 8), (4, 2)], [], "the polygon intersects itself", 1, None),
        (BOX, [[(1, 1), (3, 3), (3, 1), (1, 4)]], "the hole intersects itself", 0, 0),
        (BOX, [SMALL, [(7, 2), (12, 2), (7, 3)]], "the hole meets the polygon's outline", 0, 1),
        (BOX, [[(0, 4), (2, 5), (2, 6)]], "the hole meets the polygon's outline", 0, 0),
        (BOX, [[(1, 5), (1, 3), (2, 4)], [(3, 3), (3, 5), (2, 4)]], "the hole meets another hole", 1, 1),
        (BOX, [[(20, 0), (21, 0), (20, 1)]], "the hole lies outside of the polygon", 0, 0),
        (DENTED, [[(7, 1), (8, 1), (8, 2)]], "the hole lies outside of the polygon", 0, 0),
        (BOX, [[(0.5, 1), (9, 1), (9, 9), (0.5, 9)], SMALL], "the hole lies in another hole", 0, 1),
        (BOX, [SMALL, [(0.5, 3), (3, 3), (3, 6), (0.5, 6)]], "the hole lies in another hole", 0, 0),
        (BOX, [[(5e-7, 4), (1, 4), (1, 5)]], "two sides are less than 1e-06 m apart", 0, 0),
        (BOX, [SMALL, [(4, 4), (5, 4), (5, 4 + 5e-7)]], "two vertices of the hole are less than 1e-06 m apart", 2, 1),
        ([(0, 0), (9, 0), (5, 1), (5, 1 + 5e-7), (9, 5)], [], "two vertices of the polygon are less", 3, None),
        ([(0, 0), (9, 0), (9, 9), (8, 9), (8, 5e-7), (0, 1)], [], "two sides are less than 1e-06 m apart", 0, None),
    ],
)  # fmt: skip
def test_what_is_no_polygon_with_holes_is_refused(outline, holes, told, index, hole):
    with pytest.raises(PolygonError, match=told) as caught:
        decompose(outline, holes)
    assert (caught.value.index, caught.value.hole) == (index, hole)


def test_a_sliver_is_refused():
    with pytest.raises(PolygonError, match="thinner than 1e-06 m"):
        decompose([(0, 0), (100, 0), (1, 1.2e-6), (0, 3e-6)])


coordinate = st.integers(-3, 3)
small_ring = st.lists(st.tuples(coordinate, coordinate), min_size=3, max_size=5, unique=True)


@examples(400, suppress_health_check=list(HealthCheck))
@given(st.lists(st.tuples(st.integers(-5, 5), st.integers(-5, 5)), min_size=3, max_size=8, unique=True), small_ring)
def test_shapely_finds_the_same_polygons_valid(outline, hole):
    """On small whole numbers nothing is straight but what is so exactly, and nothing is near but what touches."""
    try:
        decompose(outline, [hole])
        sound = True
    except PolygonError:
        sound = False
    whole, ring = shapely.Polygon(outline, [hole]), shapely.LinearRing(hole)
    valid = whole.is_valid and whole.area > 0 and not whole.exterior.intersects(ring)
    assert sound == valid


def test_holes_of_a_round_plate():
    """A gear blank: eight round holes in a disc of 60 corners."""

    def disc(x, y, r, count):
        return [
            (x + r * math.cos(2 * math.pi * k / count), y + r * math.sin(2 * math.pi * k / count)) for k in range(count)
        ]

    holes = [disc(2 * math.cos(k * math.pi / 4), 2 * math.sin(k * math.pi / 4), 0.5, 12) for k in range(8)]
    parts = [shapely.Polygon(part.vertices) for part in decompose(disc(0, 0, 3, 60), holes).parts]
    assert len(parts) <= 8 * 12
    whole = shapely.Polygon(disc(0, 0, 3, 60), holes)
    assert shapely.union_all(parts).symmetric_difference(whole).area < 1e-12

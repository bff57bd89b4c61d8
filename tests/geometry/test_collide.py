"""What was decided about collisions, each decision by a case one can check by hand."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import (
    Box,
    Capsule,
    Circle,
    Contact,
    Polygon,
    Segment,
    collide,
    distance,
)
from tests.geometry.judged import judge
from tests.geometry.shape_families import pairs

UNIT = Box(1, 1)


def overlap(amin: float, amax: float, bmin: float, bmax: float) -> bool:
    """The inequality that `collide` stands for."""
    return amin < bmax and bmin < amax


def tutorials_overlap(amin: float, amax: float, bmin: float, bmax: float) -> bool:
    """An inequality one meets in tutorials: each minimum strictly within the other interval."""
    return (amin < bmax and amin > bmin) or (bmin < amax and bmin > amin)


TOUCHING = [
    (Box(1, 1, at=(1, 0)), (-1, 0)),
    (Box(1, 1, at=(1, 1)), (-1, -1)),
    (Box(3, 1, at=(0.25, -1)), (0, 1)),
    (Circle((1.5, 0.25), 1), (-1, 0)),
    (Capsule((-2, 1.5), (2, 1.5), 1), (0, -1)),
    (Segment((0.5, -3), (0.5, 3)), (-1, 0)),
    (Segment((0, 1), (1, 0)), (-1, -1)),
    (Polygon([(0.5, 0), (1, 1), (1, -1)]), (-1, 0)),
    (Polygon([(1.5, -0.5), (1.5, 0.5), (2, 0)], 1), (-1, 0)),
]
"""Shapes that touch the unit box, and the way that presses them into it."""


@pytest.mark.parametrize(("other", "way"), TOUCHING)
def test_touching_is_not_colliding(other, way):
    assert collide(UNIT, other) is None
    assert collide(other, UNIT) is None
    assert distance(UNIT, other).value == 0.0
    pressed = other.moved([1e-15 * part for part in way])
    contact = collide(UNIT, pressed)
    assert contact is not None
    assert 0.0 < contact.depth < 2e-15
    apart = other.moved([-1e-15 * part for part in way])
    assert collide(UNIT, apart) is None
    assert 0.0 < distance(UNIT, apart).value < 2e-15


def test_touching_discs_do_not_collide():
    """3-4-5: a distance that is exact in floats."""
    assert collide(Circle((0, 0), 2), Circle((3, 4), 3)) is None
    assert collide(Circle((0, 0), 2), Circle((3, 4), 3.0000000000000004)) is not None


def test_identical_polygons_collide():
    """Equal minima overlap. The tutorial's inequality says that a polygon is separated from itself."""
    square = Polygon([(13, 10), (13, 3), (6, 3), (6, 10)])
    contact = collide(square, square)
    assert contact is not None
    assert contact.depth == 7.0
    for x, y in ((0, 1), (1, 0)):
        along = [x * u + y * v for u, v in square.vertices]
        assert overlap(min(along), max(along), min(along), max(along))
        assert not tutorials_overlap(min(along), max(along), min(along), max(along))


ends = st.tuples(st.integers(-4, 4), st.integers(1, 5)).map(lambda pair: (pair[0], pair[0] + pair[1]))


@given(ends, ends)
def test_the_two_inequalities_differ_exactly_where_minima_are_equal(a, b):
    shared = max(a[0], b[0]) < min(a[1], b[1])
    assert overlap(*a, *b) == shared
    assert (tutorials_overlap(*a, *b) != shared) == (a[0] == b[0])
    boxes = [Box(high - low, 1, at=((low + high) / 2, 0)) for low, high in (a, b)]
    assert (collide(*boxes) is not None) == shared


def test_a_box_inside_another_takes_the_shortest_way_out():
    """The overlap of the intervals is 1 m, the width of the small box: moving it by that leaves it inside."""
    contact = collide(Box(10, 10), Box(1, 1, at=(3, 1)))
    assert contact is not None
    assert contact.mtv == (2.5, 0.0)
    assert (contact.axis_owner, contact.axis_edge) == ("a", 1)
    other = collide(Box(1, 1, at=(3, 1)), Box(10, 10))
    assert other is not None
    assert other.mtv == (-2.5, 0.0)


def test_a_disc_inside_a_box_takes_its_whole_width_out():
    contact = collide(Box(10, 10), Circle((1, -3), 0.5))
    assert contact is not None
    assert (contact.normal, contact.depth) == ((0.0, -1.0), 2.5)


def test_the_normal_follows_the_intervals_not_the_centres():
    """At its foot the tall wedge reaches from 0 to 28.5 m; its centroid is at 10 m, left of the box at 13.5 m."""
    wedge = Polygon([(0, -1000), (30, -1000), (0, 1000)])
    contact = collide(wedge, Box(1, 1, at=(13.5, -900)))
    assert contact is not None
    assert contact.mtv == (-14.0, 0.0)
    contact = collide(wedge, Box(1, 1, at=(14.5, -900)))
    assert contact is not None
    assert contact.normal[0] > 0.99


def test_concentric_discs_part_along_y():
    assert collide(Circle((3, 4), 1), Circle((3, 4), 2)) == Contact(
        (0.0, 1.0), 3.0, (0.0, 3.0), ((3.0, 3.5),), "corners", None
    )


@pytest.mark.parametrize(
    ("shape", "depth"),
    [
        (Box(2, 1, at=(5, 7)), 1.0),
        (Circle((1, 1), 2), 4.0),
        (Capsule((0, 0), (3, 4), 0.5), 1.0),
        (Polygon([(0, 0), (4, 0), (4, 3), (0, 3)], 0.25), 3.5),
        (Polygon([(0, 0), (4, 0), (0, 3)]), 2.4),
    ],
)
def test_a_shape_and_itself_part_by_their_full_depth(shape, depth):
    contact = collide(shape, shape)
    assert contact is not None
    assert contact.depth == pytest.approx(depth, rel=1e-15)
    assert math.hypot(*contact.normal) == pytest.approx(1.0, rel=1e-15)
    assert contact == collide(shape, shape)


def test_a_line_has_no_thickness():
    """Lines that cross overlap on every axis; lines that lie on each other only touch."""
    cross = collide(Segment((0, 0), (2, 2)), Segment((0, 2), (2, 0)))
    assert cross is not None
    assert cross.depth == pytest.approx(math.sqrt(2.0))
    assert collide(Segment((0, 0), (2, 2)), Segment((0, 0), (2, 2))) is None
    assert collide(Segment((0, 0), (2, 2)), Segment((1, 1), (3, 3))) is None


def test_capsules_in_one_line_are_apart():
    """They overlap on all their face normals: the axis between their ends parts them."""
    for turn in (0.0, 0.3, 1.1, 2.5):
        c, s = math.cos(turn), math.sin(turn)
        ends = [(far * c, far * s) for far in (-1000.0, 0.0, 1.0, 900.0)]
        a, b = Capsule(ends[0], ends[1], 1e-6), Capsule(ends[2], ends[3], 1e-6)
        assert judge(a, b) == -1
        assert distance(a, b).value == pytest.approx(1.0 - 2e-6)


def test_the_tip_of_a_sliver_does_not_reach_beyond_itself():
    """Near the tip's direction every face separates by less than rounding."""
    sliver = Polygon([(0, 0), (3e5 * math.cos(1), 3e5 * math.sin(1)), (-3e-6, 2e-6)])
    beyond = math.cos(1) * 300006.0, math.sin(1) * 300006.0
    assert judge(sliver, Circle(beyond, 5)) == -1
    assert judge(sliver, Circle(beyond, 7)) == 1


def test_points_of_a_box_on_a_box():
    contact = collide(Box(10, 1), Box(2, 1, at=(3, 0.9)))
    assert contact is not None
    assert sorted(contact.points) == [pytest.approx((2, 0.45)), pytest.approx((4, 0.45))]


def test_edges_keep_the_authors_numbers():
    """The right side is edge 0 of the square given clockwise from its upper right corner."""
    square = Polygon([(13, 10), (13, 3), (6, 3), (6, 10)])
    for k, at in enumerate([(13, 6), (9, 3), (6, 6), (9, 10)]):
        contact = collide(square, Box(1, 1, at=at))
        assert contact is not None
        assert (contact.axis_owner, contact.axis_edge) == ("a", k)
        spiked = collide(Circle(at, 0.5), square)
        assert spiked is not None
        assert (spiked.axis_owner, spiked.axis_edge) == ("b", k)


@pytest.mark.parametrize("at", [(0, 0), (1e7, -1e7), (-9e8, 8e8)])
def test_far_from_the_origin_nothing_changes(at):
    a, b = Box(1, 1, at=at), Box(1, 2, at=(at[0] + 0.75, at[1] + 0.5))
    contact = collide(a, b)
    assert contact is not None
    assert (contact.mtv, contact.axis_edge) == ((0.25, 0.0), 1)


@pytest.mark.parametrize("gap", [1e-17, 1e-30, 1e-100, 1e-280])
def test_a_depth_is_right_however_small(gap):
    """3-4-5: the centres are 5 m less four fifths of `gap` apart, which is irrational."""
    contact = collide(Circle((0, gap), 2), Circle((3, 4), 3))
    assert contact is not None
    assert contact.depth == pytest.approx(0.8 * gap, rel=1e-15)
    assert judge(Circle((0, gap), 2), Circle((3, 4), 3)) == 1
    assert judge(Circle((0, -gap), 2), Circle((3, 4), 3)) == -1


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1.0, 1e3, 1e7])
def test_every_size_is_as_good(size):
    contact = collide(Box(size, size), Circle((1.25 * size, 0), size))
    assert contact is not None
    assert contact.depth == pytest.approx(0.25 * size, rel=1e-12)


@given(pairs)
def test_a_contact_is_the_same_every_time(pair):
    assert collide(*pair) == collide(*pair)


def test_a_contact_cannot_be_changed():
    contact = collide(UNIT, UNIT)
    with pytest.raises(AttributeError):
        contact.depth = 1.0


def test_the_example_in_the_guide_prints_what_it_says(capsys):
    text = Path(__file__).parents[2].joinpath("sandbox", "geometry", "README.md").read_text(encoding="utf-8")
    (code,) = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    exec(code, {})
    assert capsys.readouterr().out.splitlines() == re.findall(r"\)  # (.*)$", code, re.MULTILINE)


@pytest.mark.parametrize("depth", [0.05, 1e-3, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("turn", [0.0, 0.1, 0.3, 1.234])
def test_rounded_faces_flat_on_each_other_have_two_points_however_near(turn, depth):
    """Their corners are as near as their faces, give or take a rounding."""

    def rounded(x: float, y: float) -> Polygon:
        c, s = math.cos(turn), math.sin(turn)
        core = [(x - 0.4, y - 0.4), (x + 0.4, y - 0.4), (x + 0.4, y + 0.4), (x - 0.4, y + 0.4)]
        return Polygon([(c * u - s * v, s * u + c * v) for u, v in core], 0.1)

    for shift in (0.0, 0.2):
        contact = collide(rounded(0, 0), rounded(shift, 1 - depth))
        assert contact is not None
        assert contact.depth == pytest.approx(depth, abs=1e-15)
        assert math.dist(*contact.points) == pytest.approx(0.8 - shift, abs=1e-9)

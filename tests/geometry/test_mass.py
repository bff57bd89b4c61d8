"""Area, centroid and inertia against exact sums and closed forms."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.geometry.mass import Moments, edge_normals, moments
from tests.examples import examples
from tests.geometry.convex_cases import box, lines, polygons
from tests.naive.area import polygon_moments, rounded_moments

offsets = st.tuples(st.floats(-5, 5), st.floats(-5, 5))


def moved(core, offset):
    """A core somewhere else."""
    return tuple((x + offset[0], y + offset[1]) for x, y in core)


@given(polygons(), offsets)
def test_a_sharp_polygon_is_exact(core, offset):
    core = moved(core, offset)
    expected = [float(v) for v in polygon_moments([(Fraction(x), Fraction(y)) for x, y in core])]
    assert list(moments(core, 0.0)) == pytest.approx(expected, rel=1e-9, abs=1e-11)


@given(polygons() | lines() | st.just(((0.0, 0.0),)), offsets, st.floats(0.01, 2.0))
@examples(30)
def test_a_rounded_core_is_the_limit_of_polygons(core, offset, radius):
    core = moved(core, offset)
    assert list(moments(core, radius)) == pytest.approx(rounded_moments(core, radius), rel=1e-4, abs=1e-5)


@given(st.floats(0.01, 10.0))
def test_a_disc(radius):
    area = math.pi * radius**2
    assert moments(((0.0, 0.0),), radius) == pytest.approx((area, 0.0, 0.0, area * radius**2 / 2), rel=1e-14)


@given(st.floats(0.1, 10.0), st.floats(0.1, 10.0))
def test_a_box(width, height):
    area = width * height
    got = moments(box(width, height), 0.0)
    assert got == pytest.approx((area, 0.0, 0.0, area * (width**2 + height**2) / 12), rel=1e-13, abs=1e-13)


@given(st.floats(0.1, 5.0), st.floats(0.01, 2.0))
def test_a_capsule_is_a_box_and_a_disc_pulled_apart(half, r):
    rectangle, disc = 4 * half * r, math.pi * r * r
    ends = disc * (r * r / 2 + half**2) + half * 8 * r**3 / 3
    second = rectangle * ((2 * half) ** 2 + (2 * r) ** 2) / 12 + ends
    got = moments(((-half, 0.0), (half, 0.0)), r)
    assert got == pytest.approx((rectangle + disc, 0.0, 0.0, second), rel=1e-12, abs=1e-12)


def test_a_segment_has_no_mass():
    assert moments(((-1.0, 0.0), (1.0, 2.0)), 0.0) == Moments(0.0, 0.0, 0.0, 0.0)


@given(polygons(), offsets, st.floats(0.0, 1.0))
def test_the_parallel_axis_theorem(core, offset, radius):
    here, there = moments(core, radius), moments(moved(core, offset), radius)
    dx, dy = offset
    assert there.area == pytest.approx(here.area, rel=1e-12)
    shift = 2 * (dx * here.first_x + dy * here.first_y) + here.area * (dx * dx + dy * dy)
    assert there.second == pytest.approx(here.second + shift, rel=1e-9, abs=1e-9)


@given(polygons() | lines())
def test_edge_normals_are_unit_outward_and_square_to_their_edges(core):
    for (x0, y0), (x1, y1), (nx, ny) in zip(core, [*core[1:], core[0]], edge_normals(core), strict=True):
        assert math.hypot(nx, ny) == pytest.approx(1.0, abs=1e-15)
        assert nx * (x1 - x0) + ny * (y1 - y0) == pytest.approx(0.0, abs=1e-12)
        assert all(nx * (x - x0) + ny * (y - y0) <= 1e-12 for x, y in core)

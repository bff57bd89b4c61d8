"""The separating-axis table: the tutorial's numbers, the definition, and agreement with what the engine runs."""

from __future__ import annotations

import json
import math
from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import sandbox
from sandbox.geometry.sat_rows import author_edges, count_axes, sat_rows
from tests.examples import examples
from tests.geometry.convex_cases import Case, cases
from tests.geometry.tutorial_cases import (
    SQUARE_ONE,
    SQUARE_TWO,
    TABLE_ONE,
    TABLE_TWO,
    TRIANGLE_ONE,
    TRIANGLE_TWO,
)

ONE = sandbox.Polygon(SQUARE_ONE), sandbox.Polygon(TRIANGLE_ONE)
TWO = sandbox.Polygon(SQUARE_TWO), sandbox.Polygon(TRIANGLE_TWO)
LINE = ((0.0, 0.0), (2.0, 0.0))


def as_printed(table: sandbox.SatTable) -> tuple:
    return tuple((row.amax, row.amin, row.bmax, row.bmin, "Yes" if row.gap else "No") for row in table.rows)


def shape_of(core, radius: float) -> sandbox.Shape:
    if len(core) == 1:
        return sandbox.Circle(core[0], radius)
    if len(core) == 2:
        return sandbox.Capsule(*core, radius) if radius else sandbox.Segment(*core)
    return sandbox.Polygon(core, radius)


@st.composite
def shape_pairs(draw: st.DrawFn) -> tuple[sandbox.Shape, sandbox.Shape]:
    """Two shapes, the polygons in either winding."""
    case: Case = draw(cases)
    b = tuple((x + case.way[0], y + case.way[1]) for x, y in case.b)
    flip_a, flip_b = draw(st.booleans()), draw(st.booleans())
    return shape_of(case.a[:: -1 if flip_a else 1], case.radius_a), shape_of(b[:: -1 if flip_b else 1], case.radius_b)


def test_test_one_is_the_tutorials():
    table = sandbox.sat_table(*ONE)
    assert as_printed(table) == TABLE_ONE
    assert [(row.owner, row.edge, row.axis) for row in table.rows] == [("a", 1, (7, 0)), ("a", 2, (0, -7))]
    assert not table.colliding
    assert (table.mtv, table.mtv_row, table.runner_up) == (None, None, None)
    assert table.stopped is table.rows[1]
    assert table.stopped.separation == 1.0
    assert table.axis_count == 7


def test_test_two_is_the_tutorials():
    table = sandbox.sat_table(*TWO)
    assert as_printed(table) == TABLE_TWO
    assert [(row.owner, row.edge) for row in table.rows] == [("a", k) for k in (1, 2, 3, 4)] + [
        ("b", 1),
        ("b", 2),
        ("b", 3),
    ]
    assert table.colliding
    assert table.stopped is None
    assert table.mtv == (0.0, 1.0)
    assert table.mtv_row.number == 4
    assert table.runner_up.number == 7
    assert table.runner_up.separation == pytest.approx(-12 / math.sqrt(40))


def test_all_axes_go_on_after_the_gap_and_remember_where_the_test_stopped():
    table = sandbox.sat_table(*ONE, all_axes=True)
    assert [row.gap for row in table.rows] == [False, True, False, True, False, True, False]
    assert [row.stopped for row in table.rows] == [False, True, False, False, False, False, False]
    assert as_printed(table)[:2] == TABLE_ONE


@given(shape_pairs())
@examples(300)
@example((sandbox.Segment(*LINE), sandbox.Segment((2.0, 0.0), (3.0, 0.0))))
@example((sandbox.Segment(*LINE), sandbox.Segment((1.0, 0.0), (3.0, 0.0))))
@example((sandbox.Capsule(*LINE, 0.5), sandbox.Circle((3.0, 0.0), 0.5)))
@example((sandbox.Circle((1.0, 1.0), 0.5), sandbox.Circle((1.0, 1.0), 2.0)))
@example((sandbox.Box(2, 2), sandbox.Box(2, 2, at=(2, 0))))
@example((sandbox.Box(6, 6), sandbox.Box(1, 1, at=(1, 0))))
@example((sandbox.Box(1, 1), sandbox.Box(1, 1)))
def test_the_rows_alone_say_what_collide_says(pair):
    """Verdict, depth and axis, from exact intervals on one side and the engine's kernels on the other."""
    a, b = pair
    table = sandbox.sat_table(a, b, all_axes=True)
    contact = sandbox.collide(a, b)
    assert table.contact == contact
    assert (contact is None) == any(row.gap for row in table.rows)
    if contact is None:
        assert max(row.separation for row in table.rows) >= 0.0
        return
    least = max(table.rows, key=lambda row: row.separation)
    assert contact.depth == pytest.approx(-least.separation, rel=1e-9, abs=1e-15)
    first = table.mtv_row
    assert first.separation == pytest.approx(least.separation, rel=1e-9, abs=1e-15)
    assert first.owner == contact.axis_owner
    u = first.axis[0] / first.length, first.axis[1] / first.length
    assert u[0] * contact.normal[1] - u[1] * contact.normal[0] == pytest.approx(0.0, abs=1e-12)
    forwards, backwards = first.amax - first.bmin, first.bmax - first.amin
    if abs(forwards - backwards) > 1e-9 * (forwards + backwards):
        assert first.way * (u[0] * contact.normal[0] + u[1] * contact.normal[1]) > 0.99


@given(shape_pairs())
def test_a_gap_is_the_inequality_of_the_intervals(pair):
    for row in sat_rows(*pair):
        if pair[0].radius == pair[1].radius == 0.0:
            assert row.gap == (not (row.amin < row.bmax and row.bmin < row.amax))
        gap = max(row.bmin - row.amax, row.amin - row.bmax)
        assert row.separation == pytest.approx(gap / row.length, abs=1e-9)


@given(shape_pairs())
def test_the_intervals_are_the_least_and_greatest_dot_products(pair):
    a, b = pair
    for row in sat_rows(a, b):
        for shape, low, high in ((a, row.amin, row.amax), (b, row.bmin, row.bmax)):
            dots = [
                float(Fraction(x) * Fraction(row.axis[0]) + Fraction(y) * Fraction(row.axis[1])) for x, y in shape.given
            ]
            reach = shape.radius * row.length
            assert low == pytest.approx(min(dots) - reach, abs=1e-9)
            assert high == pytest.approx(max(dots) + reach, abs=1e-9)


def test_edges_are_numbered_and_directed_as_the_author_did():
    clockwise, anticlockwise = sandbox.Polygon(SQUARE_ONE), sandbox.Polygon(SQUARE_ONE[::-1])
    assert author_edges(clockwise) == [(k + 1, SQUARE_ONE[k], SQUARE_ONE[(k + 1) % 4]) for k in range(4)]
    assert [edge[1] for edge in author_edges(anticlockwise)] == list(SQUARE_ONE[::-1])
    assert author_edges(sandbox.Segment(*LINE)) == [(1, *LINE)]
    assert author_edges(sandbox.Circle((0, 0), 1)) == []


def test_a_vertex_too_many_does_not_shift_the_numbers():
    broken_up = sandbox.Polygon(((0, 0), (0, 2), (1, 2), (2, 2), (2, 0)))
    assert author_edges(broken_up) == [
        (1, (0, 0), (0, 2)), (2, (0, 2), (2, 2)), (4, (2, 2), (2, 0)), (5, (2, 0), (0, 0)),
    ]  # fmt: skip


def test_rounded_shapes_add_the_axis_between_their_nearest_vertices():
    box, disc = sandbox.Polygon(((0, 0), (4, 0), (4, 3), (0, 3))), sandbox.Circle((5, 4), 1.5)
    table = sandbox.sat_table(box, disc)
    last = table.rows[-1]
    assert (last.owner, last.edge, last.other, last.axis) == ("corners", 3, 1, (1, 1))
    assert table.mtv_row is last
    assert (last.amin, last.amax) == (0.0, 7.0)
    assert (last.bmin, last.bmax) == pytest.approx((9 - 1.5 * math.sqrt(2), 9 + 1.5 * math.sqrt(2)))
    assert -last.separation == pytest.approx(1.5 - math.sqrt(2))


def test_two_discs_have_one_axis_even_when_concentric():
    apart = sandbox.sat_table(sandbox.Circle((0, 0), 1), sandbox.Circle((3, 4), 1))
    assert [(row.axis, row.separation) for row in apart.rows] == [((3, 4), 3.0)]
    same = sandbox.sat_table(sandbox.Circle((0, 0), 1), sandbox.Circle((0, 0), 2))
    assert [row.axis for row in same.rows] == [(0, 1)]
    assert same.mtv == (0.0, 3.0)
    assert same.runner_up is None


def test_touching_is_a_gap_of_nothing():
    table = sandbox.sat_table(sandbox.Box(2, 2), sandbox.Box(2, 2, at=(2, 0)))
    assert not table.colliding
    assert table.stopped.separation == 0.0


def test_far_from_the_origin_the_rows_are_still_exact():
    far = 2.0**29
    a = sandbox.Polygon([(x + far, y - far) for x, y in SQUARE_TWO])
    b = sandbox.Polygon([(x + far, y - far) for x, y in TRIANGLE_TWO])
    table = sandbox.sat_table(a, b)
    assert table.mtv == (0.0, 1.0)
    assert [row.separation for row in table.rows] == [row.separation for row in sandbox.sat_table(*TWO).rows]


def test_the_data_is_plain_and_complete():
    data = json.loads(json.dumps(sandbox.sat_table(*TWO).to_data()))
    assert data["colliding"] is True
    assert (data["axes"], data["stopped_at"], data["mtv_axis"], data["runner_up"]) == (7, None, 4, 7)
    assert (data["mtv"], data["depth"], data["points"]) == ([0.0, 1.0], 1.0, [[8.0, 9.5]])
    assert data["rows"][0]["amax"] == 77
    assert count_axes(*TWO) == 7

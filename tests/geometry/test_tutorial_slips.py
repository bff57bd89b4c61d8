"""The slips of the tutorial's program: which cases are blind to each, and the case that is not.

`sandbox` is asked the same question every time: it must not have the slip.
"""

from __future__ import annotations

import pytest
from hypothesis import given

import sandbox
from sandbox.geometry.sat_rows import author_edges
from tests.examples import examples
from tests.geometry.convex_cases import Case, numbers, polygons
from tests.geometry.tutorial_cases import (
    SQUARE_ONE,
    SQUARE_TWO,
    TABLE_ONE,
    TABLE_TWO,
    TRIANGLE_ONE,
    TRIANGLE_TWO,
)
from tests.geometry.tutorial_program import Slip, edges_of, run

ONE, TWO = (SQUARE_ONE, TRIANGLE_ONE), (SQUARE_TWO, TRIANGLE_TWO)
SLANTED = ((4, 4), (4, 0), (0, 0), (0, 4)), ((3, 6), (6, 3), (6, 6))
SAME_FLOOR = ((0, 0), (4, 0), (4, 4), (0, 4)), ((3, 0), (5, 0), (5, 2), (3, 2))
PRINTED_EDGES_TWO = [(-1, 6), (6, -2)]
"""The list of data of test two has no first edge; the program below it has."""


def collides(a, b) -> bool:
    return sandbox.sat_table(sandbox.Polygon(a), sandbox.Polygon(b)).colliding


def test_without_slips_the_program_prints_the_tutorials_tables():
    assert run(*ONE) == (False, list(TABLE_ONE))
    assert run(*TWO) == (True, list(TABLE_TWO))


@given(polygons(), polygons(), numbers, numbers)
@examples(200)
def test_without_slips_the_program_agrees_with_the_table(a, b, x, y):
    moved = tuple((px + x, py + y) for px, py in b)
    table = sandbox.sat_table(sandbox.Polygon(a), sandbox.Polygon(moved))
    if any(abs(row.separation) < 1e-9 for row in table.rows):
        return  # So near a touch the program's own rounding decides.
    colliding, rows = run(a, moved)
    assert colliding == table.colliding
    assert [row[4] for row in rows] == ["Yes" if row.gap else "No" for row in table.rows]


def test_a_maximum_that_never_grows_is_caught_by_test_two():
    verdict, rows = run(*ONE, Slip.MAXIMUM_NEVER_GROWS)
    assert verdict is False, "test one is blind: it finds a gap, only the wrong one"
    assert rows != list(TABLE_ONE), "its table is not"
    assert rows == [(42, 42, 105, 70, "Yes")]
    assert run(*TWO, Slip.MAXIMUM_NEVER_GROWS)[0] is False, "test two sees it"
    assert collides(*TWO)


def test_forgotten_edges_of_b_are_caught_by_a_slanted_gap():
    assert run(*ONE, Slip.OTHER_NAME_FOR_B) == (False, list(TABLE_ONE)), "test one stops before it comes to B"
    verdict, rows = run(*TWO, Slip.OTHER_NAME_FOR_B)
    assert verdict is True, "test two is blind"
    assert rows[:4] == list(TABLE_TWO[:4])
    assert rows[4:] == [TABLE_TWO[3]] * 3, "the last axis of A, three times more"
    assert run(*SLANTED)[0] is False
    assert run(*SLANTED, Slip.OTHER_NAME_FOR_B)[0] is True, "only an edge of B parts these two"
    assert not collides(*SLANTED)


def test_a_missing_edge_is_caught_by_adding_up_the_edges():
    assert run(*TWO, edges_b=PRINTED_EDGES_TWO)[0] is True, "test two is blind"
    assert len(run(*TWO, edges_b=PRINTED_EDGES_TWO)[1]) == 6
    assert total(PRINTED_EDGES_TWO) == (5, 4), "an outline that does not close"
    assert total(edges_of(TRIANGLE_TWO)) == (0, 0)
    assert run(*SLANTED, edges_b=edges_of(SLANTED[1])[1:])[0] is True, "and here it matters"
    assert [(q[0] - p[0], q[1] - p[1]) for _, p, q in author_edges(sandbox.Polygon(TRIANGLE_TWO))] == edges_of(
        TRIANGLE_TWO
    )


def test_equal_minima_are_caught_by_two_boxes_on_one_floor():
    assert run(*ONE, Slip.MINIMA_COMPARED) == (False, list(TABLE_ONE)), "test one is blind"
    assert run(*TWO, Slip.MINIMA_COMPARED) == (True, list(TABLE_TWO)), "and so is test two"
    assert run(*SAME_FLOOR)[0] is True
    verdict, rows = run(*SAME_FLOOR, Slip.MINIMA_COMPARED)
    assert verdict is False
    assert rows[-1] == (16, 0, 8, 0, "Yes")
    assert collides(*SAME_FLOOR)


def test_equal_minima_part_a_polygon_from_itself():
    assert run(SQUARE_ONE, SQUARE_ONE, Slip.MINIMA_COMPARED)[0] is False
    assert run(SQUARE_ONE, SQUARE_ONE)[0] is True
    square = sandbox.Polygon(SQUARE_ONE)
    assert sandbox.sat_table(square, square).contact.depth == 7.0


@given(polygons(), polygons(), numbers, numbers)
@examples(200)
def test_random_polygons_are_blind_to_equal_minima(a, b, x, y):
    """The inequality is wrong for equal minima only, which shapes in general position never have."""
    moved = Case(a, tuple((px + x, py + y) for px, py in b), (0.0, 0.0))
    colliding, rows = run(moved.a, moved.b)
    if all(row[1] != row[3] for row in rows):
        assert run(moved.a, moved.b, Slip.MINIMA_COMPARED) == (colliding, rows)


def test_wrong_edges_that_add_up_are_caught_by_their_vertices():
    vertices, printed = ((4, 7), (7, 2), (1, 2)), [(4, -3), (-6, -1), (2, 4)]
    assert total(printed) == (0, 0), "adding them up is blind here"
    assert edges_of(vertices) == [(3, -5), (-6, 0), (3, 5)]
    assert edges_of(vertices) != printed


@pytest.mark.parametrize("case", [ONE, TWO])
def test_fields_of_another_name_are_caught_by_the_first_run(case):
    with pytest.raises(AttributeError, match="no attribute 'edge'"):
        run(*case, Slip.OTHER_FIELD_NAMES)
    assert run(*case)[0] == collides(*case), "with one name for each field it runs"


def total(edges) -> tuple[float, float]:
    return sum(x for x, _ in edges), sum(y for _, y in edges)

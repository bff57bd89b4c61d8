"""All pairs by sorting and counting against two loops, and the filters against their definition."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.reference import brute_force
from sandbox.reference.brute_force import overlapping_pairs, that_matter
from tests import flat

steps = st.integers(0, 12).map(lambda k: 0.5 * k)
sizes = st.integers(0, 5).map(lambda k: 0.5 * k)
boxes = st.lists(st.tuples(steps, steps, sizes, sizes), max_size=24).map(
    lambda rows: np.array([(x, y, x + w, y + h) for x, y, w, h in rows], dtype=float).reshape(-1, 4)
)


def by_two_loops(rows: np.ndarray) -> list[list[int]]:
    def meet(a: np.ndarray, b: np.ndarray) -> bool:
        return a[0] <= b[2] and b[0] <= a[2] and a[1] <= b[3] and b[1] <= a[3]

    return [[i, j] for i in range(len(rows)) for j in range(i + 1, len(rows)) if meet(rows[i], rows[j])]


@given(boxes)
def test_every_overlap_comes_out_once_and_in_order(rows: np.ndarray) -> None:
    assert overlapping_pairs(rows).tolist() == by_two_loops(rows)


@given(boxes)
def test_portions_change_nothing(rows: np.ndarray) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(brute_force, "_AT_ONCE", 3)
        assert overlapping_pairs(rows).tolist() == by_two_loops(rows)


def matters(first: dict, second: dict) -> bool:
    """Whether a pair of two bodies with one shape each has to be decided."""
    bodies = []
    for name, fields in (("a", first), ("b", second)):
        surface = {key: fields[key] for key in ("category", "mask", "group") if key in fields}
        rest = {key: value for key, value in fields.items() if key not in surface and key != "asleep"}
        bodies.append(flat.body(name, flat.circle(1.0, **surface), **rest))
    state = flat.world(*bodies).state
    for row, fields in zip(state.bodies, (first, second), strict=True):
        row.awake = 0 if fields.get("asleep") else 1
    return len(that_matter(np.array([[0, 1]]), state.bodies, state.shapes)) == 1


STATIC, DRIVEN = {"type": "static"}, {"type": "kinematic", "velocity": (1.0, 0.0)}


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        ({}, {}, True),
        ({}, STATIC, True),
        (STATIC, STATIC, False),
        (STATIC, DRIVEN, False),
        ({"asleep": True}, {}, True),
        ({"asleep": True}, {"asleep": True}, False),
        ({"asleep": True}, STATIC, False),
        ({"asleep": True}, DRIVEN, True),
        ({"asleep": True}, {"type": "kinematic"}, False),
        ({"category": 2}, {"mask": 1}, False),
        ({"category": 2}, {"mask": 3}, True),
        ({"group": -4}, {"group": -4}, False),
        ({"group": 4, "mask": 0}, {"group": 4}, True),
        ({"group": 4, "mask": 0}, {"group": 5}, False),
    ],
)
def test_only_pairs_that_can_meet_matter(first: dict, second: dict, expected: bool) -> None:
    assert matters(first, second) == expected
    assert matters(second, first) == expected


def test_shapes_of_one_body_never_matter() -> None:
    state = flat.world(flat.body("a", flat.circle(1.0), flat.circle(1.0))).state
    assert len(that_matter(np.array([[0, 1]]), state.bodies, state.shapes)) == 0

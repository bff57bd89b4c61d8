"""Colours of the joints of nets, by machine code and as Python, against one joint after another and sets."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sandbox._jit import interpreted
from sandbox.engine.joints.net_lanes import MAX_COLORS, color_joints
from tests.examples import examples

MEMBERS = 9


@pytest.mark.parametrize("run", [color_joints, interpreted(color_joints)], ids=["machine code", "Python"])
@examples(200)
@given(
    pairs=st.lists(st.tuples(st.integers(0, MEMBERS - 1), st.integers(0, MEMBERS - 1)), max_size=300),
    moves=st.lists(st.integers(0, 1), min_size=MEMBERS, max_size=MEMBERS),
)
@example(pairs=[(0, 1)] * (MAX_COLORS + 5), moves=[1] * MEMBERS)
def test_each_joint_has_the_lowest_colour_that_is_free_where_it_moves_something(run, pairs, moves):
    found = np.full(len(pairs), -1)
    a, b = (np.array([pair[k] for pair in pairs], np.int64) for k in (0, 1))
    run(a, b, np.array(moves), np.zeros(MEMBERS, np.int64), found)
    taken = [set[int]() for _ in range(MEMBERS)]
    for pair, color in zip(pairs, found.tolist(), strict=True):
        moving = [member for member in pair if moves[member]]
        used = set[int]().union(*(taken[member] for member in moving))
        assert color == min(set(range(MAX_COLORS)) - used, default=MAX_COLORS)
        for member in moving:
            taken[member].add(color)

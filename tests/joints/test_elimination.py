"""Elimination order and fill of random parts, by machine code and as Python, against sets of neighbours."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.joints import elimination
from sandbox.engine.joints.elimination import NOBODY, WORLD, minimum_degree
from sandbox.engine.joints.symbolic import symbolic
from tests.examples import examples
from tests.naive import elimination as naive


@st.composite
def parts(draw):
    """Sides of joints, two or, as a gear has, four, and how many rows each has: chains, stars, meshes and anything."""
    count, bodies = draw(st.integers(1, 40)), draw(st.integers(1, 30))
    member = st.integers(WORLD, bodies - 1)
    shape = draw(st.sampled_from(["anything", "chain", "star", "mesh"]))
    sides = []
    for k in range(count):
        gear = draw(st.integers(0, 9)) == 0
        pair = {
            "anything": lambda: [draw(member), draw(member)],
            "chain": lambda k=k: [k - 1, k],
            "star": lambda k=k: [0, k + 1],
            "mesh": lambda k=k: [k // 2, k // 2 + (1 if k % 2 else 6)],
        }[shape]()
        sides.append(pair + ([draw(member), draw(member)] if gear else [NOBODY, NOBODY]))
    return np.array(sides), np.array(draw(st.lists(st.integers(1, 4), min_size=count, max_size=count)))


def neighbours(sides):
    """For each joint the others that share a body with it."""
    bodies = [{side for side in each if side >= 0} for each in sides.tolist()]
    return {j: [k for k, other in enumerate(bodies) if k != j and each & other] for j, each in enumerate(bodies)}


@pytest.fixture(params=["machine code", "Python"])
def way(request, monkeypatch):
    monkeypatch.setattr(elimination, "FEW_JOINTS", 0 if request.param == "machine code" else 10**9)


@pytest.mark.usefixtures("way")
@examples(600)
@given(part=parts(), updates=st.sampled_from([-1000, -20, 0, 3, 10, 200]))
def test_the_order_and_what_it_costs_are_those_of_sets(part, updates):
    sides, weights = part
    joints = range(len(sides))
    order, pays = naive.minimum_degree(joints, neighbours(sides), dict(enumerate(weights.tolist())), updates)
    found = minimum_degree(sides, weights, updates)
    assert (found is not None) == pays
    if found is not None:
        assert found.order.tolist() == order


@examples(600)
@given(part=parts(), data=st.data())
def test_the_factor_has_the_entries_that_sets_say(part, data):
    """Some joints have a row without a column, which lies behind theirs."""
    sides, weights = part
    found = minimum_degree(sides, weights, 10**6)
    assert found is not None
    count, order = len(sides), found.order.tolist()
    extra = np.array(data.draw(st.lists(st.integers(0, 1), min_size=count, max_size=count)))
    total = (weights + extra)[found.order]
    first = np.cumsum(total) - total
    pattern = symbolic(found, first, weights[found.order], int(total.sum()))
    numbers = {j: list(range(first[place], first[place] + weights[j])) for place, j in enumerate(order)}
    linked, place = neighbours(sides), {j: k for k, j in enumerate(order)}
    later = [[numbers[k] for k in linked[j] if place[k] > place[j]] for j in order]
    judge = naive.Pattern()
    entry = naive.symbolic([numbers[j] for j in order], later, judge)
    assert pattern.starts.tolist() == judge.starts
    assert pattern.row_of.tolist() == judge.row_of
    assert pattern.targets.tolist() == judge.targets
    columns, rows = np.array(list(entry)).T
    assert pattern.entries(columns, rows).tolist() == list(entry.values())


@pytest.mark.usefixtures("way")
def test_a_mesh_too_dense_is_found_to_be_so_at_any_size():
    for size in (4, 40):
        across = [[size * y + x, size * y + x + 1] for y in range(size) for x in range(size - 1)]
        down = [[size * y + x, size * y + x + size] for y in range(size - 1) for x in range(size)]
        sides = np.array([[*pair, NOBODY, NOBODY] for pair in across + down])
        assert (minimum_degree(sides, np.full(len(sides), 3), 200) is None) == (size == 40)

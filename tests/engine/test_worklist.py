"""The worklist of impacts does what a queue does from which nobody may be taken twice at once."""

from __future__ import annotations

from collections import deque

from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.records.batches import IMPACT_SLOT
from sandbox.engine.restitution import worklist
from sandbox.engine.restitution.worklist import END, Worklist
from tests.engine.stages import link_contacts, stage
from tests.flat import body, circle, ground, world

BODIES = 6
list_all = stage(worklist.list_all)


@stage
def take_first(slots, first, last):
    """Python hands over numbers, no `Worklist`."""
    return worklist.take_first(slots, Worklist(first, last))


@stage
def add_contact(slots, k, first, last):
    return worklist.add_contact(slots, k, Worklist(first, last))


@stage
def add_contacts(bodies, slots, k, heads, first, last):
    return worklist.add_contacts(bodies, slots, k, heads, Worklist(first, last))


bodies_of_contacts = st.lists(
    st.tuples(st.integers(0, BODIES), st.integers(0, BODIES)).filter(lambda pair: pair[0] < pair[1]), max_size=12
)


@given(
    bodies_of_contacts, st.lists(st.tuples(st.sampled_from(["take", "add", "one"]), st.integers(0, 11)), max_size=40)
)
def test_contacts_come_out_as_they_went_in_and_none_is_in_twice(pairs, moves):
    """A move takes the first contact out, or adds one, or those of its bodies. Body 0 is static and has none."""
    w = world(ground(), *(body(f"b{i}", circle(0.5), position=(2.0 * i, 5.0)) for i in range(BODIES)))
    bodies, solver = w.state.bodies, w.scratch.solver
    slots = IMPACT_SLOT.zeros(max(len(pairs), 1))
    for slot, pair in zip(slots, pairs, strict=False):
        slot.body_a, slot.body_b = pair
    link_contacts(bodies, slots, len(pairs), solver)
    listed = list_all(slots, len(pairs))
    queue = deque(range(len(pairs)))
    for move, k in moves:
        if move == "take":
            assert listed[0] == (queue[0] if queue else END)
            if queue:
                queue.popleft()
                listed = take_first(slots, *listed)
        elif k < len(pairs) and move == "one":
            queue.extend([k] if k not in queue else [])
            listed = add_contact(slots, k, *listed)
        elif k < len(pairs):
            for i in pairs[k]:
                queue.extend(j for j, pair in enumerate(pairs) if i != 0 and i in pair and j not in queue)
            listed = add_contacts(bodies, slots, k, solver.first_impact, *listed)
    while queue:
        assert listed[0] == queue.popleft()
        listed = take_first(slots, *listed)
    assert tuple(listed) == (END, END)

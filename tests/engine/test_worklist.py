"""The worklist of impacts does what a queue does from which nobody may be taken twice at once."""

from __future__ import annotations

from collections import deque

from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.records.batches import IMPACT_SLOT
from sandbox.engine.restitution import worklist
from sandbox.engine.restitution.worklist import END
from tests.engine.stages import link_contacts, stage
from tests.flat import body, circle, ground, world

BODIES = 6
add_all = stage(worklist.add_all)
take_first = stage(worklist.take_first)
add_contacts = stage(worklist.add_contacts)

bodies_of_contacts = st.lists(
    st.tuples(st.integers(0, BODIES), st.integers(0, BODIES)).filter(lambda pair: pair[0] < pair[1]), max_size=12
)


@given(bodies_of_contacts, st.lists(st.sampled_from([0, 0, *range(1, BODIES + 1)]), max_size=40))
def test_contacts_come_out_as_they_went_in_and_none_is_in_twice(pairs, moves):
    """A move takes the first contact out, for 0, or adds those of a body. Body 0 is static and has none."""
    w = world(ground(), *(body(f"b{i}", circle(0.5), position=(2.0 * i, 5.0)) for i in range(BODIES)))
    solver = w.scratch.solver
    slots = IMPACT_SLOT.zeros(max(len(pairs), 1))
    for slot, pair in zip(slots, pairs, strict=False):
        slot.body_a, slot.body_b = pair
    link_contacts(w.state.bodies, slots, len(pairs), solver)
    first, last = add_all(slots, len(pairs))
    queue = deque(range(len(pairs)))
    for i in moves:
        if i == 0:
            assert first == (queue[0] if queue else END)
            if queue:
                queue.popleft()
                first, last = take_first(slots, first, last)
        elif any(i in pair for pair in pairs):
            queue.extend(k for k, pair in enumerate(pairs) if i in pair and k not in queue)
            first, last = add_contacts(slots, i, solver.first_impact[i], first, last)
    while queue:
        assert first == queue.popleft()
        first, last = take_first(slots, first, last)
    assert (first, last) == (END, END)

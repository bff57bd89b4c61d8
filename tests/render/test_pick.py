from __future__ import annotations

from hypothesis import example, given
from hypothesis import strategies as st

from sandbox.render.frame import capture
from sandbox.render.pick import pick
from sandbox.world.records import DYNAMIC
from tests.render.naive import distance, topmost
from tests.render.stages import zoo

STATE = zoo()
FRAME = capture(STATE)
x_values, y_values = st.floats(-8, 8), st.floats(-1, 5)


@given(x_values, y_values)
@example(-4.5, 0.8)
def test_pick_finds_the_topmost_dynamic_body(x: float, y: float) -> None:
    assert pick(FRAME, (x, y)) == topmost(STATE, x, y)


@given(x_values, y_values, st.floats(0.01, 0.5))
def test_pick_with_slack_takes_the_nearest_body(x: float, y: float, slack: float) -> None:
    inside = topmost(STATE, x, y)
    near = {
        int(STATE.shapes[i].body): distance(STATE, i, x, y)
        for i in reversed(range(len(STATE.shapes)))
        if STATE.bodies[STATE.shapes[i].body].type == DYNAMIC
    }
    for i in range(len(STATE.shapes)):
        body = int(STATE.shapes[i].body)
        if body in near:
            near[body] = min(near[body], distance(STATE, i, x, y))
    best = min(near.values())
    got = pick(FRAME, (x, y), slack)
    if inside is not None:
        assert got == inside
    elif best < slack - 1e-9:
        assert got is not None
        assert near[got] < best + 1e-9
    elif best > slack + 1e-9:
        assert got is None


def test_static_and_kinematic_bodies_are_not_picked() -> None:
    assert pick(FRAME, (-7.5, -0.5)) is None
    assert pick(FRAME, (6.5, 2.7)) is None

"""What is made of parts that lie over each other touches wherever the outermost of them does."""

from __future__ import annotations

import math
from typing import Any

from hypothesis import example, given
from hypothesis import strategies as st

from sandbox import Scene, SetPose, World
from tests.examples import examples

DEEP = 0.004
"""How far (m) the two overlap: less than a hundredth of the smallest part's width."""
FLOOR = {"id": "floor", "shapes": [{"box": [40, 2]}]}

offsets = st.floats(-0.5, 0.5)
parts = st.one_of(
    st.builds(lambda x, y, r: {"capsule": [[-x, -y], [x, y]], "radius": r}, st.floats(0.1, 0.4), offsets,
              st.floats(0.1, 0.3)),
    st.builds(lambda w, h: {"box": [w, h]}, st.floats(0.2, 0.9), st.floats(0.2, 0.9)),
    st.just({"polygon": [[0, 0], [0.6, 0], [0.6, 0.6], [0.3, 0.2], [0, 0.6]]}),
    st.just({"polygon": [[-0.3, -0.2], [0.4, -0.1], [0, 0.4]], "radius": 0.07}),
    st.just({"circle": 0.3}),
)  # fmt: skip
placed = st.builds(
    lambda part, at, turn: {**part, "at": at} | ({} if "circle" in part else {"angle": turn}),
    parts, st.tuples(offsets, offsets).map(list), st.floats(-90, 90),
)  # fmt: skip
CROSSED = [
    {"capsule": [[-0.1105, 0], [0.1105, -0.085]], "radius": 0.288},
    {"polygon": [[-0.4398, -0.1635], [0.3615, -0.2991], [0.0783, 0.4626]]},
]


@given(st.lists(placed, min_size=2, max_size=3), st.floats(-math.pi, math.pi), st.booleans())
@example(CROSSED, math.radians(130.0), False)
@example(CROSSED, math.radians(130.0), True)
@examples(100)
def test_a_floor_meets_the_outermost_part(shapes: list[dict[str, Any]], angle: float, turned_round: bool):
    """Whichever of the two is static."""
    kinds = ["static", "dynamic"][:: -1 if turned_round else 1]
    floor, body = {**FLOOR, "type": kinds[0]}, {"id": "body", "type": kinds[1], "shapes": shapes, "position": [0, 5]}
    world = World(Scene(bodies=[floor, body], gravity=[0, 0]))
    world.apply(SetPose("body", (0.0, 5.0), angle))
    gap = world.query.distance("floor", "body").distance
    world.apply(SetPose("floor", (0.0, gap + DEEP), 0.0))
    world.step()
    assert any(contact.normal_y > 0.999 for contact in world.contacts)

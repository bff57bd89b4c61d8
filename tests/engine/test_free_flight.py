"""Bodies in free flight take their substeps on their own: it makes no difference to them that others do not."""

from __future__ import annotations

import pytest

from sandbox import Scene, StartDrag, World
from sandbox.tables import plain

FLYING = [
    {
        "id": f"b{k}", "shapes": [{"box": [1, 0.4]}], "position": [9.0 * k, 0], "velocity": [k - 2.0, 3],
        "angular_velocity": 400.0 * k, "linear_damping": 0.3 * k, "angular_damping": 0.1,
    }
    for k in range(5)
]  # fmt: skip
BALL = {"id": "ball", "shapes": [{"circle": 0.5}], "position": [-50, 0]}
HELD = {
    "nobody else": [],
    "one that bounces": [{**BALL, "shapes": [{"circle": 0.5, "restitution": 0.9}]}],
    "one that lies": [BALL],
}
FLOOR = {"id": "floor", "type": "static", "shapes": [{"box": [4, 1]}], "position": [-50, -1]}


def flown(others: list[dict[str, object]], dragged: bool) -> bytes:
    """The bits of the bodies in flight after some steps; while one is dragged, all go through each substep together."""
    world = World(Scene(bodies=[*FLYING, FLOOR, {**BALL, "id": "toy", "position": [-90, 0]}, *others]))
    if dragged:
        world.apply(StartDrag("toy", (-90.0, 3.0)))
    world.state.bodies.velocity_x[len(FLYING) - 1] = 1.01e7  # is slowed down on its way, whoever else is there
    world.step(40)
    rows = [world.directory.body(f"b{k}") for k in range(len(FLYING))]
    return plain(world.state.bodies)[rows].tobytes()


@pytest.mark.parametrize("others", HELD.values(), ids=HELD.keys())
def test_free_bodies_fly_the_same_alone_and_together(others):
    assert flown(others, dragged=False) == flown(others, dragged=True)

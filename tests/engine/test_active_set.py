"""Who comes is put into the lists of what a step looks at, and nobody else is looked at for it."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import Delete, Spawn
from sandbox.engine.world import World
from tests.examples import examples

GROUND: dict[str, Any] = {"id": "ground", "type": "static", "shapes": [{"box": [60, 1]}], "position": [0, -0.5]}
KINDS = ("ball", "pair", "sleeper", "tile", "goal", "platform")


def entry(kind: str, number: int) -> dict[str, Any]:
    """A body of that kind, beside the others and near the ground."""
    name, place = f"{kind}-{number}", [float(3 * (number % 15) - 20), 0.6 + 0.2 * (number % 3)]
    return {
        "ball": {"id": name, "shapes": [{"circle": 0.5}], "position": place, "velocity": [4, 0]},
        "pair": {"id": name, "shapes": [{"box": [1, 0.5]}, {"circle": 0.4}], "position": place},
        "sleeper": {"id": name, "shapes": [{"circle": 0.4}], "position": [place[0], 0.4]},
        "tile": {"id": name, "type": "static", "shapes": [{"box": [1, 1]}], "position": [float(number), 0.5]},
        "goal": {"id": name, "type": "static", "shapes": [{"box": [2, 2], "sensor": True}], "position": place},
        "platform": {"id": name, "type": "kinematic", "shapes": [{"box": [2, 0.2]}], "position": [place[0], 2.0],
                     "velocity": [1, 0]},
    }[kind]  # fmt: skip


def check(world: World) -> None:
    """The lists hold everybody once, in the order that they promise."""
    active, shapes = world.scratch.active, world.state.shapes
    info, count = active.info[0], len(shapes)
    activity = active.activity[shapes.body]
    order = active.shapes[:count]
    assert sorted(order.tolist()) == list(range(count))
    loose = np.flatnonzero(activity != 0)
    assert active.loose_shapes[: info.loose].tolist() == loose.tolist()
    assert order[: info.moving].tolist() == np.flatnonzero(activity == 1).tolist()
    assert sorted(order[: info.loose].tolist()) == loose.tolist()
    assert info.static == (np.asarray(world.state.bodies.type) == 0).sum()
    listed = active.loose[1 : 1 + active.loose[0]]
    assert listed.tolist() == np.flatnonzero(active.activity[: len(world.names)]).tolist()


@examples(150)
@given(st.lists(st.tuples(st.sampled_from((*KINDS, "delete", "steps")), st.integers(0, 40)), max_size=25))
def test_it_goes_on_as_if_everybody_had_been_looked_at(changes):
    one, two = (World(sandbox.Scene(bodies=[GROUND])) for _ in range(2))
    for turn, (what, number) in enumerate(changes):
        for world in (one, two):
            if what == "steps":
                world.step(number)
            elif what != "delete":
                world.apply(Spawn(entry(what, 50 * turn + number)))
            elif len(world.names) > 1:
                world.apply(Delete(world.names[1 + number % (len(world.names) - 1)]))
        two._stepper.forget()
        for world in (one, two):
            world.step()
            check(world)
        assert one.digest() == two.digest()


def test_for_dynamic_bodies_nobody_is_looked_at_who_stays():
    world = World(sandbox.Scene(bodies=[GROUND, entry("tile", 3), entry("ball", 1)]))
    world.apply(Spawn(entry("ball", 5)))  # memory for more of them, of which all is new
    world.step(2)
    info = world.scratch.active.info[0]
    before = info.fixed_generation
    for number, kind in enumerate(("ball", "pair", "sleeper", "ball")):
        world.apply(Spawn([entry(kind, 50 * number + 10), entry(kind, 50 * number + 11)]))
        if number < 2:
            world.step(3)
    world.step(3)
    assert info.fixed_generation == before
    check(world)
    world.apply(Spawn(entry("tile", 7)))
    world.step()
    assert info.fixed_generation > before
    check(world)

"""Springs of contacts bear what is put down without sinking, and keep their loads where substeps become shorter."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.tables import plain
from tests.flat import body, box, circle, ground, world


def _tower(heavy: float = 1.0) -> World:
    light = [body(f"b{k}", box(1.0, 1.0, friction=0.6), position=(0.0, k + 0.5)) for k in range(5)]
    return world(ground(friction=0.6), *light, body("top", box(1.0, 1.0, density=heavy), position=(0.0, 5.5)))


def _energy(w: World) -> float:
    """Of what moves, J."""
    bodies = plain(w.state.bodies)
    moves = bodies["inverse_mass"] > 0.0
    speeds = bodies["velocity_x"] ** 2 + bodies["velocity_y"] ** 2
    return float((bodies["mass"] * (0.5 * speeds + 10.0 * bodies["center_y"]))[moves].sum())


@pytest.mark.parametrize("heavy", [1.0, 20.0, 400.0])
def test_what_is_put_down_stays_where_it_was_put(heavy):
    w = _tower(heavy)
    w.step(120)
    for k in range(5):
        assert w.body(f"b{k}").position == pytest.approx((0.0, k + 0.5), abs=2e-9 * (1.0 + heavy))


def test_what_has_sunk_already_is_not_raised():
    """A scene taken from a world in which springs bear by sinking, as they do below what has fallen."""
    w = world(ground(), body("box", box(1.0, 1.0), position=(0.0, 0.51)))
    w.step(120)
    sunk = w.body("box").position[1]
    again = world(ground(), body("box", box(1.0, 1.0), position=(0.0, sunk)))
    again.step(120)
    assert sunk < 0.5
    assert again.body("box").position[1] == pytest.approx(sunk, abs=1e-8)


def test_a_spring_forgets_a_load_that_is_gone():
    """What is left is thrown up no higher than springs without a length would throw it, which had sunk by as much."""
    w = _tower(20.0)
    w.step(2)
    w.delete("top")
    highest = 0.0
    for _ in range(90):
        w.step()
        highest = max(highest, w.body("b4").position[1])
    assert highest < 4.5 + 0.04
    assert w.body("b4").position[1] == pytest.approx(4.5, abs=3e-3)


def test_a_heap_that_begins_to_take_shorter_substeps_is_not_thrown_up():
    """A heavy disc is put on a heap that has come to rest: the springs get stiffer, what they have sunk by stays."""
    random = np.random.default_rng(3)
    walls = [body(f"wall-{x}", box(1.0, 30.0), type="static", position=(x, 15.0)) for x in (-5.5, 5.5)]
    discs = []
    for k in range(320):
        place = (-4.5 + 0.6 * (k % 16) + random.uniform(-0.05, 0.05), 0.3 + 0.6 * (k // 16))
        discs.append(body(f"d{k}", circle(0.25), position=place))
    w = world(ground(), *walls, *discs)
    w.step(400)
    top = max(w.body(f"d{k}").position[1] for k in range(320))
    w.spawn({"id": "heavy", "position": [0.0, top + 1.3], "shapes": [{"circle": 1.0, "density": 200.0}]})
    levels, rises, last = set(), 0.0, _energy(w)
    for _ in range(40):
        w.step()
        energy = _energy(w)
        levels |= set(plain(w.state.contacts)["substep_level"][: int(w.state.counters[0].contact_count)].tolist())
        rises, last = rises + max(0.0, energy - last), energy
    assert max(levels) > 0
    assert rises < 1.0

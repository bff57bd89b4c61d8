"""Too many bodies in one place are refused with one clear message, before memory is taken, and nothing has changed."""

from __future__ import annotations

import math

import pytest

import sandbox
from sandbox import CapacityError, CommandError, Delete, Spawn
from sandbox.engine.memory import limit
from sandbox.engine.world import World
from sandbox.world.records import CONTACT
from tests.flat import body, box, circle, polygon, scene, world


def pile(count: int) -> World:
    """Discs in one place."""
    return world(*(body(f"{k}", circle(0.5)) for k in range(count)))


def test_a_pile_with_too_many_pairs():
    w = pile(4000)
    before, room = w.state.bodies.tobytes(), len(w.scratch.grid.pairs)
    digest = w.digest()
    with pytest.raises(CapacityError, match=r"7,998,000 pairs .* needs .* GB of tables; the limit is 4\.3 GB"):
        w.step()
    assert (w.digest(), w.state.bodies.tobytes(), w.step_count) == (digest, before, 0)
    assert len(w.scratch.grid.pairs) == room
    assert [*w.events] == []
    w.apply(Delete([f"{k}" for k in range(10, 4000)]))
    same = pile(10)
    w.step(5)
    same.step(5)
    assert w.digest() == same.digest()


def test_fields_push_once_where_a_step_is_refused(monkeypatch):
    water = sandbox.Scene(regions=[{"water": 1, "surface": 0, "inside": [-9, -9, 9, 9]}]).flatten().regions
    discs = [body(f"{k}", circle(0.5)) for k in range(1100)]
    w, same = World(scene(*discs, regions=water)), World(scene(*discs, regions=water))
    monkeypatch.setattr(limit, "MAX_STEP_BYTES", 10**6)
    before = w.state.bodies.tobytes()
    with pytest.raises(CapacityError):
        w.step()
    assert w.state.bodies.tobytes() == before
    monkeypatch.undo()
    for each in (w, same):
        each.apply(Delete([f"{k}" for k in range(20, 1100)]))
        each.step(2)
    assert w.digest() == same.digest()


def test_room_that_would_be_too_much_is_what_is_needed():
    most = next(k for k in range(10**6, 10**8, 10**4) if limit.step_bytes(k) > limit.MAX_STEP_BYTES) - 10**4
    assert limit.room_for(most) == most
    assert limit.room_for(1000) == 1500


def test_more_pairs_take_memory_for_pairs_alone():
    """What is known of bodies and joints stays, and the bits are those of a world that had room from the start."""
    discs = [{"id": f"{k}", "position": [0.03 * k, 0.06 * k], "shapes": [{"circle": 0.5}]} for k in range(20)]
    pin = {"id": "pin", "type": "revolute", "bodies": [None, "3"], "anchor": [0.09, 0.18]}
    w, same = (World(sandbox.Scene(bodies=discs, joints=[pin])) for _ in range(2))
    same.state.contacts = CONTACT.zeros(1000)
    same._stepper.renew()
    joints, solver, room = w.scratch.joints, w.scratch.solver, len(w.scratch.grid.pairs)
    w.step(3)
    same.step(3)
    assert len(w.scratch.grid.pairs) > room
    assert w.scratch.joints is joints
    assert w.scratch.solver is solver
    assert w.digest() == same.digest()


def test_static_tiles_in_one_place_are_refused_before_they_are_gone_through():
    """Beside each other, as many are no trouble. Those with more corners are refused before."""
    tiles = [body(f"{k}", box(1.0, 1.0), type="static", angle=0.01 * k) for k in range(1600)]
    with pytest.raises(
        CapacityError, match=r"1,600 polygons and lines .* 40,960,000 pairs of edges, of which 18,560,000 may"
    ):
        World(scene(*tiles))
    beside = [body(f"{k}", box(1.0, 1.0), type="static", position=(float(k % 40), float(k // 40))) for k in range(1600)]
    assert len(World(scene(*beside)).state.bodies) == 1600


def test_tiles_with_many_corners_count_for_more():
    around = [(math.cos(k * math.pi / 32), math.sin(k * math.pi / 32)) for k in range(64)]
    tiles = [body(f"{k}", polygon(*around), type="static") for k in range(400)]
    with pytest.raises(
        CapacityError, match=r"400 polygons and lines .* 655,360,000 pairs of edges, of which 179,840,000 may"
    ):
        World(scene(*tiles))


@pytest.mark.slow
def test_static_tiles_that_come_into_a_crowd_are_refused_and_nothing_has_changed():
    """All at once, or in parts beside those that are there; elsewhere they are welcome."""

    def spawn(first: int, count: int, x: float = 0.0) -> Spawn:
        shape = {"box": [1, 1]}
        return Spawn(
            [{"id": f"{first + k}", "type": "static", "position": [x, 0], "shapes": [shape]} for k in range(count)]
        )

    w = World(sandbox.Scene(bodies=[{"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 3]}]))
    w.apply(spawn(0, 900))
    before = w.snapshot()
    for count in (900, 20_000):
        with pytest.raises(CommandError, match=r"Spawn: .* polygons and lines .* Too many are in one place"):
            w.apply(spawn(1000, count))
        assert w.snapshot() == before
        assert len(w.names) == 901
    w.apply(spawn(1000, 600, 50.0))
    assert len(w.names) == 1501
    w.step(3)

"""What the switches of the contact solver do in the engine, beside the simple solver, which reads as it works."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.reference.simple.world import SimpleWorld
from sandbox.scene.flat import FlatScene, FlatSettings
from tests import flat


def settings(**off: bool) -> FlatSettings:
    """Awake, with techniques switched."""
    return FlatSettings(sleeping=False, **off)


def tower(count: int, **off: bool) -> FlatScene:
    """Crates on top of each other."""
    crates = [flat.body(f"crate-{k}", flat.box(1, 1), position=(0.0, 0.5 + k)) for k in range(count)]
    return flat.scene(flat.ground(), *crates, settings=settings(**off))


def top(world: World) -> float:
    return float(world.state.bodies.center_y.max())


def test_a_tower_sinks_that_begins_with_nothing_in_every_substep() -> None:
    tops = []
    for off in ({}, {"warm_starting": False}, {"accumulate": False}):
        world = World(tower(10, **off))
        world.step(60)
        tops.append(top(world))
    assert tops[0] > 9.485
    assert max(tops[1:]) < 9.465


def test_relaxing_takes_back_the_speed_of_the_push() -> None:
    speeds = []
    for relax in (True, False):
        sunk = flat.body("crate", flat.box(1, 1), position=(0.0, 0.3))
        world = World(flat.scene(flat.ground(), sunk, settings=settings(relax=relax), gravity=(0.0, 0.0)))
        world.step(2)
        speeds.append(float(world.state.bodies.velocity_y[1]))
    assert speeds[0] == pytest.approx(0.0, abs=1e-3)
    assert speeds[1] > 1.0


def test_a_rigid_contact_takes_back_a_fifth_of_the_overlap_in_a_substep() -> None:
    sunk = flat.body("crate", flat.box(1, 1), position=(0.0, 0.49), fixed_rotation=True)
    world = World(flat.scene(flat.ground(), sunk, settings=settings(soft=False), gravity=(0.0, 0.0)))
    world.step()
    assert 0.5 - float(world.state.bodies.center_y[1]) == pytest.approx(0.01 * 0.8**4, rel=1e-6)


def test_without_speculation_moving_bodies_pass_through_each_other() -> None:
    places = []
    for speculative in (True, False):
        plate = flat.body("plate", flat.box(0.1, 4), position=(0.0, 0.0))
        ball = flat.body("ball", flat.circle(0.2), position=(-5.0, 0.0), velocity=(100.0, 0.0))
        world = World(flat.scene(plate, ball, settings=settings(speculative=speculative), gravity=(0.0, 0.0)))
        world.step(10)
        plate_x, ball_x = world.state.bodies.center_x.tolist()
        places.append(ball_x < plate_x)
    assert places == [True, False]


def test_points_clamped_one_by_one_turn_a_crate_on_a_post_unless_both_are_treated_alike() -> None:
    """Two points nearer to each other than the corners: in turn, as the simple solver has them, they push too hard."""

    def spin(start: type[World] | type[SimpleWorld], accumulate: bool) -> float:
        post = flat.body("post", flat.box(0.5, 2, (0.0, -1.0)), type="static")
        crate = flat.body("crate", flat.box(1, 1), position=(0.0, 0.5))
        world = start(flat.scene(post, crate, settings=settings(accumulate=accumulate)))
        fastest = 0.0
        for _ in range(30):
            world.step()
            rows = world.state.bodies if isinstance(world, World) else world.records()
            fastest = max(fastest, abs(float(rows.angular_velocity[1])))
        return fastest

    assert spin(SimpleWorld, True) < 2e-3 < 4e-3 < spin(SimpleWorld, False)
    assert spin(World, True) == spin(World, False) == 0.0


@pytest.mark.parametrize("name", ["warm_starting", "accumulate", "soft", "relax", "speculative"])
def test_engine_and_simple_solver_do_the_same_without(name: str) -> None:
    """One crate with a spin, landing on another: the two hardly differ within half a second."""

    def scene(**off: bool) -> FlatScene:
        low = flat.body("low", flat.box(1, 1), position=(0.0, 0.5))
        high = flat.body("high", flat.box(1, 1), position=(0.1, 1.55), velocity=(0.3, 0.0))
        return flat.scene(flat.ground(), low, high, settings=settings(**off))

    world, simple = World(scene(**{name: False})), SimpleWorld(scene(**{name: False}))
    world.step(30)
    simple.step(30)
    rows = simple.records()
    assert np.abs(world.state.bodies.center_y - rows.center_y).max() < 0.01
    assert np.abs(world.state.bodies.angle - rows.angle).max() < 0.02


def test_switches_leave_the_digest_of_a_scene_alone_until_they_work() -> None:
    start = World(tower(2)).digest()
    for name in ("warm_starting", "accumulate", "soft", "relax", "speculative"):
        world = World(tower(2, **{name: False}))
        assert world.digest() == start
        world.step(2)
        ours = World(tower(2))
        ours.step(2)
        if name in ("warm_starting", "accumulate", "soft", "relax"):
            assert world.digest() != ours.digest()


def test_a_snapshot_holds_the_switches() -> None:
    cold, warm = World(tower(3, warm_starting=False)), World(tower(3))
    cold.step(5)
    warm.restore(cold.snapshot())
    warm.step(5)
    cold.step(5)
    assert warm.digest() == cold.digest()

"""Whom impacts without restitution reach: far where they concern few bodies, and only hard ones elsewhere."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.contact_solver.closing_speed import HARD, SLOW
from sandbox.engine.records.ccd import STRUCK
from sandbox.engine.restitution.struck import FEW
from sandbox.engine.world import World
from tests.flat import body, box, ground, scene


def reached(world: World) -> set[str]:
    """The bodies that impacts of the last step have reached."""
    bits = world.scratch.solver.ccd["unsettled"] & STRUCK
    return {name for name, struck in zip(world.names, bits, strict=False) if struck}


def impact_speed(world: World) -> float:
    return float(world.scratch.active.info[0]["impact_speed"])


def landing(count: int, speed: float, restitution: float = 0.0) -> World:
    """So many boxes apart from each other that reach the ground in the first step, one on the other in pairs."""
    shape = box(1.0, 1.0, restitution=restitution)
    boxes = [
        body(f"b{k}", shape, position=(3.0 * (k // 2), 0.501 + k % 2), velocity=(0.0, -speed)) for k in range(count)
    ]
    return World(scene(ground(1e4), *boxes))


@pytest.mark.parametrize("height", [3, 10, 30])
def test_a_blow_on_a_stack_is_followed_to_its_foot(height):
    stack = [body(f"b{k}", box(1.0, 1.0), position=(0.0, 0.5 + k)) for k in range(height)]
    falling = body("falling", box(1.0, 1.0), position=(0.0, height + 0.5 + 1e-3), velocity=(0.0, -1.5))
    world = World(scene(ground(100.0), *stack, falling))
    world.step()
    assert reached(world) == {"falling", *(each.id for each in stack)}
    assert impact_speed(world) == SLOW


def test_it_ends_where_it_would_close_in_too_slowly():
    """Of 0.3 m/s the tenth box would get 0.3 / 11, the twentieth 0.3 / 21."""
    row = [body(f"b{k}", box(1.0, 1.0), position=(float(k), 0.0)) for k in range(30)]
    striking = body("striking", box(1.0, 1.0), position=(-1.001, 0.0), velocity=(0.3, 0.0))
    world = World(scene(striking, *row, gravity=(0.0, 0.0)))
    world.step()
    assert {"striking", "b9"} <= reached(world)
    assert "b20" not in reached(world)


@pytest.mark.parametrize(("speed", "struck"), [(0.5 * SLOW, 0), (1.0, 0), (1.5 * HARD, 2 * FEW)])
def test_where_many_are_reached_only_hard_blows_count(speed, struck):
    world = landing(2 * FEW, speed)
    world.step()
    assert len(reached(world)) == struck
    assert impact_speed(world) == (SLOW if speed < SLOW else HARD)


@pytest.mark.parametrize(("count", "struck"), [(FEW, FEW), (FEW + 1, 0), (FEW + 2, 0)])
def test_few_are_so_many(count, struck):
    world = landing(count, 1.0)
    world.step()
    assert len(reached(world)) == struck


def test_what_bounces_is_left_to_the_law_of_restitution():
    world = landing(4, 1.0, restitution=0.5)
    world.step()
    assert not reached(world)


def test_a_look_that_is_given_up_leaves_nobody_flagged():
    world = landing(20 * FEW, 1.0)
    for _ in range(3):
        world.step()
        assert not np.any(world.scratch.solver.ccd["unsettled"] & STRUCK)

"""`World.step(n)` takes many steps in one call: the same bits and the same last events as one step at a time."""

from __future__ import annotations

from dataclasses import fields

import pytest

import sandbox
from sandbox.engine.world import World
from tests.flat import FlatSettings, body, box, circle, ground, scene
from tests.shipped import FILES, shipped

AT_A_TIME = (1, 2, 3, 50, 5, 90)
SCENES = sorted(FILES)[::5]


def words_of(world: World) -> list[str]:
    """The events of the last step."""
    return [str(getattr(world.events, field.name)) for field in fields(world.events)]


def together(one_by_one: World, at_once: World, steps: int) -> None:
    """Steps of both end alike."""
    at_once.step(steps)
    for _ in range(steps):
        one_by_one.step()
    assert at_once.step_count == one_by_one.step_count
    assert at_once.digest() == one_by_one.digest()
    assert words_of(at_once) == words_of(one_by_one)
    assert at_once.contact_impulses.tolist() == one_by_one.contact_impulses.tolist()


@pytest.mark.parametrize("name", SCENES)
def test_shipped_scenes(name: str) -> None:
    worlds = World(shipped(name)), World(shipped(name))
    for steps in AT_A_TIME:
        together(*worlds, steps)


def test_what_commands_did_before_many_steps_is_no_news_to_the_last_of_them() -> None:
    parts = scene(ground(), body("a", box(1.0, 1.0), position=(0.0, 0.5)), body("b", circle(0.5), position=(0.0, 1.5)))
    worlds = World(parts), World(parts)
    together(*worlds, 10)
    for world in worlds:
        world.apply(sandbox.Delete("b"))
        world.apply(sandbox.SetPose("a", (0.0, 3.0), 0.0))
    together(*worlds, 2)


def test_all_fall_asleep_and_are_woken_in_the_midst() -> None:
    parts = scene(ground(), body("a", box(1.0, 1.0), position=(0.0, 0.5)), settings=FlatSettings())
    worlds = World(parts), World(parts)
    together(*worlds, 200)
    assert worlds[0].awake_count == 0
    for world in worlds:
        world.apply(sandbox.SetVelocity("a", (0.0, 3.0), 0.0))
    together(*worlds, 300)
    assert worlds[0].awake_count == 0


def test_memory_runs_out_in_the_midst() -> None:
    """Discs that fall into one place have more and more pairs."""
    discs = [body(f"d{k}", circle(0.5), position=(0.001 * k, 3.0 * (k % 8))) for k in range(64)]
    wall = [body(f"w{k}", box(1.0, 40.0), type="static", position=(2.0 * k - 1.0, 10.0)) for k in (0, 1)]
    worlds = World(scene(ground(), *wall, *discs)), World(scene(ground(), *wall, *discs))
    together(*worlds, 120)


def test_what_sensors_felt_earlier_is_no_event_of_the_last_step() -> None:
    gate = body("gate", box(4.0, 1.0, sensor=True), type="static")
    parts = scene(gate, body("ball", circle(0.2), position=(0.0, 1.0)))
    worlds = World(parts), World(parts)
    together(*worlds, 15)  # it enters
    together(*worlds, 40)  # and leaves


def test_workers_share_steps_of_many_bodies() -> None:
    many = [body(f"b{k}", box(1.0, 1.0), position=(1.5 * (k % 200), 0.5 + 1.01 * (k // 200))) for k in range(5000)]
    parts = scene(ground(1000.0), *many)
    worlds = World(parts), World(parts, workers=2)
    together(*worlds, 5)

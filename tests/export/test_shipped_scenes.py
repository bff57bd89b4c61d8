"""Shipped scenes that have run, made scenes again: they begin as the worlds were, and go on like them."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import World, scene_of
from tests.examples import examples
from tests.export.worlds import apart, difference, forgetful, saved
from tests.shipped import FILES, shipped

MOST = 500
LOOK = 8
"""Piles are looked at every so many steps, counted from the first one of the scene."""
TO_THE_BIT = [
    "bouncing-balls", "newtons-cradle", "three-to-one", "harbour", "planets", "rocket", "ramp",
    "rolling-hills", "tiles", "billiards", "bullets", "parachutes", "filters",
    "on-a-post", "three-balls", "mixed-towers", "pyramid-10", "stack-12", "one-way", "far-away", "matchboxes",
]  # fmt: skip
"""Scenes without joints in which a rounding stays one: no edge is as good as another, and nothing is about to slip."""
JOINTED = ["wind-tunnel", "gears-and-pulley", "pendulums", "cantilevers", "cart"]


@cache
def small() -> list[str]:
    """The names of scenes that are quickly run."""
    return [name for name in FILES if len(shipped(name).flatten().bodies) <= MOST]


@pytest.mark.parametrize("name", FILES)
def test_at_the_start_it_is_the_scene_of_the_author(name: str) -> None:
    scene = shipped(name)
    found = scene_of(World(scene))
    assert found.scene is scene
    assert found.remarks == ()


@pytest.mark.parametrize("name", ["lift", "drawbridge", "avalanche", "air-hockey", "marble-clock", "breakout", "siege"])
def test_what_is_played_is_a_scene_at_any_moment(name: str, tmp_path: Path) -> None:
    """Gates and lifts on their way, bricks that are gone, joints that broke, a ball that went down the pit."""
    world = World(shipped(name))
    for _ in range(3):
        world.step(40)
        _, other = saved(world, tmp_path)
        assert difference(world, other) < 1e-12
        assert dict(world.counters) == dict(other.counters)


@given(st.data())
@examples(60)
def test_it_begins_as_the_world_was(data: st.DataObject) -> None:
    """Poses and velocities differ by what degrees and the way from a centre to an origin round off."""
    world = World(shipped(data.draw(st.sampled_from(small()))))
    world.step(data.draw(st.integers(1, 150)))
    with TemporaryDirectory() as folder:
        found, other = saved(world, Path(folder))
    assert sorted(other.names) == sorted(world.names)
    assert difference(world, other) < 1e-12
    there = {joint.id for joint in world.joints if not joint.broken}
    assert {joint.id for joint in other.joints} == there
    author = world.scene
    assert (found.scene.materials, found.scene.prefabs, found.scene.view) == (
        author.materials, author.prefabs, author.view,
    )  # fmt: skip
    assert scene_of(other).scene is other.scene


@given(st.sampled_from(TO_THE_BIT), st.integers(1, 15))
@examples(25)
def test_without_joints_it_goes_on_as_a_world_that_has_forgotten_its_contacts(name: str, looks: int) -> None:
    """The bodies come to within rounding, for 30 steps: nothing else is lost than impulses and sleep."""
    world = World(shipped(name))
    world.step(LOOK * looks)
    with TemporaryDirectory() as folder:
        _, other = saved(world, Path(folder))
    twin = forgetful(world)
    for _ in range(6):
        twin.step(5)
        other.step(5)
        assert apart(twin, other) < 1e-9


@given(st.sampled_from(JOINTED), st.integers(1, 15))
@examples(20)
def test_with_joints_it_goes_on_nearly_so(name: str, looks: int) -> None:
    """What joints are off by is lost too: up to 1e-4 m here, and a cart on a slope bounces otherwise for that."""
    world = World(shipped(name))
    world.step(LOOK * looks)
    with TemporaryDirectory() as folder:
        _, other = saved(world, Path(folder))
    twin = forgetful(world)
    for _ in range(6):
        twin.step(5)
        other.step(5)
        assert apart(twin, other) < 5e-3

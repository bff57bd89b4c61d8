"""Left and right are alike: what is mirrored falls as the mirror shows it, and what is symmetric stays so."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape
from tests.examples import examples
from tests.flat import body, box, capsule, circle, ground, polygon, scene
from tests.physics.cards import house
from tests.physics.mirrored import mirror_error, mirrored

SURFACES = st.fixed_dictionaries(
    {"friction": st.sampled_from([0.0, 0.3, 0.7]), "restitution": st.sampled_from([0.0, 0.0, 0.6])}
)
SEEDS = st.integers(0, 10**6)
NUMBERS = st.floats(-1.0, 1.0).map(lambda x: round(x, 3))


@st.composite
def falling(draw: Any, kind: Callable[[Any], FlatShape], most: int) -> FlatScene:
    """A few bodies over a ground, near enough to meet each other on the way."""
    bodies: list[FlatBody] = [ground(60.0, **draw(SURFACES))]
    for k in range(draw(st.integers(1, most))):
        x, y, vx, vy, spin = (draw(NUMBERS) for _ in range(5))
        bodies.append(
            body(
                f"b{k}",
                kind(draw),
                position=(1.5 * x, 1.0 + 1.3 * k + 0.2 * y),
                velocity=(4.0 * vx, 3.0 * vy),
                angular_velocity=5.0 * spin,
            )
        )
    return scene(*bodies)


def disc(draw: Any) -> FlatShape:
    """Its contacts have one point."""
    return circle(0.3 + 0.2 * abs(draw(NUMBERS)), **draw(SURFACES))


def cornered(draw: Any) -> FlatShape:
    """A box, or a trapezium with rounded corners: their contacts have one point or two."""
    width, height = 0.5 + 0.3 * abs(draw(NUMBERS)), 0.4 + 0.3 * abs(draw(NUMBERS))
    if draw(st.booleans()):
        return box(width, height, **draw(SURFACES))
    outline = [(-0.5 * width, 0.0), (0.5 * width, 0.0), (0.3 * width, height), (-0.4 * width, height)]
    return polygon(*outline, radius=0.03, **draw(SURFACES))


@given(falling(disc, 8))
@examples(40)
def test_discs_that_are_mirrored_fall_mirrored(what):
    """Until rounding has grown: a bounce off a disc magnifies it several times."""
    assert _error_after(what, 60) < 1e-6


@given(falling(cornered, 1))
@examples(30)
def test_a_corner_that_is_mirrored_falls_mirrored(what):
    """It lands, tumbles and comes to lie; before, whichever of its two points was solved first turned it a little."""
    assert _error_after(what, 60) < 1e-9


@given(falling(cornered, 2))
@examples(30)
def test_corners_that_are_mirrored_fall_mirrored(what):
    assert _error_after(what, 60) < 1e-6


def overlapping(seed: int) -> FlatScene:
    """Two bodies with corners, without restitution, that overlap as they are put down and are pushed apart. Which way
    is no tie, which numbers that hypothesis likes would make it."""
    r = random.Random(seed)
    rough = {"friction": r.choice([0.3, 0.7])}
    shapes = [box(1.5, 0.5, **rough), polygon((-0.6, -0.45), (0.9, -0.3), (0.6, 1.05), **rough), box(0.6, 0.6, **rough)]
    place = r.uniform(-0.8, 0.8), r.uniform(-0.8, 0.8)
    return scene(
        body("a", r.choice(shapes), angle=r.uniform(-3.0, 3.0)),
        body("b", r.choice(shapes), position=place, angle=r.uniform(-3.0, 3.0)),
    )


@given(SEEDS, st.sampled_from([(0.0, 1e-13), (3.0, 7.0), (100.0, 50.0)]))
@examples(60)
def test_what_overlaps_parts_alike_wherever_it_is(seed, place):
    """What rounding leaves of the load of a contact that bears nothing must not say where its friction acts."""
    what = overlapping(seed)
    world, image = World(what), World(moved(what, place))
    world.step(10)
    image.step(10)
    for name in world.names:
        expected = np.add(world.body(name).position, place)
        assert image.body(name).position == pytest.approx(expected, abs=1e-8)


def moved(what: FlatScene, by: tuple[float, float]) -> FlatScene:
    """The same somewhere else."""
    bodies = (replace(each, position=(each.position[0] + by[0], each.position[1] + by[1])) for each in what.bodies)
    return replace(what, bodies=tuple(bodies))


@given(SEEDS)
@examples(60)
def test_what_overlaps_parts_mirrored(seed):
    assert _error_after(overlapping(seed), 10) < 1e-8


def tumbling(seed: int) -> FlatScene:
    """Bodies of any shape, thrown down on each other over a ground that may lean."""
    r = random.Random(seed)

    def shape() -> FlatShape:
        surface = {"friction": r.choice([0.0, 0.3, 0.6]), "rolling_resistance": r.choice([0.0, 0.0, 0.02])}
        kind = r.randrange(4)
        if kind == 0:
            return box(r.uniform(0.3, 1.2), r.uniform(0.3, 1.2), **surface)
        if kind == 1:
            return circle(r.uniform(0.2, 0.6), **surface)
        if kind == 2:
            return capsule(r.uniform(0.1, 0.5), r.uniform(0.1, 0.3), **surface)
        corners, size = r.randrange(3, 8), r.uniform(0.3, 0.7)
        turns = [2.0 * math.pi * (k + 0.3 * r.random()) / corners for k in range(corners)]
        return polygon(*((size * math.cos(turn), size * math.sin(turn)) for turn in turns), **surface)

    bodies = [replace(ground(60.0), angle=r.choice([0.0, 0.1, -0.12]))]
    for k in range(r.choice([2, 2, 3, 4])):
        speed = r.uniform(-2.0, 2.0), r.uniform(-4.0, 0.0)
        place, angle = (r.uniform(-0.5, 0.5), 1.2 + 1.3 * k), r.uniform(0.0, 6.3)
        bodies.append(body(f"b{k}", shape(), position=place, angle=angle, velocity=speed))
    return scene(*bodies)


@pytest.mark.parametrize(
    "seeds", [*(range(k, k + 15) for k in range(0, 120, 15)), (177, 221, 305, 326, 523, 918, 1177)]
)
def test_what_tumbles_goes_the_same_way_in_a_mirror_and_elsewhere(seeds):
    """Nothing is decided by rounding, or by which point, corner or side is called the first."""
    for seed in seeds:
        what = tumbling(seed)
        world, image, away = World(what), World(mirrored(what)), World(moved(what, (64.0, 0.0)))
        for each in (world, image, away):
            each.step(90)
        assert mirror_error(world, image) < 1e-7, seed
        for name in world.names:
            expected = np.add(world.body(name).position, (64.0, 0.0))
            assert away.body(name).position == pytest.approx(expected, abs=1e-7), seed


def _error_after(what: FlatScene, steps: int) -> float:
    world, image = World(what), World(mirrored(what))
    world.step(steps)
    image.step(steps)
    return mirror_error(world, image)


@pytest.mark.parametrize("friction", [0.6, 0.65, 0.7])
@pytest.mark.parametrize("levels", [2, 3, 4])
def test_a_house_of_cards_stands_as_it_landed(levels, friction):
    world = World(house(levels, friction, gap=1e-3))
    start = {name: world.body(name).position for name in world.names}
    world.step(600)
    assert max(math.dist(world.body(name).position, place) for name, place in start.items()) < 0.03

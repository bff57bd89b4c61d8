"""Left and right are alike: what is mirrored falls as the mirror shows it, and what is symmetric stays so."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatScene
from tests.examples import examples
from tests.flat import body, circle, ground, scene
from tests.physics.cards import house
from tests.physics.mirrored import mirror_error, mirrored

SURFACES = st.fixed_dictionaries(
    {"friction": st.sampled_from([0.0, 0.3, 0.7]), "restitution": st.sampled_from([0.0, 0.0, 0.6])}
)
NUMBERS = st.floats(-1.0, 1.0).map(lambda x: round(x, 3))


@st.composite
def falling(draw: Any) -> FlatScene:
    """A few discs over a ground, near enough to meet each other on the way: their contacts have one point each."""
    bodies: list[FlatBody] = [ground(60.0, **draw(SURFACES))]
    for k in range(draw(st.integers(2, 8))):
        x, y, vx, vy, spin = (draw(NUMBERS) for _ in range(5))
        bodies.append(
            body(
                f"b{k}",
                circle(0.3 + 0.2 * abs(draw(NUMBERS)), **draw(SURFACES)),
                position=(1.5 * x, 1.0 + 1.3 * k + 0.2 * y),
                velocity=(4.0 * vx, 3.0 * vy),
                angular_velocity=5.0 * spin,
            )
        )
    return scene(*bodies)


@given(falling())
@examples(60)
def test_what_is_mirrored_falls_mirrored(what):
    """Until rounding has grown: a bounce off a disc magnifies it several times."""
    world, image = World(what), World(mirrored(what))
    for _ in range(60):
        world.step()
        image.step()
    assert mirror_error(world, image) < 1e-6


@pytest.mark.parametrize("friction", [0.6, 0.65, 0.7])
@pytest.mark.parametrize("levels", [2, 3, 4])
def test_a_house_of_cards_stands_as_it_landed(levels, friction):
    world = World(house(levels, friction, gap=1e-3))
    start = {name: world.body(name).position for name in world.names}
    world.step(600)
    assert max(math.dist(world.body(name).position, place) for name, place in start.items()) < 0.03

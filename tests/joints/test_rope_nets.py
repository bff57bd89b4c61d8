"""Nets of ropes: which of them are taut changes all the time; drawn flat, they say nearly the same."""

from __future__ import annotations

import math

import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings
from tests.flat import body, circle
from tests.joints.jointed import energy, joint, jointed

SIDE = 0.3


def rope_net(across: int, down: int, held: tuple[int, ...], rate: int = 60, substeps: int = 4) -> World:
    """Discs of 50 g that hang from some of their first row, each on ropes to its neighbours as long as it lies apart; a
    stone flies into them."""
    at = {(c, r): (SIDE * c, -SIDE * r) for c in range(across) for r in range(down)}
    density = 0.05 / (math.pi * 0.01)
    knots = [body(f"{c}-{r}", circle(0.1, density=density, group=-1), position=place) for (c, r), place in at.items()]
    pairs = [(a, (a[0] + x, a[1] + y)) for a in at for x, y in ((1, 0), (0, 1)) if (a[0] + x, a[1] + y) in at]
    ropes = [
        joint(f"r{k}", "distance", f"{a[0]}-{a[1]}", f"{b[0]}-{b[1]}", anchor_a=at[a], anchor_b=at[b], upper=SIDE)
        for k, (a, b) in enumerate(pairs)
    ]
    pins = [joint(f"p{c}", "revolute", None, f"{c}-0", at[c, 0]) for c in held]
    stone = body("stone", circle(0.25, density=5.0), position=(-2.0, -0.5 * SIDE * down), velocity=(9.0, 2.0))
    settings = FlatSettings(step_rate=rate, substeps=substeps, sleeping=False)
    return jointed((*knots, stone), (*ropes, *pins), settings=settings)


def overrun(world: World) -> float:
    """How far (m) the longest rope is beyond its length."""
    return max(math.dist(*world.joint(f"r{k}").anchors) - SIDE for k in range(len(world.joint_names) - _pins(world)))


def _pins(world: World) -> int:
    return sum(name.startswith("p") for name in world.joint_names)


@pytest.mark.parametrize(
    ("across", "down", "held", "substeps"),
    [(7, 10, (0, 6), 4), (7, 10, tuple(range(7)), 4), (5, 14, (0, 2, 4), 8), (9, 6, (0, 8), 4)],
)
def test_a_net_of_ropes_holds_and_gains_no_energy(across, down, held, substeps):
    world = rope_net(across, down, held, substeps=substeps)
    most = energy(world) + 0.01
    longest = 0.0
    for _ in range(180):
        world.step()
        assert energy(world) < most
        longest = max(longest, overrun(world))
    assert longest < 0.01

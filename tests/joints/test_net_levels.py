"""Nets whose islands come to take finer substeps, as something heavy in them lies on something light."""

from __future__ import annotations

import random
from typing import Any

import pytest

from sandbox import Scene
from sandbox.engine.joints import part_layout
from sandbox.engine.world import World
from tests.joints.jointed import G, energy

LINKS: dict[str, dict[str, Any]] = {
    "stopped hinge": {"type": "revolute", "lower": -20, "upper": 20},
    "hinge": {"type": "revolute"},
    "slider": {"type": "prismatic", "lower": -0.1, "upper": 0.1},
}
SIDE = 6


def uneven_net(kind: str, seed: int) -> World:
    """Boxes of 1 g to 100 kg in a net that hangs by a corner and comes to lie on the floor."""
    choose = random.Random(seed)
    floor = {"id": "floor", "type": "static", "shapes": [{"box": [99, 2]}], "position": [0, -1]}
    floor = {"id": "floor", "type": "static", "shapes": [{"box": [99, 2]}], "position": [0, -1]}
    bodies: list[dict[str, Any]] = [floor]
    joints: list[dict[str, Any]] = []
    for x in range(SIDE):
        for y in range(SIDE):
            box = {"box": [0.7, 0.4], "density": 10 ** choose.uniform(-2, 2)}
            bodies.append({"id": f"{x}-{y}", "position": [x, 1 + y], "shapes": [box]})
            for a, b in ((x + 1, y), (x, y + 1)):
                if a < SIDE and b < SIDE:
                    link = dict(LINKS[kind], axis=[a - x, b - y]) if kind == "slider" else LINKS[kind]
                    ends = {"bodies": [f"{x}-{y}", f"{a}-{b}"], "anchor": [0.5 * (x + a), 1 + 0.5 * (y + b)]}
                    joints.append({"id": f"{x}-{y}:{a}-{b}", **link, **ends})
    joints.append({"id": "pin", "type": "revolute", "bodies": [f"0-{SIDE - 1}"], "anchor": [0, SIDE]})
    return World(Scene(bodies=bodies, joints=joints, settings={"sleeping": False}))


@pytest.mark.parametrize(
    ("kind", "seed"),
    [*(("hinge", n) for n in (1, 4, 8)), *(("stopped hinge", n) for n in (4, 8, 11)), ("slider", 4), ("slider", 8)],
)
def test_an_uneven_net_gains_no_energy(monkeypatch, kind, seed):
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -1000)
    world = uneven_net(kind, seed)
    fall = float(world.state.bodies.mass[1:].sum()) * G
    before = start = energy(world)
    levels = 0
    for _ in range(240):
        world.step()
        levels |= int(world.scratch.active.info[0].substep_levels)
        after = energy(world)
        assert after < before + 0.1 * fall
        assert after < start
        before = after
    assert levels > 1 or kind != "hinge"

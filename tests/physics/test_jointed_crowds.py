"""Jointed crowds thrown about in a closed box: impacts that joints pass on give them no energy, and lose nobody."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

import sandbox
from tests.physics.test_rattling import energy

Words = dict[str, Any]
HALF = 6.0
SIDE = 7
KINDS = ("weld", "revolute", "revolute", "stops", "distance", "rope", "slider")


def walls(surface: Words) -> Words:
    shapes = [{"box": [16, 2], "at": [0, s * (HALF + 1)], **surface} for s in (-1, 1)]
    shapes += [{"box": [2, 16], "at": [s * (HALF + 1), 0], **surface} for s in (-1, 1)]
    return {"id": "walls", "type": "static", "shapes": shapes}


def place(cell: int) -> list[float]:
    return [1.5 * (cell % SIDE) - 4.5, 1.5 * (cell // SIDE) - 4.5]


def tree(r: random.Random, count: int) -> tuple[list[int], list[tuple[int, int]]]:
    """Cells of a grid that hang together, and most of what joins them."""
    cells, joins = [r.randrange(SIDE * SIDE)], []
    while len(cells) < count:
        a = r.choice(cells)
        b = a + r.choice([1, -1, SIDE, -SIDE])
        same_row_or_column = b // SIDE == a // SIDE or b % SIDE == a % SIDE
        if 0 <= b < SIDE * SIDE and same_row_or_column and b not in cells:
            cells.append(b)
            if r.random() < 0.85:
                joins.append((a, b))
    return cells, joins


def thrown(r: random.Random, cell: int, surface: Words) -> Words:
    shape: Words = r.choice([
        {"circle": r.uniform(0.2, 0.6)},
        {"box": [r.uniform(0.3, 1.1), r.uniform(0.3, 1.1)]},
        {"capsule": [[-0.3, 0], [0.3, 0]], "radius": r.uniform(0.1, 0.3)},
    ])  # fmt: skip
    return {
        "id": f"b{cell}", "position": place(cell), "angle": r.choice([0, 0, 90]),
        "velocity": [r.uniform(-9, 9), r.uniform(-9, 9)], "angular_velocity": r.uniform(-300, 300),
        "shapes": [{**shape, "density": 10 ** r.uniform(-1, 1), **surface}],
    }  # fmt: skip


def join(r: random.Random, a: int, b: int, kinds: Sequence[str]) -> Words:
    (x, y), (u, v) = place(a), place(b)
    middle = [(x + u) / 2, (y + v) / 2]
    kind = r.choice(kinds)
    fields: Words = {
        "weld": {"type": "weld", "anchor": middle},
        "revolute": {"type": "revolute", "anchor": middle},
        "stops": {"type": "revolute", "anchor": middle, "lower": -30, "upper": 30},
        "distance": {"type": "distance", "anchors": [[x, y], [u, v]]},
        "rope": {"type": "distance", "anchors": [[x, y], [u, v]], "min": 0.5, "max": 1.6},
        "slider": {"type": "prismatic", "anchor": middle, "axis": [u - x, v - y], "lower": -0.5, "upper": 0.5},
    }[kind]
    return {"id": f"j{a}-{b}", "bodies": [f"b{a}", f"b{b}"], **fields}


def crowd(seed: int, kinds: Sequence[str] = KINDS, **surface: float) -> sandbox.World:
    """Up to 14 bodies of all kinds and masses; at times one of them is pinned to the world."""
    r = random.Random(seed)
    drawn = {"restitution": r.choice([1.0, 1.0, 0.9, 0.5, 0.2]), "friction": r.choice([0.0, 0.0, 0.3, 0.8])}
    surface = {**drawn, **surface}
    cells, joins = tree(r, r.randint(2, 14))
    bodies = [walls(surface), *(thrown(r, cell, surface) for cell in cells)]
    joints = [join(r, a, b, kinds) for a, b in joins]
    if r.random() < 0.3:
        pin = {"id": "pin", "type": "revolute", "bodies": [f"b{cells[0]}"], "anchor": place(cells[0])}
        joints.append(pin)
    return sandbox.World(sandbox.Scene(bodies=bodies, joints=joints, gravity=(0, 0), settings={"sleeping": False}))


@pytest.mark.parametrize("seed", range(40))
def test_a_jointed_crowd_gains_no_energy(seed):
    """No impact gives a tenth, of what there is after the first step, in which joints take what goes against them."""
    world = crowd(seed)
    world.step()
    first = last = energy(world)
    for step in range(2, 181):
        world.step()
        now = energy(world)
        struck = any(contact.impact_impulse > 0.0 for contact in world.contacts)
        assert not struck or now - last < 0.1 * first, f"step {step}"
        assert now < 1.1 * first, f"step {step}"
        last = now
    assert world.frozen == []
    at = world.state.bodies[1:]
    assert np.all(np.abs(at.center_x) < HALF + 0.5)
    assert np.all(np.abs(at.center_y) < HALF + 0.5)


def test_elastic_crowds_without_friction_keep_their_energy():
    """Half of them, to 2 %, through some tens of impacts; what joins them has no stops, which would take energy."""
    kept = []
    for seed in range(40):
        world = crowd(seed, ("weld", "revolute", "distance"), restitution=1.0, friction=0.0)
        world.step()
        before = energy(world)
        world.step(179)
        kept.append(energy(world) / before)
    assert max(kept) < 1.01
    assert np.median(kept) > 0.98

"""A box lands on others that bear it: without restitution it stays where it lands, and moves none of them."""

from __future__ import annotations

import math
from functools import cache

from sandbox.scene.flat import FlatScene
from tests.flat import body, box, ground, scene
from tests.physics.truth.experiment import RATE, Engine, G, experiment

ROWS = 5
RATIOS = (20.0, 100.0, 300.0)
"""Mass of the heavy box by that of a light one."""
HEIGHTS = tuple(0.5 + 3.5 * k / 12.0 for k in range(13))
"""Of the drop, m."""
MOVED = 0.3
"""Displacement (m) past which a box of 1 m no longer stands where it stood."""


def pyramid(rows: int, ratio: float, height: float, side: float = 1.0) -> FlatScene:
    """A pyramid of boxes of 1 m and 1 kg, and above its top a box of so many kg and metres."""
    light = [
        body(f"light-{row}-{k}", box(1.0, 1.0, friction=0.6), position=(k - 0.5 * (rows - 1 - row), row + 0.5))
        for row in range(rows)
        for k in range(rows - row)
    ]
    heavy = box(side, side, density=ratio / side**2, friction=0.6)
    return scene(ground(400.0), *light, body("heavy", heavy, position=(0.0, rows + height + 0.5 * side)))


def drop(start: Engine, rows: int, ratio: float, height: float, side: float = 1.0) -> tuple[float, float]:
    """Rebound speed by the speed of landing, and the largest displacement (m) of a light box after 2.5 s."""
    what = pyramid(rows, ratio, height, side)
    run = start(what)
    landing = math.sqrt(2.0 * G * height)
    rebound = 0.0
    landed = False
    for _ in range(5 * RATE // 2):
        run.step()
        speed = run.velocity("heavy")[1] / landing
        landed = landed or run.place("heavy")[1] < rows + 0.5 * side + 0.02
        rebound = max(rebound, speed) if landed else rebound
    begun = {each.id: each.position for each in what.bodies if each.id.startswith("light")}
    return rebound, max(math.dist(run.place(name), place) for name, place in begun.items())


@cache
def _drops(start: Engine) -> list[tuple[float, float]]:
    return [drop(start, ROWS, ratio, height) for ratio in RATIOS for height in HEIGHTS]


@experiment(
    "heavy box lands on a pyramid", "rebound to landing speed, 20 to 300 times the mass of its boxes", bound=0.03
)
def rebound_from_pyramid(start: Engine) -> float:
    """The mean over drops; without restitution it is nothing."""
    found = [rebound for rebound, _ in _drops(start)]
    return sum(found) / len(found)


@experiment(
    "a heavy box's landing leaves the pyramid", "share of 39 drops that move one of its boxes by 0.3 m", bound=0.0
)
def pyramid_stays(start: Engine) -> float:
    """The push goes straight down through boxes that bear it."""
    moved = [moved > MOVED for _, moved in _drops(start)]
    return sum(moved) / len(moved)


STACKS = (2, 3, 5, 10)
"""Boxes of each."""


@experiment("a box is thrown onto a stack", "rebound to landing speed, stacks of 2 to 10 alike", bound=3e-3)
def rebound_from_stack(start: Engine) -> float:
    """The mean over 4 stacks and 5 throws straight down; without restitution it is nothing."""
    found = [_throw(start, count, speed, 0.5) for count in STACKS for speed in (2.5, 4.0, 6.0, 9.0, 14.0)]
    return sum(found) / len(found)


@experiment("a box is dropped onto a stack", "rebound to landing speed, from 1 to 20 cm above it", bound=1e-2)
def rebound_from_low(start: Engine) -> float:
    """The mean over 4 stacks and 5 heights: blows of 0.4 to 2 m/s."""
    found = [_throw(start, count, 0.0, height) for count in STACKS for height in (0.01, 0.02, 0.05, 0.1, 0.2)]
    return sum(found) / len(found)


def _throw(start: Engine, count: int, speed: float, height: float) -> float:
    """Rebound speed by that of landing of a box thrown down from so many metres above a stack of so many."""
    stack = [body(f"b{k}", box(1.0, 1.0, friction=0.6), position=(0.0, k + 0.5)) for k in range(count)]
    above = (0.0, count + height + 0.5)
    thrown = body("thrown", box(1.0, 1.0, friction=0.6), position=above, velocity=(0.0, -speed))
    run = start(scene(ground(400.0), *stack, thrown))
    run.step(RATE // 30)
    rebound, landed = 0.0, False
    for _ in range(RATE):
        landed = landed or run.place("thrown")[1] < count + 0.52
        run.step()
        rebound = max(rebound, run.velocity("thrown")[1]) if landed else rebound
    return rebound / math.sqrt(speed * speed + 2.0 * G * height)

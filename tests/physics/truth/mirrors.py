"""Left and right are alike: what a mirror shows of a scene falls as the scene does, and what is symmetric stays so."""

from __future__ import annotations

import random
from dataclasses import replace

from sandbox.scene.flat import FlatScene
from tests.flat import AWAKE, body, box, circle, ground, scene
from tests.physics.cards import house
from tests.physics.mirrored import mirrored
from tests.physics.truth.experiment import RATE, Engine, Run, experiment

HEAPS = 20
"""Of each kind, each with numbers of its own."""
CHAOTIC_HEAPS = 1500
"""The same where a few heaps make up most of the mean."""


def _from_image(scene: FlatScene, run: Run, image: Run) -> float:
    """Largest distance (m) along an axis of a body of `run` from where its image in `image` is."""
    found = 0.0
    for each in scene.bodies:
        (x, y), (image_x, image_y) = run.place(each.id), image.place(each.id)
        found = max(found, abs(x + image_x), abs(y - image_y))
    return found


def _mean_error(start: Engine, kind: str, count: int, steps: int, heaps: int = HEAPS) -> float:
    errors = []
    for seed in range(heaps):
        what = _falling(random.Random(seed), kind, count)
        run, image = start(what), start(mirrored(what))
        run.step(steps)
        image.step(steps)
        errors.append(_from_image(what, run, image))
    return sum(errors) / len(errors)


def _falling(draw: random.Random, kind: str, count: int) -> FlatScene:
    """So many discs or boxes of about half a metre one above the other, turned and thrown to the sides."""
    bodies = [ground(60.0, friction=0.5)]
    for k in range(count):
        size = 0.6 + 0.3 * draw.random()
        shape = circle(0.5 * size, friction=0.5) if kind == "discs" else box(size, 0.6, friction=0.5)
        place = (draw.uniform(-1.5, 1.5), 1.0 + 0.9 * k)
        speed, angle = (draw.uniform(-1.0, 1.0), 0.0), draw.uniform(-1.0, 1.0)
        bodies.append(body(f"b{k}", shape, position=place, velocity=speed, angle=angle))
    return scene(*bodies)


@experiment("discs and their image in a mirror", "m, mean of 20 heaps of 12 after 3 s", bound=1e-12)
def discs(start: Engine) -> float:
    return _mean_error(start, "discs", 12, 3 * RATE)


@experiment("a box and its image in a mirror", "m, mean of 20 throws after 1 s", bound=1e-12)
def one_box(start: Engine) -> float:
    """It lands on a corner and tumbles over, a corner at a time."""
    return _mean_error(start, "boxes", 1, RATE)


@experiment("boxes and their image in a mirror", "m, mean of 1,500 heaps of 3 after 1 s", bound=1e-3)
def boxes(start: Engine) -> float:
    """Corners meet edges: the smallest difference grows, in every engine."""
    return _mean_error(start, "boxes", 3, RATE, CHAOTIC_HEAPS)


@experiment("a house of cards lands evenly", "m, left to right, frictions 0.6 to 0.7, 5 s", bound=4.5e-3, behind=True)
def lopsided(start: Engine) -> float:
    """Houses of 2 to 4 levels whose cards fall by a millimetre: the largest difference of two that face each other."""
    worst = 0.0
    for levels in (2, 3, 4):
        for friction in (0.6, 0.65, 0.7):
            what = replace(house(levels, friction, gap=1e-3), settings=AWAKE)
            run = start(what)
            run.step(5 * RATE)
            worst = max(worst, _lopsided(what, run))
    return worst


def _lopsided(what: FlatScene, run: Run) -> float:
    """Largest distance (m) along an axis of a body from where the mirror shows the one that faces it."""
    at = {_rounded(*each.position): each.id for each in what.bodies}
    found = 0.0
    for each in what.bodies:
        x, y = run.place(each.id)
        facing_x, facing_y = run.place(at[_rounded(-each.position[0], each.position[1])])
        found = max(found, abs(x + facing_x), abs(y - facing_y))
    return found


def _rounded(x: float, y: float) -> tuple[float, float]:
    """A place to look things up by: 0.0 for -0.0 too."""
    return round(x, 9) + 0.0, round(y, 9)

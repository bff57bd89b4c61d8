"""What lies at rest lies where it was put: on the ground, on others, on a slope its friction holds it on."""

from __future__ import annotations

import math

from sandbox.scene.flat import FlatScene
from tests.flat import body, box, ground, scene
from tests.physics.truth.experiment import RATE, Engine, experiment
from tests.physics.truth.slopes import rider, slope, way_up

TEN = 10


def _stack(count: int) -> FlatScene:
    """Boxes of a metre that touch."""
    boxes = [body(f"b{k}", box(1.0, 1.0, friction=0.6), position=(0.0, k + 0.5)) for k in range(count)]
    return scene(ground(friction=0.6), *boxes)


def _lower(start: Engine, count: int) -> float:
    """How much lower (m) the top of a stack is after 10 s than it was put."""
    run = start(_stack(count))
    run.step(10 * RATE)
    return abs(run.place(f"b{count - 1}")[1] - (count - 0.5))


@experiment("a box rests on the ground", "m of depth after 10 s, box of 1 m", bound=1e-12)
def box_rests(start: Engine) -> float:
    return _lower(start, 1)


@experiment("a stack of ten rests", "m that its top is low after 10 s, boxes of 1 m", bound=1e-8)
def stack_rests(start: Engine) -> float:
    return _lower(start, TEN)


@experiment("a stack of ten stands still", "m that its top sways from 5 s to 50 s", bound=1e-12)
def sway(start: Engine) -> float:
    """From its leftmost place to its rightmost."""
    run = start(_stack(TEN))
    run.step(5 * RATE)
    places = []
    for _ in range(45 * RATE):
        run.step()
        places.append(run.place(f"b{TEN - 1}")[0])
    return max(places) - min(places)


@experiment("a box put on a slope of 30°", "m of its way in ten steps, frictions 0.8 and 1", bound=1e-12)
def first_steps(start: Engine) -> float:
    """A box of 1 m, which its friction holds from the first moment."""
    worst, angle = 0.0, math.radians(30.0)
    for friction in (0.8, 1.0):
        run = start(scene(slope(angle, friction=friction), rider(angle, box(1.0, 1.0, friction=friction), 0.5)))
        run.step(10)
        worst = max(worst, abs(way_up(run, angle)))
    return worst

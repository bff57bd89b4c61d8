"""A chain of straight links hangs between two hinges: the catenary of rods, which is a sum and a root away."""

from __future__ import annotations

import math
from itertools import pairwise

from sandbox.scene.flat import FlatJoint, FlatScene, Vec
from tests.flat import body, box, scene
from tests.physics.truth.experiment import RATE, Engine, Run, experiment, off

LINKS, SPAN = 21, 14.0
"""Links of a metre, and how far apart (m) the hinges are that hold the ends."""


def curve(pull: float) -> list[Vec]:
    """The hinges of a chain at rest whose horizontal pull is so many times the weight of a link, from the first.

    A link turns about neither end: half its weight, and that of the links between it and the lowest point, is to the
    pull as its rise is to its run.
    """
    points = [(0.0, 0.0)]
    for k in range(LINKS):
        angle = math.atan2(k - 0.5 * (LINKS - 1), pull)
        x, y = points[-1]
        points.append((x + math.cos(angle), y + math.sin(angle)))
    return points


def hanging() -> list[Vec]:
    """The hinges of the chain that spans `SPAN`: the pull is found by halving."""
    low, high = 0.0, 1e3
    while (pull := 0.5 * (low + high)) not in (low, high):
        low, high = (pull, high) if curve(pull)[-1][0] < SPAN else (low, pull)
    return curve(pull)


def _chain(points: list[Vec], damping: float) -> FlatScene:
    """The chain, put where it hangs."""
    links, hinges = [], []
    for k, ((ax, ay), (bx, by)) in enumerate(pairwise(points)):
        place, angle = (0.5 * (ax + bx), 0.5 * (ay + by)), math.atan2(by - ay, bx - ax)
        damped = {"linear_damping": damping, "angular_damping": damping}
        links.append(body(f"link-{k}", box(1.0, 0.1), position=place, angle=angle, **damped))
    for k, at in enumerate(points):
        sides = (f"link-{k - 1}" if k else None, f"link-{k}" if k < LINKS else None)
        hinges.append(FlatJoint(f"hinge-{k}", "revolute", *sides, at, at))
    return scene(*links, joints=tuple(hinges))


def _start(start: Engine, damping: float) -> tuple[Run, float]:
    """The chain in motion, and the height (m) of its middle link's centre, which is its lowest."""
    points = hanging()
    return start(_chain(points, damping)), min(y for _, y in points)


def _height(run: Run) -> float:
    return run.place(f"link-{LINKS // 2}")[1]


@experiment("a chain hangs still", "sag of 21 links, at its worst in 30 s", bound=1e-12)
def still(start: Engine) -> float:
    """Put where it hangs, without any damping."""
    run, height = _start(start, 0.0)
    worst = 0.0
    for _ in range(30 * RATE):
        run.step()
        worst = max(worst, off(_height(run), height))
    return worst


@experiment("a damped chain comes to rest", "sag of 21 links after 30 s", bound=1e-12)
def at_rest(start: Engine) -> float:
    """The mean of the last ten seconds."""
    run, height = _start(start, 0.5)
    run.step(20 * RATE)
    total = 0.0
    for _ in range(10 * RATE):
        run.step()
        total += _height(run)
    return off(total / (10 * RATE), height)

"""Discs pressed into half the room they need, between four walls that do not give way."""

from __future__ import annotations

import math
from itertools import combinations

from sandbox.scene.flat import FlatScene, FlatSettings
from tests.flat import body, box, circle
from tests.physics.truth.experiment import RATE, Engine, experiment

SIDE = 14
"""Discs of a metre in a row, and rows."""
ROOM = SIDE * math.sqrt(math.pi / 8.0)
"""Side of the room (m): its area is half that of the discs."""


def press() -> FlatScene:
    """Discs spread evenly, each a little off its place, so that no two of them are alike."""
    half, pitch = 0.5 * ROOM, ROOM / SIDE
    walls = body(
        "walls",
        *(box(2.0, ROOM + 4.0, (side * (half + 1.0), 0.0)) for side in (-1.0, 1.0)),
        *(box(ROOM + 4.0, 2.0, (0.0, side * (half + 1.0))) for side in (-1.0, 1.0)),
        type="static",
    )
    discs = [
        body(f"disc-{i}-{j}", circle(0.5), position=(pitch * (i + 0.5) - half, pitch * (j + 0.5) - half + 1e-3 * off))
        for i in range(SIDE)
        for j in range(SIDE)
        for off in [(7 * i + 3 * j) % 5]
    ]
    return FlatScene((walls, *discs), settings=FlatSettings(sleeping=False))


@experiment("discs pressed into half their room", "share of touching pairs that overlap by half a diameter", bound=0.0)
def pressed(start: Engine) -> float:
    """Spread evenly, all overlap by a quarter and none by much more."""
    what = press()
    run = start(what)
    run.step(5 * RATE)
    places = [run.place(each.id) for each in what.bodies if each.id != "walls"]
    gaps = [math.dist(a, b) for a, b in combinations(places, 2)]
    return sum(gap < 0.5 for gap in gaps) / sum(gap < 1.0 for gap in gaps)

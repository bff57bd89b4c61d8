"""What the simple solver shows of one step: where many passes over its contacts lead to."""

from __future__ import annotations

from dataclasses import replace

import pytest

import sandbox
from sandbox.reference.simple.techniques import Techniques
from sandbox.reference.simple.trace import MANY, watch_passes
from sandbox.reference.simple.world import SimpleWorld
from sandbox.scene.flat import FlatScene


def tower(count: int) -> FlatScene:
    """Crates on each other, the ground below, and a ball that falls on them."""
    shape = [{"box": [1, 1]}]
    crates = [{"id": f"crate-{k}", "shapes": shape, "position": [0.1 * (k % 2), k + 0.5]} for k in range(count)]
    ground = {"id": "ground", "type": "static", "shapes": [{"box": [20, 1]}], "position": [0, -0.5]}
    ball = {"id": "ball", "shapes": [{"circle": 0.3}], "position": [0.2, count + 1.0]}
    return sandbox.Scene(bodies=[ground, *crates, ball]).flatten()


@pytest.mark.parametrize("step", [1, 25, 60])
def test_many_passes_are_over_the_contacts_that_are_shown(step: int) -> None:
    """Of another history, in which every step before had as many, they were those of other contacts."""
    scene = tower(3)
    techniques = replace(Techniques.of(scene), iterations=1)
    shown = watch_passes(scene, techniques, step)
    world = SimpleWorld(scene, techniques)
    world.step(step - 1)
    world.collide()
    points = [point for contact in world.contacts.values() for point in contact.points]
    rows: list[tuple[float, ...]] = []
    world.techniques = replace(techniques, iterations=MANY)
    world.solve(lambda: rows.append(tuple(point.normal for point in points)))
    assert len(shown.settled) == len(shown.spots) == len(shown.rows[0])
    assert shown.settled == rows[MANY - 1]


def test_it_hears_how_far_it_is() -> None:
    heard: list[int] = []
    watch_passes(tower(1), Techniques.of(tower(1)), 4, heard.append)
    assert heard == list(range(1, 3 + MANY + 1))

"""Rows that hang apart and fall: each runs into what has come to rest below it, and the next one follows closely."""

from __future__ import annotations

import pytest

from sandbox.engine.world import World
from tests.flat import body, box, circle, ground, world

GAP = 0.1
SHAPES = {"boxes": (box(0.8, 0.8), 0.8), "balls": (circle(0.4), 0.8), "planks": (box(3.0, 0.4), 0.4)}


def column(kind: str, count: int, lowest: float = 0.0, speed: float = 0.0) -> World:
    shape, height = SHAPES[kind]
    places = [(0.0, lowest + 0.5 * height + k * (height + GAP)) for k in range(count)]
    return world(
        ground(50.0), *[body(f"b{k}", shape, position=at, velocity=(0.0, -speed)) for k, at in enumerate(places)]
    )


def deepest(w: World) -> float:
    """The deepest overlap (m) of a contact."""
    contacts = w.state.contacts[: int(w.state.counters[0].contact_count)]
    return -min((min(c.separation1, c.separation2 if c.point_count == 2 else 0.0) for c in contacts), default=0.0)


@pytest.mark.parametrize("kind", SHAPES)
def test_a_column_that_closes_up_hardly_overlaps(kind):
    """The last of them come at 10 m/s, 17 cm a step, and what they follow is stopped in mid-step."""
    w = column(kind, 60)
    worst = 0.0
    for _ in range(150):
        w.step()
        worst = max(worst, deepest(w))
    assert worst < 0.1
    assert deepest(w) < 0.03


def test_what_falls_together_is_left_alone():
    """Nobody is stopped, so nobody is looked at as if: there are no contacts."""
    w = column("boxes", 10, lowest=50.0, speed=20.0)
    w.step(20)
    assert w.state.counters[0].contact_count == 0

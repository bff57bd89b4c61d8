"""What has no room comes to lie evenly and to rest: nobody is squeezed into another because a wall holds him."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatSettings, FlatShape
from tests.flat import body, box, circle, segment, world

WALLS = {"thick": 2.0, "thin": 0.01, "lines": 0.0}


def room(side: float, thick: float) -> list[FlatBody]:
    """A closed square room, of lines if the walls have no thickness."""
    half, middle = 0.5 * side, 0.5 * (side + thick)
    along, across = box(side + 2.0 * thick, thick), box(thick, side + 2.0 * thick)
    if thick == 0.0:
        along, across = segment((-half, 0.0), (half, 0.0)), segment((0.0, -half), (0.0, half))
    places = [((0.0, -middle), along), ((0.0, middle), along), ((-middle, 0.0), across), ((middle, 0.0), across)]
    return [body(f"wall{k}", shape, type="static", position=at) for k, (at, shape) in enumerate(places)]


def crowd(count: int, side: float, thick: float, shape: FlatShape) -> World:
    """A square of shapes of 1 m, none of which overlaps a wall yet, without gravity."""
    random = np.random.default_rng(0)
    places = np.linspace(0.5 * (1.0 - side), 0.5 * (side - 1.0), count)
    bodies = [
        body(f"b{i}-{j}", shape, position=(float(x + random.uniform(0.0, 0.01)), float(y + random.uniform(0.0, 0.01))))
        for i, x in enumerate(places)
        for j, y in enumerate(places)
    ]
    return world(*room(side, thick), *bodies, gravity=(0.0, 0.0), settings=FlatSettings())


def deepest(w: World) -> float:
    """The deepest overlap of all contacts, m."""
    second = np.where(w.contacts.point_count == 2, w.contacts.separation2, w.contacts.separation1)
    return float(-np.minimum(w.contacts.separation1, second).min())


@pytest.mark.parametrize(("count", "width"), [(2, 1.6), (3, 2.4), (6, 4.8), (12, 9.6)])
def test_a_row_between_walls_is_even(count: int, width: float):
    """One load goes through all of it: a wall, which does not move, is twice as stiff as two discs."""
    places = np.linspace(0.5, width - 0.5, count)
    walls = [body(f"wall{x}", box(2.0, 4.0), type="static", position=(x, 0.0)) for x in (-1.0, width + 1.0)]
    discs = [body(f"disc{k}", circle(0.5, friction=0.0), position=(float(x), 0.0)) for k, x in enumerate(places)]
    w = world(*walls, *discs, gravity=(0.0, 0.0), settings=FlatSettings())
    w.step(180)
    x = np.array([w.body(f"disc{k}").position[0] for k in range(count)])
    even = (count - width) / count
    assert 1.0 - np.diff(x) == pytest.approx(even, rel=0.1)
    assert 0.5 - np.array([x[0], width - x[-1]]) == pytest.approx(0.5 * even, rel=0.1)
    assert not w.bodies.awake[2:].any()


@pytest.mark.parametrize("walls", WALLS)
def test_a_crowd_that_has_no_room_is_even_and_comes_to_rest(walls):
    """An even square overlaps by 0.2 m, half of that at the walls; pymunk and Box2D leave 0.28 and 0.26."""
    w = crowd(8, 6.4, WALLS[walls], circle(0.5))
    w.step(300)
    assert deepest(w) < 0.28
    assert not w.bodies.awake[4:].any()


def test_the_middle_of_what_is_pressed_stays_on_its_side():
    """A kinematic press that leaves no room at all: the wall still holds."""
    for thick in (2.0, 0.01):
        w = world(
            body("wall", box(thick, 4.0), type="static", position=(0.5 * thick, 0.0)),
            body("press", box(1.0, 3.0), type="kinematic", position=(-2.0, 0.0), velocity=(1.0, 0.0)),
            body("disc", circle(0.5), position=(-0.6, 0.0)),
            gravity=(0.0, 0.0),
        )
        for _ in range(80):
            w.step()
            assert w.body("disc").position[0] < 0.0

"""What circles say passes by does: at no time on its way is it as near as the rounding."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.geometry.core import CoreRows
from sandbox.geometry.swept_circles import pass_by
from sandbox.geometry.time_of_impact import SWEEP
from sandbox.world.records import VERTEX
from tests.engine.stages import stage
from tests.examples import examples

told = stage(pass_by)
sizes = st.tuples(st.floats(0.05, 3.0), st.floats(0.05, 3.0))
places = st.tuples(st.floats(-4.0, 4.0), st.floats(-4.0, 4.0))
turns = st.sampled_from([0.0, 0.0, 0.5, -3.0])


def rectangle(size: tuple[float, float], angle: float) -> np.ndarray:
    """Its corners, counter-clockwise, in the frame of its body, in which it lies at an angle."""
    corners = 0.5 * np.array(size) * [[-1, -1], [1, -1], [1, 1], [-1, 1]]
    return corners @ [[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]]


def rows_of(*polygons: np.ndarray):
    rows = VERTEX.zeros(sum(map(len, polygons)))
    ways = np.concatenate([np.roll(each, -1, 0) - each for each in polygons])
    rows.x, rows.y = np.concatenate(polygons).T
    rows.normal_x, rows.normal_y = (ways[:, ::-1] * [1, -1] / np.hypot(*ways.T)[:, None]).T
    return rows


def distance(a: np.ndarray, b: np.ndarray) -> float:
    """Between two convex polygons, 0 where they overlap: by every vertex and every edge."""
    if max(_gap(a, b), _gap(b, a)) <= 0.0:
        return 0.0
    return min(_nearest(a, b), _nearest(b, a))


def _gap(a: np.ndarray, b: np.ndarray) -> float:
    """How far b lies beyond that edge of a beyond which it lies farthest."""
    ways = np.roll(a, -1, 0) - a
    normals = ways[:, ::-1] * [1, -1] / np.hypot(*ways.T)[:, None]
    return float((normals @ b.T - (normals * a).sum(1)[:, None]).min(1).max())


def _nearest(points: np.ndarray, polygon: np.ndarray) -> float:
    ways = np.roll(polygon, -1, 0) - polygon
    to = points[:, None] - polygon
    share = np.clip((to * ways).sum(2) / (ways * ways).sum(1), 0.0, 1.0)
    return float(np.linalg.norm(to - share[..., None] * ways, axis=2).min())


def sweep_of(place, way, turn_a: float, turn_b: float):
    sweep = SWEEP.zeros(1)
    row = sweep[0]
    row.x, row.y = place
    row.translation_x, row.translation_y = way
    row.rotation_a, row.rotation_b = turn_a, turn_b
    return row


def say(a: np.ndarray, b: np.ndarray, sweep, radius_a: float = 0.0, radius_b: float = 0.0) -> bool:
    rims = (float(np.linalg.norm(each, axis=1).max()) for each in (a, b))
    cores = CoreRows(0, len(a), radius_a), CoreRows(len(a), len(b), radius_b)
    return bool(told(rows_of(a, b), *cores, sweep, *rims))


def turned(polygon: np.ndarray, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    return polygon @ [[c, s], [-s, c]]


@examples(400)
@given(sizes, sizes, st.floats(0.0, 3.0), st.floats(0.0, 3.0), places, places, turns, turns, st.floats(0.0, 0.3))
def test_what_passes_by_is_apart_at_all_times(size_a, size_b, angle_a, angle_b, place, way, turn_a, turn_b, radius):
    a, b = rectangle(size_a, angle_a), rectangle(size_b, angle_b)
    if not say(a, b, sweep_of(place, way, turn_a, turn_b), radius, 0.01):
        return
    for t in np.linspace(0.0, 1.0, 60):
        there = turned(b, t * turn_b) + place + t * np.array(way)
        assert distance(turned(a, t * turn_a), there) > radius + 0.01 - 1e-12


PLANK, BOX = rectangle((10.0, 0.2), 0.5), rectangle((0.5, 0.5), 0.0)


@pytest.mark.parametrize(
    ("a", "b", "place", "way", "turns", "passes"),
    [
        (BOX, BOX, (-3.0, 0.0), (2.0, 0.0), (1.0, 1.0), True),  # it ends too early
        (BOX, BOX, (-3.0, 0.8), (9.0, 0.0), (1.0, 1.0), True),  # it flies past
        (BOX, BOX, (-3.0, 0.6), (9.0, 0.0), (1.0, 1.0), False),  # only its corners might touch
        (BOX, BOX, (3.0, 0.0), (9.0, 0.0), (1.0, 1.0), True),  # it flies off
        (PLANK, BOX, (-3.0, 0.0), (5.0, 3.0), (0.0, 1.0), True),  # along a plank that lies aslant
        (PLANK, BOX, (-3.0, 0.0), (5.0, 3.0), (0.1, 1.0), False),  # that turns
        (PLANK, BOX, (-3.0, 0.0), (5.0, -3.0), (0.0, 1.0), False),  # through it
        (BOX, PLANK, (3.0, 0.0), (-5.0, -3.0), (1.0, 0.0), True),  # seen from the other one
    ],
)
def test_it_tells_of_what_flies_past(a, b, place, way, turns, passes):
    assert say(a, b, sweep_of(place, way, *turns)) is passes

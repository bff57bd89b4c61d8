"""Sweeps hold: no way is let go on which two cores come deeper into each other than they may."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sandbox.geometry.core import CoreRows
from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.time_of_impact import POSED_ROWS, SWEEP, time_of_impact
from sandbox.world.records import VERTEX
from tests.engine.stages import stage
from tests.examples import examples

impact_of = stage(time_of_impact)
WALL = (10.0, 0.01)
DEEP = 0.002
CREEP = 0.02
GROWTH = 0.05
CORES = CoreRows(0, 4, 0.0), CoreRows(4, 4, 0.0)


def rectangles(*sizes: tuple[float, float]):
    """The vertices of some rectangles, counter-clockwise from their lower left."""
    rows = VERTEX.zeros(4 * len(sizes))
    for k, (width, height) in enumerate(sizes):
        rows.x[4 * k : 4 * k + 4] = 0.5 * width * np.array([-1, 1, 1, -1])
        rows.y[4 * k : 4 * k + 4] = 0.5 * height * np.array([-1, -1, 1, 1])
        rows.normal_x[4 * k : 4 * k + 4] = [0, 1, 0, -1]
        rows.normal_y[4 * k : 4 * k + 4] = [-1, 0, 1, 0]
    return rows


def below(rod, x: float, y: float, angle: float) -> float:
    """How far a rod at such a pose reaches below the upper face of the wall, in metres."""
    return 0.5 * WALL[1] - float((y + math.sin(angle) * rod.x + math.cos(angle) * rod.y).min())


@examples(300)
@given(
    st.floats(0.1, 2.0), st.floats(0.004, 0.02), st.floats(-0.002, 0.007), st.floats(0.0, 2.0 * math.pi),
    st.floats(-1.0, 1.0), st.floats(-2.0, 2.0), st.floats(-15.0, 15.0),
)  # fmt: skip
def test_a_rod_that_overlaps_a_wall_already_goes_hardly_deeper_on_any_way(
    length, thick, overlap, angle, way_x, way_y, turn
):
    rows = rectangles(WALL, (length, thick))
    rod = rows[4:]
    thin = 0.5 * (WALL[1] + thick)
    overlap = min(overlap, 0.7 * thin)
    y = below(rod, 0.0, 0.0, angle) - overlap
    sweep, posed, out = SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(1)
    row = sweep[0]
    row.x, row.y, row.angle_b, row.translation_x, row.translation_y, row.rotation_b = 0.0, y, angle, way_x, way_y, turn
    row.deep, row.thin, row.half = min(DEEP, 0.25 * thin), thin, 0.5 * thick
    t = impact_of(rows, *CORES, sweep, posed, out)
    assert t == -1.0 or 0.0 <= t < 1.0
    growth = max(CREEP * row.deep, GROWTH * min(overlap, row.half - overlap))
    allowed = max(row.deep, overlap + growth) + 1e-9
    for share in np.linspace(0.0, 1.0 if t < 0.0 else t, 400):
        assert below(rod, share * way_x, y + share * way_y, angle + share * turn) <= allowed


def test_what_is_told_of_a_hit_is_where_it_is():
    """A box that is 1 mm in the floor, hardly tilted, and goes on: it touches from the start, first at one corner."""
    rows = rectangles(WALL, (1.0, 1.0))
    sweep, posed, out = SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(1)
    row = sweep[0]
    row.y, row.angle_b, row.translation_y, row.deep, row.thin = 0.504, 5e-4, -1.0, 0.005, 0.505
    t = impact_of(rows, *CORES, sweep, posed, out)
    assert 0.0032 < t < 0.004
    assert (row.normal_x, row.normal_y, row.touched) == (0.0, 1.0, 1)
    assert -0.501 < row.point_x < -0.499
    row.y = 0.55
    assert 0.044 < impact_of(rows, *CORES, sweep, posed, out) < 0.0451
    assert row.touched == 0


@examples(300)
@given(st.floats(-0.001, 0.7), st.floats(-1.0, 1.0), st.floats(-3.0, -0.02), st.floats(-2.0, 2.0))
def test_what_touches_something_that_gives_way_goes_on_into_it_but_not_through(overlap, way_x, way_y, turn):
    """`overlap` as a share of how deep the two come before they part on the other side."""
    rows = rectangles(WALL, (1.0, 0.1))
    thin = 0.5 * (WALL[1] + 0.1)
    sweep, posed, out = SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(1)
    row = sweep[0]
    row.y, row.translation_x, row.translation_y, row.rotation_b = thin * (1.0 - overlap), way_x, way_y, turn
    row.deep, row.thin, row.yields = min(0.005, 0.25 * thin), thin, 1
    t = impact_of(rows, *CORES, sweep, posed, out)
    allowed = thin * (overlap + 0.5 * (0.75 - overlap))
    deepest = below(rows[4:], t * way_x, row.y + t * way_y, t * turn)
    assert 0.0 < t < 1.0
    assert 0.5 * (thin * overlap + allowed) - 1e-9 <= deepest <= allowed + 1e-9
    row.y = 0.2 * thin  # too deep to be held
    assert impact_of(rows, *CORES, sweep, posed, out) == -1.0


def test_what_ends_just_where_it_would_be_stopped_is_not_stopped():
    """As after a stop: rounding does not stop it once more."""
    rows = rectangles(WALL, (1.0, 0.1))
    sweep, posed, out = SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(1)
    row = sweep[0]
    row.y, row.deep, row.thin, row.half = 0.155, 0.002, 0.055, 0.05
    for late, stops in ((-1e-12, False), (0.0, False), (1e-12, False), (1e-6, True)):
        row.translation_y = -(0.1 + row.deep) * (1.0 + late)
        assert (impact_of(rows, *CORES, sweep, posed, out) >= 0.0) == stops, late

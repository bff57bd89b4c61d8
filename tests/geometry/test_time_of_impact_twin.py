"""Times of impact of cores that move and turn against a naive twin that looks everywhere on their way."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.time_of_impact import POSED_ROWS, SWEEP
from sandbox.world.records import VERTEX
from tests.examples import examples
from tests.geometry.convex_cases import Case, cores, radii, solid
from tests.geometry.test_time_of_impact import impact_of
from tests.naive.time_of_impact import Meeting, Mover, TooCloseError

LET_PASS = 0.1
"""A hit is told when the overlap is this near to what is let pass, as a share of it."""


@st.composite
def meetings(draw: st.DrawFn) -> Meeting:
    """Two shapes that go for each other, more or less."""
    case = solid(Case(draw(cores), draw(cores), (0.0, 0.0), draw(radii), draw(radii)))
    angle, far = draw(st.floats(-math.pi, math.pi)), draw(st.floats(1.0, 6.0))
    x, y = far * math.cos(angle), far * math.sin(angle)
    share, miss = draw(st.floats(0.2, 2.0)), draw(st.floats(-0.5, 0.5))
    turns = st.just(0.0) | st.floats(-4.0, 4.0)
    angles = st.floats(-math.pi, math.pi)
    still = Mover(case.a, case.radius_a, (0.0, 0.0), (0.0, 0.0), draw(angles), draw(turns))
    way = -share * x - miss * y, -share * y + miss * x
    return Meeting(still, Mover(case.b, case.radius_b, (x, y), way, draw(angles), draw(turns)))


def time_of_hit(meeting: Meeting, deep: float) -> tuple[float, bool]:
    """The kernel's time, and whether it says that they have touched from the start on."""
    a, b = meeting.a, meeting.b
    case = Case(tuple(a.core), tuple(b.core), (0.0, 0.0), a.radius, b.radius)
    sweep, posed, out = SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(1)
    row = sweep[0]
    row.x, row.y = b.center[0] - a.center[0], b.center[1] - a.center[1]
    row.translation_x, row.translation_y = b.way[0] - a.way[0], b.way[1] - a.way[1]
    row.angle_a, row.angle_b, row.rotation_a, row.rotation_b = a.angle, b.angle, a.turn, b.turn
    row.deep, row.thin = deep, 4.0 * deep
    t = impact_of(case.table(), *case.cores(), sweep, posed, out)
    return float(t), bool(row.touched)


@given(meetings(), st.floats(0.0, 1.0))
@examples(100)
def test_the_twin_measures_as_exact_arithmetic_does(meeting, t):
    assert meeting.separation(t) == pytest.approx(meeting.exact_separation(t), abs=1e-12)


@given(meetings(), st.floats(0.005, 0.02))
@examples(300)
def test_a_way_is_let_go_on_only_if_it_nowhere_leads_too_deep(meeting, deep):
    assume(meeting.separation(0.0) > -(1.0 - 2.0 * LET_PASS) * deep)
    t, _touched = time_of_hit(meeting, deep)
    fine = 0.02 * deep
    try:
        too_deep = meeting.first_below(-deep * 1.02, fine)
        all_but = meeting.first_below(-(1.0 - LET_PASS) * deep, fine)
    except TooCloseError:
        assume(False)
    assert t == -1.0 or 0.0 <= t < 1.0
    if t == -1.0:
        assert too_deep is None
    else:
        assert all_but is not None, "held for nothing"
        assert too_deep is None or t <= too_deep


@given(meetings(), st.floats(0.005, 0.02), st.booleans())
@examples(300)
def test_a_hit_is_told_where_the_shapes_touch_last_before_it(meeting, deep, from_touch):
    """Of shapes that touch from the start on, it is told where they are as deep as may be."""
    if from_touch:
        meeting = _from_touch(meeting, deep)
    start = meeting.separation(0.0)
    if start <= -(1.0 - 2.0 * LET_PASS) * deep:
        return
    t, touched = time_of_hit(meeting, deep)
    if t < 0.0:
        return
    there, fine = meeting.exact_separation(t), 0.02 * deep
    try:
        hit = meeting.first_below(-(1.0 - LET_PASS) * deep, fine)
        assert hit is not None
    except TooCloseError:
        return
    if touched:
        assert start <= 2.0 * LET_PASS * deep
        assert -deep * 1.001 <= there <= -(1.0 - 1.001 * LET_PASS) * deep
        assert t >= hit
        return
    assert -1e-9 <= there <= 1.001 * LET_PASS * deep
    assert t <= hit + 2.0 * fine / meeting.fastest()
    # From there on they do not part before the hit, but for less than what is let pass.
    assert meeting.separations(np.linspace(t, max(t, hit), 50)).max() <= 1.5 * deep


def test_a_graze_before_the_hit_is_not_where_they_touch_last():
    """A rod goes down and turns once: the first of its ends grazes a wall, the second one goes too deep into it."""
    deep = 0.01
    wall = Mover(((-3.0, 0.0), (3.0, 0.0)), 0.1, (0.0, 0.0))
    first, second = 1.2 + 0.05 * deep, 1.2 - 2.0 * deep
    down = 2.0 * (second - first)
    rod = Mover(((-1.0, 0.0), (1.0, 0.0)), 0.1, (0.0, first - 0.25 * down), (0.0, down), 0.0, 2.0 * math.pi)
    meeting = Meeting(wall, rod)
    t, touched = time_of_hit(meeting, deep)
    assert 0.5 < t < 0.75
    assert not touched
    assert 0.0 <= meeting.exact_separation(t) <= LET_PASS * deep


def _from_touch(meeting: Meeting, deep: float) -> Meeting:
    """The meeting from where its shapes are all but in touch."""
    try:
        t = meeting.first_below(0.5 * LET_PASS * deep, 0.1 * LET_PASS * deep)
    except TooCloseError:
        t = None
    assume(t is not None)
    moved = []
    for each in (meeting.a, meeting.b):
        x, y = each.center[0] + t * each.way[0], each.center[1] + t * each.way[1]
        moved.append(Mover(each.core, each.radius, (x, y), each.way, each.angle + t * each.turn, each.turn))
    return Meeting(*moved)

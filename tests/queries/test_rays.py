"""Rays against exact rationals: nothing missed, nothing invented, and the right place."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.examples import examples
from tests.naive.queries import Solid, gap, solids, swept, unit
from tests.queries.worlds import ways, worlds

TOLERANCE = 40.0
"""In units of rounding."""


def check_hit(hit, solid: Solid, origin, way, apart: float) -> None:
    """One hit of a ray: the way up to it just touches the shape, and all of the shape lies behind its normal."""
    tolerance = TOLERANCE * unit(solid, origin, way)
    if hit.normal == (0.0, 0.0):
        assert hit.fraction == 0.0
        assert hit.point == origin
        assert gap([*swept([origin], (0.0, 0.0))], 0.0, solid.core, solid.radius) <= 0.0
        return
    before = swept([origin], way, hit.fraction)
    if hit.fraction > 0.0:
        assert abs(gap(before, 0.0, solid.core, solid.radius)) <= tolerance
    else:
        assert abs(gap(swept([origin], (0.0, 0.0)), 0.0, solid.core, solid.radius)) <= tolerance
    assert abs(math.hypot(*hit.normal) - 1.0) < 1e-9
    rounding = 2.0**-50 * (abs(origin[0]) + abs(origin[1]) + abs(way[0]) + abs(way[1]))
    assert abs(solid.behind(hit.normal, hit.point)) <= 4.0 * tolerance + rounding
    if hit.fraction > 0.0:
        # Where it grazes an arc, a tiny way across is a long way along it.
        skew = math.sqrt(2.0 * tolerance / solid.radius) if solid.radius > 0.0 else tolerance
        assert hit.normal[0] * way[0] + hit.normal[1] * way[1] <= max(skew * math.hypot(*way), tolerance)


@given(st.data())
@examples(400)
def test_all_hits_of_a_ray(data):
    world, at = data.draw(worlds())
    origin, way = data.draw(ways(world, at))
    hits = world.query.ray_all(origin, way)
    found = {hit.shape: hit for hit in hits}
    assert len(found) == len(hits)
    assert list(hits) == sorted(hits, key=lambda hit: (hit.fraction, hit.shape))
    line = swept([origin], way)
    for solid in solids(world.state):
        apart = gap(line, 0.0, solid.core, solid.radius)
        if apart <= 0.0:
            assert solid.index in found, "missed"
        if solid.index in found:
            hit = found[solid.index]
            assert apart <= TOLERANCE * unit(solid, origin, way), "invented"
            assert hit.body == world.names[solid.body]
            check_hit(hit, solid, origin, way, apart)


@given(st.data())
@examples(300)
def test_the_first_hit_is_the_first_of_all(data):
    world, at = data.draw(worlds(30))
    origin, way = data.draw(ways(world, at))
    hits = world.query.ray_all(origin, way)
    assert world.query.ray(origin, way) == (hits[0] if hits else None)


@given(st.data(), st.integers(0, 9))
@examples(100)
def test_many_rays_at_once_are_many_single_rays(data, count):
    world, at = data.draw(worlds())
    several = [data.draw(ways(world, at)) for _ in range(count)]
    hits = world.query.rays(
        np.array([w[0] for w in several]).reshape(-1, 2), np.array([w[1] for w in several]).reshape(-1, 2)
    )
    assert len(hits) == count
    for k, (origin, way) in enumerate(several):
        one = world.query.ray(origin, way)
        if one is None:
            assert hits.body[k] == hits.shape[k] == -1
            assert hits.fraction[k] == 1.0
            assert tuple(hits.point[k]) == (origin[0] + way[0], origin[1] + way[1])
            assert tuple(hits.normal[k]) == (0.0, 0.0)
        else:
            assert world.names[hits.body[k]] == one.body
            assert (hits.shape[k], hits.fraction[k]) == (one.shape, one.fraction)
            assert (tuple(hits.point[k]), tuple(hits.normal[k])) == (one.point, one.normal)

"""The walk through the grid finds what a look at every shape finds, where grids go wrong."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.world import World
from tests.examples import examples
from tests.flat import body, box, circle, world
from tests.naive.convex import Point
from tests.naive.queries import gap, solids, swept

Ways = np.ndarray


def discs(x, y, radius) -> World:
    """A world of static discs."""
    rows = zip(x, y, radius, strict=True)
    return world(
        *(
            body(f"{k}", circle(float(r)), type="static", position=(float(u), float(v)))
            for k, (u, v, r) in enumerate(rows)
        )
    )


def first_discs(x, y, radius, way) -> tuple[np.ndarray, np.ndarray]:
    """For one ray: the fraction at which each disc is met (inf if never), and how clearly (metres)."""
    ox, oy, dx, dy = way
    square = dx * dx + dy * dy
    along = np.clip(((x - ox) * dx + (y - oy) * dy) / square, 0.0, 1.0) if square else np.zeros(len(x))
    clear = radius - np.hypot(ox + along * dx - x, oy + along * dy - y)
    side = ((x - ox) * dy - (y - oy) * dx) ** 2 / square if square else np.zeros(len(x))
    entry = along_line(x, y, ox, oy, dx, dy, square) - np.sqrt(np.maximum(radius**2 - side, 0.0) / (square or 1.0))
    inside = np.hypot(x - ox, y - oy) <= radius
    return np.where(clear < 0.0, np.inf, np.where(inside, 0.0, np.maximum(entry, 0.0))), clear


def along_line(x, y, ox, oy, dx, dy, square):
    """Fraction of the ray's closest approach to each centre."""
    return ((x - ox) * dx + (y - oy) * dy) / square if square else np.zeros(len(x))


def agree(x, y, radius, ways: Ways, fuzz: float = 1e-9) -> None:
    """Rays find the discs that brute force finds, in the same order; `fuzz` (m) is what floats cannot tell."""
    x, y, radius = (np.asarray(value, dtype=float) for value in (x, y, radius))
    query = discs(x, y, radius).query
    first = query.rays(ways[:, :2], ways[:, 2:])
    for k, way in enumerate(ways):
        entry, clear = first_discs(x, y, radius, way)
        hits = query.ray_all(tuple(map(float, way[:2])), tuple(map(float, way[2:])))
        found = {hit.shape for hit in hits}
        assert set(np.flatnonzero(clear > fuzz)) <= found, "missed"
        assert found <= set(np.flatnonzero(clear >= -fuzz)), "invented"
        length = math.hypot(way[2], way[3])
        if hits:
            assert (int(first.shape[k]), float(first.fraction[k])) == (hits[0].shape, hits[0].fraction)
        for hit in hits:
            if clear[hit.shape] > 1e-3 * radius[hit.shape]:
                assert abs(hit.fraction - entry[hit.shape]) * length <= 1e3 * fuzz
        if not hits:
            assert first.shape[k] == -1


def random_ways(random, count: int, reach: float) -> Ways:
    """Rays of all lengths and directions, a third of them along the axes."""
    starts = random.uniform(-reach, reach, (count, 2))
    ways = random.normal(size=(count, 2)) * reach * 10.0 ** random.uniform(-3.0, 1.0, (count, 1))
    ways[::6, 0] = 0.0
    ways[1::6, 1] = 0.0
    return np.hstack([starts, ways])


@given(st.integers(0, 2**32), st.sampled_from([0.5, 2.0, 30.0]))
@examples(40)
def test_discs_of_one_size(seed, spread):
    random = np.random.default_rng(seed)
    x, y = random.uniform(-10.0 * spread, 10.0 * spread, (2, 300))
    agree(x, y, np.full(300, 0.5), random_ways(random, 40, 12.0 * spread))


@given(st.integers(0, 2**32))
@examples(40)
def test_discs_of_all_sizes(seed):
    """From a millimetre to a kilometre: many levels."""
    random = np.random.default_rng(seed)
    radius = 10.0 ** random.uniform(-3.0, 3.0, 300)
    x, y = random.normal(size=(2, 300)) * radius * 3.0
    agree(x, y, radius, random_ways(random, 40, 100.0))


@given(st.integers(0, 2**32))
@examples(30)
def test_dust_on_a_huge_disc(seed):
    random = np.random.default_rng(seed)
    x, y = random.uniform(-5.0, 5.0, (2, 300))
    x[0], y[0] = 0.0, -2e5
    radius = np.full(300, 0.01)
    radius[0] = 2e5
    agree(x, y, radius, random_ways(random, 40, 6.0))


@given(st.integers(0, 2**32))
@examples(30)
def test_discs_scattered_over_a_million_metres(seed):
    random = np.random.default_rng(seed)
    x, y = random.uniform(-1e6, 1e6, (2, 200))
    ways = random_ways(random, 40, 1e6)
    # Half of the rays are aimed at a disc: the others would hardly meet one.
    goals = random.integers(0, 200, 20)
    ways[:20, 2:] = np.stack([x[goals], y[goals]], 1) + random.uniform(-1.0, 1.0, (20, 2)) - ways[:20, :2]
    agree(x, y, np.full(200, 1.0), ways, 1e-7)


@given(st.integers(0, 2**32), st.sampled_from([0.0, 1e7, -1e7]), st.sampled_from([0.25, 0.3, 1.0]))
@examples(40)
@pytest.mark.slow
def test_a_lattice_of_boxes_with_rays_along_all_its_lines(seed, far, pitch):
    """Edges of shapes on the borders of cells, rays along both: whatever a ray touches, it finds."""
    random = np.random.default_rng(seed)
    cells = np.unique(random.integers(-8, 8, (90, 2)), axis=0)
    corners = far + pitch * cells
    boxes = [
        body(f"{k}", box(pitch, pitch), type="static", position=(float(p[0] + 0.5 * pitch), float(p[1] + 0.5 * pitch)))
        for k, p in enumerate(corners)
    ]
    there = world(*boxes)
    parts = solids(there.state)
    lines = random.integers(-9, 9, (6, 2)) * pitch + far
    for k, (x, y) in enumerate(lines):
        origin, way = (
            (((far - 10.0 * pitch), float(y)), (20.0 * pitch, 0.0))
            if k % 2
            else ((float(x), far + 10.0 * pitch), (0.0, -20.0 * pitch))
        )
        if k % 3 == 0:
            origin, way = (float(x), float(y)), (float(7.0 * pitch), float(7.0 * pitch))
        found = {hit.shape for hit in there.query.ray_all(origin, way)}
        line, fuzz = swept([origin], way), 1e-12 * pitch + 1e-15 * abs(far)
        gaps = {solid.index: gap(line, 0.0, solid.core, 0.0) for solid in parts if in_reach(line, solid.core, fuzz)}
        assert {index for index, metres in gaps.items() if metres <= 0.0} <= found
        assert found <= {index for index, metres in gaps.items() if metres <= fuzz}


def in_reach(a: list[Point], b: list[Point], fuzz: float) -> bool:
    """Whether the upright boxes around two cores come so near (m); of those that do not, the gap is wider."""
    return all(
        min(p[axis] for p in one) - max(p[axis] for p in other) <= fuzz
        for one, other in ((a, b), (b, a))
        for axis in range(2)
    )


@given(st.integers(0, 2**32), st.sampled_from([1.0, 40.0]))
@examples(40)
def test_boxes_and_nearest_points_among_many(seed, spread):
    random = np.random.default_rng(seed)
    count = 300
    x, y = random.uniform(-spread, spread, (2, count)) * 5.0
    radius = 10.0 ** random.uniform(-2.0, 0.5, count)
    query = discs(x, y, radius).query
    for px, py in random.uniform(-12.0 * spread, 12.0 * spread, (15, 2)):
        distance = np.hypot(x - px, y - py) - radius
        hit = query.nearest((float(px), float(py)))
        assert hit is not None
        assert abs(hit.distance - distance.min()) < 1e-9
        wide, high = random.uniform(0.0, 4.0 * spread, 2)
        inside = np.hypot(x - np.clip(x, px, px + wide), y - np.clip(y, py, py + high)) - radius
        found = {o.shape for o in query.overlap_box((float(px), float(py)), (float(px + wide), float(py + high)))}
        assert set(np.flatnonzero(inside < -1e-9)) <= found <= set(np.flatnonzero(inside < 1e-9))
        holding = {h.shape for h in query.point((float(px), float(py)))}
        assert set(np.flatnonzero(distance < -1e-9)) <= holding <= set(np.flatnonzero(distance < 1e-9))


@pytest.mark.parametrize("length", [1e3, 1e6, 1e9])
def test_a_long_ray_looks_at_no_more_than_every_box(length):
    """A ray over a thousand million cells ends all the same, and finds the last disc."""
    x = np.append(np.arange(0.0, 50.0, 2.0), length - 10.0)
    there = discs(x, np.zeros(len(x)), np.full(len(x), 0.5))
    hits = there.query.ray_all((-5.0, 0.0), (length, 0.0))
    assert [hit.shape for hit in hits] == list(range(len(x)))
    down = there.query.ray((length - 10.0, 1e6), (0.0, -2e6))
    assert down is not None
    assert down.shape == len(x) - 1

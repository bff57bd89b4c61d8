"""The grid's pairs against every pair of boxes, most of all where grids go wrong."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sandbox.engine.broad_phase import pairs
from tests.engine.stages import Grid
from tests.examples import examples
from tests.kernels import called_from_python
from tests.naive.grid import Box, all_pairs, may_meet

may_collide = called_from_python(pairs.may_collide)
coordinates = st.integers(-20, 20).map(float) | st.floats(-20.0, 20.0)
exponents = st.floats(-6.0, 0.0).map(lambda e: 10.0**e)
sizes = st.sampled_from([0.5, 1.0, 2.0]) | st.floats(0.001, 4.0)


@st.composite
def boxes(draw: st.DrawFn, places=coordinates, extents=sizes) -> Box:
    """A box somewhere, of some body, with some filter."""
    x, y, w, h = draw(places), draw(places), draw(extents), draw(extents)
    return Box(
        (x, y), (x + w, y + h), draw(st.integers(0, 12)), draw(st.booleans()),
        draw(st.sampled_from([1, 1, 1, 2, 6])), draw(st.sampled_from([0xFFFFFFFF, 1, 2, 0])),
        draw(st.sampled_from([0, 0, 0, 1, -1, 2])),
    )  # fmt: skip


def plain(lower, upper, body) -> Box:
    """A moving box that meets everything."""
    return Box(tuple(map(float, lower)), tuple(map(float, upper)), body)


def agree(parts: list[Box]) -> None:
    """The grid finds what brute force finds, each pair once and sorted."""
    assert Grid(parts).sorted_pairs() == all_pairs(parts)


@given(st.lists(boxes(), max_size=60))
@examples(200)
def test_random_boxes(parts):
    agree(parts)


@given(st.lists(boxes(st.integers(-6, 6).map(float), st.sampled_from([1.0, 2.0])), max_size=60))
@examples(100)
def test_boxes_that_touch_on_whole_coordinates(parts):
    agree(parts)


@given(st.lists(boxes(extents=st.just(1.0)), min_size=2, max_size=40), st.integers(1, 5))
@examples(50)
def test_boxes_in_one_place(parts, copies):
    agree([replace(part, body=k) for k, part in enumerate(parts * copies)])


@given(st.lists(st.tuples(coordinates, coordinates, exponents), min_size=1, max_size=120), st.sampled_from([1e3, 1e6]))
@examples(100)
def test_sizes_that_span_a_million(parts, ratio):
    """Dust on a huge ground, and everything between."""
    dust = [plain((x, y), (x + 2.0 * s, y + s), k) for k, (x, y, s) in enumerate(parts)]
    huge = [plain((-ratio, -ratio), (ratio, 0.0), -1), plain((5.0, -3.0), (5.0 + 1e-3 * ratio, 9.0), -2)]
    agree([*dust, *huge])
    agree([*huge, *dust])


@given(
    st.lists(st.tuples(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(0.5, 2.0)), max_size=60),
    st.sampled_from([0.0, 1e8, -1e8, 1e9]),
)
@examples(100)
def test_bodies_scattered_over_a_million_metres_and_far_away(parts, far):
    scattered = [plain((x + far, y - far), (x + far + s, y - far + s), 3 * k) for k, (x, y, s) in enumerate(parts)]
    near = [plain((x + far + 0.5, y - far), (x + far + 1, y - far + s), 3 * k + 1) for k, (x, y, s) in enumerate(parts)]
    agree([*scattered, *near])


@given(st.integers(0, 2**32), st.floats(10.0, 1e6), st.booleans())
@examples(50)
def test_a_fast_body_whose_box_spans_thousands_of_cells(seed, length, upright):
    random = np.random.default_rng(seed)
    small = random.uniform(-100.0, 100.0, (200, 2))
    parts = [plain(p, p + 1.0, k) for k, p in enumerate(small)]
    parts.append(plain((-50.0, -1.0), (-50.0 + length, 1.0), 1000))
    parts.append(plain((-50.0, -length), (0.0, length) if upright else (length, length), 1001))
    agree(parts)


@given(st.integers(0, 2**32), st.sampled_from([0.25, 0.3, 1.0, 7.0]), st.sampled_from([0.0, 1e8, -1e8]))
@examples(60)
def test_a_lattice_with_boxes_exactly_on_cell_borders(seed, pitch, far):
    """All of one size, edge to edge: every border is somebody's cell border, and every touch counts."""
    random = np.random.default_rng(seed)
    cells = random.integers(-9, 9, (120, 2))
    parts = [plain(far + pitch * c, far + pitch * (c + 1), k) for k, c in enumerate(cells)]
    agree(parts)


@given(st.integers(0, 2**32), st.sampled_from([1e-6, 1e-5, 1e-3]))
@examples(60)
def test_specks_at_the_end_of_the_world(seed, size):
    """At 1e9 m neighbouring floats are 0.1 um apart: the middle of a box is rounded by much of its size."""
    random = np.random.default_rng(seed)
    place = 1e9 + size * random.integers(-5, 5, (80, 2)) * random.uniform(0.5, 1.5, (80, 2))
    agree([plain(p, p + size, k) for k, p in enumerate(place)])


@given(st.integers(0, 2**32))
@examples(30)
def test_many_levels_at_once(seed):
    random = np.random.default_rng(seed)
    side = 10.0 ** random.uniform(-4.0, 4.0, 150)
    place = random.normal(size=(150, 2)) * side[:, None]
    agree([plain(p, p + s, k) for k, (p, s) in enumerate(zip(place, side, strict=True))])


@given(st.integers(0, 2**32))
@examples(20)
def test_boxes_without_size_and_thin_ones(seed):
    random = np.random.default_rng(seed)
    corner = random.integers(-3, 3, (80, 2)).astype(float)
    way = random.choice([0.0, 1.0, 1e-12, 1e3], (80, 2))
    agree([plain(p, p + w, k) for k, (p, w) in enumerate(zip(corner, way, strict=True))])


@example([])
@given(st.lists(boxes(), max_size=2))
@examples(20)
def test_hardly_any_boxes(parts):
    agree(parts)


@pytest.mark.parametrize("capacity", [0, 1, 7, 44, 45, 46])
def test_pairs_past_the_capacity_are_counted_but_not_written(capacity):
    parts = [plain((0.1 * k, 0.0), (0.1 * k + 5.0, 1.0), k) for k in range(10)]
    grid = Grid(parts, capacity)
    assert grid.find() == 45
    written = grid.found(min(capacity, 45))
    assert len(set(written)) == len(written)
    assert set(written) <= set(all_pairs(parts))


@given(boxes(), boxes())
@examples(300)
def test_the_filter(a, b):
    filters = (a.category, a.mask, a.group, b.category, b.mask, b.group)
    assert bool(may_collide(*filters)) == may_meet(a, b)


@given(st.lists(boxes(), max_size=40), st.randoms())
@examples(50)
def test_the_order_of_shapes_changes_only_names(parts, random):
    order = list(range(len(parts)))
    random.shuffle(order)
    renamed = Grid([parts[k] for k in order]).sorted_pairs()
    assert sorted(tuple(sorted((order[a], order[b]))) for a, b in renamed) == all_pairs(parts)


def seconds(parts: list[Box]) -> float:
    """Best time of a few runs: of the processor, which what else runs does not lengthen."""
    grid = Grid(parts, 10)
    grid.find()
    times = []
    for _ in range(5):
        start = time.process_time()
        grid.find()
        times.append(time.process_time() - start)
    return min(times)


def field(count: int, spread: float = 1.5) -> list[Box]:
    """Boxes of 1 m on a square lattice."""
    side = int(count**0.5)
    return [
        plain((spread * x, spread * y), (spread * x + 1.0, spread * y + 1.0), x * side + y)
        for x in range(side)
        for y in range(side)
    ]


TRAPS = {
    "a huge ground": lambda f: [*f, plain((-1e5, -10.0), (1e5, 0.0), -1)],
    "dust among boulders": lambda f: [*f, *(plain((9.0 * k, 400.0), (9.0 * k + 1e3, 1400.0), -k) for k in range(12))],
    "scattered": lambda f: [
        replace(b, lower=(b.lower[0] * 1e4, b.lower[1] * 1e4), upper=(b.lower[0] * 1e4 + 1, b.lower[1] * 1e4 + 1))
        for b in f
    ],
    "a fast body": lambda f: [*f, plain((0.0, 0.0), (3e3, 3e3), -1)],
    "far away": lambda f: [
        replace(b, lower=(b.lower[0] + 1e8, b.lower[1]), upper=(b.upper[0] + 1e8, b.upper[1])) for b in f
    ],
}


@pytest.mark.parametrize("trap", TRAPS)
def test_the_grid_stays_linear(trap):
    """Many bodies in a trap take about as long as as many on a plain field: never a square or a lattice of cells."""
    parts = field(10_000)
    assert seconds(TRAPS[trap](parts)) < 8.0 * seconds(parts) + 1e-3

"""Abutting tiles, to the bit, against loops over all of them; and that many do not take long."""

from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import SetPose
from sandbox.scene.flat import FlatBody, FlatShape
from sandbox.world.build import build_state
from sandbox.world.records import SEAMED
from sandbox.world.state import State
from tests.flat import body, box, polygon, scene, world
from tests.naive.tiles import read_tiles, seams
from tests.shipped import FILES, shipped

SECONDS = 8.0
"""Processor time; half of it at most on a quiet machine, where it was minutes."""
halves = st.integers(-6, 6).map(lambda k: 0.5 * k)
near = st.sampled_from((0.0, 0.0, 0.0, 4e-7, 2e-6, 3e-5, 0.1))
places = st.builds(lambda x, y, dx, dy: (x + dx, y + dy), halves, halves, near, near)
sizes = st.sampled_from((0.5, 1.0, 1.5, 4.0))
turns = st.sampled_from((0.0, 0.0, 0.0, np.pi / 2, 0.3, np.pi / 4))
wedge = polygon((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
hexagon = polygon(*((float(np.cos(k * np.pi / 3)), float(np.sin(k * np.pi / 3))) for k in range(6)))
shapes = st.builds(box, sizes, sizes, category=st.sampled_from((1, 1, 1, 1, 2))) | st.sampled_from((wedge, hexagon))


def tiles(drawn: list[tuple[FlatShape, tuple[float, float], float]]) -> list[FlatBody]:
    return [body(f"{k}", shape, type="static", position=at, angle=turn) for k, (shape, at, turn) in enumerate(drawn)]


tilings = st.lists(st.tuples(shapes, places, turns), max_size=12).map(tiles)


def check(state: State) -> int:
    """Every tile has the rows that the judge finds; returns how many have any."""
    found, seamed = read_tiles(state), 0
    for row, tile in found.items():
        shape = state.shapes[row]
        expected = seams(found, row)
        if not tile.alone:
            continue
        assert bool(shape.traits & SEAMED) == (expected is not None), row
        if expected is not None:
            seamed += 1
            table = state.seams[shape.seam_start : shape.seam_start + shape.vertex_count]
            assert table.tobytes() == rows(state, row, expected), row
    return seamed


def rows(state: State, row: int, expected) -> bytes:
    """The rows of the seam table, as bytes."""
    turn = state.bodies[int(state.shapes[row].body)]
    c, s = float(turn.rotation_cos), float(turn.rotation_sin)
    found = [
        [value for x, y in sides for value in (c * x + s * y, c * y - s * x)] + [*shown]
        for sides, shown in zip(expected.sides, expected.shown, strict=True)
    ]
    return np.array(found, float).tobytes()


@given(tilings)
def test_random_tilings(bodies):
    check(build_state(scene(*bodies)))


@pytest.mark.parametrize("name", sorted(FILES))
def test_shipped_scenes(name):
    check(build_state(shipped(name).flatten()))


@given(tilings.filter(len), places)
def test_a_tile_that_is_moved(bodies, place):
    w = world(*bodies)
    w.apply(SetPose("0", place, 0.0))
    check(w.state)


def floor(count: int, size: float = 1.0) -> list[FlatBody]:
    """A square of so many tiles."""
    wide = int(count**0.5)
    return [
        body(f"{k}", box(size, size), type="static", position=(size * (k % wide), size * (k // wide)))
        for k in range(count)
    ]


def test_a_floor_of_many_tiles_is_seamed_within():
    assert check(build_state(scene(*floor(144)))) == 144


def test_a_crowd_in_one_place():
    """Most edges run within dozens of others."""
    draw = np.random.default_rng(5)
    crowd = [
        body(
            f"{k}",
            box(1.0 + 0.2 * draw.random(), 1.0),
            type="static",
            position=(0.5 * draw.random(), 0.5 * draw.random()),
            angle=float(draw.choice([0.0, 0.0, 0.4, 2.0])),
        )
        for k in range(50)
    ]
    assert check(build_state(scene(*crowd))) == 50


@pytest.mark.parametrize("missing", [None, 1, 16, 37])
def test_a_long_edge_is_covered_by_many_one_after_the_other(missing):
    """Up to the first gap from either end; some of those that cover it lie over each other, in no order."""
    places = [*range(0, 40, 2), *range(39, 0, -2)]
    bricks = [
        body(f"{k}", box(1.0 + 2.0 * (k % 7 == 5), 1.0), type="static", position=(k + 0.5, 0.5))
        for k in places
        if k != missing
    ]
    ledge = body("ledge", box(40.0, 1.0), type="static", position=(20.0, -0.5))
    state = build_state(scene(*bricks, ledge))
    check(state)
    top = state.seams[state.shapes[len(bricks)].seam_start + 2]
    shown = (float(top.shown_from), float(top.shown_to))
    gap = (1.0, 0.0) if missing is None else (1.0 - (missing + 1) / 40.0, 1.0 - missing / 40.0)
    assert shown == pytest.approx(gap, abs=1e-3)


def test_tiles_of_all_sizes_find_each_other():
    bodies = [
        body(f"{k}", box(2.0**k, 3.0 ** (k - 9)), type="static", position=(0.5 * 2.0**k, 0.5 * 3.0 ** (k - 9)))
        for k in range(-9, 10)
    ]
    assert check(build_state(scene(*bodies, *floor(49)))) > 0


def test_more_tiles_than_are_asked_touch_one_corner():
    """Of a fan of slivers only the first and the last have an edge in its tip that shows; few others are asked."""
    draw = np.random.default_rng(3)
    rays = [(float(np.cos(a)), float(np.sin(a))) for a in np.linspace(0.1, 2.8, 90)]
    fan = [
        body(f"{k}", polygon((0.0, 0.0), rays[k], rays[k + 1]), type="static") for k in draw.permutation(89).tolist()
    ]
    assert check(build_state(scene(*fan))) == 89


def crowd(count: int, kind: str) -> list[dict]:
    """Static shapes over each other, as a scene file has them: the same, side by side, turned, or with one tip."""
    shapes = {"fan": lambda k: {"polygon": [[0, 0], [1, 1e-3 * k], [1, 1e-3 * (k + 1)]]}}
    return [
        {
            "id": f"{kind}-{k}",
            "type": "static",
            "shapes": [shapes.get(kind, lambda k: {"box": [1, 1]})(k)],
            "position": [1e-3 * k if kind == "row" else 0, 0],
            "angle": 0.1 * k if kind == "star" else 0,
        }
        for k in range(count)
    ]


@pytest.mark.parametrize("kind", ["same", "row", "star", "fan"])
def test_what_lies_over_each_other_in_its_hundreds_is_joined_in_time(kind):
    w = sandbox.World(sandbox.Scene())
    w.spawn(crowd(2, kind))
    w.delete([*w.names])
    began = time.process_time()
    w.spawn(crowd(900, kind))
    assert time.process_time() - began < SECONDS


@pytest.mark.parametrize("kind", ["same", "row", "star", "fan"])
def test_more_is_refused_at_once_and_nothing_has_changed(kind):
    bodies = crowd(2400, kind)
    few = sandbox.World(sandbox.Scene(bodies=bodies[:20]))
    digest, names = few.digest(), few.names
    began = time.process_time()
    with pytest.raises(sandbox.CapacityError, match=r"pairs of 2,400 static shapes lie over each other"):
        sandbox.World(sandbox.Scene(bodies=bodies))
    with pytest.raises(sandbox.CommandError, match=r"pairs of 2,400 static shapes lie over each other"):
        few.spawn(bodies[20:])
    assert time.process_time() - began < SECONDS
    assert (few.digest(), few.names) == (digest, names)
    few.spawn(bodies[20:40])
    assert few.digest() == sandbox.World(sandbox.Scene(bodies=bodies[:40])).digest()


def test_a_tile_that_would_make_it_too_many_stays_where_it_is():
    """Halves of a crowd far from each other, on one body each; one is put over the other."""
    half = [{"box": [1, 1]} for _ in range(600)]
    halves = [
        {"id": "left", "type": "static", "shapes": half, "position": [0, 0]},
        {"id": "right", "type": "static", "shapes": half, "position": [50, 0], "angle": 20},
    ]
    w = sandbox.World(sandbox.Scene(bodies=halves))
    digest = w.digest()
    with pytest.raises(sandbox.CommandError, match=r"SetPose.*static shapes lie over each other"):
        w.apply(SetPose("right", (0.0, 0.0), 0.1))
    assert w.digest() == digest
    w.apply(SetPose("right", (30.0, 0.0), 0.1))
    assert w.body("right").position == (30.0, 0.0)


def test_a_large_level_with_slabs_behind_it_is_no_crowd():
    slabs = [body(f"s{k}", box(200.0, 200.0), type="static", position=(0.1 * k, 0.0)) for k in range(12)]
    build_state(scene(*slabs, *floor(10_000)))

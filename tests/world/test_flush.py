"""Abutting tiles, to the bit, against loops over all of them; and that many do not take long."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sandbox import SetPose
from sandbox.scene.flat import FlatBody, FlatShape
from sandbox.scene.flat_chain import seams as chain_seams
from sandbox.world import tile_corners
from sandbox.world.build import build_state
from sandbox.world.records import SEAMED
from sandbox.world.state import State
from tests.flat import body, box, polygon, scene, segment, world
from tests.naive.tiles import Tile, read_tiles, seams
from tests.shipped import FILES, shipped

halves = st.integers(-6, 6).map(lambda k: 0.5 * k)
near = st.sampled_from((0.0, 0.0, 0.0, 4e-7, 2e-6, 3e-5, 0.1))
places = st.builds(lambda x, y, dx, dy: (x + dx, y + dy), halves, halves, near, near)
sizes = st.sampled_from((0.5, 1.0, 1.5, 4.0))
turns = st.sampled_from((0.0, 0.0, 0.0, np.pi / 2, 0.3, np.pi / 4))
wedge = polygon((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
hexagon = polygon(*((float(np.cos(k * np.pi / 3)), float(np.sin(k * np.pi / 3))) for k in range(6)))
boxes = st.builds(
    box, sizes, sizes, category=st.sampled_from((1, 1, 1, 1, 2)), sensor=st.sampled_from((*3 * (False,), True))
)
ends = st.sampled_from(((0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (2.0, 0.0), (0.5, 0.5), (0.0, 1.0), (1.0, 1e-5)))
lines = st.tuples(ends, ends, st.sampled_from((0.0, 0.0, 0.0, 0.25, 0.5))).filter(lambda line: line[0] != line[1])
shapes = boxes | st.sampled_from((wedge, hexagon)) | lines.map(lambda line: segment(*line[:2], radius=line[2]))


def tiles(drawn: list[tuple[FlatShape, tuple[float, float], float]]) -> list[FlatBody]:
    return [body(f"{k}", shape, type="static", position=at, angle=turn) for k, (shape, at, turn) in enumerate(drawn)]


drawings = st.lists(st.tuples(shapes, places, turns), max_size=12)
tilings = drawings.map(tiles)


def assembled(drawn: list[tuple[FlatShape, tuple[float, float], float]]) -> FlatBody:
    """The same as one body that moves."""
    return body("all", *(placed(*each) for each in drawn), type="kinematic", position=(3.0, 1.0), angle=0.7)


def placed(shape: FlatShape, at: tuple[float, float], turn: float) -> FlatShape:
    """A shape elsewhere in its body."""
    c, s = float(np.cos(turn)), float(np.sin(turn))
    corners = tuple((at[0] + (c * x - s * y), at[1] + (s * x + c * y)) for x, y in shape.vertices)
    return replace(shape, vertices=corners)


def check(state: State) -> int:
    """Every tile has the rows that the judge finds; returns how many have any."""
    wholes: dict[int, dict[int, Tile]] = {}
    for row, tile in read_tiles(state).items():
        wholes.setdefault(tile.whole, {})[row] = tile
    seamed = 0
    for row, tile in ((row, tile) for whole in wholes.values() for row, tile in whole.items()):
        shape = state.shapes[row]
        expected = seams(wholes[tile.whole], row)
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
    c, s = (float(turn.rotation_cos), float(turn.rotation_sin)) if turn.type == 0 else (1.0, 0.0)
    found = [
        [value for x, y in sides for value in (c * x + s * y, c * y - s * x)] + [*shown]
        for sides, shown in zip(expected.sides, expected.shown, strict=True)
    ]
    return np.array(found, float).tobytes()


@given(tilings)
def test_random_tilings(bodies):
    check(build_state(scene(*bodies)))


@given(drawings, drawings)
def test_random_tilings_in_bodies_that_move(one, other):
    check(build_state(scene(assembled(one), replace(assembled(other), id="other", angle=0.0))))


capsules = st.builds(lambda half, radius: segment((-half, 0.0), (half, 0.0), radius=radius), sizes, sizes)
anywhere = st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))


@given(capsules, st.lists(st.tuples(boxes | capsules | st.just(wedge), anywhere, st.floats(0.0, 6.3)), max_size=3))
@example(segment((-0.5, 0.0), (0.5, 0.0), radius=0.5), [(wedge, (-0.6, 0.2), 0.3)])
def test_round_ends_within_others(capsule, others):
    check(build_state(scene(assembled([(capsule, (0.0, 0.0), 0.0), *others]))))


@pytest.mark.parametrize("name", sorted(FILES))
def test_shipped_scenes(name):
    check(build_state(shipped(name).flatten()))


@given(tilings.filter(len), places)
def test_a_tile_that_is_moved(bodies, place):
    w = world(*bodies)
    w.apply(SetPose("0", place, 0.0))
    check(w.state)


corners = st.lists(st.tuples(st.floats(0.5, 2.0), st.floats(-1.5, 1.5)), min_size=2, max_size=6)


@given(corners, st.booleans())
def test_lines_end_to_end_are_a_chain(steps, flip):
    """Whichever way each runs; a chain knows from the scene on what joins its links."""
    points = [(0.0, 0.0)]
    for x, y in steps:
        points.append((points[-1][0] + x, points[-1][1] + y))
    links = [*itertools.pairwise(points)]
    parts = [segment(*(link[::-1] if flip and k % 2 else link)) for k, link in enumerate(links)]
    expected = chain_seams(points, False, False, None)
    for kind in ("static", "kinematic"):
        state = build_state(scene(body("line", *parts, type=kind)))
        assert (state.shapes.traits == SEAMED).all()
        found = np.array(state.seams.tolist()).reshape(-1, 2, 6)
        for k, rows in enumerate(expected):
            turned = found[k, ::-1] if flip and k % 2 else found[k]
            for end, row in enumerate(rows):
                sides = sorted([tuple(turned[end, :2]), tuple(turned[end, 2:4])])
                straight = abs(row[0] * row[3] - row[1] * row[2]) < 1e-9 and 0 < k + end < len(links)
                if not straight:  # any of the two normals does there
                    assert np.allclose(sides, sorted([row[:2], row[2:4]]), atol=1e-12)
            assert (found[k, :, 4:] == (0.0, 1.0)).all()


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


def pinwheel(count: int) -> list[FlatBody]:
    """Tiles that all turn one of their corners to the same place."""
    corner = polygon((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
    return [body(f"{k}", corner, type="static", angle=2 * np.pi * k / count) for k in range(count)]


def test_where_a_crowd_meets_in_a_point_no_tile_is_held_against_all_the_others(monkeypatch):
    """That would take the cube of their number."""
    asked: list[int] = []
    is_free = tile_corners._Search._is_free

    def counted(search, places, tiles, edges, ahead):
        asked.append(len(places))
        return is_free(search, places, tiles, edges, ahead)

    monkeypatch.setattr(tile_corners._Search, "_is_free", counted)
    check(build_state(scene(*pinwheel(30))))
    assert sum(asked) > 0
    asked.clear()
    build_state(scene(*pinwheel(200)))
    assert sum(asked) == 0


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

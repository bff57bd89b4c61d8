"""Overlays about bodies: where they are, how fast, what holds them, who sleeps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.camera import Camera
from sandbox.render.overlays.islands import islands_of, lowest_row
from sandbox.render.overlays.pen import LABEL, Pen
from tests.examples import examples
from tests.naive.islands import islands
from tests.render.overlays.looks import GROUND, SIZE, crate, look_at, own_marks, shipped_world, words, world_of

CAMERA = Camera((0.0, 1.0), 40.0, SIZE)


@examples(200)
@given(st.integers(1, 12), st.lists(st.tuples(st.integers(0, 11), st.integers(0, 11)), max_size=16))
def test_lowest_rows_are_those_of_a_flood(count: int, links: list[tuple[int, int]]) -> None:
    links = [(a % count, b % count) for a, b in links]
    found = lowest_row(count, np.array(links, np.int64).reshape(-1, 2))
    assert found.tolist() == islands(count, links, [True] * count)


def test_islands_are_stacks() -> None:
    world = world_of(GROUND, *(crate(f"{x}-{k}", x, 0.5 + k) for x in (-3, 0, 3) for k in range(2)), steps=20)
    assert islands_of(look_at(world)).tolist() == [-1, 1, 1, 3, 3, 5, 5]
    tint = own_marks("islands", look_at(world)).tints[0]
    assert tint.amount[0] == 0.0
    assert (tint.color[1] == tint.color[2]).all()
    assert not (tint.color[1] == tint.color[3]).all()


def test_a_chain_of_joints_is_one_island() -> None:
    world = shipped_world("pendulums", 10)
    island = islands_of(look_at(world))
    for joint in world.state.joints:
        if joint.body_a >= 0 and joint.body_b >= 0 and island[joint.body_a] >= 0 and island[joint.body_b] >= 0:
            assert island[joint.body_a] == island[joint.body_b]


def test_velocities_point_along_the_motion() -> None:
    world = world_of(crate("a", 0, 0, velocity=[4, 3]), gravity=[0, 0], steps=1)
    look = look_at(world, CAMERA)
    strokes = own_marks("velocities", look).strokes
    green = (strokes.color == look.palette.green).all(axis=1)
    way = strokes.end[green] - strokes.start[green]
    shaft = way[np.hypot(*way.T).argmax()]
    assert shaft == pytest.approx(42.0 * np.array([0.8, -0.6]), rel=1e-6)
    assert "5 m/s" in own_marks("velocities", look).legend[0].text


def test_sleepers_are_blue_and_those_kept_awake_red() -> None:
    belt = {"id": "belt", "type": "static", "shapes": [{"box": [20, 1], "surface_speed": 1}], "position": [0, 4]}
    world = world_of(GROUND, belt, crate("a", 0, 0.5), crate("b", 3, 5.0), steps=200)
    look = look_at(world, CAMERA)
    tint = own_marks("sleep", look).tints[0]
    assert tint.color[2] == pytest.approx(look.palette.blue)
    assert tint.color[3] == pytest.approx(look.palette.red)
    assert tint.amount[:2].tolist() == [0.0, 0.0]


def test_levels_are_those_of_a_pile_that_needs_them() -> None:
    heavy = {"id": "heavy", "shapes": [{"box": [1, 1], "density": 400}], "position": [0, 1.5]}
    world = world_of(GROUND, crate("light", 0, 0.5), heavy, steps=10)
    marks = own_marks("levels", look_at(world, CAMERA))
    level = int(world.scratch.solver.free_motions.substep_level[1])
    assert level > 0
    assert words([marks]) == {f"x{2**level}"}


def test_sensors_tell_what_is_in_them() -> None:
    gate = {"id": "gate", "type": "static", "shapes": [{"box": [2, 2], "sensor": True}], "position": [0, 0.5]}
    far = {"id": "far", "type": "static", "shapes": [{"box": [2, 2], "sensor": True}], "position": [5, 0.5]}
    world = world_of(GROUND, gate, far, crate("a", 0, 0.5), steps=2)
    marks = own_marks("sensors", look_at(world, CAMERA))
    names = world.names
    assert {"gate: 2", "far: 1"} == words([marks]) or {"gate: 1", "far: 0"} == words([marks])
    assert marks.tints[0].amount[names.index("a")] > 0.0


def test_sweeps_show_what_a_wall_has_stopped() -> None:
    wall = {"id": "wall", "type": "static", "shapes": [{"segment": [[4, -5], [4, 5]]}]}
    ball = {"id": "ball", "shapes": [{"circle": 0.1}], "position": [0, 0], "velocity": [0, 0]}
    rod = {"id": "rod", "shapes": [{"box": [2, 0.02]}], "position": [3.5, 0], "angle": 90, "angular_velocity": -9000,
           "velocity": [30, 0]}  # fmt: skip
    world = world_of(wall, ball, rod, gravity=[0, 0])
    stopped = False
    for _ in range(20):
        world.step()
        marks = own_marks("sweeps", look_at(world, CAMERA))
        assert "swept: 1" in marks.legend[0].text or "swept: 0" in marks.legend[0].text
        stopped = stopped or any(text.endswith("%") for text in words([marks]))
    assert stopped


def test_joints_show_the_weight_that_they_carry() -> None:
    bob = {"id": "bob", "shapes": [{"circle": 0.5, "density": 1}], "position": [0, 0]}
    rod = {"id": "rod", "type": "distance", "bodies": [None, "bob"], "anchors": [[0, 3], [0, 0]]}
    world = world_of(bob, steps=60, joints=[rod])
    marks = own_marks("joints", look_at(world, CAMERA))
    weight = float(world.body("bob").mass) * 9.81
    assert words([marks]) == {f"{weight:.3g} N"}
    strokes = marks.strokes
    orange = (strokes.color == look_at(world).palette.orange).all(axis=1)
    way = (strokes.end - strokes.start)[orange]
    assert way[np.abs(way[:, 1]).argmax(), 1] < -20.0  # up


def test_centres_of_mass_lie_where_they_are() -> None:
    tool = {"id": "t", "shapes": [{"box": [1, 1]}, {"box": [1, 1], "at": [2, 0]}], "position": [0, 0]}
    look = look_at(world_of(tool), CAMERA)
    strokes = own_marks("centers", look).strokes
    dot = (strokes.color == look.palette.yellow).all(axis=1)
    assert strokes.start[dot] == pytest.approx(CAMERA.to_screen([[1.0, 0.0]]))


@pytest.mark.parametrize(("pixels_a_metre", "factor"), [(10.0, 0.44), (40.0, 1.0), (90.0, 1.45), (500.0, 1.6)])
def test_marks_are_small_on_small_bodies_and_large_on_large_ones(pixels_a_metre: float, factor: float) -> None:
    look = look_at(world_of(GROUND, crate("crate", 0, 0.5), steps=1), Camera((0.0, 0.5), pixels_a_metre, SIZE))
    assert look.mark_scale == pytest.approx(factor, abs=0.02)
    assert replace(look, scale=2.0).mark_scale >= 0.8
    pen = Pen(look)
    pen.label("words", (100.0, 100.0), look.palette.text)
    assert pen.marks().labels[0].size == LABEL  # can be read on any

"""Overlays about contacts, against what must hold for bodies that rest."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.render.camera import Camera
from sandbox.render.overlays.colors import contact_colors
from sandbox.render.overlays.features import feature_text
from sandbox.render.overlays.look import MARK_SCALES
from sandbox.render.overlays.scale import FARTHEST, REACH, lengths, reach, round_scale
from sandbox.render.overlays.separations import millimetres
from sandbox.world.records import DYNAMIC
from tests.render.overlays.looks import GROUND, SIZE, crate, look_at, own_marks, shipped_world, words, world_of

CAMERA = Camera((0.0, 1.0), 80.0, SIZE)


@pytest.fixture
def resting() -> World:
    return world_of(GROUND, crate("a", 0, 0.5), crate("b", 3, 0.5), steps=120, settings={"sleeping": False})


def test_contact_points_lie_under_the_corners_and_push_the_weight(resting: World) -> None:
    points = look_at(resting, CAMERA).points
    assert len(points) == 4
    ground = CAMERA.to_screen([[0.0, 0.0]])[0, 1]
    assert points.pixel[:, 1] == pytest.approx([ground] * 4, abs=0.5)
    assert sorted(points.pixel[:, 0]) == pytest.approx(
        CAMERA.to_screen([(x, 0) for x in (-0.5, 0.5, 2.5, 3.5)])[:, 0], abs=1
    )
    assert points.normal == pytest.approx(np.tile([0.0, -1.0], (4, 1)), abs=1e-6)  # up, on a screen
    weight = float(resting.body("a").mass) * 9.81
    assert points.pushing.sum() == pytest.approx(2 * weight, rel=0.02)
    assert points.touching.all()


def test_points_out_of_sight_are_left_out(resting: World) -> None:
    assert len(look_at(resting, Camera((0.0, 1.0), 80.0, (200, 200))).points) == 2


def test_normals_are_arrows_up_from_the_points(resting: World) -> None:
    look = look_at(resting, CAMERA)
    strokes = own_marks("contacts", look).strokes
    orange = (strokes.color == look.palette.orange).all(axis=1)
    shafts = orange & (np.hypot(*(strokes.end - strokes.start).T) > 15.0)
    assert shafts.sum() == 4
    assert (strokes.end[shafts, 1] < strokes.start[shafts, 1] - 15.0).all()


def test_a_crate_that_slides_shows_friction_against_its_way_in_the_colour_of_sliding() -> None:
    world = world_of(GROUND, crate("a", 0, 0.5, velocity=[6, 0]), steps=6)
    look = look_at(world, CAMERA)
    strokes = own_marks("impulses", look).strokes
    red = (strokes.color == look.palette.red).all(axis=1)
    way = strokes.end[red] - strokes.start[red]
    shafts = way[np.abs(way[:, 0]) > 12.0]  # longer than a head
    points = look.points
    assert len(shafts) > 0
    # The normal goes from the ground to the crate, so arrows are what the ground does to it: it slides to the right.
    assert (shafts[:, 0] < 0.0).all()
    assert np.abs(points.sliding) == pytest.approx(points.friction * points.pushing, rel=0.02)


def test_force_arrows_are_to_scale(resting: World) -> None:
    look = look_at(resting, CAMERA)
    marks = own_marks("impulses", look)
    scale = round_scale(look.points.pushing)
    orange = (marks.strokes.color == look.palette.orange).all(axis=1)
    way = (marks.strokes.start - marks.strokes.end)[orange, 1]
    shafts = np.sort(way)[-4:]
    assert shafts == pytest.approx(np.sort(lengths(look.points.pushing, scale, reach(look))), abs=0.1)
    assert marks.legend[0].length == REACH


def test_arrows_grow_with_the_bodies_that_are_seen(resting: World) -> None:
    reaches = [reach(look_at(resting, Camera((0.0, 1.0), scale, SIZE))) for scale in (1.0, 80.0, 200.0, 300.0, 5000.0)]
    assert reaches[0] == pytest.approx(MARK_SCALES[0] * REACH)  # as all marks on small bodies
    assert reaches[1] == REACH
    assert REACH < reaches[2] < reaches[3] < FARTHEST
    assert reaches[4] == REACH  # only the ground is in sight


def test_the_cone_is_as_wide_as_friction_says(resting: World) -> None:
    look = look_at(resting, CAMERA)
    cones = own_marks("impulses", look).fills[0].points
    high = np.abs(cones[:, 1, 1] - cones[:, 0, 1])
    half = np.abs(cones[:, 1, 0] - cones[:, 2, 0]) / 2
    assert half / high == pytest.approx(look.points.friction)


@pytest.mark.parametrize(
    ("values", "scale"), [([3.0], 5.0), ([5.0], 5.0), ([0.021, 0.03], 0.05), ([], 1.0), ([0.0], 1.0)]
)
def test_scales_are_round(values: list[float], scale: float) -> None:
    assert round_scale(np.array(values)) == pytest.approx(scale)


def test_separations_and_features_in_words(resting: World) -> None:
    look = look_at(resting, CAMERA)
    for text in words([own_marks("separations", look)]):
        assert -1.0 < float(text) <= 0.5
    assert words([own_marks("features", look)]) <= {f"a{i} b{j}" for i in range(4) for j in range(4)}
    assert (millimetres(-0.00012), millimetres(0.0345), millimetres(0.5)) == ("-0.12", "+34.5", "+500")
    assert (millimetres(-4e-6), millimetres(0.0), millimetres(-6e-6)) == ("0", "0", "-0.01")
    assert (feature_text(3 * 64 + 1), feature_text(-1)) == ("a3 b1", "-")


@pytest.mark.parametrize("scene", ["pyramid-10", "pile"])
def test_contacts_of_one_colour_share_no_moving_body(scene: str) -> None:
    world = shipped_world(scene, 20)
    color = contact_colors(look_at(world))
    assert (color >= 0).any()
    kinds = world.state.bodies.type
    for own in np.unique(color[color >= 0]):
        rows = world.contacts[color == own]
        bodies = [b for row in rows for b in (int(row.body_a), int(row.body_b)) if kinds[b] == DYNAMIC]
        assert len(bodies) == len(set(bodies))


def test_touching_pairs_and_those_turned_down() -> None:
    # The boxes of two turned crates overlap, the crates do not.
    world = world_of(crate("a", 0, 0, angle=45), crate("b", 1.1, 1.1, angle=45), crate("c", -0.99, 0.0, angle=45),
                     gravity=[0, 0], steps=1)  # fmt: skip
    legend = [entry.text for entry in own_marks("pairs", look_at(world)).legend]
    assert legend == ["touching: 1", "proposed by the grid, apart: 1"]

"""Regions in pictures: areas, the line on water, streaks, flames; nothing where nothing acts."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera
from sandbox.render.draw_list import build_draw_list
from sandbox.render.field_drawing import OPACITY, field_strokes, region_fills
from sandbox.render.field_frame import capture_fields
from sandbox.render.frame import capture
from sandbox.render.surface_painter import SurfacePainter
from sandbox.render.theme import DARK
from sandbox.scene.flat import FlatRegion, FlatThruster
from tests.fields.pools import inside, water
from tests.flat import body, circle, world

CAMERA = Camera((0.0, 0.0), 20.0, (400, 300))


def made(*regions: FlatRegion, thrusters: tuple[FlatThruster, ...] = ()) -> World:
    return world(body("it", circle(0.5), position=(0.0, 60.0), thrusters=thrusters), regions=regions)


def test_a_box_is_filled_from_corner_to_corner():
    (fill,) = region_fills(
        capture_fields(made(FlatRegion("gravity", inside(-2.0, -1.0, 3.0, 4.0))).state), CAMERA, DARK
    )
    assert fill.points.min(axis=0) == pytest.approx((160.0, 70.0))
    assert fill.points.max(axis=0) == pytest.approx((260.0, 170.0))
    assert fill.color == DARK.gravity


def test_an_endless_pool_ends_with_the_picture_and_has_a_line():
    marks = capture_fields(made(water(surface=1.0)).state)
    (fill,) = region_fills(marks, CAMERA, DARK)
    assert fill.points[:, 1].min() == pytest.approx(130.0)
    assert fill.points[:, 1].max() < 320.0
    (line,) = field_strokes(marks, CAMERA, DARK)
    assert (line.start[1], line.end[1]) == pytest.approx((130.0, 130.0))
    assert line.start[0] <= 0.0
    assert line.end[0] >= 400.0


def test_a_disc_of_wind_has_streaks_within_it():
    marks = capture_fields(made(FlatRegion("wind", disc=(0.0, 0.0, 6.0), flow=(0.0, 3.0), density=1.0)).state)
    (fill,) = region_fills(marks, CAMERA, DARK)
    assert np.hypot(*(fill.points - (200.0, 150.0)).T) == pytest.approx(120.0)
    lines = field_strokes(marks, CAMERA, DARK)
    assert len(lines) > 3
    for line in lines:
        assert np.hypot(line.start[0] - 200.0, line.start[1] - 150.0) <= 120.0
        assert line.end[1] < line.start[1]


def test_what_does_not_act_or_is_everywhere_is_not_seen():
    idle = FlatRegion("wind", inside(0.0, 0.0, 1.0, 1.0), start=5.0)
    marks = capture_fields(made(idle, FlatRegion("gravity_scale", scale=0.5)).state)
    assert region_fills(marks, CAMERA, DARK) == []
    assert capture_fields(made().state).regions == ()


def test_a_flame_points_away_from_the_force():
    burning = made(thrusters=(FlatThruster((0.0, 2.0), (0.0, -0.5), end=1.0),))
    (flame,) = capture_fields(burning.state).flames
    assert flame == pytest.approx((0.0, 59.5, 0.0, -1.0))
    burning.step(60)
    assert len(capture_fields(burning.state).flames) == 0


def test_the_painter_lays_the_fill_under_everything():
    scene = made(FlatRegion("gravity", inside(-2.0, -1.0, 3.0, 4.0)))
    picture = build_draw_list(capture(scene.state), CAMERA, body_colors_of(scene.state))
    image = np.asarray(SurfacePainter().paint(picture), float) / 255.0
    expected = (1.0 - OPACITY) * np.array(DARK.background) + OPACITY * np.array(DARK.gravity)
    assert image[112, 233] == pytest.approx(expected, abs=0.01)
    assert image[250, 233] == pytest.approx(DARK.background, abs=0.01)

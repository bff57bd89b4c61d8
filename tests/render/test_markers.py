"""Markers of what is too small to see, trails, and the width of what is thin."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera
from sandbox.render.draw_list import THIN_HALF_PIXELS, build_draw_list
from sandbox.render.frame import capture
from sandbox.render.markers import RING, markers
from sandbox.render.overlays.registry import OVERLAYS
from sandbox.render.shots import Shooting, Style, shots
from sandbox.render.theme import DARK
from sandbox.render.trails import SECONDS, Trails

FAR = Camera((0.0, 0.0), 1.0, (640, 400))


def world_of(*places: tuple[float, float], velocity: tuple[float, float] = (0.0, 0.0)) -> sandbox.World:
    bodies = [
        {"id": f"b{k}", "position": list(at), "velocity": list(velocity), "shapes": [{"circle": 0.5}]}
        for k, at in enumerate(places)
    ]
    return sandbox.World(sandbox.Scene.model_validate({"format": 1, "gravity": [0, 0], "bodies": bodies}))


def marks_of(world: sandbox.World, camera: Camera) -> Any:
    return markers(capture(world.state), camera, body_colors_of(world.state).base).strokes


def test_a_small_body_by_itself_gets_a_ring_in_its_colour() -> None:
    world = world_of((0, 0), (100, 50))
    rings = marks_of(world, FAR)
    ends = rings.start[2:].reshape(2, -1, 2)
    middles = FAR.to_screen([(0, 0), (100, 50)])
    assert np.hypot(*(ends - middles[:, None]).reshape(-1, 2).T) == pytest.approx(RING)
    assert rings.color[0] == pytest.approx(body_colors_of(world.state).base[0])


def test_crowds_and_what_is_large_enough_get_none() -> None:
    assert len(marks_of(world_of((0, 0), (5, 0), (0, 7)), FAR)) == 0
    assert len(marks_of(world_of((0, 0)), Camera((0.0, 0.0), 20.0, (640, 400)))) == 0
    assert len(marks_of(world_of((1000, 0)), FAR)) == 0
    assert len(marks_of(world_of(), FAR)) == 0


def test_markers_fade_in_as_one_zooms_out() -> None:
    world = world_of((0, 0))
    opacity = [marks_of(world, Camera((0.0, 0.0), scale, (640, 400))).opacity.max() for scale in (7.0, 5.0, 2.0)]
    assert 0.0 < opacity[0] < opacity[1] < opacity[2] == 1.0


def test_a_thin_plank_is_more_than_a_hairline() -> None:
    plank = {"id": "plank", "shapes": [{"box": [20, 0.1]}]}
    state = sandbox.World(sandbox.Scene.model_validate({"format": 1, "bodies": [plank]})).state
    picture = build_draw_list(capture(state), Camera((0.0, 0.0), 2.0, (640, 400)), body_colors_of(state))
    assert picture.mesh.thickness[0] * 2.0 + picture.shapes.grow[0] == pytest.approx(THIN_HALF_PIXELS)


def test_trails_lead_from_where_a_body_was_to_where_it_is() -> None:
    world, trails, camera = world_of((0, 0), velocity=(3.0, 0.0)), Trails(), Camera((0.0, 0.0), 20.0, (640, 400))
    for _ in range(400):
        world.step()
        trails.note(world.state)
    start, end, rows = trails.lines(capture(world.state), camera)
    assert rows.tolist() == [0]
    assert end[0, -1] == pytest.approx(camera.to_screen(capture(world.state).center[0]))
    assert start[0, 0, 0] == pytest.approx(end[0, -1, 0] - 20.0 * 3.0 * SECONDS, abs=20.0 * 3.0 * 0.1)
    assert end[0, :-1] == pytest.approx(start[0, 1:])


def test_trails_forget_what_comes_after_a_jump_back_and_know_only_who_is_wanted() -> None:
    world, trails = world_of((0, 0), (0, 5), velocity=(3.0, 0.0)), Trails()
    for _ in range(100):
        world.step()
        trails.note(world.state)
    trails.forget(41)
    start, end, rows = trails.lines(capture(world.state), FAR)
    assert sorted(rows.tolist()) == [0, 1]
    assert end[0, -1, 0] - start[0, -1, 0] == pytest.approx(3.0, abs=0.01)  # the 60 steps that were forgotten
    trails.only = ("b1",)
    assert trails.lines(capture(world.state), FAR)[2].tolist() == [1]


def test_a_trail_stays_with_its_body_when_another_goes() -> None:
    world, trails = world_of((0, 0), (0, 5), velocity=(3.0, 0.0)), Trails()
    for step in range(60):
        if step == 30:
            world.apply(sandbox.Delete("b0"))
        world.step()
        trails.note(world.state)
    start, _, rows = trails.lines(capture(world.state), FAR)
    assert rows.tolist() == [0]
    assert start[0, :, 1] == pytest.approx(FAR.to_screen((0, 5))[1])


class Steps:
    def __init__(self, world: sandbox.World) -> None:
        self.world = world

    def advance(self) -> None:
        self.world.step()


def test_films_have_trails_where_the_overlay_is_asked_for() -> None:
    for overlays, drawn in (([OVERLAYS["trails"]], True), ([], False)):
        stepping = Steps(world_of((0, 0), velocity=(3.0, 0.0)))
        shooting = Shooting(stepping.world, Style((640, 400), DARK, center=(0.0, 0.0), height=10.0, overlays=overlays))
        *_, last = shots(stepping, range(60), 0.25, shooting)
        lines = [layer.strokes for layer in last.marks if len(layer.strokes)]
        assert bool(lines) == drawn
    stepping = Steps(world_of((0, 0)))
    shooting = Shooting(stepping.world, Style((640, 400), DARK, overlays=[OVERLAYS["trails"]]))
    *_, last = shots(stepping, range(60), 0.25, shooting)
    assert not any(len(layer.strokes) for layer in last.marks)  # what rests leaves none


def test_who_comes_into_an_empty_world_has_no_trail_from_before() -> None:
    world, trails = world_of(), Trails()
    world.step(4)
    trails.note(world.state)
    world.spawn({"id": "late", "position": [0, 0], "velocity": [60, 0], "shapes": [{"circle": 0.5}]})
    world.step(4)
    trails.note(world.state)
    world.step(4)
    start, end, rows = trails.lines(capture(world.state), FAR)
    assert rows.tolist() == [0]
    assert np.isnan(start[0, 0]).all()
    assert np.hypot(*(end[0, 1] - start[0, 1])) == pytest.approx(4.0)

"""Water and wind by real keys and clicks: drawn, picked, erased, undone, saved."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import pytest

import sandbox
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.tools.region_pick import region_at
from sandbox.world.export.scene_now import scene_of
from sandbox.world.region_area import box_of, corners_of, disc_of, level_of
from tests.window.hands import play

SCENE = sandbox.Scene(
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [-3, 0.5]},
    ],
    view={"center": [0, 3], "height": 12},
)
POOL = "key I\ndrag @-5,3 to @-1,0.25\nwait 2\n"


def regions(screen: PlayScreen) -> tuple[str, ...]:
    return screen.session.world.state.census.regions.ids


@pytest.mark.slow
def test_a_crate_floats_in_water_that_was_drawn_and_sinks_back_when_it_is_gone(canvas: Canvas, tmp_path: Path) -> None:
    heights: list[float] = []

    def drawn(screen: PlayScreen) -> None:
        assert (regions(screen), screen.workspace.selection.region) == (("water-1",), "water-1")
        screen.session.clock.paused = False

    def look(screen: PlayScreen) -> None:
        heights.append(screen.session.world.body("crate").position[1])

    screen = play(
        canvas, SCENE, tmp_path, POOL, drawn, "wait 90\n", look, "key Delete\nwait 90\n", look, "key Ctrl+Z\nwait 3\n"
    )  # fmt: skip
    assert heights[0] > 1.0
    assert heights[1] < 0.6
    assert regions(screen) == ("water-1",)


def test_what_is_selected_next_takes_the_place_of_a_region(canvas: Canvas, tmp_path: Path) -> None:
    def all_bodies(screen: PlayScreen) -> None:
        selection = screen.workspace.selection
        assert (selection.bodies, selection.region) == (("crate",), None)

    def pasted(screen: PlayScreen) -> None:
        selection = screen.workspace.selection
        assert len(selection.bodies) == 1
        assert selection.region is None

    acts = POOL + "key Ctrl+A\nwait 2\n", all_bodies, "key Ctrl+C\n" + POOL + "key Ctrl+V\nwait 2\n", pasted
    play(canvas, SCENE, tmp_path, *acts)


def test_a_click_picks_a_region_and_the_eraser_takes_it_where_nothing_else_is(canvas: Canvas, tmp_path: Path) -> None:
    def picked(screen: PlayScreen) -> None:
        assert screen.workspace.selection.region == "wind-1"

    def left(screen: PlayScreen) -> None:
        assert regions(screen) == ("water-1", "wind-1")
        assert screen.session.world.names == ("ground",)

    screen = play(
        canvas, SCENE, tmp_path, POOL + "key D\ndrag @-4,1.5 to @3,5\n", "key V\nclick @2,4\nwait 2\n", picked,
        "key E\nclick @-3,0.5\nwait 2\n", left, "click @-2,2\nwait 2\n",
    )  # fmt: skip
    assert regions(screen) == ("wind-1",)  # the smaller one of two went


def test_a_scene_and_a_recording_of_now_have_what_was_drawn(canvas: Canvas, tmp_path: Path) -> None:
    screen = play(canvas, SCENE, tmp_path, POOL + "key D\ndrag @1,1 to @3,5\n")
    saved = scene_of(screen.session.world).scene
    assert [type(region).__name__ for region in saved.regions] == ["Water", "Wind"]
    left, bottom, right, top = saved.regions[0].inside or ()
    assert (left, bottom, right, top) == pytest.approx((-5, 0.25, -1, 3), abs=0.03)
    run = screen.session.timeline.run
    again = sandbox.World(run.scene)
    for step, command in run.commands:
        again.step(step - again.step_count)
        again.apply(command)
    again.step(screen.session.world.step_count - again.step_count)
    assert again.digest() == screen.session.world.digest()


@pytest.mark.slow
def test_a_region_without_an_id_is_picked_moved_stretched_and_all_taken_back(canvas: Canvas, tmp_path: Path) -> None:
    scene = sandbox.Scene(bodies=SCENE.bodies, view=SCENE.view, regions=[
        {"water": 1, "inside": [-8, 1, -4, 5], "surface": 4}, {"wind": [1, 0], "disc": [6, 4, 2]},
    ])  # fmt: skip
    seen: list[Any] = []

    def look(screen: PlayScreen) -> None:
        state = screen.session.world.state
        seen.append((screen.workspace.selection.region, box_of(state, 0), level_of(state, 0), disc_of(state, 1)))

    screen = play(
        canvas, scene, tmp_path, "click @-7,2\nwait 2\n", look,
        "drag @-6,3 to @-4,4 in 2\nwait 2\n", look, "drag @-2,4 to @1,4 in 2\nwait 2\n", look,
        "drag @-0.75,5 to @0,4.5 in 2\nwait 2\n", look,
        "click @6,4\nwait 2\n", "drag @8,4 to @9,4 in 2\nwait 2\n", look,
        "key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\nwait 2\n", look, size=(720, 450),
    )  # fmt: skip
    near = {"abs": 0.08}
    assert [row[0] for row in seen] == ["#1", "#1", "#1", "#1", "#2", "#2"]
    assert seen[1][1] == pytest.approx((-6, 2, -2, 6), **near)
    assert seen[2][1] == pytest.approx((-6, 2, 1, 6), **near)
    assert [row[2] for row in seen[:4]] == pytest.approx([4, 5, 5, 4.5], **near)
    assert seen[4][3] == pytest.approx((6, 4, 3), **near)
    assert seen[5][1:] == seen[0][1:]
    assert screen.session.timeline.undo_label is None


@pytest.mark.parametrize(
    ("point", "found"),
    [
        ((0, 0), "#4"),
        ((0, 1.5), "disc"),
        ((4, 0), "lake"),
        ((-1, 4), "lake"),
        ((9, 9), None),
        ((5.5, 4.5), "triangle"),
        ((5.5, 5.5), None),
    ],
)
def test_the_smallest_region_under_the_pointer_is_meant(point: tuple[float, float], found: str | None) -> None:
    world = sandbox.World(sandbox.Scene(bodies=SCENE.bodies, regions=[
        {"id": "everywhere", "wind": [1, 0]}, {"id": "lake", "water": 1, "inside": [-5, -1, 5, 5]},
        {"id": "disc", "gravity": [0, 1], "disc": [0, 0, 2]}, {"wind": [0, 1], "inside": [-1, -1, 1, 1]},
        {"id": "triangle", "gravity_scale": 0, "outline": [[5, 4], [6, 4], [5.5, 5]]},
    ]))  # fmt: skip
    assert region_at(world.state, point) == found


@pytest.mark.slow
def test_corners_of_a_region_come_go_and_are_put_elsewhere_by_hand(canvas: Canvas, tmp_path: Path) -> None:
    scene = sandbox.Scene(bodies=SCENE.bodies, view=SCENE.view, regions=[
        {"id": "pool", "water": 1, "inside": [-8, 1, -4, 5]},
        {"id": "zone", "gravity": [0, 1], "outline": [[2, 1], [8, 1], [8, 5]]},
    ])  # fmt: skip
    seen: list[Any] = []

    def look(screen: PlayScreen) -> None:
        state, row = screen.session.world.state, 1 if screen.workspace.selection.region == "zone" else 0
        seen.append([(round(x, 1), round(y, 1)) for x, y in corners_of(state, row)])

    screen = play(
        canvas, scene, tmp_path, "click @7,2\nwait 2\n", look, "drag @8,3 to @9,3 in 3\nwait 2\n", look,
        "drag @9,3 to @6,3 in 4\nwait 2\n", look,  # which would be concave: it stays where it still could be
        "hold Ctrl\nclick @8,5\nlet Ctrl\nwait 2\n", look,
        "click @-7,2\nhold Ctrl\ndrag @-4,5 to @-3,6 in 3\nlet Ctrl\nwait 2\n", look,
        "key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\nwait 2\n", look, "click @7,2\nwait 2\n", look,
        size=(960, 600),
    )  # fmt: skip
    triangle, more, pulled, less, kite, box, again = (set(one) for one in seen)
    assert triangle == again == {(2, 1), (8, 1), (8, 5)}
    assert more == {(2, 1), (8, 1), (9, 3), (8, 5)}
    assert len(pulled) == 4
    assert less == pulled - {(8, 5)}
    assert kite == {(-8, 1), (-4, 1), (-3, 6), (-8, 5)}
    assert box == {(-8, 1), (-4, 1), (-4, 5), (-8, 5)}
    assert screen.session.timeline.undo_label is None


@pytest.mark.slow
def test_regions_of_any_outline_are_drawn_and_a_concave_one_is_divided(canvas: Canvas, tmp_path: Path) -> None:
    shape = [(-8, 1), (-2, 1), (-2, 5), (-4, 5), (-4, 3), (-8, 3), (-8, 1)]  # an L
    stroke = "".join(
        f"move @{ax + k * (bx - ax) / 6:.2f},{ay + k * (by - ay) / 6:.2f}\n"
        for (ax, ay), (bx, by) in itertools.pairwise(shape) for k in range(1, 7)
    )  # fmt: skip

    def divided(screen: PlayScreen) -> None:
        assert regions(screen) == ("water-1", "water-2")
        assert screen.workspace.selection.region == "water-1"

    screen = play(
        canvas, SCENE, tmp_path, f"key I\nmove @-8,1\nhold Shift\npress left\n{stroke}let left\nlet Shift\nwait 2\n",
        divided, "key Ctrl+Z\nkey O\nclick @-4,0.2\nclick @-2,0.2\nclick @-3,4\nkey Enter\nwait 2\n"
        "key A\ndrag @4,2 to @8,6\nwait 2\n", size=(960, 600),
    )  # fmt: skip
    saved = scene_of(screen.session.world).scene
    assert [type(region).__name__ for region in saved.regions] == ["Gravity", "Attraction"]
    assert len(saved.regions[0].outline or ()) == 3
    assert getattr(saved.regions[1], "at", None) == pytest.approx((6, 4), abs=0.05)
    before = screen.session.world.body("crate").position[1]
    screen.session.skip(30)
    assert screen.session.world.body("crate").position[1] > before + 0.1

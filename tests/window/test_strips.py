"""What is written around the scene has a place beside it, and words over it are as large as the user's text."""

from __future__ import annotations

from pathlib import Path

import pytest

from sandbox import Scene
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from tests.render.overlays.looks import GROUND, crate
from tests.window.hands import play
from tests.window.test_session import SCENE

GAME = Scene(
    bodies=[GROUND, crate("crate", 0, 0.5)],
    counters={"score": 0},
    controls=[{"id": "push", "title": "Push the crate", "keys": ["right"], "minus": ["left"]}],
)  # fmt: skip
TAB = "key Tab\n"
KEYS = {"contacts": "contact points", "impulses": "impulses", "grid": "uniform grid"}


def overlay(*names: str) -> str:
    return "".join(f"key Ctrl+P\nwait 3\ntype overlay {KEYS[name]}\nkey Enter\nwait 2\n" for name in names)


@pytest.mark.slow
def test_the_legend_of_overlays_takes_its_room_from_below_the_scene_and_gives_it_back(
    canvas: Canvas, tmp_path: Path
) -> None:
    seen: list[tuple[int, int]] = []

    def look(screen: PlayScreen) -> None:
        seen.append(screen.workspace.viewport.rect[1::2])

    steps = "key .\n" * 20
    play(
        canvas, SCENE, tmp_path, steps, look, overlay("contacts"), look, overlay("impulses", "grid"), look,
        overlay("contacts", "impulses", "grid") + "wait 4\n", look, size=(480, 400),
    )  # fmt: skip
    tops, heights = zip(*seen, strict=True)
    assert len(set(tops)) == 1
    assert heights[0] > heights[1] > heights[2] >= 0.6 * heights[0]
    assert heights[3] == heights[0]


def test_without_panels_the_title_stands_above_the_scene(canvas: Canvas, tmp_path: Path) -> None:
    tops = [play(canvas, SCENE, tmp_path, keys, size=(480, 400)).workspace.viewport.rect for keys in ("", "key Tab\n")]
    assert tops[0][0] > tops[1][0] == 0
    assert tops[1][1:] == (32, 480, 368)
    assert play(canvas, SCENE, tmp_path, "key Tab\nwait 400\n").workspace.viewport.rect[1] == 32  # and stays


@pytest.mark.parametrize(
    ("size", "before", "line"), [((480, 400), "", 34), ((1280, 400), "", 0), ((1280, 400), TAB, 34)]
)
def test_keys_of_a_game_stand_above_it_where_the_line_of_the_tool_is_too_short(
    canvas: Canvas, tmp_path: Path, size: tuple[int, int], before: str, line: int
) -> None:
    seen: list[int] = []

    def look(screen: PlayScreen) -> None:
        seen.append(screen.workspace.viewport.rect[1])

    screen = play(canvas, GAME, tmp_path, f"{before}wait 2\n", look, "key V\nwait 2\n", look, size=size)
    assert seen[0] - seen[1] == line
    assert screen.note == ""


@pytest.mark.slow
def test_words_of_overlays_are_as_large_as_the_user_wants_text(canvas: Canvas, tmp_path: Path) -> None:
    sizes = []
    for larger in (0, 4):
        screen = play(canvas, SCENE, tmp_path, "key .\n" * 20 + overlay("grid") + "key Ctrl++\n" * larger + "wait 2\n")
        scale = screen.workspace.text_scale
        labels = screen._picture.of(screen.session.frame()).labels
        assert labels
        assert {round(label.size, 6) for label in labels} == {round(12.0 * scale, 6)}
        sizes.append(labels[0].size)
    assert sizes[1] > 1.2 * sizes[0]

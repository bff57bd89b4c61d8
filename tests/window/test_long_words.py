"""Long titles, names and notes: cut where there is no room, and told in full under the pointer."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest
from imgui_bundle import imgui

import sandbox
from sandbox.window.play import PlayScreen
from sandbox.window.problem_box import broken
from sandbox.window.screen import Canvas
from sandbox.window.widgets import places
from tests.window.hands import play

NAME = "a-crate-" * 12
SCENE = sandbox.Scene(
    title="A title that goes on and on " * 8,
    about="What is to be watched for takes a line and more of them. " * 10,
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": NAME, "shapes": [{"box": [1, 1]}], "position": [0, 0.5]},
    ],
)


def test_a_long_title_and_name_leave_room_for_what_is_beside_them(canvas: Canvas, tmp_path: Path) -> None:
    def select(screen: PlayScreen) -> None:
        screen.workspace.selection.pick(NAME)

    def look(screen: PlayScreen) -> None:
        for names in (("menu.help", "title", "figures"), ("inspector.name", "inspector.kind", "inspector.center")):
            boxes = [places[name] for name in names]
            assert all(right <= left for (_, _, right, _), (left, _, _, _) in pairwise(boxes))

    play(canvas, SCENE, tmp_path, select, "wait 4\n", look)


@pytest.mark.parametrize("size", [(640, 400), (1280, 800)])
def test_a_long_note_is_told_in_full(size: tuple[int, int], canvas: Canvas, tmp_path: Path) -> None:
    seen: list[tuple[float, float]] = []

    def look(screen: PlayScreen) -> None:
        tip = imgui.internal.find_window_by_name("##Tooltip_00")
        assert tip is not None
        assert tip.pos.x + tip.content_size.x <= size[0]
        seen.append((tip.content_size.x, tip.content_size.y))

    def at_once(screen: PlayScreen) -> None:
        style = imgui.get_style()
        style.hover_stationary_delay = style.hover_delay_short = style.hover_delay_normal = 0.0

    title = SCENE.model_copy(update={"title": "Short"})
    play(canvas, title, tmp_path, "wait 4\n", at_once, "move title\nwait 10\n", look, size=size)
    assert seen[0][1] > 4 * 13.0


def test_messages_are_broken_between_words_alone() -> None:
    told = 'a.scene.json:6:45: a "]" is missing before this: the "[" at 6:40 is not closed by a "]"'
    for columns in range(20, 90):
        lines = broken(told, columns)
        assert " ".join(lines) == told
        assert max(map(len, lines)) <= columns
    excerpt = "    6 | " + "x" * 200
    assert broken(excerpt, 40) == [excerpt]

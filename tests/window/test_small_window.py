"""A small window with large text: the scene keeps most of it, and all that can be done is still at hand."""

from __future__ import annotations

from pathlib import Path

import pytest

import sandbox
from sandbox.errors import SandboxError
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.widgets import Scale, places
from tests.window.hands import play
from tests.window.test_session import SCENE as CRATES

SIZE = 640, 400
KEYS = "F4", "F2", "F3", "F5", "F6", "F7", "F10", "F11", "U"
"""Of all panels."""
SCENE = sandbox.Scene(
    bodies=[{"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]}],
    counters={"score": 0, "bricks-left": 50, "balls": 3},
    view={"center": [0, 3], "height": 12},
)


def test_panels_grow_and_shrink_with_their_text(canvas: Canvas, tmp_path: Path) -> None:
    widths: list[float] = []

    def look(screen: PlayScreen) -> None:
        left, _, width, _ = screen.workspace.viewport.rect
        widths.append(1280 - left - width)

    larger = "key Ctrl++\n" * 3 + "wait 3\n"
    play(canvas, SCENE, tmp_path, "wait 4\n", look, larger, look, larger.replace("++", "+-"), look)
    assert widths[1] / widths[0] == pytest.approx(1.1**3, rel=0.02)
    assert widths[2] == pytest.approx(widths[0], abs=3)


def test_a_long_list_of_mistakes_can_be_closed(canvas: Canvas, tmp_path: Path) -> None:
    def wrong(screen: PlayScreen) -> None:
        assert screen._reloader is not None
        screen._reloader.problem = "\n".join(30 * ["a.scene.json:1:1: something is wrong", '  1 | {"a": 1}', "    | ^"])

    def look(screen: PlayScreen) -> None:
        left, top, width, height = screen.workspace.viewport.rect
        _, above, right, below = places["problem.close"]
        assert right < left + width
        assert top < above < below < top + height

    screen = play(
        canvas, SCENE, tmp_path, wrong, "wait 4\n", look, "click problem.close\nwait 2\n", size=SIZE
    )  # fmt: skip
    assert screen._reloader is not None
    assert screen._reloader.problem == ""


@pytest.mark.parametrize("larger", [0, 7])
def test_the_scene_keeps_most_of_it_and_nothing_is_out_of_reach(larger: int, canvas: Canvas, tmp_path: Path) -> None:
    def look(screen: PlayScreen) -> None:
        _, top, width, height = screen.workspace.viewport.rect
        assert width * height > 0.45 * SIZE[0] * SIZE[1]
        assert width > 0.8 * SIZE[0]
        assert top > places["menu.file"][3] + 16  # below the counters, which cover nothing
        assert {"time.pause", "time.undo", "time.redo", "hint", "tools.join"} <= places.keys()
        assert all(right <= SIZE[0] and bottom <= SIZE[1] for _, _, right, bottom in places.values())

    screen = play(
        canvas, SCENE, tmp_path, "key Ctrl++\n" * larger + "wait 3\n", look,
        "click tools.draw\nwait 3\nclick tool.wall\nwait 2\n",
        "click menu.view\nwait 3\nmove menu.fit\nwait 2\nwheel -30\nwait 3\nclick menu.panel.lessons\nwait 3\n",
        size=SIZE,
    )  # fmt: skip
    assert screen.tool_box.tool.name == "wall"
    assert "lessons" in screen.workspace.panels


def test_numbers_of_a_narrow_panel_can_be_read(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[float] = []

    def look(screen: PlayScreen) -> None:
        for name in ("inspector.position.x", "world.gravity.y"):
            if name in places:
                left, _, right, _ = places[name]
                seen.append(right - left)

    play(
        canvas, CRATES, tmp_path, "key F2\nkey Ctrl+A\nwait 6\n", look, "key F2\nkey F3\nwait 6\n", look,
        size=(400, 300),
    )  # fmt: skip
    assert len(seen) == 2
    assert min(seen) > 60.0  # six or seven digits


@pytest.mark.parametrize(("width", "shown"), [(200.0, "%.5g m"), (78.0, "%.4g m"), (60.0, "%.2g m"), (44.0, "%.2g")])
def test_a_number_has_as_many_digits_as_find_room(canvas: Canvas, width: float, shown: str) -> None:
    canvas.gui.begin((400, 300))
    text, flags = Scale("m", digits=5).format([-0.959133, 3.6], width)
    canvas.gui.end()
    assert text == shown
    assert (flags == 0) == (shown == "%.5g m")  # a drag does not round to fewer digits than a number has


def test_the_help_takes_the_whole_window_where_the_scene_is_small(canvas: Canvas, tmp_path: Path) -> None:
    play(canvas, CRATES, tmp_path, "key F2\nwait 4\nkey F1\nwait 3\n", size=(400, 300))
    left, _, right, _ = places["help"]
    assert right - left > 300.0


def test_hands_press_nothing_that_is_scrolled_out_of_sight(canvas: Canvas, tmp_path: Path) -> None:
    with pytest.raises(SandboxError, match=r"'overlay\.trails' is scrolled out of sight"):
        play(canvas, SCENE, tmp_path, "key F10\nwait 3\nclick overlay.trails\n", size=SIZE)

    def look(screen: PlayScreen) -> None:
        assert screen.workspace.overlays == ["trails"]

    play(
        canvas,
        SCENE,
        tmp_path,
        "key F10\nwait 3\nwheel -60 overlay.outlines\nwait 3\nclick overlay.trails\n",
        look,
        size=SIZE,
    )


@pytest.mark.parametrize("size", [(1, 1), (300, 2), (2, 300), (60, 400)])
def test_a_window_may_have_next_to_no_room(size: tuple[int, int], canvas: Canvas, tmp_path: Path) -> None:
    """Who moves it to the edge of the screen goes on where it is large again."""
    panels = "".join(f"key {key}\nwait 2\nkey Ctrl+K\nwait 3\nkey Esc\n" for key in KEYS)

    def picks(screen: PlayScreen) -> None:
        screen.workspace.selection.pair = "ground", "crate"

    screen = play(canvas, CRATES, tmp_path, "wait 2\n", picks, panels, "key .\nwait 2\n", size=size)
    assert len(screen.workspace.panels) == 9
    assert screen.session.timeline.step_count > 0


def test_nothing_is_pasted_where_nothing_can_be(canvas: Canvas, tmp_path: Path) -> None:
    """Zoomed out so far that a pixel is ten thousand kilometres."""

    def after(screen: PlayScreen) -> None:
        assert "within +-1e+09 m" in screen.note
        assert len(screen.session.world.bodies) == 3

    acts = "key Ctrl+A\nkey Ctrl+C\nwheel -200 300,200\nmove 500,300\nwait 2\nkey Ctrl+V\nwait 2\n"
    play(canvas, CRATES, tmp_path, acts, after, size=SIZE)

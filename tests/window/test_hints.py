"""What the tool in hand says at the lower right: its keys are there whole, however narrow the window."""

from __future__ import annotations

from pathlib import Path

import pytest

from sandbox.window.gui_style import ON_DARK
from sandbox.window.hint import GIVE_UP, Hint, Key
from sandbox.window.hint_line import SIGN_EMS
from sandbox.window.keycaps import Keycaps, sign_of
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.widgets import places
from tests.window.hands import play
from tests.window.test_session import SCENE


@pytest.mark.parametrize("size", [(400, 300), (800, 600), (1280, 800)])
def test_keys_are_not_cut_and_corners_are_counted(canvas: Canvas, tmp_path: Path, size: tuple[int, int]) -> None:
    seen: list[tuple[str, float]] = []

    def look(screen: PlayScreen) -> None:
        left, _, right, _ = places["hint"]
        assert right <= size[0]
        seen.append((screen.tool_box.tool.hint(screen.workspace).text, right - left))

    begun = "key P\nclick @-1,2\n"
    play(canvas, SCENE, tmp_path, begun, look, "click @1,2\nclick @1,4\nwait 2\n", look, size=size)
    (first, _), (second, wide) = seen
    assert first == "1 corner: click the next.  Esc: give up"
    assert second == "3 corners: click the next; the first one ends it.  Enter: finish  Esc: give up"
    assert wide > 2 * SIGN_EMS * 16.0  # at least both caps


def test_keys_take_the_lines_that_they_need(canvas: Canvas) -> None:
    canvas.gui.begin((400, 300))
    caps = Keycaps(None, 16.0, ON_DARK)
    keys = (Key(("Left", "Right"), "Turn"), Key(("Space",), "Strike"), GIVE_UP)
    one = caps.width(keys)
    assert [len(line) for line in caps.lines(keys, one + 1.0)] == [3]
    assert [len(line) for line in caps.lines(keys, one - 1.0)] == [2, 1]
    assert [len(line) for line in caps.lines(keys, 1.0)] == [1, 1, 1]
    assert caps.width(keys, words=False) < one
    canvas.gui.end()
    assert Hint("Do.", keys[1:]).text == "Do.  Space: Strike  Esc: give up"
    assert sign_of("Mouse left").endswith(" left")

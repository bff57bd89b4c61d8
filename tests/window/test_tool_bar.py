"""Tools have their names beside them where there is room."""

from __future__ import annotations

import pytest

from sandbox.render.theme import DARK
from sandbox.window.gui_style import apply_style
from sandbox.window.screen import Canvas
from sandbox.window.tool_bar import ToolBar


@pytest.mark.parametrize(
    ("down", "across", "wide"),
    [(1350, 2560, (120, 160)), (710, 1280, (120, 160)), (710, 1000, (40, 50)), (500, 1280, (70, 90)),
     (150, 400, (40, 50))],
)  # fmt: skip
def test_words_stand_beside_icons_where_they_take_little_of_the_window(
    canvas: Canvas, down: float, across: float, wide: tuple[float, float]
) -> None:
    apply_style(DARK)
    canvas.gui.begin((400, 300))
    width = ToolBar(down, across).width
    canvas.gui.end()
    assert wide[0] < width < wide[1]

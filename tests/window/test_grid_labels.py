"""The numbers at the lines of the grid say where the lines are, at every zoom, and never stand in each other's way."""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest

import sandbox
from sandbox.render.camera import Camera
from sandbox.render.grid import grid_lines
from sandbox.window import grid_labels
from sandbox.window.grid_labels import number_text
from sandbox.window.screen import Canvas
from tests.window.hands import play

SCENE = sandbox.Scene(
    bodies=[{"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 0.5]}], view={"center": [0, 0], "height": 10}
)


@pytest.mark.parametrize("scale", [1e-6, 3e-3, 0.7, 12.0, 48.0, 950.0, 4e7])
def test_a_line_is_where_it_says(scale: float) -> None:
    camera = Camera((3.0 / scale, -7.0 / scale), scale, (800, 600))
    lines = grid_lines(camera)
    assert sum(line.rank > 0 for line in lines) >= 2
    for line in lines:
        point = (line.metres, 0.0) if line.vertical else (0.0, line.metres)
        assert camera.to_screen(point)[0 if line.vertical else 1] == pytest.approx(line.pixel, abs=1e-6)


@pytest.mark.parametrize(
    ("metres", "text"),
    [
        (0.0, "0"),
        (-0.0, "0"),
        (3 * 0.1, "0.3"),
        (-20.0, "\N{MINUS SIGN}20"),
        (100010.0, "100010"),
        (1.5e9, "1500000000"),
    ],
)
def test_numbers_are_short(metres: float, text: str) -> None:
    assert number_text(metres) == text


@pytest.mark.parametrize("turns", [-25, 0, 12])
def test_numbers_stand_apart_and_left_of_the_scale_bar(
    turns: int, canvas: Canvas, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written: list[tuple[float, float, float]] = []
    write = grid_labels._write

    def noted(overlay: object, workspace: object, at: tuple[float, float], text: str) -> None:
        written.append((*at, overlay.width(text, grid_labels.SIZE)))  # type: ignore[attr-defined]
        write(overlay, workspace, at, text)  # type: ignore[arg-type]

    monkeypatch.setattr(grid_labels, "_write", noted)
    look = f"wheel {turns} 500,300\nmove 500,300\nwait 3\n"
    shown = play(canvas, SCENE, tmp_path, look, lambda screen: written.clear(), "wait 2\n", size=(1000, 600))
    left, _, width, _ = shown.workspace.viewport.rect
    assert len(set(written)) >= 4
    below = max(y for _, y, _ in written)
    row = sorted({(x, wide) for x, y, wide in written if y == below})
    for (x, wide), (following, _) in itertools.pairwise(row):
        assert following > x + wide
    assert max(x + wide for x, wide in row) < left + width - 60

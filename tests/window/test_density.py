"""How large the first window and its text are: what a person sees, not what a pixel is."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from sandbox import Scene
from sandbox.window.density import USUAL_SIZE, first_size, suited_scale
from sandbox.window.platform import system_scale
from sandbox.window.remembered import Remembered, remembered
from sandbox.window.screen import Canvas
from tests.window.hands import play


@pytest.mark.parametrize(
    ("screen", "scale"),
    [
        ((1280, 720), 1.0), ((1920, 1080), 1.0), ((2560, 1440), 1.0), ((3840, 2160), 1.5), ((2160, 3840), 1.5),
        ((5120, 2880), 2.0), ((7680, 4320), 3.0), ((15360, 8640), 3.0),
    ],
)  # fmt: skip
def test_text_is_larger_where_pixels_are_smaller(screen: tuple[int, int], scale: float) -> None:
    assert suited_scale(screen) == scale


@pytest.mark.parametrize("screen", [(320, 240), (800, 600), (1366, 768), (3840, 2160), (1080, 1920)])
def test_the_first_window_has_room_on_its_screen(screen: tuple[int, int]) -> None:
    width, height = first_size(screen, suited_scale(screen))
    assert width <= 0.9 * screen[0] + 1
    assert height <= 0.9 * screen[1] + 1
    assert first_size((1920, 1080), 1.0) == USUAL_SIZE


@pytest.mark.parametrize(
    ("told", "scale"), [(None, 1.0), (1.0, 1.0), (1.25, 1.25), (1.33, 1.25), (2.0, 2.0), (0.5, 1.0), (9.0, 3.0)]
)
def test_what_the_system_says_goes_before_the_number_of_pixels(told: float | None, scale: float) -> None:
    assert suited_scale((1920, 1080), told) == scale


@pytest.mark.parametrize(("told", "scale"), [("Xft.dpi: 192", 2.0), ("Xft.dpi: no number", 1.5), ("", 1.5)])
def test_the_desktop_says_how_large_all_is_to_be(
    told: str, scale: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not os.environ.get("DISPLAY") or not sys.platform.startswith("linux"):
        pytest.skip("there is no X server to ask")
    resources = tmp_path / "resources"
    resources.write_text(told + "\n")
    monkeypatch.setenv("XENVIRONMENT", str(resources))
    monkeypatch.delenv("QT_SCALE_FACTOR", raising=False)
    monkeypatch.setenv("GDK_SCALE", "1.5")
    assert system_scale("x11") == scale
    assert system_scale("wayland") is None


def test_a_window_is_as_large_as_the_screen_asks_until_the_user_chooses(canvas: Canvas, tmp_path: Path) -> None:
    canvas.suited_scale = 1.5
    scene = Scene(bodies=[{"id": "ball", "shapes": [{"circle": 1}]}])
    assert play(canvas, scene, tmp_path, "wait 2\n").workspace.text_scale == 1.5
    assert canvas.remembered.text_scale is None
    assert play(canvas, scene, tmp_path, "key Ctrl++\nwait 2\n").workspace.text_scale == pytest.approx(1.65)
    assert canvas.remembered.text_scale == pytest.approx(1.65)


def test_what_the_user_chose_holds_from_then_on(tmp_path: Path) -> None:
    assert remembered(tmp_path).text_scale is None
    Remembered(text_scale=1.25).keep(tmp_path)
    assert remembered(tmp_path).text_scale == 1.25
    Remembered().keep(tmp_path)
    assert remembered(tmp_path).text_scale is None

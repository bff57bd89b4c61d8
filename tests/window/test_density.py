"""How large the first window and its text are: what a person sees, not what a pixel is."""

from __future__ import annotations

from pathlib import Path

import pytest

from sandbox.window.density import USUAL_SIZE, first_scale, first_size
from sandbox.window.remembered import Remembered, remembered


@pytest.mark.parametrize(
    ("screen", "scale"),
    [
        ((1280, 720), 1.0), ((1920, 1080), 1.0), ((2560, 1440), 1.0), ((3840, 2160), 1.5), ((2160, 3840), 1.5),
        ((5120, 2880), 2.0), ((7680, 4320), 3.0), ((15360, 8640), 3.0),
    ],
)  # fmt: skip
def test_text_is_larger_where_pixels_are_smaller(screen: tuple[int, int], scale: float) -> None:
    assert first_scale(screen) == scale


@pytest.mark.parametrize("screen", [(320, 240), (800, 600), (1366, 768), (3840, 2160), (1080, 1920)])
def test_the_first_window_has_room_on_its_screen(screen: tuple[int, int]) -> None:
    width, height = first_size(screen)
    assert width <= 0.9 * screen[0] + 1
    assert height <= 0.9 * screen[1] + 1
    assert first_size((1920, 1080)) == USUAL_SIZE


def test_what_the_user_chose_holds_from_then_on(tmp_path: Path) -> None:
    assert remembered(tmp_path).text_scale is None
    Remembered(text_scale=1.25).keep(tmp_path)
    assert remembered(tmp_path).text_scale == 1.25
    Remembered().keep(tmp_path)
    assert remembered(tmp_path).text_scale is None

"""Where nobody looks at the window, only pictures that are read are filled in: they are those of a window in sight."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image, ImageSequence

import sandbox
from sandbox.window.app import App
from sandbox.window.gl_painter import GlPainter
from sandbox.window.options import Options
from sandbox.window.screen import Canvas
from tests.window.resizing import window_of

SCENE = sandbox.Scene(
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "ball", "shapes": [{"circle": 0.5}], "position": [3, 4]},
    ],
    view={"center": [0, 3], "height": 12},
)
SCRIPT = """
wait 5
shot {at}/scene.png
film {at}/film.gif
wait 9
cut
click @0,-0.5
key Space
wait 3
shot {at}/inspector.png
key F1
wait 3
shot {at}/help.png
"""
TOP = 24
"""Pixels: there stands how quick this machine is."""
PALETTE = 16
"""Levels by which colours of a film may be apart, as its palette has those of the top too."""


class Counting(GlPainter):
    painted = 0

    def paint(self, picture: Any) -> None:
        self.painted += 1
        super().paint(picture)


def seen(canvas: Canvas, folder: Path, watched: bool) -> dict[str, list[Any]]:
    """The pictures of a visit."""
    folder.mkdir()
    canvas.display.watched = watched
    SCENE.save(folder / "fall.scene.json")
    (folder / "hands.txt").write_text(SCRIPT.format(at=folder))
    with window_of((800, 600)):
        App(canvas, Options(folder / "fall.scene.json", script=folder / "hands.txt")).run()
    found = {}
    for path in sorted([*folder.glob("*.png"), *folder.glob("*.gif")]):
        with Image.open(path) as image:
            found[path.name] = [np.asarray(one.convert("RGB")).astype(int) for one in ImageSequence.Iterator(image)]
    return found


@pytest.mark.slow
def test_pictures_of_a_window_that_nobody_watches_are_the_same(
    canvas: Canvas, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(canvas.display, "watched", True)
    painter = canvas.painter = Counting(canvas.display.context)
    watched = seen(canvas, tmp_path / "watched", True)
    often, painter.painted = painter.painted, 0
    unwatched = seen(canvas, tmp_path / "unwatched", False)
    assert list(watched) == list(unwatched) == ["film.gif", "help.png", "inspector.png", "scene.png"]
    for name, pictures in watched.items():
        assert len(pictures) == len(unwatched[name])
        for one, other in zip(pictures, unwatched[name], strict=True):
            assert one.std() > 5
            apart = np.abs(one - other)[TOP:].max(axis=2)
            assert apart.max() <= 1 or (name == "film.gif" and (apart > PALETTE).mean() < 0.001), name
    assert painter.painted == sum(map(len, unwatched.values())) < often

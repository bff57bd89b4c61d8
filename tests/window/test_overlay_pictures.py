"""OpenGL draws the overlays that the surface painter draws, but for their words, which the window writes itself."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera
from sandbox.render.draw_list import build_draw_list
from sandbox.render.overlays.registry import OVERLAYS
from sandbox.render.surface_painter import SurfacePainter
from sandbox.render.theme import DARK, LIGHT
from tests.render.overlays.looks import look_at, shipped_world, shown


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("name", ["outlines", "grid", "contacts", "impulses", "islands"])
def test_opengl_draws_the_overlays_of_the_surface_painter(name: str, theme: Any, display: Any, tmp_path: Path) -> None:
    from sandbox.window.gl_painter import GlPainter

    look = look_at(shipped_world("pile", 80), Camera((0.0, 3.0), 40.0, display.size), theme)
    layers = tuple(replace(layer, labels=()) for layer in shown(look, OVERLAYS[name].name))
    picture = build_draw_list(look.frame, look.camera, body_colors_of(look.world.state, theme), marks=layers)
    display.begin()
    GlPainter(display.context).paint(picture)
    display.save(tmp_path / "gl.png")
    with Image.open(tmp_path / "gl.png") as image:
        drawn = np.asarray(image).astype(int)
    expected = np.asarray(SurfacePainter().paint(picture)).astype(int)
    without = build_draw_list(look.frame, look.camera, body_colors_of(look.world.state, theme))
    plain = np.asarray(SurfacePainter().paint(without)).astype(int)
    difference = np.abs(drawn - expected).max(axis=2)
    difference[difference <= 1] = 0  # of 255: how a driver rounds where colours are blended
    assert difference.mean() < 2.5
    assert difference.mean() < 0.4 * np.abs(plain - expected).max(axis=2).mean()

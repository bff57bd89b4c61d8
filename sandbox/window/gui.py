"""Dear ImGui in the window: context, fonts, events, and a few strokes of the pen for text and panels."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import imgui_bundle
from imgui_bundle import imgui

from sandbox.render.camera import Size
from sandbox.render.theme import Color

TEXT_SIZE = 16.0
_FONT = Path(imgui_bundle.__file__).parent / "assets" / "fonts" / "Roboto" / "Roboto-Regular.ttf"
_BOLD = _FONT.with_name("Roboto-Bold.ttf")


class Gui:
    """One ImGui context drawn with OpenGL. Between `begin` and `end`, draw."""

    def __init__(self, driver: str) -> None:
        _choose_gl_platform(driver)
        from imgui_bundle.python_backends.pygame_backend import PygameRenderer

        imgui.create_context()
        self.io = imgui.get_io()
        self.io.set_ini_filename("")  # the window leaves no files behind
        self.io.set_log_filename("")
        self.regular = self._font(_FONT)
        self.bold = self._font(_BOLD)
        self._renderer: Any = PygameRenderer()  # type: ignore[no-untyped-call]

    def process(self, event: Any) -> None:
        """Let ImGui see a pygame event. Resizing is not its business: it would open the window anew."""
        import pygame

        if event.type not in (pygame.VIDEORESIZE, pygame.QUIT):
            self._renderer.process_event(event)

    def begin(self, size: Size) -> None:
        """Start a frame in a window of `size` pixels."""
        self.io.display_size = imgui.ImVec2(*size)
        self._renderer.process_inputs()
        imgui.new_frame()

    def end(self) -> None:
        """Draw the frame into the current framebuffer."""
        imgui.render()
        self._renderer.render(imgui.get_draw_data())

    def close(self) -> None:
        """Free what the context holds; the window must still be open."""
        self._renderer.shutdown()
        imgui.destroy_context()

    def _font(self, path: Path) -> Any:
        if path.is_file():
            return self.io.fonts.add_font_from_file_ttf(str(path), TEXT_SIZE)
        return self.io.fonts.add_font_default()


class Pen:
    """Draws text and panels at pixel positions over the picture (or into `target`, an ImGui draw list)."""

    def __init__(self, gui: Gui, target: Any = None) -> None:
        self.gui = gui
        self._list = target if target is not None else imgui.get_background_draw_list()

    def text(
        self,
        x: float,
        y: float,
        text: str,
        color: Color,
        opacity: float = 1.0,
        size: float = TEXT_SIZE,
        bold: bool = False,
    ) -> None:
        """Write one line with its top left corner at (x, y)."""
        font = self.gui.bold if bold else self.gui.regular
        self._list.add_text(font, size, imgui.ImVec2(round(x), round(y)), pack(color, opacity), text)

    def width(self, text: str, size: float = TEXT_SIZE, bold: bool = False) -> float:
        """Pixels that a line of text takes."""
        imgui.push_font(self.gui.bold if bold else self.gui.regular, size)
        width = float(imgui.calc_text_size(text).x)
        imgui.pop_font()
        return width

    def panel(
        self, box: tuple[float, float, float, float], color: Color, opacity: float, rounding: float
    ) -> None:
        """Fill a rectangle (left, top, right, bottom) with round corners."""
        low, high = imgui.ImVec2(box[0], box[1]), imgui.ImVec2(box[2], box[3])
        self._list.add_rect_filled(low, high, pack(color, opacity), rounding)

    def arc(
        self, x: float, y: float, radius: float, turn: tuple[float, float], color: Color, width: float
    ) -> None:
        """Stroke a part of a circle between two angles in radians."""
        self._list.path_arc_to(imgui.ImVec2(x, y), radius, turn[0], turn[1], 32)
        self._list.path_stroke(pack(color, 1.0), thickness=width)


def pack(color: Color, opacity: float) -> int:
    """A colour as ImGui's 32-bit number."""
    return int(imgui.color_convert_float4_to_u32(imgui.ImVec4(*color, opacity)))


def _choose_gl_platform(driver: str) -> None:
    """PyOpenGL has to use the interface (GLX or EGL) that SDL uses; alone it guesses from the session."""
    if sys.platform.startswith("linux"):
        os.environ.setdefault("PYOPENGL_PLATFORM", "glx" if driver == "x11" else "egl")

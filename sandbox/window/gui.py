"""Dear ImGui in the window: context, fonts, events and style."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import imgui_bundle
from imgui_bundle import imgui

from sandbox.render.camera import Size
from sandbox.window.platform import choose_gl_platform

TEXT_SIZE = 16.0
_FONT = Path(imgui_bundle.__file__).parent / "assets" / "fonts" / "Roboto" / "Roboto-Regular.ttf"
_BOLD = _FONT.with_name("Roboto-Bold.ttf")


class Gui:
    """One ImGui context drawn with OpenGL. Between `begin` and `end`, draw."""

    def __init__(self, driver: str) -> None:
        choose_gl_platform(driver)
        from imgui_bundle.python_backends.pygame_backend import PygameRenderer

        imgui.create_context()
        self.io = imgui.get_io()
        self.io.set_ini_filename("")  # the window leaves no files behind
        self.io.set_log_filename("")
        self.regular = self._font(_FONT)
        self.bold = self._font(_BOLD)
        _style()
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


def _style() -> None:
    """A scroll bar that keeps in the background; all else is drawn by pens."""
    style = imgui.get_style()
    style.window_padding = imgui.ImVec2(0.0, 0.0)
    style.window_border_size = 0.0
    style.scrollbar_size = 9.0
    style.scrollbar_rounding = 5.0
    for name, gray in (
        ("scrollbar_grab", 0.22),
        ("scrollbar_grab_hovered", 0.32),
        ("scrollbar_grab_active", 0.4),
    ):
        style.set_color_(getattr(imgui.Col_, name), imgui.ImVec4(gray, gray + 0.02, gray + 0.06, 1.0))
    style.set_color_(imgui.Col_.scrollbar_bg, imgui.ImVec4(0.0, 0.0, 0.0, 0.0))

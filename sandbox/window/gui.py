"""Dear ImGui in the window: context, fonts, events and style."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import imgui_bundle
from imgui_bundle import imgui, implot

from sandbox.render.camera import Size
from sandbox.window.platform import choose_gl_platform

TEXT_SIZE = 16.0
_FONT = Path(imgui_bundle.__file__).parent / "assets" / "fonts" / "Roboto" / "Roboto-Regular.ttf"
_BOLD = _FONT.with_name("Roboto-Bold.ttf")
_MONO = _FONT.parents[1] / "Inconsolata-Medium.ttf"
_ICONS = _FONT.parents[1] / "Font_Awesome_6_Free-Solid-900.otf"
ANY_POPUP = imgui.PopupFlags_.any_popup_id | imgui.PopupFlags_.any_popup_level
"""For asking whether any menu or list is open."""
ICON_SIZE, ICON_WIDTH = 14.0, 18.0
"""Height of an icon's box, and how far all but the widest take a line on, so that what stands behind them lines up."""


class Gui:
    """One ImGui context drawn with OpenGL. Between `begin` and `end`, draw."""

    def __init__(self, driver: str) -> None:
        choose_gl_platform(driver)
        import OpenGL

        OpenGL.ERROR_CHECKING = False  # it asks after each call, of which panels make hundreds a picture
        from imgui_bundle.python_backends.pygame_backend import PygameRenderer

        self._context = imgui.create_context()
        imgui.set_current_context(self._context)
        self.io = imgui.get_io()
        self.io.set_ini_filename("")  # the window leaves no files behind
        self.io.set_log_filename("")
        self.io.config_flags |= imgui.ConfigFlags_.docking_enable
        self.io.config_drag_click_to_input_text = True  # a click on a number is for typing, a drag for dragging
        self.regular = self._font(_FONT)
        self._add_icons()
        self.bold = self._font(_BOLD)
        self.mono = self._font(_MONO)
        self._plots = implot.create_context()
        self._renderer: Any = PygameRenderer()  # type: ignore[no-untyped-call]

    def process(self, event: Any) -> tuple[bool, bool]:
        """Let ImGui see a pygame event; says whether its widgets want the mouse, and the keyboard.

        Resizing is not its business: it would open the window anew.
        """
        import pygame

        if event.type not in (pygame.VIDEORESIZE, pygame.QUIT):
            self._renderer.process_event(event)
        return bool(self.io.want_capture_mouse), bool(self.io.want_text_input)

    def begin(self, size: Size) -> None:
        """Start a frame in a window of `size` pixels."""
        self.io.display_size = imgui.ImVec2(*size)
        self._renderer.process_inputs()
        imgui.new_frame()

    def end(self) -> None:
        """Draw the frame into the current framebuffer."""
        imgui.render()
        self.draw_again()

    def draw_again(self) -> None:
        """Draw the last frame into the current framebuffer."""
        self._renderer.render(imgui.get_draw_data())

    def close(self) -> None:
        """Free what the context holds; the window must still be open."""
        self._renderer.shutdown()
        implot.destroy_context(self._plots)
        imgui.destroy_context(self._context)

    def _add_icons(self) -> None:
        """The icons of buttons and panels, as characters of the regular font."""
        if _ICONS.is_file():
            merged = imgui.ImFontConfig()
            merged.merge_mode = True
            merged.glyph_offset = imgui.ImVec2(0.0, 1.0)
            merged.glyph_min_advance_x = ICON_WIDTH
            self.io.fonts.add_font_from_file_ttf(str(_ICONS), ICON_SIZE, merged)

    def _font(self, path: Path) -> Any:
        if path.is_file():
            return self.io.fonts.add_font_from_file_ttf(str(path), TEXT_SIZE)
        return self.io.fonts.add_font_default()

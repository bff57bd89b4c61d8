"""Opens the window and draws a first picture, before all that a scene needs is imported."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.render.theme import DARK, LIGHT, Theme
from sandbox.window.density import USUAL_SIZE
from sandbox.window.display import Display, check_size
from sandbox.window.gui import Gui
from sandbox.window.gui_style import apply_style, palette_of
from sandbox.window.options import Options
from sandbox.window.overlay import Overlay
from sandbox.window.remembered import Remembered, remembered
from sandbox.window.state_folder import state_folder
from sandbox.window.threads import ended_threads


def run_window(options: Options) -> None:
    """Show the window until it is closed. Raises `MissingDependencyError` or `SceneError`."""
    if options.size is not None:
        check_size(options.size)
    counted = options.frames is not None or options.script is not None
    kept = Remembered() if counted else remembered(state_folder())
    theme = LIGHT if kept.light else DARK
    size = USUAL_SIZE if counted else kept.size
    with ended_threads(), Display(options.size or size, "sandbox", visible=not counted) as display:
        suited = 1.0 if counted else display.suited_scale
        gui = Gui(display.driver)
        if kept.docks:
            imgui.load_ini_settings_from_memory(kept.docks)
        try:
            _greet(display, gui, theme, options.scene.name if options.scene else "", kept.text_scale or suited)
            _run(display, gui, theme, (kept, suited), options)
        finally:
            gui.close()


def _run(display: Display, gui: Gui, theme: Theme, kept: tuple[Remembered, float], options: Options) -> None:
    from sandbox.window.app import App
    from sandbox.window.gl_painter import GlPainter
    from sandbox.window.screen import Canvas

    App(Canvas(display, GlPainter(display.context), gui, theme, *kept), options).run()


def _greet(display: Display, gui: Gui, theme: Theme, name: str, scale: float) -> None:
    """The picture while Python reads the rest of the program, half a second."""
    display.begin()
    display.context.clear(*theme.background)
    gui.begin(display.size)
    apply_style(theme)
    overlay, colors = Overlay(gui, scale=scale), palette_of(theme)
    middle, y = display.size[0] / 2, display.size[1] / 2
    overlay.text(
        middle - overlay.width("sandbox", 32.0, bold=True) / 2, y - 40.0, "sandbox", colors.text, 1.0, 32.0, True
    )
    overlay.text(middle - overlay.width(name) / 2, y + 8.0, name, colors.faint)
    gui.end()
    display.show()

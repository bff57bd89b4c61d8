"""The world: gravity with a dial, and how the scene is solved."""

from __future__ import annotations

import math

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.engine.commands.set_gravity import SetGravity
from sandbox.window.adjustment import Adjustment
from sandbox.window.gui_style import palette_of
from sandbox.window.panels.panel import Panel
from sandbox.window.panels.solver_switches import SolverSwitches
from sandbox.window.widgets import Scale, button, drag2, is_narrow, mark, row, same_line_if_fits, section
from sandbox.window.workspace import Workspace

DIAL_EMS = 5.75
"""Across, in heights of the text."""
DIAL_GRAVITY = 20.0
"""m/s^2 at the dial's rim."""
PRESETS = (("Earth", 9.81), ("Moon", 1.62), ("Mars", 3.71), ("Jupiter", 24.8), ("None", 0.0))


class WorldPanel(Panel):
    """What holds for all bodies."""

    name = "world"
    title = "World"
    icon = icons.ICON_FA_EARTH_EUROPE
    help = "Gravity, and how the scene is solved."
    key = "F3"
    shown_at_first = True

    def __init__(self) -> None:
        self._gravity = Adjustment("Gravity")
        self._solver = SolverSwitches()

    def draw(self, workspace: Workspace) -> None:
        """Gravity, the solver, then figures of the world."""
        if section("Gravity"):
            self._draw_gravity(workspace)
        if section("Solver"):
            self._solver.draw(workspace)
        if section("Now"):
            self._draw_figures(workspace)

    def _draw_gravity(self, workspace: Workspace) -> None:
        gravity = workspace.session.world.gravity
        changed, dialled = _dial("world.gravity.dial", gravity, workspace)
        self._gravity.follow(workspace, changed, SetGravity(dialled))
        if not is_narrow():
            imgui.same_line()
        imgui.begin_group()
        imgui.set_next_item_width(-1.0)
        changed, typed = drag2("world.gravity", "", gravity, "Gravity, x and y", Scale("m/s²", 0.05))
        self._gravity.follow(workspace, changed, SetGravity(typed))
        for number, (label, strength) in enumerate(PRESETS):
            if number % 3:
                same_line_if_fits(label)
            if button(f"world.gravity.{label.lower()}", label, f"{strength:g} m/s² downwards"):
                units = float(workspace.session.world.state.settings[0].units_per_meter)
                workspace.do(f"Gravity of {label}", SetGravity((0.0, -strength * units)))
        imgui.end_group()

    @staticmethod
    def _draw_figures(workspace: Workspace) -> None:
        world = workspace.session.world
        row("time", f"{world.time:.3f} s, step {world.step_count:,}")
        row("bodies", f"{len(world.names):,}, {world.awake_count:,} awake")
        row("joints", f"{len(world.joint_names):,}")
        row("contacts", f"{len(world.contacts):,}")
        row("digest", world.digest(), "A fingerprint of the whole state: equal bits, equal digest.")


def _dial(name: str, gravity: tuple[float, float], workspace: Workspace) -> tuple[bool, tuple[float, float]]:
    """A round field in which one points where gravity pulls. (changed, gravity)."""
    corner, radius = imgui.get_cursor_screen_pos(), 0.5 * DIAL_EMS * imgui.get_font_size()
    imgui.invisible_button(name, imgui.ImVec2(2.0 * radius, 2.0 * radius))
    mark(name, "Drag to where things are to fall; the farther out, the stronger.")
    active, mouse = imgui.is_item_active(), imgui.get_io().mouse_pos
    middle = corner.x + radius, corner.y + radius
    if active:
        x, y = (mouse.x - middle[0]) / radius, (middle[1] - mouse.y) / radius
        length = math.hypot(x, y)
        share = min(1.0, 1.0 / length) if length > 0.0 else 0.0
        gravity = round(x * share * DIAL_GRAVITY, 2), round(y * share * DIAL_GRAVITY, 2)
    _draw_dial(middle, radius, gravity, workspace)
    return active, gravity


def _draw_dial(middle: tuple[float, float], radius: float, gravity: tuple[float, float], workspace: Workspace) -> None:
    from sandbox.window.overlay import packed_color

    colors, pen = palette_of(workspace.theme), imgui.get_window_draw_list()
    center = imgui.ImVec2(*middle)
    pen.add_circle_filled(center, radius, packed_color(colors.inset, 1.0), 48)
    for share in (0.5, 1.0):
        pen.add_circle(center, radius * share - 0.5, packed_color(colors.line, 1.0), 48, 1.0)
    strength = math.hypot(*gravity)
    share = min(strength / DIAL_GRAVITY, 1.0) / strength if strength > 0.0 else 0.0
    tip = imgui.ImVec2(middle[0] + gravity[0] * share * radius, middle[1] - gravity[1] * share * radius)
    pen.add_line(center, tip, packed_color(colors.accent, 1.0), 2.5)
    pen.add_circle_filled(tip, 5.0, packed_color(colors.accent, 1.0), 20)
    pen.add_circle_filled(center, 2.5, packed_color(colors.faint, 1.0), 12)

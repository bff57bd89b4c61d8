"""What is drawn over the scene: boxes, grid, contacts, impulses, islands and the rest, to be switched on and off."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.render.overlays.registry import OVERLAYS
from sandbox.window.panels.panel import Panel
from sandbox.window.widgets import button, checkbox, wrapped
from sandbox.window.workspace import Workspace


class OverlaysPanel(Panel):
    """A box to tick for each overlay; those that are off cost nothing."""

    name = "overlays"
    title = "Overlays"
    icon = icons.ICON_FA_LAYER_GROUP
    help = "What the engine sees and does, drawn over the scene."
    key = "F10"
    shown_at_first = True

    def draw(self, workspace: Workspace) -> None:
        """The list, with what each of them shows."""
        if button("overlays.none", "None", "Switch all off.", enabled=bool(workspace.overlays)):
            workspace.overlays = []
        for overlay in OVERLAYS.values():
            shown = overlay.name in workspace.overlays
            if checkbox(f"overlay.{overlay.name}", overlay.title, shown, overlay.help) != shown:
                workspace.toggle_overlay(overlay.name)
            imgui.indent(28.0)
            wrapped(overlay.help)
            imgui.unindent(28.0)

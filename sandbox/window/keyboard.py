"""What keys do in a scene: actions by the table, then tools and panels by their own."""

from __future__ import annotations

from collections.abc import Mapping

import pygame
from imgui_bundle import imgui

from sandbox.window.actions.registry import action_of, released
from sandbox.window.gui import ANY_POPUP
from sandbox.window.panels.panel import Panel
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.workspace import Workspace

_COMMAND = pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META


class Keyboard:
    """The keys of one scene's screen."""

    def __init__(self, workspace: Workspace, tool_box: ToolBox, panels: Mapping[str, Panel]) -> None:
        self.workspace = workspace
        self._tool_box = tool_box
        self._panels = panels

    def handle(self, event: pygame.event.Event, taken: bool) -> None:
        """Act on a key; `taken` says whether a panel wants what is typed."""
        elsewhere = taken or self.workspace.palette_shown or self.workspace.steering.takes(event)
        if event.type == pygame.KEYDOWN and not elsewhere:
            self._press(event)
        self.workspace.held -= released(event)

    def _press(self, event: pygame.event.Event) -> None:
        workspace = self.workspace
        if event.key == pygame.K_ESCAPE and imgui.is_popup_open("", ANY_POPUP):
            imgui.internal.close_popup_to_level(0, True)
            return
        if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER) and self._tool_box.tool.confirm(workspace):
            return
        action = action_of(event)
        if action is not None and action.held:
            workspace.held.add(action.name)
        elif action is not None:
            action.run(workspace)
        elif not event.mod & _COMMAND:
            self._choose(event)

    def _choose(self, event: pygame.event.Event) -> None:
        """Tools and panels have keys as well."""
        typed = event.unicode.upper()
        for tool in self._tool_box.tools.values():
            if tool.key and tool.key == typed:
                self._tool_box.choose(tool.name)
        for panel in self._panels.values():
            if panel.key and pygame.key.name(event.key).upper() == panel.key:
                self.workspace.toggle_panel(panel.name)

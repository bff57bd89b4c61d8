"""A value under the user's hand: all changes of one drag are one act, and while time stands still, one command."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.engine.commands.base import Command
from sandbox.errors import SandboxError
from sandbox.replay.moment import Mark
from sandbox.window.workspace import Workspace


class Adjustment:
    """For one widget or a few that change the same thing: tell it after each whether that has changed it."""

    def __init__(self, label: str) -> None:
        self.label = label
        self._mark: Mark | None = None
        self._item = 0

    def follow(self, workspace: Workspace, changed: bool, *commands: Command, label: str = "") -> None:
        """Apply `commands` if the widget drawn last says `changed`; a refusal becomes a note."""
        timeline = workspace.session.timeline
        if self._mark is not None and imgui.is_item_activated():  # its widget went while it was dragged
            timeline.end_act()
            self._mark = None
        if changed:
            item = imgui.get_item_id()
            if self._mark is None or self._item != item:
                timeline.begin_act(label or self.label)
                self._mark, self._item = timeline.mark(), item
            try:
                workspace.session.adjust(self._mark, *commands)
            except SandboxError as error:
                workspace.say(str(error))
        if self._mark is not None and imgui.get_item_id() == self._item and not imgui.is_item_active():
            timeline.end_act()
            self._mark = None

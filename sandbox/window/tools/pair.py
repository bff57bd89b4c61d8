"""The tool that picks the two bodies whose separating-axis test is looked at."""

from __future__ import annotations

from collections.abc import Sequence

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.render.line import Line
from sandbox.window.hint import GIVE_UP, Hint
from sandbox.window.tools.tool import Pointer, Tool, body_under, outline
from sandbox.window.workspace import Workspace

PANEL = "sat"
"""The panel that shows the pair."""


class PairTool(Tool):
    """A click on one body, another on the second one: the inspector opens on them."""

    name, title, icon, key = "pair", "Pair", icons.ICON_FA_OBJECT_UNGROUP, "K"
    help = "Click two bodies to see their separating-axis test."

    def __init__(self) -> None:
        self._first: tuple[str, Pointer] | None = None
        self._cursor: Pointer | None = None

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """The first body, or the second one."""
        name = body_under(workspace, pointer)
        if name is None:
            return False
        if self._first is None:
            self._first, self._cursor = (name, pointer), pointer
            workspace.selection.pick(name)
            return True
        (first, _), self._first = self._first, None
        if name == first:
            workspace.say(f"{name} with itself is no pair: click two bodies")
            return True
        workspace.selection.pick(None)  # the inspector shows them in colours of its own
        workspace.selection.pair = first, name
        workspace.panels.add(PANEL)
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Follow the hand."""
        self._cursor = pointer

    def cancel(self, workspace: Workspace) -> bool:
        """Forget the first body."""
        busy, self._first = self._first is not None, None
        return busy

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """A line from the first body to the cursor."""
        if self._first is None or self._cursor is None:
            return ()
        return outline(workspace, [self._first[1].point, self._cursor.point], closed=False)

    def hint(self, workspace: Workspace) -> Hint:
        """Which body is asked for."""
        if self._first is None:
            return super().hint(workspace)
        return Hint(f"Now click the body whose test with {self._first[0]} you want to see.", (GIVE_UP,))

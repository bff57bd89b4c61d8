"""The tools of one window, and which of them is in hand."""

from __future__ import annotations

from sandbox.window.tools.registry import GROUPS, new_tools
from sandbox.window.tools.tool import Tool
from sandbox.window.workspace import Workspace


class ToolBox:
    """All tools by name; `tool` is the one in hand, `latest` the one of each group that was in hand last."""

    def __init__(self, workspace: Workspace) -> None:
        self.workspace = workspace
        self.tools = new_tools()
        self.tool: Tool = self.tools["hand"]
        self.latest = {title: kinds[0].name for title, kinds in GROUPS}
        workspace.interrupt = self.interrupt

    def choose(self, name: str) -> None:
        """Put the tool in hand away and take another."""
        self.interrupt()
        self.tool = self.tools[name]
        self.latest |= {title: name for title, kinds in GROUPS if type(self.tool) in kinds}

    def interrupt(self) -> bool:
        """Give up what the tool in hand is in the middle of; False if there is nothing."""
        return self.tool.cancel(self.workspace)

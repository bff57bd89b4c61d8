"""What a panel is: a part of the window beside the scene that shows and changes one kind of thing."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from sandbox.window.overlay import Overlay
from sandbox.window.workspace import Workspace


class Panel(ABC):
    """A panel. One object each, in the registry; `draw` is called between ImGui's begin and end while it is shown.

    A panel that is not shown is not called, neither to draw nor after steps, so it costs nothing.
    """

    name: ClassVar[str]
    title: ClassVar[str]
    icon: ClassVar[str]
    help: ClassVar[str]
    key: ClassVar[str] = ""
    shown_at_first: ClassVar[bool] = False
    side: ClassVar[str] = "right"
    """Where it is docked at first: "right" or "bottom"."""
    exact: ClassVar[bool] = False
    """While it is open, pictures show the last step as it is, not a blend of the last two: it draws over the scene."""

    @abstractmethod
    def draw(self, workspace: Workspace) -> None:
        """Draw its widgets."""

    def draw_over(self, workspace: Workspace, overlay: Overlay) -> None:  # noqa: B027 (most draw nothing there)
        """Draw over the scene, in pixels of the window; called after `draw`, also while another tab hides the panel."""

    def note_step(self, workspace: Workspace) -> None:  # noqa: B027 (most keep nothing)
        """A step has been taken while the panel is shown: keep of it what is needed later."""

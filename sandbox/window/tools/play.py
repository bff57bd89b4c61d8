"""The tool with which a scene is played: keys and mouse are those of the scene's controls."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.window.controls.control_keys import control_keys
from sandbox.window.hint import Hint
from sandbox.window.tools.tool import Pointer, Tool
from sandbox.window.workspace import Workspace


class PlayTool(Tool):
    """While it is in hand, what the scene's controls name does what they say, and nothing else."""

    name, title, icon, key = "play", "Play", icons.ICON_FA_GAMEPAD, "Z"
    help = "Play the scene with its own keys; other tools and keys work as usual when another tool is in hand."

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """The button is the scene's if a control has it; else the drag pans."""
        return any("left" in control.mouse for control in workspace.session.world.controls)

    def hint(self, workspace: Workspace) -> Hint:
        """The controls."""
        controls = workspace.session.world.controls
        return Hint("", control_keys(controls)) if controls else Hint("This scene has no controls.")

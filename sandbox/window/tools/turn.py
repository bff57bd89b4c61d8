"""The tool that turns bodies by hand."""

from __future__ import annotations

import math
from collections.abc import Sequence

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.motion import SetPose
from sandbox.errors import SandboxError
from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.replay.moment import Mark
from sandbox.window.hint import Key
from sandbox.window.tools.tool import Pointer, Tool, body_under, outline
from sandbox.window.workspace import Workspace

NOTCH = math.radians(15.0)
"""With Ctrl, bodies turn by multiples of this."""


class TurnTool(Tool):
    """Turns the body under the pointer, or all that are selected, about their common middle."""

    name, title, icon, key = "turn", "Turn", icons.ICON_FA_ARROWS_ROTATE, "T"
    help = "Drag a body around its middle to turn it. What is selected turns as one."
    keys = (Key(("Ctrl",), "by 15 degrees"),)

    def __init__(self) -> None:
        self._poses: dict[str, tuple[Vec, float]] = {}
        self._middle: Vec = (0.0, 0.0)
        self._from = 0.0
        self._mark: Mark | None = None
        self._to: Pointer | None = None

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Take hold."""
        name = body_under(workspace, pointer)
        if name is None:
            return False
        selection, world = workspace.selection, workspace.session.world
        if name not in selection.bodies:
            selection.pick(name, pointer.more)
        views = [world.body(one) for one in selection.present(world)]
        self._poses = {view.id: (view.position, view.angle) for view in views}
        xs, ys = [view.center[0] for view in views], [view.center[1] for view in views]
        self._middle = sum(xs) / len(xs), sum(ys) / len(ys)
        self._from, self._to = self._angle(pointer), pointer
        workspace.session.timeline.begin_act(f"Turn {', '.join(self._poses)}")
        self._mark = workspace.session.timeline.mark()
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Turn it."""
        if self._mark is None:
            return
        self._to = pointer
        by = self._angle(pointer) - self._from
        by = round(by / NOTCH) * NOTCH if pointer.free else by
        try:
            workspace.session.adjust(self._mark, *self._turned(by))
        except SandboxError as error:
            workspace.say(str(error))

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """Let go."""
        workspace.session.timeline.end_act()
        self.cancel(workspace)

    def cancel(self, workspace: Workspace) -> bool:
        """Let go."""
        busy, self._mark, self._to = self._mark is not None, None, None
        return busy

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """A line from the middle to the hand."""
        return () if self._to is None else outline(workspace, [self._middle, self._to.point], closed=False, width=1.5)

    def _angle(self, pointer: Pointer) -> float:
        return math.atan2(pointer.point[1] - self._middle[1], pointer.point[0] - self._middle[0])

    def _turned(self, by: float) -> list[SetPose]:
        c, s = math.cos(by), math.sin(by)
        x0, y0 = self._middle
        poses = []
        for name, ((x, y), angle) in self._poses.items():
            dx, dy = x - x0, y - y0
            poses.append(SetPose(name, (x0 + c * dx - s * dy, y0 + s * dx + c * dy), angle + by))
        return poses

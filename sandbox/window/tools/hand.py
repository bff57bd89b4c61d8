"""The hand: picks bodies, throws them while time runs, and puts them elsewhere while it stands still."""

from __future__ import annotations

import math
from collections.abc import Sequence

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.motion import SetPose
from sandbox.errors import SandboxError
from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.replay.moment import Mark
from sandbox.window.hint import Hint, Key
from sandbox.window.tools.joint_pick import joint_under
from sandbox.window.tools.region_drag import SHAPING, RegionDrag
from sandbox.window.tools.region_handles import middle_of
from sandbox.window.tools.region_pick import region_at
from sandbox.window.tools.tool import GRAB_PIXELS, Pointer, Tool, body_under
from sandbox.window.workspace import Workspace

CLICK_PIXELS = 4.0
"""A press that moves less is a click."""


class Hand(Tool):
    """A click selects. A drag pulls by a spring while time runs; while it stands still it moves what is selected."""

    name = "hand"
    title = "Hand"
    icon = icons.ICON_FA_HAND
    key = "V"
    help = "Drag a body to throw it; while paused, to move it. Click selects a body, joint or region."
    keys = (Key(("Shift",), "add"),)

    def __init__(self) -> None:
        self._start: Pointer | None = None
        self._moving: dict[str, tuple[Vec, float]] = {}
        self._mark: Mark | None = None
        self._moved = False
        self._joint: str | None = None
        self._region = RegionDrag()

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Take hold of what is under the pointer."""
        self._start, self._moved = pointer, False
        if self._region.press(workspace, pointer):
            return True
        name = body_under(workspace, pointer)
        self._joint = joint_under(workspace, pointer, lines=name is None)
        if name is None:
            if self._joint is not None:
                workspace.selection.pick_joint(self._joint)
            elif not pointer.more:
                workspace.selection.pick_region(region_at(workspace.session.world.state, pointer.point))
            return False
        if workspace.session.clock.paused:
            self._take(workspace, name, pointer.more)
            return True
        workspace.selection.pick(name, pointer.more)
        slack = GRAB_PIXELS / workspace.viewport.camera.scale
        return workspace.session.grab(pointer.point, slack)

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Pull, or put elsewhere."""
        self._region.move(workspace, pointer)
        workspace.session.grip.pull(pointer.point)
        start = self._start
        if start is None:
            return
        self._moved = self._moved or math.dist(start.pixel, pointer.pixel) > CLICK_PIXELS
        if self._moved and self._moving:
            self._put(workspace, (pointer.point[0] - start.point[0], pointer.point[1] - start.point[1]))

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """Let go. A click on the anchor of a joint means the joint."""
        workspace.session.grip.let_go()
        if not self._region.release(workspace):
            workspace.session.timeline.end_act()
        if self._joint is not None and not self._moved:
            workspace.selection.pick_joint(self._joint)
        self._forget()

    def cancel(self, workspace: Workspace) -> bool:
        """Let go."""
        busy = bool(self._moving) or workspace.session.grip.body is not None
        busy = self._region.release(workspace) or busy
        workspace.session.grip.let_go()
        self._forget()
        return busy

    def hint(self, workspace: Workspace) -> Hint:
        """How a region that is selected is shaped."""
        area = middle_of(workspace.session.world, workspace.selection.region or "")
        return super().hint(workspace) if area is None else SHAPING

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """The line from the grabbed point to the hand, or the handles of the region that is selected."""
        session, camera = workspace.session, workspace.viewport.camera
        if session.grip.body is None:
            return self._region.strokes(workspace)
        start, end = camera.to_screen([session.grip.place(session.frame()), session.grip.target])
        grip, hand = (float(start[0]), float(start[1])), (float(end[0]), float(end[1]))
        color = workspace.theme.drag
        return Line(grip, hand, 1.6, color, 0.75), Line(grip, grip, 6.0, color), Line(hand, hand, 8.0, color)

    def _take(self, workspace: Workspace, name: str, more: bool) -> None:
        """Get ready to move the body under the pointer, and with it the others that are selected."""
        if more or name not in workspace.selection.bodies:
            workspace.selection.pick(name, more)
        world = workspace.session.world
        views = [world.body(one) for one in workspace.selection.present(world)]
        self._moving = {view.id: (view.position, view.angle) for view in views}
        self._mark = workspace.session.timeline.mark()
        workspace.session.timeline.begin_act(f"Move {', '.join(self._moving)}")

    def _put(self, workspace: Workspace, by: Vec) -> None:
        assert self._mark is not None
        session = workspace.session
        poses = [SetPose(name, (at[0] + by[0], at[1] + by[1]), angle) for name, (at, angle) in self._moving.items()]
        try:
            session.adjust(self._mark, *poses)
        except SandboxError as error:
            workspace.say(str(error))

    def _forget(self) -> None:
        self._start, self._joint, self._moving, self._mark = None, None, {}, None

"""Tools that act on what they touch: erase, explode, push and pull."""

from __future__ import annotations

import math
from collections.abc import Sequence

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.delete import Delete, DeleteJoint, DeleteRegion
from sandbox.engine.commands.explode import Explode
from sandbox.errors import SandboxError
from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.window.hint import Key
from sandbox.window.tools.joint_pick import joint_under
from sandbox.window.tools.region_pick import region_at
from sandbox.window.tools.tool import Pointer, Tool, body_under, outline
from sandbox.window.workspace import Workspace

BLAST_SHARE, MAGNET_SHARE = 0.2, 0.3
"""Radius of a blast, and reach of a magnet, as shares of the height that is seen."""
BLAST_IMPULSE = 10.0
"""N s for each metre of a shape's width and each metre of the blast's radius, per kg/m^2 of usual density."""
MAGNET_IMPULSE = 0.6
"""The same for one step of a magnet."""


class EraseTool(Tool):
    """Deletes what is clicked or swept over: joints before bodies, and a region that is clicked where nothing is."""

    name, title, icon, key = "erase", "Erase", icons.ICON_FA_ERASER, "E"
    help = "Click what is to go, or sweep over it: joints first, then bodies. A click beside them takes a region."

    def __init__(self) -> None:
        self._down = False

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Begin to erase."""
        self._down = True
        workspace.session.timeline.begin_act("Erase")
        if not self._erase(workspace, pointer):
            self._drain(workspace, pointer)
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Erase on the way."""
        if self._down:
            self._erase(workspace, pointer)

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """Enough."""
        self._down = False
        workspace.session.timeline.end_act()

    def _drain(self, workspace: Workspace, pointer: Pointer) -> None:
        region = region_at(workspace.session.world.state, pointer.point)
        if region is not None:
            with workspace.attempt("not erased"):
                workspace.session.apply(DeleteRegion(region))

    def _erase(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Erase what is there; False if nothing is."""
        joint, body = joint_under(workspace, pointer), body_under(workspace, pointer)
        if joint is None and body is None:
            return False
        with workspace.attempt("not erased"):
            workspace.session.apply(Delete(body) if joint is None and body is not None else DeleteJoint(joint or ""))
        return True


class BlastTool(Tool):
    """Explosions: the longer the drag, the farther they reach."""

    name, title, icon, key = "blast", "Explode", icons.ICON_FA_BURST, "X"
    help = "Click for a blast, or drag to say how far it reaches."

    def __init__(self) -> None:
        self._from: Pointer | None = None
        self._radius = 0.0

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Where it will be."""
        self._from = pointer
        self._radius = self._usual(workspace)
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """How far it will reach."""
        if self._from is not None and math.dist(self._from.pixel, pointer.pixel) > 6.0:
            self._radius = math.dist(self._from.point, pointer.point)

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """Bang."""
        start, self._from = self._from, None
        if start is not None:
            workspace.do(
                "Explode", Explode(start.point, self._radius, BLAST_IMPULSE * _units(workspace) * self._radius)
            )

    def cancel(self, workspace: Workspace) -> bool:
        """No bang."""
        busy, self._from = self._from is not None, None
        return busy

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """A ring."""
        if self._from is None:
            return ()
        return _ring(workspace, self._from.point, self._radius)

    @staticmethod
    def _usual(workspace: Workspace) -> float:
        return BLAST_SHARE * _height(workspace)


class MagnetTool(Tool):
    """Pulls towards the pointer while the button is down, or with Shift pushes away."""

    name, title, icon, key = "magnet", "Magnet", icons.ICON_FA_MAGNET, "M"
    help = "Hold to pull everything near to the pointer."
    keys = (Key(("Shift",), "push it away"),)

    def __init__(self) -> None:
        self._at: Pointer | None = None
        self._step = -1

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Switch it on."""
        self._at, self._step = pointer, -1
        workspace.session.timeline.begin_act("Magnet")
        self.tick(workspace)
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Carry it along."""
        if self._at is not None:
            self._at = pointer

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """Switch it off."""
        self._at = None
        workspace.session.timeline.end_act()

    def cancel(self, workspace: Workspace) -> bool:
        """Switch it off."""
        busy, self._at = self._at is not None, None
        return busy

    def tick(self, workspace: Workspace) -> None:
        """Pull once in each step."""
        step = workspace.session.timeline.step_count
        if self._at is None or step == self._step:
            return
        self._step = step
        radius = MAGNET_SHARE * _height(workspace)
        impulse = MAGNET_IMPULSE * _units(workspace) * radius * (1.0 if self._at.more else -1.0)
        try:
            workspace.session.apply(Explode(self._at.point, radius, impulse))
        except SandboxError as error:
            workspace.say(str(error))
            self._at = None

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """Two rings."""
        if self._at is None:
            return ()
        reach = MAGNET_SHARE * _height(workspace)
        return [line for share in (1.0, 0.6) for line in _ring(workspace, self._at.point, share * reach, width=1.2)]


def _units(workspace: Workspace) -> float:
    """Units of length to a metre."""
    return float(workspace.session.world.state.settings[0].units_per_meter)


def _height(workspace: Workspace) -> float:
    """How much is seen from top to bottom, m."""
    camera = workspace.viewport.camera
    return camera.size[1] / camera.scale


def _ring(workspace: Workspace, center: Vec, radius: float, width: float = 2.0) -> list[Line]:
    """A circle of the plane (m)."""
    turns = [2.0 * math.pi * k / 64 for k in range(64)]
    ring = [(center[0] + radius * math.cos(turn), center[1] + radius * math.sin(turn)) for turn in turns]
    return outline(workspace, ring, closed=True, width=width)

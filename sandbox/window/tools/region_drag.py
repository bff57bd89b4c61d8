"""What the hand does to the selected region: it drags its handles, and gives and takes corners."""

from __future__ import annotations

import math

from sandbox.engine.commands.set_region import SetRegion
from sandbox.errors import SandboxError
from sandbox.render.line import Line
from sandbox.replay.moment import Mark
from sandbox.window.hint import Hint, Key
from sandbox.window.tools.region_handles import Handle, command_of, handles_of
from sandbox.window.tools.tool import Pointer, outline
from sandbox.window.workspace import Workspace
from sandbox.world.region_area import corners_of

HANDLE_PIXELS = 10.0
"""How far beside a handle a press still takes it."""
SLIP_PIXELS = 3.0
"""A drag that goes no farther is a click."""
SHAPING = Hint(
    "Drag the cross to move it, dots to shape it; a click on a corner takes it away.", (Key(("Ctrl",), "one corner"),)
)


class RegionDrag:
    """The handle that the hand holds, and what it has done to the region up to now: one act."""

    def __init__(self) -> None:
        self._held: tuple[str, Handle] | None = None
        self._mark: Mark | None = None
        self._last: SetRegion | None = None
        """What was done last, which is done again where the hand asks for what cannot be."""
        self._start: Pointer | None = None

    @property
    def busy(self) -> bool:
        """Whether a handle is held."""
        return self._held is not None

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Take the handle of the selected region that is nearest, if one is under the pointer."""
        name, timeline = workspace.selection.region, workspace.session.timeline
        near = [(math.dist(workspace.viewport.pixel(one.place), pointer.pixel), one) for one in _handles(workspace)]
        away, handle = min(near, key=lambda row: row[0], default=(math.inf, None))
        if handle is None or name is None or away > HANDLE_PIXELS:
            return False
        timeline.begin_act(f"{'Move' if handle.moves else 'Resize'} {workspace.selection.region_title}")
        self._held, self._mark, self._last = (name, handle), timeline.mark(), None
        self._start = pointer
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Put it where the pointer is."""
        if self._held is None or self._mark is None or self._start is None:
            return
        name, handle = self._held
        if self._last is None and math.dist(self._start.pixel, pointer.pixel) < SLIP_PIXELS:
            return
        wanted = command_of(name, handle, pointer.point, self._start.free)
        try:
            workspace.session.adjust(self._mark, wanted)
        except SandboxError as error:
            workspace.say(str(error))
            if self._last is not None:
                workspace.session.adjust(self._mark, self._last)
        else:
            self._last = wanted

    def release(self, workspace: Workspace) -> bool:
        """Let go; False if nothing was held. With Ctrl, a corner that was not dragged goes away."""
        busy = self.busy
        if self._held is not None and self._mark is not None and self._start is not None:
            name, handle = self._held
            if self._start.free and self._last is None and handle.gone is not None:
                workspace.session.adjust(self._mark, SetRegion(name, **handle.gone))
            workspace.session.timeline.end_act()
        self._held = self._mark = None
        return busy

    def strokes(self, workspace: Workspace) -> list[Line]:
        """Dots at the edge, a cross in the middle, and the edge where water does not fill it."""
        name, world = workspace.selection.region, workspace.session.world
        row = world.directory.find_region(name)
        lines: list[Line] = []
        if row is not None and world.state.census.regions.items[row].surfaced:
            lines += outline(workspace, corners_of(world.state, row), closed=True, width=1.0)
        for handle in _handles(workspace):
            x, y = (float(part) for part in workspace.viewport.camera.to_screen(handle.place))
            arm = 8.0 if handle.moves else 0.0
            ends = [((x - arm, y), (x + arm, y)), ((x, y - arm), (x, y + arm))]
            width = 3.0 if handle.moves else 5.0 if handle.new else 9.0
            lines += [Line(start, end, width, workspace.theme.drag, 0.95) for start, end in ends]
        return lines


def _handles(workspace: Workspace) -> list[Handle]:
    return handles_of(workspace.session.world, workspace.selection.region)

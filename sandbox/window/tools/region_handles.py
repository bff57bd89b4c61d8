"""The handles of the selected region: what is dragged at its middle moves it, elsewhere at its edge resizes it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from sandbox.engine.commands.set_region import SetRegion
from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.replay.moment import Mark
from sandbox.window.tools.tool import Pointer, outline
from sandbox.window.workspace import Workspace
from sandbox.world.region_area import Box, box_of, corners_of, disc_of, level_of
from sandbox.world.state import State

HANDLE_PIXELS = 10.0
"""How far beside a handle a press still takes it."""
Area = dict[str, Any]
"""Fields of `SetRegion` that say where a region is."""


@dataclass(frozen=True)
class Handle:
    """Something to drag, at a `place` (m): `moves` the whole or a part, and tells the `area` for another place."""

    place: Vec
    moves: bool
    area: Callable[[Vec], Area]


def handles_of(world: World, name: str | None) -> list[Handle]:
    """Those of the region of that name: the one in the middle first; none if it has no area."""
    row = world.directory.find_region(name)
    return [] if row is None else [*_grip(world.state, row), *_rim(world.state, row)]


def middle_of(world: World, name: str) -> Vec | None:
    """The middle of the region's area (m); None if it has none."""
    return next((one.place for one in handles_of(world, name) if one.moves), None)


def command_of(name: str, handle: Handle, place: Vec) -> SetRegion:
    """What dragging a handle to a place does."""
    return SetRegion(name, **handle.area(place))


def _grip(state: State, row: int) -> Iterator[Handle]:
    """The handle in the middle, which takes all that there is of the area along, and the surface of water."""
    box, corners, disc = box_of(state, row), corners_of(state, row), disc_of(state, row)
    around = corners or ([disc[:2]] if disc else [])
    if not around:
        return
    middle = sum(x for x, _ in around) / len(around), sum(y for _, y in around) / len(around)
    level = level_of(state, row) if state.census.regions.items[row].surfaced else None

    def moved(to: Vec) -> Area:
        x, y = to[0] - middle[0], to[1] - middle[1]
        area: Area = {"disc": (disc[0] + x, disc[1] + y, disc[2])} if disc else {}
        if box:
            area["inside"] = box[0] + x, box[1] + y, box[2] + x, box[3] + y
        elif corners:
            area["outline"] = tuple((a + x, b + y) for a, b in corners)
        return area if level is None else {**area, "surface": level + y}

    yield Handle(middle, True, moved)


def _rim(state: State, row: int) -> Iterator[Handle]:
    box, corners, disc = box_of(state, row), corners_of(state, row), disc_of(state, row)
    if box:
        yield from _box_handles(box)
        if state.census.regions.items[row].surfaced:
            yield Handle((0.25 * box[0] + 0.75 * box[2], level_of(state, row)), False, lambda to: {"surface": to[1]})
    else:
        for number in range(len(corners)):
            yield _corner_handle(corners, number)
    if disc:
        x, y, _ = disc
        yield Handle((x + disc[2], y), False, lambda to: {"disc": (x, y, math.dist((x, y), to))})


def _box_handles(box: Box) -> Iterator[Handle]:
    """Four corners and four sides; what is dragged past the opposite side comes out on its other side."""
    across = ((box[0], (0,)), (0.5 * (box[0] + box[2]), ()), (box[2], (2,)))
    upward = ((box[1], (1,)), (0.5 * (box[1] + box[3]), ()), (box[3], (3,)))

    def stretched(sides: tuple[int, ...], to: Vec) -> Area:
        left, bottom, right, top = (to[side % 2] if side in sides else box[side] for side in range(4))
        return {"inside": (min(left, right), min(bottom, top), max(left, right), max(bottom, top))}

    for x, x_sides in across:
        for y, y_sides in upward:
            if x_sides or y_sides:
                yield Handle((x, y), False, partial(stretched, (*x_sides, *y_sides)))


def _corner_handle(corners: list[Vec], number: int) -> Handle:
    def pulled(to: Vec) -> Area:
        return {"outline": (*corners[:number], to, *corners[number + 1 :])}

    return Handle(corners[number], False, pulled)


class RegionDrag:
    """The handle that the hand holds, and what it has done to the region up to now: one act."""

    def __init__(self) -> None:
        self._held: tuple[str, Handle] | None = None
        self._mark: Mark | None = None

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
        self._held, self._mark = (name, handle), timeline.mark()
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Put it where the pointer is."""
        if self._held is None or self._mark is None:
            return
        name, handle = self._held
        try:
            workspace.session.adjust(self._mark, command_of(name, handle, pointer.point))
        except SandboxError as error:
            workspace.say(str(error))

    def release(self, workspace: Workspace) -> bool:
        """Let go; False if nothing was held."""
        busy = self.busy
        if busy:
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
            width = 3.0 if handle.moves else 9.0
            lines += [Line(start, end, width, workspace.theme.drag, 0.95) for start, end in ends]
        return lines


def _handles(workspace: Workspace) -> list[Handle]:
    return handles_of(workspace.session.world, workspace.selection.region)

"""What a tool is: what the left mouse button means in the viewport."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.render.pick import pick
from sandbox.window.hint import Hint, Key
from sandbox.window.workspace import Workspace
from sandbox.world.records import DYNAMIC, KINEMATIC, STATIC

GRAB_PIXELS = 6.0
"""How far beside a body a click still catches it."""
ANY_TYPE = (STATIC, KINEMATIC, DYNAMIC)


@dataclass(frozen=True)
class Pointer:
    """Where the mouse is: `pixel` of the window, `point` in metres; `more`: Shift is held, `free`: Ctrl."""

    pixel: Vec
    point: Vec
    more: bool = False
    free: bool = False


class Tool:
    """A tool. One object each, in the registry; what it is in the middle of, it keeps itself until `cancel`.

    `press` says whether it wants the drag that may follow; if not, the drag pans.
    """

    name: ClassVar[str]
    title: ClassVar[str]
    icon: ClassVar[str]
    key: ClassVar[str] = ""
    help: ClassVar[str]
    keys: ClassVar[tuple[Key, ...]] = ()
    """What is held or pressed with it."""

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """The left button goes down."""
        return False

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """The mouse moves, with or without the button."""

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """The left button goes up, if `press` wanted it."""

    def confirm(self, workspace: Workspace) -> bool:
        """Enter: finish what is in the middle. False if there is nothing."""
        return False

    def cancel(self, workspace: Workspace) -> bool:
        """Esc, or another tool: leave what is in the middle. False if there is nothing."""
        return False

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """What it draws over the scene, in pixels of the viewport."""
        return ()

    def hint(self, workspace: Workspace) -> Hint:
        """What the next click or key will do, for the status line."""
        return Hint(self.help, self.keys)

    @classmethod
    def told(cls) -> str:
        """What it does, and its keys, in words."""
        return Hint(cls.help, cls.keys).text


def body_under(workspace: Workspace, pointer: Pointer, types: Sequence[int] = ANY_TYPE) -> str | None:
    """The id of the body under the pointer, or up to `GRAB_PIXELS` beside it; static ones come last."""
    frame = workspace.session.frame()
    slack = GRAB_PIXELS / workspace.viewport.camera.scale
    moving = [kind for kind in types if kind != STATIC]
    row = pick(frame, pointer.point, slack, moving)
    if row is None and STATIC in types:
        row = pick(frame, pointer.point, slack, (STATIC,))
    return None if row is None else frame.roster.names[row]


def fresh_id(workspace: Workspace, stem: str, others: Sequence[str] = ()) -> str:
    """STEM-1, STEM-2, ...: the first that no body, joint or region has, and that is none of the `others`."""
    world = workspace.session.world
    taken = {*world.names, *world.joint_names, *world.state.census.regions.names, *others}
    return next(name for number in range(1, len(taken) + 2) if (name := f"{stem}-{number}") not in taken)


def outline(workspace: Workspace, points: Sequence[Vec], closed: bool, width: float = 2.0) -> list[Line]:
    """Strokes along points of the plane, in the colour of tools."""
    if not points:
        return []
    pixels = [(float(x), float(y)) for x, y in workspace.viewport.camera.to_screen(points)]
    ends = [*pixels[1:], pixels[0]] if closed else pixels[1:]
    return [Line(a, b, width, workspace.theme.drag, 0.95) for a, b in zip(pixels, ends, strict=False)]

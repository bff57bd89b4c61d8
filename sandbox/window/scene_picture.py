"""What is painted of the scene: bodies in their colours, overlays, ghosts, and the outline of what is selected."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sandbox.render.body_colors import BodyColors, body_colors_of
from sandbox.render.camera import Camera
from sandbox.render.coloring.registry import shown_coloring
from sandbox.render.draw_list import DrawList, build_draw_list
from sandbox.render.frame import Frame
from sandbox.render.line import Line
from sandbox.render.marks import LegendEntry, Marks
from sandbox.render.overlays import trails
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.registry import OVERLAYS, draw_overlays
from sandbox.render.trails import Trails
from sandbox.window.compare import ghost_over
from sandbox.window.highlight import highlight, highlight_joint, highlight_region
from sandbox.window.workspace import Workspace

TRAILS = trails.OVERLAY.name
Seen = tuple[Camera, list[Line], bool]
"""Camera, strokes of the tool in hand, and whether bodies cast shadows."""


class ScenePicture:
    """Makes the draw list of a workspace's scene; `strokes` are those of the tool in hand."""

    def __init__(self, workspace: Workspace, strokes: Callable[[], Sequence[Line]]) -> None:
        self.workspace = workspace
        self._strokes = strokes
        self._colors = body_colors_of(workspace.session.world.state, workspace.theme)
        self.legend: list[LegendEntry] = []
        """What the colours of the overlays in the last picture mean."""
        self._last: tuple[Frame, BodyColors, Seen, DrawList] | None = None
        """The last picture and what it was made of."""

    def of(self, frame: Frame) -> DrawList:
        """What painters draw of a frame: the same object as before, if nothing has changed."""
        workspace = self.workspace
        if workspace.theme is not self._colors.theme:
            self._colors = body_colors_of(workspace.session.world.state, workspace.theme)
        self._colors = self._colors.for_frame(frame)
        camera, strokes, marks = workspace.viewport.camera, list(self._strokes()), self._marks(frame)
        last, seen = self._last, (camera, strokes, workspace.depth)
        same = last is not None and last[0] is frame and last[1] is self._colors and last[2] == seen
        if last is None or not same or any(marks) or any(last[3].marks[1:]):
            picture = build_draw_list(frame, camera, self._colors, strokes, marks, workspace.depth)
            self._last = last = frame, self._colors, seen, picture
        return last[3]

    def _marks(self, frame: Frame) -> tuple[Marks, ...]:
        workspace = self.workspace
        camera, theme, world = workspace.viewport.camera, workspace.theme, workspace.session.world
        selection = workspace.selection
        lit = highlight(frame, camera, selection.bodies, theme.drag)
        if selection.joint is not None:
            lit = highlight_joint(world.state, frame, camera, selection.joint, theme.drag)
        if selection.region is not None:
            lit = highlight_region(world.state, camera, world.directory.find_region(selection.region), theme.drag)
        shown = [*shown_coloring(workspace.color_by), *(OVERLAYS[name] for name in workspace.overlays)]
        look = Look(world, frame, camera, theme, self._trails(), workspace.text_scale)
        layers = draw_overlays(shown, look, corner=None)
        self.legend = [entry for layer in layers for entry in layer.legend]
        return *layers, ghost_over(workspace, frame), lit

    def _trails(self) -> Trails | None:
        """What is kept of where bodies were: nothing while trails are off."""
        workspace, session = self.workspace, self.workspace.session
        if TRAILS not in workspace.overlays:
            session.trails = None
        elif session.trails is None:
            session.trails = Trails()
        if session.trails is not None:
            session.trails.only = workspace.selection.bodies
        return session.trails

"""The separating-axis test of one pair, live: its table, its axes turned by hand, its outcome, told step by step."""

from __future__ import annotations

from collections.abc import Sequence

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import Overlay
from sandbox.window.panels.panel import Panel
from sandbox.window.sat.colors import sat_colors
from sandbox.window.sat.drawing import Drawing
from sandbox.window.sat.focus import Focus
from sandbox.window.sat.free_axis_view import FreeAxisView
from sandbox.window.sat.inspection import Inspection, Inspector
from sandbox.window.sat.overlap_curve import axis_at
from sandbox.window.sat.pair_view import PairView
from sandbox.window.sat.pen import Pen
from sandbox.window.sat.regression import save_regression
from sandbox.window.sat.scene_handle import draw_handle
from sandbox.window.sat.shape_drawing import edge_near
from sandbox.window.sat.table_view import TableView
from sandbox.window.sat.tour import Kind, Step, tour_of
from sandbox.window.sat.tour_view import draw_tour
from sandbox.window.sat.verdict_view import draw_verdict
from sandbox.window.widgets import button, section
from sandbox.window.workspace import Workspace

EDGE_PIXELS = 7.0
"""How near the pointer must be to an edge in the scene to point at it."""

FIGURES: dict[str, Kind] = {"edges": "axes", "perpendiculars": "axes", "mtv": "orientation", "clipping": "cut"}
"""Steps of the tour that show what figures of `sandbox sat` show."""


class SatPanel(Panel):
    """The inspector of one pair."""

    name = "sat"
    title = "SAT"
    icon = icons.ICON_FA_OBJECT_UNGROUP
    help = "The separating-axis test of two bodies, axis by axis."
    key = "F4"
    exact = True

    def __init__(self) -> None:
        self.inspector = Inspector()
        self.focus = Focus()
        self._pairs = PairView(self.inspector)
        self._names: tuple[str, str] | None = None
        self._tour: tuple[Inspection | None, Sequence[Step]] = (None, ())

    def look(self, workspace: Workspace) -> Inspection | None:
        """The pair that is picked, as it is now; None if there is none."""
        names = workspace.selection.pair
        if names != self._names:
            self._names = names
            self.focus.forget()
        return self.inspector.look(workspace.session.world, names)

    def steps(self, seen: Inspection) -> Sequence[Step]:
        """The tour of what is seen."""
        if self._tour[0] is not seen:
            self._tour = seen, tour_of(seen)
        return self._tour[1]

    def draw(self, workspace: Workspace) -> None:
        """Pair, verdict, steps, table, free axis. Where there are only two bodies, they are the pair."""
        names = workspace.session.world.names
        if workspace.selection.pair is None and len(names) == 2:
            workspace.selection.pair = names[0], names[1]
        seen = self.look(workspace)
        self._pairs.draw(workspace, seen)
        if seen is None:
            return
        self._take_figure(workspace, seen)
        palette, colors = palette_of(workspace.theme), sat_colors(workspace.theme)
        draw_verdict(seen, palette, colors)
        if section("Step by step"):
            draw_tour(self.steps(seen), self.focus, workspace)
        if section("Axes"):
            TableView(seen, self.focus, palette, colors).draw()
        if section("Any axis"):
            FreeAxisView(seen, self.focus, palette, colors).draw()
        self._draw_buttons(workspace, seen)

    def draw_over(self, workspace: Workspace, overlay: Overlay) -> None:
        """The shapes, one rail, and the outcome or the step that is told."""
        seen = self.look(workspace)
        if seen is None:
            return
        self._point(workspace, seen)
        drawing = Drawing(Pen(workspace, overlay), seen, sat_colors(workspace.theme), workspace.viewport.camera)
        step = self._step(seen)
        drawing.shapes()
        if step is None:
            drawing.outcome()
            self._draw_axis(workspace, drawing)
        elif self.focus.hovered is not None:
            self._draw_axis(workspace, drawing)
        else:
            _draw_step(drawing, step)

    def _draw_axis(self, workspace: Workspace, drawing: Drawing) -> None:
        """The rail of the row in focus, or of the free axis with its handle."""
        row = self.focus.row(drawing.seen)
        if row is not None:
            drawing.edge(row)
            drawing.rail(row.axis, row)
        elif self.focus.free is not None:
            drawing.rail(axis_at(self.focus.free))
        if self.focus.free is not None:
            draw_handle(workspace, drawing, self.focus)

    def _take_figure(self, workspace: Workspace, seen: Inspection) -> None:
        """Show what somebody else has asked for: an axis, or a step of the tour."""
        if workspace.selection.figure is None:
            return
        (figure, axis), workspace.selection.figure = workspace.selection.figure, None
        kinds = [step.kind for step in self.steps(seen)]
        wanted = FIGURES.get(figure)
        self.focus.free, self.focus.chosen = None, axis
        self.focus.step = kinds.index(wanted) if wanted in kinds else None

    def _step(self, seen: Inspection) -> Step | None:
        """The step that is told, if one is."""
        if self.focus.step is None:
            return None
        steps = self.steps(seen)
        self.focus.step = min(self.focus.step, len(steps) - 1)
        return steps[self.focus.step]

    def _point(self, workspace: Workspace, seen: Inspection) -> None:
        """Note which edge the pointer is at in the scene."""
        io, self.focus.lit = imgui.get_io(), None
        pixel = (io.mouse_pos.x, io.mouse_pos.y)
        if io.want_capture_mouse or io.mouse_down[0] or not workspace.viewport.holds(pixel):
            return
        row = edge_near(seen, workspace.viewport.point(pixel), EDGE_PIXELS / workspace.viewport.camera.scale)
        self.focus.lit = None if row is None else row.number

    def _draw_buttons(self, workspace: Workspace, seen: Inspection) -> None:
        imgui.dummy(imgui.ImVec2(0.0, 2.0))
        tip = "Write these two bodies as a scene, and what must hold of them; sandbox check judges it."
        if button("sat.save", f"{icons.ICON_FA_FLOPPY_DISK}  Save as regression test", tip, width=-1.0):
            with workspace.attempt("not saved", OSError):
                session = workspace.session
                path = save_regression(seen, session.stem, session.timeline.step_count, workspace.folder)
                workspace.say(f"saved: {path.name}")


def _draw_step(drawing: Drawing, step: Step) -> None:
    """What belongs to one step of the tour."""
    row = drawing.seen.row(step.row)
    if step.kind == "axes":
        drawing.perpendiculars()
    if step.kind == "exit":
        drawing.outcome()
    if row is not None:
        drawing.edge(row)
        drawing.rail(row.axis, row)
    if step.kind == "orientation":
        drawing.way_out()
    if step.kind in ("reference", "cut", "points"):
        drawing.clipping(cut=step.kind != "reference")
    if step.kind == "points":
        drawing.points()

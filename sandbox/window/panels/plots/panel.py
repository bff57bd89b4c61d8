"""Time series over the timeline: energy, momentum, overlap, cost, and any field of the selected body."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox._atomic_write import write_text
from sandbox.tables import Floats
from sandbox.window.history import History
from sandbox.window.panels.panel import Panel
from sandbox.window.panels.plots.chart import draw_chart
from sandbox.window.panels.plots.quantities import BODY, CHARTS, WORLD, Chart, body_values, world_values
from sandbox.window.panels.plots.table import csv_text
from sandbox.window.plot_style import plot_style
from sandbox.window.session import free_path
from sandbox.window.stage_times import StageTimes
from sandbox.window.widgets import button, checkbox, choice, wrapped
from sandbox.window.workspace import Workspace

SPANS = {"all": 0.0, "10 s": 10.0, "3 s": 3.0, "1 s": 1.0}
LEAST_WIDTH, LEAST_HEIGHT = 210.0, 90.0
LIST_EMS = 10.5


class PlotsPanel(Panel):
    """Keeps numbers of each step taken while it is open, and draws those that are chosen."""

    name = "plots"
    title = "Plots"
    icon = icons.ICON_FA_CHART_LINE
    help = "Energy, momentum, overlap, contacts, time a step, and the selected body, over time."
    key = "F6"
    side = "bottom"

    def __init__(self) -> None:
        self.chosen = {"energy", "overlap"}
        self._span = "all"
        self._world = History(WORLD)
        self._bodies: dict[str, History] = {}
        self._stages = StageTimes()

    def note_step(self, workspace: Workspace) -> None:
        """Keep the numbers of this step."""
        session, world = workspace.session, workspace.session.world
        self._follow(workspace)
        self._world.note(world.step_count, world_values(world, session.timeline.cost, self._stages.take(world)))
        name = self._body(workspace)
        if name is not None:
            history = self._bodies.setdefault(name, History(BODY))
            history.follow(session.timeline)
            history.note(world.step_count, body_values(world, world.directory.body(name)))

    def draw(self, workspace: Workspace) -> None:
        """Boxes to tick at the left, plots at the right."""
        self._follow(workspace)
        width = imgui.get_font_size() * LIST_EMS
        imgui.begin_child("charts", imgui.ImVec2(width, 0.0))
        self._draw_list(workspace)
        imgui.end_child()
        imgui.same_line()
        imgui.begin_child("plots", imgui.ImVec2(0.0, 0.0))
        charts = self._shown(workspace)
        if not charts:
            wrapped("Tick what is to be plotted. Fields of a body need one that is selected.")
        elif not len(self._world):
            wrapped("Let time run: what is plotted is taken at each step from now on.")
        else:
            self._draw_plots(workspace, charts)
        imgui.end_child()

    def values(self, workspace: Workspace) -> dict[str, Floats]:
        """What is known of every quantity, by step."""
        found = {name: self._world.column(name) for name in WORLD}
        history = self._bodies.get(self._body(workspace) or "")
        return found | ({name: history.column(name) for name in BODY} if history is not None else {})

    def save(self, workspace: Workspace) -> None:
        """Write what is shown as the first free NAME-plots.csv in the folder the program was started in."""
        known = self.values(workspace)
        lines = [
            (chart, name, title) for chart in self._shown(workspace) for name, title in chart.lines if name in known
        ]
        seconds = workspace.session.clock.step_seconds
        with workspace.attempt("not saved", OSError):
            path = free_path(workspace.folder, f"{workspace.session.stem}-plots", ".csv")
            write_text(path, csv_text(lines, known, seconds))
            workspace.say(f"saved {path.name}")

    def _follow(self, workspace: Workspace) -> None:
        for history in (self._world, *self._bodies.values()):
            history.follow(workspace.session.timeline)

    def _body(self, workspace: Workspace) -> str | None:
        """The body whose fields are plotted: the one selected first."""
        return next(iter(workspace.selection.bodies), None) if self._present(workspace) else None

    @staticmethod
    def _present(workspace: Workspace) -> bool:
        bodies = workspace.selection.bodies
        return bool(bodies) and bodies[0] in workspace.session.world.state.census.bodies.names

    def _shown(self, workspace: Workspace) -> list[Chart]:
        body = self._body(workspace)
        return [chart for chart in CHARTS if chart.name in self.chosen and (body is not None or not chart.of_body)]

    def _draw_list(self, workspace: Workspace) -> None:
        imgui.set_next_item_width(imgui.get_font_size() * 4.5)
        self._span = choice("plots.span", "", self._span, list(SPANS), "How much time is shown, up to now.")
        imgui.same_line()
        enabled = bool(self._shown(workspace)) and bool(len(self._world))
        if button("plots.csv", f"{icons.ICON_FA_FILE_CSV}  CSV", "Save what is shown as a table.", enabled=enabled):
            self.save(workspace)
        imgui.separator()
        body = self._body(workspace)
        for chart in CHARTS:
            if chart.of_body and chart is CHARTS[_FIRST_OF_BODY]:
                imgui.separator()
                imgui.text_disabled(body or "no body selected")
            imgui.begin_disabled(chart.of_body and body is None)
            on = checkbox(f"plots.{chart.name}", chart.title, chart.name in self.chosen, chart.tip)
            imgui.end_disabled()
            (self.chosen.add if on else self.chosen.discard)(chart.name)

    def _draw_plots(self, workspace: Workspace, charts: list[Chart]) -> None:
        room = imgui.get_content_region_avail()
        columns = min(len(charts), max(int(room.x // LEAST_WIDTH), 1))
        rows = -(-len(charts) // columns)
        columns = -(-len(charts) // rows)
        gap = imgui.get_style().item_spacing
        height = max((room.y - (rows - 1) * gap.y) / rows, LEAST_HEIGHT)
        known = self.values(workspace)
        plot_style(workspace.theme)
        for number, chart in enumerate(charts):
            if number % columns:
                imgui.same_line()
            beside = min(len(charts) - number // columns * columns, columns)  # the last row is as wide as the others
            width = (room.x - (beside - 1) * gap.x) / beside
            draw_chart(workspace, chart, known, self._limits(workspace), (width, height))

    def _limits(self, workspace: Workspace) -> tuple[float, float]:
        """First and last step that are shown: none before there was anything to keep, unless time stands there."""
        timeline, span = workspace.session.timeline, SPANS[self._span]
        now = timeline.step_count
        first = float(min(self._world.first, now))
        if not span:
            return first, max(float(timeline.length), first + 1.0)
        return max(first, now - span / workspace.session.clock.step_seconds), max(float(now), first + 1.0)


_FIRST_OF_BODY = next(number for number, chart in enumerate(CHARTS) if chart.of_body)

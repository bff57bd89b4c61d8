"""One chart of the plots panel: its lines, its limits, and the cursor at the present step."""

from __future__ import annotations

import numpy as np
from imgui_bundle import imgui, implot
from numpy.typing import NDArray

from sandbox.tables import Floats, Integers
from sandbox.window.history import thinned
from sandbox.window.panels.plots.quantities import Chart
from sandbox.window.plot_style import line_look
from sandbox.window.stage_times import STAGES
from sandbox.window.widgets import mark
from sandbox.window.workspace import Workspace

_LOCKED = implot.AxisFlags_.lock | implot.AxisFlags_.no_highlight | implot.AxisFlags_.no_menus
_FLAGS = implot.Flags_.no_menus | implot.Flags_.no_box_select | implot.Flags_.no_mouse_text
NEAR_PIXELS, DASH_PIXELS = 1.5, 9.0
"""Lines nearer than the first take turns to be seen, each over so many pixels."""
LEGEND_PIXELS, FRAME_PIXELS = 28.0, 48.0
"""Height of the legend, and of what stands above and below a plot."""
_NOTHING: Floats = np.zeros(0)


def draw_chart(
    workspace: Workspace, chart: Chart, known: dict[str, Floats], limits: tuple[float, float], size: tuple[float, float]
) -> None:
    """One chart of `size` pixels over the steps between `limits`, with the line of the present."""
    session = workspace.session
    seconds = session.clock.step_seconds
    unit = f", {chart.unit}" if chart.unit else ""
    if not implot.begin_plot(f"{chart.title}{unit}##{chart.name}", imgui.ImVec2(*size), _FLAGS):
        return
    low, high = limits
    lines = _visible(chart, known, (low, high), int(size[0]))
    bottom, top = value_range([values for _, _, values in lines], size[1])
    implot.setup_axes("", "", _LOCKED, _LOCKED)
    implot.setup_axis_limits(implot.ImAxis_.x1, low * seconds, high * seconds, implot.Cond_.always)
    implot.setup_axis_limits(implot.ImAxis_.y1, bottom, top, implot.Cond_.always)
    implot.setup_axis_format(implot.ImAxis_.x1, "%g s")
    implot.setup_legend(implot.Location_.north_west, implot.LegendFlags_.horizontal)
    drawn = implot.get_plot_size()
    scale = drawn.x / max(high - low, 1e-9), drawn.y / (top - bottom)
    covered = [np.column_stack([places * scale[0], values * scale[1]]) for _, places, values in lines]
    for number, (title, places, values) in enumerate(lines):
        shown = np.where(gaps(covered[number], covered[:number]), np.nan, values)
        implot.plot_line(title, places * seconds, shown, line_look(workspace.theme, number))
    cursor_seek(workspace, seconds)
    implot.end_plot()
    mark(f"plots.chart.{chart.name}")


def _visible(
    chart: Chart, known: dict[str, Floats], limits: tuple[float, float], pixels: int
) -> list[tuple[str, Integers, Floats]]:
    """The lines of a chart: title, steps and values. Stages that never ran are left out."""
    lines = []
    for name, title in chart.lines:
        values = known.get(name, _NOTHING)
        if name in STAGES and not np.nansum(values):
            continue
        places = thinned(values, min(int(limits[0]), len(values)), min(int(limits[1]) + 1, len(values)), pixels)
        lines.append((title, places, values[places]))
    return lines


def gaps(line: Floats, beneath: list[Floats]) -> NDArray[np.bool_]:
    """Where a line (n, 2) is left out, so that those `beneath` it are seen where it covers them: all in pixels."""
    covers = np.zeros(len(line), np.int64)
    for other in beneath:
        if len(other):
            covers += np.abs(np.interp(line[:, 0], other[:, 0], other[:, 1]) - line[:, 1]) < NEAR_PIXELS
    turn = (line[:, 0] // DASH_PIXELS).astype(np.int64) % (covers + 1)
    return np.asarray(turn != covers, np.bool_)


def value_range(lines: list[Floats], pixels: float = 200.0) -> tuple[float, float]:
    """Bottom and top of a plot so many pixels high that shows all of some lines, with room for the legend."""
    values = np.concatenate([*lines, _NOTHING])
    values = values[~np.isnan(values)]
    if not len(values):
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    size = high - low
    if size <= 1e-6 * max(abs(low), abs(high)):  # a level line: no noise blown up, no zooming into nothing
        size = 0.1 * abs(high) or 1.0
    legend = min(LEGEND_PIXELS / max(pixels - FRAME_PIXELS - LEGEND_PIXELS, 1.0), 1.0)
    return low - 0.1 * size, high + max(1.1 * legend, 0.15) * size


def cursor_seek(workspace: Workspace, seconds: float) -> None:
    """The line of the present step in the plot that is drawn; the left button on the plot goes there."""
    session = workspace.session
    look = line_look(workspace.theme, -1)
    implot.plot_inf_lines("##now", np.array([session.timeline.step_count * seconds]), look)
    if implot.is_plot_hovered() and imgui.is_mouse_down(imgui.MouseButton_.left):
        wanted = min(max(round(implot.get_plot_mouse_pos().x / seconds), 0), session.timeline.length)
        session.clock.paused = True
        if wanted != session.timeline.step_count:
            session.seek(wanted)

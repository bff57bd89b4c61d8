"""Where the time of a step goes: a table by stage, and a strip of the last steps."""

from __future__ import annotations

import numpy as np
from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui, implot

from sandbox.window.gui_style import palette_of
from sandbox.window.panels.panel import Panel
from sandbox.window.panels.profile.table import PARTS, REST, StageTable
from sandbox.window.plot_style import line_color, line_look, plot_style
from sandbox.window.stage_times import STAGES, StageTimes
from sandbox.window.widgets import mark, wrapped
from sandbox.window.workspace import Workspace

STRIP_EMS, TABLE_EMS, BESIDE_EMS = 9.0, 21.0, 34.0
LEAST_STRIP = 60.0
_AUTO = imgui.ChildFlags_.auto_resize_y
_REST_TIP = "Python around the compiled calls, and events if they are asked for."
_LOCKED = implot.AxisFlags_.lock | implot.AxisFlags_.no_highlight | implot.AxisFlags_.no_menus
_FLAGS = (
    implot.Flags_.no_menus | implot.Flags_.no_box_select | implot.Flags_.no_mouse_text | implot.Flags_.no_legend
    | implot.Flags_.no_title
)  # fmt: skip
_COLUMNS = (("stage", 1.7), ("ms now", 1.0), ("mean", 1.0), ("share", 1.0))


class ProfilePanel(Panel):
    """Times the stages of each step taken while it is open."""

    name = "profile"
    title = "Profile"
    icon = icons.ICON_FA_STOPWATCH
    help = "Where the time of a step goes, by stage."
    key = "F7"
    side = "bottom"

    def __init__(self) -> None:
        self.table = StageTable()
        self._times = StageTimes()

    def note_step(self, workspace: Workspace) -> None:
        """Keep what this step took; the first one tells how long it took, but not yet on what."""
        stages = self._times.take(workspace.session.world)
        if stages:
            self.table.note(1000.0 * workspace.session.timeline.cost, stages)

    def draw(self, workspace: Workspace) -> None:
        """The table, the strip, and how it is measured."""
        if not len(self.table):
            wrapped("Let time run: stages are timed at each step from now on.")
            return
        beside = imgui.get_content_region_avail().x > BESIDE_EMS * imgui.get_font_size()
        imgui.begin_child("table", imgui.ImVec2(TABLE_EMS * imgui.get_font_size() if beside else 0.0, 0.0), _AUTO)
        self._draw_table(workspace)
        wrapped(f"Mean and strip are of the last {len(self.table)} steps.")
        imgui.end_child()
        if beside:
            imgui.same_line()
        self._draw_strip(workspace, imgui.get_content_region_avail().y if beside else 0.0)

    def _draw_table(self, workspace: Workspace) -> None:
        if not imgui.begin_table("stages", len(_COLUMNS), imgui.TableFlags_.sizing_stretch_prop):
            return
        for title, share in _COLUMNS:
            imgui.table_setup_column(title, imgui.TableColumnFlags_.width_stretch, share)
        imgui.table_headers_row()
        summary = self.table.summary()
        for name, now, mean, share in summary:
            title, tip = STAGES.get(name, (REST, _REST_TIP))
            imgui.table_next_row()
            imgui.table_set_column_index(0)
            color = line_color(workspace.theme, PARTS.index(name))
            imgui.text_colored(imgui.ImVec4(*color, 1.0), icons.ICON_FA_SQUARE)
            imgui.same_line()
            imgui.text_unformatted(title)
            mark(f"profile.{name}", tip)
            self._draw_figures(workspace, (now, mean, share))
        imgui.table_next_row()
        imgui.table_set_column_index(0)
        imgui.text_unformatted("step")
        self._draw_figures(workspace, tuple(map(sum, zip(*(row[1:] for row in summary), strict=True))))
        imgui.end_table()

    @staticmethod
    def _draw_figures(workspace: Workspace, figures: tuple[float, ...]) -> None:
        now, mean, share = figures
        for column, words in ((1, f"{now:.3f}"), (2, f"{mean:.3f}")):
            imgui.table_set_column_index(column)
            imgui.text_unformatted(words)
        imgui.table_set_column_index(3)
        corner, width = imgui.get_cursor_screen_pos(), imgui.get_content_region_avail().x
        height = imgui.get_font_size()
        color = imgui.color_convert_float4_to_u32(imgui.ImVec4(*palette_of(workspace.theme).raised, 1.0))
        far = imgui.ImVec2(corner.x + width * min(share, 1.0), corner.y + height)
        imgui.get_window_draw_list().add_rect_filled(corner, far, color, 3.0)
        imgui.text_unformatted(f" {100.0 * share:.0f} %")

    def _draw_strip(self, workspace: Workspace, height: float) -> None:
        """The stages of the last steps, one on top of the other; as high as there is room, or as is usual."""
        plot_style(workspace.theme)
        rows = self.table.rows
        height = max(height, LEAST_STRIP) if height else imgui.get_font_size() * STRIP_EMS
        if not implot.begin_plot("##strip", imgui.ImVec2(-1.0, height), _FLAGS):
            return
        sums = np.concatenate([np.zeros((len(rows), 1)), rows.cumsum(axis=1)], axis=1)
        top = max(float(np.percentile(sums[:, -1], 95.0)) * 1.3, 1e-3)
        implot.setup_axes("", "", _LOCKED | implot.AxisFlags_.no_tick_labels, _LOCKED)
        implot.setup_axis_limits(implot.ImAxis_.x1, 0.0, max(len(rows) - 1.0, 1.0), implot.Cond_.always)
        implot.setup_axis_limits(implot.ImAxis_.y1, 0.0, top, implot.Cond_.always)
        implot.setup_axis_format(implot.ImAxis_.y1, "%g ms")
        places = np.arange(len(rows), dtype=float)
        for number, name in enumerate(PARTS):
            if rows[:, number].any():
                low, high = np.ascontiguousarray(sums[:, number]), np.ascontiguousarray(sums[:, number + 1])
                implot.plot_shaded(name, places, low, high, line_look(workspace.theme, number))
        implot.end_plot()
        mark("profile.strip")

"""What happened, step by step: contacts, hits, sensors, sleep, breaks. A click goes there in time and space."""

from __future__ import annotations

from typing import Any

import numpy as np
from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.engine.events.events import KINDS
from sandbox.window.gui_style import palette_of
from sandbox.window.panels.events.log import EventTable, Filter, LoggedEvent
from sandbox.window.panels.events.rows import STEP_KINDS
from sandbox.window.panels.panel import Panel
from sandbox.window.widgets import button, mark, text, wrapped
from sandbox.window.workspace import Workspace

TITLES = {
    "begin": "begin", "end": "end", "hit": "hit", "enter": "enter", "leave": "leave", "sleep": "sleep", "wake": "wake",
    "freeze": "freeze", "joint_break": "break", "counter": "counter", "spawn": "spawn", "delete": "delete",
    "win": "win", "lose": "lose", "refused": "refused",
}  # fmt: skip
TIPS = {
    "begin": "Shapes began to push or overlap.", "end": "Shapes came apart.", "hit": "Struck at 1 m/s or more.",
    "enter": "A sensor has something in it that it had not.", "leave": "Something left a sensor.",
    "sleep": "Fell asleep.", "wake": "Woke up.", "freeze": "Stopped for good by bad numbers.",
    "joint_break": "A joint broke.", "counter": "A rule has counted.", "spawn": "A rule brought bodies in.",
    "delete": "A rule took bodies out.", "win": "Won.", "lose": "Lost.",
    "refused": "What a rule or control was to do could not be done.",
}  # fmt: skip
STRONG = ("hit", "joint_break", "freeze", "win", "lose", "refused")
_FLAGS = (
    imgui.TableFlags_.row_bg | imgui.TableFlags_.scroll_y | imgui.TableFlags_.sizing_stretch_prop
    | imgui.TableFlags_.borders_inner_h
)  # fmt: skip
_COLUMNS = (("step", 0.7), ("event", 0.7), ("who", 3.0), ("speed m/s", 1.0), ("impulse N s", 1.0))


class EventsPanel(Panel):
    """Keeps the events of each step taken while it is open."""

    name = "events"
    title = "Events"
    icon = icons.ICON_FA_BELL
    help = "Contacts, hits, sensors, sleep and breaks; a click goes there in time and space."
    key = "F5"
    side = "bottom"

    def __init__(self) -> None:
        self.table = EventTable()
        self.filter = Filter()

    def note_step(self, workspace: Workspace) -> None:
        """Keep the events of this step."""
        self.table.follow(workspace.session.timeline)
        self.table.note(workspace.session.world.events)

    def draw(self, workspace: Workspace) -> None:
        """The filter above, the events below, the latest first."""
        self.table.follow(workspace.session.timeline)
        self._draw_filter(workspace)
        found = self.table.matching(self.filter)
        if len(found):
            self._draw_table(workspace, found)
        elif len(self.table):
            wrapped("No event of these kinds and words.")
        else:
            wrapped("Let time run: events are taken at each step from now on.")

    @staticmethod
    def _kinds(workspace: Workspace) -> tuple[str, ...]:
        """Those that there can be: what rules do, only where there are rules or controls."""
        scene = workspace.session.scene
        return KINDS if getattr(scene, "rules", None) or getattr(scene, "controls", None) else STEP_KINDS

    def _draw_filter(self, workspace: Workspace) -> None:
        em = imgui.get_font_size()
        imgui.set_next_item_width(min(10.0 * em, imgui.get_content_region_avail().x))
        hint = f"{icons.ICON_FA_MAGNIFYING_GLASS}  words"
        self.filter.words = text("events.words", "", self.filter.words, hint)
        right = imgui.get_window_pos().x + imgui.get_window_width()
        for kind in self._kinds(workspace):
            width = imgui.calc_text_size(TITLES[kind]).x + 2.0 * imgui.get_style().frame_padding.x
            if imgui.get_item_rect_max().x + width + 12.0 < right:
                imgui.same_line()
            on = kind in self.filter.kinds
            if button(f"events.{kind}", TITLES[kind], TIPS[kind], on=on):
                self.filter.kinds ^= {kind}

    def _draw_table(self, workspace: Workspace, found: Any) -> None:
        if self.table.forgotten:
            wrapped("There were too many: the oldest are forgotten.")
        if not imgui.begin_table("events", len(_COLUMNS), _FLAGS, imgui.ImVec2(0.0, 0.0)):
            return
        imgui.table_setup_scroll_freeze(0, 1)
        for title, share in _COLUMNS:
            imgui.table_setup_column(title, imgui.TableColumnFlags_.width_stretch, share)
        imgui.table_headers_row()
        chosen: LoggedEvent | None = None
        clipper = imgui.ListClipper()
        clipper.begin(len(found))
        while clipper.step():
            for number in range(clipper.display_start, clipper.display_end):
                one = self.table.event(int(found[number]))
                if _draw_row(workspace, one, number):
                    chosen = one
        imgui.end_table()
        if chosen is not None:
            go_to(workspace, chosen)


def _draw_row(workspace: Workspace, one: LoggedEvent, number: int) -> bool:
    """True in the picture in which it is clicked."""
    imgui.table_next_row()
    here = one.step == workspace.session.timeline.step_count
    imgui.table_set_column_index(0)
    flags = imgui.SelectableFlags_.span_all_columns
    clicked, _ = imgui.selectable(f"{one.step:,}##event {number}", here, flags)
    mark(f"events.row.{number}")
    imgui.table_set_column_index(1)
    colors = palette_of(workspace.theme)
    strong = one.kind in STRONG
    imgui.text_colored(imgui.ImVec4(*(colors.accent if strong else colors.faint), 1.0), TITLES[one.kind])
    imgui.table_set_column_index(2)
    imgui.text_unformatted(one.joint or one.said or "  ·  ".join(one.bodies))
    for column, value in ((3, one.speed), (4, one.impulse)):
        imgui.table_set_column_index(column)
        if value:
            imgui.text_unformatted(f"{value:.4g}")
    return bool(clicked)


def go_to(workspace: Workspace, one: LoggedEvent) -> None:
    """Pause at its step, look at where it was, and select who it speaks of."""
    session = workspace.session
    session.clock.paused = True
    session.seek(one.step)
    world, names = session.world, set(session.world.names)
    bodies = tuple(name for name in one.bodies if name in names)
    if one.joint in world.joint_names and one.joint is not None:
        workspace.selection.pick_joint(one.joint)
        bodies = tuple(name for name in world.joint(one.joint).bodies if name is not None)
    else:
        workspace.selection.clear()
        for name in bodies:
            workspace.selection.pick(name, more=True)
    if one.point is not None:
        workspace.viewport.center_on(one.point)
    elif bodies:
        places = np.array([world.body(name).center for name in bodies])
        workspace.viewport.center_on((float(places[:, 0].mean()), float(places[:, 1].mean())))

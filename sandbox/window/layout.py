"""Where things stand: menus at the top, tools at the left, time at the bottom, panels docked, the scene in between."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.render.camera import Size
from sandbox.window.menu_bar import draw_menu_bar
from sandbox.window.panels.panel import Panel
from sandbox.window.scrubber import Scrubber
from sandbox.window.time_bar import draw_time_bar, time_bar_height
from sandbox.window.tool_bar import ToolBar
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.viewport import Rect
from sandbox.window.widgets import mark
from sandbox.window.workspace import Workspace

PANEL_WIDTH, LOW_HEIGHT = 352.0, 200.0
"""Pixels of what is docked at the right, and least of what is docked below, as far as that leaves half to the scene."""
WIDE_SHARE, LOW_SHARE = 0.18, 0.34
"""Of a large window, what they take at least."""
NARROW = 900
"""Below this width of the window, in pixels, no panel is open at first."""
TAB_PAD = 4.0
"""Pixels beside the title of a tab, so that four of them are read in the usual width."""
SETTLING = 2
"""Pictures until panels that come are docked."""
FIXED = (
    imgui.WindowFlags_.no_decoration
    | imgui.WindowFlags_.no_docking
    | imgui.WindowFlags_.no_saved_settings
    | imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_bring_to_front_on_focus
    | imgui.WindowFlags_.no_nav_focus
)


class Layout:
    """Draws all that is not the scene; `draw` says which rectangle is left."""

    def __init__(self, panels: dict[str, Panel], tool_box: ToolBox) -> None:
        self.panels = panels
        self.tool_box = tool_box
        self._shown: set[str] | None = None
        self._fresh: set[str] = set()
        self._settling = SETTLING
        self._picture = 0
        """Number of the last picture that it drew."""
        self._fronts: list[str] = []
        """Panels that are to be in front again."""
        self._scale: float | None = None
        """How large text was in the picture before."""
        self._scrubber = Scrubber()

    def draw(self, workspace: Workspace, size: Size) -> Rect:
        """One picture of it in a window of `size` pixels."""
        if not workspace.interface:
            return 0, 0, *size
        if self._shown is not None and imgui.get_frame_count() != self._picture + 1:
            self._come_back(workspace)
        self._picture = imgui.get_frame_count()
        workspace.steering.set_keys()
        top = draw_menu_bar(workspace, self.panels)
        bar = time_bar_height()
        bottom = size[1] - bar
        tools = ToolBar(bottom - top, size[0])
        left = tools.width
        _fixed("##tools", 0.0, top, left, bottom - top)
        tools.draw(self.tool_box)
        imgui.end()
        _fixed("##time", 0.0, bottom, float(size[0]), bar)
        draw_time_bar(workspace, self._scrubber, self.tool_box.tool.hint(workspace))
        imgui.end()
        rect = self._dock(workspace, (left, top, size[0] - left, bottom - top))
        self._fresh = workspace.panels - self._shown if self._shown is not None else set()
        self._shown = set(workspace.panels)
        for panel in self.panels.values():
            if panel.name in workspace.panels:
                self._draw_panel(workspace, panel)
        titles = {name: _window_title(panel) for name, panel in self.panels.items() if name in self._shown}
        workspace.steering.end_picture(titles, next((name for name in titles if name not in workspace.behind), ""))
        self._settling -= 1
        if self._settling == 0 or (workspace.front and self._settling < 0):  # docked by now
            self._bring_to_front(workspace)
        return rect

    def _come_back(self, workspace: Workspace) -> None:
        """Panels that were not drawn for a while are docked anew: those that were in front are to be so again."""
        self._settling = SETTLING
        self._fronts = [name for name in self.panels if name in workspace.panels - workspace.behind]

    def _bring_to_front(self, workspace: Workspace) -> None:
        """What is wanted there, else the first panel: of those that opened together the last would be in front."""
        shown = [name for name in self.panels if name in workspace.panels]
        wanted = [name for name in (*self._fronts, workspace.front) if name in shown] or shown[:1]
        self._fronts, workspace.front = [], ""
        for name in wanted:
            imgui.set_window_focus(_window_title(self.panels[name]))

    def _draw_panel(self, workspace: Workspace, panel: Panel) -> None:
        imgui.set_next_window_size(imgui.ImVec2(PANEL_WIDTH, 480.0), imgui.Cond_.first_use_ever)
        if panel.name in self._fresh:
            imgui.set_next_window_focus()
        imgui.set_next_window_class(_without_crosses())
        shown, still_open = imgui.begin(_window_title(panel), True)
        mark(f"panel.{panel.name}")
        (workspace.behind.discard if shown else workspace.behind.add)(panel.name)
        if shown:
            panel.draw(workspace)
        imgui.end()
        if not still_open:
            workspace.panels.discard(panel.name)

    def _dock(self, workspace: Workspace, box: tuple[float, float, float, float]) -> Rect:
        """The room for panels and scene: left, top, width, height. Gives what the scene gets."""
        left, top, width, height = *box[:2], max(box[2], 1.0), max(box[3], 1.0)
        imgui.set_next_window_pos(imgui.ImVec2(left, top))
        imgui.set_next_window_size(imgui.ImVec2(width, height))
        imgui.push_style_var(imgui.StyleVar_.window_padding, imgui.ImVec2(0.0, 0.0))
        imgui.begin("##dock", None, FIXED | imgui.WindowFlags_.no_background)
        imgui.pop_style_var()
        dock = imgui.get_id("dock")
        if imgui.internal.dock_builder_get_node(dock) is None:
            self._arrange(dock, width, height, PANEL_WIDTH * workspace.text_scale)
        elif self._scale is not None and workspace.text_scale != self._scale:
            self._stretch(workspace.text_scale / self._scale, (0.5 * width, 0.5 * height))
        self._scale = workspace.text_scale
        imgui.push_style_var(imgui.StyleVar_.frame_padding, imgui.ImVec2(TAB_PAD, imgui.get_style().frame_padding.y))
        imgui.dock_space(dock, imgui.ImVec2(0.0, 0.0), imgui.DockNodeFlags_.passthru_central_node)
        imgui.pop_style_var()
        imgui.end()
        node = imgui.internal.dock_builder_get_central_node(dock)
        if node is None:
            return int(left), int(top), int(width), int(height)
        return int(node.pos.x), int(node.pos.y), max(int(node.size.x), 1), max(int(node.size.y), 1)

    def _stretch(self, factor: float, most: tuple[float, float]) -> None:
        """Make room for text that is `factor` times as large: panels become so many times as wide and high, up to
        `most` pixels."""
        nodes = {}
        for panel in self.panels.values():
            window = imgui.internal.find_window_by_name(_window_title(panel))
            node = window.dock_node if window is not None else None
            if node is not None:
                nodes[node.id_] = node
        for node in nodes.values():
            size = zip((node.size.x, node.size.y), most, strict=True)
            node.size_ref = imgui.ImVec2(*(min(factor * now, max(limit, now)) for now, limit in size))

    def _arrange(self, dock: int, width: float, height: float, panel_width: float) -> None:
        """Where panels are docked at first."""
        self._settling = SETTLING
        builder = imgui.internal
        builder.dock_builder_remove_node(dock)
        builder.dock_builder_add_node(dock, imgui.internal.DockNodeFlagsPrivate_.dock_space)
        builder.dock_builder_set_node_size(dock, imgui.ImVec2(width, height))
        share = min(max(panel_width / width, WIDE_SHARE), 0.5)
        right = builder.dock_builder_split_node(dock, imgui.Dir.right, share)
        share = min(max(LOW_SHARE, LOW_HEIGHT * panel_width / PANEL_WIDTH / height), 0.5)
        below = builder.dock_builder_split_node(right.id_at_opposite_dir, imgui.Dir.down, share)
        for panel in self.panels.values():
            node = below.id_at_dir if panel.side == "bottom" else right.id_at_dir
            builder.dock_builder_dock_window(_window_title(panel), node)
        builder.dock_builder_finish(dock)


def first_panels(panels: dict[str, Panel], size: Size) -> set[str]:
    """The panels that are open at first in a window of `size` pixels."""
    return {panel.name for panel in panels.values() if panel.shown_at_first and size[0] >= NARROW}


def _without_crosses() -> imgui.WindowClass:
    """The cross at the end of the tabs closes the one in front; one in each tab would only take from their titles."""
    kind = imgui.WindowClass()
    kind.tab_item_flags_override_set = int(imgui.internal.TabItemFlagsPrivate_.no_close_button)
    return kind


def _window_title(panel: Panel) -> str:
    return f"{panel.icon} {panel.title}###panel {panel.name}"


def _fixed(name: str, x: float, y: float, width: float, height: float) -> None:
    imgui.set_next_window_pos(imgui.ImVec2(x, y))
    imgui.set_next_window_size(imgui.ImVec2(width, height))
    imgui.push_style_var(imgui.StyleVar_.window_rounding, 0.0)
    imgui.push_style_var(imgui.StyleVar_.window_padding, imgui.ImVec2(6.0, 6.0))
    imgui.push_style_var(imgui.StyleVar_.window_min_size, imgui.ImVec2(1.0, 1.0))
    imgui.begin(name, None, FIXED)
    imgui.pop_style_var(3)

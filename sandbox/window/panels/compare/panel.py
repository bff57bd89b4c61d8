"""A recording beside what the window computes: where they part, and every number that shows it."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.window.compare import compare_with_file, go_to_difference, recordings_near, show_body
from sandbox.window.comparer import Comparer
from sandbox.window.gui_style import palette_of
from sandbox.window.panels.compare.figures import draw_checkpoints, draw_fields, draw_groups
from sandbox.window.panels.panel import Panel
from sandbox.window.widgets import button, checkbox, mark, progress_bar, section, wrapped
from sandbox.window.workspace import Workspace

MOST_ROWS = 8
NONE = (
    "Nothing is compared. Open a recording (sandbox run NAME.replay.json), or choose one below to hold what you did "
    "against it."
)
WITHOUT_RUN = "The recorded run cannot be had again here: its fingerprints and figures can, and where it ended."
WITH_RUN = "The outlines are the expected run, wherever it is not where the bodies are."


class ComparePanel(Panel):
    """The replay viewer."""

    name = "compare"
    title = "Compare"
    icon = icons.ICON_FA_CODE_COMPARE
    help = "A recording held against what the window computes: the first difference, and its ghost."
    key = "F11"

    def draw(self, workspace: Workspace) -> None:
        """The verdict, then this step, then the whole run."""
        comparer = workspace.comparer
        if comparer is None:
            wrapped(NONE)
        else:
            _draw_verdict(workspace, comparer)
            if section("This step"):
                draw_groups(workspace, comparer)
                _draw_ghost(comparer)
                draw_fields(workspace, comparer)
            if comparer.comparison is not None and comparer.comparison.divergence is not None:
                _draw_farthest(workspace, comparer)
            if section("Figures on the way"):
                draw_checkpoints(workspace, comparer)
        if section("Compare with"):
            _draw_files(workspace)


def _draw_verdict(workspace: Workspace, comparer: Comparer) -> None:
    found, colors = comparer.comparison, palette_of(workspace.theme)
    parted = found.divergence if found is not None else None
    same = found is not None and parted is None
    icon = icons.ICON_FA_CIRCLE_CHECK if same else icons.ICON_FA_CIRCLE_EXCLAMATION
    if found is None and not comparer.trouble:
        progress = comparer.job.progress
        wrapped(f"running it again: step {progress.done:,} of {progress.total:,}")
        progress_bar("compare.progress", progress.share)
        return
    title = comparer.title()
    imgui.push_style_color(imgui.Col_.text, imgui.ImVec4(*(colors.second if same else colors.accent), 1.0))
    imgui.push_text_wrap_pos(0.0)
    imgui.text_unformatted(f"{icon}  {title[:1].upper()}{title[1:]}")
    imgui.pop_text_wrap_pos()
    imgui.pop_style_color()
    mark("compare.verdict")
    if parted is not None:
        if button("compare.go", f"{icons.ICON_FA_LOCATION_CROSSHAIRS}  Go there", "To the first step that differs."):
            go_to_difference(workspace)
        imgui.push_text_wrap_pos(0.0)
        for line in found.where() if found is not None else ():
            imgui.text_unformatted(line)
        imgui.pop_text_wrap_pos()
    for line in found.lines() if found is not None else ():
        wrapped(line.strip())
    own = comparer.own_acts_from(workspace.session)
    if own is not None:
        imgui.push_style_color(imgui.Col_.text, imgui.ImVec4(*colors.second, 1.0))
        imgui.push_text_wrap_pos(0.0)
        imgui.text_unformatted(f"From step {own:,} on you do something else: what differs there is your doing.")
        imgui.pop_text_wrap_pos()
        imgui.pop_style_color()


def _draw_ghost(comparer: Comparer) -> None:
    tip = WITH_RUN if comparer.ghost is not None else WITHOUT_RUN
    comparer.ghost_shown = checkbox("compare.ghost", "Ghost of what is expected", comparer.ghost_shown, tip)
    if comparer.ghost is None and comparer.comparison is not None:
        wrapped(WITHOUT_RUN)
    elif comparer.ghost is not None and comparer.ghost.trouble:
        wrapped(f"the expected run ends here: {comparer.ghost.trouble}")


def _draw_farthest(workspace: Workspace, comparer: Comparer) -> None:
    """The bodies that end farthest off; a click shows one."""
    drifts = comparer.comparison.drifts if comparer.comparison is not None else ()
    if not drifts or not section("Farthest off at the end"):
        return
    for drift in drifts[:MOST_ROWS]:
        there = drift.expected is not None and drift.got is not None
        told = f"{drift.distance:.3g} m, {drift.turn:.2g} rad" if there else "not in both"
        clicked, _ = imgui.selectable(f"{drift.body}##drift", drift.body in workspace.selection.bodies)
        mark(f"compare.body.{drift.body}", "Select it, and look at it.")
        if clicked:
            show_body(workspace, drift.body)
        imgui.same_line(imgui.get_content_region_avail().x - imgui.calc_text_size(told).x)
        imgui.text_disabled(told)


def _draw_files(workspace: Workspace) -> None:
    paths = recordings_near(workspace)
    if not paths:
        wrapped("There are no other recordings in this folder.")
    for path in paths:
        if button(f"compare.with.{path.name}", path.name, f"{path}\nWhat it did becomes the ghost."):
            compare_with_file(workspace, path)

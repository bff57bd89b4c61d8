"""The numbers of the comparison: fingerprints of a step, the fields of a body, figures on the way."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.replay.comparison import FieldRow, field_rows
from sandbox.replay.recording.checkpoint import Checkpoint
from sandbox.replay.recording.fingerprint import GROUPS
from sandbox.window.comparer import Comparer
from sandbox.window.gui_style import palette_of
from sandbox.window.tooltip import tooltip
from sandbox.window.widgets import wrapped
from sandbox.window.workspace import Workspace

MEANINGS = {
    "pairs": "Which shapes are near each other.",
    "manifolds": "How they touch: normals, points, separations.",
    "impulses": "What contacts, joints and hands exert.",
    "poses": "Where bodies are, and how they move.",
}
LABELS = {
    "position_x": "x",
    "position_y": "y",
    "velocity_x": "speed x",
    "velocity_y": "speed y",
    "angular_velocity": "spin",
}
COLUMNS = {
    "energy": ("energy", "J", 1.0), "contacts": ("contacts", "touching", 1.0), "awake": ("awake", "bodies", 1.0),
    "deepest": ("mm deep", "mm of overlap", 1000.0),
}  # fmt: skip
"""Figures of a checkpoint: the heading, in what they are, and how many of that one is."""
LOOK = imgui.TableFlags_.borders_inner_h | imgui.TableFlags_.row_bg
TABLE = LOOK | imgui.TableFlags_.sizing_stretch_prop
SCROLLED = LOOK | imgui.TableFlags_.sizing_stretch_same | imgui.TableFlags_.scroll_y


def draw_groups(workspace: Workspace, comparer: Comparer) -> None:
    """The fingerprints of the step that is shown, recorded and here, group by group."""
    timeline, digests = workspace.session.timeline, comparer.against.digests
    step = timeline.step_count
    expected = digests[step - 1].split(" ") if 0 < step <= len(digests) else []
    known = timeline.tape.digest(step)
    if not expected or known is None:
        wrapped("The start has no fingerprint." if step == 0 else f"The recording ends at step {len(digests):,}.")
        return
    if not imgui.begin_table("##groups", 3, TABLE):
        return
    _head(f"step {step:,}", "expected", "here")
    for group, old, new in zip(GROUPS, expected, known.split(" "), strict=True):
        imgui.table_next_row()
        _cell(group)
        if imgui.is_item_hovered():
            tooltip(MEANINGS[group])
        _cell(old)
        _cell(new, workspace if old != new else None)
    imgui.end_table()


def draw_fields(workspace: Workspace, comparer: Comparer) -> None:
    """The selected body in both runs."""
    moment, world = comparer.moment(workspace.session), workspace.session.world
    found = comparer.comparison
    name = next(iter(workspace.selection.bodies), found.body if found is not None else None)
    if comparer.ghost is None or name is None:
        if comparer.ghost is not None:
            wrapped("Select a body to see its fields side by side.")
        return
    if moment is None:
        past = workspace.session.timeline.step_count > comparer.ghost.length
        wrapped("The expected run is over here." if past else "The expected run is on its way here.")
        return
    bodies = world.state.bodies
    here = bodies[world.names.index(name)] if name in world.names else None
    rows = field_rows(moment.record(name), here)
    if not imgui.begin_table("##fields", 4, TABLE):
        return
    for weight in (1.25, 1.0, 1.0, 0.9):
        imgui.table_setup_column("", imgui.TableColumnFlags_.width_stretch, weight)
    _head(name if len(name) < 12 else f"{name[:11]}…", "expected", "here", "off by")
    for row in rows:
        imgui.table_next_row()
        _cell(LABELS.get(row.field, row.field.replace("_", " ")))
        if imgui.is_item_hovered():
            tooltip(f"{row.field}, {row.unit}: {row.help}")
        for value in (row.expected, row.got):
            _cell("-" if value is None else f"{value:.4g}")
            if imgui.is_item_hovered() and value is not None:
                tooltip(f"{value!r} {row.unit}")
        _cell(_difference(row), workspace if row.ulps else None)
        if imgui.is_item_hovered() and row.ulps:
            tooltip(f"{row.difference!r} {row.unit}, {row.ulps:,} floats apart")
    imgui.end_table()


def draw_checkpoints(workspace: Workspace, comparer: Comparer) -> None:
    """Energy, contacts and so on as recorded; where the window has other ones, these in colour."""
    here = {row.step: row for row in workspace.session.timeline.tape.checkpoints}
    if not imgui.begin_table("##checkpoints", 5, SCROLLED, imgui.ImVec2(0.0, 150.0)):
        return
    imgui.table_setup_scroll_freeze(0, 1)
    _head("step", *(heading for heading, _, _ in COLUMNS.values()))
    for row in comparer.against.checkpoints:
        _checkpoint(workspace, row, here.get(row.step))
    imgui.end_table()


def _checkpoint(workspace: Workspace, recorded: Checkpoint, here: Checkpoint | None) -> None:
    imgui.table_next_row()
    imgui.table_next_column()
    if imgui.selectable(f"{recorded.step:,}##checkpoint", False, imgui.SelectableFlags_.span_all_columns)[0]:
        workspace.session.clock.paused = True
        workspace.session.seek(recorded.step)
    for name, (_, unit, times) in COLUMNS.items():
        old, new = (times * getattr(one, name) if one is not None else None for one in (recorded, here))
        differs = new is not None and new != old
        _cell(f"{new if differs else old:{'.3g' if times > 1.0 else '.4g'}}", workspace if differs else None)
        if differs and imgui.is_item_hovered():
            tooltip(f"recorded {old:.6g}, here {new:.6g} ({unit})")


def _difference(row: FieldRow) -> str:
    if row.difference is None:
        return "only in one"
    return f"{row.difference:+.2g}" if row.ulps else "="


def _head(*titles: str) -> None:
    imgui.table_next_row(imgui.TableRowFlags_.headers)
    for title in titles:
        imgui.table_next_column()
        imgui.text_disabled(title)


def _cell(text: str, colored: Workspace | None = None) -> None:
    """A cell; in colour, for that theme, where it differs."""
    imgui.table_next_column()
    if colored is None:
        imgui.text_unformatted(text)
        return
    imgui.text_colored(imgui.ImVec4(*palette_of(colored.theme).accent, 1.0), text)

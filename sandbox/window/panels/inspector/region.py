"""The selected region: what field it is, how strong, and whether it acts."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.delete import DeleteRegion
from sandbox.engine.commands.set_region import SetRegion
from sandbox.scene.regions import REGIONS
from sandbox.window.editor import Editor, Entry
from sandbox.window.widgets import Scale, button, row, section
from sandbox.window.workspace import Workspace
from sandbox.world.region_columns import columns_of

_SPEED, _LENGTH = Scale("m/s", 0.02, digits=5), Scale("m", 0.01, digits=5)
_SCALES = {
    "water": Scale("kg/m²", 0.01, 0.0, 1e9, 5), "surface": _LENGTH, "drag": Scale("", 0.01, 0.0, 1e4),
    "angular_drag": Scale("1/s", 0.01, 0.0, 1e4), "flow": _SPEED, "gravity": Scale("m/s²", 0.05, digits=5),
    "gravity_scale": Scale("", 0.01), "attraction": Scale("m/s²", 0.05, digits=5), "at": _LENGTH,
    "falloff": Scale("", 0.02, 0.0, 3.0), "core": _LENGTH, "range": _LENGTH, "wind": _SPEED,
    "density": Scale("kg/m²", 0.01, 0.0, 1e9, 5),
}  # fmt: skip
USUAL_RANGE = 10.0
_ENABLED = Entry("inspector.region.enabled", "on", tip="Whether it acts now, whatever its schedule was.")


def draw_region(workspace: Workspace, editor: Editor, name: str) -> None:
    """All of one region."""
    world = workspace.session.world
    number = world.directory.region(name)
    record: Any = world.state.regions[number]
    fields = columns_of(record)
    kind = next(iter(fields))
    editor.of = name
    if not section("Region"):
        return
    row("kind", kind.replace("_", " "))
    row("area", _area(workspace, record))
    acts = bool(record.start_step <= world.step_count < record.end_step)
    editor.switch(workspace, _ENABLED, acts, lambda on: [SetRegion(name, enabled=on)])
    for field, columns in fields.items():
        entry = Entry(f"inspector.region.{field}", field.replace("_", " "), _SCALES[field], _tip(kind, field))
        _draw_field(workspace, editor, entry, (name, field, _values(workspace, record, columns)))
    if button("inspector.region.delete", "Delete", "Takes it out of the world."):
        workspace.do(f"Delete {name}", DeleteRegion(name))


def _draw_field(workspace: Workspace, editor: Editor, entry: Entry, what: tuple[str, str, tuple[float, ...]]) -> None:
    name, field, values = what

    def change(value: Any) -> Iterable[Command]:
        return [SetRegion(name, **{field: round(value) if field == "falloff" else value})]

    if len(values) == 2:
        editor.pair(workspace, entry, [(values[0], values[1])], change)
    else:
        editor.ceiling(workspace, entry, values[0], USUAL_RANGE, change)


def _values(workspace: Workspace, record: Any, columns: tuple[str, ...]) -> tuple[float, ...]:
    """What a field is now; a surface is the last edge of the water."""
    if columns:
        return tuple(float(record[column]) for column in columns)
    return (float(workspace.session.world.state.edges[record.first_edge + record.edge_count - 1].offset),)


def _area(workspace: Workspace, record: Any) -> str:
    if record.disc_radius:
        return f"disc at {record.disc_x:.4g}, {record.disc_y:.4g} m, radius {record.disc_radius:.4g} m"
    return f"convex, {int(record.edge_count)} sides" if record.edge_count else "everywhere"


def _tip(kind: str, field: str) -> str:
    return str(REGIONS[kind].model_fields[field].description or "")

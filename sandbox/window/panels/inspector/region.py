"""The selected region: what field it is, how strong, and whether it acts."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.delete import DeleteRegion
from sandbox.engine.commands.set_region import SetRegion
from sandbox.scene.regions import REGIONS
from sandbox.window.editor import Editor, Entry, Vec
from sandbox.window.widgets import Scale, button, row, section
from sandbox.window.workspace import Workspace
from sandbox.world.region_area import box_of, disc_of, level_of, side_count
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
LEAST_SIZE = 0.01
"""Metres to which a drag of a number makes an area at least."""
SHAPED = "Its corners are dragged in the scene; a small dot becomes a corner; Ctrl and a click takes one away."
_CORNER = Entry("inspector.region.corner", "lower left", _LENGTH, "The lower left corner of its box.")
_SIZE = Entry("inspector.region.size", "size", _LENGTH, "Width and height of its box.")
_CENTER = Entry("inspector.region.center", "centre", _LENGTH, "The centre of its disc.")
_RADIUS = Entry("inspector.region.radius", "radius", _LENGTH, "The radius of its disc.")
_ENABLED = Entry("inspector.region.enabled", "on", tip="Whether it acts now, whatever its schedule was.")


def draw_region(workspace: Workspace, editor: Editor, name: str) -> None:
    """All of one region."""
    world = workspace.session.world
    number = world.directory.region(name)
    record: Any = world.state.regions[number]
    fields = columns_of(record)
    kind = next(iter(fields))
    editor.of = workspace.selection.region_title
    if not section("Region"):
        return
    row("kind", kind.replace("_", " "))
    _draw_area(workspace, editor, name, number)
    acts = bool(record.start_step <= world.step_count < record.end_step)
    editor.switch(workspace, _ENABLED, acts, lambda on: [SetRegion(name, enabled=on)])
    for field, columns in fields.items():
        if not columns and not world.state.census.regions.items[number].surfaced:
            continue  # the area is full
        entry = Entry(f"inspector.region.{field}", field.replace("_", " "), _SCALES[field], _tip(kind, field))
        _draw_field(workspace, editor, entry, (name, field, _values(workspace, name, record, columns)))
    if button("inspector.region.delete", "Delete", "Takes it out of the world."):
        workspace.do(f"Delete {editor.of}", DeleteRegion(name))


def _draw_field(workspace: Workspace, editor: Editor, entry: Entry, what: tuple[str, str, tuple[float, ...]]) -> None:
    name, field, values = what

    def change(value: Any) -> Iterable[Command]:
        return [SetRegion(name, **{field: round(value) if field == "falloff" else value})]

    if len(values) == 2:
        editor.pair(workspace, entry, [(values[0], values[1])], change)
    elif field in SetRegion.UNLIMITED:
        editor.ceiling(workspace, entry, values[0], USUAL_RANGE, change)
    else:
        editor.number(workspace, entry, [values[0]], change)


def _values(workspace: Workspace, name: str, record: Any, columns: tuple[str, ...]) -> tuple[float, ...]:
    """What a field is now: a surface has no column."""
    if columns:
        return tuple(float(record[column]) for column in columns)
    return (level_of(workspace.session.world.state, workspace.session.world.directory.region(name)),)


def _draw_area(workspace: Workspace, editor: Editor, name: str, number: int) -> None:
    """Where it is: a box by its lower left corner and its size, a disc by its centre and radius."""
    state = workspace.session.world.state
    box, disc, sides = box_of(state, number), disc_of(state, number), side_count(state, number)

    def put(corner: Vec, size: Vec) -> Iterable[Command]:
        wide, high = (max(side, LEAST_SIZE) for side in size)
        return [SetRegion(name, inside=(*corner, corner[0] + wide, corner[1] + high))]

    if box is not None:
        corner, size = (box[0], box[1]), (box[2] - box[0], box[3] - box[1])
        editor.pair(workspace, _CORNER, [corner], lambda corner: put(corner, size))
        editor.pair(workspace, _SIZE, [size], lambda size: put(corner, size))
    elif sides:
        row("area", f"convex, {sides} sides", SHAPED)
    if disc is not None:
        x, y, radius = disc
        editor.pair(workspace, _CENTER, [(x, y)], lambda center: [SetRegion(name, disc=(*center, radius))])
        editor.number(
            workspace, _RADIUS, [radius], lambda value: [SetRegion(name, disc=(x, y, max(value, LEAST_SIZE)))]
        )
    elif not sides:
        row("area", "everywhere")


def _tip(kind: str, field: str) -> str:
    return str(REGIONS[kind].model_fields[field].description or "")

"""The shapes of the selected bodies: how large they are, what they are made of, what they collide with."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.set_surface import SetSurface
from sandbox.scene.limits import ALL_BITS
from sandbox.tables import plain
from sandbox.window.editor import Editor, Entry
from sandbox.window.widgets import Scale, integer, label, row
from sandbox.window.workspace import Workspace
from sandbox.world.records import BOX, CAPSULE, CIRCLE, DYNAMIC, SEGMENT
from sandbox.world.state import State

KINDS = ("circle", "box", "capsule", "segment", "polygon")
HIGHEST_BOUNCE = 5.0
_FIELDS = {
    "density": Entry("inspector.density", "density", Scale("kg/m²", 0.01, 1e-6, 1e9, 5), "Mass for each area."),
    "friction": Entry("inspector.friction", "friction", Scale("", 0.005, 0.0, 1e3), "A pair uses √(a b)."),
    "restitution": Entry("inspector.restitution", "restitution", Scale("", 0.005, 0.0, 1.0), "A pair uses max(a, b)."),
    "rolling_resistance": Entry(
        "inspector.rolling", "rolling res.", Scale("m", 0.001, 0.0, 1e9), "Lever arm of rolling friction."
    ),
    "surface_speed": Entry(
        "inspector.surface_speed", "surface speed", Scale("m/s", 0.01), "A conveyor: clockwise around the shape."
    ),
}


class Surfaces:
    """The part of the inspector for shapes; knows which shape of a body is looked at, 0 for all."""

    def __init__(self) -> None:
        self._of = ""
        self._chosen = 0

    def draw(self, workspace: Workspace, editor: Editor, names: Sequence[str], rows: Any) -> None:
        """The shapes of the bodies `names`, which lie in `rows` of the table."""
        state = workspace.session.world.state
        shapes = np.flatnonzero(np.isin(plain(state.shapes)["body"], rows))
        shape = self._choose(names, len(shapes)) if len(names) == 1 else None
        if shape is not None:
            shapes = shapes[shape : shape + 1]
        if len(shapes) == 1:
            row("shape", f"{size_text(state, int(shapes[0]))}")
        _draw_surface(workspace, editor, names, (shapes, shape))
        if len(shapes):
            row("collides", filter_text(state.shapes[shapes]), "Categories and masks of shapes, and their groups.")

    def _choose(self, names: Sequence[str], count: int) -> int | None:
        """The number of a shape; None for all, as long as there is one only."""
        if names[0] != self._of:
            self._of, self._chosen = names[0], 0
        if count < 2:
            return None
        tip = f"Drag: all shapes, or one of 1 to {count}."
        shown = f"%d of {count}" if self._chosen else f"all {count}"
        label("shapes", tip)
        _, chosen = integer("inspector.shape", "", self._chosen, tip, limits=(0, count), shown=shown)
        self._chosen = min(max(chosen, 0), count)
        return self._chosen - 1 if self._chosen else None


def _draw_surface(workspace: Workspace, editor: Editor, names: Sequence[str], which: tuple[Any, int | None]) -> None:
    table, (shapes, shape) = plain(workspace.session.world.state.shapes), which
    bodies = plain(workspace.session.world.state.bodies)
    for field, entry in _FIELDS.items():
        values = table[field][shapes]
        if not len(values) or (field == "density" and (bodies["type"][table["body"][shapes]] != DYNAMIC).any()):
            continue
        if field == "restitution" and values.max() > 1.0:
            entry = Entry(entry.name, entry.title, Scale("", 0.005, 0.0, HIGHEST_BOUNCE), entry.tip)

        def change(value: float, field: str = field) -> Iterable[Command]:
            bumper = True if field == "restitution" and value > 1.0 else None
            given: dict[str, Any] = {field: value, "shape": shape, "bumper": bumper}
            return [SetSurface(name, **given) for name in names]

        editor.number(workspace, entry, values, change)


def size_text(state: State, number: int) -> str:
    """A shape's kind and size in words."""
    shape = state.shapes[number]
    first, count, radius = int(shape.vertex_start), int(shape.vertex_count), float(shape.radius)
    core: Any = state.vertices[first : first + count]
    x, y = core.x.tolist(), core.y.tolist()
    sides = [math.hypot(x[k] - x[k - 1], y[k] - y[k - 1]) for k in range(1, min(count, 3))]
    kind = int(shape.kind)
    rounded = f", rounded by {radius:.4g} m" if radius else ""
    if kind == CIRCLE:
        return f"circle, radius {radius:.4g} m"
    if kind == BOX:
        width, height = (side + 2.0 * radius for side in sides)
        return f"box, {width:.4g} × {height:.4g} m{rounded}"
    if kind == CAPSULE:
        return f"capsule, {sides[0]:.4g} m long, radius {radius:.4g} m"
    if kind == SEGMENT:
        link = f", link {int(shape.part)} of a chain" if shape.part else ""
        return f"segment, {sides[0]:.4g} m long{link}"
    part = f", part {int(shape.part)} of a concave one" if shape.part else ""
    return f"polygon, {count} corners{rounded}{part}"


def filter_text(shapes: Any) -> str:
    """What shapes collide with."""
    words = ["sensor, pushes nothing"] if (shapes.sensor == 1).all() else []
    if not shapes.mask.any() and not shapes.group.any():
        return "; ".join([*words, "with nothing"])
    for name, usual in (("category", 1), ("mask", ALL_BITS), ("group", 0)):
        values = sorted(set(shapes[name].tolist()))
        if values != [usual]:
            shown = ", ".join(f"{value:#x}" if name != "group" else f"{value}" for value in values[:3])
            words.append(f"{name} {shown}")
    return "; ".join(words) or "with all"

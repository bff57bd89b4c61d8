"""The bodies of a film: shapes and colour of each, as plain data that a canvas can draw."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from sandbox.render.body_colors import BodyColors
from sandbox.render.camera import Floats
from sandbox.render.frame import Frame
from sandbox.render.geometry import Mesh
from sandbox.render.theme import Color
from sandbox.world.records import DYNAMIC, SEGMENT, STATIC

Plain: TypeAlias = dict[str, Any]

FINENESS = 2048
"""Steps in which places are told, in half the width of a body: a box of a metre moves by a quarter of a millimetre."""


@dataclass(frozen=True)
class FilmBody:
    """A body as one sees it: `data` for the page; `quantum` (m) and `turn` (rad), the least moves that are told."""

    id: str
    data: Mapping[str, Any]
    quantum: float
    turn: float


def hex_of(color: Color | Floats) -> str:
    """`#rrggbb` of sRGB 0..1."""
    return "#" + "".join(f"{round(255 * float(part)):02x}" for part in color)


def film_bodies(frame: Frame, body_colors: BodyColors, wanted: Sequence[int]) -> list[FilmBody]:
    """The bodies in the `wanted` rows of a frame."""
    shapes: dict[int, list[int]] = {body: [] for body in wanted}
    for row in np.flatnonzero(np.isin(frame.mesh.body, wanted)).tolist():
        shapes[int(frame.mesh.body[row])].append(row)
    return [_film_body(frame, body_colors, body, rows) for body, rows in shapes.items()]


def _film_body(frame: Frame, body_colors: BodyColors, body: int, rows: list[int]) -> FilmBody:
    mesh, kind = frame.mesh, int(frame.type[body])
    name = frame.roster.names[body]
    data: Plain = {"id": name, "fill": hex_of(body_colors.base[body]), "shapes": [_shape(mesh, row) for row in rows]}
    data |= {"static": True} if kind == STATIC else {}
    data |= {"marked": True} if kind == DYNAMIC else {}
    thick = max((float(mesh.thickness[row]) for row in rows), default=0.0)
    reach = max((float(np.hypot(*mesh.offset[row]) + mesh.reach[row]) for row in rows), default=1.0)
    data |= {"half": _short(thick), "reach": _short(reach)}
    quantum = _short((thick or 0.1 * reach) / FINENESS)
    return FilmBody(name, data, quantum, _short(quantum / max(reach, 1e-9)))


def _shape(mesh: Mesh, row: int) -> Plain:
    """One shape in its body's frame: `rings` of corners [x, y, x, y, ...], or a `core` with a `radius` about it."""
    c, s = mesh.axis[row]
    turned = np.array([[c, s], [-s, c]])
    start, end = mesh.mark[row]
    data: Plain = {"mark": _numbers(np.array([[start, 0.0], [end, 0.0]]) @ turned + mesh.offset[row])}
    if row in mesh.outlines:
        data["rings"] = [_numbers(ring @ turned + mesh.offset[row]) for ring in _rings(mesh.outlines[row].sides)]
    else:
        data["core"] = _numbers(mesh.core(row) @ turned + mesh.offset[row])
        data["radius"] = _short(float(mesh.radius[row]))
    data |= {"sensor": True} if mesh.sensor[row] else {}
    return data | ({"line": True} if mesh.kind[row] == SEGMENT else {})


def _rings(sides: Floats) -> list[Floats]:
    """The corners of each closed ring of sides (k, 2, 2)."""
    ends = [k for k in range(len(sides)) if k + 1 == len(sides) or (sides[k, 1] != sides[k + 1, 0]).any()]
    return [sides[first : last + 1, 0] for first, last in zip([0, *(end + 1 for end in ends)], ends, strict=False)]


def _numbers(points: Floats) -> list[float]:
    return [_short(value) for value in points.ravel().tolist()]


def _short(value: float) -> float:
    return float(f"{value:.6g}")

"""The contact points of the last step, where the bodies of the frame are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.world import World
from sandbox.render.camera import Camera, Floats
from sandbox.render.frame import Frame
from sandbox.render.geometry import Ints
from sandbox.tables import plain

_MARGIN = 40.0
"""Pixels beside the picture up to which a point counts as in sight."""


@dataclass(frozen=True)
class ContactPoints:
    """One row a point.

    `contact` row of its contact; `pixel` (p, 2); `normal` (p, 2) on screen, y down, from body a to body b; `friction`
    (p,); `separation` (p,) in metres when the step began; `feature` (p,); `pushing` and `sliding` (p,) Newtons, mean
    over the last substep; `touching` (p,); `bodies` (p, 2) rows.
    """

    contact: Ints
    pixel: Floats
    normal: Floats
    friction: Floats
    separation: Floats
    feature: Ints
    pushing: Floats
    sliding: Floats
    touching: NDArray[np.bool_]
    bodies: Ints

    def __len__(self) -> int:
        return len(self.contact)


def read_contact_points(world: World, frame: Frame, camera: Camera) -> ContactPoints:
    """The points in sight, in the order of the contacts."""
    contacts: Any = plain(world.contacts)
    first = _in_sight(contacts, 1, np.arange(len(contacts)), frame, camera)
    second = _in_sight(contacts, 2, np.flatnonzero(contacts["point_count"] == 2), frame, camera)
    rows, which = np.concatenate([first, second]), np.repeat([1, 2], [len(first), len(second)])
    order = np.lexsort((which, rows))
    rows, which = rows[order], which[order]
    chosen = contacts[rows]

    def column(name: str) -> Any:
        return np.where(which == 1, chosen[f"{name}1"], chosen[f"{name}2"])

    setting = world.state.settings[0]
    seconds = float(setting.step_seconds) / int(setting.substeps)
    return ContactPoints(
        contact=rows,
        pixel=camera.to_screen(_places(chosen, column, frame)),
        normal=np.column_stack([chosen["normal_x"], -chosen["normal_y"]]),
        friction=chosen["friction"],
        separation=column("separation"),
        feature=column("feature"),
        pushing=column("normal_impulse") / seconds,
        sliding=column("tangent_impulse") / seconds,
        touching=chosen["touching"] == 1,
        bodies=np.column_stack([chosen["body_a"], chosen["body_b"]]),
    )


def _in_sight(contacts: Any, k: int, rows: Ints, frame: Frame, camera: Camera) -> Ints:
    chosen = contacts[rows]
    pixels = camera.to_screen(_places(chosen, lambda name: chosen[f"{name}{k}"], frame))
    inside = ((pixels >= -_MARGIN) & (pixels <= np.asarray(camera.size) + _MARGIN)).all(axis=1)
    seen: Ints = rows[inside]
    return seen


def _places(chosen: Any, column: Any, frame: Frame) -> Floats:
    """Half way between where the point is on both bodies now (m)."""
    a = frame.center[chosen["body_a"]] + np.column_stack([column("anchor_ax"), column("anchor_ay")])
    b = frame.center[chosen["body_b"]] + np.column_stack([column("anchor_bx"), column("anchor_by")])
    middle: Floats = 0.5 * (a + b)
    return middle

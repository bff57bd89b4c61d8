"""The frames of joints, and the force and torque that each gives."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.render.camera import Floats
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.render.overlays.scale import amount, lengths, reach, round_scale
from sandbox.tables import plain

AXIS_METRES, AXIS_PIXELS = 0.3, (5.0, 14.0)
"""Length of the axes of a joint frame, and within what it is kept on screen."""


def _draw(look: Look) -> Marks:
    pen, color = Pen(look), look.palette
    marks, table = look.frame.joints, plain(look.world.state.joints)
    held: Any = table[(table["enabled"] == 1) & (table["broken_step"] < 0)]
    if len(held) != len(marks) or len(marks) == 0:
        return pen.marks()
    a, b = look.camera.to_screen(marks.a), look.camera.to_screen(marks.b)
    seen = look.visible(a) | look.visible(b)
    held, a, b = held[seen], a[seen], b[seen]
    pen.lines(a, b, 1.2, color.quiet, halo=True)
    for at, body in ((a, held["body_a"]), (b, held["body_b"])):
        _frames(look, pen, at, body)
    force = np.column_stack([held["force_x"], -held["force_y"]])
    size = np.hypot(*force.T)
    scale, pixels = round_scale(size), reach(look)
    unit = force / np.maximum(size, 1e-300)[:, None]
    pen.arrows(b, lengths(size, scale, pixels)[:, None] * unit, 2.0, color.orange)
    for row in np.flatnonzero((size > 0.0) | (held["torque"] != 0.0)).tolist():
        pen.label(_load(float(size[row]), float(held["torque"][row])), b[row], color.text, 9.0, float(size[row]))
    pen.legend(color.orange, f"force on b, {amount(scale, 'N')}", pixels)
    pen.legend(color.red, "x axis of a joint frame")
    pen.legend(color.green, "y axis")
    return pen.marks()


def _frames(look: Look, pen: Pen, at: Floats, body: Any) -> None:
    """The axes of the body that an anchor is on; those of the world where it is on the world."""
    least, most = (look.mark_scale * pixels for pixels in AXIS_PIXELS)
    length = float(np.clip(AXIS_METRES * look.camera.scale, least, most))
    turn = np.vstack([look.frame.rotation, [[1.0, 0.0]]])[body] * (1.0, -1.0)
    for axis, ink in ((turn, pen.palette.red), (np.column_stack([turn[:, 1], -turn[:, 0]]), pen.palette.green)):
        pen.lines(at, at + length * axis, 1.4, ink, halo=True)
    pen.dots(at, 2.4, pen.palette.text)


def _load(force: float, torque: float) -> str:
    """Force and torque in words; a torque that comes of rounding is left out."""
    words = amount(force, "N")
    return f"{words}, {amount(torque, 'N m')}" if abs(torque) > 1e-6 * max(force, 1.0) else words


OVERLAY = Overlay("joints", "Joint frames", "Joint frames, and force and torque of each joint with numbers.", _draw)

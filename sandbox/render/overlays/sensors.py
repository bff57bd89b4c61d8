"""Sensors, and what each of them has in it."""

from __future__ import annotations

import numpy as np

from sandbox.render.marks import Marks
from sandbox.render.number_text import counted
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen, box_corners
from sandbox.tables import plain


def _draw(look: Look) -> Marks:
    pen, color, frame = Pen(look), look.palette, look.frame
    shapes = plain(look.world.state.shapes)
    rows = np.flatnonzero((shapes["sensor"] == 1) & look.visible_boxes(look.shape_boxes))
    sensed = [[look.world.directory.body(name) for name in pair] for pair in look.world.sensed]
    pairs = np.array(sensed, dtype=np.int64).reshape(-1, 2)
    boxes = look.shape_boxes[rows]
    low, high = look.camera.to_screen(boxes[:, :2]), look.camera.to_screen(boxes[:, 2:])
    busy = np.isin(shapes["body"][rows], pairs[:, 0])
    inks = np.where(busy[:, None], color.green, color.quiet)
    pen.fill(box_corners(low, high), inks, np.where(busy, 0.14, 0.06))
    pen.boxes(low, high, 1.5, inks)
    for body, at in zip(shapes["body"][rows].tolist(), (0.5 * (low + high)).tolist(), strict=True):
        inside = int((pairs[:, 0] == body).sum())
        pen.words(f"{look.world.names[body]}: {inside}", at, color.text, rank=1.0 + inside)
    amount = np.zeros(len(frame.type))
    amount[pairs[:, 1]] = 0.85
    pen.tint(np.broadcast_to(np.array(color.green), (len(amount), 3)), amount)
    pen.legend(color.green, f"sensors with something in them, and what that is: {counted(len(pairs), 'pair')}")
    pen.legend(color.quiet, "sensors with nothing in them")
    return pen.marks(calm=False)


OVERLAY = Overlay("sensors", "Sensors", "Sensors and the bodies that are in them.", _draw)

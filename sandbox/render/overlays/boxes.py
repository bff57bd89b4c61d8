"""The axis-aligned box of every shape, and the wider one by which the broad phase chose its pairs."""

from __future__ import annotations

import numpy as np

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.memory import step_boxes
from sandbox.render.overlays.pen import Pen

LEAST_PIXELS = 3.0
"""Smaller boxes are not drawn, and wide ones only where they are wider by a pixel and a half."""


def _draw(look: Look) -> Marks:
    pen, color = Pen(look), look.palette
    tight = look.shape_boxes
    wide, trusted = step_boxes(look)
    scale = look.camera.scale
    large = (tight[:, 2:] - tight[:, :2]).max(axis=1) * scale > LEAST_PIXELS
    seen = look.visible_boxes(tight) & large
    wider = np.abs(wide - tight).max(axis=1) * scale > 1.5
    far = seen & trusted & wider
    for boxes, rows, ink, width, opacity in ((wide, far, color.orange, 1.0, 0.8), (tight, seen, color.blue, 1.25, 1.0)):
        low, high = look.camera.to_screen(boxes[rows, :2]), look.camera.to_screen(boxes[rows, 2:])
        pen.boxes(low, high, width, ink, opacity)
    pen.legend(color.blue, "box of a shape")
    if far.any():
        pen.legend(color.orange, "with margin and the way of a step")
    return pen.marks()


OVERLAY = Overlay(
    "boxes", "Bounding boxes", "The box of each shape, and the wider one by which pairs are chosen.", _draw
)

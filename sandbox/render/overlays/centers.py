"""Where the centres of mass are."""

from __future__ import annotations

import numpy as np

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.tables import plain

ARM, ARM_PIXELS = 0.5, (4.0, 16.0)
"""Length of the axes as a share of the body's extent, and within what it is kept on screen."""


def _draw(look: Look) -> Marks:
    pen, color = Pen(look), look.palette
    rows = look.visible_bodies()
    at = look.camera.to_screen(look.frame.center[rows])
    if len(rows) > 2000:
        pen.dots(at, 1.6, color.yellow)
    else:
        extent = plain(look.world.state.bodies)["extent"][rows]
        least, most = (look.mark_scale * pixels for pixels in ARM_PIXELS)
        length = np.clip(ARM * extent * look.camera.scale, least, most)[:, None]
        turn = look.frame.rotation[rows] * (1.0, -1.0)
        for axis, ink in ((turn, color.red), (np.column_stack([turn[:, 1], -turn[:, 0]]), color.green)):
            pen.lines(at, at + length * axis, 1.6, ink, halo=True)
        pen.dots(at, 2.6, color.yellow)
        pen.legend(color.red, "x axis of the body")
        pen.legend(color.green, "y axis of the body")
    pen.legend(color.yellow, "centre of mass")
    return pen.marks()


OVERLAY = Overlay("centers", "Centres of mass", "Centre of mass of each body that moves, with the body's axes.", _draw)

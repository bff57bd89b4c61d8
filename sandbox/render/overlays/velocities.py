"""How fast the bodies are, as arrows from their centres of mass."""

from __future__ import annotations

import numpy as np

from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.render.overlays.scale import LONGEST, amount, lengths, reach, round_scale
from sandbox.tables import plain


def _draw(look: Look) -> Marks:
    pen, color = Pen(look), look.palette
    bodies = plain(look.world.state.bodies)
    every = np.column_stack([bodies["velocity_x"], bodies["velocity_y"]])
    rows = look.visible_bodies()
    speed = np.hypot(*every[rows].T)
    scale, pixels = round_scale(speed), reach(look)
    length = lengths(speed, scale, pixels)
    unit = every[rows] / np.maximum(speed, 1e-300)[:, None] * (1.0, -1.0)
    at = look.camera.to_screen(look.frame.center[rows])
    pen.arrows(at, length[:, None] * unit, 1.8, color.green)
    moving = length > 1.0
    pen.dots(at[moving], 2.0, color.green)
    pen.legend(color.green, f"velocity, {amount(scale, 'm/s')}", pixels)
    if (speed > LONGEST * scale).any():
        fastest = amount(float(speed.max()), "m/s")
        pen.legend(color.quiet, f"cut at {amount(LONGEST * scale, 'm/s')}; fastest {fastest}")
    return pen.marks()


OVERLAY = Overlay("velocities", "Velocities", "Velocity of each body as an arrow to scale.", _draw)

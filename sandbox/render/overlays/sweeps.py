"""Continuous collision: the bodies that were swept along their way in the last step, and where they were stopped."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.render.camera import Floats
from sandbox.render.contour import contour
from sandbox.render.geometry import Ints
from sandbox.render.marks import Marks
from sandbox.render.number_text import counted
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.tables import plain

NORMAL_PIXELS = 24.0
_MOST_GHOSTS = 200
"""Ghosts of more shapes would be fog."""


def _draw(look: Look) -> Marks:
    pen, color, frame = Pen(look), look.palette, look.frame
    count = len(frame.type)
    ccd, solver = look.world.scratch.ccd, look.world.scratch.solver
    motions = plain(solver.motions)[:count]
    swept = np.flatnonzero((plain(solver.ccd)["fast"][:count] == 1) & frame.awake)
    impacts: Any = plain(ccd.impacts)[swept]
    way = np.column_stack([motions["delta_x"], motions["delta_y"]])[swept]
    angle = motions["delta_angle"][swept]
    now = frame.center[swept]
    start = now - impacts["time"][:, None] * way
    _ghosts(look, pen, swept, start - now, -impacts["time"] * angle)
    begin, end = look.camera.to_screen(start), look.camera.to_screen(start + way)
    pen.dashes(look.camera.to_screen(now), end, 1.4, color.quiet)
    pen.arrows(begin, look.camera.to_screen(now) - begin, 1.8, color.blue)
    stopped = impacts["time"] < 1.0
    arm = np.column_stack([impacts["arm_x"], impacts["arm_y"]])
    hit = look.camera.to_screen(now + arm)[stopped]
    normal = np.column_stack([impacts["normal_x"], -impacts["normal_y"]])[stopped]
    pen.arrows(hit, NORMAL_PIXELS * look.mark_scale * normal, 1.8, color.red)
    pen.dots(hit, 3.0, color.red)
    shares = [f"{100 * time:.0f} %" for time in impacts["time"][stopped].tolist()]
    pen.labels(shares, hit, color.red, gap=8.0)
    pen.legend(color.blue, f"swept: {counted(len(swept), 'body', 'bodies')}, from where the step began")
    pen.legend(color.red, f"stopped at a share of the step: {int(stopped.sum())}")
    return pen.marks()


def _ghosts(look: Look, pen: Pen, bodies: Ints, moved: Floats, turned: Floats) -> None:
    """The outlines of swept bodies where the step began."""
    mesh = look.frame.mesh
    origin, axis = look.frame.shape_poses()
    place = {body: k for k, body in enumerate(bodies.tolist())}
    shapes = [row for row in np.flatnonzero(np.isin(mesh.body, bodies)).tolist() if row not in mesh.outlines]
    for row in shapes[:_MOST_GHOSTS]:
        body = int(mesh.body[row])
        shift, turn = moved[place[body]], turned[place[body]]
        c, s = np.cos(turn), np.sin(turn)
        spin = np.array([[c, -s], [s, c]])
        center = look.frame.center[body]
        way = np.array([[axis[row, 0], -axis[row, 1]], [axis[row, 1], axis[row, 0]]])
        ring = contour(mesh.core(row), float(mesh.radius[row]), 0.25 / look.camera.scale)
        points = look.camera.to_screen((ring @ way.T + origin[row] - center) @ spin.T + center + shift)
        pen.lines(points, np.roll(points, -1, axis=0), 1.2, pen.palette.blue, 0.9)


OVERLAY = Overlay("sweeps", "Sweeps", "Bodies swept by continuous collision, and where they were stopped.", _draw)

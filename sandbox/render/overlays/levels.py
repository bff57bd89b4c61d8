"""Substep levels: islands that take 2, 4, 8 or 16 times the substeps of the scene."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.engine.active.pile_stability import MAX_LEVEL
from sandbox.render.marks import Marks
from sandbox.render.number_text import counted
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.tables import plain
from sandbox.world.records import DYNAMIC


def _draw(look: Look) -> Marks:
    pen, frame = Pen(look), look.frame
    motions: Any = plain(look.world.scratch.solver.free_motions)[: len(frame.type)]
    solved = (frame.type == DYNAMIC) & frame.awake
    level = np.where(solved, motions["substep_level"], 0)
    pen.tint(look.palette.ramp(level / MAX_LEVEL), np.where(frame.type == DYNAMIC, np.where(level > 0, 0.9, 0.6), 0.0))
    rows = look.visible_bodies()
    rows = rows[level[rows] > 0]
    substeps = int(look.world.state.settings[0].substeps)
    for row, at in zip(rows.tolist(), look.camera.to_screen(frame.center[rows]).tolist(), strict=True):
        pen.words(f"x{2 ** int(level[row])}", at, look.palette.text, rank=float(level[row]))
    for each in np.unique(level[frame.type == DYNAMIC]).tolist():
        count = int(((level == each) & (frame.type == DYNAMIC)).sum())
        color = look.palette.ramp(np.array([each / MAX_LEVEL]))[0]
        pen.legend(color, f"{counted(substeps << each, 'substep')}: {counted(count, 'body', 'bodies')}")
    return pen.marks(calm=False)


OVERLAY = Overlay("levels", "Substep levels", "Bodies whose islands take more substeps than the scene has.", _draw)

"""Who sleeps, who is about to, and who is kept awake."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.engine.active.sleep import SLEEP_SECONDS
from sandbox.engine.bodies.flags import KEPT_AWAKE
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.tables import plain
from sandbox.world.records import DYNAMIC


def _draw(look: Look) -> Marks:
    pen, frame, color = Pen(look), look.frame, look.palette
    bodies: Any = plain(look.world.state.bodies)
    dynamic = frame.type == DYNAMIC
    asleep = dynamic & ~frame.awake
    share = np.clip(bodies["sleep_time"] / SLEEP_SECONDS, 0.0, 1.0)
    kept = dynamic & frame.awake & (look.world.scratch.solver.flags[: len(frame.type)] & KEPT_AWAKE != 0)
    drowsy = share[:, None]
    inks = np.array(color.orange) * (1.0 - drowsy) + np.array(color.purple) * drowsy
    inks[asleep], inks[kept] = color.blue, color.red
    pen.tint(inks, np.where(asleep, 0.55, 0.85) * dynamic)
    rows = look.visible_bodies()
    waiting = rows[(dynamic & frame.awake & (share >= 0.1))[rows]]
    for row, at in zip(waiting.tolist(), look.camera.to_screen(frame.center[waiting]).tolist(), strict=True):
        if share[row] < 1.0:
            pen.words(f"{bodies['sleep_time'][row]:.1f} s", at, color.text)
    for ink, name, which in (
        (color.orange, "awake", dynamic & frame.awake & (share == 0.0) & ~kept),
        (color.purple, f"slow: sleeps after {SLEEP_SECONDS} s", dynamic & frame.awake & (share > 0.0) & ~kept),
        (color.red, "kept awake", kept),
        (color.blue, "asleep", asleep),
    ):
        if which.any():
            pen.legend(ink, f"{name}: {int(which.sum())}")
    return pen.marks(calm=False)


OVERLAY = Overlay("sleep", "Sleep", "Who is awake, slow (for so many seconds), kept awake or asleep.", _draw)

"""The list of bodies that something stops in mid-step: of thousands that are swept they are few."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.records.ccd import Ccd


@kernel
def list_hit(ccd: Ccd, body: int) -> None:
    """List a body before its row of `ccd.impacts` is written to."""
    if ccd.impacts[body].listed == 0:
        ccd.impacts[body].listed = 1
        ccd.hit[0] += 1
        ccd.hit[ccd.hit[0]] = body


@kernel
def forget_hits(ccd: Ccd) -> None:
    """Nobody is stopped yet."""
    for i in ccd.hit[1 : 1 + ccd.hit[0]]:
        impact = ccd.impacts[i]
        impact.time = 1.0
        impact.stopped = -1
        impact.bounces = impact.touched = impact.round = impact.listed = 0
    ccd.hit[0] = 0

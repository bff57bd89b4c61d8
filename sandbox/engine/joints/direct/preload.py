"""The preload of rigid rows: what they bore when the world was put down, under which they do not give way.

Rigid rows have a little compliance, so that ropes that are drawn straight stay solvable; a chain that is put where it
hangs would sag by it. Like the rest length of a contact's spring, the preload is found in the first substep of a world
and does not follow loads that come later: that would be an integral controller, which swings long chains up.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, Vector, absolute, load, select, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.acting_time import acting_time
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.rows import row_speed, units_of
from sandbox.engine.joints.direct.targets import is_rigid
from sandbox.tables import Floats, Records

ASSEMBLED = 1e-6
"""Error (m or rad) of joints that are put together: beyond it, what draws them together is no load."""
SLOW = 0.2
"""Speed (m/s or rad/s) of what is put down at rest, with what gravity adds in the longest usual substep."""

PRELOAD_TURNS = 4
"""How often the loads are found again, with those of the time before as preload: the method of multipliers
(M. Hestenes, 1969; M. Powell, 1969). A turn leaves a thirtieth of the error of a chain of 21 links; a rope that is
drawn straight, whose load is infinite, gets no more than some times what it bears without."""


@kernel
def is_at_rest(d: Batches, batch: Records) -> Mask:
    """Which parts are put together and do not move along any rigid row, before their joints have been solved."""
    v = d.memory
    layout = d.layouts[batch.layout]
    found = load(v, batch.lanes + at.IN_USE) == 1.0
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            error = absolute(load(v, batch.rows + row.kept + at.ERROR))
            unit = units_of(d, frame, row)
            rests = (error <= ASSEMBLED * unit) & (absolute(row_speed(v, row)) <= SLOW * unit)
            found = found & (rests | ~is_rigid(v, batch, frame, row))
    return found


@kernel
def take_as_preload(d: Batches, batch: Records, seconds: float, who: Mask) -> None:
    """Let the rigid rows of some parts bear what they bear now without giving way."""
    v = d.memory
    layout = d.layouts[batch.layout]
    acting = acting_time(v, batch, seconds)
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            kept = batch.rows + row.kept
            where = who & is_rigid(v, batch, frame, row)
            store(v, kept + at.PRELOAD, select(where, load(v, kept + at.IMPULSE) / acting, load(v, kept + at.PRELOAD)))


@inlined_kernel
def beyond_preload(v: Floats, batch: Records, row: Records, seconds: float) -> Vector:
    """The impulse (N s) before the move that a row gives way to."""
    kept = batch.rows + row.kept
    return load(v, kept + at.IMPULSE) - acting_time(v, batch, seconds) * load(v, kept + at.PRELOAD)

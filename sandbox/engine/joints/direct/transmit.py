"""What the joints of a factorised part do in an impact: they pass it on, so that its bodies stay joined in velocity.

That is exact, whatever hangs together: the velocities are projected onto those that the joints allow, as R. Weinstein,
J. Teran and R. Fedkiw, "Dynamic Simulation of Articulated Rigid Bodies with Contact and Collision", IEEE Transactions
on Visualization and Computer Graphics 12 (2006), do joint by joint.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import WIDTH, Mask, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.bodies import gather_bodies, scatter_bodies
from sandbox.engine.joints.direct.passes import BLOW
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.solve import solve_rows, update_rows
from sandbox.engine.joints.direct.targets import acts_in_blow
from sandbox.tables import Floats, Records


@kernel
def transmit(d: Batches, lane: int, motions: Records, free_motions: Records, seconds: float) -> None:
    """Change the velocities in `motions` of the part in a lane so that they keep its joints. Stops hold what would pass
    them within a substep of `seconds`. The impulses of the rows are left in `places.BLOW`."""
    batch = d.batches[lane // WIDTH]
    who = _only(d.memory, batch, lane % WIDTH)
    gather_bodies(d, batch, motions, free_motions, BLOW)
    update_rows(d, batch)
    _begin(d, batch, who)
    solve_rows(d, batch, seconds, BLOW, who)
    scatter_bodies(d, batch, motions)


@kernel
def report_blow(d: Batches, lane: int) -> None:
    """Add the impulses of the last impact to those of the step."""
    v = d.memory
    batch = d.batches[lane // WIDTH]
    layout = d.layouts[batch.layout]
    k = lane % WIDTH
    for r in range(layout.first_row, layout.row_end):
        kept = batch.rows + d.equations[r].kept + k
        v[kept + at.TOTAL] += v[kept + at.BLOW]


@kernel
def _only(v: Floats, batch: Records, k: int) -> Mask:
    """The mask of one lane."""
    for n in range(WIDTH):
        v[batch.lanes + at.STRUCK + n] = 1.0 if n == k else 0.0
    return load(v, batch.lanes + at.STRUCK) == 1.0


@kernel
def _begin(d: Batches, batch: Records, who: Mask) -> None:
    """No impulses yet; of the rows that act, nobody has looked at which are part of the system."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            kept = batch.rows + row.kept
            acts = who & acts_in_blow(v, batch, frame, row)
            store(v, kept + at.BLOW, select(who, 0.0, load(v, kept + at.BLOW)))
            store(v, row.place + at.CAPPED, select(acts, 0.0, spread(1.0)))
            store(v, row.place + at.ACTIVE, select(acts, spread(-1.0), 0.0))

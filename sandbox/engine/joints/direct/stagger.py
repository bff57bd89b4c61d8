"""Parts that nothing touches take the leapfrog through a step: their velocities are relaxed in its last substep alone.

What the relaxation changes lies along the rows of the pose that has been reached, and so do the impulses of the next
substep, which would give as much themselves: without it positions are the same (B. Leimkuhler, R. Skeel, "Symplectic
Numerical Integrators in Constrained Hamiltonian Systems", 1994: SHAKE and RATTLE). Springs know what they still have to
give of a substep, and give it when the next one begins. All that holds where nobody else asks for velocities: no
contact, no hand, and no limit, which draws back what is past it by a velocity that the relaxation takes away again.

Between two substeps, velocities are then those of the middle; the next one does not hold back a half of what forces
add, and impulses of its rows, other than springs, are those of a whole substep.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, load, select, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.targets import may_be_sprung, row_hertz
from sandbox.tables import Floats, Records


@kernel
def stay_between(d: Batches, batch: Records) -> None:
    """End a substep with the velocities of its middle. Impulses become those of a whole substep, which the next one
    begins with."""
    v = d.memory
    layout = d.layouts[batch.layout]
    factor = 1.0 if batch.between == 1 else 2.0
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            kept = batch.rows + row.kept
            impulse = load(v, kept + at.IMPULSE)
            springs = is_spring(v, batch, frame, row)
            store(v, kept + at.TOTAL, load(v, kept + at.TOTAL) + select(springs, 2.0 * impulse, impulse))
            store(v, kept + at.IMPULSE, select(springs, impulse, factor * impulse))


@kernel
def return_from_between(d: Batches, batch: Records) -> None:
    """Before velocities are relaxed: impulses become those of the half before the move, as they are elsewhere."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            kept = batch.rows + row.kept
            impulse = load(v, kept + at.IMPULSE)
            half = select(is_spring(v, batch, frame, row), 0.0, 0.5 * impulse)
            store(v, kept + at.TOTAL, load(v, kept + at.TOTAL) + half)
            store(v, kept + at.IMPULSE, impulse - half)
    batch.between = 0


@inlined_kernel
def is_spring(v: Floats, batch: Records, frame: Records, row: Records) -> Mask:
    """In which lanes a row is one."""
    stiff = load(v, batch.rows + row.kept + at.STIFFNESS) != 0.0
    if not may_be_spring(frame.kind, row.slot):
        return stiff & ~stiff
    if row.slot == 3:
        return stiff
    return stiff & (row_hertz(v, batch.joints + frame.constants, row.slot) > 0.0)


@inlined_kernel
def may_be_spring(kind: int, slot: int) -> bool:
    """Whether a row of a kind may be one."""
    return slot == 3 or (slot < 3 and may_be_sprung(kind))

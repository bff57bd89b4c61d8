"""Links under high tension swing faster than substeps can follow; they get the inertia at which these still can.

A force f that pulls at the arm r of a body turns it back with r . f for each radian: the geometric stiffness of
M. Tournier et al., "Stable Constrained Dynamics", 2015, which in the plane is a number for each body. The substep can
follow as long as its square times that is less than four times the inertia. Thrust, which makes links buckle, is
tamed alike.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Mask, Vector, absolute, any_lane, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.acting_time import acting_time
from sandbox.engine.joints.direct.records import TURN, Batches
from sandbox.engine.joints.direct.rows import fill_stiffness
from sandbox.tables import Floats, Records


@kernel
def add_geometric_stiffness(d: Batches, batch: Records, seconds: float) -> None:
    """Set the inertia of the bodies of a batch for this substep, from the impulses of the one before."""
    v = d.memory
    layout = d.layouts[batch.layout]
    acting = acting_time(v, batch, seconds)
    for slot in range(layout.seats):
        store(v, slot * at.SEAT_SIZE + at.TENSION, spread(0.0))
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            if row.sides == 2 and row.axis != TURN:
                stiff = load(v, batch.rows + row.kept + at.STIFFNESS) > 0.0
                force = load(v, batch.rows + row.kept + at.IMPULSE) / acting
                jacobian = row.place + at.JACOBIAN
                _pull(v, row.seat_1, frame.place + at.ARM_AX, jacobian, force, stiff)
                _pull(v, row.seat_2, frame.place + at.ARM_BX, jacobian + at.SIDE, force, stiff)
    changed = spread(0.0) > 0.0
    for slot in range(layout.moving):
        seat = batch.seats + slot * at.SEAT_SIZE
        inertia = load(v, seat + at.INERTIA)
        least = 0.5 * seconds * seconds * absolute(load(v, slot * at.SEAT_SIZE + at.TENSION))
        before = load(v, seat + at.INVERSE_INERTIA)
        _set_inertia(v, seat, inertia > 0.0, select(inertia > least, inertia, least))
        changed = changed | (load(v, seat + at.INVERSE_INERTIA) != before)
    if any_lane(changed):
        fill_stiffness(d, batch)


@inlined_kernel
def _pull(v: Floats, seat: int, arm: int, side: int, force: Vector, who: Mask) -> None:
    """Each y follows its x in memory."""
    before = load(v, seat + at.TENSION)
    pulled = load(v, arm) * load(v, side) + load(v, arm + WIDTH) * load(v, side + WIDTH)
    store(v, seat + at.TENSION, select(who, before + force * pulled, before))


@inlined_kernel
def _set_inertia(v: Floats, seat: int, who: Mask, inertia: Vector) -> None:
    before = load(v, seat + at.INVERSE_INERTIA)
    store(v, seat + at.INVERSE_INERTIA, select(who, 1.0 / select(who, inertia, 1.0), before))


@kernel
def remove_geometric_stiffness(d: Batches, batch: Records, who: Mask) -> None:
    """Give the bodies of some parts their own inertia: only with that can passes not add energy."""
    v = d.memory
    for slot in range(d.layouts[batch.layout].moving):
        seat = batch.seats + slot * at.SEAT_SIZE
        inertia = load(v, seat + at.INERTIA)
        _set_inertia(v, seat, who & (inertia > 0.0), inertia)
    fill_stiffness(d, batch)

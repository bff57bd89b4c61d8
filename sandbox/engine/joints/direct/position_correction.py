"""Displacements that bring a separated part together: pseudo-velocities, which move bodies once and are then forgotten.

E. Guendelman et al., "Nonconvex Rigid Bodies with Stacking", 2003, separate positions from velocities in this way. The
linear system is damped (K. Levenberg, 1944): joints next to each other come together at once, and what only the whole
chain could do, such as to fit between walls that are too far apart, does not throw its links about.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import WIDTH, Mask, absolute, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.ldl import factorize, solve_directly
from sandbox.engine.joints.direct.records import SUBSTEP_LEVEL, Batches
from sandbox.engine.joints.direct.separated import excess_error
from sandbox.engine.joints.direct.targets import is_rigid
from sandbox.engine.joints.laws import CORRECTION_SPEED
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records

CLOSE = 1e-6
"""Sum of the errors of a part (m or rad) up to which nothing is corrected: what rests is spared the linear system."""
DAMPING = 0.03
"""Softness of rows that are corrected, as a share of their stiffness."""


@kernel
def find_corrections(d: Batches, batch: Records, seconds: float, who: Mask) -> None:
    """Find what brings separated parts together without moving or turning a body faster than `CORRECTION_SPEED`."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            excess = excess_error(v, batch, frame, row, seconds)
            moved = is_rigid(v, batch, frame, row) | (excess != 0.0)
            store(v, row.place + at.ACTIVE, select(moved, 1.0, spread(0.0)))
            store(v, row.place + at.BIAS, excess / seconds)
            softness = DAMPING * load(v, batch.rows + row.kept + at.STIFFNESS)
            store(v, row.place + at.SOFTNESS, softness)
    _set_aside(d, batch)
    factorize(d, batch)
    solve_directly(d, batch, at.IMPULSE, who)
    _take_back(d, batch)
    _slow_down(d, batch)


@kernel
def _set_aside(d: Batches, batch: Records) -> None:
    """Keep velocities and impulses for later; mending begins at rest."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        kept = batch.rows + row.kept + at.IMPULSE
        store(v, row.place + at.ASIDE, load(v, kept))
        store(v, kept, spread(0.0))
    for slot in range(layout.seats):
        for field in range(3):
            place = slot * at.SEAT_SIZE + field * WIDTH
            store(v, batch.seats + place + at.CORRECTION_X, load(v, place + at.VELOCITY_X))
            if slot < layout.moving:
                store(v, place + at.VELOCITY_X, spread(0.0))


@kernel
def _take_back(d: Batches, batch: Records) -> None:
    """Exchange what was found for the velocities, and put the impulses back."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for slot in range(layout.seats):
        for field in range(3):
            place = slot * at.SEAT_SIZE + field * WIDTH
            found = load(v, place + at.VELOCITY_X)
            store(v, place + at.VELOCITY_X, load(v, batch.seats + place + at.CORRECTION_X))
            store(v, batch.seats + place + at.CORRECTION_X, found)
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        store(v, batch.rows + row.kept + at.IMPULSE, load(v, row.place + at.ASIDE))


@kernel
def _slow_down(d: Batches, batch: Records) -> None:
    """Make the fastest body keep to the limit, and all others with it."""
    v = d.memory
    moving = d.layouts[batch.layout].moving
    fastest = spread(CORRECTION_SPEED)
    for slot in range(moving):
        for field in range(3):
            place = batch.seats + slot * at.SEAT_SIZE + at.CORRECTION_X + field * WIDTH
            speed = absolute(load(v, place)) / (1.0 if field == 2 else d.units[0])
            fastest = select(speed > fastest, speed, fastest)
    share = CORRECTION_SPEED / fastest
    for slot in range(moving):
        for field in range(3):
            place = batch.seats + slot * at.SEAT_SIZE + at.CORRECTION_X + field * WIDTH
            store(v, place, load(v, place) * share)


@kernel
def apply_corrections(d: Batches, motions: Records, seconds: float) -> None:
    """Displace the bodies of separated parts."""
    v = d.memory
    for n in range(d.found[0]):
        batch = d.batches[n]
        if batch.level != d.level[SUBSTEP_LEVEL]:
            continue
        for k in range(batch.count):
            if v[batch.lanes + at.CORRECTED + k] == 1.0:
                _displace(d, batch, k, motions, seconds)


@kernel
def _displace(d: Batches, batch: Records, k: int, motions: Records, seconds: float) -> None:
    v = d.memory
    for slot in range(d.layouts[batch.layout].moving):
        seat = batch.seats + slot * at.SEAT_SIZE + k
        motion = motions[d.bodies[batch.bodies + slot * WIDTH + k]]
        motion.delta_x += seconds * v[seat + at.CORRECTION_X]
        motion.delta_y += seconds * v[seat + at.CORRECTION_Y]
        motion.delta_angle += seconds * v[seat + at.CORRECTION_W]
        motion.delta_cos, motion.delta_sin = cos_sin(motion.delta_angle)

"""Which rows are part of the linear system: those whose impulse is within its bounds, or on its way back into them.

The bounds of motors, limits, ropes and brakes make this a complementarity problem. It is solved by block pivoting
(J. Judice, F. Pires, 1994): guess which rows are at a bound, solve the others at once, and look again. The first guess
is what the substep before came to. Guesses may go in circles, as along a chain of hinges with friction, all of whose
rows say nearly the same, or in a net of ropes: then `descent` goes on.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, Vector, absolute, any_lane, load, root, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.acting_time import acting_time, spring_time
from sandbox.engine.joints.direct.passes import BLOW, RELAX, impulse_of
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.rows import change_impulse, row_error, row_speed, units_of
from sandbox.engine.joints.direct.targets import strength, target_blow, target_positions, target_velocities
from sandbox.engine.joints.laws import INFINITE
from sandbox.tables import Floats, Records
from sandbox.world.joint_records import FRICTION, MOTOR, TARGET

_AT_BOUND = 1.0 - 1e-9
"""The share of a bound from which on an impulse of the substep before is at it; it has been rounded since."""
_AT_REST = 1e-10
"""Speed (m/s or rad/s) along a row at its bound that is no more than rounding."""


@kernel
def choose_rows(d: Batches, batch: Records, seconds: float, purpose: int, who: Mask) -> Mask:
    """Set the law of every row at the present velocities, mark the active ones; in which parts that has changed."""
    v = d.memory
    changed = aim_rows(d, batch, seconds, purpose, who)
    layout = d.layouts[batch.layout]
    impulse = impulse_of(purpose)
    beyond = who & ~who
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            before = load(v, row.place + at.ACTIVE)
            acts = who & has_law(v, batch, row)
            if row.bounded == 1:
                beyond = beyond | (acts & _is_beyond(v, batch, row, impulse))
                acts = acts & _is_active(v, batch, row, impulse, _AT_REST * units_of(d, frame, row))
            active = select(acts, 1.0, select(who, 0.0, before))
            store(v, row.place + at.ACTIVE, active)
            changed = changed | (active != before)
    if any_lane(beyond):
        clamp_rows(d, batch, impulse, who)
    return changed


@kernel
def aim_rows(d: Batches, batch: Records, seconds: float, purpose: int, who: Mask) -> Mask:
    """Set all laws before any impulse changes: errors ahead belong to the velocities they were looked at with.

    Returns in which parts an active row strives for another speed, as it went from its stop to its motor.
    """
    v = d.memory
    changed = who & ~who
    layout = d.layouts[batch.layout]
    halves = load(v, batch.lanes + at.HALVES) == 1.0
    separated = load(v, batch.lanes + at.SEPARATED) == 1.0
    acting = acting_time(v, batch, seconds)
    springs_acting = spring_time(v, batch, seconds)
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            speed = row_speed(v, row)
            if purpose == RELAX:
                law = target_velocities(v, batch, frame, row, speed, seconds, halves)
            elif purpose == BLOW:
                law = target_blow(v, batch, frame, row, speed, seconds)
            else:
                error = load(v, batch.rows + row.kept + at.ERROR)
                ahead = select(separated, error + seconds * speed, row_error(v, frame, row))
                law = target_positions(v, batch, frame, row, ahead, speed, seconds, acting, springs_acting)
            where = who & has_law(v, batch, row)
            before = load(v, row.place + at.BIAS)
            replace(v, row.place + at.BIAS, law.bias, where)
            replace(v, row.place + at.SOFTNESS, law.softness, where)
            if row.bounded == 1:
                replace(v, row.place + at.LOW, law.low, where)
                replace(v, row.place + at.HIGH, law.high, where)
                stop = at.HELD if purpose == BLOW else at.STOP  # the pass that goes on asks which one had a say before
                place = batch.rows + row.kept + stop
                differs = (load(v, row.place + at.ACTIVE) == 1.0) & (load(v, place) != law.stop)
                if any_lane(where & differs):
                    notable = absolute(before - law.bias) > _AT_REST * units_of(d, frame, row)
                    changed = changed | (where & differs & notable)
                replace(v, place, law.stop, where)
    return changed


@inlined_kernel
def has_law(v: Floats, batch: Records, row: Records) -> Mask:
    """Whether a row has a say in this pass."""
    stiff = load(v, batch.rows + row.kept + at.STIFFNESS) > 0.0
    return stiff & (load(v, row.place + at.CAPPED) == 0.0)


@inlined_kernel
def replace(v: Floats, place: int, value: Vector, where: Mask) -> None:
    """Store a vector at `place` in some lanes."""
    store(v, place, select(where, value, load(v, place)))


@inlined_kernel
def _is_beyond(v: Floats, batch: Records, row: Records, impulse: int) -> Mask:
    """Whether a row's impulse is past one of its bounds."""
    current = load(v, batch.rows + row.kept + impulse)
    return (current < load(v, row.place + at.LOW)) | (current > load(v, row.place + at.HIGH))


@inlined_kernel
def _is_active(v: Floats, batch: Records, row: Records, impulse: int, slow: float) -> Mask:
    """Whether an active row's impulse is within its bounds, or another one's would come back from the one it is at.

    In the first guess what the substep before has left at a bound stays there: before joints are solved, the speed
    along a row says little. Later none leaves its bound for a speed up to `slow` (m/s or rad/s).
    """
    current = load(v, batch.rows + row.kept + impulse)
    low = load(v, row.place + at.LOW)
    high = load(v, row.place + at.HIGH)
    before = load(v, row.place + at.ACTIVE)
    wanted = row_speed(v, row) + load(v, row.place + at.BIAS) + load(v, row.place + at.SOFTNESS) * current
    solved = before == 1.0
    first = before == -1.0
    at_low = (current <= low) & (solved | (wanted >= -slow))
    at_high = (current >= high) & (solved | (wanted <= slow))
    was_low = first & (low < 0.0) & (current <= _AT_BOUND * low)
    was_high = first & (high > 0.0) & (current >= _AT_BOUND * high)
    return ~((low >= high) | at_low | at_high | was_low | was_high)


@kernel
def clamp_rows(d: Batches, batch: Records, impulse: int, who: Mask) -> None:
    """Put the impulses of all rows that have a say within their bounds."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if row.bounded == 1:
            clamp(v, batch, row, impulse, who & has_law(v, batch, row))


@kernel
def clamp(v: Floats, batch: Records, row: Records, impulse: int, who: Mask) -> None:
    """Put a row's impulse within its bounds."""
    kept = batch.rows + row.kept + impulse
    current = load(v, kept)
    low = load(v, row.place + at.LOW)
    high = load(v, row.place + at.HIGH)
    within = select(current < high, current, high)
    within = select(within > low, within, low)
    where = who & (within != current)
    if any_lane(where):
        change_impulse(v, batch, row, within - current, impulse, where)
        # to the bit, for whoever asks whether it is at its bound
        store(v, kept, select(where, within, current))


@kernel
def cap_pairs(d: Batches, batch: Records, seconds: float, purpose: int, who: Mask) -> None:
    """Shorten forces of two rows that are together past their limit; such a pair has reached it for this pass."""
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        if frame.kind == MOTOR or frame.kind == TARGET or frame.kind == FRICTION:
            _cap_pair(d, batch, frame, seconds, purpose, who)


@kernel
def _cap_pair(d: Batches, batch: Records, frame: Records, seconds: float, purpose: int, who: Mask) -> None:
    v = d.memory
    impulse = impulse_of(purpose)
    row = d.equations[frame.first_row]
    other = d.equations[frame.first_row + 1]
    most = strength(v, batch.joints + frame.constants, frame.kind, 0)
    stiff = load(v, batch.rows + row.kept + at.STIFFNESS) > 0.0
    limit = most * seconds if purpose == RELAX else most * acting_time(v, batch, seconds)
    x = load(v, batch.rows + row.kept + at.IMPULSE)
    y = load(v, batch.rows + other.kept + at.IMPULSE)
    if purpose == RELAX:
        x = x + load(v, batch.rows + row.kept + at.RELAXING)
        y = y + load(v, batch.rows + other.kept + at.RELAXING)
    size = root(x * x + y * y)
    where = who & stiff & (most < INFINITE) & (size > limit)
    if any_lane(where):
        share = limit / select(where, size, 1.0) - 1.0
        change_impulse(v, batch, row, share * x, impulse, where)
        change_impulse(v, batch, other, share * y, impulse, where)
        replace(v, row.place + at.CAPPED, spread(1.0), where)
        replace(v, other.place + at.CAPPED, spread(1.0), where)

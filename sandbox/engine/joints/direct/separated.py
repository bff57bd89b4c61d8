"""What a substep does about joints that are torn apart or borne, or whose links cannot be foreseen.

A joint that is drawn together moves all that hangs on it, so that the speeds which would correct a long chain at once
are enormous; and where something else bears the bodies, it hinders that, and answers: what stands on two legs would be
walked away by its own corrections. Links that turn too fast, and linkages that pass flat, are held by enormous
impulses or none. A part that is *separated*, by an impact or a command, that is borne, or whose joints miss their aim
or give it energy, is therefore solved otherwise: its velocities only keep the errors as they are, which takes no look
ahead and cannot add energy, and displacements that velocities never see bring it together (`position_correction`).
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, Vector, absolute, any_lane, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.acting_time import compliance
from sandbox.engine.joints.direct.preload import beyond_preload
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.rows import change_impulse, counts_radians, row_error, row_speed
from sandbox.engine.joints.direct.targets import is_brake, is_rigid, may_be_sprung, runs
from sandbox.engine.joints.laws import CORRECTION_SPEED, limited, overrun, without_yield
from sandbox.tables import Floats, Records
from sandbox.world.joint_records import MOTOR, TARGET

_GAIN = 1.1
"""Ratio of kinetic energies: links that turn by a third of a radian in a substep change theirs by as much."""
SLOW = 0.1
"""Speed (m/s) up to which a gain is what joints yield and take back."""
SHORT = 2
"""Joints of a part whose speeds of correction may add up."""


@kernel
def detect_separation(d: Batches, batch: Records, seconds: float) -> None:
    """Set what every row may have left of its error after this substep; the impulses are still those of the last.

    A part is separated if it is borne, or if its errors come to more than one joint may correct, unless it has but two
    joints.
    """
    v = d.memory
    layout = d.layouts[batch.layout]
    unit = d.units[0]
    meters = d.units[1]
    most = CORRECTION_SPEED * seconds
    total = spread(0.0)
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            excess = excess_error(v, batch, frame, row, seconds)
            turns = counts_radians(frame, row)
            store(v, row.place + at.MAY_LEAVE, limited(excess, most if turns else most * unit))
            apart = excess
            if row.slot < 3:
                error = load(v, batch.rows + row.kept + at.ERROR)
                apart = without_yield(error, _yielded(v, batch, row, seconds))
            store(v, row.place + at.APART, apart)
            total = total + absolute(excess) * (1.0 if turns else meters)
    place = batch.lanes + at.SEPARATED
    store(v, place, select(total > most, 1.0, spread(0.0)))
    if layout.joints <= SHORT:
        store(v, place, spread(0.0))
    borne = load(v, batch.lanes + at.HALVES) == 0.0
    store(v, place, select(borne, 1.0, load(v, place)))
    store(v, batch.lanes + at.APART_BY, total)
    keep_apart(d, batch, load(v, place) == 1.0)


@kernel
def keep_apart(d: Batches, batch: Records, who: Mask) -> None:
    """Have the rows of separated parts keep their errors."""
    v = d.memory
    if any_lane(who):
        layout = d.layouts[batch.layout]
        for r in range(layout.first_row, layout.row_end):
            place = d.equations[r].place
            kept = select(who, load(v, place + at.APART), load(v, place + at.MAY_LEAVE))
            store(v, place + at.MAY_LEAVE, kept)


@inlined_kernel
def excess_error(v: Floats, batch: Records, frame: Records, row: Records, seconds: float) -> Vector:
    """How far a limit is overrun, or the error of a rigid row beyond what it yields to its impulse, in m or rad."""
    kept = batch.rows + row.kept
    error = load(v, kept + at.ERROR)
    if row.slot == 4 and frame.limit == 1:
        joint = batch.joints + frame.constants
        over = overrun(error, load(v, joint + at.LOWER), load(v, joint + at.UPPER))
        return select(load(v, kept + at.STIFFNESS) > 0.0, over, 0.0)
    return select(is_rigid(v, batch, frame, row), error - _yielded(v, batch, row, seconds), 0.0)


@inlined_kernel
def _yielded(v: Floats, batch: Records, row: Records, seconds: float) -> Vector:
    """Error that the softness of a rigid row leaves under the impulse of the last substep, and gives back."""
    kept = batch.rows + row.kept
    return -seconds * compliance(batch) * load(v, kept + at.STIFFNESS) * beyond_preload(v, batch, row, seconds)


@kernel
def is_nearly_linear(d: Batches, batch: Records, seconds: float) -> bool:
    """Whether no hinge can miss its aim by more than a substep could correct, as bodies hardly turn otherwise than when
    they were looked at.

    The system is solved for levers of now: an arm r that turns by b instead of a misses |b - a| max(|a|, |b|) |r|.
    """
    v = d.memory
    layout = d.layouts[batch.layout]
    turned = spread(0.0)
    for slot in range(layout.seats):
        place = slot * at.SEAT_SIZE
        now = load(v, batch.seats + place + at.START_ANGLE) + load(v, place + at.DELTA_ANGLE)
        looked_at = load(v, place + at.ANGLE) - now
        ahead = seconds * load(v, place + at.VELOCITY_W)
        further = select(absolute(ahead) > absolute(looked_at), absolute(ahead), absolute(looked_at))
        missed = absolute(ahead - looked_at) * further
        turned = select(missed > turned, missed, turned)
    longest = spread(0.0)
    for f in range(layout.first_frame, layout.frame_end):
        place = d.layout_frames[f].place
        gap = absolute(load(v, place + at.GAP_X)) + absolute(load(v, place + at.GAP_Y))
        arm_a = absolute(load(v, place + at.ARM_AX)) + absolute(load(v, place + at.ARM_AY))
        arm_b = absolute(load(v, place + at.ARM_BX)) + absolute(load(v, place + at.ARM_BY))
        reach = arm_a + arm_b + gap
        longest = select(reach > longest, reach, longest)
    return not any_lane(~(turned * longest < CORRECTION_SPEED * seconds * d.units[0]))


@kernel
def kinetic_energy(d: Batches, batch: Records, faster: float) -> Vector:
    """The kinetic energy (J) of each part, were its bodies faster by so much (m/s), aside."""
    v = d.memory
    energy = spread(0.0)
    for slot in range(d.layouts[batch.layout].moving):
        place = slot * at.SEAT_SIZE
        x = load(v, place + at.VELOCITY_X)
        y = load(v, place + at.VELOCITY_Y)
        w = load(v, place + at.VELOCITY_W)
        inverse = load(v, batch.seats + place + at.INVERSE_MASS)
        moves = inverse > 0.0
        mass = select(moves, 1.0 / select(moves, inverse, 1.0), 0.0)
        energy = energy + 0.5 * (
            mass * (x * x + y * y + faster * faster) + load(v, batch.seats + place + at.INERTIA) * (w * w)
        )
    return energy


@kernel
def gains_energy(d: Batches, batch: Records, seconds: float, before: Vector) -> Mask:
    """Which parts have notably more kinetic energy (J) than before their joints were solved, and than these can have
    given: a linkage that passes flat, whose rows say nearly the same, can be held by enormous impulses only."""
    v = d.memory
    layout = d.layouts[batch.layout]
    gained = kinetic_energy(d, batch, 0.0) - _GAIN * before
    if not any_lane(gained > 0.0):
        return gained > 0.0
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            if row.slot > 2 or is_brake(frame.kind, row.slot) or may_be_sprung(frame.kind):
                gained = gained - _work(v, batch, frame, row, seconds)
    return gained > 0.0


@kernel
def _work(v: Floats, batch: Records, frame: Records, row: Records, seconds: float) -> Vector:
    """The energy (J) that a spring, a drive, or a stop that was overrun may have given."""
    given = absolute(load(v, batch.rows + row.kept + at.IMPULSE))
    speed = absolute(row_speed(v, row))
    if row.slot != 4:
        pulls = frame.kind == MOTOR or frame.kind == TARGET
        return given * speed if pulls else select(is_rigid(v, batch, frame, row), 0.0, given * speed)
    limit = seconds * load(v, batch.joints + frame.constants + at.MAX_MOTOR) if runs(frame) else spread(0.0)
    driven = select(given < limit, given, limit) * speed
    return driven + given * absolute(excess_error(v, batch, frame, row, seconds)) / seconds


@kernel
def misses_targets(d: Batches, batch: Records, seconds: float) -> Mask:
    """In which parts some joint, at the predicted pose, misses its aim by more than a substep could correct."""
    v = d.memory
    layout = d.layouts[batch.layout]
    most = CORRECTION_SPEED * seconds
    unit = d.units[0]
    found = spread(0.0) > 0.0
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        may = 4.0 * most if frame.kind == MOTOR else most  # a motor may have a long way to go
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            found = found | (
                _missed(v, batch, frame, row, seconds) > (may if counts_radians(frame, row) else may * unit)
            )
    return found


@kernel
def _missed(v: Floats, batch: Records, frame: Records, row: Records, seconds: float) -> Vector:
    kept = batch.rows + row.kept
    error = row_error(v, frame, row)
    may_leave = load(v, row.place + at.MAY_LEAVE)
    if row.slot == 4 and frame.limit == 1:
        joint = batch.joints + frame.constants
        lower = load(v, joint + at.LOWER)
        upper = load(v, joint + at.UPPER)
        stop = load(v, kept + at.STOP)
        at_stop = (load(v, row.place + at.ACTIVE) == 1.0) & (stop != 0.0)
        stiff = load(v, kept + at.STIFFNESS) > 0.0
        over = absolute(overrun(error, lower, upper)) - absolute(may_leave)
        held = absolute(error - select(stop < 0.0, upper, lower) - may_leave)
        return select(at_stop, held, select(stiff, over, 0.0))
    softness = load(v, row.place + at.SOFTNESS)
    missed = absolute(error - may_leave + seconds * softness * beyond_preload(v, batch, row, seconds))
    return select(is_rigid(v, batch, frame, row), missed, 0.0)


@kernel
def take_impulses_back(d: Batches, batch: Records, who: Mask) -> None:
    """Take back what the rows of some parts have done in this substep; these count as separated."""
    v = d.memory
    layout = d.layouts[batch.layout]
    place = batch.lanes + at.SEPARATED
    store(v, place, select(who, 1.0, load(v, place)))
    keep_apart(d, batch, who)
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        kept = batch.rows + row.kept
        stiff = load(v, kept + at.STIFFNESS) > 0.0
        store(v, row.place + at.CAPPED, select(who, 0.0, load(v, row.place + at.CAPPED)))
        unknown = select(stiff, -1.0, spread(0.0))
        store(v, row.place + at.ACTIVE, select(who, unknown, load(v, row.place + at.ACTIVE)))
        change_impulse(v, batch, row, -load(v, kept + at.IMPULSE), at.IMPULSE, who)

"""What a pass does about bounds where guesses at which rows are at them go in circles: steps that only lead downhill.

What the rows strive for is the least of a convex function of their impulses within their bounds. Sweeps of projected
Gauss-Seidel find out who is at a bound; all others are solved at once, and that is followed as far as the first bound:
M. Silcowitz, S. Niebe, K. Erleben, "Projected Gauss-Seidel Subspace Minimization Method for Interactive Rigid Body
Dynamics", 2010. Neither adds energy to what no stop has touched, from which they begin, however far they get.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Mask, Vector, any_lane, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.acting_time import acting_time, compliance, spring_time
from sandbox.engine.joints.direct.ldl import factorize, solve_directly
from sandbox.engine.joints.direct.passes import RELAX, impulse_of
from sandbox.engine.joints.direct.pivoting import cap_pairs, clamp, clamp_rows, has_law, replace
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.rows import change_impulse, row_speed
from sandbox.engine.joints.direct.targets import Law, target_positions, target_velocities
from sandbox.tables import Floats, Records

_NO_BOUND = 1e250
"""Impulses (N s or N m s) from here on are no bound: `INFINITE` times the length of a substep."""
_ROUNDS = 4
"""Most linear systems that are solved for that."""
_SWEEPS = 4
"""Sweeps before each of them, every other one backwards."""


@kernel
def descend(d: Batches, batch: Records, seconds: float, purpose: int, who: Mask) -> None:
    """Solve the parts `who` for velocities of now alone, as far as some rounds lead."""
    impulse = impulse_of(purpose)
    _begin_again(d, batch, impulse, who)
    _let_go(d, batch, impulse, who)
    factorize(d, batch)
    solve_directly(d, batch, impulse, who)
    for _ in range(_ROUNDS):
        changed = who & ~who
        for sweep in range(_SWEEPS):
            changed = changed | _sweep(d, batch, seconds, purpose, who, sweep % 2 == 1)
        if not any_lane(changed):
            break
        _set_aside(d, batch, impulse)
        factorize(d, batch)
        solve_directly(d, batch, impulse, who)
        _return_to_bounds(d, batch, impulse, who)
        cap_pairs(d, batch, seconds, purpose, who)


@kernel
def keep_beginning(d: Batches, batch: Records, impulse: int) -> None:
    """Note velocities and impulses before the first guess."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        store(v, row.place + at.BEGAN, load(v, batch.rows + row.kept + impulse))
    for slot in range(layout.moving):
        for field in range(3):
            place = slot * at.SEAT_SIZE + field * WIDTH
            store(v, batch.seats + place + at.CORRECTION_X, load(v, place + at.VELOCITY_X))


@kernel
def _begin_again(d: Batches, batch: Records, impulse: int, who: Mask) -> None:
    """Put velocities and impulses back to what they were: what a wrong guess has given may be so much that to take it
    away leaves nothing but rounding."""
    v = d.memory
    layout = d.layouts[batch.layout]
    batch.foreseen = 0
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        replace(v, batch.rows + row.kept + impulse, load(v, row.place + at.BEGAN), who)
        replace(v, row.place + at.CAPPED, spread(0.0), who)
    for slot in range(layout.moving):
        for field in range(3):
            place = slot * at.SEAT_SIZE + field * WIDTH
            replace(v, place + at.VELOCITY_X, load(v, batch.seats + place + at.CORRECTION_X), who)


@kernel
def _let_go(d: Batches, batch: Records, impulse: int, who: Mask) -> None:
    """Leave the rows that have bounds out of the linear system. Those of motors give what they gave, put within their
    bounds; what stops gave is taken back."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if row.bounded == 1:
            below = load(v, row.place + at.LOW) > -_NO_BOUND
            above = load(v, row.place + at.HIGH) < _NO_BOUND
            active = load(v, row.place + at.ACTIVE)
            store(v, row.place + at.ACTIVE, select(who & (below | above), 0.0, active))
            stops = who & has_law(v, batch, row) & (below | above) & ~(below & above)
            change_impulse(v, batch, row, -load(v, batch.rows + row.kept + impulse), impulse, stops)
    clamp_rows(d, batch, impulse, who)


@kernel
def _sweep(d: Batches, batch: Records, seconds: float, purpose: int, who: Mask, backwards: bool) -> Mask:
    """Give each row that has bounds the impulse that it strives for, one after the other, and mark those between their
    bounds as active; in which parts that has changed."""
    v = d.memory
    layout = d.layouts[batch.layout]
    impulse = impulse_of(purpose)
    changed = who & ~who
    count = layout.frame_end - layout.first_frame
    for n in range(count):
        frame = d.layout_frames[layout.frame_end - 1 - n if backwards else layout.first_frame + n]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            if row.bounded == 0:
                continue
            where = who & has_law(v, batch, row)
            speed = row_speed(v, row)
            law = _law_of_now(v, batch, frame, row, speed, seconds, purpose)
            _keep_law(v, batch, row, law, where)
            current = load(v, batch.rows + row.kept + impulse)
            easily = load(v, batch.rows + row.kept + at.STIFFNESS) + law.softness
            moves = where & (easily > 0.0)
            wanted = current - (speed + law.bias + law.softness * current) / select(moves, easily, 1.0)
            wanted = select(wanted < law.high, wanted, law.high)
            wanted = select(wanted > law.low, wanted, law.low)
            active = select((wanted > law.low) & (wanted < law.high), 1.0, spread(0.0))
            before = load(v, row.place + at.ACTIVE)
            changed = changed | (where & (active != before))
            store(v, row.place + at.ACTIVE, select(where, active, select(who, 0.0, before)))
            change_impulse(v, batch, row, wanted - current, impulse, moves)
    return changed


@inlined_kernel
def _keep_law(v: Floats, batch: Records, row: Records, law: Law, where: Mask) -> None:
    replace(v, row.place + at.BIAS, law.bias, where)
    replace(v, row.place + at.SOFTNESS, law.softness, where)
    replace(v, row.place + at.LOW, law.low, where)
    replace(v, row.place + at.HIGH, law.high, where)
    replace(v, batch.rows + row.kept + at.STOP, law.stop, where)


@kernel
def _law_of_now(
    v: Floats, batch: Records, frame: Records, row: Records, speed: Vector, seconds: float, purpose: int
) -> Law:
    """The law of a row whose error grows with its speed of now. Stops give way as rigid rows do: taut ones may say
    nearly the same."""
    if purpose == RELAX:
        halves = load(v, batch.lanes + at.HALVES) == 1.0
        law = target_velocities(v, batch, frame, row, speed, seconds, halves)
    else:
        ahead = load(v, batch.rows + row.kept + at.ERROR) + seconds * speed
        acting = acting_time(v, batch, seconds)
        springs_acting = spring_time(v, batch, seconds)
        law = target_positions(v, batch, frame, row, ahead, speed, seconds, acting, springs_acting)
    if row.slot != 4:
        return law
    give = compliance(batch) * load(v, batch.rows + row.kept + at.STIFFNESS)
    return Law(law.bias, give, law.low, law.high, law.stop)


@kernel
def _set_aside(d: Batches, batch: Records, impulse: int) -> None:
    """Keep the impulses of all rows for later."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        store(v, row.place + at.ASIDE, load(v, batch.rows + row.kept + impulse))


@kernel
def _return_to_bounds(d: Batches, batch: Records, impulse: int, who: Mask) -> None:
    """Go back on the way from the impulses that were set aside to where none is past its bounds."""
    v = d.memory
    layout = d.layouts[batch.layout]
    share = spread(1.0)
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if row.bounded == 1:
            aside = load(v, row.place + at.ASIDE)
            way = load(v, batch.rows + row.kept + impulse) - aside
            low = load(v, row.place + at.LOW)
            high = load(v, row.place + at.HIGH)
            bound = select(way < 0.0, low, high) - aside
            beyond = has_law(v, batch, row) & (way != 0.0) & (select(way < 0.0, bound - way, way - bound) > 0.0)
            reached = bound / select(beyond, way, 1.0)
            reached = select(reached > 0.0, reached, 0.0)
            share = select(beyond & (reached < share), reached, share)
    if not any_lane(who & (share < 1.0)):
        return
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        way = load(v, batch.rows + row.kept + impulse) - load(v, row.place + at.ASIDE)
        change_impulse(v, batch, row, (share - 1.0) * way, impulse, who & (share < 1.0))
        if row.bounded == 1:
            clamp(v, batch, row, impulse, who & has_law(v, batch, row))

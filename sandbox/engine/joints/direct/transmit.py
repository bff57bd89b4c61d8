"""What the joints of a factorised part do in an impact: they pass it on, so that its bodies stay joined in velocity.

That is exact, whatever hangs together: the velocities are projected onto those that the joints allow, as R. Weinstein,
J. Teran and R. Fedkiw, "Dynamic Simulation of Articulated Rigid Bodies with Contact and Collision", IEEE Transactions
on Visualization and Computer Graphics 12 (2006), do joint by joint.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import WIDTH, Mask, any_lane, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.assemble import assemble
from sandbox.engine.joints.direct.bodies import gather_bodies, gather_starts, scatter_bodies
from sandbox.engine.joints.direct.ldl import factorize, solve_directly
from sandbox.engine.joints.direct.passes import BLOW
from sandbox.engine.joints.direct.pivoting import aim_rows, choose_rows, clamp_rows
from sandbox.engine.joints.direct.records import PASSED_THROUGH, Batches
from sandbox.engine.joints.direct.rows import row_speed
from sandbox.engine.joints.direct.solve import update_rows
from sandbox.engine.joints.direct.targets import acts_in_blow
from sandbox.tables import Records

_TURNS = 16
"""Most guesses at which stops hold."""


@kernel
def begin_blows(d: Batches) -> None:
    """Begin with the impacts of a substep: no batch is in the working place for them."""
    d.own[0].in_blow = 0
    d.level[PASSED_THROUGH] = 0


@kernel
def forget_stops(d: Batches, lane: int) -> None:
    """No stop of the part in a lane holds yet."""
    v = d.memory
    batch = d.batches[lane // WIDTH]
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        v[batch.rows + d.equations[r].kept + at.HELD + lane % WIDTH] = 0.0


@kernel
def set_struck(d: Batches, lane: int, struck: bool) -> None:
    """Say whether something pushes the part in a lane."""
    d.memory[d.batches[lane // WIDTH].lanes + at.STRUCK + lane % WIDTH] = 1.0 if struck else 0.0
    d.level[PASSED_THROUGH] += 1 if struck else 0


@kernel
def transmit(d: Batches, n: int, motions: Records, free_motions: Records, seconds: float) -> bool:
    """Change the velocities in `motions` of the parts of batch n that are struck so that they keep their joints;
    returns whether other stops hold than before.

    Stops hold what would pass them within a substep of `seconds`; those that held before are the first guess. The
    impulses of the rows are left in `places.BLOW`.
    """
    who = load(d.memory, d.batches[n].lanes + at.STRUCK) == 1.0
    if not any_lane(who):
        return False
    batch = d.own[0]
    _place(d, n, motions, free_motions, who, seconds)
    solve_directly(d, batch, at.BLOW, who)
    others = False
    if d.layouts[batch.layout].bounded == 1:
        _let_stops_act(d, batch, who)
        going = who
        for _ in range(_TURNS):
            going = going & choose_rows(d, batch, seconds, BLOW, going)
            if not any_lane(going):
                break
            others = True
            factorize(d, batch)
            solve_directly(d, batch, at.BLOW, going)
        clamp_rows(d, batch, at.BLOW, who)
    scatter_bodies(d, batch, motions)
    return others


@kernel
def transmit_push(d: Batches, n: int, motions: Records, free_motions: Records, seconds: float) -> None:
    """The same for what pushes alone: with the stops that held before, even if they pull, which leave the speeds along
    them as they were at the start of the substep. So what it changes is proportional to the push."""
    batch = d.own[0]
    who = load(d.memory, d.batches[n].lanes + at.STRUCK) == 1.0
    if any_lane(who):
        _place(d, n, motions, free_motions, who, seconds)
        if _acts_at_stop(d, batch, who):
            _keep_speeds_at_stops(d, batch, free_motions)
            gather_bodies(d, batch, motions, free_motions, BLOW)
        solve_directly(d, batch, at.BLOW, who)
        scatter_bodies(d, batch, motions)


@kernel
def come_to_stops(d: Batches, n: int, motions: Records, free_motions: Records, seconds: float) -> None:
    """The same where nothing pushes: what the stops that held before change, which what they hold comes to within the
    substep."""
    who = load(d.memory, d.batches[n].lanes + at.STRUCK) == 1.0
    if any_lane(who):
        _place(d, n, motions, free_motions, who, seconds)
        solve_directly(d, d.own[0], at.BLOW, who)
        scatter_bodies(d, d.own[0], motions)


@kernel
def holds_stop(d: Batches, lane: int) -> bool:
    """Whether some stop of the part in a lane held last."""
    batch = d.batches[lane // WIDTH]
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if row.slot == 4 and d.memory[batch.rows + row.kept + at.HELD + lane % WIDTH] != 0.0:
            return True
    return False


@kernel
def _acts_at_stop(d: Batches, batch: Records, who: Mask) -> bool:
    """Whether some stop of the parts `who` acts."""
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if row.slot == 4 and any_lane(who & (load(d.memory, row.place + at.ACTIVE) == 1.0)):
            return True
    return False


@kernel
def _keep_speeds_at_stops(d: Batches, batch: Records, free_motions: Records) -> None:
    """Let stops that hold aim at the speeds along them with which the substep began."""
    v = d.memory
    layout = d.layouts[batch.layout]
    gather_starts(d, batch, free_motions)
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if row.slot == 4:
            store(v, row.place + at.BIAS, -row_speed(v, row))


@kernel
def _place(d: Batches, n: int, motions: Records, free_motions: Records, who: Mask, seconds: float) -> None:
    """Put batch n, `own[0]`, in the working place, factorised with the stops of the parts `who` that held before."""
    batch = d.own[0]
    placed = batch.in_blow == 1 and batch.rows == d.batches[n].rows
    if not placed:
        d.own[0] = d.batches[n]
        batch.in_blow = 1
    gather_bodies(d, batch, motions, free_motions, BLOW)
    if not placed:
        update_rows(d, batch)
        assemble(d, batch)
    changed = _begin(d, batch, who)
    aim_rows(d, batch, seconds, BLOW, who)
    if not placed or any_lane(changed):
        factorize(d, batch)


@kernel
def report_blow(d: Batches, lane: int) -> None:
    """Add the impulses of the last impact to those of the step, if it struck."""
    v = d.memory
    batch = d.batches[lane // WIDTH]
    layout = d.layouts[batch.layout]
    k = lane % WIDTH
    if v[batch.lanes + at.STRUCK + k] == 0.0:
        return
    for r in range(layout.first_row, layout.row_end):
        kept = batch.rows + d.equations[r].kept + k
        v[kept + at.TOTAL] += v[kept + at.BLOW]


@kernel
def _let_stops_act(d: Batches, batch: Records, who: Mask) -> None:
    """Give those stops a say that did not hold before, too."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            if row.slot == 4:
                acts = who & acts_in_blow(v, batch, frame, row)
                store(v, row.place + at.CAPPED, select(acts, 0.0, load(v, row.place + at.CAPPED)))


@kernel
def _begin(d: Batches, batch: Records, who: Mask) -> Mask:
    """Begin with no impulses of the rows that are rigid and of the stops that held before; where that is not what has
    been factorised."""
    v = d.memory
    layout = d.layouts[batch.layout]
    changed = who & ~who
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            kept = batch.rows + row.kept
            acts = who & acts_in_blow(v, batch, frame, row)
            store(v, kept + at.BLOW, select(who, 0.0, load(v, kept + at.BLOW)))
            if row.slot == 4:
                acts = acts & (load(v, kept + at.HELD) != 0.0)
            store(v, row.place + at.CAPPED, select(acts, 0.0, spread(1.0)))
            active = select(acts, spread(1.0), 0.0)
            changed = changed | (active != load(v, row.place + at.ACTIVE))
            store(v, row.place + at.ACTIVE, active)
    return changed

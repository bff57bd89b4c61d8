"""The passes over batches: before the move, which positions are solved by, and after it, which relaxes velocities."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, any_lane, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.assemble import assemble
from sandbox.engine.joints.direct.bodies import gather_bodies, look_ahead, scatter_bodies
from sandbox.engine.joints.direct.descent import descend, keep_beginning
from sandbox.engine.joints.direct.frames import measure_frames
from sandbox.engine.joints.direct.geometric_stiffness import add_geometric_stiffness, remove_geometric_stiffness
from sandbox.engine.joints.direct.ldl import factorize, solve_directly
from sandbox.engine.joints.direct.passes import MOVE, RELAX, impulse_of
from sandbox.engine.joints.direct.pivoting import cap_pairs, choose_rows
from sandbox.engine.joints.direct.position_correction import CLOSE, find_corrections
from sandbox.engine.joints.direct.preload import PRELOAD_TURNS, is_at_rest, take_as_preload
from sandbox.engine.joints.direct.records import IS_LAST, SUBSTEP_LEVEL, Batches
from sandbox.engine.joints.direct.reports import accumulate
from sandbox.engine.joints.direct.rows import change_impulse, fill_rows
from sandbox.engine.joints.direct.separated import (
    SLOW,
    detect_separation,
    gains_energy,
    is_nearly_linear,
    kinetic_energy,
    misses_targets,
    take_impulses_back,
)
from sandbox.engine.joints.direct.stagger import is_spring, may_be_spring, return_from_between, stay_between
from sandbox.engine.joints.direct.targets import may_be_sprung, row_hertz
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import SECONDS, SOLVE_BATCHES
from sandbox.tables import Floats, Records

_TURNS = 12
"""Most guesses at which rows are at their bounds, in one pass; what is left is for the next one."""


@kernel
def solve_batches(
    d: Batches, motions: Records, free_motions: Records, seconds: float, task: int, workers: Workers
) -> None:
    """Change velocities so that joints will be kept after the move (`SOLVE_BATCHES`), or are after it, in velocity as
    well (`RELAX_BATCHES`)."""
    workers.numbers[SECONDS] = seconds
    first, end = first_part(workers, task, 0, d.found[0])
    while first < end:
        solve_some_batches(d, motions, free_motions, seconds, task, 0, first, end)
        first, end = next_part(workers, first, end)


@kernel
def solve_some_batches(
    d: Batches, motions: Records, free_motions: Records, seconds: float, task: int, worker: int, first: int, end: int
) -> None:
    """The same for the batches first..end-1, in the working place of a worker."""
    begin = worker * d.found[4]
    here = Batches(
        d.layouts, d.layout_frames, d.equations, d.entries, d.products, d.targets, d.fixed, d.batches, d.own, d.found,
        d.level, d.open, d.parts, d.bodies, d.delassus, d.units, d.memory[begin:],
    )  # fmt: skip
    batch = d.own[worker]
    for n in range(first, end):
        if d.batches[n].level != d.level[SUBSTEP_LEVEL]:
            continue
        stays = d.batches[n].staggered == 1 and d.level[IS_LAST] == 0
        d.own[worker] = d.batches[n]
        batch.lanes -= begin
        batch.seats -= begin
        batch.joints -= begin
        batch.rows -= begin
        if task == SOLVE_BATCHES:
            gather_bodies(here, batch, motions, free_motions, MOVE)
            _solve_positions(here, batch, seconds)
        elif stays:
            stay_between(here, batch)
            d.batches[n].between = 1
            continue
        else:
            if batch.between == 1:
                return_from_between(here, batch)
                d.batches[n].between = 0
            gather_bodies(here, batch, motions, free_motions, RELAX)
            _relax(here, batch, seconds)
        scatter_bodies(here, batch, motions)


@kernel
def _relax(d: Batches, batch: Records, seconds: float) -> None:
    update_rows(d, batch)
    _start_warm(d, batch, True)
    solve_rows(d, batch, seconds, RELAX, _lanes_in_use(d.memory, batch))
    accumulate(d, batch)


@kernel
def _solve_positions(d: Batches, batch: Records, seconds: float) -> None:
    v = d.memory
    layout = d.layouts[batch.layout]
    who = _lanes_in_use(v, batch)
    update_rows(d, batch)
    add_geometric_stiffness(d, batch, seconds)
    detect_separation(d, batch, seconds)
    separated = load(v, batch.lanes + at.SEPARATED) == 1.0
    if any_lane(separated):
        remove_geometric_stiffness(d, batch, separated)
    put_down = who & (load(v, batch.lanes + at.NEW) == 1.0)
    if any_lane(put_down):
        put_down = put_down & is_at_rest(d, batch)
        store(v, batch.lanes + at.NEW, spread(0.0))
    before = kinetic_energy(d, batch, SLOW * d.units[0])
    _start_warm(d, batch, False)
    settled = solve_rows(d, batch, seconds, MOVE, who)
    if any_lane(put_down):  # what its loads tear from its aim, as a motor of any strength may, does not rest under them
        _foresee(d, batch, seconds)
        put_down = put_down & ~misses_targets(d, batch, seconds)
    for _ in range(PRELOAD_TURNS if any_lane(put_down) else 0):
        take_as_preload(d, batch, seconds, put_down & settled)
        settled = (settled & ~put_down) | solve_rows(d, batch, seconds, MOVE, put_down)
    failed = who & ~separated & ~put_down & gains_energy(d, batch, seconds, before)
    solved_once = layout.hinged == 1 and batch.redundant == 0 and not any_lane(put_down)
    if not (solved_once and is_nearly_linear(d, batch, seconds)):
        _foresee(d, batch, seconds)
        failed = failed | (who & ~separated & misses_targets(d, batch, seconds))
    if any_lane(failed):
        take_impulses_back(d, batch, failed)
        remove_geometric_stiffness(d, batch, failed)
        update_rows(d, batch)
        solve_rows(d, batch, seconds, MOVE, failed)
    separated = who & (separated | failed)
    apart = separated & (load(v, batch.lanes + at.APART_BY) > CLOSE)
    store(v, batch.lanes + at.CORRECTED, select(apart, 1.0, spread(0.0)))
    if any_lane(apart):
        find_corrections(d, batch, seconds, apart)


@inlined_kernel
def _lanes_in_use(v: Floats, batch: Records) -> Mask:
    return load(v, batch.lanes + at.IN_USE) == 1.0


@kernel
def update_rows(d: Batches, batch: Records) -> None:
    """Rows of the present pose."""
    look_ahead(d, batch, 0.0)
    measure_frames(d, batch)
    batch.foreseen = 0
    fill_rows(d, batch)


@kernel
def _foresee(d: Batches, batch: Records, seconds: float) -> None:
    """Measure the joints where the present velocities lead in so many seconds."""
    if batch.foreseen == 0:
        look_ahead(d, batch, seconds)
        measure_frames(d, batch)
        batch.foreseen = 1


@kernel
def _start_warm(d: Batches, batch: Records, relaxing: bool) -> None:
    """Apply the impulses of the substep before; springs give the other half of theirs where they act in halves."""
    v = d.memory
    layout = d.layouts[batch.layout]
    halves = load(v, batch.lanes + at.HALVES) == 1.0
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            kept = batch.rows + row.kept
            stiff = load(v, kept + at.STIFFNESS) != 0.0
            impulse = select(stiff, load(v, kept + at.IMPULSE), 0.0)
            current = select(stiff, load(v, kept + at.RELAXING), 0.0)
            store(v, row.place + at.CAPPED, spread(0.0))
            store(v, row.place + at.ACTIVE, select(stiff, spread(-1.0), 0.0))
            if relaxing:
                if row.slot == 3:
                    current = select(halves, impulse, 0.0)
                elif row.slot < 3 and may_be_sprung(frame.kind):
                    sprung = row_hertz(v, batch.joints + frame.constants, row.slot) > 0.0
                    current = select(sprung, select(halves, impulse, 0.0), current)
                store(v, kept + at.IMPULSE, impulse)
                store(v, kept + at.RELAXING, spread(0.0))
                change_impulse(v, batch, row, current, at.RELAXING, halves | ~halves)
            else:
                stop = select(impulse > 0.0, 1.0, select(impulse < 0.0, -1.0, spread(0.0)))
                store(v, kept + at.STOP, stop)
                store(v, kept + at.RELAXING, current)
                store(v, kept + at.IMPULSE, spread(0.0))
                change_impulse(v, batch, row, impulse, at.IMPULSE, halves | ~halves)
                if batch.between == 1 and may_be_spring(frame.kind, row.slot):
                    # what it has still to give of the substep before
                    change_impulse(v, batch, row, impulse, at.RELAXING, is_spring(v, batch, frame, row))


@kernel
def solve_rows(d: Batches, batch: Records, seconds: float, purpose: int, who: Mask) -> Mask:
    """In which of the parts `who` all marks of the rows came to rest.

    A part whose marks rest is left alone while others of its batch go on. Where they do not, `descent` goes on from
    where the guesses began.
    """
    layout = d.layouts[batch.layout]
    impulse = impulse_of(purpose)
    assemble(d, batch)
    if layout.bounded == 1:
        keep_beginning(d, batch, impulse)
    going = who
    settled = who & ~who
    again = settled
    for turn in range(_TURNS):
        if purpose == MOVE:
            _foresee(d, batch, seconds)
        changed = choose_rows(d, batch, seconds, purpose, going)
        if turn > 0:
            settled = settled | (going & ~(changed | again))
            going = going & ~settled
            if not any_lane(going):
                break
            again = changed  # then the pose looked at was that of a wrong guess
        if turn == 0 or any_lane(changed):
            factorize(d, batch)
        solve_directly(d, batch, impulse, going)
        cap_pairs(d, batch, seconds, purpose, going)
        if layout.bounded == 0:
            return going
    if any_lane(going):
        descend(d, batch, seconds, purpose, going)
    return settled

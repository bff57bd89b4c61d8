"""Stage: the islands of a substep level, from colouring to the impulses that the next step begins with.

They are solved in batches (`active.island_batches`): the first by all workers together, each of the others by whichever
worker takes it.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from sandbox._atomics import atomic_add
from sandbox._jit import kernel
from sandbox.engine.active.free_bodies import put_free_last
from sandbox.engine.active.island_batches import form_batches, sort_impacts, worth_batches
from sandbox.engine.bodies.integrate import prepare_forces
from sandbox.engine.contact_solver.blocks import BLOCK_SIZE
from sandbox.engine.contact_solver.closing_speed import bounce_threshold
from sandbox.engine.contact_solver.fill_blocks import fill_blocks, sort_contacts
from sandbox.engine.contact_solver.graph_coloring import color_contacts
from sandbox.engine.contact_solver.impact_criteria import ImpactCriteria
from sandbox.engine.contact_solver.prepare import prepare_contacts
from sandbox.engine.contact_solver.soft_constraint import contact_spring
from sandbox.engine.contact_solver.store import store_impulses
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.batches import BLOCKS
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.ccd import NEW, STRUCK
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import FROZEN, NUMBERS, Workers
from sandbox.engine.restitution.impact_list import list_impact_contacts
from sandbox.engine.restitution.simultaneous import forget_passes
from sandbox.engine.restitution.worklist import link_contacts
from sandbox.engine.substeps import Pass, run_substeps
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import IMPACT_SPEED, IMPACTS, LEVEL, SOLVE_ISLANDS, UNSETTLED


class Level(NamedTuple):
    """A substep level: its number, whether there are others, and the square of the speed (m/s) of the fastest point of
    any body."""

    number: int
    mixed: bool
    fastest: float


class Share(NamedTuple):
    """What all batches of a level have in common: whether some contact may have an impact, past which speed (m/s)
    those without restitution have one, and the bits of `unsettled` that some body of the level has. `colors` says how
    many colours there are, and is 0 to those who do not solve batch 0: only that has contacts without one."""

    level: int
    impacts: bool
    impact_speed: float
    unsettled: int
    colors: int


@kernel
def solve_level(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
    level: Level,
) -> int:
    """Colour, solve and store the contacts of the islands of a substep level; returns the number of colours."""
    number = level.number
    batches = blocks.batches
    rows = active.bodies[1 : 1 + active.bodies[0]]
    worth = worth_batches(contacts.active[0].contact, batches)
    colors, bits = color_contacts(state.bodies, active, solver, contacts, number, level.mixed, worth, blocks)
    count = form_batches(rows, solver, state.drags, joints, number, level.mixed, worth, batches)
    sort_contacts(contacts, solver.batches, blocks, count)
    impacts = _list_impacts(state, solver, contacts, blocks, level, count)
    share = Share(number, impacts > 0 or bits & STRUCK != 0, active.info[0].impact_speed, bits, colors)
    _tell(workers, share)
    first = 0
    end = 1
    while first < end:
        solve_batches(state, active, solver, contacts, blocks, joints, workers, share, first, end)
        if first > 0:
            first, end = next_part(workers, first, end)
        elif count > 1:
            first, end = first_part(workers, SOLVE_ISLANDS, 1, count)
        else:
            first = end
    state.counters[0].frozen_count += workers.words[FROZEN]
    return int(colors)


@kernel
def _list_impacts(
    state: StateTables,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    level: Level,
    count: int,
) -> int:
    """List the contacts that may have an impact, by batch; returns how many there are."""
    batches = blocks.batches
    threshold = bounce_threshold(state.settings[0])
    found = list_impact_contacts(state.bodies, solver, contacts, level.number, level.fastest, threshold, blocks.spare)
    sort_impacts(blocks.spare, found, solver.batches, batches, count)
    return int(found)


@kernel
def _tell(workers: Workers, share: Share) -> None:
    """Tell who solves islands what all batches share."""
    workers.words[FROZEN] = 0
    workers.numbers[LEVEL] = share.level
    workers.numbers[IMPACTS] = 1.0 if share.impacts else 0.0
    workers.numbers[IMPACT_SPEED] = share.impact_speed
    workers.numbers[UNSETTLED] = share.unsettled


@kernel
def told_share(workers: Workers) -> Share:
    """What those who solve islands were told."""
    n = workers.numbers
    return Share(int(n[LEVEL]), n[IMPACTS] > 0.0, n[IMPACT_SPEED], int(n[UNSETTLED]), 0)


@kernel
def solve_batches(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
    share: Share,
    first: int,
    end: int,
) -> None:
    """Solve the batches first..end-1 as worker `workers.number`: batch 0 with all others, any other one alone."""
    batches = blocks.batches
    own = _own_blocks(blocks, workers.number)
    team = _team(workers, first > 0)
    bodies = state.bodies
    level = share.level
    setting = state.settings[0]
    spring = contact_spring(setting, level)
    seconds = setting.step_seconds / (setting.substeps << level)
    frozen = 0
    for batch in range(first, end):
        members = batches.bodies[batches.first_body[batch] : batches.first_body[batch + 1]]
        touched, held = put_free_last(members, solver, state.drags, joints, share.colors)
        start = batches.first_impact[batch]
        stop = batches.first_impact[batch + 1]
        rows: Any = batches.impacts[start:stop]
        slots: Any = batches.impact_slots[start:stop]
        link_contacts(bodies, slots, stop - start, solver)
        forget_passes(rows)
        ranges = fill_blocks(solver.colors, own, batch)
        criteria = ImpactCriteria(share.impacts, ranges.struck, share.impact_speed)
        # It reads rows of bodies one after the other, which contacts then find in the cache.
        prepare_forces(bodies, members[:held], solver, setting, seconds, team)
        prepare_contacts(state, solver, contacts.now, own, ranges.total, team, spring, criteria)
        todo = Pass(level, batch, touched, held, ranges, share.unsettled & NEW != 0, share.impacts)
        frozen += run_substeps(state, active, solver, contacts, own, joints, team, members, todo)
        store_impulses(state, solver, contacts, own, ranges.total, team, spring)
    if frozen > 0:
        atomic_add(workers.words, FROZEN, frozen)


@kernel
def _team(workers: Workers, alone: bool) -> Workers:
    """Whom a worker divides its tasks with: all others, or nobody."""
    n = workers.number
    return Workers(
        workers.alone if alone else workers.words,
        workers.numbers[n * NUMBERS :] if alone else workers.numbers,
        n,
        workers.alone,
    )


@kernel
def _own_blocks(blocks: ContactBlocks, number: int) -> ContactBlocks:
    """The memory in which a worker solves: the first one has that of the step."""
    batches = blocks.batches
    first = (number - 1) * BLOCKS
    rows: Any = batches.blocks[first : first + BLOCKS] if number > 0 else blocks.blocks
    return ContactBlocks(
        blocks.slots,
        rows,
        blocks.colors,
        batches.lanes[first * BLOCK_SIZE : (first + BLOCKS) * BLOCK_SIZE] if number > 0 else blocks.lanes,
        batches.starts[(number - 1) * (BLOCKS + 2) : number * (BLOCKS + 2)] if number > 0 else blocks.starts,
        blocks.heads,
        blocks.further,
        blocks.further_heads,
        blocks.sets,
        blocks.spare,
        batches,
    )

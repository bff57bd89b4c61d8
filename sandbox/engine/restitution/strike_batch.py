"""The impacts of a batch of islands, as machine code of its own, which only worlds with restitution need.

The substeps call it by its address (`_calls.py`): it is a third of all that moves bodies, and would be compiled into
every version of that. Who calls it leaves word in the memory of his worker.
"""

from __future__ import annotations

from typing import Any

from sandbox._calls import BLOCK, CODE, call_nothing
from sandbox._jit import entry_point, kernel
from sandbox.engine.contact_solver.closing_speed import bounce_threshold
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import NUMBERS, Workers
from sandbox.engine.restitution.impact_list import ImpactList, may_strike
from sandbox.engine.restitution.impacts import resolve_impacts
from sandbox.engine.restitution.jointed.strike import strike_through_joints
from sandbox.engine.workers.task_kinds import BATCH, IMPACT_SECONDS


@kernel
def lacks_impacts(contacts: Contacts, fastest: float, threshold: float) -> bool:
    """Whether some contact may have an impact (`list_impact_contacts`), for which no machine code is there."""
    if contacts.impact_calls[0, CODE] != 0 or not may_strike(fastest, threshold):
        return False
    candidates = contacts.impact_candidates
    highest = 0.0
    for k in candidates[1 : 1 + candidates[0]]:
        restitution = contacts.now[k].restitution
        highest = restitution if restitution > highest else highest
    return bool(highest > 0.0)


@kernel
def call_strikes(contacts: Contacts, workers: Workers, batch: int, seconds: float) -> None:
    """Run `strike_batch` as worker `workers.number`, whose own numbers `workers.numbers` begin with."""
    workers.numbers[BATCH] = batch
    workers.numbers[IMPACT_SECONDS] = seconds
    call = contacts.impact_calls[workers.number]
    call_nothing(call[CODE], call[BLOCK])


@entry_point
def strike_batch(
    state: StateTables,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork | None,
    workers: Workers,
) -> None:
    """Resolve the impacts within a substep of the batch that worker `workers.number` solves, and let joints pass them
    on."""
    told: Any = workers.numbers[workers.number * NUMBERS :]
    batch = int(told[BATCH])
    seconds = told[IMPACT_SECONDS]
    batches = blocks.batches
    first = batches.first_impact[batch]
    end = batches.first_impact[batch + 1]
    rows: Any = batches.impacts[first:end]
    slots: Any = batches.impact_slots[first:end]
    impacts = ImpactList(rows, slots, end - first, bounce_threshold(state.settings[0]))
    resolve_impacts(state.bodies, solver, contacts.now, impacts, seconds)
    if joints is not None and batch == 0:
        strike_through_joints(state.bodies, solver, contacts.now, impacts, joints, seconds)

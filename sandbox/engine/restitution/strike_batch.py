"""The impacts of a batch of islands, as machine code of its own, which only worlds with restitution need.

The substeps call it by its address (`_calls.py`): it is a third of all that moves bodies. Who calls it leaves word in
the memory of his worker. So does it with what joints pass on (`jointed/strike.py`).
"""

from __future__ import annotations

from typing import Any

from sandbox._calls import BLOCK, CODE, call_nothing
from sandbox._jit import entry_point, kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.calls import IMPACTS, JOINT_IMPACTS
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import NUMBERS, Workers
from sandbox.engine.restitution.impact_list import listed_impacts, may_strike
from sandbox.engine.restitution.impacts import resolve_impacts
from sandbox.engine.workers.task_kinds import BATCH, IMPACT_SECONDS


@kernel
def lacks_impacts(contacts: Contacts, fastest: float, threshold: float) -> bool:
    """Whether some contact may have an impact (`list_impact_contacts`), for which no machine code is there."""
    if contacts.calls[0, IMPACTS, CODE] != 0 or not may_strike(fastest, threshold):
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
    calls = contacts.calls[workers.number]
    call_nothing(calls[IMPACTS, CODE], calls[IMPACTS, BLOCK])


@entry_point
def strike_batch(
    state: StateTables,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    workers: Workers,
) -> None:
    """Resolve the impacts within a substep of the batch that worker `workers.number` solves, and let joints pass them
    on."""
    told: Any = workers.numbers[workers.number * NUMBERS :]
    batch = int(told[BATCH])
    impacts = listed_impacts(state, blocks, batch)
    resolve_impacts(state.bodies, solver, contacts.now, impacts, told[IMPACT_SECONDS])
    calls = contacts.calls[0]
    if batch == 0 and calls[JOINT_IMPACTS, CODE] != 0:
        call_nothing(calls[JOINT_IMPACTS, CODE], calls[JOINT_IMPACTS, BLOCK])

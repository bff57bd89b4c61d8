"""The contacts that may have an impact in a step."""

from __future__ import annotations

from typing import Any, NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.substep_level import contact_substep_level
from sandbox.engine.contact_solver.closing_speed import bounce_threshold
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.tables import Records


class ImpactList(NamedTuple):
    """The contacts that may have an impact in a step: `slots[:length]`, as `IMPACT_SLOT`, and what else they need, as
    `IMPACT`, in `rows`; and the speed (m/s) below which none has one."""

    rows: Records
    slots: Records
    length: int
    threshold: float


@inlined_kernel
def may_strike(fastest: float, threshold: float) -> bool:
    """Whether any two bodies can close as fast as the threshold (m/s); `fastest` is the square of the highest speed
    (m/s) of a point."""
    return fastest > 0.25 * threshold * threshold


@kernel
def listed_impacts(state: StateTables, blocks: ContactBlocks, batch: int) -> ImpactList:
    """The contacts of a batch of islands that may have an impact."""
    batches = blocks.batches
    first = batches.first_impact[batch]
    end = batches.first_impact[batch + 1]
    rows: Any = batches.impacts[first:end]
    slots: Any = batches.impact_slots[first:end]
    return ImpactList(rows, slots, end - first, bounce_threshold(state.settings[0]))


@kernel
def list_impact_contacts(
    bodies: Records,
    solver: SolverBodies,
    contacts: Contacts,
    substep_level: int,
    fastest: float,
    threshold: float,
    slots: Records,
) -> int:
    """List the contacts of a substep level that may strike, or none when no body is fast enough for any to matter.

    Those are the `impact_candidates` (see `decision_bits`) with restitution. `fastest` is the square of the highest
    speed (m/s) of a point. Returns how many `slots` are used.
    """
    used = 0
    candidates = contacts.impact_candidates
    if not may_strike(fastest, threshold):
        return 0
    for k in range(1, candidates[0] + 1):
        contact = contacts.now[candidates[k]]
        level = contact_substep_level(bodies, solver.free_motions, contact)
        if contact.restitution > 0.0 and level == substep_level:
            slot = slots[used]
            slot.contact = candidates[k]
            slot.body_a = contact.body_a
            slot.body_b = contact.body_b
            used += 1
    return used

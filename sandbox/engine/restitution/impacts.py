"""Stage: impacts. Those that fall into a substep are resolved before the solver makes them inelastic.

Those without restitution are stopped all at once, afterwards (`inelastic.py`).
Contacts strike one after the other until none closes faster than the threshold (`in_turn.py`), so that an impact runs
through a row of balls as it does through Newton's cradle; what falls on a body in the same moment strikes together.
Where that does not end, as a light body rattles between heavy ones, those that have struck strike together instead
(`simultaneous.py`). The two points of a manifold always do, so that a flat box leaves flat. The rebound speed comes
from the energy at the surface, not at the place where the step happens to catch the body, so that a bounce neither
gains nor loses height.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import form_groups, note_first_strike, starts_group
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.in_turn import strike_in_turn
from sandbox.engine.restitution.rebound_speed import closes, rebound_speed
from sandbox.engine.restitution.simultaneous import strike_group
from sandbox.tables import Records

_MOST_WORK = 15_000
"""Passes times contacts of those that rattle in a substep: what is left goes to the contact solver."""
_ROUNDS = 32
"""In which groups strike together: most end with the first few."""


@kernel
def resolve_impacts(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, seconds: float
) -> None:
    """Strike every listed contact that closes within the substep, again and again until none is left.

    Negative `seconds` look back: contacts that have come into each other, unforeseen, within the substep that just
    moved everything. Corners of a spinning body do that: their speeds change while it turns, and the relax pass would
    stop them dead. Groups that do not come to an end in turn are taken back, and strike together.
    """
    if strike_in_turn(bodies, solver, contacts, impacts, seconds):
        return
    work = 0
    for turn in range(_ROUNDS):
        if work >= _MOST_WORK or not _add_closing(bodies, solver, contacts, impacts, seconds):
            return
        form_groups(bodies, impacts, solver.struck)
        for k in range(impacts.length):
            if starts_group(impacts, k, solver.struck):
                work += strike_group(bodies, solver, contacts, impacts, k, turn == 0, _MOST_WORK - work)


@kernel
def _add_closing(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, seconds: float) -> bool:
    """Let contacts that close strike too, and return whether there are any."""
    found = False
    for k in range(impacts.length):
        slot = impacts.slots[k]
        contact = contacts[slot.contact]
        if closes(rebound_speed(solver, contact, slot, impacts.threshold, seconds)):
            note_first_strike(bodies, solver, contact, impacts.rows[k])
            found = True
    return found

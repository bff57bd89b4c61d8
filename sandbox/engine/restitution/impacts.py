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
from sandbox.engine.restitution.add_closing import add_closing
from sandbox.engine.restitution.groups import form_groups, starts_group
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.in_turn import strike_in_turn
from sandbox.engine.restitution.simultaneous import strike_group
from sandbox.tables import Records

_ROUNDS = 16
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
    for turn in range(_ROUNDS):
        if not add_closing(bodies, solver, contacts, impacts, seconds, 1 << turn):
            return
        form_groups(bodies, impacts, solver.struck)
        struck = False
        for k in range(impacts.length):
            if starts_group(impacts, k, solver.struck):
                struck = strike_group(bodies, solver, contacts, impacts, k, turn == 0) or struck
        if not struck:
            return

"""Which impacts of a turn come first on the bodies that they share."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import MARKS
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

JOINED, LATER = -2, -3
"""How a contact that closes is to others of its turn with which it shares a moving body: some close in the same moment,
or some earlier. `END` if it is the only one."""


@kernel
def note_closing(bodies: Records, solver: SolverBodies, slot: Records, moment: float, turn: int) -> None:
    """Note for the moving bodies of a contact that it closes at a moment (s), in a turn."""
    for i in (slot.body_a, slot.body_b):
        if bodies[i].type == DYNAMIC:
            here = solver.impact_bodies[i]
            if solver.struck[i] & ~MARKS != turn:
                solver.struck[i] = solver.struck[i] & MARKS | turn
                here.moment = moment
                here.closing = 1
            else:
                here.moment = moment if moment < here.moment else here.moment
                here.closing += 1


@inlined_kernel
def relation_to_others(bodies: Records, solver: SolverBodies, slot: Records, moment: float, same: float) -> int:
    """How a contact that closes at a moment (s) is to others of its turn; `same` (s) is what counts as one moment."""
    relation = END
    for i in (slot.body_a, slot.body_b):
        if bodies[i].type == DYNAMIC:
            here = solver.impact_bodies[i]
            if here.moment < moment - same:
                return LATER
            relation = JOINED if here.closing > 1 else relation
    return relation

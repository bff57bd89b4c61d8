"""Impacts that strike together: where one by one does not end, as a light body rattles between heavy ones.

The impulses that would stop the group (`stop_group.py`) come with as much more as restitution gives back, scaled
so that none gains energy (`rebound.py`). As impulses only push and energy is bounded, what closes ends.

Source: J. J. Moreau 1985 (restitution of all contacts at once); B. Smith, D. Kaufman, E. Vouga, R. Tamstorf and E.
Grinspun, "Reflections on simultaneous impact", ACM Transactions on Graphics 31 (2012).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_driving
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import start_velocity
from sandbox.engine.contact_solver.nesterov import passes_within
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import next_of, size_of, take_back
from sandbox.engine.restitution.rebound import rebound
from sandbox.engine.restitution.stop_group import stop_group
from sandbox.tables import Records

MOST_PASSES = 256
LEAST_PASSES = 16
"""What a group is given at least, or it is left to the contact solver."""
AGREED = 1e-3
"""Change of velocity by a pass at any contact, as a share of the highest closing speed, below which it was the last."""


@kernel
def strike_group(
    bodies: Records, solver: SolverBodies, contacts: Records, group: Records, threshold: float, anew: bool, most: int
) -> int:
    """Strike the group of impacts that begins with `group[0]`, if one closes faster than the threshold (m/s).

    `anew` takes back what they have done in the substep so far. Returns how much work that was, passes times contacts,
    of `most`; a group for which that is too little is left as it is, and was the last one. So is one that a kinematic
    body drives, which may press it against something immovable: nothing bounds its energy.
    """
    count = size_of(group)
    if LEAST_PASSES * count > most:
        return most
    if _is_driven(bodies, group) or _fastest(solver, contacts, group) <= threshold:
        return count
    if anew:
        take_back(bodies, solver, contacts, group)
    agreed = AGREED * _fastest(solver, contacts, group)
    passes = stop_group(bodies, solver, contacts, group, agreed, passes_within(most, count, MOST_PASSES))
    rebound(bodies, solver, contacts, group)
    return passes * count


@kernel
def _is_driven(bodies: Records, group: Records) -> bool:
    """Whether something without mass that moves strikes too."""
    k = 0
    while k >= 0:
        if is_driving(bodies[group[k].body_a]) or is_driving(bodies[group[k].body_b]):
            return True
        k = next_of(group, k)
    return False


@kernel
def _fastest(solver: SolverBodies, contacts: Records, group: Records) -> float:
    """The highest closing speed (m/s)."""
    fastest = 0.0
    k = 0
    while k >= 0:
        contact = contacts[group[k].contact]
        start = start_velocity(solver.free_motions, contact)
        for point in range(1, contact.point_count + 1):
            closing = -opening_speed(start, contact, point)
            fastest = closing if closing > fastest else fastest
        k = next_of(group, k)
    return fastest

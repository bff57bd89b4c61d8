"""Stage: islands that the usual substeps cannot hold are given more of them.

Those are piles that would buckle or be crushed (`pile_stability.py`, of what `pile_measures.py` finds). Small jointed
parts that swing freely get more as well, for the sake of truth (`joints/fine_substeps.py`).
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.active.bearable_mass import masses_differ
from sandbox.engine.active.islands import find_islands
from sandbox.engine.active.pile_measures import is_stacked, measure_bodies, measure_contacts
from sandbox.engine.active.pile_stability import level_for, some_pile_may_fall
from sandbox.engine.active.pile_support import Load, measure_support
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.geometry.trig import PI
from sandbox.tables import Integers, Records

EVERY = 8
"""Steps from one look at piles to the next, while no pile needs a level and none can come to bear a heavy body."""
SELDOM = 1
"""`counter.substep_watch`: look every so many steps."""
ALWAYS = 2
"""`counter.substep_watch`: look at every step."""


@kernel
def assign_substep_levels(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    piles: Records,
    contacts: Contacts,
    joints: JointWork,
) -> int:
    """Write `free_motion.substep_level`, which is 0, for the bodies of piles which need one, as they might fall.

    Returns the levels in use, as bits.

    A look at the piles costs a pass over all contacts, and piles buckle slowly: where masses are alike and no pile
    needs a level, every eighth step is enough. `counter.substep_watch` remembers that; commands set it to 0, unknown.
    """
    rows = active.bodies[1 : 1 + active.bodies[0]]
    counter = state.counters[0]
    setting = state.settings[0]
    if counter.substep_watch == SELDOM and counter.step_count % EVERY != 0:
        return 1
    gravity_x = setting.gravity_x
    gravity_y = setting.gravity_y
    gravity = math.sqrt(gravity_x * gravity_x + gravity_y * gravity_y)
    omega = 2.0 * PI * setting.contact_hertz
    used = 1
    if gravity > 0.0:
        find_islands(state.bodies, rows, solver.islands, contacts, joints)
        seconds = setting.step_seconds / setting.substeps if counter.substep_levels > 0 else 0.0
        load = Load(gravity_x / gravity, gravity_y / gravity, gravity, omega, seconds, setting.units_per_meter)
        used = _look(state, rows, solver, piles, contacts, joints, load, counter.substep_levels)
    counter.substep_levels = used
    differ = used > 1 or masses_differ(state.bodies, active.info[0], gravity, omega, setting.units_per_meter)
    counter.substep_watch = ALWAYS if differ else SELDOM
    return used


@kernel
def _look(
    state: StateTables,
    rows: Integers,
    solver: SolverBodies,
    piles: Records,
    contacts: Contacts,
    joints: JointWork,
    load: Load,
    had_levels: int,
) -> int:
    """Bodies alone show that most islands are safe; only if one may not be, contacts are looked at too.

    Or if one was not in the last step, in which piles had the levels `had_levels`, as bits.
    """
    bodies = state.bodies
    measure_bodies(bodies, rows, solver.islands, piles, joints, load)
    if had_levels <= 1 and not some_pile_may_fall(rows, solver.islands, piles, load):
        return 1
    measure_support(bodies, rows, solver.islands, piles, joints, state.drags, load)
    measure_contacts(bodies, rows, solver.islands, piles, contacts, joints, load)
    used = 1
    for i in rows:
        pile = piles[solver.islands[i]]
        if is_active(bodies[i]) and is_stacked(pile):
            solver.free_motions[i].substep_level = level_for(pile, load)
            used |= 1 << solver.free_motions[i].substep_level
    return used


@kernel
def contact_substep_level(bodies: Records, free_motions: Records, contact: Records) -> int:
    """The substep level a contact is solved at; -1 among bodies that are not moved."""
    if is_active(bodies[contact.body_a]):
        level: int = free_motions[contact.body_a].substep_level
        return level
    if is_active(bodies[contact.body_b]):
        other: int = free_motions[contact.body_b].substep_level
        return other
    return -1

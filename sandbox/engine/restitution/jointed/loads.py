"""The loads of impacts on jointed bodies, and their friction: of one linear complementarity problem.

Its matrix is what joints pass on of each impulse (`delassus.py`), with the stops that are held; these are guessed, and
looked at once all loads have been passed on together. It is solved by passes over the contacts, a block of two points
each.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.law import clamp_to_cone
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.jointed.delassus import AXES, TANGENT, WIDE, add_impulses, fill_matrix, note_speeds
from sandbox.engine.restitution.jointed.give import push_loads
from sandbox.engine.restitution.jointed.reach import (
    Reach,
    begin_pushes,
    count_passes,
    holds_matrix,
    reach_stops,
    work_left,
)
from sandbox.engine.restitution.two_point_block import Block, bearing_impulses
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Floats, Records

MOST_GUESSES = 4
"""At the stops that hold; what is wrong with the last one is left to how large a share of the loads is given."""
_MOST_PASSES = 256
IMMOVABLE = 1e-9
"""A point that an impulse moves by this share of what it moves free bodies by is held by joints alone."""


@kernel
def solve_jointed(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    rough: bool,
    agreed: float,
    reach: Reach,
) -> None:
    """Find the loads as `solve_group` does, to `agreed` (m/s), of contacts on what reaches further by joints."""
    for _ in range(MOST_GUESSES):
        begin_pushes(bodies, solver, impacts, first, reach)
        note_speeds(bodies, solver, contacts, impacts, first)
        if not holds_matrix(reach):
            fill_matrix(bodies, solver, contacts, impacts, first, reach)
        if reach_stops(solver, reach):
            note_speeds(bodies, solver, contacts, impacts, first)
        count_passes(reach, _solve(bodies, contacts, impacts, first, rough, agreed, reach.work.direct.delassus))
        push_loads(bodies, solver, contacts, impacts, first, 1.0, reach)
        if holds_matrix(reach) or work_left(reach) <= 0:
            break


@kernel
def _solve(
    bodies: Records, contacts: Records, impacts: ImpactList, first: int, rough: bool, agreed: float, m: Floats
) -> int:
    """Passes from no impulses until they change no speed by more than `agreed` (m/s); returns how many contacts they
    went over."""
    count = 0
    k = first
    while k != END:
        row = impacts.rows[k]
        row.load1 = row.load2 = row.drag = 0.0
        count += 1
        k = row.next
    for turn in range(_MOST_PASSES):
        largest = 0.0
        column = 0
        k = first
        while k != END:
            contact = contacts[impacts.slots[k].contact]
            least = IMMOVABLE * (bodies[contact.body_a].inverse_mass + bodies[contact.body_b].inverse_mass)
            change = _solve_contact(contact, impacts, first, k, column, rough, least, m)
            largest = change if change > largest else largest
            column += AXES
            k = impacts.rows[k].next
        if largest <= agreed:
            return (turn + 1) * count
    return _MOST_PASSES * count


@kernel
def _solve_contact(
    contact: Records, impacts: ImpactList, first: int, k: int, column: int, rough: bool, least: float, m: Floats
) -> float:
    """Give a contact the impulses that it asks for, none of them pulling; returns by how much they change its speeds
    (m/s). What moves by less than `least` (1/kg) is immovable."""
    row = impacts.rows[k]
    at = column * WIDE + column
    block = _block(m, at)
    moved = 0.0
    if block.k11 > least:
        ask1 = row.rebound1 - row.opening1 + block.k11 * row.load1 + block.k12 * row.load2
        load1 = block.mass1 * ask1 if ask1 > 0.0 else 0.0
        load2 = 0.0
        if contact.point_count == 2 and block.k22 > least:
            ask2 = row.rebound2 - row.opening2 + block.k12 * row.load1 + block.k22 * row.load2
            load1, load2 = bearing_impulses(block, ask1, ask2)
        added1 = load1 - row.load1
        added2 = load2 - row.load2
        row.load1 = load1
        row.load2 = load2
        moved = block.k11 * abs(added1) + block.k22 * abs(added2)
        add_impulses(impacts, first, m, column, added1, added2, 0.0)
    stiffness = m[at + TANGENT * WIDE + TANGENT]
    if rough and contact.friction > 0.0 and stiffness > least:
        limit = contact.friction * (row.load1 + row.load2)
        drag = clamp_to_cone(row.drag - row.slip / stiffness, limit)
        if row.slides != 0.0:
            drag = -row.slides * limit
        added = drag - row.drag
        row.drag = drag
        moved += stiffness * abs(added)
        add_impulses(impacts, first, m, column, 0.0, 0.0, added)
    return float(moved)


@inlined_kernel
def _block(m: Floats, at: int) -> Block:
    """The block of the two points of the contact whose part of the matrix begins there."""
    k11 = m[at]
    k12 = 0.5 * (m[at + 1] + m[at + WIDE])
    k22 = m[at + WIDE + 1]
    mass1 = 1.0 / k11 if k11 > 0.0 else 0.0
    mass2 = 1.0 / k22 if k22 > 0.0 else 0.0
    return Block(mass1, mass2, k11, k12, k22, k11 * k22 - k12 * k12)

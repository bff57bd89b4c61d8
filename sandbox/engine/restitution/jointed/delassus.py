"""The Delassus matrix of a group of impacts: what an impulse at each contact changes the speeds at all of them.

J M^-1 J^T of free bodies, less what their joints take of it. Column by column it is what joints pass on of an impulse,
with the stops held that were held last: so it is for as long as these are the same. What such stops do without any
impulse, as what they hold comes to them within the substep, is no part of it, but of the speeds to which it adds.

Source: E. Delassus, "Memoire sur la theorie des liaisons finies unilaterales", Annales scientifiques de l'Ecole Normale
Superieure 34 (1917).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import anchors_of, apply_impulse, pair_mass, pair_velocity, start_velocity
from sandbox.engine.joints.direct.records import MOST_STRUCK
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import rub_between, slip_speed
from sandbox.engine.restitution.jointed.reach import Reach, forget_push, hold_matrix, pass_on_from
from sandbox.engine.restitution.solve_group import set_velocity
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Floats, Records

FIRST, SECOND, TANGENT = 0, 1, 2
AXES = 3
"""Rows of a contact: the normals at both points, and the tangent."""
WIDE = AXES * MOST_STRUCK
"""Length of a row of the matrix."""


@kernel
def note_speeds(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> None:
    """Note how fast the points of the contacts linked from impact `first` on open, and how fast they slide, by the
    velocities in `solver.motions`."""
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        row.opening1 = opening_speed(now, contact, 1)
        row.opening2 = opening_speed(now, contact, 2) if contact.point_count == 2 else 0.0
        row.slip = (
            slip_speed(now, rub_between(bodies[contact.body_a], bodies[contact.body_b], contact))
            - contact.surface_speed
        )
        k = row.next


@kernel
def fill_matrix(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, reach: Reach
) -> None:
    """Work out the matrix of the contacts linked from impact `first` on. In: their speeds, and `solver.motions`, both
    at the start of the substep, where the latter are left."""
    column = 0
    k = first
    while k != END:
        contact = contacts[impacts.slots[k].contact]
        for axis in range(AXES):
            acts = contact.point_count == 2 if axis == SECOND else axis == FIRST or contact.friction > 0.0
            if acts:
                size = _push(bodies, solver, contact, axis, reach.work.direct.units[0])
                pass_on_from(solver, contact, reach)
                _note_column(bodies, solver, contacts, impacts, first, reach, column + axis, size)
                forget_push(solver, contact, reach)
            else:
                _clear_column(impacts, first, reach, column + axis)
        column += AXES
        k = impacts.rows[k].next
    hold_matrix(reach)


@kernel
def _push(bodies: Records, solver: SolverBodies, contact: Records, axis: int, metre: float) -> float:
    """Give an impulse along one of the axes of a contact that changes speeds by some `metre` a second, however many
    units of length that is; returns how large it is (N s)."""
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    size = metre / (mass.mass_a + mass.mass_b)
    anchors = anchors_of(contact, 2 if axis == SECOND else 1)
    x = contact.normal_x
    y = contact.normal_y
    if axis == TANGENT:
        rub = rub_between(bodies[contact.body_a], bodies[contact.body_b], contact)
        anchors = rub.anchors
        x = rub.tangent_x
        y = rub.tangent_y
    start = start_velocity(solver.free_motions, contact)
    set_velocity(solver.motions, contact, apply_impulse(start, mass, anchors, size * x, size * y))
    return float(size)


@kernel
def _note_column(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    reach: Reach,
    column: int,
    size: float,
) -> None:
    """Write what an impulse of so many N s has changed at each contact."""
    m = reach.work.direct.delassus
    place = column
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        m[place] = (opening_speed(now, contact, 1) - row.opening1) / size
        m[place + WIDE] = (opening_speed(now, contact, 2) - row.opening2) / size if contact.point_count == 2 else 0.0
        slip = (
            slip_speed(now, rub_between(bodies[contact.body_a], bodies[contact.body_b], contact))
            - contact.surface_speed
        )
        m[place + 2 * WIDE] = (slip - row.slip) / size
        place += AXES * WIDE
        k = row.next


@kernel
def _clear_column(impacts: ImpactList, first: int, reach: Reach, column: int) -> None:
    """Nothing acts along an axis."""
    m = reach.work.direct.delassus
    place = column
    k = first
    while k != END:
        for axis in range(AXES):
            m[place + axis * WIDE] = 0.0
        place += AXES * WIDE
        k = impacts.rows[k].next


@kernel
def add_impulses(
    impacts: ImpactList, first: int, m: Floats, column: int, load1: float, load2: float, drag: float
) -> None:
    """Add what impulses (N s) at the contact whose columns begin there change the speeds at all."""
    place = column
    k = first
    while k != END:
        row = impacts.rows[k]
        row.opening1 += m[place] * load1 + m[place + 1] * load2 + m[place + 2] * drag
        row.opening2 += m[place + WIDE] * load1 + m[place + WIDE + 1] * load2 + m[place + WIDE + 2] * drag
        row.slip += m[place + 2 * WIDE] * load1 + m[place + 2 * WIDE + 1] * load2 + m[place + 2 * WIDE + 2] * drag
        place += AXES * WIDE
        k = row.next

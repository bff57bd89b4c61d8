"""Friction of impacts on jointed bodies, which joints pass on: found in rounds, as normal loads are."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.law import apply_impulse, clamp_to_cone, pair_mass, pair_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.impulses import rub_of, slip_speed
from sandbox.engine.restitution.jointed.give import give, push_loads
from sandbox.engine.restitution.jointed.reach import Reach, pass_on
from sandbox.engine.restitution.jointed.step_length import best_share, until
from sandbox.engine.restitution.solve_group import set_velocity
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

_ROUNDS = 16


@kernel
def rub_jointed(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    part: float,
    agreed: float,
    reach: Reach,
) -> None:
    """Apply the friction that a part of the loads allows, `drag`, of the group that is linked from impact `first` on:
    rounds until none changes by more than the share `agreed` of its load."""
    for _ in range(_ROUNDS):
        push_loads(bodies, solver, contacts, impacts, first, 0.0, 1.0, reach)
        _note_slips(bodies, solver, contacts, impacts, first)
        if not _rub(bodies, solver, contacts, impacts, first, part, agreed):
            break
        pass_on(solver, reach)
        share = _share_of(bodies, solver, contacts, impacts, first, part)
        k = first
        while k != END:
            row = impacts.rows[k]
            row.drag = row.passed_drag + share * (row.drag - row.passed_drag)
            k = row.next
    give(bodies, solver, contacts, impacts, first, 0.0, 0.0, reach)


@kernel
def _note_slips(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> None:
    """Note what has been passed on, and how fast contacts then slide."""
    k = first
    while k != END:
        row = impacts.rows[k]
        row.passed_drag = row.drag
        row.opening1 = _slip(bodies, solver, contacts[impacts.slots[k].contact], row)
        k = row.next


@inlined_kernel
def _slip(bodies: Records, solver: SolverBodies, contact: Records, row: Records) -> float:
    """How fast (m/s) a contact slides by the velocities in `solver.motions`."""
    rub = rub_of(bodies[contact.body_a], bodies[contact.body_b], contact, row.load1, row.load2)
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    return float(slip_speed(now, rub) - contact.surface_speed)


@kernel
def _rub(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    part: float,
    agreed: float,
) -> bool:
    """Stop the sliding of each contact as if its bodies were free; return whether that has changed anything."""
    changes = False
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        load = part * (row.load1 + row.load2)
        if contact.friction > 0.0 and load > 0.0:
            a = bodies[contact.body_a]
            b = bodies[contact.body_b]
            rub = rub_of(a, b, contact, row.load1, row.load2)
            now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
            wanted = row.drag - rub.mass * (slip_speed(now, rub) - contact.surface_speed)
            row.drag = clamp_to_cone(wanted, contact.friction * load)
            added = row.drag - row.passed_drag
            x = added * rub.tangent_x
            y = added * rub.tangent_y
            set_velocity(solver.motions, contact, apply_impulse(now, pair_mass(a, b), rub.anchors, x, y))
            changes = changes or abs(added) > agreed * load
        k = row.next
    return changes


@kernel
def _share_of(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, part: float
) -> float:
    """The share of what was added that stops most of the sliding, within Coulomb's law."""
    asked = changed = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        added = row.drag - row.passed_drag
        if added != 0.0:
            now = _slip(bodies, solver, contacts[impacts.slots[k].contact], row)
            asked -= added * row.opening1
            changed += added * (now - row.opening1)
        k = row.next
    share = best_share(asked, changed)
    k = first
    while k != END:
        row = impacts.rows[k]
        added = row.drag - row.passed_drag
        limit = part * contacts[impacts.slots[k].contact].friction * (row.load1 + row.load2)
        share = until(share, added, limit - row.passed_drag)
        share = until(share, -added, limit + row.passed_drag)
        k = row.next
    return share

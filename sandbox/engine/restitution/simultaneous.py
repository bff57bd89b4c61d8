"""Impacts that strike together: where one by one does not end, as a light body rattles between heavy ones.

The impulses that would stop the group are those of the inelastic impact, found by passes that the nonsmooth nonlinear
conjugate gradient makes faster. Then come as much more as restitution gives back: by 1 + e times the impulses, scaled
so that they take the most energy, the group keeps all of it with e = 1 and never gains any, however
exact the passes were. As impulses only push and energy is bounded, what closes ends.

Source: J. J. Moreau 1985 (restitution of all contacts at once); B. Smith, D. Kaufman, E. Vouga, R. Tamstorf and E.
Grinspun, "Reflections on simultaneous impact", ACM Transactions on Graphics 31 (2012); M. Silcowitz, S. Niebe and
K. Erleben, The Visual Computer 26 (2010).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import (
    PairVelocity,
    PointImpulses,
    anchors_of,
    pair_mass,
    pair_velocity,
    push_both,
    relative_velocity,
    start_velocity,
)
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.elastic import rub_struck
from sandbox.engine.restitution.groups import next_of, take_back
from sandbox.engine.restitution.impulses import push_points, put_back, take
from sandbox.engine.restitution.two_point_block import Block, bearing_impulses, one_point, two_points
from sandbox.tables import Records
from sandbox.world.records import KINEMATIC

MOST_PASSES = 256
LEAST_PASSES = 16
MOST_WORK = 15_000
"""Passes times contacts of all groups and rounds of a substep: what is left then is the contact solver's."""
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
    count = _count(group)
    if LEAST_PASSES * count > most:
        return most
    if _is_driven(bodies, group) or _fastest(solver, contacts, group) <= threshold:
        return count
    passes = most // count if most < MOST_PASSES * count else MOST_PASSES
    if anew:
        take_back(bodies, solver, contacts, group)
    _begin(solver, contacts, group)
    passes = _stop(bodies, solver, contacts, group, AGREED * _fastest(solver, contacts, group), passes)
    _rebound(bodies, solver, contacts, group)
    return passes * count


@kernel
def _is_driven(bodies: Records, group: Records) -> bool:
    """Whether something without mass that moves strikes too."""
    k = 0
    while k >= 0:
        for i in (group[k].body_a, group[k].body_b):
            body = bodies[i]
            moves = body.velocity_x != 0.0 or body.velocity_y != 0.0 or body.angular_velocity != 0.0
            if body.type == KINEMATIC and moves:
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
            closing = -_normal_speed(contact, start, point)
            fastest = closing if closing > fastest else fastest
        k = next_of(group, k)
    return fastest


@kernel
def _begin(solver: SolverBodies, contacts: Records, group: Records) -> None:
    """Begin with no impulses, in `solver.motions` with the velocities at the start of the substep."""
    k = 0
    while k >= 0:
        slot = group[k]
        slot.load1 = slot.load2 = slot.search1 = slot.search2 = slot.added1 = slot.added2 = 0.0
        contact = contacts[slot.contact]
        _set_velocity(solver.motions, contact, start_velocity(solver.free_motions, contact))
        k = next_of(group, k)


@kernel
def _stop(bodies: Records, solver: SolverBodies, contacts: Records, group: Records, agreed: float, passes: int) -> int:
    """Find the impulses of the inelastic impact: passes until they change no velocity by more than `agreed` (m/s).

    Returns how many passes that took, of so many.
    """
    last_square = 0.0
    for turn in range(passes):
        square = 0.0
        largest = 0.0
        k = 0
        while k >= 0:
            slot = group[k]
            contact = contacts[slot.contact]
            change = _stop_contact(bodies, solver, contact, slot)
            square += slot.added1 * slot.added1 + slot.added2 * slot.added2
            largest = change if change > largest else largest
            k = next_of(group, k)
        if largest <= agreed or turn == passes - 1:  # the last is a pass, so that no contact pulls
            return turn + 1
        beta = square / last_square if square < last_square else 0.0  # 0 begins anew
        k = 0
        while k >= 0:
            _search(bodies, solver, contacts[group[k].contact], group[k], beta)
            k = next_of(group, k)
        last_square = square
    return passes


@kernel
def _count(group: Records) -> int:
    """How many impacts a group has."""
    count = 0
    k = 0
    while k >= 0:
        count += 1
        k = next_of(group, k)
    return count


@kernel
def _stop_contact(bodies: Records, solver: SolverBodies, contact: Records, slot: Records) -> float:
    """Give a contact the impulses that stop it, none of them pulling; return its change of velocity (m/s)."""
    a = bodies[contact.body_a]
    b = bodies[contact.body_b]
    mass = pair_mass(a, b)
    r1 = anchors_of(contact, 1)
    both = contact.point_count == 2
    block = two_points(contact, mass, r1, anchors_of(contact, 2)) if both else one_point(contact, mass, r1)
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    before1 = slot.load1
    before2 = slot.load2
    ask1 = _alone(block, before1, before2) - _normal_speed(contact, now, 1)
    ask2 = block.k12 * before1 + block.k22 * before2 - _normal_speed(contact, now, 2) if both else 0.0
    load1, load2 = bearing_impulses(block, ask1, ask2)
    added1 = load1 - before1
    added2 = load2 - before2
    slot.load1 = load1
    slot.load2 = load2
    slot.added1 = added1
    slot.added2 = added2
    _push(bodies, solver, contact, added1, added2)
    return float((abs(added1) + abs(added2)) * (mass.mass_a + mass.mass_b))


@kernel
def _alone(block: Block, load1: float, load2: float) -> float:
    """What the impulses of a contact have added to the normal velocity at its point 1."""
    inverse = 1.0 / block.mass1 if block.mass1 > 0.0 else 0.0
    return inverse * load1 + block.k12 * load2


@kernel
def _search(bodies: Records, solver: SolverBodies, contact: Records, slot: Records, beta: float) -> None:
    """Go on by `beta` along the direction searched so far, and turn it by what the last pass has added."""
    more1 = beta * slot.search1
    more2 = beta * slot.search2
    slot.search1 = more1 + slot.added1
    slot.search2 = more2 + slot.added2
    if beta > 0.0:
        slot.load1 += more1
        slot.load2 += more2
        _push(bodies, solver, contact, more1, more2)


@kernel
def _rebound(bodies: Records, solver: SolverBodies, contacts: Records, group: Records) -> None:
    """Apply the impulses with restitution to the velocities of the substep, and then the friction that they allow.

    With loads p, u at the start and w when they have been applied, p u is the work per unit of scale and p (w - u) the
    square: the scale -p u / p (w - u) takes the most energy. Restitution is the mean over what closes, by its work.
    """
    work = square = closed = given = 0.0
    k = 0
    while k >= 0:
        slot = group[k]
        contact = contacts[slot.contact]
        start = start_velocity(solver.free_motions, contact)
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        restitution = contact.restitution if contact.restitution < 1.0 else 1.0
        for point in range(1, contact.point_count + 1):
            load = slot.load1 if point == 1 else slot.load2
            before = _normal_speed(contact, start, point)
            work += load * before
            square += load * (_normal_speed(contact, now, point) - before)
            closed += load * before if before < 0.0 else 0.0
            given += restitution * load * before if before < 0.0 else 0.0
        k = next_of(group, k)
    scale = (1.0 + given / closed) * (-work / square) if work < 0.0 < square else 0.0
    k = 0
    while k >= 0:
        slot = group[k]
        contact = contacts[slot.contact]
        slot.load1 *= scale
        slot.load2 *= scale
        mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
        struck = push_points(take(solver.free_motions, contact), contact, mass, slot.load1, slot.load2)
        put_back(solver, contact, struck)
        contact.impact_impulse += slot.load1 + slot.load2
        k = next_of(group, k)
    k = 0
    while k >= 0:
        slot = group[k]
        rub_struck(bodies, solver, contacts[slot.contact], slot.load1, slot.load2)
        k = next_of(group, k)


@kernel
def _normal_speed(contact: Records, velocity: PairVelocity, point: int) -> float:
    """Speed (m/s) at which a point opens."""
    vx, vy = relative_velocity(velocity, anchors_of(contact, point))
    return float(vx * contact.normal_x + vy * contact.normal_y)


@kernel
def _push(bodies: Records, solver: SolverBodies, contact: Records, load1: float, load2: float) -> None:
    """Apply normal impulses (N s) at both points to `solver.motions`."""
    mass = pair_mass(bodies[contact.body_a], bodies[contact.body_b])
    now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
    r1 = anchors_of(contact, 1)
    r2 = anchors_of(contact, 2)
    loads = PointImpulses(load1, load2)
    _set_velocity(solver.motions, contact, push_both(now, mass, r1, r2, loads, contact.normal_x, contact.normal_y))


@kernel
def _set_velocity(motions: Records, contact: Records, v: PairVelocity) -> None:
    """Write the velocities of a contact's bodies."""
    a = motions[contact.body_a]
    b = motions[contact.body_b]
    a.velocity_x = v.ax
    a.velocity_y = v.ay
    a.angular_velocity = v.aw
    b.velocity_x = v.bx
    b.velocity_y = v.by
    b.angular_velocity = v.bw

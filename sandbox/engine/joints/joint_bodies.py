"""What the joint solver asks of jointed bodies, masses and where they are, and by which velocity it has them move."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import root_of, unite
from sandbox.engine.bodies.flags import JOINTED, is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records

BY_END = 1.0
"""`forces.by_end` of a body that moves by its velocity at the end of a substep,"""
DRIVES = 2.0
"""and of one that a spring drives besides, or that touches one."""


@kernel
def load_members(work: JointWork, bodies: Records, solver: SolverBodies) -> None:
    """Masses and first poses of a step, and flags; a part is awake if the solver moves any of its bodies.

    The world is put to rest: an impulse that is not a number would leave it without a velocity.
    """
    work.members[0].body = solver.motions.shape[0] - 1
    world = solver.motions[work.members[0].body]
    world.velocity_x = world.velocity_y = world.angular_velocity = 0.0
    for p in range(work.parts.shape[0]):
        work.parts[p].awake = 0
    for i in range(1, work.members.shape[0]):
        member = work.members[i]
        body = bodies[member.body]
        moves = is_active(body)
        member.inverse_mass = body.inverse_mass if moves else 0.0
        member.inverse_inertia = body.inverse_inertia if moves else 0.0
        member.start_cos = body.rotation_cos
        member.start_sin = body.rotation_sin
        member.start_angle = body.angle
        member.center_x = body.center_x
        member.center_y = body.center_y
        if moves:
            work.parts[member.part].awake = 1
            solver.flags[member.body] |= JOINTED


@kernel
def part_level(work: JointWork, part: Records, free_motions: Records) -> int:
    """The substep level of a part: that of the first of its bodies which the solver moves."""
    for i in range(part.first_member, part.member_end):
        member = work.members[i]
        if member.inverse_mass > 0.0:
            level: int = free_motions[member.body].substep_level
            return level
    return 0


@kernel
def move_by_end_velocity(work: JointWork, bodies: Records, forces: Records, slots: Records, lowest: Integers) -> None:
    """Let the bodies of current parts move by the velocity they have; others move by its mean with the start.

    What the contacts in `slots` hold together with springs moves as these do: else it would drive them. `lowest` is
    scratch with a row a body.
    """
    springs = False
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1:
            borne = part.direct == 1 and part.supported == 1 and _has_spring(work, part)
            springs = springs or borne
            for i in range(part.first_member, part.member_end):
                if work.members[i].inverse_mass > 0.0:
                    forces[work.members[i].body].by_end = DRIVES if borne else BY_END
    if springs:
        _spread_over_contacts(bodies, forces, slots, lowest)


@kernel
def _has_spring(work: JointWork, part: Records) -> bool:
    for k in range(part.first_constraint, part.constraint_end):
        joint = work.joints[work.constraints[k].joint]
        if joint.hertz > 0.0 or joint.angular_hertz > 0.0:
            return True
    return False


@kernel
def _spread_over_contacts(bodies: Records, forces: Records, slots: Records, lowest: Integers) -> None:
    """Whoever touches one that `DRIVES`, or one of those that touch it, moves by its end velocity as well."""
    for slot in slots:
        lowest[slot.body_a] = slot.body_a
        lowest[slot.body_b] = slot.body_b
    for slot in slots:
        if _both_move(bodies, slot):
            unite(lowest, slot.body_a, slot.body_b)
    for slot in slots:
        if _both_move(bodies, slot) and (forces[slot.body_a].by_end == DRIVES or forces[slot.body_b].by_end == DRIVES):
            forces[root_of(lowest, slot.body_a)].by_end = DRIVES
    for slot in slots:
        if _both_move(bodies, slot) and forces[root_of(lowest, slot.body_a)].by_end == DRIVES:
            forces[slot.body_a].by_end = forces[slot.body_b].by_end = DRIVES


@inlined_kernel
def _both_move(bodies: Records, slot: Records) -> bool:
    return bool(bodies[slot.body_a].inverse_mass > 0.0 and bodies[slot.body_b].inverse_mass > 0.0)


@kernel
def place_members(work: JointWork, part: Records, motions: Records) -> None:
    """Present rotation of the members of a net, and of what joints cannot move."""
    i = 1
    while i < part.member_end:
        member = work.members[i]
        if member.part >= 0 and i < part.first_member:
            i = part.first_member
            continue
        motion = motions[member.body]
        c = motion.delta_cos
        s = motion.delta_sin
        member.cos = member.start_cos * c - member.start_sin * s
        member.sin = member.start_sin * c + member.start_cos * s
        member.angle = member.start_angle + motion.delta_angle
        i += 1

"""Contacts solved together until they agree: rigid passes, accelerated by Nesterov's method with adaptive restarts.

A pass carries an impulse one contact further, and through a light body that a heavy one presses on only as much as the
light one can give: plain passes would take some thousand where one of 1,000 times the mass lands on a pyramid. So every
pass begins further along what the last one has changed, the longer passes agree on it the further. What all of them
lower is the kinetic energy of the bodies; where it rises they have gone too far, and begin anew from where they are.

Source: Yu. Nesterov, "A method of solving a convex programming problem with convergence rate O(1/k^2)" (1983), on
contacts H. Mazhar, T. Heyn, D. Negrut and A. Tasora, ACM Transactions on Graphics 34 (2015); the restarts are those of
B. O'Donoghue and E. Candes, Foundations of Computational Mathematics 15 (2015).
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, Vector, absolute, any_lane, load, root, select, store
from sandbox.engine.bodies.flags import is_driving
from sandbox.engine.bodies.integrate import SOLVED
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.lanes import load_anchors, load_masses
from sandbox.engine.contact_solver.solve import solve_again, solve_contacts
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES
LEAST_WORK = 2_000
"""Before so many passes times contacts only rounding ends it: few contacts cost little, and where masses differ,
much may be left to be found though each pass changes little."""
FAR = 1e30
"""Change of speed (m/s) before the first window, and of impulse where none changes a speed."""
ROUNDING = 1e-12
"""Change of speed (m/s) where nothing is left but rounding."""
WINDOW = 32
"""Where belts or kinematic bodies drive, so many passes must bring contacts nearer to agreeing, and leave them no more
energy than there was: what two belts draw into a gap from which it cannot slip has no impulses on which contacts agree,
and every pass adds to what there is."""
NEARER = 0.9
"""Ratio of the largest changes of speed in two passes a window apart, at most."""
TAKES_PART = 1 << 40
"""`solver.struck` of a body while it is listed as one that takes part: no value that groups of impacts leave there."""


class Effort(NamedTuple):
    """When to stop: after so many passes, after so many passes times contacts, or after a pass that has changed no
    contact's speed along the normal, nor by what resists a roll, by more than `agreed` (m/s). A heavy body may hardly
    notice a pass that presses a light one between it and the ground; what the two of them close in by, both contacts of
    the light one notice. Of few contacts, only a change by no more than `rounding` (m/s) ends it."""

    most_passes: int
    most_work: int
    agreed: float
    rounding: float


@kernel
def list_bodies(solver: SolverBodies, moved: Records, blocks: ContactBlocks, block_count: int) -> int:
    """List the bodies that the first blocks of contacts move, each once; returns how many."""
    count = 0
    for n in range(block_count):
        for slot in blocks.slots[blocks.blocks[n].first : blocks.blocks[n].first + blocks.blocks[n].count]:
            count += _list_body(solver, moved, count, slot.body_a)
            count += _list_body(solver, moved, count, slot.body_b)
    for here in moved[:count]:
        solver.struck[here.body] = 0
    return count


@inlined_kernel
def _list_body(solver: SolverBodies, moved: Records, count: int, i: int) -> int:
    if solver.forces[i].moves != SOLVED or solver.struck[i] == TAKES_PART:
        return 0
    solver.struck[i] = TAKES_PART
    moved[count].body = i
    return 1


@kernel
def solve_until_agreed(
    bodies: Records,
    motions: Records,
    moved: Records,
    blocks: ContactBlocks,
    block_count: int,
    workers: Workers,
    rigid: SoftContact,
    effort: Effort,
) -> None:
    """Solve the first blocks of contacts together, from the impulses that they have; `moved` lists their bodies."""
    contacts = count_contacts(blocks, block_count)
    passes = passes_within(effort.most_work, contacts, effort.most_passes)
    _begin(motions, moved, blocks, block_count)
    last_energy = first_energy = _energy(bodies, motions, moved)
    driven = _is_driven(bodies, blocks, block_count)
    agree = 0
    largest = FAR
    for turn in range(passes):
        if turn == 0:
            solve_contacts(motions, blocks, 0, block_count, workers, rigid)
        else:
            solve_again(motions, blocks, 0, block_count, workers, rigid)
        enough = effort.agreed if turn * contacts >= LEAST_WORK else effort.rounding
        # The last is a pass, so that no contact pulls.
        if turn == passes - 1 or not _changes(blocks, block_count, enough):
            return
        energy = _energy(bodies, motions, moved)
        if driven and turn % WINDOW == WINDOW - 1:
            change = _largest_change(blocks, block_count)
            if energy > first_energy or change > NEARER * largest:
                return
            largest = change
        agree = agree + 1 if energy <= last_energy else 0
        last_energy = energy
        further = momentum(agree)
        _go_further(blocks, block_count, further)
        _move_further(motions, moved, further)


@inlined_kernel
def momentum(agree: int) -> float:
    """The share of what the last pass has changed by which the next begins further on, after so many that agree."""
    return agree / (agree + 3.0)


@kernel
def count_contacts(blocks: ContactBlocks, block_count: int) -> int:
    """How many contacts the first blocks have."""
    contacts = 0
    for n in range(block_count):
        contacts += blocks.blocks[n].count
    return contacts


@inlined_kernel
def passes_within(work: int, contacts: int, most: int) -> int:
    """How many passes so many contacts may take for so much work, passes times contacts; one in any case."""
    passes = work // contacts
    passes = passes if passes < most else most
    return passes if passes > 1 else 1


@kernel
def _begin(motions: Records, moved: Records, blocks: ContactBlocks, block_count: int) -> None:
    """Note where the first pass begins."""
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        store(v, cb.LAST_IMPULSES, load(v, cb.POINT_1 + cb.NORMAL_IMPULSE))
        store(v, cb.LAST_IMPULSES + LANES, load(v, cb.POINT_2 + cb.NORMAL_IMPULSE))
        store(v, cb.LAST_IMPULSES + 2 * LANES, load(v, cb.TANGENT_IMPULSE))
        if blocks.blocks[n].rolling == 1:
            store(v, cb.LAST_IMPULSES + 3 * LANES, load(v, cb.ROLLING_IMPULSE))
    for here in moved:
        motion = motions[here.body]
        here.last_x = motion.velocity_x
        here.last_y = motion.velocity_y
        here.last_w = motion.angular_velocity


@kernel
def _energy(bodies: Records, motions: Records, moved: Records) -> float:
    """Twice the kinetic energy (J) of the bodies."""
    energy = 0.0
    for here in moved:
        motion = motions[here.body]
        body = bodies[here.body]
        square = motion.velocity_x * motion.velocity_x + motion.velocity_y * motion.velocity_y
        energy += body.mass * square + body.inertia * (motion.angular_velocity * motion.angular_velocity)
    return energy


@kernel
def _changes(blocks: ContactBlocks, block_count: int, agreed: float) -> bool:
    """Whether the last pass has changed the speed of a contact by more than `agreed` (m/s).

    Friction agrees when loads do; it follows a roll that is resisted while loads stay as they are.
    """
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        first = _changes_more(v, cb.POINT_1 + cb.NORMAL_IMPULSE, 0, agreed * load(v, cb.POINT_1 + cb.NORMAL_MASS))
        second = _changes_more(v, cb.POINT_2 + cb.NORMAL_IMPULSE, 1, agreed * load(v, cb.POINT_2 + cb.NORMAL_MASS))
        if any_lane(first | second):
            return True
        if blocks.blocks[n].rolling == 1:
            rubs = _changes_more(v, cb.TANGENT_IMPULSE, 2, agreed * load(v, cb.TANGENT_MASS))
            rolls = _changes_more(v, cb.ROLLING_IMPULSE, 3, agreed * _inertia_of_roll(v))
            if any_lane((load(v, cb.ROLLING_RESISTANCE) > 0.0) & (rubs | rolls)):
                return True
    return False


@kernel
def _is_driven(bodies: Records, blocks: ContactBlocks, block_count: int) -> bool:
    """Whether a surface runs, or a kinematic body moves, at one of the first blocks of contacts."""
    for n in range(block_count):
        block = blocks.blocks[n]
        if block.driven == 1:
            return True
        for slot in blocks.slots[block.first : block.first + block.count]:
            if is_driving(bodies[slot.body_a]) or is_driving(bodies[slot.body_b]):
                return True
    return False


@kernel
def _largest_change(blocks: ContactBlocks, block_count: int) -> float:
    """The most (m/s) by which the last pass has changed the speed of a contact along its normal."""
    largest = 0.0
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for k in range(blocks.blocks[n].count):
            for point, last in ((cb.POINT_1, cb.LAST_IMPULSES), (cb.POINT_2, cb.LAST_IMPULSES + LANES)):
                change = abs(v[point + cb.NORMAL_IMPULSE + k] - v[last + k])
                mass = v[point + cb.NORMAL_MASS + k]
                speed = change / mass if mass > 0.0 else 0.0
                largest = speed if speed > largest else largest
    return largest


@inlined_kernel
def _changes_more(v: Floats, field: int, kept: int, change: Vector) -> Mask:
    """Whether the last pass has changed the impulses of a field by more than that."""
    return absolute(load(v, field) - load(v, cb.LAST_IMPULSES + kept * LANES)) > change


@inlined_kernel
def _inertia_of_roll(v: Floats) -> Vector:
    """The rolling impulses (N m s) that change the speed of the surfaces where two bodies touch by 1 m/s."""
    mass = load_masses(v)
    r = load_anchors(v, cb.POINT_1)
    speed = mass.inertia_a * root(r.ax * r.ax + r.ay * r.ay) + mass.inertia_b * root(r.bx * r.bx + r.by * r.by)
    turns = speed > 0.0
    return select(turns, 1.0 / select(turns, speed, 1.0), FAR)


@kernel
def _go_further(blocks: ContactBlocks, block_count: int, further: float) -> None:
    """Go on by a share of what the impulses have changed since the pass before; until the next one they may pull."""
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        _go_further_with(v, cb.POINT_1 + cb.NORMAL_IMPULSE, 0, further)
        _go_further_with(v, cb.POINT_2 + cb.NORMAL_IMPULSE, 1, further)
        _go_further_with(v, cb.TANGENT_IMPULSE, 2, further)
        if blocks.blocks[n].rolling == 1:
            _go_further_with(v, cb.ROLLING_IMPULSE, 3, further)


@inlined_kernel
def _go_further_with(v: Floats, field: int, kept: int, further: float) -> None:
    last = cb.LAST_IMPULSES + kept * LANES
    now = load(v, field)
    store(v, field, now + further * (now - load(v, last)))
    store(v, last, now)


@kernel
def _move_further(motions: Records, moved: Records, further: float) -> None:
    """The same for the velocities, which follow from the impulses."""
    for here in moved:
        motion = motions[here.body]
        x = motion.velocity_x
        y = motion.velocity_y
        w = motion.angular_velocity
        motion.velocity_x = x + further * (x - here.last_x)
        motion.velocity_y = y + further * (y - here.last_y)
        motion.angular_velocity = w + further * (w - here.last_w)
        here.last_x = x
        here.last_y = y
        here.last_w = w

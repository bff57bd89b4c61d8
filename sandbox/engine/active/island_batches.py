"""Stage: islands are solved some at a time, in batches that fit into the processor's cache.

No island knows of another one, so that the bits do not depend on who shares a batch. All substeps of a batch are taken
before the next one begins: what a pass has read is still there for the next, however many islands there are.

Batch 0 has what does not fit or goes through more than contacts: large islands, and those that have joints, are
dragged, touch something that drives them, or have contacts without a colour.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import root_of
from sandbox.engine.bodies.flags import IMMOVABLE
from sandbox.engine.contact_solver.graph_coloring import TOO_MANY
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import has_joints
from sandbox.engine.records.batches import Batches
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records

ELSEWHERE = -1
"""In the place of the batch of a body that the solver moves at another substep level."""


@kernel
def worth_batches(contacts: int, batches: Batches) -> bool:
    """Whether so many contacts may be worth more than one batch: their islands have to be known then."""
    return contacts >= 2 * int(batches.size[0])


@kernel
def form_batches(
    rows: Integers,
    solver: SolverBodies,
    drags: Records,
    joints: JointWork,
    level: int,
    mixed: bool,
    worth: bool,
    batches: Batches,
) -> int:
    """Write `solver.batches`, the batch of each active body of `rows`, and the bodies of each; returns how many.

    Those that the solver moves at another level than this one are in none (`mixed`: there are such).

    It is one that has them all, unless more are `worth` it: then `color_contacts` has united islands, counted their
    contacts and marked what fits into no batch. What joints unite is left in batch 0 as a whole, since each part of it
    has a joint.
    """
    if not worth:
        return _keep_together(rows, solver, level, mixed, batches)
    counts = solver.batches
    jointed = has_joints(joints)
    for k in range(drags.shape[0]):
        if drags[k].body >= 0 and solver.colors[drags[k].body] != IMMOVABLE:
            counts[drags[k].body] = TOO_MANY
    for i in rows:
        if mixed and _is_elsewhere(i, solver, level):
            counts[i] = ELSEWHERE
            continue
        if jointed and joints.part_of[i] >= 0:
            counts[i] = TOO_MANY
        root = root_of(solver.islands, i)
        solver.islands[i] = root
        if root != i:
            counts[root] += counts[i]
    count = _number_islands(rows, solver.islands, counts, batches)
    _sort_bodies(rows, counts, batches, count)
    return count


@inlined_kernel
def _is_elsewhere(i: int, solver: SolverBodies, level: int) -> bool:
    """Whether the solver moves a body at another level."""
    return bool(solver.colors[i] != IMMOVABLE and solver.free_motions[i].substep_level != level)


@kernel
def _keep_together(rows: Integers, solver: SolverBodies, level: int, mixed: bool, batches: Batches) -> int:
    """All bodies in one batch."""
    count = 0
    for i in rows:
        if not (mixed and _is_elsewhere(i, solver, level)):
            batches.bodies[count] = i
            count += 1
    batches.first_body[0] = 0
    batches.first_body[1] = count
    return 1


@kernel
def _number_islands(rows: Integers, islands: Integers, counts: Integers, batches: Batches) -> int:
    """Put islands into batches, in the order of their roots, which come first of their bodies: `counts`, of bodies
    and contacts, becomes their numbers. Returns how many batches there are."""
    size = batches.size[0]
    last = batches.first_body.shape[0] - 2
    number = 0
    filled = size
    for i in rows:
        if counts[i] == ELSEWHERE:
            continue
        if islands[i] != i:
            counts[i] = counts[islands[i]]
            continue
        count = counts[i]
        fits = count <= size
        if fits and filled + count > size:
            fits = number < last
            number += 1 if fits else 0
            filled = 0 if fits else filled
        filled += count if fits else 0
        counts[i] = number if fits else 0
    return number + 1


@kernel
def _sort_bodies(rows: Integers, of_body: Integers, batches: Batches, count: int) -> None:
    """A counting sort, stable."""
    first = batches.first_body
    for n in range(count + 1):
        first[n] = 0
    for i in rows:
        if of_body[i] != ELSEWHERE:
            first[of_body[i]] += 1
    total = 0
    for n in range(count + 1):
        total += first[n]
        first[n] = total
    for k in range(rows.shape[0] - 1, -1, -1):
        n = of_body[rows[k]]
        if n == ELSEWHERE:
            continue
        first[n] -= 1
        batches.bodies[first[n]] = rows[k]


@kernel
def sort_impacts(slots: Records, length: int, of_body: Integers, batches: Batches, count: int) -> None:
    """Write `batches.impact_slots`: the contacts that may have an impact, by batch and in the order of `slots`."""
    first = batches.first_impact
    for n in range(count + 1):
        first[n] = 0
    for k in range(length):
        first[batch_of(slots[k], of_body) if count > 1 else 0] += 1
    total = 0
    for n in range(count + 1):
        total += first[n]
        first[n] = total
    for k in range(length - 1, -1, -1):
        slot = slots[k]
        n = batch_of(slot, of_body) if count > 1 else 0
        first[n] -= 1
        listed = batches.impact_slots[first[n]]
        listed.contact = slot.contact
        listed.body_a = slot.body_a
        listed.body_b = slot.body_b


@kernel
def batch_of(slot: Records, of_body: Integers) -> int:
    """The batch of a contact: what does not move is in none, which counts as 0."""
    a = of_body[slot.body_a]
    b = of_body[slot.body_b]
    return int(a if a > b else b)

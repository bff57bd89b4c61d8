"""Stage: the narrow phase. Each proposed pair is decided, and keeps what is known of it from the last step."""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.active_set import list_row
from sandbox.engine.broad_phase.pairs import comes_before
from sandbox.engine.narrow_phase.decide_pairs import decide_pairs
from sandbox.engine.narrow_phase.sleeping_contacts import keep_sleeping_before
from sandbox.engine.narrow_phase.write_contacts import write_contacts
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.ccd import NEW, OVERLAPS
from sandbox.engine.records.colliders import Colliders
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.decisions import DEEP, MAY_IMPACT, Decisions
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import FIRST_PAIR, first_part, next_part
from sandbox.engine.workers.task_kinds import DECIDE_PAIRS, WRITE_CONTACTS
from sandbox.tables import Records

LAST = 1 << 60
"""No shape has such a row: everything comes before it."""


@kernel
def find_contacts(
    state: StateTables,
    active: ActiveSet,
    colliders: Colliders,
    pairs: Records,
    contacts: Contacts,
    ccd_bodies: Records,
    workers: Workers,
    decisions: Decisions,
) -> int:
    """Write a contact for every pair that touches or will touch within the step; return how many.

    Pairs come in batches. Deciding them and writing their contacts is shared by the workers; between the two, one of
    them numbers the contacts: in the order of pairs, which is that of `contacts.now`. `contacts.active` and
    `impact_candidates` are filled as by `list_active_contacts`. Contacts among sleeping bodies, which the grid does not
    propose, are kept as they are.
    """
    for i in active.bodies[1 : 1 + active.bodies[0]]:
        ccd_bodies[i].deep = 0
        ccd_bodies[i].unsettled = 0
    contacts.active[0].contact = 0
    contacts.impact_candidates[0] = 0
    pair_count = state.counters[0].pair_count
    batch_size = decisions.made.shape[0]
    k = 0
    count = 0
    for batch in range(0, pair_count, batch_size):
        length = batch_size if batch + batch_size < pair_count else pair_count - batch
        now: Any = pairs[batch:]
        workers.words[FIRST_PAIR] = batch
        first, end = first_part(workers, DECIDE_PAIRS, 0, length)
        while first < end:
            decide_pairs(state, colliders, now, contacts.before, decisions, 0, first, end)
            first, end = next_part(workers, first, end)
        k, count = _number_contacts(
            state, active, colliders.proxies, now, length, contacts, ccd_bodies, decisions.made, k, count
        )
        first, end = first_part(workers, WRITE_CONTACTS, 0, length)
        while first < end:
            write_contacts(colliders.proxies, now, contacts, decisions, first, end)
            first, end = next_part(workers, first, end)
    _, count = keep_sleeping_before(
        state.bodies, active.activity, contacts, k, state.counters[0].contact_count, LAST, 0, count
    )
    return count


@kernel
def _number_contacts(
    state: StateTables,
    active: ActiveSet,
    proxies: Records,
    pairs: Records,
    length: int,
    contacts: Contacts,
    ccd_bodies: Records,
    decided: Records,
    k: int,
    count: int,
) -> tuple[int, int]:
    """Give the contacts of a batch of `length` pairs their rows, behind what is kept of sleepers before them.

    `k` is the next contact of the step before; returns it and the new count of contacts.
    """
    old = contacts.before
    old_count = state.counters[0].contact_count
    for n in range(length):
        i = pairs[n].shape_a
        j = pairs[n].shape_b
        made = decided[n]
        if made.old != k and k < old_count and comes_before(old[k], i, j):
            k, count = keep_sleeping_before(state.bodies, active.activity, contacts, k, old_count, i, j, count)
        body_a = proxies[i].body
        body_b = proxies[j].body
        if made.bits & (NEW | OVERLAPS | DEEP):
            _note(ccd_bodies[body_a], made.bits)
            _note(ccd_bodies[body_b], made.bits)
        if made.row < 0:
            continue
        made.row = count
        list_row(count, body_a, body_b, made.bits & MAY_IMPACT != 0, contacts)
        if made.old >= 0:
            k = made.old + 1
        count += 1
    return k, count


@inlined_kernel
def _note(ccd_body: Records, bits: int) -> None:
    ccd_body.unsettled |= bits & (NEW | OVERLAPS)
    if bits & DEEP:
        ccd_body.deep = 1

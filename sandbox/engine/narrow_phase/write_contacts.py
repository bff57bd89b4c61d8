"""Contacts of the pairs that touch, with what they keep of the step before."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.narrow_phase.contact import fill_contact, match_contact
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.decisions import Decisions
from sandbox.tables import Records


@kernel
def write_contacts(
    proxies: Records, pairs: Records, contacts: Contacts, decisions: Decisions, first: int, end: int
) -> None:
    """Write the contacts of the pairs first..end-1 of a batch to the rows of `contacts.now` that were decided.

    Impulses of points with the same feature id carry over from `contacts.before` (warm starting).
    """
    for n in range(first, end):
        made = decisions.made[n]
        if made.row < 0:
            continue
        contact = contacts.now[made.row]
        manifold = decisions.manifolds[n]
        fill_contact(proxies, pairs[n].shape_a, pairs[n].shape_b, made.shift_x, made.shift_y, manifold, contact)
        if made.old >= 0:
            match_contact(contacts.before[made.old], contact)

"""Stage: colour the constraint graph, so that contacts of one colour share no moving body."""

from __future__ import annotations

import numpy as np

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import unite
from sandbox.engine.bodies.flags import IMMOVABLE, MOVING_KINEMATIC, is_active
from sandbox.engine.contact_solver.blocks import (
    DEEP,
    MAX_COLORS,
    SETTLED,
    STRUCK_ALONE,
    STRUCK_AND_DEEP,
    UNSETTLED,
)
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.ccd import OVERLAPS, STRUCK
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Records

FREE = np.array([next(k for k in range(9) if not (bits >> k) & 1) for bits in range(256)])
"""For every set of the first eight colours the lowest that is not in it; 8 if all are."""
TOO_MANY = 1 << 40
"""Counts as so many contacts: an island with such a one fits into no batch (`active.island_batches`)."""
IS_UNSETTLED = 1 << MAX_COLORS
"""In the set of a body's colours: its contacts come before those of all others."""


@kernel
def color_contacts(
    bodies: Records,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    substep_level: int,
    mixed: bool,
    islands_too: bool,
    blocks: ContactBlocks,
) -> tuple[int, int]:
    """Greedy colouring of the active contacts of a substep level, in order; returns the number of colours, and the bits
    of `unsettled` that some body of the level has.

    `mixed` says that there are other levels. `blocks.colors` gets a colour for each active contact, `solver.colors` is
    scratch: the colours that each body's contacts have. Only active bodies count: others are read by the solver but
    not changed. A contact that finds no free colour gets `MAX_COLORS`, the colour of those that are solved one by one;
    one among sleeping bodies or of another substep level gets -1 and is not solved. Each kind of contacts
    (`blocks.KIND`) has colours of its own. Contacts that find no colour get further ones in `fill_blocks`, if there are
    enough of them.

    With `islands_too` what contacts join is united in `solver.islands`, and `solver.batches` counts each body and its
    contacts, each of these at one of its two: as `TOO_MANY` where they fit into no batch.
    """
    taken = solver.colors
    listed = contacts.active[1 : 1 + contacts.active[0].contact]
    unsettled = 0
    for i in active.bodies[1 : 1 + active.bodies[0]]:
        bits = solver.ccd[i].unsettled
        moves = is_active(bodies[i])
        taken[i] = (IS_UNSETTLED if bits != 0 else 0) if moves else IMMOVABLE
        if bits != 0 and moves and solver.free_motions[i].substep_level == substep_level:
            unsettled |= bits
        if islands_too:
            solver.islands[i] = i
            solver.batches[i] = 1 if moves else TOO_MANY
    highest = -1
    for k in range(listed.shape[0]):
        a = listed[k].body_a
        b = listed[k].body_b
        moves_a = taken[a] != IMMOVABLE
        moves_b = taken[b] != IMMOVABLE
        moves = moves_a or moves_b
        if not moves or (mixed and solver.free_motions[a if moves_a else b].substep_level != substep_level):
            blocks.colors[k] = -1
            continue
        both = (taken[a] if moves_a else 0) | (taken[b] if moves_b else 0)
        color = lowest_free(both)
        kind = SETTLED
        if both & IS_UNSETTLED:
            bits = (solver.ccd[a].unsettled if moves_a else 0) | (solver.ccd[b].unsettled if moves_b else 0)
            kind = _kind(bits)
        blocks.colors[k] = color + kind
        highest = color if color > highest else highest
        if color < MAX_COLORS:
            if moves_a:
                taken[a] |= 1 << color
            if moves_b:
                taken[b] |= 1 << color
        if islands_too:
            if moves_a and moves_b:
                unite(solver.islands, a, b)
            driven = moves_a != moves_b and (solver.flags[a] | solver.flags[b]) & MOVING_KINEMATIC != 0
            solver.batches[a if moves_a else b] += TOO_MANY if driven or color == MAX_COLORS else 1
    return highest + 1, unsettled


@inlined_kernel
def _kind(unsettled: int) -> int:
    """The first colour of contacts of bodies with these bits of `unsettled`."""
    if unsettled & STRUCK:
        return STRUCK_AND_DEEP if unsettled & OVERLAPS else STRUCK_ALONE
    return DEEP if unsettled & OVERLAPS else UNSETTLED


@inlined_kernel
def lowest_free(taken: int) -> int:
    """Lowest colour that is not in a set. A table, as nobody can guess when a loop over its bits ends."""
    color = int(FREE[taken & 0xFF])
    if color == 8:
        while color < MAX_COLORS - 8 and (taken >> color) & 0xFF == 0xFF:
            color += 8
        color += int(FREE[(taken >> color) & 0xFF])
        color = color if color < MAX_COLORS else MAX_COLORS
    return color

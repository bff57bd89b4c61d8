"""The linear systems of a batch: sparse LDL^T of J M^-1 J^T + softness, along the pattern of their layout.

T. Davis, "Direct Methods for Sparse Linear Systems", 2006; for jointed bodies D. Baraff, "Linear-Time Dynamics using
Lagrange Multipliers", 1996. An equation none of whose rows is active has the column of the unit matrix.

A spring and a limit or motor act on the same coordinate, so that their rows would be the same but for softness: they
share an equation, whose unknown is what both give. While the limit is active, it alone says what the equation strives
for, and the spring gives what its law asks for at the speed that comes of it.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Mask, Vector, any_lane, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.assemble import has_equation
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.rows import change_impulse, is_of_body, row_speed
from sandbox.tables import Floats, Records

_REDUNDANT = 1e-10
"""A pivot that has shrunk to this share of its stiffness says what other rows say already."""


@kernel
def factorize(d: Batches, batch: Records) -> None:
    """Factorise the assembled matrices of a batch, less the rows that are not active."""
    batch.redundant = 0
    _unite_rows(d, batch)
    _choose_entries(d, batch)
    layout = d.layouts[batch.layout]
    r = layout.first_row
    while r < layout.row_end:
        if not has_equation(d.equations[r]):
            r += 1
        elif d.equations[r].paired == 1:
            _eliminate_pair(d, batch, d.equations[r], d.equations[r + 1])
            r += 2
        else:
            _eliminate(d, batch, d.equations[r])
            r += 1


@kernel
def _eliminate(d: Batches, batch: Records, row: Records) -> None:
    """Subtract what a row says from all after it. Where it is in none of the systems it has nothing to say."""
    v = d.memory
    if not _is_taken(v, row):
        return
    targets = d.targets
    first, end = _column(d, row)
    inverse = _inverse(d, batch, row, first)
    t = row.first_target
    for i in range(first + WIDTH, end, WIDTH):
        scaled = load(v, i) * inverse
        for k in range(i, end, WIDTH):
            store(v, targets[t], load(v, targets[t]) - scaled * load(v, k))
            t += 1
        store(v, i, scaled)
    store(v, first, inverse)


@kernel
def _eliminate_pair(d: Batches, batch: Records, row: Records, after: Records) -> None:
    """The same for two rows of one joint, one after the other, whose columns have the same rows below: what both
    subtract from is fetched once."""
    v = d.memory
    targets = d.targets
    first, second = _column(d, row)
    _, end = _column(d, after)
    inverse = _inverse(d, batch, row, first)
    between = load(v, first + WIDTH) * inverse
    shift = second - first - WIDTH
    for k in range(second, end, WIDTH):
        store(v, k, load(v, k) - between * load(v, k - shift))
    inverse_after = _inverse(d, batch, after, second)
    t = after.first_target
    for i in range(second + WIDTH, end, WIDTH):
        scaled = load(v, i - shift) * inverse
        scaled_after = load(v, i) * inverse_after
        for k in range(i, end, WIDTH):
            left = load(v, targets[t]) - scaled * load(v, k - shift)
            store(v, targets[t], left - scaled_after * load(v, k))
            t += 1
        store(v, i - shift, scaled)
        store(v, i, scaled_after)
    store(v, first + WIDTH, between)
    store(v, first, inverse)
    store(v, second, inverse_after)


@inlined_kernel
def _is_taken(v: Floats, row: Records) -> bool:
    """Whether an equation is part of the linear system in some lane."""
    return bool(any_lane(load(v, row.place + at.IN_SYSTEM) == 1.0))


@inlined_kernel
def _column(d: Batches, row: Records) -> tuple[int, int]:
    """Where a row's column of the factor begins and ends."""
    first = d.entries[row.first_entry].place
    return first, first + (row.entry_end - row.first_entry) * WIDTH


@inlined_kernel
def _inverse(d: Batches, batch: Records, row: Records, pivot: int) -> Vector:
    """One divided by the pivot of a row; 0 where others have said what it says. That of a body is less than 0, of its
    mass at least."""
    v = d.memory
    left = load(v, pivot)
    taken = load(v, row.place + at.IN_SYSTEM) == 1.0
    stiffness = load(v, batch.rows + row.kept + at.STIFFNESS)
    if row.augmented != 0:
        if is_of_body(row):
            return 1.0 / left
        stiffness = load(v, d.entries[row.first_entry].total)
    whole = select(taken, stiffness + load(v, row.place + at.DIAGONAL), 1.0)
    sound = left > _REDUNDANT * whole
    if any_lane(~sound):
        batch.redundant = 1
    return select(sound, 1.0 / select(sound, left, 1.0), 0.0)


@kernel
def _unite_rows(d: Batches, batch: Records) -> None:
    """Which equations are part of the linear system, and how soft they are."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if is_of_body(row):
            inverse = at.INVERSE_INERTIA if row.slot == 2 else at.INVERSE_MASS
            moves = load(v, batch.seats + row.seat_1 + inverse) > 0.0
            store(v, row.place + at.IN_SYSTEM, select(moves, 1.0, spread(0.0)))
            store(v, row.place + at.DIAGONAL, spread(0.0))
            continue
        taken = load(v, row.place + at.ACTIVE)
        softness = load(v, row.place + at.SOFTNESS)
        if row.shares == 1:
            after = d.equations[r + 1].place
            leads = load(v, after + at.ACTIVE) == 1.0
            taken = select(leads, 1.0, taken)
            softness = select(leads, load(v, after + at.SOFTNESS), softness)
        store(v, row.place + at.IN_SYSTEM, taken)
        store(v, row.place + at.DIAGONAL, softness)


@kernel
def _choose_entries(d: Batches, batch: Records) -> None:
    """Copy the entries between equations of the system to where they are factorised."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if not has_equation(row):
            continue
        taken = load(v, row.place + at.IN_SYSTEM) == 1.0
        first = d.entries[row.first_entry]
        whole = load(v, first.total) + load(v, row.place + at.DIAGONAL)
        store(v, first.place, select(taken, whole, 1.0))
        for e in range(row.first_entry + 1, row.entry_end):
            entry = d.entries[e]
            both = taken & (load(v, entry.other + at.IN_SYSTEM) == 1.0)
            store(v, entry.place, select(both, load(v, entry.total), 0.0))


@kernel
def solve_directly(d: Batches, batch: Records, impulse: int, who: Mask) -> None:
    """Give all active rows of the parts `who`, at once, the impulses that they strive for; see `change_impulse`."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if not has_equation(row):
            continue
        if is_of_body(row):
            store(v, row.place + at.CHANGE, spread(0.0))
            continue
        speed = row_speed(v, row)
        taken = who & (load(v, row.place + at.IN_SYSTEM) == 1.0)
        wanted = _unmet(v, batch, row, impulse, speed)
        if row.shares == 1:
            after = d.equations[r + 1]
            leads = load(v, after.place + at.ACTIVE) == 1.0
            wanted = select(leads, _unmet(v, batch, after, impulse, speed), wanted)
        store(v, row.place + at.CHANGE, select(taken, -wanted, 0.0))
    _substitute_all(d, batch)
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if has_equation(row):
            taken = who & (load(v, row.place + at.IN_SYSTEM) == 1.0)
            change_impulse(v, batch, row, load(v, row.place + at.CHANGE), impulse, taken)
    for r in range(layout.first_row, layout.row_end):
        if d.equations[r].shares == 1:
            _share_out(d, batch, r, impulse, who)


@inlined_kernel
def _unmet(v: Floats, batch: Records, row: Records, impulse: int, speed: Vector) -> Vector:
    """What is left of the law of a row at that speed along it."""
    current = load(v, batch.rows + row.kept + impulse)
    return speed + load(v, row.place + at.BIAS) + load(v, row.place + at.SOFTNESS) * current


@kernel
def _share_out(d: Batches, batch: Records, r: int, impulse: int, who: Mask) -> None:
    """Give the second of two rows that share an equation its part of the change, which the first one has got."""
    v = d.memory
    row = d.equations[r]
    after = d.equations[r + 1]
    leads = who & (load(v, after.place + at.ACTIVE) == 1.0)
    if any_lane(leads):
        first = batch.rows + row.kept + impulse
        second = batch.rows + after.kept + impulse
        got = load(v, first)
        before = got - load(v, row.place + at.CHANGE)
        yields = leads & (load(v, row.place + at.ACTIVE) == 1.0) & (load(v, row.place + at.SOFTNESS) > 0.0)
        softness = select(yields, load(v, row.place + at.SOFTNESS), 1.0)
        own = select(yields, -(row_speed(v, row) + load(v, row.place + at.BIAS)) / softness, before)
        store(v, first, select(leads, own, got))
        store(v, second, select(leads, load(v, second) + (got - own), load(v, second)))


@kernel
def _substitute_all(d: Batches, batch: Records) -> None:
    """Forward and backward substitution."""
    v = d.memory
    layout = d.layouts[batch.layout]
    r = layout.first_row
    while r < layout.row_end:
        if not has_equation(d.equations[r]):
            r += 1
        elif d.equations[r].paired == 1:
            _substitute_pair(d, d.equations[r], d.equations[r + 1])
            r += 2
        else:
            _substitute(d, d.equations[r])
            r += 1
    for r in range(layout.row_end - 1, layout.first_row - 1, -1):
        row = d.equations[r]
        if not (has_equation(row) and _is_taken(v, row)):
            continue
        change = load(v, row.place + at.CHANGE) * load(v, d.entries[row.first_entry].place)
        for e in range(row.first_entry + 1, row.entry_end):
            entry = d.entries[e]
            change = change - load(v, entry.place) * load(v, entry.other + at.CHANGE)
        store(v, row.place + at.CHANGE, change)


@inlined_kernel
def _substitute(d: Batches, row: Records) -> None:
    """Forward substitution of a row."""
    v = d.memory
    if not _is_taken(v, row):
        return
    change = load(v, row.place + at.CHANGE)
    for e in range(row.first_entry + 1, row.entry_end):
        entry = d.entries[e]
        place = entry.other + at.CHANGE
        store(v, place, load(v, place) - load(v, entry.place) * change)


@inlined_kernel
def _substitute_pair(d: Batches, row: Records, after: Records) -> None:
    """Forward substitution of two rows that are eliminated together."""
    v = d.memory
    first, second = _column(d, row)
    shift = second - first - WIDTH
    change = load(v, row.place + at.CHANGE)
    change_after = load(v, after.place + at.CHANGE) - load(v, first + WIDTH) * change
    store(v, after.place + at.CHANGE, change_after)
    for e in range(after.first_entry + 1, after.entry_end):
        entry = d.entries[e]
        place = entry.other + at.CHANGE
        left = load(v, place) - load(v, entry.place - shift) * change
        store(v, place, left - load(v, entry.place) * change_after)

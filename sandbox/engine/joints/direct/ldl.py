"""The linear systems of a batch: sparse LDL^T of J M^-1 J^T + softness, along the pattern of their layout.

T. Davis, "Direct Methods for Sparse Linear Systems", 2006; for jointed bodies D. Baraff, "Linear-Time Dynamics using
Lagrange Multipliers", 1996. A row that is not active has the column of the unit matrix.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Mask, Vector, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.rows import change_impulse, row_speed, side_product
from sandbox.tables import Floats, Records

_REDUNDANT = 1e-10
"""A pivot that has shrunk to this share of its stiffness says what other rows say already."""


@kernel
def assemble(d: Batches, batch: Records) -> None:
    """Work out J M^-1 J^T of all rows of a batch. It holds until rows or masses change, whichever rows are active."""
    layout = d.layouts[batch.layout]
    r = layout.first_row
    while r < layout.row_end:
        row = d.equations[r]
        if row.paired == 1:
            after = d.equations[r + 1]
            _sum_products(d, batch, row.first_entry, row.first_entry + 2)
            _sum_products(d, batch, after.first_entry, after.first_entry + 1)
            _sum_products_of_pair(d, batch, row, after)
            r += 2
        else:
            _sum_products(d, batch, row.first_entry, row.entry_end)
            r += 1


@inlined_kernel
def _sum_products(d: Batches, batch: Records, first: int, end: int) -> None:
    """Work out the entries first..end-1."""
    v = d.memory
    for e in range(first, end):
        entry = d.entries[e]
        total = spread(0.0)
        for k in range(entry.first_product, entry.product_end):
            product = d.products[k]
            total = total + side_product(v, batch, product.one, product.other, product.seat)
        store(v, entry.total, total)


@inlined_kernel
def _sum_products_of_pair(d: Batches, batch: Records, row: Records, after: Records) -> None:
    """Work out the entries that two rows of one joint have below: they are products with the same rows."""
    v = d.memory
    back = after.place - row.place
    shift = d.entries[after.first_entry].total - d.entries[row.first_entry].total - WIDTH
    for e in range(after.first_entry + 1, after.entry_end):
        entry = d.entries[e]
        total = spread(0.0)
        total_after = spread(0.0)
        for k in range(entry.first_product, entry.product_end):
            product = d.products[k]
            total = total + side_product(v, batch, product.one, product.other - back, product.seat)
            total_after = total_after + side_product(v, batch, product.one, product.other, product.seat)
        store(v, entry.total - shift, total)
        store(v, entry.total, total_after)


@kernel
def factorize(d: Batches, batch: Records) -> None:
    """Factorise the assembled matrices of a batch, less the rows that are not active."""
    _choose_entries(d, batch)
    layout = d.layouts[batch.layout]
    r = layout.first_row
    while r < layout.row_end:
        if d.equations[r].paired == 1:
            _eliminate_pair(d, batch, d.equations[r], d.equations[r + 1])
            r += 2
        else:
            _eliminate(d, batch, d.equations[r])
            r += 1


@kernel
def _eliminate(d: Batches, batch: Records, row: Records) -> None:
    """Subtract what a row says from all after it."""
    v = d.memory
    targets = d.targets
    first, end = _column(d, row)
    inverse = _inverse(v, batch, row, first)
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
    inverse = _inverse(v, batch, row, first)
    between = load(v, first + WIDTH) * inverse
    shift = second - first - WIDTH
    for k in range(second, end, WIDTH):
        store(v, k, load(v, k) - between * load(v, k - shift))
    inverse_after = _inverse(v, batch, after, second)
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
def _column(d: Batches, row: Records) -> tuple[int, int]:
    """Where a row's column of the factor begins and ends."""
    first = d.entries[row.first_entry].place
    return first, first + (row.entry_end - row.first_entry) * WIDTH


@inlined_kernel
def _inverse(v: Floats, batch: Records, row: Records, pivot: int) -> Vector:
    """One divided by the pivot of a row; 0 where others have said what it says."""
    active = load(v, row.place + at.ACTIVE) == 1.0
    stiffness = load(v, batch.rows + row.kept + at.STIFFNESS)
    whole = select(active, stiffness + load(v, row.place + at.SOFTNESS), 1.0)
    left = load(v, pivot)
    sound = left > _REDUNDANT * whole
    return select(sound, 1.0 / select(sound, left, 1.0), 0.0)


@kernel
def _choose_entries(d: Batches, batch: Records) -> None:
    """Copy the entries between active rows to where they are factorised."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        active = load(v, row.place + at.ACTIVE) == 1.0
        first = d.entries[row.first_entry]
        whole = load(v, first.total) + load(v, row.place + at.SOFTNESS)
        store(v, first.place, select(active, whole, 1.0))
        for e in range(row.first_entry + 1, row.entry_end):
            entry = d.entries[e]
            both = active & (load(v, entry.other + at.ACTIVE) == 1.0)
            store(v, entry.place, select(both, load(v, entry.total), 0.0))


@kernel
def solve_directly(d: Batches, batch: Records, impulse: int, who: Mask) -> None:
    """Give all active rows of the parts `who`, at once, the impulses that they strive for; see `change_impulse`."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        active = who & (load(v, row.place + at.ACTIVE) == 1.0)
        current = load(v, batch.rows + row.kept + impulse)
        wanted = row_speed(v, row) + load(v, row.place + at.BIAS) + load(v, row.place + at.SOFTNESS) * current
        store(v, row.place + at.CHANGE, select(active, -wanted, 0.0))
    r = layout.first_row
    while r < layout.row_end:
        if d.equations[r].paired == 1:
            _substitute_pair(d, d.equations[r], d.equations[r + 1])
            r += 2
        else:
            _substitute(d, d.equations[r])
            r += 1
    for r in range(layout.row_end - 1, layout.first_row - 1, -1):
        row = d.equations[r]
        change = load(v, row.place + at.CHANGE) * load(v, d.entries[row.first_entry].place)
        for e in range(row.first_entry + 1, row.entry_end):
            entry = d.entries[e]
            change = change - load(v, entry.place) * load(v, entry.other + at.CHANGE)
        store(v, row.place + at.CHANGE, change)
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        active = who & (load(v, row.place + at.ACTIVE) == 1.0)
        change_impulse(v, batch, row, load(v, row.place + at.CHANGE), impulse, active)


@inlined_kernel
def _substitute(d: Batches, row: Records) -> None:
    """Forward substitution of a row."""
    v = d.memory
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

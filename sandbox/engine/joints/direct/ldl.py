"""The linear systems of a batch: sparse LDL^T of J M^-1 J^T + softness, along the pattern of their layout.

T. Davis, "Direct Methods for Sparse Linear Systems", 2006; for jointed bodies D. Baraff, "Linear-Time Dynamics using
Lagrange Multipliers", 1996. A row that is not active has the column of the unit matrix.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import WIDTH, Mask, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.rows import change_impulse, row_speed, side_product
from sandbox.tables import Records

_REDUNDANT = 1e-10
"""A pivot that has shrunk to this share of its stiffness says what other rows say already."""


@kernel
def assemble(d: Batches, batch: Records) -> None:
    """Work out J M^-1 J^T of all rows of a batch. It holds until rows or masses change, whichever rows are active."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        for e in range(row.first_entry, row.entry_end):
            entry = d.entries[e]
            total = spread(0.0)
            for k in range(entry.first_product, entry.product_end):
                product = d.products[k]
                total = total + side_product(v, batch, product.one, product.other, product.seat)
            store(v, entry.total, total)


@kernel
def factorize(d: Batches, batch: Records) -> None:
    """Factorise the assembled matrices of a batch, less the rows that are not active."""
    v = d.memory
    _choose_entries(d, batch)
    layout = d.layouts[batch.layout]
    targets = d.targets
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        first = d.entries[row.first_entry].place
        end = first + (row.entry_end - row.first_entry) * WIDTH
        active = load(v, row.place + at.ACTIVE) == 1.0
        stiffness = load(v, batch.rows + row.kept + at.STIFFNESS)
        whole = select(active, stiffness + load(v, row.place + at.SOFTNESS), 1.0)
        pivot = load(v, first)
        sound = pivot > _REDUNDANT * whole
        inverse = select(sound, 1.0 / select(sound, pivot, 1.0), 0.0)
        t = row.first_target
        for i in range(first + WIDTH, end, WIDTH):
            scaled = load(v, i) * inverse
            for k in range(i, end, WIDTH):
                store(v, targets[t], load(v, targets[t]) - scaled * load(v, k))
                t += 1
            store(v, i, scaled)
        store(v, first, inverse)


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
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        change = load(v, row.place + at.CHANGE)
        for e in range(row.first_entry + 1, row.entry_end):
            entry = d.entries[e]
            place = entry.other + at.CHANGE
            store(v, place, load(v, place) - load(v, entry.place) * change)
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

"""The matrices of a batch, J M^-1 J^T, entry by entry: each is a sum over the bodies that two rows have in common.

Bodies that stay in the system (`augmented`) are no such bodies: they have rows of their own.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Vector, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import ANY_PRODUCT, OF_INERTIA, OF_JACOBIAN, Batches
from sandbox.engine.joints.direct.rows import side_product
from sandbox.tables import Floats, Records


@kernel
def assemble(d: Batches, batch: Records) -> None:
    """Work out J M^-1 J^T of all rows of a batch. It holds until rows or masses change, whichever rows are active."""
    layout = d.layouts[batch.layout]
    r = layout.first_row
    while r < layout.row_end:
        row = d.equations[r]
        if not has_equation(row):
            r += 1
        elif row.paired == 1:
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
            total = total + _product(v, batch, d.products[k])
        store(v, entry.total, total)


@inlined_kernel
def _sum_products_of_pair(d: Batches, batch: Records, row: Records, after: Records) -> None:
    """Work out the entries that two rows of one joint have below: they are products with the same rows."""
    v = d.memory
    first = row.first_entry + 2
    for e in range(after.first_entry + 1, after.entry_end):
        entry = d.entries[e]
        before = d.entries[first]
        total = spread(0.0)
        total_after = spread(0.0)
        back = before.first_product - entry.first_product
        for k in range(entry.first_product, entry.product_end):
            total = total + _product(v, batch, d.products[back + k])
            total_after = total_after + _product(v, batch, d.products[k])
        store(v, before.total, total)
        store(v, entry.total, total_after)
        first += 1


@inlined_kernel
def _product(v: Floats, batch: Records, product: Records) -> Vector:
    """What a body adds to the entry of two rows; it may be known for good what the velocity of its centre does."""
    if product.linear == ANY_PRODUCT:
        return side_product(v, batch, product.one, product.other, product.seat)
    if product.linear >= OF_JACOBIAN:
        return load(v, product.one) if product.linear == OF_JACOBIAN else _less_mass(v, batch, product)
    w = load(v, product.one + 2 * WIDTH) * load(v, product.other + 2 * WIDTH)
    turn = load(v, batch.seats + product.seat + at.INVERSE_INERTIA) * w
    if product.linear == 0:
        return turn
    mass = load(v, batch.seats + product.seat + at.INVERSE_MASS)
    return turn + mass if product.linear == 1 else turn - mass


@inlined_kernel
def _less_mass(v: Floats, batch: Records, product: Records) -> Vector:
    """The diagonal of a body that stays in the system; of one that does not move the row is left out."""
    field = at.INVERSE_INERTIA if product.linear == OF_INERTIA else at.INVERSE_MASS
    inverse = load(v, batch.seats + product.seat + field)
    return -1.0 / select(inverse > 0.0, inverse, 1.0)


@inlined_kernel
def has_equation(row: Records) -> bool:
    """Whether a row has a column of the factor: the second of two that share an equation has none."""
    return bool(row.entry_end > row.first_entry)

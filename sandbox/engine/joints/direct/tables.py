"""The memory of factorised parts, put together from their layouts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox._vectors import WIDTH
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.layout import DirectLayout
from sandbox.engine.joints.direct.records import (
    BATCH,
    ENTRY,
    EQUATION,
    FRAME,
    HAS_MATRIX,
    LAYOUT,
    LEVELS,
    MOST_STRUCK,
    PRODUCT,
    Batches,
)
from sandbox.tables import Integers, Records, Table, aligned_zeros, joined


def direct_tables(layouts: Sequence[DirectLayout], workers: int = 1, units_per_meter: float = 1.0) -> Batches:
    """The tables of layouts, one after another, and no memory yet for parts that have them, but for so many workers.

    Places in the working memory count from where it begins.
    """
    all_layouts = _joined(layouts)
    table, frames, equations = all_layouts.layout, all_layouts.frames, all_layouts.equations
    entries, products, targets = all_layouts.entries, all_layouts.products, all_layouts.targets
    joints, rows = table.frame_end - table.first_frame, table.row_end - table.first_row
    factor = int(entries.place.max(initial=-WIDTH)) + WIDTH
    sizes = np.array([
        _largest(table.seats) * at.SEAT_SIZE, _largest(joints) * at.FRAME_SIZE, _largest(rows) * at.ROW_SIZE,
        factor, factor,
    ])  # fmt: skip
    _, first_frame, first_row, first_entry, first_total, end = np.append(0, np.cumsum(sizes)).tolist()
    for places in (frames.place, frames.coordinate_1, frames.coordinate_2):
        places += first_frame
    for places in (equations.place, entries.other, products.one, products.other):
        places += first_row
    for places in (entries.place, targets):
        places += first_entry
    entries.total += first_total
    nothing = np.zeros(0, np.int64)
    return Batches(
        table, frames, equations, entries, products, targets, nothing, BATCH.zeros(0), BATCH.zeros(workers),
        np.array([0, workers * end, 0, workers * end, end]), np.zeros(1, np.int64),
        nothing, nothing, nothing, np.zeros((3 * MOST_STRUCK) ** 2), np.array([units_per_meter, 1.0 / units_per_meter]),
        np.zeros(0),
    )  # fmt: skip


def with_room(tables: Batches, of_part: Integers, old: Batches | None = None) -> Batches:
    """Layouts with memory for as many batches as parts may make; `of_part` is the layout of each part, -1 where it is
    not factorised. Each level may have one batch that is not full, or two, of which one is staggered. The memory of
    `old` is used if it is large enough.
    """
    layouts = tables.layouts
    count = np.bincount(of_part[of_part >= 0], minlength=len(layouts))
    kinds = LEVELS * (1 + layouts.staggers)
    most = np.minimum(count, (count + kinds * (WIDTH - 1)) // WIDTH)
    joints, rows = layouts.frame_end - layouts.first_frame, layouts.row_end - layouts.first_row
    size = at.LANE_SIZE + layouts.seats * at.SEAT_SIZE + joints * at.JOINT_SIZE + rows * at.KEPT_SIZE
    had = old or tables
    return tables._replace(
        batches=_with_rows(had.batches, int(most.sum())).view(np.recarray),
        found=tables.found.copy(),
        level=np.zeros(1 + HAS_MATRIX, np.int64),
        open=_with_rows(had.open, 2 * len(layouts) * LEVELS),
        parts=_with_rows(had.parts, int(most.sum()) * WIDTH),
        bodies=_with_rows(had.bodies, int(most @ layouts.seats) * WIDTH),
        memory=_with_rows(had.memory, int(tables.found[3] + most @ size)),
    )


def _with_rows(had: NDArray[Any], count: int) -> NDArray[Any]:
    """Memory of at least so many rows: what there was, or twice as much as is needed if there was some already."""
    if len(had) >= count:
        return had
    return aligned_zeros(2 * count if len(had) else count, had.dtype)


def _joined(layouts: Sequence[DirectLayout]) -> DirectLayout:
    """The tables of all layouts, one after another."""
    found = DirectLayout(
        _all(LAYOUT, [each.layout for each in layouts]),
        _all(FRAME, [each.frames for each in layouts]),
        _all(EQUATION, [each.equations for each in layouts]),
        _all(ENTRY, [each.entries for each in layouts]),
        _all(PRODUCT, [each.products for each in layouts]),
        np.concatenate([np.zeros(0, np.int32), *(each.targets for each in layouts)]),
    )
    one = [1] * len(layouts)
    frames, rows = [len(each.frames) for each in layouts], [len(each.equations) for each in layouts]
    entries = [len(each.entries) for each in layouts]
    _shift(found.layout, ("first_frame", "frame_end"), frames, one)
    _shift(found.layout, ("first_row", "row_end"), rows, one)
    _shift(found.frames, ("first_row", "row_end"), rows, frames)
    _shift(found.equations, ("first_entry", "entry_end"), entries, rows)
    _shift(found.equations, ("first_target",), [len(each.targets) for each in layouts], rows)
    _shift(found.entries, ("first_product", "product_end"), [len(each.products) for each in layouts], entries)
    return found


def _all(table: Table, parts: Sequence[Records]) -> Records:
    return joined([table.zeros(0), *parts]).view(np.recarray)


def _shift(table: Records, columns: Sequence[str], sizes: Sequence[int], counts: Sequence[int]) -> None:
    """Make numbers that count from a layout's first count from the first of all, layout by layout."""
    first = np.cumsum([0, *sizes])[:-1]
    for name in columns:
        table[name] += np.repeat(first, counts)


def _largest(counts: Integers) -> int:
    return int(counts.max(initial=0))

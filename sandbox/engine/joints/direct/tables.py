"""The memory of factorised parts, put together from their layouts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sandbox._vectors import WIDTH
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.layout import DirectLayout
from sandbox.engine.joints.direct.records import BATCH, ENTRY, EQUATION, FRAME, LAYOUT, LEVELS, PRODUCT, Batches
from sandbox.tables import Integers, Records, Table, aligned_zeros


def direct_tables(found: Sequence[DirectLayout | None], fixed: Integers) -> tuple[Integers, Batches]:
    """The layout of each part, -1 where it is not factorised, and the memory for all; `fixed` are the bodies on the
    fixed sides of joints, part after part."""
    numbers: dict[int, int] = {}
    layouts: list[DirectLayout] = []
    for each in found:
        if each is not None and id(each) not in numbers:
            numbers[id(each)] = len(layouts)
            layouts.append(each)
    of_part = np.array([-1 if each is None else numbers[id(each)] for each in found], np.int64)
    joined = _joined(layouts)
    return of_part, _memory(joined, fixed, np.bincount(of_part[of_part >= 0], minlength=len(layouts)))


def _joined(layouts: Sequence[DirectLayout]) -> DirectLayout:
    """The tables of all layouts, one after another."""
    found = DirectLayout(
        _all(LAYOUT, [each.layout for each in layouts]),
        _all(FRAME, [each.frames for each in layouts]),
        _all(EQUATION, [each.equations for each in layouts]),
        _all(ENTRY, [each.entries for each in layouts]),
        _all(PRODUCT, [each.products for each in layouts]),
        np.concatenate([np.zeros(0, np.int64), *(each.targets for each in layouts)]),
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


def _memory(joined: DirectLayout, fixed: Integers, count: Integers) -> Batches:
    """Room for as many batches as may be of layouts that `count` parts have: each level may have one that is not full.

    Places in the working memory count from where it begins from now on.
    """
    layouts, frames, equations = joined.layout, joined.frames, joined.equations
    entries, products, targets = joined.entries, joined.products, joined.targets
    most = np.minimum(count, (count + LEVELS * (WIDTH - 1)) // WIDTH)
    joints, rows = layouts.frame_end - layouts.first_frame, layouts.row_end - layouts.first_row
    factor = int(entries.place.max(initial=-WIDTH)) + WIDTH
    sizes = np.array([
        _largest(layouts.seats) * at.SEAT_SIZE, _largest(joints) * at.FRAME_SIZE, _largest(rows) * at.ROW_SIZE, factor,
    ])  # fmt: skip
    _, first_frame, first_row, first_entry, end = np.append(0, np.cumsum(sizes)).tolist()
    for places in (frames.place, frames.coordinate_1, frames.coordinate_2):
        places += first_frame
    for places in (equations.place, entries.other, products.one, products.other):
        places += first_row
    for places in (entries.place, targets):
        places += first_entry
    size = at.LANE_SIZE + layouts.seats * at.SEAT_SIZE + joints * at.JOINT_SIZE + rows * at.KEPT_SIZE
    return Batches(
        layouts, frames, equations, entries, products, targets, fixed, BATCH.zeros(int(most.sum())),
        np.array([0, end, 0, end]), np.zeros(1, np.int64), np.zeros(len(layouts) * LEVELS, np.int64),
        np.zeros(int(most.sum()) * WIDTH, np.int64), np.zeros(int(most @ layouts.seats) * WIDTH, np.int64),
        aligned_zeros(end + int(most @ size), np.float64),
    )  # fmt: skip


def _all(table: Table, parts: Sequence[Records]) -> Records:
    joined: Records = np.concatenate([table.zeros(0), *parts]).view(np.recarray)
    return joined


def _shift(table: Records, columns: Sequence[str], sizes: Sequence[int], counts: Sequence[int]) -> None:
    """Make numbers that count from a layout's first count from the first of all, layout by layout."""
    first = np.cumsum([0, *sizes])[:-1]
    for name in columns:
        table[name] += np.repeat(first, counts)


def _largest(counts: Integers) -> int:
    return int(counts.max(initial=0))

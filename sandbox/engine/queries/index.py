"""The spatial index of all shapes, brought up to date at the first question after a change.

What rests is kept as it was laid out; what has moved since is taken out there and laid out anew each time, in a part of
the grid for itself. So a question after a step costs what moves. All is laid out anew where the lists of the active set
no longer tell who has moved, and once the shapes that have come to rest among the loose have cost as much as that: the
rule for renting skis or buying them, which costs at most twice what it would to know beforehand (A. R. Karlin et al.,
Competitive Snoopy Caching, Algorithmica 3, 1988). The same answers come out either way.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import entry_point, inlined_kernel, kernel
from sandbox.engine.active.active_set import first_from
from sandbox.engine.bodies.flags import disturbs
from sandbox.engine.broad_phase.proxies import turn_core
from sandbox.engine.queries.boxes import bound
from sandbox.engine.queries.cells import empty, fill_part
from sandbox.engine.queries.records import NOTHING, Memory, QueryTables
from sandbox.engine.records.active_set import ActiveSet
from sandbox.geometry.sat import FAR
from sandbox.tables import Integers, Records

LOOSE, NOWHERE = -1, -2
"""What `places` says of a shape, if not where its box is kept: it is laid out each time, or is new."""


@entry_point
def lay_out(tables: QueryTables, active: ActiveSet, memory: Memory) -> None:
    """Bring the index up to date. `active` has the lists that tell who has moved."""
    index, info = memory.info[0], active.info[0]
    shapes = tables.shapes.shape[0]
    known = _is_known(active, index)
    if known:
        _loosen_changed(tables, active, memory)
        known = _is_worth_keeping(index, shapes, info.listed)
    if not known:
        _keep_what_rests(tables, memory)
    _lay_out_loose(tables, memory)
    index.generation = info.generation if info.stale == 0 else NOTHING
    index.settled = active.settled[0]
    index.anew = 0 if known else 1
    index.shapes = shapes


@inlined_kernel
def _is_known(active: ActiveSet, index: Records) -> bool:
    """Whether the lists tell of all who may have moved since the index was brought up to date."""
    info = active.info[0]
    since = active.settled[0] - index.settled
    return bool(info.stale == 0 and info.anew <= index.generation and since < active.settled.shape[0])


@inlined_kernel
def _is_worth_keeping(index: Records, shapes: int, moving: int) -> bool:
    """Whether what is kept costs less than to lay out all anew would have: where less than half of it has been taken
    out, and what lies among the loose needlessly is not more than all shapes, over all times."""
    rests = index.loose - moving
    if rests > 0 and 2 * moving < shapes:
        index.idle += rests
    return bool(index.idle <= shapes and 2 * index.taken <= index.kept)


@kernel
def _loosen_changed(tables: QueryTables, active: ActiveSet, memory: Memory) -> None:
    """Take out what may have moved, came, or has another row since the index was brought up to date."""
    index, info = memory.info[0], active.info[0]
    owners: Any = tables.shapes.body
    shapes = owners.shape[0]
    for i in range(index.shapes, shapes):
        memory.places[i] = NOWHERE
    for i in range(shapes, index.shapes):
        _take_out(i, memory)
    settled: Any = active.settled[1:]
    for n in range(index.settled, active.settled[0]):
        _loosen_body(owners, settled[n % settled.shape[0]], memory)
    for body in active.touched[1 : 1 + active.touched[0]]:
        _loosen_body(owners, body, memory)
    for i in range(first_from(owners, info.bodies), shapes):
        _loosen(i, memory)
    for i in active.shapes[: info.listed]:  # where rows have gone some are none of theirs, which does no harm
        if i < shapes:
            _loosen(i, memory)
    count = 0
    for i in memory.loose[: index.loose]:
        if i < shapes:
            memory.loose[count] = i
            count += 1
    index.loose = count


@kernel
def _loosen_body(owners: Integers, body: int, memory: Memory) -> None:
    """Loosen all shapes of a body, if it is still there."""
    i = first_from(owners, body)
    while i < owners.shape[0] and owners[i] == body:
        _loosen(i, memory)
        i += 1


@inlined_kernel
def _loosen(i: int, memory: Memory) -> None:
    """A shape is laid out each time from now on."""
    if memory.places[i] == LOOSE:
        return
    _take_out(i, memory)
    memory.places[i] = LOOSE
    index = memory.info[0]
    memory.loose[index.loose] = i
    index.loose += 1


@inlined_kernel
def _take_out(i: int, memory: Memory) -> None:
    """Take the box of a shape out of what is kept: nothing meets what ends before it begins."""
    row = memory.places[i]
    if row >= 0:
        box = memory.grid.ordered[row]
        box.lower_x = box.lower_y = FAR
        box.upper_x = box.upper_y = -FAR
        memory.info[0].taken += 1


@kernel
def _keep_what_rests(tables: QueryTables, memory: Memory) -> None:
    """Lay out what does not move to be kept, if that is at least half of all; everything else is loose."""
    index, question, regions = memory.info[0], memory.question[0], memory.grid.regions
    shapes = tables.shapes.shape[0]
    moving = 0
    for i in range(shapes):
        moves = disturbs(tables.bodies[tables.shapes[i].body])
        memory.places[i] = LOOSE if moves else NOWHERE
        moving += 1 if moves else 0
    kept = loose = 0
    for i in range(shapes):
        if memory.places[i] == LOOSE or 2 * moving > shapes:
            memory.places[i] = LOOSE
            memory.loose[loose] = i
            loose += 1
        else:
            _turn_and_bound(tables, memory, i, kept)
            kept += 1
    question.region_count = question.sparse_count = 0
    empty(regions[regions.shape[0] - 1])
    fill_part(memory, kept, 0, 0)
    regions[regions.shape[0] - 2] = regions[regions.shape[0] - 1]
    for row in range(kept):
        memory.places[memory.grid.ordered[row].shape_index] = row
    index.kept_regions = question.region_count
    index.kept_sparse = question.sparse_count
    index.kept = kept
    index.loose = loose
    index.taken = index.idle = 0


@kernel
def _lay_out_loose(tables: QueryTables, memory: Memory) -> None:
    """Lay out what is loose behind what is kept."""
    index, question, regions = memory.info[0], memory.question[0], memory.grid.regions
    question.region_count = index.kept_regions
    question.sparse_count = index.kept_sparse
    regions[regions.shape[0] - 1] = regions[regions.shape[0] - 2]
    for n in range(index.loose):
        _turn_and_bound(tables, memory, memory.loose[n], n)
    fill_part(memory, index.loose, index.kept, memory.grid.heads.shape[0] // 2)


@inlined_kernel
def _turn_and_bound(tables: QueryTables, memory: Memory, i: int, row: int) -> None:
    """Turn the core of a shape and write its box to a row of `memory.boxes`."""
    shape = tables.shapes[i]
    turn_core(tables.bodies[shape.body], shape, tables.vertices, memory.cores)
    bound(tables, memory, i, memory.boxes[row])

"""Elimination order and fill of a sparse LDL^T factorisation, with sets: the judge of `joints/elimination.py` and
`joints/symbolic.py`."""

from __future__ import annotations

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

_FREE_UPDATES = 2000


@dataclass
class Pattern:
    """The lower triangles of all parts: column r begins at `starts[r]` with its diagonal; `row_of` names the row of
    each entry, `targets` lists the entries from which eliminating each column subtracts."""

    starts: list[int] = field(default_factory=list)
    row_of: list[int] = field(default_factory=list)
    targets: list[int] = field(default_factory=list)


def minimum_degree(
    nodes: Sequence[int], neighbours: Mapping[int, Sequence[int]], weights: Mapping[int, int], limit: int
) -> tuple[list[int], bool]:
    """Elimination order of a graph, and whether it takes at most about `limit` updates a row."""
    left = {n: set(neighbours[n]) for n in nodes}
    degrees = {n: sum(weights[k] for k in left[n]) for n in nodes}
    heap = [(degree, n) for n, degree in degrees.items()]
    heapq.heapify(heap)
    budget = limit * sum(weights[n] for n in nodes) + _FREE_UPDATES
    order: list[int] = []
    while heap:
        degree, n = heapq.heappop(heap)
        if degrees.get(n) != degree:
            continue
        budget -= weights[n] * (degree + weights[n]) ** 2 // 2
        if budget < 0:
            return list(nodes), False
        around = left.pop(n)
        del degrees[n]
        order.append(n)
        for k in around:
            new = around - left[k] - {k}
            left[k] |= new
            left[k].remove(n)
            degrees[k] += sum(weights[m] for m in new) - weights[n]
            heapq.heappush(heap, (degrees[k], k))
    return order, True


def symbolic(
    blocks: Sequence[Sequence[int]], below: Sequence[Sequence[Sequence[int]]], pattern: Pattern
) -> dict[tuple[int, int], int]:
    """Append the columns of one part to `pattern`; return where each pair (column, row) lies.

    `blocks` are the rows of each joint in elimination order, `below` the rows of later joints it shares bodies with.
    """
    block_of = {r: k for k, block in enumerate(blocks) for r in block}
    filled = [sorted({block_of[rows[0]] for rows in group}) for group in below]
    for later in filled:
        if later:  # what is eliminated links all that it was linked to
            filled[later[0]] = sorted({*filled[later[0]], *later[1:]})
    entry: dict[tuple[int, int], int] = {}
    columns: list[tuple[int, list[int]]] = []
    for block, later in zip(blocks, filled, strict=True):
        rows = [*block, *(r for m in later for r in blocks[m])]
        for i, r in enumerate(block):
            below_r = rows[i + 1 :]
            pattern.starts.append(len(pattern.row_of))
            for row in (r, *below_r):
                entry[r, row] = len(pattern.row_of)
                pattern.row_of.append(row)
            columns.append((r, below_r))
    pattern.targets += [entry[s, t] for _, rows in columns for i, s in enumerate(rows) for t in rows[i:]]
    return entry

"""Every pair of overlapping boxes, by looking at all of them: what the grid's pairs are held against."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from sandbox.engine.broad_phase.proxies import ACTIVE, DRIVEN, SLEEPS
from sandbox.tables import Floats, Integers, Records
from sandbox.world.records import DYNAMIC

_AT_ONCE = 1 << 21


def overlapping_pairs(boxes: Floats) -> Integers:
    """(m, 2): all (a, b) with a < b whose boxes (n, 4; lower x, lower y, upper x, upper y) share a point, in order.

    Boxes are sorted by their left sides, so each one needs to be held only against those that begin before it ends;
    no other use is made of where they lie.
    """
    order = np.argsort(boxes[:, 0], kind="stable")
    ordered = boxes[order]
    ends = np.searchsorted(ordered[:, 0], ordered[:, 2], side="right")
    counts = np.maximum(ends - np.arange(1, len(boxes) + 1), 0)
    found = [_overlapping(ordered, first, last, counts) for first, last in _portions(counts)]
    pairs = np.sort(order[np.concatenate(found)] if found else np.zeros((0, 2), np.int64), axis=1)
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


def _portions(counts: Integers) -> list[tuple[int, int]]:
    """Runs of boxes [first, last) that have about `_AT_ONCE` others to be held against."""
    if not len(counts):
        return []
    total = np.cumsum(counts)
    cuts = np.searchsorted(total, np.arange(_AT_ONCE, total[-1], _AT_ONCE))
    edges = np.unique(np.concatenate([[0], cuts, [len(counts)]]))
    return [(int(a), int(b)) for a, b in pairwise(edges)]


def _overlapping(ordered: Floats, first: int, last: int, counts: Integers) -> Integers:
    some = counts[first:last]
    i = np.repeat(np.arange(first, last), some)
    j = i + 1 + np.arange(len(i)) - np.repeat(np.cumsum(some) - some, some)
    meet = (ordered[i, 1] <= ordered[j, 3]) & (ordered[j, 1] <= ordered[i, 3])
    return np.stack([i[meet], j[meet]], axis=1)


def that_matter(pairs: Integers, bodies: Records, shapes: Records) -> Integers:
    """Those `pairs` of shapes on which a step has to decide: filters let them collide, and one can move.

    A pair matters if one of its bodies is simulated, or one sleeps and the other is driven. `bodies` as they were
    when the step began.
    """
    a: Any = shapes[pairs[:, 0]]
    b: Any = shapes[pairs[:, 1]]
    moves = _how_bodies_move(bodies)
    both = moves[a.body] | moves[b.body]
    alive = ((both & ACTIVE) != 0) | (both == SLEEPS | DRIVEN)
    solid = (a.sensor | b.sensor) == 0
    matter: Integers = pairs[(a.body != b.body) & solid & alive & _filters_agree(a, b)]
    return matter


def not_joined(pairs: Integers, bonds: Records, shapes: Records) -> Integers:
    """Those `pairs` of shapes whose bodies no joint keeps from colliding; `bonds` are rows (low body, high body)."""
    if not len(bonds):
        return pairs
    bodies = np.sort(np.asarray(shapes.body)[pairs], axis=1)
    span = int(np.asarray(shapes.body).max()) + 1
    free: Integers = pairs[~np.isin(bodies[:, 0] * span + bodies[:, 1], bonds.low * span + bonds.high)]
    return free


def _how_bodies_move(bodies: Records) -> Integers:
    driven = (bodies.velocity_x != 0.0) | (bodies.velocity_y != 0.0) | (bodies.angular_velocity != 0.0)
    driven |= bodies.posed == 1
    dynamic = np.where(bodies.awake == 1, ACTIVE, SLEEPS)
    return np.where(bodies.type == DYNAMIC, dynamic, np.where(driven, DRIVEN, 0))


def _filters_agree(a: Records, b: Records) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """A shared group decides by its sign; otherwise each mask must hold the other's category."""
    masks = ((a.category & b.mask) != 0) & ((b.category & a.mask) != 0)
    agree: np.ndarray[tuple[int], np.dtype[np.bool_]] = np.where(
        (a.group == b.group) & (a.group != 0), a.group > 0, masks
    )
    return agree

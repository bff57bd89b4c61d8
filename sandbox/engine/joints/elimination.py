"""In which order the joints of a part are eliminated, and whether that is worth it.

Minimum degree: W. Tinney, J. Walker, "Direct Solutions of Sparse Network Equations", 1967; ties go to the lowest
number, so that the order is the same everywhere. The graph is kept as cliques: at first the joints of each body, then
what each eliminated joint leaves linked, which is its column of the factor, in the place of the cliques that it was in
(J. A. George, J. W. H. Liu, "The Evolution of the Minimum Degree Ordering Algorithm", 1989).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sandbox._jit import entry_point, interpreted, kernel
from sandbox.tables import Integers

WORLD = -1
"""In the place of a member: something that joints cannot move."""
NOBODY = -2
"""In the place of a member: the joint has no such side."""
_FREE_UPDATES = 2000
FEW_JOINTS = 250
"""Up to so many joints Python is at the end before machine code is found."""
_DONE = 1 << 62
"""The key of joints that are eliminated."""


class Cliques(NamedTuple):
    """Joints that are linked to each other: clique c has `joints[first[c] : first[c] + length[c]]`; `of_joint` are the
    up to four that each joint is in, else less than 0; `closed` those that have gone into others."""

    joints: Integers
    first: Integers
    length: Integers
    of_joint: Integers
    closed: Integers


class Elimination(NamedTuple):
    """The joints of a part in the order of their elimination, and for each place in it the places of those that were
    linked to that joint by then, ascending, `below[ends[place - 1] : ends[place]]`."""

    order: Integers
    below: Integers
    ends: Integers


def minimum_degree(sides: Integers, weights: Integers, updates: int) -> Elimination | None:
    """How to eliminate joints, of which each has up to four `sides`: bodies from 0 on, which link those that have them,
    `WORLD` or `NOBODY`. `weights` are how many rows each has, at least one.

    None if that takes more than about so many `updates` a row.
    """
    count, budget = len(sides), budget_of(weights, updates)
    # A clique of m joints costs m^2 / 2 updates and more, so that all together have no more than this.
    cliques, used = _cliques(sides, math.isqrt(2 * count * budget) + 1 if budget > 0 else 0)
    order, seen = np.zeros(count, np.int64), np.zeros(count, np.int64)
    keys = np.full(2 << max(count - 1, 0).bit_length(), _DONE, np.int64)
    run = eliminate if count > FEW_JOINTS else interpreted(eliminate)
    if run(cliques, weights, budget, order, seen, keys) < count:
        return None
    counts = cliques.length[-count:]
    place = np.argsort(order)
    below = place[cliques.joints[used : used + int(counts.sum())]]
    of_place = np.repeat(np.arange(count), counts)
    return Elimination(order, below[np.lexsort((below, of_place))], np.cumsum(counts))


def budget_of(weights: Integers, updates: int) -> int:
    """How many updates the joints of a part may take, at so many a row."""
    return updates * int(weights.sum()) + _FREE_UPDATES


def _cliques(sides: Integers, more: int) -> tuple[Cliques, int]:
    """The joints of each body, with room for `more` numbers of cliques that come; and how many these take up."""
    bodies, joints = int(sides.max(initial=-1)) + 1, len(sides)
    joint, _ = np.nonzero(sides >= 0)
    body = sides[sides >= 0]
    order = np.argsort(body, kind="stable")
    first, count, closed = (np.zeros(bodies + joints, np.int64) for _ in range(3))
    count[:bodies] = np.bincount(body, minlength=bodies)
    first[:bodies] = np.cumsum(count[:bodies]) - count[:bodies]
    return Cliques(np.append(joint[order], np.zeros(more, np.int64)), first, count, sides.copy(), closed), len(joint)


@entry_point
def eliminate(cliques: Cliques, weights: Integers, budget: int, order: Integers, seen: Integers, keys: Integers) -> int:
    """Write the `order` of elimination, and what it leaves linked as further cliques, one for each place.

    `seen` is 0 for each joint, `keys` are twice as many `_DONE` as a power of two no less than the joints. Returns how
    many joints are eliminated before there have been more updates than the `budget`.
    """
    joints: int = weights.shape[0]
    bodies = cliques.first.shape[0] - joints
    leaves = keys.shape[0] // 2
    most = int(math.sqrt(2.0 * budget)) + 1 if budget > 0 else 0  # a joint linked to more rows is not eliminated
    stamp = 0
    for j in range(joints):
        stamp += 1
        keys[leaves + j] = _degree(cliques, weights, seen, j, stamp, most) * joints + j
    for k in range(leaves - 1, 0, -1):
        keys[k] = keys[2 * k] if keys[2 * k] < keys[2 * k + 1] else keys[2 * k + 1]
    end = cliques.first[bodies - 1] + cliques.length[bodies - 1] if bodies > 0 else 0
    for place in range(joints):
        degree = keys[1] // joints
        j = keys[1] - degree * joints
        budget -= weights[j] * (degree + weights[j]) * (degree + weights[j]) // 2
        if budget < 0:
            return place
        order[place] = j
        stamp += 1
        clique = bodies + place
        cliques.first[clique] = end
        end = _unite(cliques, seen, j, clique, stamp)
        _set_key(keys, leaves + j, _DONE)
        for i in range(cliques.first[clique], end):
            k = cliques.joints[i]
            _exchange(cliques, k, clique)
            stamp += 1
            _set_key(keys, leaves + k, _degree(cliques, weights, seen, k, stamp, most) * joints + k)
    return joints


@kernel
def _degree(cliques: Cliques, weights: Integers, seen: Integers, j: int, stamp: int, most: int) -> int:
    """Rows of the joints that joint j is linked to, or of some of them if that is more than `most`."""
    seen[j] = stamp
    total = 0
    for side in range(4):
        clique = cliques.of_joint[j, side]
        if clique >= 0:
            for i in range(cliques.first[clique], cliques.first[clique] + cliques.length[clique]):
                k = cliques.joints[i]
                if seen[k] != stamp:
                    seen[k] = stamp
                    total += weights[k]
                    if total > most:
                        return int(total)
    return total


@kernel
def _unite(cliques: Cliques, seen: Integers, j: int, clique: int, stamp: int) -> int:
    """Make a `clique` of all that joint j is linked to and close those that linked them; returns where it ends."""
    seen[j] = stamp
    end = cliques.first[clique]
    for side in range(4):
        old = cliques.of_joint[j, side]
        if old >= 0:
            cliques.closed[old] = 1
            for i in range(cliques.first[old], cliques.first[old] + cliques.length[old]):
                k = cliques.joints[i]
                if seen[k] != stamp:
                    seen[k] = stamp
                    cliques.joints[end] = k
                    end += 1
    cliques.length[clique] = end - cliques.first[clique]
    return int(end)


@kernel
def _exchange(cliques: Cliques, j: int, clique: int) -> None:
    """Put joint j into a clique in the place of those that are closed."""
    for side in range(4):
        old = cliques.of_joint[j, side]
        if old >= 0 and cliques.closed[old] == 1:
            cliques.of_joint[j, side] = clique
            clique = -1


@kernel
def _set_key(keys: Integers, k: int, key: int) -> None:
    """Set a leaf of a tournament whose nodes have the least of the two keys below them."""
    keys[k] = key
    k //= 2
    while k > 0:
        keys[k] = keys[2 * k] if keys[2 * k] < keys[2 * k + 1] else keys[2 * k + 1]
        k //= 2

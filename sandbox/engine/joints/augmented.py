"""Parts that are sparse but for a few bodies with many joints: a wheel with its spokes, a beam on which much hangs.

All joints of a body are linked to each other, so that the factor of a star is full. Where a body's velocity stays in
the system as an unknown, each joint is linked to that alone: the augmented system (A B; B' -M), in which M is the mass
of the body and B what the joints do to it. It has the same solution, and is quasi-definite, so that its LDL^T exists
in any order in which no joint comes before all of its bodies: those that only such bodies and the world hold come last.

R. Vanderbei, "Symmetric Quasidefinite Matrices", SIAM Journal on Optimization 5 (1995); on joints D. Baraff,
"Linear-Time Dynamics using Lagrange Multipliers", 1996.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.elimination import NOBODY, Elimination, budget_of, minimum_degree
from sandbox.tables import Integers

ROWS_OF_BODY = 3
"""Unknowns of a body: its velocity along x and y, and its turn."""
MANY_ROWS = 16
"""A body whose joints have more rows than that may stay in the system."""


def augment(sides: Integers, weights: Integers, updates: int) -> tuple[Elimination, Integers] | None:
    """How to eliminate the joints of a part, and bodies that stay in its system, which are numbered after them.

    Takes what `minimum_degree` does, and returns those bodies besides; None if that takes more than about so many
    `updates` a row as well.
    """
    movable = sides >= 0
    bodies = np.flatnonzero(np.bincount(sides[movable], np.repeat(weights, movable.sum(axis=1))) > MANY_ROWS)
    stay = movable & np.isin(sides, bodies)
    alone = (stay | ~movable).all(axis=1)  # joints of such bodies and the world
    early, late = np.flatnonzero(~alone), np.flatnonzero(alone)
    last = ROWS_OF_BODY * len(bodies) + int(weights[late].sum())  # rows that are all linked to each other
    if not len(bodies) or not len(early) or last**3 // 6 > budget_of(weights, updates):
        return None
    found = minimum_degree(np.where(stay, NOBODY, sides)[early], weights[early], updates)
    if found is None:
        return None
    first = early[found.order]
    linked = _linked(found, np.where(stay, np.searchsorted(bodies, sides), NOBODY)[first], len(bodies))
    below = [
        np.append(joints, len(early) + np.flatnonzero(also))
        for joints, also in zip(_columns(found), linked, strict=True)
    ]
    tail = len(early) + np.arange(len(bodies) + len(late))
    below += [tail[1 + k :] for k in range(len(tail))]
    order = np.concatenate([first, len(sides) + np.arange(len(bodies)), late])
    whole = Elimination(order, np.concatenate(below), np.cumsum([len(each) for each in below]))
    counts = np.append(weights, np.full(len(bodies), ROWS_OF_BODY))[order]
    return (whole, bodies) if _updates(whole, counts) <= budget_of(weights, updates) else None


def _columns(found: Elimination) -> list[Integers]:
    """What is linked to each joint when it is eliminated."""
    return np.split(found.below, found.ends[:-1])


def _linked(found: Elimination, own: Integers, bodies: int) -> NDArray[np.bool_]:
    """To which of the bodies that stay each joint is linked when it is eliminated: its `own`, by their numbers, and
    what its children in the elimination tree were linked to."""
    linked = np.zeros((len(own), bodies), np.bool_)
    joint, side = np.nonzero(own >= 0)
    linked[joint, own[joint, side]] = True
    for place, below in enumerate(_columns(found)):
        if len(below):
            linked[below[0]] |= linked[place]
    return linked


def _updates(found: Elimination, counts: Integers) -> int:
    """About how many multiplications it takes to factorise."""
    lengths = np.diff(found.ends, prepend=0)
    sums = np.append(0, np.cumsum(counts[found.below]))
    rows = counts + sums[found.ends] - sums[found.ends - lengths]
    return int((counts * rows * rows // 2).sum())

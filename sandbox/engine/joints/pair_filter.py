"""Stage: bodies that are joined do not collide, unless their joint says so."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sandbox._jit import kernel
from sandbox.tables import Integers, Records, plain

NO_BOND = -1


class JointFilter(NamedTuple):
    """The pairs of bodies that joints keep from colliding, sorted by (low, high body), and for each body the first one
    of which it is the low one, or `NO_BOND`."""

    bonds: Records
    first: Integers


def note_first(joint_filter: JointFilter, start: int = 0) -> JointFilter:
    """Note which bonds from row `start` on are the first ones of bodies; none of these is the low one of others."""
    low = plain(joint_filter.bonds)["low"][start:]
    begins = np.flatnonzero(np.diff(low, prepend=NO_BOND))
    joint_filter.first[low[begins]] = start + begins
    return joint_filter


@kernel
def are_joined(joint_filter: JointFilter, a: int, b: int) -> bool:
    """Whether a joint keeps two bodies from colliding."""
    bonds = joint_filter.bonds
    low = a if a < b else b
    high = b if a < b else a
    k = joint_filter.first[low]
    if k == NO_BOND:
        return False
    end = bonds.shape[0]
    stride = 1  # most bodies have few, some thousands
    while k + stride < end and _comes_before(bonds[k + stride - 1], low, high):
        k += stride
        stride *= 2
    k = _first_bond(bonds, k, k + stride if k + stride < end else end, low, high)
    return bool(k < end and bonds[k].low == low and bonds[k].high == high)


@kernel
def _first_bond(bonds: Records, start: int, end: int, low: int, high: int) -> int:
    """The first of the bonds start..end-1 that does not come before a pair of bodies, or `end`: by bisection."""
    while start < end:
        middle = (start + end) // 2
        if _comes_before(bonds[middle], low, high):
            start = middle + 1
        else:
            end = middle
    return start


@kernel
def _comes_before(bond: Records, low: int, high: int) -> bool:
    return bool(bond.low < low or (bond.low == low and bond.high < high))

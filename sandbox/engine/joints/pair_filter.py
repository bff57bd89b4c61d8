"""Stage: bodies that are joined do not collide, unless their joint says so."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.tables import Integers, Records


class JointFilter(NamedTuple):
    """The pairs of bodies that joints keep from colliding, sorted by (low, high body), and 1 for each such body."""

    bonds: Records
    joined: Integers


@kernel
def are_joined(joint_filter: JointFilter, a: int, b: int) -> bool:
    """Whether a joint keeps two bodies from colliding."""
    if joint_filter.joined[a] == 0 or joint_filter.joined[b] == 0:
        return False
    bonds = joint_filter.bonds
    low = a if a < b else b
    high = b if a < b else a
    k = _first_bond(bonds, low, high)
    return bool(k < bonds.shape[0] and bonds[k].low == low and bonds[k].high == high)


@kernel
def _first_bond(bonds: Records, low: int, high: int) -> int:
    """Where the bonds of a pair of bodies begin, by bisection."""
    start = 0
    end = bonds.shape[0]
    while start < end:
        middle = (start + end) // 2
        bond = bonds[middle]
        if bond.low < low or (bond.low == low and bond.high < high):
            start = middle + 1
        else:
            end = middle
    return start

"""The linear system of a part: sparse LDL^T of J M^-1 J^T + softness, along the pattern found when the world was made.

T. Davis, "Direct Methods for Sparse Linear Systems", 2006; for jointed bodies D. Baraff, "Linear-Time Dynamics using
Lagrange Multipliers", 1996. A row that is not active has the column of the unit matrix.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.jacobian import push_row, row_speed, side_product
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records

_REDUNDANT = 1e-10
"""A pivot that has shrunk to this share of its stiffness says what other rows say already."""


@kernel
def factorize(work: JointWork, part: Records) -> None:
    """Assemble and factorise the matrix of the active rows of a part."""
    _assemble(work, part)
    entries = work.entries
    starts = work.starts
    targets = work.targets
    t = part.first_target
    for r in range(part.first_row, part.row_end):
        first = starts[r]
        end = starts[r + 1]
        row = work.rows[r]
        whole = row.stiffness + row.softness if row.active == 1 else 1.0
        inverse = 1.0 / entries[first] if entries[first] > _REDUNDANT * whole else 0.0
        for i in range(first + 1, end):
            scaled = entries[i] * inverse
            for k in range(i, end):
                entries[targets[t]] -= scaled * entries[k]
                t += 1
        for i in range(first + 1, end):
            entries[i] = entries[i] * inverse
        entries[first] = inverse


@kernel
def _assemble(work: JointWork, part: Records) -> None:
    for i in range(work.starts[part.first_row], work.starts[part.row_end]):
        work.entries[i] = 0.0
    for k in range(part.first_link, part.link_end):
        link = work.links[k]
        row = work.rows[link.row]
        other = work.rows[link.other]
        if row.active == 1 and other.active == 1:
            product = side_product(work.members, row, link.side, other, link.other_side)
            work.entries[link.entry] += product
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        work.entries[work.starts[r]] = work.entries[work.starts[r]] + row.softness if row.active == 1 else 1.0


@kernel
def solve_directly(work: JointWork, part: Records, relaxing: bool) -> None:
    """Give all active rows of a part, at once, the impulses that they strive for."""
    rows = work.rows
    entries = work.entries
    for r in range(part.first_row, part.row_end):
        row = rows[r]
        row.change = 0.0
        if row.active == 1:
            current = row.relaxing if relaxing else row.impulse
            row.change = -(row_speed(work.members, row) + row.bias + row.softness * current)
    for r in range(part.first_row, part.row_end):
        for i in range(work.starts[r] + 1, work.starts[r + 1]):
            rows[work.row_of[i]].change -= entries[i] * rows[r].change
    for r in range(part.row_end - 1, part.first_row - 1, -1):
        value = rows[r].change * entries[work.starts[r]]
        for i in range(work.starts[r] + 1, work.starts[r + 1]):
            value -= entries[i] * rows[work.row_of[i]].change
        rows[r].change = value
    for r in range(part.first_row, part.row_end):
        row = rows[r]
        if row.active == 1:
            change_impulse(work, row, row.change, relaxing)


@kernel
def change_impulse(work: JointWork, row: Records, change: float, relaxing: bool) -> None:
    """Add to a row's impulse and to the velocities of its members."""
    if relaxing:
        row.relaxing += change
    else:
        row.impulse += change
    push_row(work.members, row, change)

"""Parts that hang together too densely to be factorised (nets, cloth): projected Gauss-Seidel sweeps, warm started."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.jacobian import row_speed
from sandbox.engine.joints.ldl import change_impulse
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records

SWEEPS = 8


@kernel
def solve_by_sweeps(work: JointWork, part: Records, relaxing: bool) -> None:
    """Solve the active rows of a part one after another, forwards and backwards in turn."""
    for sweep in range(SWEEPS):
        for k in range(part.row_end - part.first_row):
            r = part.first_row + k if sweep % 2 == 0 else part.row_end - 1 - k
            row = work.rows[r]
            if row.active == 0:
                continue
            current = row.relaxing if relaxing else row.impulse
            wanted = row_speed(work.members, row) + row.bias + row.softness * current
            after = current - wanted / (row.stiffness + row.softness)
            after = after if after < row.high else row.high
            after = after if after > row.low else row.low
            change_impulse(work, row, after - current, relaxing)

"""The tasks that workers share, by number, and what they are told beside the range."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.records.contact_blocks import SoftContact
from sandbox.tables import Floats

# Of `collide`, `solve`, `finish`, `do_joints` and `do_nets`, in this order.
DECIDE_PAIRS = 1
WRITE_CONTACTS = 2
BOUND_SHAPES = 3
PREPARE_CONTACTS = 4
WARM_START = 5
SOLVE_AGAIN = 6
SOLVE_CONTACTS = 7
STORE_IMPULSES = 8
INTEGRATE_VELOCITIES = 9
INTEGRATE_POSITIONS = 10
ADD_PARTS = 11
TURN_PARTS = 12
PREPARE_FORCES = 13
FLY = 14
GUARD_VELOCITIES = 15
SOLVE_ISLANDS = 16
FINISH_BODIES = 17
SOLVE_BATCHES = 18
RELAX_BATCHES = 19
LOAD_NETS = 20
WARM_START_NETS = 21
SWEEP_NETS = 22
REPORT_NETS = 23

# Places in `Workers.numbers`; the fields of `SoftContact` come first. The range to do is told to each worker by itself.
SECONDS = 8
GRAVITY = 9
LEVEL = 10
IMPACTS = 11
PUSH = 12
MOST = 13
GIVE = 14
UNSETTLED = 15
IMPACT_SPEED = 16
SUBSTEPS = 17
STRUCK_BLOCKS = 18
ANEW = 19
BATCH = 20
IMPACT_SECONDS = 21
FIRST = 22
END = 23
UNITS = 24
STAGE = 25
SLOTS = 26


@kernel
def tell_soft(numbers: Floats, soft: SoftContact) -> None:
    """Tell who solves contacts how to treat them."""
    numbers[0] = soft.inverse_seconds
    numbers[1] = soft.bias_rate
    numbers[2] = soft.softness
    numbers[3] = soft.slowest_bias
    numbers[4] = soft.impact_allowance
    numbers[5] = soft.over_relaxation
    numbers[6] = 1.0 if soft.sums else 0.0
    numbers[7] = 1.0 if soft.keeps else 0.0


@kernel
def told_soft(n: Floats) -> SoftContact:
    """How contacts are to be treated."""
    return SoftContact(n[0], n[1], n[2], n[3], n[4], n[5], n[6] > 0.0, n[7] > 0.0)

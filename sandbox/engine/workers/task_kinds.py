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
SECONDS = 9
GRAVITY = 10
LEVEL = 11
IMPACTS = 12
PUSH = 13
MOST = 14
GIVE = 15
UNSETTLED = 16
IMPACT_SPEED = 17
SUBSTEPS = 18
STRUCK_BLOCKS = 19
ANEW = 20
BATCH = 21
IMPACT_SECONDS = 22
FIRST = 23
END = 24
UNITS = 25
STAGE = 26
SLOTS = 27


@kernel
def tell_soft(numbers: Floats, soft: SoftContact) -> None:
    """Tell who solves contacts how to treat them."""
    numbers[0] = soft.inverse_seconds
    numbers[1] = soft.bias_rate
    numbers[2] = soft.softness
    numbers[3] = soft.softness_jointed
    numbers[4] = soft.slowest_bias
    numbers[5] = soft.impact_allowance
    numbers[6] = soft.over_relaxation
    numbers[7] = 1.0 if soft.sums else 0.0
    numbers[8] = 1.0 if soft.keeps else 0.0


@kernel
def told_soft(n: Floats) -> SoftContact:
    """How contacts are to be treated."""
    return SoftContact(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7] > 0.0, n[8] > 0.0)

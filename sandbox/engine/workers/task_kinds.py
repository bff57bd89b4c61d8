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
SECONDS = 10
GRAVITY = 11
LEVEL = 12
IMPACTS = 13
PUSH = 14
MOST = 15
GIVE = 16
UNSETTLED = 17
IMPACT_SPEED = 18
SUBSTEPS = 19
STRUCK_BLOCKS = 20
ANEW = 21
BATCH = 22
IMPACT_SECONDS = 23
FIRST = 24
END = 25
UNITS = 26
STAGE = 27
SLOTS = 28


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
    numbers[7] = soft.touching
    numbers[8] = 1.0 if soft.sums else 0.0
    numbers[9] = 1.0 if soft.keeps else 0.0


@kernel
def told_soft(n: Floats) -> SoftContact:
    """How contacts are to be treated."""
    return SoftContact(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8] > 0.0, n[9] > 0.0)

"""The tasks that workers share, by number, and what they are told beside the range."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.records.contact_blocks import SoftContact
from sandbox.tables import Floats

DECIDE_PAIRS = 1
WRITE_CONTACTS = 2
PREPARE_CONTACTS = 3
WARM_START = 4
SOLVE_AGAIN = 5
SOLVE_CONTACTS = 6
STORE_IMPULSES = 7
INTEGRATE_VELOCITIES = 8
INTEGRATE_POSITIONS = 9
SOLVE_BATCHES = 10
RELAX_BATCHES = 11
WARM_START_HINGES = 12
SWEEP_HINGES = 13
SOLVE_ISLANDS = 14

# Places in `Workers.numbers`; the fields of `SoftContact` come first.
SECONDS = 6
GRAVITY = 7
LEVEL = 8
IMPACTS = 9
FASTEST = 10
PUSH = 11
MOST = 12
GIVE = 13
UNSETTLED = 14
IMPACT_SPEED = 15


@kernel
def tell_soft(numbers: Floats, soft: SoftContact) -> None:
    """Tell who solves contacts how to treat them."""
    numbers[0] = soft.inverse_seconds
    numbers[1] = soft.bias_rate
    numbers[2] = soft.softness
    numbers[3] = soft.slowest_bias
    numbers[4] = soft.impact_allowance
    numbers[5] = soft.over_relaxation


@kernel
def told_soft(n: Floats) -> SoftContact:
    """How contacts are to be treated."""
    return SoftContact(n[0], n[1], n[2], n[3], n[4], n[5])

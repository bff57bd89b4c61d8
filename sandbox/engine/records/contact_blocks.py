"""Contacts in the order in which they are solved, and the memory in which they are."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.engine.records.batches import Batches
from sandbox.tables import Field, Floats, Integers, Records, Table

BLOCK = Table(
    "block",
    (
        Field("first", "-", "its first slot", "i4"),
        Field("count", "-", "lanes in use, 1..4", "i4"),
        Field("serial", "-", "1 when its contacts may share bodies and are solved one by one", "i2"),
        Field("frictional", "-", "1 when some contact has friction", "i2"),
        Field("rolling", "-", "1 when some contact has rolling resistance", "i4"),
        Field("driven", "-", "1 when some contact has a surface speed", "i2"),
        Field("jointed", "-", "1 when joints hold a body of some contact", "i2"),
        Field("rounded", "-", "1 when some contact is one of rounded shapes", "i4"),
        Field("strikes", "-", "1 when some contact may have an impact", "i4"),
        Field("single", "-", "1 when no contact has two points", "i4"),
        *(Field(f"{side}{k}", "-", f"body {side} of lane {k}", "i4") for side in "ab" for k in range(4)),
    ),
)
"""One cache line a block. Lanes that are not used have the bodies of the first one."""


class ContactBlocks(NamedTuple):
    """Contact constraints laid out for the solver, see `blocks`.

    `slots` has them colour by colour, `colors` the colour of each active contact, `starts` first how many ranges of
    one colour the blocks fall into, then the first block of each and behind them the number of blocks; `heads`,
    `further` and `further_heads` are scratch of the counting sorts by batch and colour, `sets` the further colours that
    bodies have. `spare` is scratch for other orders of them. `batches` are those that islands fall into.
    """

    slots: Records
    blocks: Records
    colors: Integers
    lanes: Floats
    starts: Integers
    heads: Integers
    further: Integers
    further_heads: Integers
    sets: Integers
    spare: Records
    batches: Batches


class BlockRanges(NamedTuple):
    """How many blocks of contacts there are, and which are of what kind: the first `unsettled` ones of unsettled
    bodies, of these the first `struck` ones of bodies that a hard impact without restitution reaches, and the ones
    from `deep_first` to before `deep_end` of bodies that overlap deeply."""

    total: int
    unsettled: int
    struck: int
    deep_first: int
    deep_end: int


class SoftContact(NamedTuple):
    """How a pass treats contacts, from `contact_coefficients`.

    `softness` is the share of an impulse by which the springs of overlaps give way in a pass, 0 for rigid ones, and
    `softness_jointed` that of bodies which joints hold.
    `slowest_bias` (m/s, negative or zero) bounds the velocity that pushes overlapping bodies apart; zero makes the pass
    a relax pass, which removes the velocity that the push has added. `impact_allowance` (m/s) is added to the speed at
    which contacts that may have an impact may close while they are apart. `over_relaxation` is the share by which
    the normal impulses of two points go beyond what is asked of them. Gaps up to `touching` (m) are closed but for
    rounding, as what was stopped just when it arrived leaves them, and count as overlaps. `sums` adds those that a pass
    begins with to what the step has given so far. `keeps` notes what the pass adds to velocities along the normal, for
    others at the same poses.
    """

    inverse_seconds: float
    bias_rate: float
    softness: float
    softness_jointed: float
    slowest_bias: float
    impact_allowance: float
    over_relaxation: float
    touching: float
    sums: bool
    keeps: bool

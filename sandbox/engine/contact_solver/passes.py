"""How the passes over contacts in a substep treat them: rigid, soft, or taking back what pushed overlaps apart."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.contact_solver.soft_constraint import TOUCHING, Spring
from sandbox.engine.contact_solver.solve import solve_again, solve_contacts
from sandbox.engine.contact_solver.warm_start import forget_impulses
from sandbox.engine.records.contact_blocks import BlockRanges, ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.tables import Records

WAIT = 1e30
"""Speed (m/s) that a relax pass grants contacts which may bounce: the next substep decides on their impact."""

AT_ONCE = 1e30
"""Rate (1/s) at which points apart may close their gap where contacts are not speculative: they are left alone."""

OVER_RELAXATION = 0.2
"""Of the relax pass, which finds the loads that the next substep begins with: the top of a pyramid of 110 rows that is
put down at rest jumps by 6 cm, without it by 14. In the soft pass as well it would be 2 cm, but then some heaps never
come to rest, as springs are too lively."""

RELAX_DEEP = 8
"""Relax passes where bodies overlap deeply: 40 boxes thrown into one place part at 3 m/s instead of 12."""


class Passes(NamedTuple):
    """The passes of a substep: a rigid one over what is new, the soft one, `summing` what it begins with from the
    second substep on, the relax pass, and the first ones of it over what overlaps deeply."""

    rigid: SoftContact
    soft: SoftContact
    summing: SoftContact
    relax: SoftContact
    relax_deep: SoftContact


@kernel
def passes_of(setting: Records, spring: Spring, seconds: float) -> Passes:
    """The passes of substeps of so many seconds whose contacts have that spring."""
    closing = 1.0 / seconds if setting.speculative == 1 else AT_ONCE
    push = -setting.push_out_speed * setting.units_per_meter
    touching = TOUCHING * setting.units_per_meter
    soft, jointed = spring.softness, spring.softness_jointed
    return Passes(
        SoftContact(closing, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, touching, False, True),
        SoftContact(closing, spring.bias, soft, jointed, push, 0.0, 0.0, touching, False, False),
        SoftContact(closing, spring.bias, soft, jointed, push, 0.0, 0.0, touching, True, False),
        SoftContact(closing, 0.0, 0.0, 0.0, 0.0, WAIT, OVER_RELAXATION, touching, False, False),
        SoftContact(closing, 0.0, 0.0, 0.0, 0.0, WAIT, OVER_RELAXATION, touching, False, True),
    )


@kernel
def relax_contacts(
    motions: Records, blocks: ContactBlocks, ranges: BlockRanges, workers: Workers, passes: Passes, keeps: bool
) -> None:
    """Take back the velocity that pushes overlaps apart: `RELAX_DEEP` passes over what overlaps deeply, of which the
    last goes over all blocks. Impulses are begun anew unless contacts keep theirs."""
    first = ranges.deep_first
    end = ranges.deep_end
    for turn in range(RELAX_DEEP - 1 if first < end else 0):
        if not keeps:
            forget_impulses(blocks, first, end)
        if turn == 0:
            solve_contacts(motions, blocks, first, end, workers, passes.relax_deep)
        else:
            solve_again(motions, blocks, first, end, workers, passes.relax_deep)
    if not keeps:
        forget_impulses(blocks, 0, ranges.total)
    solve_contacts(motions, blocks, 0, ranges.total, workers, passes.relax)

"""Impacts without restitution: blocks of contacts solved together, by conjugate gradients, until they agree.

A pass is one of the contact solver's, rigid. Velocities follow from impulses, so that they have directions of their
own, one a body: to go on along these costs a look at every body instead of a push at every contact.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.solve import solve_contacts
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.engine.restitution.conjugate_gradient import MOST_WORK, conjugate_share, passes_within, search_on
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES
VECTOR = cb.VECTOR
LEAST_WORK = 2_000
"""So much is done in any case: where little is struck all is found to rounding."""
AGREED = 1e-3
"""Share of the energy that all passes have taken; after a pass that took less, the next would take little."""
ROUNDING = 1e-28
"""The same where nothing is left but rounding."""


@kernel
def solve_until_agreed(
    motions: Records, struck: Records, blocks: ContactBlocks, block_count: int, workers: Workers, rigid: SoftContact
) -> None:
    """Solve the first blocks of contacts together, from no impulses. `struck` lists the bodies that they move."""
    contacts = _count(blocks, block_count)
    passes = passes_within(MOST_WORK, contacts)
    last_square = 0.0
    energy = 0.0
    for turn in range(passes):
        solve_contacts(motions, blocks, block_count, workers, rigid)
        square, taken = _measure(blocks, block_count)
        energy += taken
        agreed = taken <= ROUNDING * energy or (taken < AGREED * energy and turn * contacts >= LEAST_WORK)
        if agreed or turn == passes - 1:  # the last is a pass, so that no contact pulls
            return
        share = conjugate_share(square, last_square)
        _search(blocks, block_count, share)
        _move(motions, struck, share)
        last_square = square


@kernel
def _count(blocks: ContactBlocks, block_count: int) -> int:
    contacts = 0
    for n in range(block_count):
        contacts += blocks.blocks[n].count
    return contacts


@kernel
def _measure(blocks: ContactBlocks, block_count: int) -> tuple[float, float]:
    """The square of what the last pass has added (N^2 s^2), and twice the energy (J) that it took, about."""
    square = 0.0
    taken = 0.0
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for k in range(blocks.blocks[n].count):
            first, second, tangent = _added(v, k)
            each = first * first + second * second + tangent * tangent
            square += each
            taken += each * (v[cb.INVERSE_MASS_A + k] + v[cb.INVERSE_MASS_B + k])
    return square, taken


@inlined_kernel
def _added(v: Floats, k: int) -> tuple[float, float, float]:
    """What the last pass has added to the impulses of lane k: the negative gradient."""
    return (
        v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] - v[cb.LAST_IMPULSES + k],
        v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] - v[cb.LAST_IMPULSES + LANES + k],
        v[cb.TANGENT_IMPULSE + k] - v[cb.LAST_IMPULSES + 2 * LANES + k],
    )


@kernel
def _search(blocks: ContactBlocks, block_count: int, share: float) -> None:
    """Go on with the impulses along the direction searched so far, and turn it. They may pull until the next pass."""
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for lane in range(0, blocks.blocks[n].count, VECTOR):
            _search_lanes(v[lane:], share)


@kernel
def _search_lanes(v: Floats, share: float) -> None:
    for k in range(VECTOR):
        first, second, tangent = _added(v, k)
        more1, v[cb.SEARCH_DIRECTION + k] = search_on(v[cb.SEARCH_DIRECTION + k], first, share)
        more2, v[cb.SEARCH_DIRECTION + LANES + k] = search_on(v[cb.SEARCH_DIRECTION + LANES + k], second, share)
        rub, v[cb.SEARCH_DIRECTION + 2 * LANES + k] = search_on(v[cb.SEARCH_DIRECTION + 2 * LANES + k], tangent, share)
        load1 = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + more1
        load2 = v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] + more2
        rubbed = v[cb.TANGENT_IMPULSE + k] + rub
        v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] = v[cb.LAST_IMPULSES + k] = load1
        v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] = v[cb.LAST_IMPULSES + LANES + k] = load2
        v[cb.TANGENT_IMPULSE + k] = v[cb.LAST_IMPULSES + 2 * LANES + k] = rubbed


@kernel
def _move(motions: Records, struck: Records, share: float) -> None:
    """The same for velocities."""
    for here in struck:
        motion = motions[here.body]
        more_x, here.search_x = search_on(here.search_x, motion.velocity_x - here.last_x, share)
        more_y, here.search_y = search_on(here.search_y, motion.velocity_y - here.last_y, share)
        more_w, here.search_w = search_on(here.search_w, motion.angular_velocity - here.last_w, share)
        motion.velocity_x = here.last_x = motion.velocity_x + more_x
        motion.velocity_y = here.last_y = motion.velocity_y + more_y
        motion.angular_velocity = here.last_w = motion.angular_velocity + more_w

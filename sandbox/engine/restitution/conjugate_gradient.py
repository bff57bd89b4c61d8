"""Contacts solved together until they agree: rigid passes, made faster by the nonsmooth nonlinear conjugate gradient.

A pass carries an impulse one contact further, and through a light body that a heavy one presses on only as much as the
light one can give: plain passes would take some thousand where one of 1,000 times the mass lands on a pyramid. What a
pass changes is the gradient of what is left to solve, so that passes can be continued along conjugate directions.

Source: M. Silcowitz, S. Niebe and K. Erleben, "A nonsmooth nonlinear conjugate gradient method for interactive contact
force problems", The Visual Computer 26 (2010).
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.solve import solve_contacts
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
LANES = cb.LANES
VECTOR = cb.VECTOR
MOST_PASSES = 256
MOST_WORK = 15_000
"""Passes times contacts: in large heaps impacts are not solved as far, which only what is heavy on light would need."""
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
    passes = _passes(contacts)
    last_square = 0.0
    energy = 0.0
    for turn in range(passes):
        solve_contacts(motions, blocks, block_count, workers, rigid)
        square, taken = _measure(blocks, block_count)
        energy += taken
        agreed = taken <= ROUNDING * energy or (taken < AGREED * energy and turn * contacts >= LEAST_WORK)
        if agreed or turn == passes - 1:  # the last is a pass, so that no contact pulls
            return
        beta = square / last_square if square < last_square else 0.0  # 0 begins anew
        _search(blocks, block_count, beta)
        _move(motions, struck, beta)
        last_square = square


@kernel
def _count(blocks: ContactBlocks, block_count: int) -> int:
    contacts = 0
    for n in range(block_count):
        contacts += blocks.blocks[n].count
    return contacts


@kernel
def _passes(contacts: int) -> int:
    passes = MOST_WORK // contacts
    passes = passes if passes < MOST_PASSES else MOST_PASSES
    return passes if passes > 1 else 1


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
def _search(blocks: ContactBlocks, block_count: int, beta: float) -> None:
    """Go on by `beta` along the direction searched so far, and turn it by what the last pass has added.

    Impulses may pull until the next pass.
    """
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for lane in range(0, blocks.blocks[n].count, VECTOR):
            _search_lanes(v[lane:], beta)


@kernel
def _search_lanes(v: Floats, beta: float) -> None:
    for k in range(VECTOR):
        first, second, tangent = _added(v, k)
        more1 = beta * v[cb.SEARCH_DIRECTION + k]
        more2 = beta * v[cb.SEARCH_DIRECTION + LANES + k]
        rub = beta * v[cb.SEARCH_DIRECTION + 2 * LANES + k]
        v[cb.SEARCH_DIRECTION + k] = more1 + first
        v[cb.SEARCH_DIRECTION + LANES + k] = more2 + second
        v[cb.SEARCH_DIRECTION + 2 * LANES + k] = rub + tangent
        load1 = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + more1
        load2 = v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] + more2
        rubbed = v[cb.TANGENT_IMPULSE + k] + rub
        v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] = v[cb.LAST_IMPULSES + k] = load1
        v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] = v[cb.LAST_IMPULSES + LANES + k] = load2
        v[cb.TANGENT_IMPULSE + k] = v[cb.LAST_IMPULSES + 2 * LANES + k] = rubbed


@kernel
def _move(motions: Records, struck: Records, beta: float) -> None:
    """The same for the velocities, which follow from the impulses: what a pass changes of them is their gradient."""
    for here in struck:
        motion = motions[here.body]
        more_x = beta * here.search_x
        more_y = beta * here.search_y
        more_w = beta * here.search_w
        here.search_x = more_x + (motion.velocity_x - here.last_x)
        here.search_y = more_y + (motion.velocity_y - here.last_y)
        here.search_w = more_w + (motion.angular_velocity - here.last_w)
        motion.velocity_x = here.last_x = motion.velocity_x + more_x
        motion.velocity_y = here.last_y = motion.velocity_y + more_y
        motion.angular_velocity = here.last_w = motion.angular_velocity + more_w

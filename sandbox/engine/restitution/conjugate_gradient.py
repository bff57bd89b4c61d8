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
from sandbox.engine.contact_solver.gather import gather_velocities, scatter_velocities
from sandbox.engine.contact_solver.lanes import lane_anchors, lane_mass, lane_velocity, set_lane_velocity
from sandbox.engine.contact_solver.law import PointImpulses, apply_impulse, bearing_anchors, push_both
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
LEAST_PASSES = 4
LEAST_WORK = 1_000
"""So much is done in any case: where little is struck all is found to rounding."""
AGREED = 0.01
"""Change of velocity (m/s) by the impulses that a pass adds at one contact, below which the next would add little."""


@kernel
def solve_until_agreed(
    motions: Records, blocks: ContactBlocks, block_count: int, workers: Workers, rigid: SoftContact
) -> None:
    """Solve the first blocks of contacts together, from the impulses that they have."""
    contacts = _count(blocks, block_count)
    passes = _passes(contacts)
    last_square = 0.0
    for turn in range(passes):
        _keep_last(blocks, block_count)
        solve_contacts(motions, blocks, block_count, workers, rigid)
        square, change = _measure(blocks, block_count)
        agreed = change == 0.0 or (change < AGREED and turn * contacts >= LEAST_WORK)
        if agreed or turn == passes - 1:  # the last is a pass, so that no contact pulls
            return
        beta = square / last_square if square < last_square else 0.0  # 0 begins anew
        _search(motions, blocks, block_count, beta, workers.gathered)
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
    return passes if passes > LEAST_PASSES else LEAST_PASSES


@kernel
def _keep_last(blocks: ContactBlocks, block_count: int) -> None:
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for k in range(blocks.blocks[n].count):
            v[cb.LAST_IMPULSES + k] = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k]
            v[cb.LAST_IMPULSES + LANES + k] = v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
            v[cb.LAST_IMPULSES + 2 * LANES + k] = v[cb.TANGENT_IMPULSE + k]


@inlined_kernel
def _added(v: Floats, k: int) -> tuple[float, float, float]:
    """What the last pass has added to the impulses of lane k: the negative gradient."""
    return (
        v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] - v[cb.LAST_IMPULSES + k],
        v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] - v[cb.LAST_IMPULSES + LANES + k],
        v[cb.TANGENT_IMPULSE + k] - v[cb.LAST_IMPULSES + 2 * LANES + k],
    )


@kernel
def _measure(blocks: ContactBlocks, block_count: int) -> tuple[float, float]:
    """The square of what the last pass has added (N^2 s^2), and the largest change of velocity (m/s) that it made."""
    square = 0.0
    largest = 0.0
    for n in range(block_count):
        v = blocks.lanes[n * BLOCK_SIZE : (n + 1) * BLOCK_SIZE]
        for k in range(blocks.blocks[n].count):
            first, second, tangent = _added(v, k)
            square += first * first + second * second + tangent * tangent
            change = (abs(first) + abs(second)) * (v[cb.INVERSE_MASS_A + k] + v[cb.INVERSE_MASS_B + k])
            largest = change if change > largest else largest
    return square, largest


@kernel
def _search(motions: Records, blocks: ContactBlocks, block_count: int, beta: float, gathered: Floats) -> None:
    """Go on by `beta` along the direction searched so far, and turn it by what the last pass has added."""
    slots = blocks.slots
    for n in range(block_count):
        block = blocks.blocks[n]
        turns = block.count if block.serial == 1 else 1
        width = 1 if block.serial == 1 else block.count
        for turn in range(turns):
            v = blocks.lanes[n * BLOCK_SIZE + turn : (n + 1) * BLOCK_SIZE]
            slot = block.first + turn
            if beta > 0.0:
                gather_velocities(motions, slots, slot, width, gathered)
            if block.serial == 1:
                _search_lane(v, gathered, 0, beta)
            else:
                for lane in range(0, width, VECTOR):
                    _search_lanes(v[lane:], gathered[lane:], beta)
            if beta > 0.0:
                scatter_velocities(motions, slots, slot, width, gathered)


@kernel
def _search_lanes(v: Floats, g: Floats, beta: float) -> None:
    for k in range(VECTOR):
        _search_lane(v, g, k, beta)


@inlined_kernel
def _search_lane(v: Floats, g: Floats, k: int, beta: float) -> None:
    first, second, tangent = _added(v, k)
    more = PointImpulses(
        beta * v[cb.SEARCH_DIRECTION + k] if beta > 0.0 else 0.0,
        beta * v[cb.SEARCH_DIRECTION + LANES + k] if beta > 0.0 else 0.0,
    )
    rub = beta * v[cb.SEARCH_DIRECTION + 2 * LANES + k] if beta > 0.0 else 0.0
    v[cb.SEARCH_DIRECTION + k] = more.first + first
    v[cb.SEARCH_DIRECTION + LANES + k] = more.second + second
    v[cb.SEARCH_DIRECTION + 2 * LANES + k] = rub + tangent
    load1 = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + more.first
    load2 = v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] + more.second
    v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] = load1
    v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] = load2
    v[cb.TANGENT_IMPULSE + k] += rub
    mass = lane_mass(v, k)
    nx = v[cb.NORMAL_X + k]
    ny = v[cb.NORMAL_Y + k]
    r1 = lane_anchors(v, cb.POINT_1, k)
    r2 = lane_anchors(v, cb.POINT_2, k)
    velocity = push_both(lane_velocity(g, k), mass, r1, r2, more, nx, ny)
    # Impulses along the direction may pull until the next pass: then nothing says where between the points they act.
    load1 = load1 if load1 > 0.0 else 0.0
    load2 = load2 if load2 > 0.0 else 0.0
    r = bearing_anchors(r1, r2, load1, load2)
    set_lane_velocity(g, k, apply_impulse(velocity, mass, r, rub * ny, -rub * nx))

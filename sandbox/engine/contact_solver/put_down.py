"""The first step of a world: what its contacts bear is found at once, and springs are as long as that asks.

Impulses are not known yet: soft contacts alone would let all slip and sink until they are.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.law import anchors_of, relative_velocity, start_velocity
from sandbox.engine.contact_solver.nesterov import Effort, list_bodies, solve_until_agreed
from sandbox.engine.contact_solver.rest_length import sink
from sandbox.engine.contact_solver.soft_constraint import Spring
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
MOST_PASSES = 1024
MOST_WORK = 2_000_000
"""Passes times contacts: up to 0.1 s, once."""
AGREED = 1e-9
"""Up to so many m/s passes agree: loads, which change 0.01 m/s and more in a substep, are right to a millionth."""


@kernel
def put_down(
    bodies: Records,
    solver: SolverBodies,
    moved: Records,
    contacts: Records,
    blocks: ContactBlocks,
    block_count: int,
    workers: Workers,
    rigid: SoftContact,
    spring: Spring,
    gravity: float,
) -> None:
    """Find what the first blocks of contacts bear in the first step of a world; `moved` is scratch.

    Springs of points at rest get the length that asks for. At rest is what moves along the normal no faster than
    `gravity` (m/s^2) makes it in a substep.
    """
    listed: Any = moved[: list_bodies(solver, moved, blocks, block_count)]
    effort = Effort(MOST_PASSES, MOST_WORK, AGREED)
    solve_until_agreed(bodies, solver.motions, listed, blocks, block_count, workers, rigid, effort)
    slow = gravity * spring.seconds
    for n in range(block_count):
        block = blocks.blocks[n]
        for k in range(block.count):
            contact = contacts[blocks.slots[block.first + k].contact]
            v = blocks.lanes[n * BLOCK_SIZE + k : (n + 1) * BLOCK_SIZE]
            if _rests(solver.free_motions, contact, 1, slow):
                contact.rest_length1 = _lengthen(v[cb.POINT_1 :], contact.separation1, spring)
            if contact.point_count == 2 and _rests(solver.free_motions, contact, 2, slow):
                contact.rest_length2 = _lengthen(v[cb.POINT_2 :], contact.separation2, spring)


@inlined_kernel
def _rests(free_motions: Records, contact: Records, point: int, slow: float) -> bool:
    """Whether a point closes in on the other body, or leaves it, no faster than `slow` (m/s); it may slide."""
    x, y = relative_velocity(start_velocity(free_motions, contact), anchors_of(contact, point))
    speed = x * contact.normal_x + y * contact.normal_y
    return bool(-slow <= speed <= slow)


@inlined_kernel
def _lengthen(v: Floats, separation: float, spring: Spring) -> float:
    """Make the spring of a point longer by what it would sink by, less what it has sunk by already; returns its rest
    length (m)."""
    longer = sink(spring, v[cb.NORMAL_IMPULSE] / spring.share, v[cb.NORMAL_MASS])
    sunk = -separation if separation < 0.0 else 0.0
    longer = longer - sunk if longer > sunk else 0.0
    v[cb.SEPARATION] -= longer
    return longer

"""The first step of a world: what its contacts bear is found at once, and springs are as long as that asks.

Impulses are not known yet: soft contacts alone would let all slip and sink until they are.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import root_of, unite
from sandbox.engine.bodies.integrate import SOLVED
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import start_velocity
from sandbox.engine.contact_solver.nesterov import ROUNDING, Effort, list_bodies, solve_until_agreed
from sandbox.engine.contact_solver.rest_length import sink, yields_of
from sandbox.engine.contact_solver.soft_constraint import TOUCHING, Spring
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
MOST_PASSES = 1024
MOST_WORK = 2_000_000
"""Passes times contacts: up to 0.1 s, once."""
NOBODY = -1
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

    Springs get the length that asks for, but where something strikes, of whatever hangs together with that by
    contacts: a spring that was as long as a blow asks for would throw up what has struck. Nothing strikes that closes
    no faster than `gravity` (m/s^2) makes it in a substep.
    """
    listed: Any = moved[: list_bodies(solver, moved, blocks, block_count)]
    effort = Effort(MOST_PASSES, MOST_WORK, AGREED * spring.units_per_meter, ROUNDING * spring.units_per_meter)
    solve_until_agreed(bodies, solver.motions, listed, blocks, block_count, workers, rigid, effort)
    struck = _unite_struck(solver, listed, contacts, blocks, block_count, gravity, spring)
    for n in range(block_count):
        block = blocks.blocks[n]
        for k in range(block.count):
            slot = blocks.slots[block.first + k]
            if struck != NOBODY and _root(solver, slot) == root_of(solver.struck, struck):
                continue
            contact = contacts[slot.contact]
            v = blocks.lanes[n * BLOCK_SIZE + k : (n + 1) * BLOCK_SIZE]
            yields = yields_of(block, v, spring) / spring.share
            contact.rest_length1 = _lengthen(v[cb.POINT_1 :], contact.separation1, yields)
            if contact.point_count == 2:
                contact.rest_length2 = _lengthen(v[cb.POINT_2 :], contact.separation2, yields)


@kernel
def _unite_struck(
    solver: SolverBodies,
    listed: Records,
    contacts: Records,
    blocks: ContactBlocks,
    block_count: int,
    gravity: float,
    spring: Spring,
) -> int:
    """Unite, in `solver.struck`, what hangs together by contacts, and all of that in which something strikes;
    returns a body of the latter, or `NOBODY`."""
    for here in listed:
        solver.struck[here.body] = here.body
    struck = NOBODY
    for n in range(block_count):
        block = blocks.blocks[n]
        for slot in blocks.slots[block.first : block.first + block.count]:
            if solver.forces[slot.body_a].moves == SOLVED and solver.forces[slot.body_b].moves == SOLVED:
                unite(solver.struck, slot.body_a, slot.body_b)
            if _strikes(solver.free_motions, contacts[slot.contact], gravity * spring.seconds, spring):
                root = _root(solver, slot)
                if struck == NOBODY:
                    struck = root
                unite(solver.struck, struck, root)
    return struck


@inlined_kernel
def _root(solver: SolverBodies, slot: Records) -> int:
    """What a contact belongs to, of which one body at least moves."""
    moves = slot.body_a if solver.forces[slot.body_a].moves == SOLVED else slot.body_b
    return int(root_of(solver.struck, moves))


@inlined_kernel
def _strikes(free_motions: Records, contact: Records, slow: float, spring: Spring) -> bool:
    """Whether a point closes within a substep, be it just so, faster than `slow` (m/s); it may slide."""
    v = start_velocity(free_motions, contact)
    first = -opening_speed(v, contact, 1)
    second = -opening_speed(v, contact, 2) if contact.point_count == 2 else 0.0
    nearly = TOUCHING * spring.units_per_meter
    strikes = first > slow and contact.separation1 <= first * spring.seconds + nearly
    return bool(strikes or (second > slow and contact.separation2 <= second * spring.seconds + nearly))


@inlined_kernel
def _lengthen(v: Floats, separation: float, yields: float) -> float:
    """Make the spring of a point, which yields so much to an impulse of this level, longer by what it would sink by,
    less what it has sunk by already; returns its rest length (m)."""
    longer = sink(yields, v[cb.NORMAL_IMPULSE], v[cb.NORMAL_MASS])
    sunk = -separation if separation < 0.0 else 0.0
    longer = longer - sunk if longer > sunk else 0.0
    v[cb.SEPARATION] -= longer
    return longer

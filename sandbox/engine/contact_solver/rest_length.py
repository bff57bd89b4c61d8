"""The rest length of a contact's spring: the gap at which it does not push.

A spring bears a load by sinking, under the n-th box from the top of a stack by n times what one sinks by. Where bodies
are put down at rest it is made as long as the load asks for, which is found for all contacts together, so that nothing
sinks. The length shrinks as the load falls, and does not grow with it: one that followed rising loads would be an
integral controller, and large piles, which sway slowly, swing themselves up with one.

Springs are stiffer where substeps are shorter. When an island begins to take shorter ones its springs become shorter
as well, so that its gaps and its loads stay: else all that it has sunk by would push with many times the load that sank
it. A length below zero, which comes of that, is given back slowly, or when the island takes longer substeps again.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Number, Vector, select
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.soft_constraint import Spring
from sandbox.tables import Floats, Records

MOST = 2.0
"""Times what the load of now sinks by: no spring is longer, so that what is suddenly free is not thrown up far."""
FORGETS = 0.1
"""Share of the length that the load of now does not ask for, given up in a step."""
RETURNS = 0.05
"""Share of a length below zero that is given back in a step."""


@inlined_kernel
def sink(yields: Number, impulse: Number, mass: Number) -> Number:
    """How far (m) a spring that `yields` so much sinks under a load, the impulse (N s) in a substep of level 0, at an
    effective mass (kg)."""
    moves = mass > 0.0
    return select(moves, yields * impulse / select(moves, mass, 1.0), 0.0)


@inlined_kernel
def yields_of(block: Records, v: Floats, spring: Spring) -> float:
    """How far the spring of the contact with lane `v` of a block yields."""
    return spring.yields_jointed if block.jointed == 1 and v[cb.JOINTED] > 0.0 else spring.yields


@kernel
def change_level(contact: Records, block: Records, v: Floats, spring: Spring) -> None:
    """Let the springs of a contact with lane `v`, which had another substep level, keep their loads where they can.

    Energy is not to be had by it: softer springs do not get longer than they were, nor than 0.
    """
    times = 1.0
    for _ in range(spring.level, contact.substep_level):
        times *= 0.25
    for _ in range(contact.substep_level, spring.level):
        times *= 4.0
    yields = yields_of(block, v, spring)
    contact.rest_length1 += _change(contact.rest_length1, contact.normal_impulse1, times, yields, v[cb.POINT_1 :])
    contact.rest_length2 += _change(contact.rest_length2, contact.normal_impulse2, times, yields, v[cb.POINT_2 :])
    contact.substep_level = spring.level


@kernel
def _change(length: float, load: float, times: float, yields: float, v: Floats) -> float:
    """Change of a rest length (m), in the lane too, where the spring yielded so many times as much before."""
    change = (1.0 - times) * sink(yields, load, v[cb.NORMAL_MASS])
    room = -length if length < 0.0 else 0.0
    change = change if change < room else room
    v[cb.SEPARATION] -= change
    return change


@inlined_kernel
def next_length(length: Vector, load: Vector, yields: Vector, mass: Vector) -> Vector:
    """How long (m) springs that yield so much at these effective masses (kg) are in the next step, as the loads (N s)
    that they bear now allow."""
    asked = sink(yields, load, mass)
    most = select(length < MOST * asked, length, MOST * asked)
    given = most - select(most > asked, FORGETS * (most - asked), 0.0)
    return select(length < 0.0, length - RETURNS * length, given)

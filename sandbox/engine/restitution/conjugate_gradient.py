"""The nonsmooth nonlinear conjugate gradient, as far as all impacts share it: how long, and along which directions.

A pass over contacts carries an impulse one contact further, and through a light body that a heavy one presses on only
as much as the light one can give: plain passes would take some thousand where one of 1,000 times the mass lands on a
pyramid. What a pass changes is the gradient of what is left to solve, negative, so that passes can be continued along
conjugate directions.

What goes through contacts is not shared: a blow without restitution reaches whole heaps, in the lanes of the contact
solver's blocks with its friction and its workers, and may stop by energy (`conjugate_blocks.py`); those that rebound
together are few, in a list, without friction until they have, and agree to a velocity (`conjugate_group.py`).

Source: M. Silcowitz, S. Niebe and K. Erleben, "A nonsmooth nonlinear conjugate gradient method for interactive contact
force problems", The Visual Computer 26 (2010).
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel

MOST_PASSES = 256
MOST_WORK = 15_000
"""Passes times contacts, at most: in large heaps impacts are not solved as far, and the contact solver goes on."""


@inlined_kernel
def passes_within(work: int, contacts: int) -> int:
    """How many passes so many contacts may take for so much work; one in any case."""
    passes = work // contacts
    passes = passes if passes < MOST_PASSES else MOST_PASSES
    return passes if passes > 1 else 1


@inlined_kernel
def conjugate_share(square: float, last_square: float) -> float:
    """How much of the direction searched so far to keep, given the squares of what the last two passes have added.

    That is beta by Fletcher and Reeves, and 0, which begins anew, where passes have come to change more.
    """
    return square / last_square if square < last_square else 0.0


@inlined_kernel
def search_on(direction: float, added: float, share: float) -> tuple[float, float]:
    """How far to go on along a component of the direction, and what it is next: turned by what the last pass added."""
    further = share * direction
    return further, further + added

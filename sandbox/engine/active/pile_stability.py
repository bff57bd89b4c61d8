"""How stable piles are: what columns of soft contacts bear before they buckle, and how heavy what lies on light is.

Soft contacts give way under load, so a slender pile buckles like a column of elastic joints, and one solver pass a
substep cannot carry a heavy body through a light one. Both get better with the square of the substep rate. A column
is safe while the sum of weight * height^2 over its bodies is less than 2.5 EI (A. G. Greenhill 1881; a load at the
top is Euler's case), and contacts with the angular frequency w over a width W have EI of about m w^2 W^3. Stiffness
only holds what is a frame: a pile with fewer forces, two at each contact point, than its bodies have degrees of freedom
is a mechanism (J. C. Maxwell, "On the calculation of the equilibrium and stiffness of frames", 1864).
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.bearable_mass import bearable
from sandbox.engine.active.pile_measures import is_frame
from sandbox.engine.active.pile_support import Load, share_supported
from sandbox.tables import Integers, Records

MAX_LEVEL = 4
"""Highest substep level: an island of level p takes 2**p times the scene's substeps."""
STIFFNESS = 0.6
"""Measured: a stack of 28 unit boxes just stands at 55 Hz."""
SAFE = 0.35
"""Largest share of the buckling load that an island bears at its level."""
KEEPS = 0.5
"""Share of what an island could bear at a level up to which it goes back to that from a higher one."""


@kernel
def some_pile_may_fall(rows: Integers, islands: Integers, piles: Records, load: Load) -> bool:
    """Whether some pile of two or more would need a higher level, or be overloaded, if it were as bad as its bodies
    allow. What hangs may weigh on what does not."""
    for i in rows:
        if islands[i] == i and piles[i].bodies > 1:
            piles[i].ratio = piles[i].heaviest / piles[i].bearer
            if level_for(piles[i], load) > 0 or (piles[i].hangs == 1 and piles[i].weight > 0.0):
                return True
    return False


@kernel
def level_for(pile: Records, load: Load) -> int:
    """How many times the substeps have to be doubled for this pile.

    By one time less than in the last step at least: springs that bear a heavy load of now would throw up what is left
    when it goes, if they became much softer at once. And by none less while it bears a good part of what asks for so
    many: a tower that bounces would have stiff springs below and soft ones above, and swing itself up.
    """
    width = pile.right - pile.left
    width = width if width > 0.5 * pile.slight else 0.5 * pile.slight
    foot = pile.bottom
    buckles = pile.second_moment - 2.0 * foot * pile.moment + foot * foot * pile.weight
    buckles = buckles * share_supported(pile) if is_frame(pile) else 0.0
    heaviest = pile.ratio if pile.support > 0.0 else 0.0  # what falls freely presses on nothing
    bears = SAFE * STIFFNESS * pile.bearer * load.omega * load.omega * width * width * width
    ratio = bearable(pile.slight, load.gravity, load.omega, load.unit)
    level = pile.level - 1 if pile.level > 1 else 0
    for _ in range(level):
        bears = 4.0 * bears
        ratio = 4.0 * ratio
    while level < MAX_LEVEL and (buckles > _limit(bears, level, pile) or heaviest > _limit(ratio, level, pile)):
        bears = 4.0 * bears
        ratio = 4.0 * ratio
        level += 1
    return level


@inlined_kernel
def _limit(bears: float, level: int, pile: Records) -> float:
    """What a pile may bear at a level: at most `KEEPS` of what it could, to go back to that from a higher one."""
    return KEEPS * bears if level < pile.level else bears

"""How contacts lie in memory while they are solved: blocks of four lanes, one float array for all.

Contacts of one colour share no body that moves, so four of them can be solved side by side, in vectors (`_vectors.py`).
A block has all that belongs to its contacts in one piece: field `F` of lane `k` is `lanes[base + F + k]`.
"""

from __future__ import annotations

from sandbox._vectors import WIDTH

LANES = WIDTH
ENOUGH = 4
"""Contacts that a further colour must have on the average to be worth its blocks."""
MAX_COLORS = 62
"""Contacts that find no colour below this go into serial blocks, whose lanes are solved one by one."""
KIND = MAX_COLORS + 1
"""Colours of one kind of contacts. Those of struck bodies come first, then those of other unsettled ones."""
UNSETTLED = 1 * KIND
SETTLED = 2 * KIND
ALL_COLORS = 3 * KIND

NORMAL_X = 0 * LANES
NORMAL_Y = 1 * LANES
INVERSE_MASS_A = 2 * LANES
INVERSE_INERTIA_A = 3 * LANES
INVERSE_MASS_B = 4 * LANES
INVERSE_INERTIA_B = 5 * LANES

POINT_1 = 6 * LANES
"""First field of point 1; the fields below count from it."""
POINT_2 = 13 * LANES
"""First field of point 2. A contact of one point has it there again, but without mass, so that it never pushes."""

ANCHOR_AX = 0 * LANES
ANCHOR_AY = 1 * LANES
ANCHOR_BX = 2 * LANES
ANCHOR_BY = 3 * LANES
SEPARATION = 4 * LANES
NORMAL_MASS = 5 * LANES
NORMAL_IMPULSE = 6 * LANES

COUPLING = 20 * LANES
"""What a normal impulse of 1 N s at one point changes of the normal velocity at the other, 1/kg."""
TANGENT_IMPULSE = 21 * LANES
"""Friction of both points: they lie on one line along the tangent, so it is one force."""
TANGENT_MASS = 22 * LANES
FRICTION = 23 * LANES
SURFACE_SPEED = 24 * LANES
RADIUS_A = 25 * LANES
RADIUS_B = 26 * LANES
MAY_IMPACT = 27 * LANES
"""1 where an impact may follow: such a contact must not be slowed before it strikes."""
ROLLING_IMPULSE = 28 * LANES
TOTAL_IMPULSE = 29 * LANES
"""Normal impulses of both points, summed over the substeps so far."""
ROLLING_RESISTANCE = 30 * LANES
ROLLING_MASS = 31 * LANES

# What is kept while contacts are solved together: normal impulses of points 1 and 2, and the tangent impulse.
RESTING_IMPULSES = 32 * LANES
"""Those that the contact solver had accumulated."""
LAST_IMPULSES = 35 * LANES
"""Those after the pass before."""

BLOCK_SIZE = 38 * LANES

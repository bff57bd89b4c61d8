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
"""Colours of one kind of contacts. Kinds follow each other so that contacts of struck bodies, of bodies that overlap
deeply, and of all unsettled ones are a range each."""
STRUCK_ALONE = 0 * KIND
STRUCK_AND_DEEP = 1 * KIND
DEEP = 2 * KIND
UNSETTLED = 3 * KIND
SETTLED = 4 * KIND
ALL_COLORS = 5 * KIND

# What every pass reads comes first, so that the lines behind it are not fetched.
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

TANGENT_IMPULSE = 20 * LANES
"""Friction of both points: they lie on one line along the tangent, so it is one force."""
TANGENT_MASS = 21 * LANES
FRICTION = 22 * LANES
TOTAL_IMPULSE = 23 * LANES
"""Normal impulses of both points, summed over the substeps so far."""

BIAS_1 = 24 * LANES
"""What the last rigid pass added to the velocity of point 1 along the normal (m/s), for passes at the same poses."""
BIAS_2 = 25 * LANES

# What few contacts have: it is neither written nor read where no contact of a block has it (`BLOCK`).
SURFACE_SPEED = 26 * LANES
RADIUS_A = 27 * LANES
RADIUS_B = 28 * LANES
MAY_IMPACT = 29 * LANES
"""1 where an impact may follow: such a contact must not be slowed before it strikes."""
ROLLING_RESISTANCE = 30 * LANES
ROLLING_MASS = 31 * LANES
ROLLING_IMPULSE = 32 * LANES

# What is kept while contacts are solved together: normal impulses of points 1 and 2, and the tangent impulse.
RESTING_IMPULSES = 33 * LANES
"""Those that the contact solver had accumulated."""
LAST_IMPULSES = 36 * LANES
"""Those after the pass before."""

BLOCK_SIZE = 40 * LANES
"""Whole cache lines."""

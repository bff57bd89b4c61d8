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
TANGENT_LEVER_A = 22 * LANES
TANGENT_LEVER_B = 23 * LANES
"""Levers of the line along which it acts, the same throughout a step: what it has given can be given again."""
FRICTION = 24 * LANES
TOTAL_IMPULSE = 25 * LANES
"""Normal impulses of both points, summed over the substeps so far."""

BIAS_1 = 26 * LANES
"""What the last rigid pass added to the velocity of point 1 along the normal (m/s), for passes at the same poses."""
BIAS_2 = 27 * LANES

# What few contacts have: it is neither written nor read where no contact of a block has it (`BLOCK`).
SURFACE_SPEED = 28 * LANES
RADIUS_A = 29 * LANES
RADIUS_B = 30 * LANES
MAY_IMPACT = 31 * LANES
"""1 where an impact may follow: such a contact must not be slowed before it strikes."""
ROLLING_RESISTANCE = 32 * LANES
ROLLING_MASS = 33 * LANES
ROLLING_IMPULSE = 34 * LANES

# What is kept while contacts are solved together: normal impulses of points 1 and 2, the tangent impulse, and, where a
# contact of the block resists rolling, the rolling impulse.
RESTING_IMPULSES = 35 * LANES
"""Those that the contact solver had accumulated."""
LAST_IMPULSES = 39 * LANES
"""Those after the pass before."""

JOINTED = 43 * LANES
"""1 where joints hold a body."""

BLOCK_SIZE = 44 * LANES
"""Whole cache lines."""

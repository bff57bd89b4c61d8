"""How contacts lie in memory while they are solved: blocks of 64 lanes, one float array for all.

Contacts of one colour share no body, so 64 of them can be solved side by side. Field `F` of lane `k` of a block is
`lanes[base + F + k]`: every field at a constant offset in one array is what lets LLVM turn the loop over `k` into
vector instructions. Results do not depend on the vector width.
"""

from __future__ import annotations

LANES = 64
VECTOR = 16
"""Lanes that one turn of the arithmetic covers. Constant, or LLVM would not vectorise it."""
ENOUGH = VECTOR // 4
"""Contacts of a colour that are solved sooner side by side than one by one, with the same outcome."""
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
FRICTION = 6 * LANES
SURFACE_SPEED = 7 * LANES
ROLLING_RESISTANCE = 8 * LANES
ROLLING_MASS = 9 * LANES
ROLLING_IMPULSE = 10 * LANES
MAY_IMPACT = 11 * LANES
"""1 where an impact may follow: such a contact must not be slowed before it strikes."""

RADIUS_A = 12 * LANES
RADIUS_B = 13 * LANES
TANGENT_IMPULSE = 14 * LANES
"""Friction of both points: they lie on one line along the tangent, so it is one force."""
TANGENT_MASS = 15 * LANES
COUPLING = 16 * LANES
"""What a normal impulse of 1 N s at one point changes of the normal velocity at the other, 1/kg."""

POINT_1 = 17 * LANES
"""First field of point 1; the fields below count from it."""
POINT_2 = 24 * LANES
"""First field of point 2. A contact of one point has it there again, but without mass, so that it never pushes."""

ANCHOR_AX = 0 * LANES
ANCHOR_AY = 1 * LANES
ANCHOR_BX = 2 * LANES
ANCHOR_BY = 3 * LANES
SEPARATION = 4 * LANES
NORMAL_MASS = 5 * LANES
NORMAL_IMPULSE = 6 * LANES

TOTAL_IMPULSE = 31 * LANES
"""Normal impulses of both points, summed over the substeps so far."""

# What is kept while contacts are solved together: normal impulses of points 1 and 2, and the tangent impulse.
RESTING_IMPULSES = 32 * LANES
"""Those that the contact solver had accumulated."""
LAST_IMPULSES = 35 * LANES
"""Those after the pass before."""

BLOCK_SIZE = 38 * LANES

# Bodies of a block, gathered before the arithmetic and scattered after it.
VELOCITY_AX = 0 * LANES
VELOCITY_AY = 1 * LANES
ANGULAR_A = 2 * LANES
VELOCITY_BX = 3 * LANES
VELOCITY_BY = 4 * LANES
ANGULAR_B = 5 * LANES
DELTA_X = 6 * LANES
DELTA_Y = 7 * LANES
COS_A = 8 * LANES
SIN_A = 9 * LANES
COS_B = 10 * LANES
SIN_B = 11 * LANES
GATHER_SIZE = 12 * LANES

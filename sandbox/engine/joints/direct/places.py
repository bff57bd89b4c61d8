"""Where each number lies in the memory of factorised parts.

All numbers are in one array. Field `F` of a record at place `p` is the vector at `memory[p + F]`: one lane for each
part. What lasts from pass to pass lies in memory of the batch's own, all else in a working place that every batch uses
in turn, so that it stays in the nearest cache.
"""

from __future__ import annotations

from sandbox._vectors import WIDTH

# What lasts of a body.
INVERSE_MASS = 0 * WIDTH
INVERSE_INERTIA = 1 * WIDTH
"""Of the pass; less than the body's own under high tension."""
INERTIA = 2 * WIDTH
"""The body's own; 0 where it cannot turn."""
START_COS = 3 * WIDTH
START_SIN = 4 * WIDTH
START_ANGLE = 5 * WIDTH
CENTER_X = 6 * WIDTH
"""Centre of mass when the step began."""
CENTER_Y = 7 * WIDTH
KICK_X = 8 * WIDTH
"""Half of what forces add in this substep, held back while it moves."""
KICK_Y = 9 * WIDTH
KICK_W = 10 * WIDTH
CORRECTION_X = 11 * WIDTH
"""Position correction of a separated part: moves it, is no velocity. Until it is found, and after the move, the
velocity with which guesses at which rows are at a bound began."""
CORRECTION_Y = 12 * WIDTH
CORRECTION_W = 13 * WIDTH
SEAT_SIZE = 14 * WIDTH

# A body while a pass works on it.
VELOCITY_X = 0 * WIDTH
VELOCITY_Y = 1 * WIDTH
VELOCITY_W = 2 * WIDTH
TENSION = 3 * WIDTH
"""What turns it back, for each radian, when joints pull at its anchors, N m."""
DELTA_X = 4 * WIDTH
"""Since the step began."""
DELTA_Y = 5 * WIDTH
DELTA_ANGLE = 6 * WIDTH
DELTA_COS = 7 * WIDTH
DELTA_SIN = 8 * WIDTH
AHEAD_X = 9 * WIDTH
"""Displacement since the step began, at the pose it is looked at."""
AHEAD_Y = 10 * WIDTH
COS = 11 * WIDTH
SIN = 12 * WIDTH
ANGLE = 13 * WIDTH

# The constants of a joint, as in the joint table.
ANCHOR_AX = 0 * WIDTH
ANCHOR_AY = 1 * WIDTH
ANCHOR_BX = 2 * WIDTH
ANCHOR_BY = 3 * WIDTH
AXIS_X = 4 * WIDTH
AXIS_Y = 5 * WIDTH
REFERENCE_ANGLE = 6 * WIDTH
LENGTH = 7 * WIDTH
RATIO = 8 * WIDTH
POINT_AX = 9 * WIDTH
POINT_AY = 10 * WIDTH
POINT_BX = 11 * WIDTH
POINT_BY = 12 * WIDTH
HERTZ = 13 * WIDTH
DAMPING_RATIO = 14 * WIDTH
ANGULAR_HERTZ = 15 * WIDTH
ANGULAR_DAMPING_RATIO = 16 * WIDTH
REST = 17 * WIDTH
LOWER = 18 * WIDTH
UPPER = 19 * WIDTH
MOTOR_SPEED = 20 * WIDTH
MAX_MOTOR = 21 * WIDTH
MAX_FORCE = 22 * WIDTH
MAX_TORQUE = 23 * WIDTH
END_ARM_X = 24 * WIDTH
"""Arm of the second anchor when the last pass ended."""
END_ARM_Y = 25 * WIDTH
JOINT_SIZE = 26 * WIDTH

# A joint at the pose it is looked at.
ARM_AX = 0 * WIDTH
"""Anchor from the centre of a, world axes."""
ARM_AY = 1 * WIDTH
ARM_BX = 2 * WIDTH
ARM_BY = 3 * WIDTH
GAP_X = 4 * WIDTH
"""From anchor a to anchor b."""
GAP_Y = 5 * WIDTH
TURN = 6 * WIDTH
"""Angle of b less angle of a, less the reference angle."""
ALONG_X = 7 * WIDTH
"""Unit axis of the slide, or from anchor a to anchor b."""
ALONG_Y = 8 * WIDTH
ERRORS = 9 * WIDTH
"""How far rows 0 to 2 are from being kept, then twice the place: length, slide or angle that rows 3 and 4 act on."""
PLACE = 12 * WIDTH
LEVERED = 14 * WIDTH
"""1 where rows 0 and 1 push both bodies at the second one's anchor."""
FRAME_SIZE = 15 * WIDTH

# What lasts of a row.
IMPULSE = 0 * WIDTH
"""While positions are solved, N s."""
RELAXING = 1 * WIDTH
"""While velocities are relaxed, N s."""
TOTAL = 2 * WIDTH
"""Over the step so far."""
STOP = 3 * WIDTH
"""1 while the lower limit has a say, -1 for the upper one."""
ERROR = 4 * WIDTH
"""When the substep began."""
STIFFNESS = 5 * WIDTH
"""J M^-1 J^T: speed that a unit impulse gives; 0 while it has no say."""
END_X = 6 * WIDTH
"""Jacobian at the second body when the last pass ended."""
END_Y = 7 * WIDTH
END_W = 8 * WIDTH
PRELOAD = 9 * WIDTH
"""The force (N or N m) that a rigid row bears without giving way: what it bore when the world was put down."""
BLOW = 10 * WIDTH
"""In the last impact of a body of the part, N s."""
HELD = 11 * WIDTH
"""1 where its lower stop holds in the impact under way, -1 where the upper one does."""
KEPT_SIZE = 12 * WIDTH

# A row while a pass works on it.
JACOBIAN = 0 * WIDTH
"""Three numbers for each of up to four sides."""
SIDE = 3 * WIDTH
SPEED = 12 * WIDTH
"""Of the members along it, when its law was set."""
BIAS = 13 * WIDTH
"""It strives for speed + bias + softness * impulse = 0."""
SOFTNESS = 14 * WIDTH
LOW = 15 * WIDTH
"""Bounds of the impulse."""
HIGH = 16 * WIDTH
ACTIVE = 17 * WIDTH
"""1 while it is part of the linear system; -1 where nobody has looked yet."""
CAPPED = 18 * WIDTH
"""1 once its pair has reached the limit of the force."""
MAY_LEAVE = 19 * WIDTH
"""Error it may have left after the substep."""
APART = 20 * WIDTH
"""Error of now without what it yields under the force it bears."""
ASIDE = 21 * WIDTH
"""The impulse, while the recovery of a separated part is found."""
CHANGE = 22 * WIDTH
"""Solution of the linear system."""
IN_SYSTEM = 23 * WIDTH
"""1 while its equation, which two rows may share, is part of the linear system."""
DIAGONAL = 24 * WIDTH
"""Softness of its equation."""
BEGAN = 25 * WIDTH
"""The impulse with which guesses at which rows are at a bound began."""
ROW_SIZE = 26 * WIDTH

# What is known of each part of a batch.
HALVES = 0 * WIDTH
"""1 when forces act half before and half after the move; not in what is borne."""
SEPARATED = 1 * WIDTH
"""1 when its joints must not be brought together by velocities."""
IN_USE = 2 * WIDTH
"""1 where the lane has a part."""
NEW = 3 * WIDTH
"""1 until the first loads of a world are known."""
STRUCK = 4 * WIDTH
"""1 where an impact is passed on."""
APART_BY = 5 * WIDTH
"""Sum of what joints are apart by, in m and rad, beyond what they yield."""
CORRECTED = 6 * WIDTH
"""1 when its bodies are displaced after the move."""
LANE_SIZE = 7 * WIDTH

"""How the joints of nets lie in memory: blocks of four lanes, as contacts do (`contact_solver/blocks.py`).

Joints of one colour share no body that they move, so that they can be solved side by side. Only plain ones lie here, in
parts that are not factorised: hinges without spring, stop or motor, rods and springs without stops, and welds.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sandbox._jit import entry_point, interpreted
from sandbox.engine.contact_solver.blocks import LANES
from sandbox.engine.joints.elimination import FEW_JOINTS
from sandbox.tables import Field, Floats, Integers, Records, Table, aligned_zeros
from sandbox.world.joint_records import DISTANCE, FRICTION, GEAR, MOTOR, REVOLUTE, TARGET, WELD

SHARE_A_LIMIT = (MOTOR, TARGET, FRICTION)
"""Kinds whose force has a limit in all directions, which two rows share."""
MAX_COLORS = 62
"""Joints that find no colour below this are swept one by one, as all other joints of a net."""

ANCHOR_AX = 0 * LANES
"""Anchors from the centres of their bodies, world axes when the step began."""
ANCHOR_AY = 1 * LANES
ANCHOR_BX = 2 * LANES
ANCHOR_BY = 3 * LANES
CENTER_X = 4 * LANES
"""From the centre of a to that of b when the step began."""
CENTER_Y = 5 * LANES
INVERSE_MASS_A = 6 * LANES
INVERSE_INERTIA_A = 7 * LANES
INVERSE_MASS_B = 8 * LANES
INVERSE_INERTIA_B = 9 * LANES
TOTAL_X = 10 * LANES
"""Impulse over the step so far."""
TOTAL_Y = 11 * LANES
IMPULSE_X = 12 * LANES
"""Of a hinge or weld; what rods have instead follows below."""
IMPULSE_Y = 13 * LANES
HINGE_BLOCK_SIZE = 14 * LANES
IMPULSE = 12 * LANES
"""Along a rod or spring."""
LENGTH = 13 * LANES
"""At rest."""
HERTZ = 14 * LANES
"""Of a spring; -1 of a rod."""
DAMPING_RATIO = 15 * LANES
AXIS_X = 16 * LANES
"""From anchor a to anchor b when last looked at."""
AXIS_Y = 17 * LANES
ROD_BLOCK_SIZE = 18 * LANES
IMPULSE_W = 14 * LANES
"""Of a weld, as all that follows."""
TOTAL_W = 15 * LANES
TURN = 16 * LANES
"""Angle of b less angle of a, less the reference angle, when the step began."""
WELD_HERTZ = 17 * LANES
"""0 of a rigid one."""
WELD_DAMPING_RATIO = 18 * LANES
ANGULAR_HERTZ = 19 * LANES
ANGULAR_DAMPING_RATIO = 20 * LANES
WELD_BLOCK_SIZE = 22 * LANES

HINGES, RODS, WELDS = range(3)
"""Kinds of blocks."""

NET_JOINT = Table(
    "net_joint",
    (
        Field("joint", "-", "row in the joint table", "i8"),
        Field("member_a", "-", "", "i8"),
        Field("member_b", "-", "", "i8"),
    ),
)
"""Joints in the order in which they are solved: part by part, colour by colour, kind by kind."""

NET_BLOCK = Table(
    "net_block",
    (
        Field("first", "-", "its first joint", "i4"),
        Field("count", "-", "lanes in use, 1..4", "i4"),
        Field("place", "-", "of its first field in `lanes`", "i8"),
        Field("kind", "-", "`HINGES`, `RODS`, springs included, or `WELDS`", "i4"),
        Field("before", "-", "blocks of the same part, colour and kind before it", "i4"),
        Field("left", "-", "blocks of them from it on", "i8"),
        *(
            Field(f"{side}{k}", "-", f"row of motions of body {side} of lane {k}", "i4")
            for side in "ab"
            for k in range(4)
        ),
    ),
)
"""One cache line a block. Lanes that are not used have the bodies of the first one."""


class NetLanes(NamedTuple):
    """The joints of nets that are solved side by side."""

    joints: Records
    blocks: Records
    lanes: Floats


def lay_lanes(joints: Records, members: Records, constraints: Records, parts: Records) -> NetLanes:
    """Colour the plain joints of nets, greedily in the order of their constraints, and cut every colour into blocks.

    Notes in the constraints which of them lie in lanes, and in the parts which blocks are theirs, and of what kind
    their other joints are.
    """
    if parts.direct.all():  # no nets, as in most worlds: of such notes all is zero
        return NetLanes(NET_JOINT.zeros(0), NET_BLOCK.zeros(0), aligned_zeros(0, np.float64))
    kind = joints.kind[constraints.joint]
    coupled = np.zeros(len(constraints), bool)
    for column in (constraints.constraint_1, constraints.constraint_2):
        coupled[column[kind == GEAR]] = True
    rod = (kind == DISTANCE) & (constraints.row_count == 1) & (joints.limit[constraints.joint] == 0)
    hinge = (kind == REVOLUTE) & (constraints.row_count == 2) & ~coupled
    weld = kind == WELD
    plain = (parts.direct[constraints.part] == 0) & (rod | hinge | weld)
    block_kind = np.where(rod, RODS, np.where(weld, WELDS, HINGES))
    colors = np.full(len(constraints), MAX_COLORS)
    if plain.any():
        colors[plain] = _colors(members, constraints[plain])
    constraints.in_lane = colors < MAX_COLORS
    numbers = np.arange(len(parts))
    parts.swept = np.isin(numbers, constraints.part[constraints.in_lane == 0]) & (parts.direct == 0)
    parts.geared = np.isin(numbers, constraints.part[kind == GEAR]) & (parts.direct == 0)
    parts.capped = np.isin(numbers, constraints.part[np.isin(kind, SHARE_A_LIMIT)]) & (parts.direct == 0)
    laid = np.flatnonzero(constraints.in_lane)
    laid = laid[np.lexsort((laid, block_kind[laid], colors[laid], constraints.part[laid]))]
    found = NET_JOINT.zeros(len(laid))
    for name in ("joint", "member_a", "member_b"):
        found[name] = constraints[name][laid]
    blocks = _blocks(constraints.part[laid], colors[laid], block_kind[laid])
    of_part = constraints.part[laid][blocks.first]
    parts.first_block = np.searchsorted(of_part, numbers)
    parts.block_end = np.searchsorted(of_part, numbers, side="right")
    return NetLanes(found, blocks, lanes_for(blocks))


def lanes_for(blocks: Records) -> Floats:
    """Memory for blocks, and the place of each in it."""
    sizes = np.array([HINGE_BLOCK_SIZE, ROD_BLOCK_SIZE, WELD_BLOCK_SIZE])[blocks.kind]
    blocks.place = np.cumsum(sizes) - sizes
    return aligned_zeros(int(sizes.sum()), np.float64)


def _colors(members: Records, joints: Records) -> Integers:
    """For each joint the lowest colour that no earlier one has at a member which joints can move."""
    colors = np.zeros(len(joints), np.int64)
    moves = (members.part >= 0).astype(np.int64)
    run = color_joints if len(joints) > FEW_JOINTS else interpreted(color_joints)
    a, b = (np.ascontiguousarray(each) for each in (joints.member_a, joints.member_b))
    run(a, b, moves, np.zeros_like(moves), colors)
    return colors


@entry_point
def color_joints(members_a: Integers, members_b: Integers, moves: Integers, taken: Integers, colors: Integers) -> None:
    """Write the colours of joints between members, at most `MAX_COLORS`; `taken` are the colours at each, as bits."""
    for j in range(colors.shape[0]):
        a = members_a[j]
        b = members_b[j]
        both = taken[a] * moves[a] | taken[b] * moves[b]
        color = 0
        while color < MAX_COLORS and (both >> color) & 1 == 1:
            color += 1
        colors[j] = color
        taken[a] |= 1 << color
        taken[b] |= 1 << color


def _blocks(part: Integers, color: Integers, kind: Integers) -> Records:
    """Blocks of up to four neighbours that have all of these in common."""
    count = len(part)
    change = np.ones(count, bool)
    change[1:] = (part[1:] != part[:-1]) | (color[1:] != color[:-1]) | (kind[1:] != kind[:-1])
    starts = np.flatnonzero(change)
    since = np.arange(count) - np.repeat(starts, np.diff([*starts, count]))
    first = np.flatnonzero(since % LANES == 0)
    table = NET_BLOCK.zeros(len(first))
    table.first, table.count = first, np.diff([*first, count])
    table.kind = kind[first]
    table.before = since[first] // LANES
    last = np.append(table.before[1:] == 0, True)[: len(first)]
    table.left = np.repeat(table.before[last] + 1, table.before[last] + 1) - table.before
    return table

"""Scratch memory of the joint solver: never hashed, never saved; a pure function of the joint and body tables.

Jointed bodies are *members*, joints *constraints*, and every scalar constraint is a *row*. What
hangs together by joints is a *part*; it is solved as one linear system (`direct`) or, if too dense for that, by sweeps.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.net_lanes import NetLanes
from sandbox.tables import Field, Integers, Records, Table

MEMBER = Table(
    "member",
    (
        Field("body", "-", "index of the body; of the world, which is member 0, the last row of motions", "i8"),
        Field("part", "-", "part it belongs to; -1 for what joints cannot move", "i8"),
        Field("inverse_mass", "1/kg", ""),
        Field("inverse_inertia", "1/(kg m^2)", ""),
        Field("start_cos", "1", "rotation when the step began"),
        Field("start_sin", "1", "rotation when the step began"),
        Field("start_angle", "rad", "angle when the step began"),
        Field("center_x", "m", "centre of mass when the step began"),
        Field("center_y", "m", "centre of mass when the step began"),
        Field("cos", "1", "rotation now"),
        Field("sin", "1", "rotation now"),
        Field("angle", "rad", "angle now"),
        Field("spins", "-", "1 where it turns too fast for the impulses of the substep before", "i8"),
    ),
)

CONSTRAINT = Table(
    "constraint",
    (
        Field("joint", "-", "row in the joint table", "i8"),
        Field("part", "-", "", "i8"),
        Field("member_a", "-", "", "i8"),
        Field("member_b", "-", "", "i8"),
        Field("constraint_1", "-", "gear: constraints of the joints it couples", "i8"),
        Field("constraint_2", "-", "", "i8"),
        Field("first_row", "-", "", "i8"),
        Field("row_count", "-", "", "i8"),
        Field("in_lane", "-", "1 when it is solved side by side with others, see `net_lanes`", "i8"),
        Field("arm_ax", "m", "anchor from the centre of a, world axes"),
        Field("arm_ay", "m", ""),
        Field("arm_bx", "m", ""),
        Field("arm_by", "m", ""),
        Field("gap_x", "m", "from anchor a to anchor b"),
        Field("gap_y", "m", ""),
        Field("turn", "rad", "angle of b less angle of a, less the reference angle"),
        Field("axis_x", "1", "unit axis of the slide, or from anchor a to anchor b"),
        Field("axis_y", "1", ""),
        Field("error_0", "m or rad", "how far rows 0 to 2 are from being kept"),
        Field("error_1", "m or rad", ""),
        Field("error_2", "rad", ""),
        Field("place", "m or rad", "length, slide or angle: what spring, limit and motor act on"),
    ),
)

ROW = Table(
    "row",
    (
        Field("constraint", "-", "the joint it belongs to", "i8"),
        Field("slot", "-", "0 to 2: what the kind keeps; 3: its spring; 4: its limit and motor", "i8"),
        Field("error", "m or rad", "when the substep began"),
        Field("total", "N s", "over the step so far"),
        Field("stop", "-", "1 while the lower limit has a say, -1 for the upper one", "i8"),
        Field(
            "stiffness", "1/kg", "J M^-1 J^T: speed that a unit impulse gives; 0 while it has no say, or is in a lane"
        ),
        Field("easiest", "1/kg", "that of a point along the axis where it is greatest"),
        Field("steady", "-", "1 when what it strives for does not depend on speeds", "i8"),
        Field("bias", "m/s or rad/s", "the row strives for speed + bias + softness * impulse = 0"),
        Field("softness", "1/kg", "compliance over one impulse"),
        Field("low", "N s", "bounds of the impulse"),
        Field("high", "N s", ""),
        Field("impulse", "N s", ""),
        Field("sides", "-", "members it acts on: 2, or 4 for a gear", "i8"),
        *(Field(f"member_{k}", "-", "", "i8") for k in (1, 2, 3, 4)),
        *(Field(f"{axis}{k}", "1 or m", "Jacobian") for k in (1, 2, 3, 4) for axis in "xyw"),
    ),
)

PART = Table(
    "part",
    (
        Field("first_row", "-", "", "i8"),
        Field("row_end", "-", "", "i8"),
        Field("first_constraint", "-", "", "i8"),
        Field("constraint_end", "-", "", "i8"),
        Field("first_member", "-", "", "i8"),
        Field("member_end", "-", "", "i8"),
        Field("direct", "-", "1: factorised; 0: too dense for that, its joints are soft", "i8"),
        Field("layout", "-", "factorised: what it shares with all parts that are built alike", "i8"),
        Field("lane", "-", "factorised and awake: its lane, counted through all batches", "i8"),
        Field(
            "next_struck", "-", "1 + the next part that the same impact reaches, -1 for the last; 0 if none does", "i8"
        ),
        Field("first_fixed", "-", "factorised: bodies on the fixed sides of its joints", "i8"),
        Field("awake", "-", "", "i8"),
        Field("anchored", "-", "1 when it is joined to something that does not move", "i8"),
        Field("hung", "-", "1 when besides all its joints keep a point or a length: they bear its weight", "i8"),
        Field("mass", "kg", "of its bodies that move; this and the next four where piles are looked at"),
        Field("root", "-", "the root of its island", "i8"),
        Field("stands_on", "-", "contacts with what is below", "i8"),
        Field("bearer", "kg", "lightest body at one of these"),
        Field("slight", "m", "smallest extent of such a body"),
        Field("current", "-", "1 while it is solved: awake, and its island has the substep level under way", "i8"),
        Field("level", "-", "substep level of its island", "i8"),
        Field("supported", "-", "1 when something that is not joined to it bears it", "i8"),
        Field("free", "-", "1 when it has no contact", "i8"),
        Field("dragged", "-", "1 when a hand drags one of its bodies", "i8"),
        Field(
            "halves",
            "-",
            "1 when forces act half before and half after the move; not in what is borne or soft",
            "i8",
        ),
        Field("swept", "-", "1 when it has joints that lie in no lane", "i8"),
        Field("geared", "-", "1 when it has gears", "i8"),
        Field("capped", "-", "1 when it has joints two rows of which share a limit", "i8"),
        Field("first_block", "-", "blocks of joints that are solved side by side", "i8"),
        Field("block_end", "-", "", "i8"),
        Field("fine", "-", "1 when it is small, swings and has no contact: it takes finer substeps", "i8"),
    ),
)

BOND = Table(
    "bond",
    (
        Field("low", "-", "lower index of two joined bodies", "i8"),
        Field("high", "-", "higher index", "i8"),
    ),
)


class JointWork(NamedTuple):
    """The arrays of the joint solver.

    `ties` are the pairs of bodies with a joint. `part_of` names the part of every body, -1 where it has none. `rows`
    are those of parts that are not factorised; `direct` has all that the others need.
    """

    joints: Records
    ties: Records
    part_of: Integers
    members: Records
    constraints: Records
    rows: Records
    parts: Records
    side_by_side: NetLanes
    direct: Batches

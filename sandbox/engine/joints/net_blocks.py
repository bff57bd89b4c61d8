"""The bodies of a block of joints of nets: gathered before it is solved, scattered after it."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox._vectors import Mask, Vector, load, select
from sandbox.engine.contact_solver.gather import PairPose, PairRows, gather_fields, scatter_fields
from sandbox.engine.contact_solver.law import PairMass, PairVelocity
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.laws import share_within, spring_law, turned
from sandbox.engine.joints.net_lanes import NetLanes
from sandbox.tables import Floats, Records


class SoftJoint(NamedTuple):
    """How a sweep treats joints: `push` (1/s) turns an error into the speed that takes it back, of `most` m at most;
    `give` is the softness as a share of the stiffness, `seconds` the length of the substep (s)."""

    push: float
    most: float
    give: float
    seconds: float


class Members(NamedTuple):
    """The bodies of the joints of a block: their rows in the table of members, their velocities and poses, and what
    lies behind the velocities there."""

    rows: PairRows
    velocity: PairVelocity
    pose: PairPose
    start_cos_a: Vector
    start_cos_b: Vector


class Gap(NamedTuple):
    """The anchors of joints from the centres of their bodies, and from anchor a to anchor b, m, world axes."""

    ax: Vector
    ay: Vector
    bx: Vector
    by: Vector
    x: Vector
    y: Vector


class Spring(NamedTuple):
    """Where a row is a spring, its frequency (1/s) and damping ratio."""

    sprung: Mask
    hertz: Vector
    ratio: Vector


class Row(NamedTuple):
    """What a row of joints is at: how far it is from being kept (m or rad), J M^-1 J^T (1/kg), speed, and impulse."""

    error: Vector
    stiffness: Vector
    speed: Vector
    impulse: Vector


_VELOCITY, _DISPLACEMENT = 4, 12
"""Numbers of fields of the table of members: velocity_x and displacement_x, each before what belongs to it."""


@inlined_kernel
def gather_block(members: Records, h: NetLanes, block: Records) -> Members:
    """The bodies of a block; lanes that are not used have those of the first one."""
    k0 = block.first
    k1 = k0 + 1 if block.count > 1 else k0
    k2 = k0 + 2 if block.count > 2 else k0
    k3 = k0 + 3 if block.count > 3 else k0
    rows = PairRows(
        (h.joints[k0].member_a, h.joints[k1].member_a, h.joints[k2].member_a, h.joints[k3].member_a),
        (h.joints[k0].member_b, h.joints[k1].member_b, h.joints[k2].member_b, h.joints[k3].member_b),
    )
    ax, ay, aw, start_cos_a = gather_fields(members, rows.a, _VELOCITY)
    bx, by, bw, start_cos_b = gather_fields(members, rows.b, _VELOCITY)
    from_x, from_y, cos_a, sin_a = gather_fields(members, rows.a, _DISPLACEMENT)
    to_x, to_y, cos_b, sin_b = gather_fields(members, rows.b, _DISPLACEMENT)
    pose = PairPose(to_x - from_x, to_y - from_y, cos_a, sin_a, cos_b, sin_b)
    return Members(rows, PairVelocity(ax, ay, aw, bx, by, bw), pose, start_cos_a, start_cos_b)


@inlined_kernel
def scatter_block(members: Records, of: Members, v: PairVelocity, count: int) -> None:
    """Write the velocities of `count` joints back to the rows they came from."""
    scatter_fields(members, of.rows.a, _VELOCITY, (v.ax, v.ay, v.aw, of.start_cos_a), 0, count)
    scatter_fields(members, of.rows.b, _VELOCITY, (v.bx, v.by, v.bw, of.start_cos_b), 0, count)


@inlined_kernel
def row_change(row: Row, spring: Spring, soft: SoftJoint) -> Vector:
    """The change of its impulse that a row strives for. Springs have had their say once nothing is pushed any more."""
    share = share_within(row.error, soft.most)
    bias = soft.push * share * row.error
    give = soft.give * share * row.stiffness
    acts = row.stiffness > 0.0
    if soft.push > 0.0:
        soft_bias, softer = spring_law(row.error, spring.hertz, spring.ratio, row.stiffness, soft.seconds)
        bias = select(spring.sprung, soft_bias, bias)
        give = select(spring.sprung, softer, give)
    else:
        acts = acts & ~spring.sprung
    wanted = row.speed + bias + give * row.impulse
    return select(acts, -wanted / select(acts, row.stiffness + give, 1.0), 0.0)


@inlined_kernel
def block_masses(v: Floats) -> PairMass:
    """Inverse masses and inertias of the bodies of a block with lanes `v`."""
    return PairMass(
        load(v, nl.INVERSE_MASS_A),
        load(v, nl.INVERSE_INERTIA_A),
        load(v, nl.INVERSE_MASS_B),
        load(v, nl.INVERSE_INERTIA_B),
    )


@inlined_kernel
def gap_of(v: Floats, pose: PairPose) -> Gap:
    """The anchors of a block with lanes `v` at the poses of its bodies."""
    ax, ay = turned(pose.cos_a, pose.sin_a, load(v, nl.ANCHOR_AX), load(v, nl.ANCHOR_AY))
    bx, by = turned(pose.cos_b, pose.sin_b, load(v, nl.ANCHOR_BX), load(v, nl.ANCHOR_BY))
    x = load(v, nl.CENTER_X) + pose.x + (bx - ax)
    y = load(v, nl.CENTER_Y) + pose.y + (by - ay)
    return Gap(ax, ay, bx, by, x, y)

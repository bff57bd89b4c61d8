"""The bodies of a block of joints of nets: gathered before it is solved, scattered after it."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox._vectors import Mask, Vector, load, select
from sandbox.engine.contact_solver.gather import (
    Gathered,
    PairPose,
    PairRows,
    gather_poses_and_turns,
    gather_velocities,
    rows_of,
    scatter_velocities,
)
from sandbox.engine.contact_solver.law import PairMass, PairVelocity
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.laws import share_within, spring_law, turned
from sandbox.tables import Floats, Records


class SoftJoint(NamedTuple):
    """How a sweep treats joints: `push` (1/s) turns an error into the speed that takes it back, of `most` m at most;
    `give` is the softness as a share of the stiffness, `seconds` the length of the substep (s)."""

    push: float
    most: float
    give: float
    seconds: float


class BlockBodies(NamedTuple):
    """The bodies of the joints of a block: their rows, their velocities, where they are, and by how much b has turned
    against a since the step began (rad)."""

    rows: PairRows
    gathered: Gathered
    pose: PairPose
    turn: Vector


class Gap(NamedTuple):
    """The anchors of joints from the centres of their bodies, and from anchor a to anchor b, m, world axes."""

    ax: Vector
    ay: Vector
    bx: Vector
    by: Vector
    x: Vector
    y: Vector


class Spring(NamedTuple):
    """Where a row is a spring, its frequency (1/s), its damping ratio, and what it swings with them, 1/kg or
    1/(kg m^2)."""

    sprung: Mask
    hertz: Vector
    ratio: Vector
    mobility: Vector


class Row(NamedTuple):
    """What a row of joints is at: how far it is from being kept (m or rad), J M^-1 J^T (1/kg), speed, and impulse."""

    error: Vector
    stiffness: Vector
    speed: Vector
    impulse: Vector


@inlined_kernel
def gather_block(motions: Records, block: Records) -> BlockBodies:
    """The bodies of a block."""
    rows = rows_of(block)
    gathered = gather_velocities(motions, rows)
    pose, turn = gather_poses_and_turns(motions, rows, gathered)
    return BlockBodies(rows, gathered, pose, turn)


@inlined_kernel
def scatter_block(motions: Records, of: BlockBodies, v: PairVelocity, count: int) -> None:
    """Write the velocities of `count` joints back to the rows they came from."""
    scatter_velocities(motions, of.rows, v, of.gathered, 0, count)


@inlined_kernel
def row_change(row: Row, spring: Spring, soft: SoftJoint, most: float) -> Vector:
    """The change of its impulse that a row strives for, which takes back an error of at most `most` (m or rad).

    Springs have had their say once nothing is pushed any more.
    """
    share = share_within(row.error, most)
    bias = soft.push * share * row.error
    give = soft.give * share * row.stiffness
    acts = row.stiffness > 0.0
    if soft.push > 0.0:
        soft_bias, softer = spring_law(row.error, spring.hertz, spring.ratio, spring.mobility, soft.seconds)
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

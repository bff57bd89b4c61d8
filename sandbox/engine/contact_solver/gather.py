"""The two bodies of four contacts or joints side by side: their motions as vectors, and back into their rows."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox._vectors import Vector
from sandbox.engine.contact_solver.law import PairVelocity
from sandbox.engine.records.bodies import POSE, VELOCITY
from sandbox.engine.records.gather_fields import Rows, gather_fields, scatter_fields
from sandbox.tables import Records


class PairRows(NamedTuple):
    """The rows of the bodies a and b of four contacts or joints."""

    a: Rows
    b: Rows


class PairPose(NamedTuple):
    """How far b has moved against a since the step began (m), and the rotations of both since then."""

    x: Vector
    y: Vector
    cos_a: Vector
    sin_a: Vector
    cos_b: Vector
    sin_b: Vector


class Gathered(NamedTuple):
    """The velocities of two bodies, and what lies between them and the poses in the table."""

    velocity: PairVelocity
    delta_ax: Vector
    delta_bx: Vector


@inlined_kernel
def rows_of(block: Records) -> PairRows:
    """The bodies of a block of contacts or joints."""
    return PairRows((block.a0, block.a1, block.a2, block.a3), (block.b0, block.b1, block.b2, block.b3))


@inlined_kernel
def note_rows(block: Records, rows: PairRows) -> None:
    """Note the bodies of a block, for `rows_of`."""
    block.a0, block.a1, block.a2, block.a3 = rows.a
    block.b0, block.b1, block.b2, block.b3 = rows.b


@inlined_kernel
def gather_velocities(motions: Records, rows: PairRows) -> Gathered:
    """The velocities of four pairs of bodies."""
    ax, ay, aw, delta_ax = gather_fields(motions, rows.a, VELOCITY)
    bx, by, bw, delta_bx = gather_fields(motions, rows.b, VELOCITY)
    return Gathered(PairVelocity(ax, ay, aw, bx, by, bw), delta_ax, delta_bx)


@inlined_kernel
def gather_poses(motions: Records, rows: PairRows, of: Gathered) -> PairPose:
    """How far four pairs of bodies have moved and turned since the step began."""
    pose, _ = gather_poses_and_turns(motions, rows, of)
    return pose


@inlined_kernel
def gather_poses_and_turns(motions: Records, rows: PairRows, of: Gathered) -> tuple[PairPose, Vector]:
    """The same, and by how much b has turned against a (rad)."""
    ay, cos_a, sin_a, angle_a = gather_fields(motions, rows.a, POSE)
    by, cos_b, sin_b, angle_b = gather_fields(motions, rows.b, POSE)
    return PairPose(of.delta_bx - of.delta_ax, by - ay, cos_a, sin_a, cos_b, sin_b), angle_b - angle_a


@inlined_kernel
def scatter_velocities(
    motions: Records, rows: PairRows, v: PairVelocity, of: Gathered, first_lane: int, end_lane: int
) -> None:
    """Write the velocities of the lanes first_lane..end_lane-1 back to the rows that were gathered."""
    scatter_fields(motions, rows.a, VELOCITY, (v.ax, v.ay, v.aw, of.delta_ax), first_lane, end_lane)
    scatter_fields(motions, rows.b, VELOCITY, (v.bx, v.by, v.bw, of.delta_bx), first_lane, end_lane)

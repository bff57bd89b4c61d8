"""Bodies side by side: four rows of a table become vectors, field by field, and vectors become rows again."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

from sandbox._jit import inlined_kernel
from sandbox._vectors import Vector, load_fields, store_fields, transpose
from sandbox.engine.contact_solver.law import PairVelocity
from sandbox.tables import Records

Rows: TypeAlias = tuple[int, int, int, int]
"""A row of a table for each lane."""
_VELOCITY, _POSE = 0, 4
"""Numbers of the first field of either half of a row of the motion table (`records.bodies.MOTION`)."""


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
def gather_fields(table: Records, rows: Rows, first: int) -> tuple[Vector, Vector, Vector, Vector]:
    """Four fields of four rows, from the one with number `first` on: a vector for each field."""
    return transpose(
        load_fields(table, rows[0], first),
        load_fields(table, rows[1], first),
        load_fields(table, rows[2], first),
        load_fields(table, rows[3], first),
    )


@inlined_kernel
def scatter_fields(
    table: Records,
    rows: Rows,
    first: int,
    fields: tuple[Vector, Vector, Vector, Vector],
    first_lane: int,
    end_lane: int,
) -> None:
    """The other way, for the lanes first_lane..end_lane-1."""
    of_row = transpose(fields[0], fields[1], fields[2], fields[3])
    if first_lane <= 0 < end_lane:
        store_fields(table, rows[0], first, of_row[0])
    if first_lane <= 1 < end_lane:
        store_fields(table, rows[1], first, of_row[1])
    if first_lane <= 2 < end_lane:
        store_fields(table, rows[2], first, of_row[2])
    if first_lane <= 3 < end_lane:
        store_fields(table, rows[3], first, of_row[3])


@inlined_kernel
def gather_velocities(motions: Records, rows: PairRows) -> Gathered:
    """The velocities of four pairs of bodies."""
    ax, ay, aw, delta_ax = gather_fields(motions, rows.a, _VELOCITY)
    bx, by, bw, delta_bx = gather_fields(motions, rows.b, _VELOCITY)
    return Gathered(PairVelocity(ax, ay, aw, bx, by, bw), delta_ax, delta_bx)


@inlined_kernel
def gather_poses(motions: Records, rows: PairRows, of: Gathered) -> PairPose:
    """How far four pairs of bodies have moved and turned since the step began."""
    pose, _ = gather_poses_and_turns(motions, rows, of)
    return pose


@inlined_kernel
def gather_poses_and_turns(motions: Records, rows: PairRows, of: Gathered) -> tuple[PairPose, Vector]:
    """The same, and by how much b has turned against a (rad)."""
    ay, cos_a, sin_a, angle_a = gather_fields(motions, rows.a, _POSE)
    by, cos_b, sin_b, angle_b = gather_fields(motions, rows.b, _POSE)
    return PairPose(of.delta_bx - of.delta_ax, by - ay, cos_a, sin_a, cos_b, sin_b), angle_b - angle_a


@inlined_kernel
def scatter_velocities(
    motions: Records, rows: PairRows, v: PairVelocity, of: Gathered, first_lane: int, end_lane: int
) -> None:
    """Write the velocities of the lanes first_lane..end_lane-1 back to the rows that were gathered."""
    scatter_fields(motions, rows.a, _VELOCITY, (v.ax, v.ay, v.aw, of.delta_ax), first_lane, end_lane)
    scatter_fields(motions, rows.b, _VELOCITY, (v.bx, v.by, v.bw, of.delta_bx), first_lane, end_lane)

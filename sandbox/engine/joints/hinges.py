"""The law of the hinges of nets, four side by side: soft joints as in `gauss_seidel`, both rows of a hinge at once."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, Vector, load, select, store
from sandbox.engine.contact_solver.law import Anchors, PairMass, PairVelocity, apply_impulse, relative_velocity
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.laws import is_close, share_within
from sandbox.engine.joints.net_blocks import BlockBodies, Gap, SoftJoint, block_masses, gap_of
from sandbox.tables import Floats, Records


@kernel
def load_hinge(v: Floats, k: int, joint: Records, share: float) -> None:
    """Fill lane `k` of a block with lanes `v` with what hinges alone have; `share` is a `substep_share`."""
    v[nl.IMPULSE_X + k] = share * joint.impulse_0
    v[nl.IMPULSE_Y + k] = share * joint.impulse_1
    # The first warm start adds what the last substep gave; that belongs to no substep of this step.
    v[nl.TOTAL_X + k] = -share * joint.impulse_0
    v[nl.TOTAL_Y + k] = -share * joint.impulse_1


@kernel
def scale_hinge(v: Floats, k: int, share: float) -> None:
    """Multiply the impulses in lane `k`."""
    v[nl.IMPULSE_X + k] *= share
    v[nl.IMPULSE_Y + k] *= share


@inlined_kernel
def warm_hinges(v: Floats, of: BlockBodies) -> PairVelocity:
    """The velocities after the impulses of the substep before, which are added to those of the step."""
    return warm_point(v, of, pushed_at(gap_of(v, of.pose)))


@inlined_kernel
def warm_point(v: Floats, of: BlockBodies, r: Anchors) -> PairVelocity:
    """The same for points that are pushed at `r`."""
    x = load(v, nl.IMPULSE_X)
    y = load(v, nl.IMPULSE_Y)
    store(v, nl.TOTAL_X, load(v, nl.TOTAL_X) + x)
    store(v, nl.TOTAL_Y, load(v, nl.TOTAL_Y) + y)
    return apply_impulse(of.gathered.velocity, block_masses(v), r, x, y)


@inlined_kernel
def pushed_at(gap: Gap) -> Anchors:
    """Both are pushed at b's anchor, unless that is further off than half of the longer arm; see `jacobian`."""
    return pushed_together(gap, is_close(gap.ax, gap.ay, gap.bx, gap.by, gap.x, gap.y))


@inlined_kernel
def pushed_together(gap: Gap, where: Mask) -> Anchors:
    """Both are pushed at b's anchor there, elsewhere each at its own."""
    return Anchors(gap.ax + select(where, gap.x, 0.0), gap.ay + select(where, gap.y, 0.0), gap.bx, gap.by)


class PointMatrix(NamedTuple):
    """J M^-1 J^T of both rows of an anchor point, 1/kg."""

    xx: Vector
    yy: Vector
    xy: Vector


class PointLaw(NamedTuple):
    """What both rows strive for: speed + bias (m/s) + give (1/kg) * impulse = 0."""

    bias_x: Vector
    bias_y: Vector
    give_x: Vector
    give_y: Vector


@inlined_kernel
def point_matrix(masses: PairMass, r: Anchors) -> PointMatrix:
    """How easily the anchors move away from each other."""
    ia = masses.inertia_a
    ib = masses.inertia_b
    mass = masses.mass_a + masses.mass_b
    xx = mass + ia * r.ay * r.ay + ib * r.by * r.by
    yy = mass + ia * r.ax * r.ax + ib * r.bx * r.bx
    return PointMatrix(xx, yy, -(ia * r.ax * r.ay) - ib * r.bx * r.by)


@inlined_kernel
def rigid_law(gap: Gap, matrix: PointMatrix, soft: SoftJoint) -> PointLaw:
    """The law of anchors that are kept together."""
    share_x = share_within(gap.x, soft.most)
    share_y = share_within(gap.y, soft.most)
    return PointLaw(
        soft.push * share_x * gap.x,
        soft.push * share_y * gap.y,
        soft.give * matrix.xx * share_x,
        soft.give * matrix.yy * share_y,
    )


@inlined_kernel
def point_change(v: Floats, u: PairVelocity, r: Anchors, matrix: PointMatrix, law: PointLaw) -> tuple[Vector, Vector]:
    """The changes of the impulses of a block with lanes `v` that both rows strive for at the velocities `u`."""
    x, y = relative_velocity(u, r)
    x = x + law.bias_x + law.give_x * load(v, nl.IMPULSE_X)
    y = y + law.bias_y + law.give_y * load(v, nl.IMPULSE_Y)
    xx = matrix.xx + law.give_x
    yy = matrix.yy + law.give_y
    determinant = xx * yy - matrix.xy * matrix.xy
    regular = determinant > 0.0
    inverse = select(regular, 1.0 / select(regular, determinant, 1.0), 0.0)
    return -inverse * (yy * x - matrix.xy * y), -inverse * (xx * y - matrix.xy * x)


@inlined_kernel
def push_point(v: Floats, u: PairVelocity, masses: PairMass, r: Anchors, x: Vector, y: Vector) -> PairVelocity:
    """Add to the impulses of a block with lanes `v`, and to the velocities."""
    store(v, nl.IMPULSE_X, load(v, nl.IMPULSE_X) + x)
    store(v, nl.IMPULSE_Y, load(v, nl.IMPULSE_Y) + y)
    return apply_impulse(u, masses, r, x, y)


@inlined_kernel
def swept_hinges(v: Floats, of: BlockBodies, soft: SoftJoint) -> PairVelocity:
    """The velocities after a sweep over a block of hinges with lanes `v`, whose impulses it changes."""
    gap = gap_of(v, of.pose)
    r = pushed_at(gap)
    masses = block_masses(v)
    matrix = point_matrix(masses, r)
    x, y = point_change(v, of.gathered.velocity, r, matrix, rigid_law(gap, matrix, soft))
    return push_point(v, of.gathered.velocity, masses, r, x, y)


@kernel
def report_hinge(v: Floats, k: int, joint: Records, share: float) -> tuple[float, float]:
    """Write the impulses of lane `k` into the joint table; returns those of the step (N s)."""
    joint.impulse_0 = v[nl.IMPULSE_X + k] / share
    joint.impulse_1 = v[nl.IMPULSE_Y + k] / share
    return v[nl.TOTAL_X + k] + v[nl.IMPULSE_X + k], v[nl.TOTAL_Y + k] + v[nl.IMPULSE_Y + k]

"""The law of the welds of nets, four side by side: that of hinges, then the angle; either may be a spring."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Vector, load, select, store
from sandbox.engine.contact_solver.law import Anchors, PairMass, PairVelocity
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.hinges import (
    PointLaw,
    load_hinge,
    point_change,
    point_matrix,
    push_point,
    pushed_together,
    report_hinge,
    rigid_law,
    scale_hinge,
    warm_point,
)
from sandbox.engine.joints.laws import CORRECTION_SPEED, is_close, spring_law, spring_mobility
from sandbox.engine.joints.net_blocks import BlockBodies, Gap, Row, SoftJoint, Spring, block_masses, gap_of, row_change
from sandbox.tables import Floats, Records


@kernel
def load_weld(v: Floats, k: int, joint: Records, a: Records, b: Records, share: float) -> None:
    """Fill lane `k` of a block with lanes `v` with what welds alone have; a and b are its members, `share` is a
    `substep_share`."""
    load_hinge(v, k, joint, share)
    v[nl.IMPULSE_W + k] = share * joint.impulse_2
    v[nl.TOTAL_W + k] = -share * joint.impulse_2
    v[nl.TURN + k] = b.start_angle - a.start_angle - joint.reference_angle
    v[nl.WELD_HERTZ + k] = joint.hertz
    v[nl.WELD_DAMPING_RATIO + k] = joint.damping_ratio
    v[nl.ANGULAR_HERTZ + k] = joint.angular_hertz
    v[nl.ANGULAR_DAMPING_RATIO + k] = joint.angular_damping_ratio


@kernel
def scale_weld(v: Floats, k: int, share: float) -> None:
    """Multiply the impulses in lane `k`."""
    scale_hinge(v, k, share)
    v[nl.IMPULSE_W + k] *= share


@inlined_kernel
def warm_welds(v: Floats, of: BlockBodies) -> PairVelocity:
    """The velocities after the impulses of the substep before, which are added to those of the step."""
    impulse = load(v, nl.IMPULSE_W)
    store(v, nl.TOTAL_W, load(v, nl.TOTAL_W) + impulse)
    return _turned_by(warm_point(v, of, _pushed_at(v, gap_of(v, of.pose))), block_masses(v), impulse)


@inlined_kernel
def _pushed_at(v: Floats, gap: Gap) -> Anchors:
    """As hinges are; but both ends of a spring always at one point."""
    sprung = load(v, nl.WELD_HERTZ) > 0.0
    return pushed_together(gap, sprung | is_close(gap.ax, gap.ay, gap.bx, gap.by, gap.x, gap.y))


@inlined_kernel
def _turned_by(u: PairVelocity, masses: PairMass, impulse: Vector) -> PairVelocity:
    """The velocities after an angular impulse (N m s) on b, and the opposite on a."""
    return PairVelocity(u.ax, u.ay, u.aw - masses.inertia_a * impulse, u.bx, u.by, u.bw + masses.inertia_b * impulse)


@inlined_kernel
def swept_welds(v: Floats, of: BlockBodies, soft: SoftJoint) -> PairVelocity:
    """The velocities after a sweep over a block of welds with lanes `v`, whose impulses it changes.

    Springs have had their say once nothing is pushed any more.
    """
    gap = gap_of(v, of.pose)
    r = _pushed_at(v, gap)
    masses = block_masses(v)
    matrix = point_matrix(masses, r)
    law = rigid_law(gap, matrix, soft)
    hertz = load(v, nl.WELD_HERTZ)
    sprung = hertz > 0.0
    if soft.push > 0.0:
        ratio = load(v, nl.WELD_DAMPING_RATIO)
        straight = masses.mass_a + masses.mass_b
        mobility = spring_mobility(straight, matrix.xx + matrix.yy - straight, hertz, soft.seconds)
        bias_x, give = spring_law(gap.x, hertz, ratio, mobility, soft.seconds)
        bias_y, give = spring_law(gap.y, hertz, ratio, mobility, soft.seconds)
        law = PointLaw(
            select(sprung, bias_x, law.bias_x),
            select(sprung, bias_y, law.bias_y),
            select(sprung, give, law.give_x),
            select(sprung, give, law.give_y),
        )
    x, y = point_change(v, of.gathered.velocity, r, matrix, law)
    if soft.push == 0.0:
        x = select(sprung, 0.0, x)
        y = select(sprung, 0.0, y)
    u = push_point(v, of.gathered.velocity, masses, r, x, y)
    hertz = load(v, nl.ANGULAR_HERTZ)
    impulse = load(v, nl.IMPULSE_W)
    mobility = masses.inertia_a + masses.inertia_b
    most = CORRECTION_SPEED / soft.push if soft.push > 0.0 else 0.0
    row = Row(load(v, nl.TURN) + of.turn, mobility, u.bw - u.aw, impulse)
    change = row_change(row, Spring(hertz > 0.0, hertz, load(v, nl.ANGULAR_DAMPING_RATIO), mobility), soft, most)
    store(v, nl.IMPULSE_W, impulse + change)
    return _turned_by(u, masses, change)


@kernel
def report_weld(v: Floats, k: int, joint: Records, share: float) -> tuple[float, float, float]:
    """Write the impulses of lane `k` into the joint table; returns those of the step, the third in N m s."""
    x, y = report_hinge(v, k, joint, share)
    joint.impulse_2 = v[nl.IMPULSE_W + k] / share
    return x, y, v[nl.TOTAL_W + k] + v[nl.IMPULSE_W + k]

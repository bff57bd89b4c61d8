"""The law of the hinges of nets, four side by side: soft joints as in `gauss_seidel`, both rows of a hinge at once."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, load, select, store
from sandbox.engine.contact_solver.law import Anchors, PairVelocity, apply_impulse, relative_velocity
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.laws import is_close, share_within
from sandbox.engine.joints.net_blocks import Gap, Members, SoftJoint, block_masses, gap_of
from sandbox.tables import Floats, Records


@kernel
def load_hinge(v: Floats, k: int, joint: Records) -> None:
    """Fill lane `k` of a block with lanes `v` with what hinges alone have."""
    v[nl.IMPULSE_X + k] = joint.impulse_0
    v[nl.IMPULSE_Y + k] = joint.impulse_1


@inlined_kernel
def warm_hinges(v: Floats, of: Members, spins: Mask) -> PairVelocity:
    """The velocities after the impulses of the substep before, which are forgotten where something `spins`."""
    x = select(spins, 0.0, load(v, nl.IMPULSE_X))
    y = select(spins, 0.0, load(v, nl.IMPULSE_Y))
    store(v, nl.IMPULSE_X, x)
    store(v, nl.IMPULSE_Y, y)
    return apply_impulse(of.velocity, block_masses(v), _pushed_at(gap_of(v, of.pose)), x, y)


@inlined_kernel
def _pushed_at(gap: Gap) -> Anchors:
    """Both are pushed at b's anchor, unless that is further off than half of the longer arm; see `jacobian`."""
    close = is_close(gap.ax, gap.ay, gap.bx, gap.by, gap.x, gap.y)
    return Anchors(gap.ax + select(close, gap.x, 0.0), gap.ay + select(close, gap.y, 0.0), gap.bx, gap.by)


@inlined_kernel
def swept_hinges(v: Floats, of: Members, soft: SoftJoint) -> PairVelocity:
    """The velocities after a sweep over a block of hinges with lanes `v`, whose impulses it changes."""
    velocity = of.velocity
    gap = gap_of(v, of.pose)
    r = _pushed_at(gap)
    masses = block_masses(v)
    ia = masses.inertia_a
    ib = masses.inertia_b
    mass = masses.mass_a + masses.mass_b
    xx = mass + ia * r.ay * r.ay + ib * r.by * r.by
    yy = mass + ia * r.ax * r.ax + ib * r.bx * r.bx
    xy = -(ia * r.ax * r.ay) - ib * r.bx * r.by
    share_x = share_within(gap.x, soft.most)
    share_y = share_within(gap.y, soft.most)
    give_x = soft.give * xx * share_x
    give_y = soft.give * yy * share_y
    impulse_x = load(v, nl.IMPULSE_X)
    impulse_y = load(v, nl.IMPULSE_Y)
    x, y = relative_velocity(velocity, r)
    x = x + soft.push * share_x * gap.x + give_x * impulse_x
    y = y + soft.push * share_y * gap.y + give_y * impulse_y
    soft_xx = xx + give_x
    soft_yy = yy + give_y
    determinant = soft_xx * soft_yy - xy * xy
    regular = determinant > 0.0
    inverse = select(regular, 1.0 / select(regular, determinant, 1.0), 0.0)
    change_x = -inverse * (soft_yy * x - xy * y)
    change_y = -inverse * (soft_xx * y - xy * x)
    store(v, nl.IMPULSE_X, impulse_x + change_x)
    store(v, nl.IMPULSE_Y, impulse_y + change_y)
    return apply_impulse(velocity, masses, r, change_x, change_y)


@kernel
def accumulate_hinge_block(v: Floats) -> None:
    """Add the impulses of a substep to those of the step."""
    store(v, nl.TOTAL_X, load(v, nl.TOTAL_X) + load(v, nl.IMPULSE_X))
    store(v, nl.TOTAL_Y, load(v, nl.TOTAL_Y) + load(v, nl.IMPULSE_Y))


@kernel
def report_hinge(v: Floats, k: int, joint: Records) -> None:
    """Write the impulses of lane `k` into the joint table."""
    joint.impulse_0 = v[nl.IMPULSE_X + k]
    joint.impulse_1 = v[nl.IMPULSE_Y + k]

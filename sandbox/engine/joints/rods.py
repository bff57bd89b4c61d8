"""The law of the rods and springs of nets, four side by side: soft joints as in `gauss_seidel`."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import load, store
from sandbox.engine.contact_solver.law import Anchors, PairVelocity, apply_impulse
from sandbox.engine.joints import net_lanes as nl
from sandbox.engine.joints.laws import along, length_and_direction, own_stiffness, spring_mobility
from sandbox.engine.joints.net_blocks import BlockBodies, Gap, Row, SoftJoint, Spring, block_masses, gap_of, row_change
from sandbox.tables import Floats, Records

ROD = -1.0
"""In the place of a frequency: it is no spring."""


@kernel
def load_rod(v: Floats, k: int, joint: Records, share: float) -> None:
    """Fill lane `k` of a block with lanes `v` with what rods and springs alone have; `share` is a `substep_share`."""
    v[nl.IMPULSE + k] = share * (joint.impulse_3 if joint.spring == 1 else joint.impulse_0)
    v[nl.TOTAL_X + k] = v[nl.TOTAL_Y + k] = 0.0
    v[nl.AXIS_X + k] = v[nl.AXIS_Y + k] = 0.0  # what the last step gave belongs to no substep of this one
    v[nl.LENGTH + k] = joint.length
    v[nl.HERTZ + k] = joint.hertz if joint.spring == 1 else ROD
    v[nl.DAMPING_RATIO + k] = joint.damping_ratio


@kernel
def scale_rod(v: Floats, k: int, share: float) -> None:
    """Multiply the impulse in lane `k`."""
    v[nl.IMPULSE + k] *= share


@inlined_kernel
def warm_rods(v: Floats, of: BlockBodies) -> PairVelocity:
    """The velocities after the impulses of the substep before, which are added to those of the step."""
    gap = gap_of(v, of.pose)
    _, x, y = length_and_direction(gap.x, gap.y, 1.0)
    impulse = load(v, nl.IMPULSE)
    store(v, nl.TOTAL_X, load(v, nl.TOTAL_X) + impulse * load(v, nl.AXIS_X))
    store(v, nl.TOTAL_Y, load(v, nl.TOTAL_Y) + impulse * load(v, nl.AXIS_Y))
    return apply_impulse(of.gathered.velocity, block_masses(v), _pushed_at(gap), impulse * x, impulse * y)


@inlined_kernel
def _pushed_at(gap: Gap) -> Anchors:
    """Both bodies are pushed at anchor b: no angular momentum comes out of nothing."""
    return Anchors(gap.ax + gap.x, gap.ay + gap.y, gap.bx, gap.by)


@inlined_kernel
def swept_rods(v: Floats, of: BlockBodies, soft: SoftJoint) -> PairVelocity:
    """The velocities after a sweep over a block of rods and springs with lanes `v`, whose impulses it changes."""
    u = of.gathered.velocity
    gap = gap_of(v, of.pose)
    masses = block_masses(v)
    length, x, y = length_and_direction(gap.x, gap.y, 1.0)
    store(v, nl.AXIS_X, x)
    store(v, nl.AXIS_Y, y)
    j = along(gap.ax, gap.ay, gap.bx, gap.by, gap.x, gap.y, x, y)
    stiffness = own_stiffness(masses.mass_a, masses.inertia_a, masses.mass_b, masses.inertia_b, j)
    speed = j[0] * u.ax + j[1] * u.ay + j[2] * u.aw + j[3] * u.bx + j[4] * u.by + j[5] * u.bw
    hertz = load(v, nl.HERTZ)
    impulse = load(v, nl.IMPULSE)
    row = Row(length - load(v, nl.LENGTH), stiffness, speed, impulse)
    mobility = spring_mobility(masses.mass_a + masses.mass_b, stiffness, hertz, soft.seconds)
    spring = Spring(hertz >= 0.0, hertz, load(v, nl.DAMPING_RATIO), mobility)
    change = row_change(row, spring, soft, soft.most)
    store(v, nl.IMPULSE, impulse + change)
    return apply_impulse(u, masses, _pushed_at(gap), change * x, change * y)


@kernel
def report_rod(v: Floats, k: int, joint: Records, share: float) -> tuple[float, float]:
    """Write the impulse of lane `k` into the joint table; returns those of the step (N s)."""
    impulse = v[nl.IMPULSE + k]
    if joint.spring == 1:
        joint.impulse_3 = impulse / share
    else:
        joint.impulse_0 = impulse / share
    return v[nl.TOTAL_X + k] + impulse * v[nl.AXIS_X + k], v[nl.TOTAL_Y + k] + impulse * v[nl.AXIS_Y + k]

"""One lane of a block as the values of `law`: what the loops over lanes read and write."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.law import Anchors, PairMass, PairVelocity
from sandbox.tables import Floats, Records


@inlined_kernel
def is_solved_singly(block: Records) -> bool:
    """Whether the lanes of a block are solved one by one: they may share bodies, or are too few for a vector.

    The outcome of those that share none is the same either way.
    """
    return bool(block.serial == 1 or block.count < cb.ENOUGH)


@inlined_kernel
def lane_velocity(g: Floats, k: int) -> PairVelocity:
    """The gathered velocities of lane k."""
    return PairVelocity(
        g[cb.VELOCITY_AX + k],
        g[cb.VELOCITY_AY + k],
        g[cb.ANGULAR_A + k],
        g[cb.VELOCITY_BX + k],
        g[cb.VELOCITY_BY + k],
        g[cb.ANGULAR_B + k],
    )


@inlined_kernel
def set_lane_velocity(g: Floats, k: int, v: PairVelocity) -> None:
    """Write the velocities of lane k."""
    g[cb.VELOCITY_AX + k] = v.ax
    g[cb.VELOCITY_AY + k] = v.ay
    g[cb.ANGULAR_A + k] = v.aw
    g[cb.VELOCITY_BX + k] = v.bx
    g[cb.VELOCITY_BY + k] = v.by
    g[cb.ANGULAR_B + k] = v.bw


@inlined_kernel
def lane_mass(v: Floats, k: int) -> PairMass:
    """The inverse masses of lane k."""
    return PairMass(
        v[cb.INVERSE_MASS_A + k], v[cb.INVERSE_INERTIA_A + k], v[cb.INVERSE_MASS_B + k], v[cb.INVERSE_INERTIA_B + k]
    )


@inlined_kernel
def lane_anchors(v: Floats, point: int, k: int) -> Anchors:
    """The anchors of `POINT_1` or `POINT_2` of lane k."""
    return Anchors(
        v[point + cb.ANCHOR_AX + k],
        v[point + cb.ANCHOR_AY + k],
        v[point + cb.ANCHOR_BX + k],
        v[point + cb.ANCHOR_BY + k],
    )

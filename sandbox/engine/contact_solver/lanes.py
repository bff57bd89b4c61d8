"""The lanes of a block as the values of `law`: of one contact, or of all four side by side."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox._vectors import Mask, Vector, lane_numbers, load, select, store
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.law import Anchors, PairMass, PointImpulses
from sandbox.tables import Floats


@inlined_kernel
def lane_anchors(v: Floats, point: int, k: int) -> Anchors:
    """The anchors of `POINT_1` or `POINT_2` of lane k."""
    return Anchors(
        v[point + cb.ANCHOR_AX + k],
        v[point + cb.ANCHOR_AY + k],
        v[point + cb.ANCHOR_BX + k],
        v[point + cb.ANCHOR_BY + k],
    )


@inlined_kernel
def load_anchors(v: Floats, point: int) -> Anchors:
    """The anchors of `POINT_1` or `POINT_2` of a block that begins at `v`."""
    return Anchors(
        load(v, point + cb.ANCHOR_AX),
        load(v, point + cb.ANCHOR_AY),
        load(v, point + cb.ANCHOR_BX),
        load(v, point + cb.ANCHOR_BY),
    )


@inlined_kernel
def load_masses(v: Floats) -> PairMass:
    """The inverse masses of a block."""
    return PairMass(
        load(v, cb.INVERSE_MASS_A),
        load(v, cb.INVERSE_INERTIA_A),
        load(v, cb.INVERSE_MASS_B),
        load(v, cb.INVERSE_INERTIA_B),
    )


@inlined_kernel
def load_normal_impulses(v: Floats) -> PointImpulses:
    """The accumulated normal impulses (N s) of a block."""
    return PointImpulses(load(v, cb.POINT_1 + cb.NORMAL_IMPULSE), load(v, cb.POINT_2 + cb.NORMAL_IMPULSE))


@inlined_kernel
def lanes_between(first: int, end: int) -> Mask:
    """True in the lanes first..end-1."""
    numbers = lane_numbers()
    return (numbers >= float(first)) & (numbers < float(end))


@inlined_kernel
def store_lanes(v: Floats, field: int, lanes: Mask, one: Vector, other: Vector) -> None:
    """Write a field of a block: `one` in those lanes, `other` elsewhere."""
    store(v, field, select(lanes, one, other))

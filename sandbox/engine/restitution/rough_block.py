"""Friction within a blow at both points of a contact: it turns the bodies, and so changes how the points share a load.

The slip is the same at both, as their tangents are on one line. The blow goes through as one at a point does
(`rough_blow.py`): a piece in which the contact slides, and one in which it sticks, or slides back where friction cannot
hold it. In each piece the loads are those that change the speeds at both points in the ratio that restitution asks
for, with the torque of the friction in them, so that what lands flat leaves flat. Restitution multiplies the load at
which the points no longer close, on the mean by what they bear; it ends where no more work is left for it.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import PairMass, PairVelocity, anchors_of, levers_of
from sandbox.engine.restitution.blow_work import share_within
from sandbox.engine.restitution.impulses import Rub, slip_speed
from sandbox.engine.restitution.two_point_block import Block, block_of
from sandbox.tables import Records

_SINGULAR = 1e-9


class RoughLoads(NamedTuple):
    """Normal impulses at both points, and the tangent impulse, N s."""

    first: float
    second: float
    drag: float


class RoughMatrix(NamedTuple):
    """What 1 N s along the normal at both points and along the tangent changes the speeds along these, 1/kg."""

    k11: float
    k12: float
    k22: float
    k1t: float
    k2t: float
    ktt: float


class _Speeds(NamedTuple):
    """Speeds (m/s) at which both points open, and at which the contact slides."""

    opening1: float
    opening2: float
    slip: float


class _Piece(NamedTuple):
    """The impulses (N s) of a piece, and what they change the speeds (m/s) at both points and the slip."""

    load1: float
    load2: float
    drag: float
    change1: float
    change2: float
    slip: float


@inlined_kernel
def rough_matrix(contact: Records, mass: PairMass, rub: Rub) -> RoughMatrix:
    """The matrix of a contact of two points."""
    block: Block = block_of(contact, mass)
    n1 = levers_of(anchors_of(contact, 1), contact.normal_x, contact.normal_y)
    n2 = levers_of(anchors_of(contact, 2), contact.normal_x, contact.normal_y)
    t = levers_of(rub.anchors, rub.tangent_x, rub.tangent_y)
    k1t = mass.inertia_a * (n1.a * t.a) + mass.inertia_b * (n1.b * t.b)
    k2t = mass.inertia_a * (n2.a * t.a) + mass.inertia_b * (n2.b * t.b)
    return RoughMatrix(block.k11, block.k12, block.k22, k1t, k2t, 1.0 / rub.mass)


@kernel
def rough_loads(
    start: PairVelocity, contact: Records, rub: Rub, k: RoughMatrix, change1: float, change2: float
) -> RoughLoads:
    """The blow that is to change the speeds at both points of a contact so much (m/s). What only one point bears while
    it slides, as friction turns it over that, both may bear once it no longer does."""
    friction = contact.friction
    slip = slip_speed(start, rub) - contact.surface_speed
    if slip == 0.0:
        first = _after_sliding(k, friction, change1, change2)
    else:
        first = _slide(k, -friction if slip > 0.0 else friction, change1, change2)
    load = first.load1 + first.load2
    closing1 = -opening_speed(start, contact, 1)
    closing2 = -opening_speed(start, contact, 2)
    closing = first.load1 * closing1 + first.load2 * closing2
    if load <= 0.0 or closing <= 0.0:
        return RoughLoads(first.load1, first.load2, first.drag)
    share = -slip / first.slip if slip * (slip + first.slip) < 0.0 else 1.0
    speeds = _Speeds(-closing1, -closing2, slip)
    turned = _after(speeds, first, share)
    after = _after_sliding(k, friction, change1 - share * first.change1, change2 - share * first.change2)
    left = after.load1 + after.load2
    stop = closing / (first.load1 * first.change1 + first.load2 * first.change2)
    stopped = stop * load
    lowest = _work(speeds, first, stop)
    if stop > share:
        closing = -after.load1 * turned.opening1 - after.load2 * turned.opening2
        changed = after.load1 * after.change1 + after.load2 * after.change2
        part = closing / changed if closing < changed else 1.0
        stopped = share * load + part * left
        lowest = _work(speeds, first, share) + _work(turned, after, part)
    restitution = 1.0 / stop - 1.0
    most = (1.0 - restitution * restitution) * lowest
    total = stopped / stop
    part = 0.0
    if share == 1.0 or total <= share * load:
        share = _within(speeds, first, total / load, most)
    elif left > 0.0:
        part = _within(turned, after, (total - share * load) / left, most - _work(speeds, first, share))
    return RoughLoads(
        share * first.load1 + part * after.load1,
        share * first.load2 + part * after.load2,
        share * first.drag + part * after.drag,
    )


@inlined_kernel
def _after(speeds: _Speeds, piece: _Piece, share: float) -> _Speeds:
    """The speeds after a share of a piece."""
    return _Speeds(
        speeds.opening1 + share * piece.change1,
        speeds.opening2 + share * piece.change2,
        speeds.slip + share * piece.slip,
    )


@inlined_kernel
def _power(speeds: _Speeds, piece: _Piece) -> float:
    """The work (J) of a piece, if speeds stayed as they are."""
    return piece.load1 * speeds.opening1 + piece.load2 * speeds.opening2 + piece.drag * speeds.slip


@inlined_kernel
def _slowing(piece: _Piece) -> float:
    """The work (J) of a piece by the change of speeds that it brings."""
    return 0.5 * (piece.load1 * piece.change1 + piece.load2 * piece.change2 + piece.drag * piece.slip)


@inlined_kernel
def _work(speeds: _Speeds, piece: _Piece, share: float) -> float:
    """The work (J) of a share of a piece."""
    return share * (_power(speeds, piece) + share * _slowing(piece))


@inlined_kernel
def _within(speeds: _Speeds, piece: _Piece, share: float, most: float) -> float:
    """A share of a piece, or the one up to which it does no more work (J) than `most`."""
    return share_within(share, _power(speeds, piece), _slowing(piece), most)


@kernel
def _after_sliding(k: RoughMatrix, friction: float, change1: float, change2: float) -> _Piece:
    """The contact sticks where friction is enough for that; else it slides where the blow drives it."""
    m12 = k.k12 - k.k1t * k.k2t / k.ktt
    load1, load2 = _bearing(k.k11 - k.k1t * k.k1t / k.ktt, m12, m12, k.k22 - k.k2t * k.k2t / k.ktt, change1, change2)
    driven = k.k1t * load1 + k.k2t * load2
    if abs(driven) > friction * k.ktt * (load1 + load2):
        return _slide(k, -friction if driven > 0.0 else friction, change1, change2)
    return _piece(k, load1, load2, -driven / k.ktt)


@kernel
def _slide(k: RoughMatrix, rate: float, change1: float, change2: float) -> _Piece:
    """A piece with the tangent impulse `rate` for each N s of load."""
    load1, load2 = _bearing(
        k.k11 + rate * k.k1t, k.k12 + rate * k.k1t, k.k12 + rate * k.k2t, k.k22 + rate * k.k2t, change1, change2
    )
    return _piece(k, load1, load2, rate * (load1 + load2))


@inlined_kernel
def _piece(k: RoughMatrix, load1: float, load2: float, drag: float) -> _Piece:
    change1 = k.k11 * load1 + k.k12 * load2 + k.k1t * drag
    change2 = k.k12 * load1 + k.k22 * load2 + k.k2t * drag
    return _Piece(load1, load2, drag, change1, change2, k.k1t * load1 + k.k2t * load2 + k.ktt * drag)


@kernel
def _bearing(m11: float, m12: float, m21: float, m22: float, change1: float, change2: float) -> tuple[float, float]:
    """The loads (N s) of which none pulls and that change both speeds by as much or more, by trying who bears; none if
    nobody can, as where friction makes a corner jam."""
    determinant = m11 * m22 - m12 * m21
    if determinant > _SINGULAR * abs(m11 * m22):
        load1 = (m22 * change1 - m12 * change2) / determinant
        load2 = (m11 * change2 - m21 * change1) / determinant
        if load1 >= 0.0 and load2 >= 0.0:
            return load1, load2
    if m11 > 0.0 and change1 > 0.0 and m21 * change1 >= m11 * change2:
        return change1 / m11, 0.0
    if m22 > 0.0 and change2 > 0.0 and m12 * change2 >= m22 * change1:
        return 0.0, change2 / m22
    return 0.0, 0.0

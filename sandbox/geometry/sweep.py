"""When two convex cores that move and turn along a straight way come into each other."""

from __future__ import annotations

import math

from sandbox._jit import ZERO, kernel
from sandbox.geometry.manifold import collide_cores
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Field, Records, Table

SWEEP = Table(
    "sweep",
    (
        Field("x", "m", "centre of b from the centre of a at time 0"),
        Field("y", "m", "centre of b from the centre of a at time 0"),
        Field("way_x", "m", "way of b against a until time 1"),
        Field("way_y", "m", "way of b against a until time 1"),
        Field("angle_a", "rad", "turn of the given core of a at time 0"),
        Field("angle_b", "rad", "turn of the given core of b at time 0"),
        Field("turn_a", "rad", "turn of a until time 1"),
        Field("turn_b", "rad", "turn of b until time 1"),
        Field("deep", "m", "overlap that is let pass"),
        Field("creep", "1", "share of that by which an overlap as deep as that may grow on the way"),
        Field("thin", "m", "half widths of both cores together: past that overlap they part on the other side"),
        Field("normal_x", "1", "answer: axis of the hit from a to b"),
        Field("normal_y", "1", "answer: axis of the hit from a to b"),
        Field("point_x", "m", "answer: deepest point of the hit, from the centre of a"),
        Field("point_y", "m", "answer: deepest point of the hit, from the centre of a"),
        Field("touched", "-", "answer: 1 if they have touched from the start of the way on", "i8"),
    ),
)
"""One question to `time_of_hit`: the ways of a pair. Times are shares of the way, 0 to 1."""

SWEPT_ROWS = 128
_FAR = 1e200
_TURNS = 4096
_SOUND = 0.75
"""Up to this share of `thin` overlaps may come so, by ever less the nearer they are to it."""
_LEAST_ROOM = 1e-4
"""Past that they may still grow by so little: a way that leads out again needs strides of some length."""
_NEAR = 0.1
"""A hit is told when the overlap comes this near to what is let pass, as a share of it."""
_TOUCHES = 2.0 * _NEAR
"""Cores nearer than this share of what is let pass touch already: a way is made to end within half of it."""


@kernel
def time_of_hit(
    cores: Records,
    a: int,
    a_count: int,
    a_radius: float,
    b: int,
    b_count: int,
    b_radius: float,
    sweep: Records,
    swept: Records,
    out: Records,
) -> float:
    """Time (0..1) at which two cores touch, on a way that leads them deeper than `deep` into each other; else -1.

    Conservative advancement (B. Mirtich 1996) on the signed separation of the test: along a fixed axis it shrinks no
    faster than the way along it and the rims of the turning cores, so nothing is missed; and as overlaps up to
    `deep` are let pass, every stride has a least length. Cores that overlap more than that from the start go hardly
    deeper. Cores that touch from the start go as far as the hit itself: back at the touch, the next step would find
    them as this one did, and they would never get on. Out of strides, the cores count as touching: safe, and it costs
    no more than the rest of a step. `swept` (`SWEPT_ROWS` vertices) and `out` (a `MANIFOLD` row) are scratch.
    """
    s = sweep[0]
    rims = abs(s.turn_a) * _rim(cores, a, a_count) + abs(s.turn_b) * _rim(cores, b, b_count)
    deep = s.deep
    near = _NEAR * deep
    t = 0.0
    clear = -1.0
    for _stride in range(_TURNS):
        _pose(cores, a, a_count, b, b_count, s, t, swept)
        gap = _gap(swept, a_count, a_radius, b_count, b_radius, s, t, out)
        m = out[0]
        if t == 0.0 and gap <= -deep + near:
            deep = _let_pass(s, -gap)
            near = 0.5 * (gap + deep)
        if gap <= -deep + near:
            break
        if gap > _TOUCHES * s.deep:
            clear = t
        closing = rims - (s.way_x * m.normal_x + s.way_y * m.normal_y)
        if closing <= 0.0:
            return -1.0
        t = t + (gap + deep) / closing
        if t >= 1.0:
            return -1.0
    _tell(s, out[0])
    s.touched = 1 if clear < 0.0 else 0
    if clear < 0.0:
        return t
    return _first_touch(cores, a, a_count, a_radius, b, b_count, b_radius, rims, clear, s, swept, out)


@kernel
def _tell(s: Records, m: Records) -> None:
    """Answer with the axis of a manifold and the deeper of its points."""
    s.normal_x = m.normal_x
    s.normal_y = m.normal_y
    second = m.point_count == 2 and m.separation2 < m.separation1
    s.point_x = m.x2 if second else m.x1
    s.point_y = m.y2 if second else m.y1


@kernel
def _let_pass(s: Records, overlap: float) -> float:
    """How deep (m) cores may come on their way that overlap by what is let pass, or all but, from the start on.

    They never come out on the other side: every step takes only a share of what is left until then.
    """
    room = _SOUND * s.thin - overlap
    room = room if room < s.deep else s.deep
    room = room if room > _LEAST_ROOM * s.deep else _LEAST_ROOM * s.deep
    deep = overlap + s.creep * room
    return float(deep if deep > s.deep else s.deep)


@kernel
def _first_touch(
    cores: Records,
    a: int,
    a_count: int,
    a_radius: float,
    b: int,
    b_count: int,
    b_radius: float,
    rims: float,
    t: float,
    s: Records,
    swept: Records,
    out: Records,
) -> float:
    """Time after `t`, when the cores are apart, at which they all but touch."""
    for _stride in range(_TURNS):
        _pose(cores, a, a_count, b, b_count, s, t, swept)
        gap = _gap(swept, a_count, a_radius, b_count, b_radius, s, t, out)
        m = out[0]
        closing = rims - (s.way_x * m.normal_x + s.way_y * m.normal_y)
        if gap <= _NEAR * s.deep or closing <= 0.0:
            return t
        t = t + (gap - 0.5 * _NEAR * s.deep) / closing
    return t


@kernel
def _rim(cores: Records, start: int, count: int) -> float:
    """Largest distance of a core's vertex from its body's centre: a radius about it moves on no rim."""
    most = 0.0
    for i in range(start, start + count):
        square = cores[i].x * cores[i].x + cores[i].y * cores[i].y
        most = square if square > most else most
    return math.sqrt(most)


@kernel
def _pose(cores: Records, a: int, a_count: int, b: int, b_count: int, s: Records, t: float, swept: Records) -> None:
    """Turn both cores to time t: a into `swept[0:]`, b into its second half. What does not turn stays as at time 0."""
    if t == 0.0 or s.turn_a != 0.0:
        _turn(cores, a, a_count, s.angle_a + t * s.turn_a, swept, ZERO)
    if t == 0.0 or s.turn_b != 0.0:
        _turn(cores, b, b_count, s.angle_b + t * s.turn_b, swept, ZERO + SWEPT_ROWS // 2)


@kernel
def _turn(cores: Records, start: int, count: int, angle: float, target: Records, at: int) -> None:
    c, s = cos_sin(angle)
    for i in range(count):
        source = cores[start + i]
        row = target[at + i]
        row.x = c * source.x - s * source.y
        row.y = s * source.x + c * source.y
        row.normal_x = c * source.normal_x - s * source.normal_y
        row.normal_y = s * source.normal_x + c * source.normal_y


@kernel
def _gap(
    swept: Records, a_count: int, a_radius: float, b_count: int, b_radius: float, s: Records, t: float, out: Records
) -> float:
    """Signed separation (m) at time t; its axis is in `out`."""
    x = s.x + t * s.way_x
    y = s.y + t * s.way_y
    half = ZERO + SWEPT_ROWS // 2
    collide_cores(swept, ZERO, a_count, a_radius, half, b_count, b_radius, x, y, _FAR, 0.0, out)
    gap: float = out[0].separation
    return gap

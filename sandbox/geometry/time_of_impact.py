"""When two convex cores that move and turn evenly come into each other: the time of impact of continuous collision."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.geometry.closest_features import closest_features
from sandbox.geometry.core import CoreRows
from sandbox.geometry.manifold import collide_cores
from sandbox.geometry.swept_circles import pass_by
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Field, Records, Table

SWEEP = Table(
    "sweep",
    (
        Field("x", "m", "centre of b from the centre of a at time 0"),
        Field("y", "m", "centre of b from the centre of a at time 0"),
        Field("translation_x", "m", "translation of b against a until time 1"),
        Field("translation_y", "m", "translation of b against a until time 1"),
        Field("angle_a", "rad", "turn of the given core of a at time 0"),
        Field("angle_b", "rad", "turn of the given core of b at time 0"),
        Field("rotation_a", "rad", "turn of a until time 1"),
        Field("rotation_b", "rad", "turn of b until time 1"),
        Field("deep", "m", "overlap that is let pass"),
        Field("thin", "m", "half widths of both cores together: past that overlap they part on the other side"),
        Field("half", "m", "half width of the one that gives way, if one of them does: so deep lies its middle"),
        Field("yields", "-", "1 when both are bodies that give way: their contact parts them", "i8"),
        Field("normal_x", "1", "answer: axis of the hit from a to b"),
        Field("normal_y", "1", "answer: axis of the hit from a to b"),
        Field("point_x", "m", "answer: deepest point of the hit, from the centre of a"),
        Field("point_y", "m", "answer: deepest point of the hit, from the centre of a"),
        Field("touched", "-", "answer: 1 if they have touched from the start on", "i8"),
    ),
)
"""One question to `time_of_impact`: how a pair moves. Times are shares of the motion, 0 to 1."""

POSED_ROWS = 128
"""Vertices of both cores as they lie at one time: a's first, b's from the middle on."""
_FAR = 1e200
_END = 1.0 - 1e-9
"""A hit from then on is at the end of the motion but for rounding, as of what was stopped there before."""
_STRIDES = 4096
_CREEP = 0.02
"""Share of what is let pass by which overlaps as deep as that may grow: a surface slid along is not quite even."""
_GROWTH = 0.05
"""Share of themselves by which overlaps with something immovable may grow, and of what is left until the middle of the
one that gives way."""
_SOUND = 0.75
"""Up to this share of `thin` overlaps may come so, by ever less the nearer they are to it."""
_YIELD = 0.5
"""Share of what is left until then by which overlaps of two that give way may grow."""
_LEAST_ROOM = 1e-4
"""Past that they may still grow by so little: a motion that leads out again needs strides of some length."""
_NEAR = 0.1
"""A hit is told when the overlap comes this near to what is let pass, as a share of it."""
_TOUCHES = 2.0 * _NEAR
"""Cores nearer than this share of what is let pass touch already: a motion is made to end within half of it."""


@kernel
def time_of_impact(cores: Records, a: CoreRows, b: CoreRows, sweep: Records, posed: Records, out: Records) -> float:
    """Time (0..1) at which two cores touch, on a motion that leads them deeper than `deep` into each other; else -1.

    Conservative advancement (B. Mirtich 1996) on the signed separation of the test: along a fixed axis it shrinks no
    faster than the translation along it and the rims of the turning cores, so nothing is missed; and as overlaps up to
    `deep` are let pass, every stride has a least length. Cores that overlap more than that from the start go hardly
    deeper; where both give way, those that touch go so deep that their contact sees it. Cores that touch from the start
    go as far as the hit itself: back at the touch, the next step would find them as this one did, and they would never
    get on. Out of strides, the cores count as touching: safe, and it costs no more than the rest of a step. `posed`
    (`POSED_ROWS` vertices) and `out` (a `MANIFOLD` row) are scratch.
    """
    s = sweep[0]
    rim_a = _rim(cores, a)
    rim_b = _rim(cores, b)
    if pass_by(cores, a, b, s, rim_a, rim_b):
        return -1.0
    rims = abs(s.rotation_a) * rim_a + abs(s.rotation_b) * rim_b
    deep = s.deep
    near = _NEAR * deep
    t = 0.0
    seen = 0.0
    clear = -1.0
    for _stride in range(_STRIDES):
        seen = t
        _pose(cores, a, b, s, t, posed)
        gap, nx, ny = _separation(posed, a, b, s, t)
        if t == 0.0 and gap <= (_TOUCHES * deep if s.yields == 1 else near - deep):
            deep = _let_pass(s, -gap)
            near = 0.5 * (gap + deep)
        if gap <= -deep + near:
            break
        if gap > _TOUCHES * s.deep:
            clear = t
        closing = rims - (s.translation_x * nx + s.translation_y * ny)
        if closing <= 0.0:
            return -1.0
        t = t + (gap + deep) / closing
        if t >= _END:
            return -1.0
    _answer(posed, a, b, s, seen, out)
    s.touched = 1 if clear < 0.0 else 0
    if clear < 0.0:
        return t
    return _first_touch(cores, a, b, rims, clear, s, posed)


@kernel
def _answer(posed: Records, a: CoreRows, b: CoreRows, s: Records, t: float, out: Records) -> None:
    """Answer with the axis of the cores posed at time t and the deeper of their contact points."""
    of_a, of_b = _posed(a, b)
    m = out[0]
    m.x1 = m.y1 = 0.0
    collide_cores(posed, of_a, of_b, s.x + t * s.translation_x, s.y + t * s.translation_y, _FAR, 0.0, out)
    s.normal_x = m.normal_x
    s.normal_y = m.normal_y
    second = m.point_count == 2 and m.separation2 < m.separation1
    s.point_x = m.x2 if second else m.x1
    s.point_y = m.y2 if second else m.y1


@kernel
def _let_pass(s: Records, overlap: float) -> float:
    """How deep (m) cores may come as they move that overlap by what is let pass, or all but, from the start on, or that
    touch and give way.

    They never come out on the other side: every step takes only a share of what is left until then. Who gives way needs
    a large one, as what is rolled back to where it was keeps its velocity, finds the others so again, and hangs there;
    and what has come too deep all the same is let go. What goes on pressing on something immovable sinks faster and
    faster, until the spring of its contact bears the load: while it is held here, that spring gives way in vain, and
    what presses it on is squeezed into it instead. A blow is over before.
    """
    room = _SOUND * s.thin - overlap
    if s.yields == 1:
        deep = overlap + _YIELD * room if room > 0.0 else _FAR
    else:
        room = room if room < s.deep else s.deep
        room = room if room > _LEAST_ROOM * s.deep else _LEAST_ROOM * s.deep
        creep = _CREEP * room
        left = s.half - overlap
        growth = _GROWTH * (left if left < overlap else overlap)
        deep = overlap + (growth if growth > creep else creep)
    return float(deep if deep > s.deep else s.deep)


@kernel
def _first_touch(cores: Records, a: CoreRows, b: CoreRows, rims: float, t: float, s: Records, posed: Records) -> float:
    """Time after `t`, when the cores are apart, at which they all but touch."""
    for _stride in range(_STRIDES):
        _pose(cores, a, b, s, t, posed)
        gap, nx, ny = _separation(posed, a, b, s, t)
        closing = rims - (s.translation_x * nx + s.translation_y * ny)
        if gap <= _NEAR * s.deep or closing <= 0.0:
            return t
        t = t + (gap - 0.5 * _NEAR * s.deep) / closing
    return t


@kernel
def _rim(cores: Records, core: CoreRows) -> float:
    """Largest distance of a core's vertex from its body's centre: a radius about it moves on no rim."""
    most = 0.0
    for i in range(core.start, core.start + core.vertex_count):
        square = cores[i].x * cores[i].x + cores[i].y * cores[i].y
        most = square if square > most else most
    return math.sqrt(most)


@kernel
def _pose(cores: Records, a: CoreRows, b: CoreRows, s: Records, t: float, posed: Records) -> None:
    """Turn both cores to time t: a into `posed[0:]`, b into its second half. What does not turn stays as at time 0."""
    if t == 0.0 or s.rotation_a != 0.0:
        _turn(cores, a, s.angle_a + t * s.rotation_a, posed, 0)
    if t == 0.0 or s.rotation_b != 0.0:
        _turn(cores, b, s.angle_b + t * s.rotation_b, posed, POSED_ROWS // 2)


@kernel
def _turn(cores: Records, core: CoreRows, angle: float, target: Records, at: int) -> None:
    c, s = cos_sin(angle)
    for i in range(core.vertex_count):
        source = cores[core.start + i]
        row = target[at + i]
        row.x = c * source.x - s * source.y
        row.y = s * source.x + c * source.y
        row.normal_x = c * source.normal_x - s * source.normal_y
        row.normal_y = s * source.normal_x + c * source.normal_y


@kernel
def _posed(a: CoreRows, b: CoreRows) -> tuple[CoreRows, CoreRows]:
    """Both cores as they lie in `posed`."""
    return CoreRows(0, a.vertex_count, a.radius), CoreRows(POSED_ROWS // 2, b.vertex_count, b.radius)


@kernel
def _separation(posed: Records, a: CoreRows, b: CoreRows, s: Records, t: float) -> tuple[float, float, float]:
    """(signed separation in metres, its unit axis x, y from a to b) of the cores posed at time t."""
    of_a, of_b = _posed(a, b)
    found = closest_features(posed, of_a, of_b, s.x + t * s.translation_x, s.y + t * s.translation_y, _FAR, 0.0)
    return found.separation, found.normal_x, found.normal_y

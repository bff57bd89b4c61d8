"""The laws of joints: arithmetic that holds for one joint and, lane by lane, for four of them.

A number is a float or a vector, see `_vectors`; only `select` chooses, as lanes may differ.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox._vectors import Number, absolute, root, select
from sandbox.geometry.trig import PI

INFINITE = 1e300
COMPLIANCE = 1e-4
"""How far rigid rows give way, as a share of how far their members do: ropes that are drawn straight stay solvable."""
IMPACT_COMPLIANCE = 1e-8
"""The same in an impact, which happens once: 1e-4 would take as much of its energy."""
CORRECTION_SPEED = 4.0
"""Fastest recovery of what a joint keeps, after something else has pulled it apart, in m/s or rad/s."""
FOLLOWED = 0.25
"""Oscillations in the time for which a spring acts that can be followed where bodies turn out of its way."""
_SHORT = 1e-9

Pair = tuple[Number, Number]
Jacobian = tuple[Number, Number, Number, Number, Number, Number]
"""What a row does at both bodies: x, y and turn of the first, then of the second."""


@inlined_kernel
def turned(c: Number, s: Number, x: Number, y: Number) -> Pair:
    """(x, y) turned by an angle with that cosine and sine."""
    return c * x - s * y, s * x + c * y


@inlined_kernel
def gap(center_a: Number, center_b: Number, way_a: Number, way_b: Number, arm_a: Number, arm_b: Number) -> Number:
    """From anchor a to anchor b. Large numbers first: nearby bodies keep their precision far from the origin."""
    return (center_b - center_a) + (way_b - way_a) + (arm_b - arm_a)


@inlined_kernel
def rope(wheel: Number, center: Number, way: Number, arm: Number) -> Number:
    """From the wheel of a pulley to the anchor."""
    return (center - wheel) + way + arm


@inlined_kernel
def length_and_direction(x: Number, y: Number, otherwise: float) -> tuple[Number, Number, Number]:
    """Length and unit vector of (x, y); what is too short to have a direction points along (`otherwise`, 0)."""
    length = root(x * x + y * y)
    divisor = select(length > _SHORT, length, 1.0)
    return length, select(length > _SHORT, x / divisor, otherwise), select(length > _SHORT, y / divisor, 0.0)


@inlined_kernel
def is_close(arm_ax: Number, arm_ay: Number, arm_bx: Number, arm_by: Number, gap_x: Number, gap_y: Number) -> Number:
    """Whether the anchors are together but for half of the longer arm."""
    arm_a = arm_ax * arm_ax + arm_ay * arm_ay
    arm_b = arm_bx * arm_bx + arm_by * arm_by
    return gap_x * gap_x + gap_y * gap_y < 0.25 * select(arm_a > arm_b, arm_a, arm_b)


@inlined_kernel
def along(
    arm_ax: Number, arm_ay: Number, arm_bx: Number, arm_by: Number, gap_x: Number, gap_y: Number, x: Number, y: Number
) -> Jacobian:
    """Way of anchor b along an axis (x, y) that turns with a.

    Both bodies are pushed at anchor b, also while the anchors are apart: no angular momentum comes out of nothing.
    """
    turn_a = (arm_ax + gap_x) * y - (arm_ay + gap_y) * x
    return -x, -y, -turn_a, x, y, arm_bx * y - arm_by * x


@inlined_kernel
def own_stiffness(mass_a: Number, inertia_a: Number, mass_b: Number, inertia_b: Number, j: Jacobian) -> Number:
    """J M^-1 J^T of a row with two bodies; all masses are inverse ones."""
    found = mass_a * (j[0] * j[0] + j[1] * j[1]) + inertia_a * j[2] * j[2]
    return found + mass_b * (j[3] * j[3] + j[4] * j[4]) + inertia_b * j[5] * j[5]


@inlined_kernel
def spring_mobility(straight: Number, stiffness: Number, hertz: Number, acting: Number) -> Number:
    """What a spring along a line swings with its frequency, 1/kg: `straight`, 1 / the reduced mass of its bodies.

    How far bodies turn out of its way depends on where it pulls: `stiffness`, J M^-1 J^T or its greatest for a point.
    Were that what it swings, it would be as stiff as its direction says, would pull beside the gap between two points,
    and would give back other energies than it has taken. But it swings faster for their turning, and where the time
    `acting` (s) could not follow that any more, it is softer.
    """
    share = hertz * acting / FOLLOWED
    share = select(share < 1.0, share, 1.0)
    followed = share * share * stiffness
    return select(followed > straight, followed, straight)


@inlined_kernel
def spring_law(
    rest: Number, hertz: Number, ratio: Number, mobility: Number, acting: Number, ahead: Number = 1.0
) -> Pair:
    """(bias, softness) of a spring that is so far from rest, and whose force is that of where it will be after the time
    `acting` (s), or after a share `ahead` of it. `hertz` is what it swings a mobility (1/kg or 1/(kg m^2)) with."""
    omega = 2.0 * PI * hertz
    lag = 2.0 * ratio + ahead * (acting * omega)
    bias = select(lag > 0.0, omega * rest / select(lag > 0.0, lag, 1.0), 0.0)
    divisor = acting * omega * lag
    softness = select(divisor > 0.0, mobility / select(divisor > 0.0, divisor, 1.0), INFINITE)
    return bias, softness


@inlined_kernel
def drive(
    limited_by_stops: bool,
    lower: Number,
    upper: Number,
    stop: Number,
    aim: Number,
    most: Number,
    speed: Number,
    slowest: Number,
    fastest: Number,
    total: Number,
) -> tuple[Number, Number, Number, Number]:
    """(low, high, bias, stop) of a motor that strives for the speed `aim` with an impulse of `most` at most; limits add
    what is lacking.

    `slowest` and `fastest` are the speeds that just reach the lower and the upper limit, `total` the impulse so far.
    """
    low = -most
    high = most
    if limited_by_stops:
        locked = lower >= upper
        found = find_stop(stop, aim, most, speed, slowest, fastest, total)
        low = select(found > 0.0, select(aim < slowest, -most, most), select(found < 0.0, -INFINITE, -most))
        high = select(found > 0.0, INFINITE, select(found < 0.0, select(aim > fastest, most, -most), most))
        aim = select(found > 0.0, slowest, select(found < 0.0, fastest, aim))
        low = select(locked, -INFINITE, low)
        high = select(locked, INFINITE, high)
        aim = select(locked, slowest, aim)
        stop = select(locked, stop, found)
    return low, high, -aim, stop


@inlined_kernel
def find_stop(
    stop: Number, aim: Number, most: Number, speed: Number, slowest: Number, fastest: Number, total: Number
) -> Number:
    """Which limit has a say: 1 the lower, -1 the upper, 0 none. One lets go once the motor alone would do.

    One that did may have been taken away since, or what gave its impulse may have been the motor: there is none to hold
    where no speed reaches it.
    """
    upper = select(aim > fastest, -1.0, select(speed > fastest, select(total <= -most, -1.0, 0.0), 0.0))
    lower = select(aim < slowest, 1.0, select(speed < slowest, select(total >= most, 1.0, upper), upper))
    alone = select(aim > fastest, most, -most)
    held_above = select((stop < 0.0) & (fastest < INFINITE), select(total < alone, -1.0, lower), lower)
    alone = select(aim < slowest, -most, most)
    return select((stop > 0.0) & (slowest > -INFINITE), select(total > alone, 1.0, held_above), held_above)


@inlined_kernel
def limited(error: Number, most: float) -> Number:
    """What is left of an error of which so much at most is taken back: nothing, unless it is large."""
    return select(error > most, error - most, select(error < -most, error + most, 0.0))


@inlined_kernel
def share_within(error: Number, most: float) -> Number:
    """The share of an error that is pushed back where no more than `most` is.

    A soft joint grows stiffer by it, so that it gives way no further than the same spring would.
    """
    cut = absolute(error) > most
    return select(cut, most / select(cut, absolute(error), 1.0), 1.0)


@inlined_kernel
def overrun(place: Number, lower: Number, upper: Number) -> Number:
    """Signed distance to the limit that has been passed; 0 between the limits."""
    over = place - upper
    under = place - lower
    return select(over > 0.0, over, select(under < 0.0, under, 0.0))


@inlined_kernel
def without_yield(error: Number, yielded: Number) -> Number:
    """An error less what its row yields, which is part of it; an impulse that was an impact says nothing about it."""
    size = absolute(error)
    share = select(error > 0.0, yielded, -yielded)
    share = select(share > 0.0, share, 0.0)
    left = select(share < size, size - share, 0.0)
    return select(error > 0.0, left, -left)

"""Sine, cosine and arc tangent from + - * / alone, so that every machine gives the same bits.

libm differs between systems in the last bit, which is enough to part two replays. The polynomials are minimax
fits on a reduced range; errors are below 2e-16 relative to 1 for angles up to 1e6 rad.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Number, Vector, absolute, any_lane, lanes, spread, transpose

PI = 3.141592653589793
NEAR_ZERO = 0.75
"""Angles (rad) up to this need no reduction."""
_HALF_PI_HIGH = 1.5707963267341256
_HALF_PI_MIDDLE = 6.077100506303966e-11
_HALF_PI_LOW = 2.0222662487959506e-21
_TWO_OVER_PI = 0.6366197723675814
_TAN_PI_8 = 0.41421356237309503


@inlined_kernel
def cos_sin_near_zero(x: Number) -> tuple[Number, Number]:
    """(cosine, sine) of an angle of up to `NEAR_ZERO` rad, or of one in each lane of a vector: the polynomials of
    fdlibm's `__kernel_cos` and `__kernel_sin`."""
    z = x * x
    tail = -2.50507602534068634195e-08 + z * 1.58969099521155010221e-10
    tail = 2.75573137070700676789e-06 + z * tail
    tail = -1.98412698298579493134e-04 + z * tail
    tail = 8.33333333332248946124e-03 + z * tail
    sine = x + x * z * (-1.66666666666666324348e-01 + z * tail)
    tail = 2.08757232129817482790e-09 - z * 1.13596475577881948265e-11
    tail = -2.75573143513906633035e-07 + z * tail
    tail = 2.48015872894767294178e-05 + z * tail
    tail = -1.38888888888741095749e-03 + z * tail
    tail = 4.16666666666666019037e-02 + z * tail
    return 1.0 - (0.5 * z - z * z * tail), sine


@kernel
def cos_sin(angle: float) -> tuple[float, float]:
    """(cosine, sine) of an angle in radians; error below 2e-16 up to 1e6 rad.

    Cody-Waite reduction to [-pi/4, pi/4], then `cos_sin_near_zero`.
    """
    x = angle
    quadrant = 0
    if angle < -NEAR_ZERO or angle > NEAR_ZERO:
        turns = math.floor(angle * _TWO_OVER_PI + 0.5)
        x = angle - turns * _HALF_PI_HIGH
        x = x - turns * _HALF_PI_MIDDLE
        x = x - turns * _HALF_PI_LOW
        quadrant = int(turns) & 3
    cosine, sine = cos_sin_near_zero(x)
    if quadrant == 0:
        return cosine, sine
    if quadrant == 1:
        return -sine, cosine
    if quadrant == 2:
        return -cosine, -sine
    return sine, -cosine


@inlined_kernel
def cos_sin_lanes(angles: Vector) -> tuple[Vector, Vector]:
    """(cosines, sines) of four angles in radians, as `cos_sin` has them."""
    if any_lane(absolute(angles) > NEAR_ZERO):
        return _one_by_one(angles)
    return cos_sin_near_zero(angles)


@kernel
def _one_by_one(angles: Vector) -> tuple[Vector, Vector]:
    first, second, third, fourth = lanes(angles)
    a, b, c, d = cos_sin(first), cos_sin(second), cos_sin(third), cos_sin(fourth)
    cosines, _, _, _ = transpose(spread(a[0]), spread(b[0]), spread(c[0]), spread(d[0]))
    sines, _, _, _ = transpose(spread(a[1]), spread(b[1]), spread(c[1]), spread(d[1]))
    return cosines, sines


@kernel
def arctan2(y: float, x: float) -> float:
    """Angle of the vector (x, y) in radians, in [-pi, pi]; 0 for the zero vector; error below 5e-16.

    Arc tangent of y / x by the rational approximation of Cephes (S. Moshier), then the quadrant.
    """
    if x == 0.0:
        if y == 0.0:
            return 0.0
        return 0.5 * PI if y > 0.0 else -0.5 * PI
    slope = y / x
    magnitude = -slope if slope < 0.0 else slope
    base = 0.0
    if magnitude > 1.0 / _TAN_PI_8:
        base = 0.5 * PI
        magnitude = -1.0 / magnitude
    elif magnitude > _TAN_PI_8:
        base = 0.25 * PI
        magnitude = (magnitude - 1.0) / (magnitude + 1.0)
    z = magnitude * magnitude
    upper = -8.750608600031904122785e-1 * z - 1.615753718733365076637e1
    upper = upper * z - 7.500855792314704667340e1
    upper = upper * z - 1.228866684490136173410e2
    upper = upper * z - 6.485021904942025371773e1
    lower = z + 2.485846490142306297962e1
    lower = lower * z + 1.650270098316988542046e2
    lower = lower * z + 4.328810604912902668951e2
    lower = lower * z + 4.853903996359136964868e2
    lower = lower * z + 1.945506571482613964425e2
    angle = base + (magnitude * (z * upper / lower) + magnitude)
    angle = -angle if slope < 0.0 else angle
    if x > 0.0:
        return angle
    return angle + PI if y >= 0.0 else angle - PI

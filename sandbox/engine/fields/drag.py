"""Drag, taken implicitly: however strong, it never throws a body back, and terminal velocities are exact.

With D the drag matrix at the velocities of now, the velocities at the end of the step solve
(M + h D) q' = M q + h (force + D medium). That is the exact way along which quadratic drag alone decays.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.tables import Records


@kernel
def drag_force(push: Records, body: Records, vx: float, vy: float, w: float, h: float) -> tuple[float, float, float]:
    """Mean drag (N, N, N m) over `h` seconds on a body that would have the velocities given at their end without it."""
    fx = push.carry_x - (push.drag_xx * vx + push.drag_xy * vy + push.drag_xw * w)
    fy = push.carry_y - (push.drag_xy * vx + push.drag_yy * vy + push.drag_yw * w)
    turn = push.carry_w - (push.drag_xw * vx + push.drag_yw * vy + push.drag_ww * w)
    a = body.mass + h * push.drag_xx
    b = h * push.drag_xy
    d = body.mass + h * push.drag_yy
    c = e = 0.0
    f = 1.0
    if body.inverse_inertia > 0.0:
        c = h * push.drag_xw
        e = h * push.drag_yw
        f = body.inertia + h * push.drag_ww
    else:
        turn = 0.0
    # Cholesky without roots (L D L^T) of the symmetric matrix [a b c; b d e; c e f].
    l1 = b / a
    l2 = c / a
    d2 = d - l1 * b
    l3 = (e - l2 * b) / d2
    d3 = f - l2 * c - l3 * l3 * d2
    y2 = fy - l1 * fx
    y3 = turn - l2 * fx - l3 * y2
    x3 = y3 / d3
    x2 = y2 / d2 - l3 * x3
    x1 = fx / a - l1 * x2 - l2 * x3
    return body.mass * x1, body.mass * x2, body.inertia * x3

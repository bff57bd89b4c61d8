"""A blow at one point, event by event: while it slides, sticks, or slides back, until restitution has had its say."""

from __future__ import annotations

import math

import numpy as np


def impulse_of(inverse: np.ndarray, velocity: np.ndarray, friction: float, restitution: float) -> np.ndarray:
    """The impulse (normal, tangent; N s) of a blow.

    `inverse` (2, 2) says what a unit impulse adds to the velocity (normal, tangent; m/s) of the point. Friction goes
    against the slip, and where there is none it holds, if it can. The normal impulse that stops the closing is given
    1 + restitution times.
    """
    v, given, end = velocity.astype(float), np.zeros(2), math.inf
    while given[0] < end:
        push = np.array([1.0, _drag(inverse, v[1], friction)])
        rate = inverse @ push
        ends = [end - given[0]]
        if end == math.inf and rate[0] > 0.0:
            ends.append(-v[0] / rate[0])
        if v[1] * rate[1] < 0.0:
            ends.append(-v[1] / rate[1])
        take = min(ends)
        v, given = v + take * rate, given + take * push
        v[np.abs(v) < 1e-12] = 0.0
        if end == math.inf and v[0] == 0.0:
            end = (1.0 + restitution) * given[0]
    return given


def _drag(inverse: np.ndarray, slip: float, friction: float) -> float:
    """Tangent impulse for each N s along the normal."""
    if slip != 0.0:
        return -friction if slip > 0.0 else friction
    hold = -inverse[1, 0] / inverse[1, 1]
    return hold if abs(hold) <= friction else math.copysign(friction, hold)

"""At which slope a box falls over."""

from __future__ import annotations

import math

from tests.flat import box, scene
from tests.physics.truth.experiment import RATE, Engine, experiment, off
from tests.physics.truth.slopes import rider, slope


def _tips(start: Engine, width: float, height: float, angle: float) -> bool:
    run = start(scene(slope(angle, friction=4.0), rider(angle, box(width, height, friction=4.0), 0.5 * height)))
    run.step(8 * RATE)
    return abs(run.angle("rider") - angle) > 0.2


@experiment("tipping angle of a box", "the angle, sizes 1:2 and 2:3", bound=1e-2)
def tipping(start: Engine) -> float:
    """It falls when its middle is no longer above its base: tan = width / height. Halved down to 1e-5 of the angle."""
    worst = 0.0
    for width, height in ((0.5, 1.0), (1.0, 1.5)):
        truth = math.atan2(width, height)
        low, high = 0.5 * truth, 1.5 * truth
        while high - low > 1e-5 * truth:
            middle = 0.5 * (low + high)
            low, high = (low, middle) if _tips(start, width, height, middle) else (middle, high)
        worst = max(worst, off(0.5 * (low + high), truth))
    return worst

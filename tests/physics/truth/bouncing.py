"""A ball that bounces on the ground."""

from __future__ import annotations

from tests.flat import body, circle, scene
from tests.physics.truth.experiment import RATE, Engine, Run, experiment, off
from tests.physics.truth.slopes import slope


def _apexes(run: Run, count: int, seconds: int = 60) -> list[float]:
    """The next `count` greatest heights; each of the parabola through the three highest places in a row."""
    found: list[float] = []
    before, last = run.place("ball")[1], run.place("ball")[1]
    for _ in range(seconds * RATE):
        run.step()
        now = run.place("ball")[1]
        if before < last >= now:
            bend = before - 2.0 * last + now
            found.append(last - (now - before) ** 2 / (8.0 * bend) - 0.5)
            if len(found) == count:
                break
        before, last = last, now
    return found


def _bounces(start: Engine, e: float, drop: float, count: int) -> float:
    ball = body("ball", circle(0.5, restitution=e), position=(0.0, 0.5 + drop))
    heights = _apexes(start(scene(slope(0.0, restitution=e), ball)), count)
    wanted = [drop * e ** (2 * k) for k in range(1, count + 1)]
    # A ball that stopped bouncing has no height where one was wanted.
    heights += [0.0] * (count - len(heights))
    return max(off(height, truth) for height, truth in zip(heights, wanted, strict=True))


@experiment("bounces with restitution 0.5 and 0.8", "heights of the next 3 and 6", bound=1e-12)
def series(start: Engine) -> float:
    return max(_bounces(start, 0.5, 3.0, 3), _bounces(start, 0.8, 2.0, 6))


@experiment("bounces with restitution 1", "heights of the next 20", bound=1e-12)
def perfect(start: Engine) -> float:
    return max(_bounces(start, 1.0, drop, 20) for drop in (0.31, 1.0, 5.0))

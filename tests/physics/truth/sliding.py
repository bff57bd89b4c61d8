"""Coulomb friction of a box: slopes, stopping, a conveyor."""

from __future__ import annotations

import math

from tests.flat import box, scene
from tests.physics.truth.experiment import RATE, Engine, Experiment, G, experiment, off
from tests.physics.truth.slopes import rider, slope, way_up


def _incline(mu: float, degrees: float) -> Experiment:
    angle = math.radians(degrees)

    @experiment(f"incline of {degrees:g}°, friction {mu:g}", "way after 2 s", bound=1e-12)
    def slide(start: Engine) -> float:
        run = start(scene(slope(angle, friction=mu), rider(angle, box(1.0, 0.2, friction=mu), 0.1)))
        run.step(2 * RATE)
        return off(-way_up(run, angle), 0.5 * G * (math.sin(angle) - mu * math.cos(angle)) * 2.0**2)

    return slide


INCLINES = [_incline(0.0, 20.0), _incline(0.2, 30.0), _incline(0.5, 40.0), _incline(0.8, 50.0)]


def _way_on_steep_slopes(start: Engine, since: int, until: int) -> float:
    """How far boxes of 1 m slip from one step to another on slopes 1° below the angle of their friction."""
    worst = 0.0
    for mu in (0.2, 0.5, 0.8):
        angle = math.atan(mu) - math.radians(1.0)
        run = start(scene(slope(angle, friction=mu), rider(angle, box(1.0, 0.2, friction=mu), 0.1)))
        run.step(since)
        before = way_up(run, angle)
        run.step(until - since)
        worst = max(worst, abs(way_up(run, angle) - before))
    return worst


@experiment("box put on a slope: slip until it holds", "lengths of the box, 1° below the friction angle", bound=1e-12)
def settling(start: Engine) -> float:
    return _way_on_steep_slopes(start, 0, RATE)


@experiment("box on a slope: creep after the first second", "lengths of the box in 9 s", bound=1e-12)
def creeping(start: Engine) -> float:
    return _way_on_steep_slopes(start, RATE, 10 * RATE)


@experiment("slides up an incline and stays", "highest way, and 4 s later", bound=1e-4)
def up_and_stay(start: Engine) -> float:
    angle, mu, speed = math.radians(20.0), 0.5, 6.0
    run = start(scene(slope(angle, friction=mu), rider(angle, box(1.0, 0.2, friction=mu), 0.1, speed)))
    truth = speed**2 / (2.0 * G * (math.sin(angle) + mu * math.cos(angle)))
    run.step(2 * RATE)
    first = off(way_up(run, angle), truth)
    run.step(4 * RATE)
    return max(first, off(way_up(run, angle), truth))


@experiment("stopping", "distance, frictions 0.1 to 0.7, 2 to 8 m/s", bound=2e-5)
def stopping(start: Engine) -> float:
    worst = 0.0
    for mu, speed in ((0.1, 2.0), (0.3, 5.0), (0.3, 8.0), (0.7, 8.0)):
        run = start(scene(slope(0.0, friction=mu), rider(0.0, box(1.0, 0.2, friction=mu), 0.1, speed)))
        run.step(RATE + int(RATE * speed / (mu * G)))
        worst = max(worst, off(way_up(run, 0.0), speed**2 / (2.0 * mu * G)))
    return worst


@experiment("conveyor", "way of a crate in 3 s", bound=1e-6)
def conveyor(start: Engine) -> float:
    """The belt drags the crate at mu g until it moves as fast as the belt."""
    worst = 0.0
    for mu, speed in ((0.5, 2.0), (0.2, -3.0)):
        belt = slope(0.0, friction=mu, surface_speed=speed)
        run = start(scene(belt, rider(0.0, box(1.0, 0.5, friction=mu), 0.25)))
        run.step(3 * RATE)
        catching_up = abs(speed) / (mu * G)
        worst = max(worst, off(way_up(run, 0.0), speed * (3.0 - 0.5 * catching_up)))
    return worst

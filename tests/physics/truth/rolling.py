"""A disc on a slope and on the flat."""

from __future__ import annotations

import math

from tests.flat import body, box, circle, scene
from tests.physics.truth.experiment import RATE, Engine, G, experiment, off
from tests.physics.truth.slopes import rider, slope, up_the_slope, way_up


@experiment("disc rolls down a slope", "way and spin after 3 s", bound=2e-5)
def rolling(start: Engine) -> float:
    """a = 2/3 g sin: a third of the pull goes into the spin."""
    worst = 0.0
    for degrees in (5.0, 20.0):
        angle = math.radians(degrees)
        run = start(scene(slope(angle, friction=1.0), rider(angle, circle(0.5, friction=1.0), 0.5)))
        run.step(3 * RATE)
        a = 2.0 / 3.0 * G * math.sin(angle)
        worst = max(worst, off(-way_up(run, angle), 0.5 * a * 3.0**2), off(run.spin("rider"), a * 3.0 / 0.5))
    return worst


@experiment("disc slips down a slope", "way and spin after 2 s", bound=2e-5)
def slipping(start: Engine) -> float:
    """Friction gives all that it has: a = g (sin - mu cos), and the spin grows by 2 mu g cos / r."""
    angle, mu = math.radians(50.0), 0.1
    run = start(scene(slope(angle, friction=mu), rider(angle, circle(0.5, friction=mu), 0.5)))
    run.step(2 * RATE)
    way = 0.5 * G * (math.sin(angle) - mu * math.cos(angle)) * 2.0**2
    return max(off(-way_up(run, angle), way), off(run.spin("rider"), 2.0 * mu * G * math.cos(angle) / 0.5 * 2.0))


@experiment("sliding disc begins to roll", "way, speed and spin after 3 s", bound=1e-6)
def begins_to_roll(start: Engine) -> float:
    """It slows at mu g until it rolls, after v / (3 mu g), and goes on at two thirds of its speed."""
    mu, speed = 0.4, 6.0
    run = start(scene(slope(0.0, friction=mu), rider(0.0, circle(0.5, friction=mu), 0.5, speed)))
    run.step(3 * RATE)
    slips = speed / (3.0 * mu * G)
    way = speed * slips - 0.5 * mu * G * slips**2 + 2.0 / 3.0 * speed * (3.0 - slips)
    rolls = up_the_slope(0.0, run.velocity("rider"))
    speeds = max(off(rolls, 2.0 / 3.0 * speed), off(run.spin("rider"), -2.0 / 3.0 * speed / 0.5))
    return max(off(way_up(run, 0.0), way), speeds)


@experiment("disc rolls on level ground", "way after 30 s", bound=1e-12)
def rolls_on(start: Engine) -> float:
    """Nothing slows it: its speed and its spin fit from the start."""
    run = start(scene(slope(0.0, friction=0.5), rider(0.0, circle(0.5, friction=0.5), 0.5, 1.0, angular_velocity=-2.0)))
    run.step(30 * RATE)
    return off(way_up(run, 0.0), 30.0)


@experiment("disc rolls down a slope: its error grows", "m from 1 s to 4 s, radii 0.1 and 0.5 m", bound=1e-12)
def error_grows(start: Engine) -> float:
    """An arm of the friction that is too short shows here: the acceleration is wrong."""
    worst, angle = 0.0, math.radians(5.0)
    for radius in (0.1, 0.5):
        run = start(scene(slope(angle, friction=1.0), rider(angle, circle(radius, friction=1.0), radius)))
        errors = []
        for seconds in (1.0, 4.0):
            run.step(RATE if seconds == 1.0 else 3 * RATE)
            errors.append(-way_up(run, angle) - G * math.sin(angle) / 3.0 * seconds**2)
        worst = max(worst, abs(errors[1] - errors[0]))
    return worst


@experiment("disc slips on a board that gives way", "velocities and spin after 1 s", bound=2.5e-8)
def on_a_board(start: Engine) -> float:
    """The friction between two that move: the board, on ice, is dragged along until the disc rolls on it."""
    mu, speed, radius = 0.3, 3.0, 0.5
    ice = body("ice", box(400.0, 2.0, (0.0, -1.0), friction=0.0), type="static")
    board = body("board", box(60.0, 0.5, friction=mu), position=(0.0, 0.25))
    disc = body("disc", circle(radius, friction=mu), position=(-10.0, 0.5 + radius), velocity=(speed, 0.0))
    run = start(scene(ice, board, disc))
    run.step(RATE)
    share = math.pi * radius**2 / 30.0
    lost = speed / (3.0 + share)
    velocities = max(abs(run.velocity("disc")[0] - (speed - lost)), abs(run.velocity("board")[0] - share * lost))
    return max(velocities, abs(run.spin("disc") * radius + 2.0 * lost)) / speed

"""Nothing touches: free fall, a throw, a spin."""

from __future__ import annotations

import math

from tests.flat import body, box, circle, polygon, scene
from tests.physics.truth.experiment import RATE, Engine, G, experiment, off, off_pair


@experiment("free fall", "way after 2 s", bound=1e-12)
def free_fall(start: Engine) -> float:
    run = start(scene(body("stone", circle(0.5))))
    run.step(2 * RATE)
    return off(run.place("stone")[1], -0.5 * G * 2.0**2)


@experiment("projectile", "range, back at the height it came from", bound=1e-12)
def projectile(start: Engine) -> float:
    """Thrown so that it comes down after 3 s."""
    up, along = 1.5 * G, 7.0
    run = start(scene(body("stone", box(1.0, 0.5), velocity=(along, up), angular_velocity=2.0)))
    run.step(3 * RATE)
    return off_pair(run.place("stone"), (3.0 * along, 0.0), 3.0 * along)


@experiment("spinning body", "angle after 100 s, 1,100 rad", bound=1e-12)
def spinning_body(start: Engine) -> float:
    """An uneven body spins about its centre of mass, which stays where it is."""
    wedge = polygon((0.0, 0.0), (2.0, 0.0), (0.0, 1.0))
    run = start(scene(body("top", wedge, angular_velocity=11.0), gravity=(0.0, 0.0)))
    run.step(100 * RATE)
    turned = math.remainder(run.angle("top") - 1100.0, 2.0 * math.pi)
    drift = off_pair(run.place("top"), (2.0 / 3.0, 1.0 / 3.0), 1.0)
    return max(abs(turned) / 1100.0, off(run.spin("top"), 11.0), drift)

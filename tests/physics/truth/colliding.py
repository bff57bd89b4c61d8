"""Two bodies collide in empty space."""

from __future__ import annotations

import math

from tests.flat import body, box, circle, scene
from tests.physics.truth.experiment import RATE, Engine, Run, experiment, off, off_pair

NOWHERE = (0.0, 0.0)
DISC = math.pi * 0.25
"""m^2, of a disc of radius 0.5 m."""


@experiment("collision on one line", "both velocities; 1:1, 1:3, 10:1, restitution 0 to 1", bound=1e-12)
def head_on(start: Engine) -> float:
    worst = 0.0
    for m1, m2 in ((1.0, 1.0), (1.0, 3.0), (10.0, 1.0)):
        for e in (0.0, 0.5, 1.0):
            a, b = (circle(0.5, density=m / DISC, restitution=e, friction=0.0) for m in (m1, m2))
            run = start(
                scene(
                    body("a", a, position=(-2.0, 0.0), velocity=(3.0, 0.0)),
                    body("b", b, position=(2.0, 0.0), velocity=(-1.5, 0.0)),
                    gravity=NOWHERE,
                )
            )
            run.step(2 * RATE)
            mean, closing = (3.0 * m1 - 1.5 * m2) / (m1 + m2), 4.5
            va, vb = mean - m2 * e * closing / (m1 + m2), mean + m1 * e * closing / (m1 + m2)
            worst = max(worst, off_pair(run.velocity("a"), (va, 0.0), closing))
            worst = max(worst, off_pair(run.velocity("b"), (vb, 0.0), closing))
    return worst


@experiment("oblique collision of two discs", "both velocities, restitution 0.5 and 1", bound=1e-3)
def oblique(start: Engine) -> float:
    """Smooth discs exchange only what is along the line of their centres at the moment they touch."""
    worst = 0.0
    for e, aside in ((1.0, 0.4), (0.5, 0.7)):
        disc = circle(0.5, restitution=e, friction=0.0)
        run = start(
            scene(
                body("a", disc, position=(-2.0, 0.0), velocity=(4.0, 0.0)),
                body("b", disc, position=(2.0, aside)),
                gravity=NOWHERE,
            )
        )
        run.step(2 * RATE)
        nx, ny = math.sqrt(1.0 - aside**2), aside
        passed = 0.5 * (1.0 + e) * 4.0 * nx
        worst = max(worst, off_pair(run.velocity("b"), (passed * nx, passed * ny), 4.0))
        worst = max(worst, off_pair(run.velocity("a"), (4.0 - passed * nx, -passed * ny), 4.0))
    return worst


@experiment("oblique bounce of a rough disc", "velocity and spin; it slips, it grips", bound=1e-12)
def rough(start: Engine) -> float:
    """The blow's friction is mu times the blow, or as much as stops the sliding: a third of it, for a disc."""
    worst = 0.0
    for mu, e, along in ((0.1, 0.8, 5.0), (0.9, 0.8, 3.0)):
        wall = body("wall", box(40.0, 2.0, (0.0, -1.0), friction=mu, restitution=e), type="static")
        disc = body("disc", circle(0.5, friction=mu, restitution=e), position=(-3.0, 2.5), velocity=(along, -4.0))
        run = start(scene(wall, disc, gravity=NOWHERE))
        run.step(RATE)
        lost = min(mu * (1.0 + e) * 4.0, along / 3.0)
        worst = max(worst, off_pair(run.velocity("disc"), (along - lost, 4.0 * e), math.hypot(along, 4.0)))
        worst = max(worst, off(run.spin("disc"), -2.0 * lost / 0.5))
    return worst


@experiment("a box on a rough corner", "velocity and spin; it grips, restitution 0.5 and 1", bound=1e-12)
def corner(start: Engine) -> float:
    """Friction that holds takes its part while the blow lasts, so that the corner gives way along the ground: by
    k_tn / k_tt of the blow, of the inverse masses of the corner."""
    worst = 0.0
    for e, angle in ((0.5, 0.35), (1.0, 0.35), (0.5, 0.6), (1.0, 0.6)):
        ground = body("ground", box(40.0, 2.0, (0.0, -1.0), friction=2.0, restitution=e), type="static")
        x = 0.5 * (math.sin(angle) - math.cos(angle))
        y = -0.5 * (math.sin(angle) + math.cos(angle))
        crate = box(1.0, 1.0, density=1.0, friction=2.0, restitution=e)
        run = start(
            scene(
                ground,
                body("crate", crate, position=(0.0, 0.03 - y), angle=angle, velocity=(0.0, -4.0)),
                gravity=NOWHERE,
            )
        )
        run.step(2)
        inertia = 1.0 / 6.0
        normal, tangent, both = 1.0 + x * x / inertia, 1.0 + y * y / inertia, -x * y / inertia
        blow = (1.0 + e) * 4.0 / (normal - both * both / tangent)
        rub = -both / tangent * blow
        worst = max(worst, off_pair(run.velocity("crate"), (rub, blow - 4.0), 4.0))
        worst = max(worst, off(run.spin("crate"), (x * blow - y * rub) / inertia))
    return worst


def _rod_and_ball(start: Engine, e: float, arm: float) -> Run:
    rod = body("rod", box(0.2, 2.0, density=5.0, friction=0.0, restitution=e))
    ball = circle(0.25, density=3.0, friction=0.0, restitution=e)
    return start(scene(rod, body("ball", ball, position=(-2.0, arm), velocity=(3.0, 0.0)), gravity=NOWHERE))


@experiment("ball against the end of a rod", "velocities and the rod's spin", bound=1e-12)
def rod_end(start: Engine) -> float:
    """The rod gives way and turns: at the arm it weighs as 1 / (1/M + arm^2/I)."""
    worst = 0.0
    for e, arm in ((1.0, 0.9), (0.5, 0.9), (0.5, 0.6)):
        run = _rod_and_ball(start, e, arm)
        run.step(RATE)
        ball, rod = 3.0 * math.pi * 0.25**2, 5.0 * 0.2 * 2.0
        inertia = rod * (0.2**2 + 2.0**2) / 12.0
        blow = (1.0 + e) * 3.0 / (1.0 / ball + 1.0 / rod + arm**2 / inertia)
        worst = max(worst, off_pair(run.velocity("ball"), (3.0 - blow / ball, 0.0), 3.0))
        worst = max(worst, off_pair(run.velocity("rod"), (blow / rod, 0.0), 3.0))
        worst = max(worst, off(run.spin("rod"), -blow * arm / inertia))
    return worst

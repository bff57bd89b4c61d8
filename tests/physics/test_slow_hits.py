"""What closes in slowly strikes where it touches, not where the step finds it a centimetre before."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sandbox.scene.flat import FlatSettings
from tests.flat import body, box, circle, world

RADIUS = 0.3
SMOOTH = {"friction": 0.0, "restitution": 1.0}


def after_blow(aslant: float, sliding: float, closing: float, rate: int, corner: bool) -> tuple[float, float]:
    """(closing, sliding) of a disc after it has struck a body at rest that is immovable: a disc, or the corner of a
    box. It comes from where it touches as the normal lies aslant so much, and takes 0.2 s; velocities are along that
    normal and across it (m/s)."""
    normal = np.array([math.cos(aslant), math.sin(aslant)])
    across = np.array([-normal[1], normal[0]])
    post = body("post", box(1.0, 1.0, (-0.5, -0.5), **SMOOTH) if corner else circle(RADIUS, **SMOOTH), type="static")
    touch = normal * (RADIUS if corner else 2.0 * RADIUS)
    velocity = across * sliding - normal * closing
    x, y = touch - velocity * 0.2
    disc = body("disc", circle(RADIUS, **SMOOTH), position=(x, y), velocity=tuple(velocity))
    w = world(post, disc, gravity=(0.0, 0.0), settings=FlatSettings(step_rate=float(rate)))
    w.step(2 + rate // 5)
    left = np.array(w.body("disc").velocity)
    return -float(left @ normal), float(left @ across)


@pytest.mark.parametrize("corner", [False, True])
@pytest.mark.parametrize("rate", [59, 61, 123, 240])
@pytest.mark.parametrize("sliding", [-0.7, 0.4, 1.0])
@pytest.mark.parametrize("closing", [0.3, 0.6])
def test_a_disc_rebounds_by_the_normal_of_where_it_touches(closing, sliding, rate, corner):
    for aslant in (0.4, 0.8, 1.2):
        found = after_blow(aslant, sliding, closing, rate, corner)
        assert found == pytest.approx((-closing, sliding), abs=1e-3)

"""Blows of rough corners, against the same blows in many small pushes: friction acts within a blow, not after it."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings
from tests.examples import examples
from tests.flat import body, box, ground, scene

PUSHES = 800


def in_small_pushes(arm, velocity, spin, mass, inertia, friction, restitution):
    """(vx, vy, w) after a blow at `arm` on flat ground. Friction goes against the slip of the moment, or holds it where
    it can; restitution gives the impulse that stopped the closing so many times again."""
    x, y = arm
    vx, vy = velocity
    push, given, stopped = mass * abs(vy - spin * x) / PUSHES, 0.0, None
    while stopped is None or given < (1.0 + restitution) * stopped:
        slip = vx - spin * y
        # What this push along the normal adds to the slip, and what a push along the tangent would.
        adds, tangent = -push * x * y / inertia, 1.0 / mass + y * y / inertia
        drag = -(slip + adds) / tangent
        drag = max(-friction * push, min(friction * push, drag))
        vx += drag / mass
        vy += push / mass
        spin += (x * push - y * drag) / inertia
        given += push
        if stopped is None and vy + spin * x >= 0.0:
            stopped = given
    return vx, vy, spin


def blow_of(angle, velocity, spin, friction, restitution):
    """The same in a world: a box that comes down on its corner, (arm, velocities before, velocities after)."""
    crate = box(1.0, 0.6, restitution=restitution, friction=friction)
    corners = [(u * math.cos(angle) - v * math.sin(angle), u * math.sin(angle) + v * math.cos(angle))
               for u in (-0.5, 0.5) for v in (-0.3, 0.3)]  # fmt: skip
    arm = min(corners, key=lambda corner: corner[1])
    bodies = [
        ground(friction=friction),
        body("crate", crate, position=(0.0, 1e-4 - arm[1]), angle=angle, velocity=velocity, angular_velocity=spin),
    ]
    world = World(scene(*bodies, gravity=(0.0, 0.0), settings=FlatSettings(step_rate=1000)))
    crate = world.body("crate")
    world.step(1)
    assert crate.velocity[1] != velocity[1]
    return arm, crate


@given(
    st.floats(0.1, 1.4),
    st.floats(-6.0, 6.0),
    st.floats(2.0, 8.0),
    st.floats(-3.0, 3.0),
    st.floats(0.05, 2.0),
    st.floats(0.05, 1.0),
)
@examples(40)
def test_a_corner_rebounds_as_in_small_pushes(angle, sideways, down, spin, friction, restitution):
    arm, crate = blow_of(angle, (sideways, -down), spin, friction, restitution)
    assume(-down + spin * arm[0] < -1.5)  # what hardly closes does not bounce
    wanted = in_small_pushes(arm, (sideways, -down), spin, crate.mass, crate.inertia, friction, restitution)
    found = (*crate.velocity, crate.angular_velocity)
    assert found == pytest.approx(wanted, abs=0.02 * math.hypot(sideways, down))
    energy = 0.5 * crate.mass * (found[0] ** 2 + found[1] ** 2) + 0.5 * crate.inertia * found[2] ** 2
    before = 0.5 * crate.mass * (sideways**2 + down**2) + 0.5 * crate.inertia * spin**2
    assert energy <= before * (1.0 + 1e-9)


def test_a_corner_that_sticks_keeps_all_energy_with_restitution_1():
    """Nothing slides, so that nothing is lost."""
    _, crate = blow_of(math.radians(20.0), (0.0, -4.0), 0.0, 2.0, 1.0)
    energy = 0.5 * crate.mass * math.hypot(*crate.velocity) ** 2 + 0.5 * crate.inertia * crate.angular_velocity**2
    assert energy == pytest.approx(0.5 * crate.mass * 16.0, rel=1e-9)

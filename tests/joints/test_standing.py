"""What stands on the ground by joints: light legs and wheels bear heavy bodies, and come to rest."""

from __future__ import annotations

import dataclasses
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.contact_solver import soft_constraint
from sandbox.engine.world import World
from tests.flat import AWAKE, body, box, circle
from tests.joints.jointed import joint, jointed
from tests.kernels import called_from_python

FLOOR = body("floor", box(60.0, 2.0), type="static", position=(0.0, -1.0))
contact_spring = called_from_python(soft_constraint.contact_spring)


def table(ratio: float, speed: float = 0.0) -> World:
    """A top of `ratio` times the mass of each of its two welded legs, which comes down at a speed (m/s)."""
    legs = [body(f"l{x}", box(0.3, 1.0), position=(x, 0.5), velocity=(0.0, -speed)) for x in (-1.0, 1.0)]
    top = body("top", box(3.0, 0.4, density=ratio * 0.25), position=(0.0, 1.2), velocity=(0.0, -speed))
    welds = [joint(f"w{x}", "weld", "top", f"l{x}", (x, 1.0)) for x in (-1.0, 1.0)]
    return jointed((FLOOR, top, *legs), tuple(welds))


def cart(ratio: float, speed: float = 0.0) -> World:
    """A chassis of `ratio` times the mass of each of its two wheels, which comes down at a speed (m/s)."""
    wheels = [body(f"l{x}", circle(0.3), position=(x, 0.3), velocity=(0.0, -speed)) for x in (-1.0, 1.0)]
    chassis = box(3.0, 0.4, density=ratio * math.pi * 0.09 / 1.2)
    top = body("top", chassis, position=(0.0, 0.7), velocity=(0.0, -speed))
    hinges = [joint(f"h{x}", "revolute", "top", f"l{x}", (x, 0.3)) for x in (-1.0, 1.0)]
    return jointed((FLOOR, top, *wheels), tuple(hinges))


@pytest.mark.parametrize("ratio", [10.0, 100.0, 300.0, 1000.0, 10_000.0])
@pytest.mark.parametrize("build", [table, cart])
def test_what_stands_by_joints_stands_still(build, ratio):
    world = build(ratio)
    start = world.body("top").position
    for _ in range(300):
        world.step()
    x, y = world.body("top").position
    assert abs(x - start[0]) < 1e-4
    assert -1e-4 < start[1] - y < 0.01
    assert max(map(abs, world.body("top").velocity)) < 1e-3


@pytest.mark.parametrize("build", [table, cart])
def test_what_is_light_takes_no_finer_substeps(build):
    world = build(10.0)
    for _ in range(60):
        world.step()
        assert world.scratch.solver.free_motions.substep_level.max() == 0


@pytest.mark.parametrize("rate", [30.0, 60.0])
@pytest.mark.parametrize("load", [20.0, 50.0])
def test_a_loaded_table_rests(rate, load):
    """It bears a box of that many times the mass of its top."""
    legs = [body(f"l{x}", box(0.2, 1.0), position=(x, 0.5)) for x in (-1.3, 1.3)]
    crate = body("crate", box(1.0, 1.0, density=0.6 * load), position=(0.0, 1.7))
    welds = [joint(f"w{x}", "weld", "top", f"l{x}", (x, 1.0)) for x in (-1.3, 1.3)]
    bodies = (FLOOR, body("top", box(3.0, 0.2), position=(0.0, 1.1)), *legs, crate)
    world = jointed(bodies, tuple(welds), settings=dataclasses.replace(AWAKE, step_rate=rate))
    world.step(int(5.0 * rate))
    for _ in range(int(5.0 * rate)):
        world.step()
        assert max(map(abs, (*world.body("top").velocity, *world.body("crate").velocity))) < 0.01


@pytest.mark.parametrize(("build", "ratio", "most"), [(cart, 4.0, 0.38), (cart, 100.0, 0.6), (table, 100.0, 0.6)])
def test_a_landing_rebounds_little(build, ratio, most):
    speed = 5.0
    world = build(ratio, speed)
    for _ in range(30):
        world.step()
        assert world.body("top").velocity[1] < most * speed


@given(
    substeps=st.integers(1, 64), rate=st.sampled_from([30.0, 60.0, 240.0]), hertz=st.floats(5.0, 200.0),
    damping=st.floats(0.5, 10.0), level=st.integers(0, 4),
)  # fmt: skip
def test_forces_on_what_is_heavier_than_a_contact_knows_die_out(substeps, rate, hertz, damping, level):
    """Routh's and Hurwitz's criterion for the softness that contacts of jointed bodies have."""
    settings = dataclasses.replace(
        AWAKE, substeps=substeps, step_rate=rate, contact_hertz=hertz, contact_damping_ratio=damping
    )
    world = jointed((body("b", circle(0.5)),), (), settings=settings)
    spring = soft_constraint.Spring(*contact_spring(world.state.settings[0], level))
    softness = spring.softness_jointed
    assert softness >= spring.softness
    assert softness * (2.0 - softness) > 1.2 * (1.0 - softness) * spring.bias * spring.seconds


def test_a_joint_at_the_floor_changes_nothing_for_what_lies_there():
    """Its contacts are as stiff as without the joint."""
    stack = [body(f"s{k}", box(1.0, 1.0), position=(0.01 * k, 0.51 + 1.01 * k)) for k in range(5)]
    door = body("door", box(2.0, 0.2), position=(20.0, 5.0))
    with_joint = jointed((FLOOR, *stack, door), (joint("hinge", "revolute", "floor", "door", (19.0, 5.0)),))
    without = jointed((FLOOR, *stack, door), ())
    for _ in range(60):
        with_joint.step()
        without.step()
        for each in stack:
            assert with_joint.body(each.id).position == pytest.approx(without.body(each.id).position, abs=1e-9)

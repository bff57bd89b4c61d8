"""A body with bad numbers is frozen alone: what touches it or hangs on it treats it as one that does not move."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sandbox import ApplyForce
from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatJoint
from tests.engine.test_guard import finite
from tests.examples import examples
from tests.flat import body, box, circle, ground
from tests.joints.jointed import gap, joint, jointed

ABSURD = ("force", "torque", "velocity", "spin", "sliver", "mass", "inertia", "feather")


def joints_finite(w: World) -> bool:
    """Whether impulses, forces and torques of all joints are numbers."""
    names = [name for name in w.state.joints.dtype.names if name.startswith(("impulse", "force", "torque"))]
    return all(np.isfinite(w.state.joints[name]).all() for name in names)


def chain(count: int) -> tuple[list[FlatBody], list[FlatJoint]]:
    """Links of 1 m that hang from the world at (0, 0)."""
    links = [body(f"l{k}", box(0.2, 0.9), position=(0.0, -0.5 - k)) for k in range(count)]
    return links, [
        joint(f"j{k}", "revolute", f"l{k - 1}" if k else None, f"l{k}", (0.0, -float(k))) for k in range(count)
    ]


def net(side: int) -> tuple[list[FlatBody], list[FlatJoint]]:
    """A cloth of boxes 1 m apart, too dense to be factorised, that hangs from the world by its uppermost row."""
    cloth = [body(f"n{i}{k}", box(0.3, 0.3), position=(i, -float(k))) for i in range(side) for k in range(side)]
    joints = [joint(f"t{i}", "revolute", None, f"n{i}0", (float(i), 0.0)) for i in range(side)]
    for i in range(side):
        for k in range(side):
            for right, name in ((f"n{i + 1}{k}", "h"), (f"n{i}{k + 1}", "v")):
                if (i if name == "h" else k) + 1 < side:
                    joints.append(joint(f"{name}{i}{k}", "revolute", f"n{i}{k}", right, (float(i), -float(k))))
    return cloth, joints


@pytest.mark.parametrize("force", [1e12, 1e15, 1e300])
@pytest.mark.parametrize(("made", "middle"), [(chain(2), "l0"), (chain(5), "l2"), (net(5), "n22")])
def test_a_monstrous_force_on_a_link_freezes_that_link_alone(made, middle, force):
    links, joints = made
    w = jointed(tuple(links), tuple(joints))
    w.step(10)
    place = w.body(middle).position
    w.apply(ApplyForce(middle, (force, 0.0)))
    w.step(120)
    assert w.frozen == [(middle, 10)]
    assert w.body(middle).position == place
    assert finite(w)
    assert joints_finite(w)


def test_what_hangs_on_a_frozen_link_swings_on_it():
    links, joints = chain(2)
    w = jointed(tuple(links), tuple(joints))
    w.apply(ApplyForce("l0", (1e300, 0.0)))
    w.step()
    w.apply(ApplyForce("l1", (100.0, 0.0)))
    w.step(30)
    assert gap(w) < 1e-3, "at whatever substeps it is solved"
    assert abs(w.body("l1").angle) > 0.1
    other = jointed(tuple(links), tuple(joints))
    other.restore(w.snapshot())
    w.step(30)
    other.step(30)
    assert other.digest() == w.digest()


def test_the_joint_of_two_frozen_bodies_rests():
    links, joints = chain(2)
    w = jointed(tuple(links), tuple(joints))
    for name in ("l0", "l1"):
        w.apply(ApplyForce(name, (1e300, 1e300)))
    w.step(30)
    assert [name for name, _ in w.frozen] == ["l0", "l1"]
    assert joints_finite(w)


@given(
    absurd=st.sampled_from(ABSURD),
    which=st.integers(0, 3),
    size=st.floats(6.0, 15.0),
    turn=st.floats(-math.pi, math.pi),
    hung=st.booleans(),
)
@example("force", 1, 15.0, 0.3, True)
@examples(40)
def test_the_neighbours_of_an_absurd_body_stay_sound(absurd, which, size, turn, hung):
    """Three crates and a ball in a pile, or a chain, of which one has a size, mass, velocity or force of 10^size
    within the limits of scenes."""
    big = 10.0**size
    fields = {
        "velocity": {"velocity": (min(big, 1e6) * math.cos(turn), min(big, 1e6) * math.sin(turn))},
        "spin": {"angular_velocity": min(big, 1e6)},
        "mass": {"mass": big, "inertia": big},
        "inertia": {"inertia": big},
        "feather": {"mass": 1e-9, "inertia": 1e-12},
        "sliver": {"angle": turn, "angular_velocity": 1.0},
    }
    bodies = []
    for k in range(4):
        odd = k == which
        shape = box(min(big, 1e7), 1e-3) if odd and absurd == "sliver" else (circle(0.5) if k == 3 else box(1.0, 1.0))
        bodies.append(body(f"b{k}", shape, position=(0.0, 0.5 + k), **(fields.get(absurd, {}) if odd else {})))
    joints = [joint(f"j{k}", "revolute", f"b{k}", f"b{k + 1}", (0.0, 1.0 + k)) for k in range(3)] if hung else []
    w = jointed((ground(), *bodies), tuple(joints))
    if absurd == "force":
        w.apply(ApplyForce(f"b{which}", (big * math.cos(turn), big * math.sin(turn))))
    if absurd == "torque":
        w.apply(ApplyForce(f"b{which}", (0.0, 0.0), big))
    for _ in range(30):
        w.step()
        assert finite(w)
        assert joints_finite(w)
    assert {name for name, _ in w.frozen} <= {f"b{which}"}

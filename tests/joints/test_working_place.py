"""What is worked out of a batch does not depend on what the batch before has left in the working place."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatJoint, FlatScene
from tests.determinism import jointed as machines
from tests.flat import body, box, circle
from tests.joints.jointed import joint, jointed

MACHINE = machines.scene()
PARTS: dict[str, tuple[str, ...]] = {
    "rod": ("bob",),
    "axle": ("car", "wheel", "gear"),
    "cogs": ("sled", "gear"),
    "mouse": ("crate",),
    "rub": ("puck",),
    "rope": ("lamp", "left", "right"),
    "chain-0": tuple(f"link-{k}" for k in range(5)),
}
"""The bodies of every part of the machine, by one of its joints."""


def alone(names: tuple[str, ...]) -> FlatScene:
    """Only these bodies of the machine, and what joins them."""
    bodies = tuple(b for b in MACHINE.bodies if b.id in names)
    joints = tuple(j for j in MACHINE.joints if all(b is None or b in names for b in (j.body_a, j.body_b)))
    known = {j.id for j in joints}
    return FlatScene(bodies, joints=tuple(j for j in joints if j.joints is None or set(j.joints) <= known))


@pytest.mark.parametrize("names", PARTS.values(), ids=PARTS)
def test_rubbish_there_makes_no_difference(names):
    clean, spoilt = World(alone(names)), World(alone(names))
    for step in range(60):
        clean.step()
        d = spoilt.scratch.joints.direct
        d.memory[: int(d.found[3])] = np.nan
        spoilt.step()
        assert clean.digest() == spoilt.digest(), step


def test_every_joint_of_the_machine_is_in_some_part():
    assert {j.id for j in MACHINE.joints} == {j.id for names in PARTS.values() for j in alone(names).joints}


def test_the_torque_of_a_gear_counts_from_the_anchor_of_its_first_joint():
    """A rack that is pushed along its slide, through the anchor, which is away from its middle."""
    bodies = (body("rack", box(2.0, 0.3), position=(0.0, 5.0)), body("cog", circle(0.5), position=(0.0, 5.8)))
    joints = (
        joint("slide", "prismatic", None, "rack", (0.7, 5.4), axis=(0.8, 0.6)),
        joint("pin", "revolute", None, "cog", (0.0, 5.8)),
        FlatJoint("cogs", "gear", None, None, joints=("slide", "pin"), ratio=0.5),
    )
    world = jointed(bodies, joints)
    for _ in range(10):
        world.step()
    cogs = world.joint("cogs")
    assert math.hypot(*cogs.force) > 0.1
    assert cogs.torque == pytest.approx(0.0, abs=1e-9)

"""What has to be assembled anew after a restore: nothing, while `wiring` is what it was."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from sandbox import BreakJoint
from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.wiring import wiring
from sandbox.engine.world import World
from sandbox.tables import plain
from sandbox.world.build import build_state
from sandbox.world.joint_records import JOINT
from sandbox.world.records import BODY
from tests.shipped import FILES, shipped

JOINTED = [name for name in sorted(FILES) if shipped(name).flatten().joints]


def contents(value: Any) -> Any:
    """The bytes of all arrays in tuples of arrays and such tuples."""
    return value.tobytes() if isinstance(value, np.ndarray) else [contents(each) for each in value or ()]


def assembled(state: Any) -> Any:
    """All that `assemble` makes of a state, but for the table of joints that it passes on."""
    joint_filter, work = assemble(state.joints, state.bodies, PartLayouts(), len(state.bodies))
    return contents(joint_filter), contents(work and work._replace(joints=np.zeros(0)))


@pytest.mark.parametrize("name", JOINTED)
def test_nothing_else_makes_a_difference_to_the_assembly(name: str) -> None:
    """Other anchors, impulses, places and speeds, and other flags of bodies: the same tables."""
    state, draw = build_state(shipped(name).flatten()), np.random.default_rng(7)
    before, wired = assembled(state), wiring(state.joints, state.bodies)
    for table, rows in ((JOINT, plain(state.joints)), (BODY, plain(state.bodies))):
        for field in table.fields:
            if field.kind == "f8":
                rows[field.name] = np.where(rows[field.name] != 0.0, draw.uniform(0.1, 3.0, len(rows)), 0.0)
    for flag in ("awake", "bullet", "island", "posed", "type"):
        plain(state.bodies)[flag] = draw.integers(0, 2, len(state.bodies))
    assert wiring(state.joints, state.bodies) == wired
    assert assembled(state) == before


@pytest.mark.parametrize("field", [field.name for field in JOINT.fields if field.kind == "i8"])
def test_every_whole_number_of_a_joint_is_in_it(field: str) -> None:
    state = build_state(shipped("gears-and-pulley").flatten())
    before = wiring(state.joints, state.bodies)
    plain(state.joints)[field][-1] += 1
    assert wiring(state.joints, state.bodies) != before


@pytest.mark.parametrize(("field", "value"), [("mass", 0.0), ("frozen_step", 3)])
def test_who_can_be_moved_is_in_it(field: str, value: float) -> None:
    state = build_state(shipped("gears-and-pulley").flatten())
    before = wiring(state.joints, state.bodies)
    plain(state.bodies)[field][np.flatnonzero(state.bodies.mass > 0.0)[-1]] = value
    assert wiring(state.joints, state.bodies) != before


def test_a_restore_assembles_only_what_hangs_together_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    world = World(shipped("gears-and-pulley"))
    world.step(5)
    whole, digests = world.snapshot(), []
    for _ in range(5):
        world.step()
        digests.append(world.digest())
    memory = world.scratch.joints
    world.restore(whole)
    assert world.scratch.joints is memory
    world.step(5)
    assert world.digest() == digests[-1]
    world.apply(BreakJoint(next(name for name in world.joint_names if world.joint(name).type == "revolute")))
    assert world.scratch.joints is not memory
    memory = world.scratch.joints
    world.restore(whole)
    assert world.scratch.joints is not memory
    for digest in digests:
        world.step()
        assert world.digest() == digest

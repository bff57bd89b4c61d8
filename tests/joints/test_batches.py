"""Parts of one layout are solved side by side: nobody notices who else is in the batch."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox._vectors import WIDTH
from sandbox.engine.active.pile_stability import MAX_LEVEL
from sandbox.engine.joints.direct.layout import JointRows, direct_layout
from sandbox.engine.joints.direct.records import LEVELS
from sandbox.engine.joints.direct.tables import direct_tables, with_room
from sandbox.engine.joints.elimination import NOBODY, WORLD, minimum_degree
from sandbox.engine.joints.part_layout import UPDATES_A_ROW
from sandbox.engine.joints.symbolic import symbolic
from sandbox.scene.flat import FlatBody, FlatJoint, FlatSettings
from sandbox.world.joint_records import TARGET
from tests.examples import examples
from tests.flat import body, box, ground
from tests.joints.jointed import joint, jointed

SPACE = 200.0
"""More than what is thrown apart flies."""
KINDS: tuple[dict[str, Any], ...] = (
    {"kind": "revolute", "motor_speed": 2.0, "max_motor": 3.0, "lower": -0.3, "upper": 0.4, "hertz": 3.0},
    {"kind": "wheel", "axis": (0.6, 0.8), "hertz": 4.0, "damping_ratio": 0.5, "motor_speed": 3.0, "max_motor": 2.0},
    {"kind": "weld", "hertz": 5.0, "damping_ratio": 0.3},
    {"kind": "friction", "max_force": 3.0, "max_torque": 0.5},
)


def toy(k: int, fate: int) -> tuple[list[FlatBody], list[FlatJoint]]:
    """Five boxes in a row with joints of four kinds between them, at the place `k`; `fate` says what befalls it: it
    flies, spins, is thrown apart, lies on the ground, or hangs from the world."""
    x, y = SPACE * k, 0.2 if fate == 3 else 8.0
    speeds = [(0.0, 0.0, 0.0)] * 5
    if fate == 1:
        speeds = [(0.3 * i, 1.0, 3.0 + i) for i in range(5)]
    elif fate == 2:
        speeds = [((-40.0) ** i % 90.0, 70.0 * (-1) ** i, 30.0) for i in range(5)]
    bodies = [
        body(f"{k}b{i}", box(0.8, 0.4), position=(x + i, y), velocity=(vx, vy), angular_velocity=w)
        for i, (vx, vy, w) in enumerate(speeds)
    ]
    joints = [
        joint(f"{k}j{i}", fields["kind"], f"{k}b{i}", f"{k}b{i + 1}", (x + i + 0.5, y), **_without_kind(fields))
        for i, fields in enumerate(KINDS)
    ]
    if fate == 4:
        joints.append(joint(f"{k}pin", "revolute", None, f"{k}b0", (x - 0.5, y)))
    return bodies, joints


def _without_kind(fields: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in fields.items() if name != "kind"}


def toys(fates: dict[int, int], **settings: Any) -> Any:
    """A world of toys on one ground."""
    bodies: list[FlatBody] = [ground(8000.0)]
    joints: list[FlatJoint] = []
    for k, fate in fates.items():
        some, theirs = toy(k, fate)
        bodies += some
        joints += theirs
    return jointed(tuple(bodies), tuple(joints), settings=FlatSettings(**settings))


def rows_of(world: Any, k: int) -> list[bytes]:
    """All that is kept of a toy, bodies and joints; less the numbers of rows and islands."""
    found = []
    for table, names in ((world.state.bodies, world.names), (world.state.joints, world.joint_names)):
        columns = [c for c in table.dtype.names if not c.startswith("body_") and c not in ("island", "first_shape")]
        floats = [c for c in columns if table.dtype[c] == np.float64]
        chosen = [i for i, name in enumerate(names) if name.startswith((f"{k}b", f"{k}j", f"{k}pin"))]
        found += [table[c][chosen].tobytes() for c in floats]
    return found


@given(st.lists(st.integers(0, 4), min_size=2, max_size=2 * WIDTH + 3), st.booleans())
@examples(15)
def test_a_part_moves_as_if_it_were_alone(fates, sleeping):
    world = toys(dict(enumerate(fates)), sleeping=sleeping)
    alone = {k: toys({k: fate}, sleeping=sleeping) for k, fate in enumerate(fates) if k in (0, len(fates) - 1)}
    for step in range(40):
        world.step()
        for k, one in alone.items():
            one.step()
            assert rows_of(world, k) == rows_of(one, k), (step, k)


def test_parts_of_different_levels_share_no_batch():
    """A toy that a heavy load makes finer steps for, beside ones that are fine as they are."""
    bodies, joints = [ground(8000.0)], []
    for k in range(2 * WIDTH):
        some, theirs = toy(k, 3)
        bodies += some
        joints += theirs
        if k % 3 == 0:
            bodies.append(body(f"load{k}", box(4.0, 1.0, density=400.0), position=(SPACE * k + 2.0, 0.95)))
    world = jointed(tuple(bodies), tuple(joints))
    seen = set()
    for _ in range(60):
        world.step()
        d = world.scratch.joints.direct
        batches = d.batches[: int(d.found[0])]
        levels = world.scratch.solver.free_motions.substep_level
        for n, batch in enumerate(batches):
            seen.add(int(batch.level))
            for k in range(int(batch.count)):
                part = world.scratch.joints.parts[d.parts[n * WIDTH + k]]
                first = world.scratch.joints.members[part.first_member].body
                assert levels[first] == batch.level
        assert batches["count"].sum() == 2 * WIDTH
    assert len(seen) > 1


def test_sleepers_take_up_no_lanes():
    world = toys(dict.fromkeys(range(12), 3), sleeping=True)
    for _ in range(600):
        world.step()
    world.body("5b0").velocity = (0.0, 1.0)
    world.step()
    d = world.scratch.joints.direct
    batches = d.batches[: int(d.found[0])]
    assert batches["count"].tolist() == [1]


def test_a_level_for_each_that_islands_may_have():
    assert LEVELS == MAX_LEVEL + 1


@given(st.lists(st.integers(0, LEVELS - 1), min_size=1, max_size=70))
def test_there_is_room_however_parts_spread_over_levels(levels):
    sides = np.array([[WORLD, 0, NOBODY, NOBODY]])
    found = minimum_degree(sides, np.array([2]), UPDATES_A_ROW)
    assert found is not None
    rows = JointRows(np.array([[TARGET, 0, 0, -1, -1]]), sides, np.array([0, 0]), np.array([0, 1]))
    one = direct_layout(rows, symbolic(found, np.array([0]), np.array([2]), 2), True)
    d = with_room(direct_tables([one]), np.zeros(len(levels), np.int64))
    needed = sum(-(-levels.count(level) // WIDTH) for level in range(LEVELS))
    assert len(d.batches) >= needed


def test_one_layout_for_all_that_are_built_alike():
    world = toys(dict.fromkeys(range(5), 0) | dict.fromkeys(range(5, 9), 4))
    world.step()
    d = world.scratch.joints.direct
    assert len(d.layouts) == 2
    batches = d.batches[: int(d.found[0])]
    assert np.bincount(batches["layout"], batches["count"]).tolist() == [5, 4]


def test_gears_lie_in_lanes_as_well():
    """Their joints' coordinates are those of their own lane."""
    bodies, joints = [], []
    for k in range(3):
        x = SPACE * k
        bodies += [body(f"{k}b{i}", box(1.0, 0.3), position=(x + 6.0 * i, 5.0)) for i in range(2)]
        joints += [
            joint(f"{k}j0", "revolute", None, f"{k}b0", (x, 5.0), motor_speed=1.0 + k, max_motor=50.0),
            joint(f"{k}j1", "prismatic", None, f"{k}b1", (x + 6.0, 5.0), axis=(1.0, 0.0)),
            FlatJoint(f"{k}j2", "gear", None, None, joints=(f"{k}j0", f"{k}j1"), ratio=2.0),
        ]
    world = jointed(tuple(bodies), tuple(joints))
    for _ in range(60):
        world.step()
    for k in range(3):
        turned = world.body(f"{k}b0").angle
        slid = world.body(f"{k}b1").position[0] - SPACE * k - 6.0
        assert turned == pytest.approx(1.0 + k, rel=0.05)
        assert turned + 2.0 * slid == pytest.approx(0.0, abs=1e-6)

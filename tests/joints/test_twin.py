"""The joint solver and its naive twin: derivatives by a complex step, dense matrices, bounds by going through all ways
to be at them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox._vectors import WIDTH
from sandbox.engine.joints.direct import places as at
from sandbox.engine.world import World
from sandbox.world.joint_records import FRICTION, MOTOR, TARGET
from tests.examples import examples
from tests.joints.lanes import kept_field, lane_rows, some_part_is_separated, strained_bodies
from tests.joints.linkages import KINDS, SETTINGS, Linkage, force, linkages, parts, twin
from tests.naive.joint_rows import Array, arms, jacobian
from tests.naive.joints import Jointed, after_the_move, substeps

SECONDS = 1.0 / SETTINGS.step_rate
RIGID = ["revolute", "weld", "prismatic", "distance", "pulley"]
FREE = [*RIGID, "revolute spring", "weld soft", "wheel", "distance spring"]
"""Kinds whose rows have no bounds."""
BOTH = ["revolute motor stops", "revolute all", "prismatic all"]
"""Motors between stops."""
BOUND = [kind for kind in KINDS if kind not in FREE + BOTH]


def is_plain(world: World) -> bool:
    """Whether the last step followed the laws of the twin: nothing torn apart, no force at its limit in all directions,
    no link so strained that it was given more inertia."""
    return not (some_part_is_separated(world) or strained_bodies(world) or some_pair_is_capped(world))


def some_pair_is_capped(world: World) -> bool:
    """Whether the two rows of some joint are together at the limit of its force."""
    joints = world.state.joints
    for joint in joints[np.isin(joints.kind, (MOTOR, TARGET, FRICTION))]:
        if np.hypot(joint.impulse_0, joint.impulse_1) > joint.max_force * SECONDS * (1.0 - 1e-9):
            return True
    return False


def step_both(world: World) -> tuple[Jointed, float] | None:
    """Step a world and its twin; the twin after it, and how far off (m/s) one turn of Newton's method may be.

    None of a step that `is_plain` says the twin knows no laws of.

    It takes rows for straight, which turn in the substep: at the end of an arm it misses by arm * angle * speed.
    """
    part, pull = twin(world), force(world)
    world.step()
    if not is_plain(world):
        return None
    for k in range(3):  # found in the first step: `test_preload` asks whether these are the loads
        part.joints[f"preload_{k}"] = world.state.joints[f"preload_{k}"]
    levels = world.scratch.solver.free_motions.substep_level
    miss, longest = 0.0, max(1.0, *(arm for joint in part.joints for arm in arms(joint)))
    after = replace(part, pose=part.pose.copy(), velocity=part.velocity.copy())
    for group in parts(world):
        one = _only(part, group)
        count = 1 << int(levels[group[0]])
        one.before, one.after = one.before / count, one.after / count  # the table has them as of level 0
        columns = [3 * k + i for k in group for i in range(3)]
        rows = [part.rows.index(row) for row in one.rows]
        for _ in substeps(one, pull, SECONDS / count, count):
            fast = float(np.max(np.abs(one.velocity[columns])))
            miss += 2.0 * longest * SECONDS / count * one.reach * (one.reach + fast)
        after.pose[columns], after.velocity[columns] = one.pose[columns], one.velocity[columns]
        after.before[rows], after.after[rows] = count * one.before, count * one.after
    return after, miss


def _only(part: Jointed, group: list[int]) -> Jointed:
    """The rows that act on some bodies."""
    lines = jacobian(part.pose, part.joints, part.rows)
    columns = [3 * k + i for k in group for i in range(3)]
    kept = [r for r in range(len(part.rows)) if np.any(lines[r, columns] != 0.0)]
    rows = [part.rows[r] for r in kept]
    return replace(part, rows=rows, before=part.before[kept], after=part.after[kept])


def solver_jacobian(world: World, rows: list[tuple[int, int]]) -> tuple[list[int], Array]:
    """Rows that the solver worked on last, and all its rows as a dense matrix, in which only these are set."""
    memory: Array = world.scratch.joints.direct.memory  # type: ignore[union-attr]
    dense = np.zeros((len(rows), 3 * len(world.names)))
    numbers = []
    for row in (row for row in lane_rows(world) if row.last):
        number = rows.index((row.joint, row.slot))
        numbers.append(number)
        for k, body in enumerate(row.bodies):
            if body >= 0:
                first = row.place + at.JACOBIAN + k * at.SIDE
                dense[number, 3 * body : 3 * body + 3] += memory[[first, first + WIDTH, first + 2 * WIDTH]]
    return numbers, dense


@given(linkages(list(KINDS)), st.sampled_from([0.0, 0.03, 0.2, 3.0]), st.floats(-3.0, 3.0))
@examples(100)
def test_rows_are_the_derivatives_of_what_joints_hold(linkage, way, angle):
    """Also where something has torn the joints apart."""
    world = linkage.world()
    last = world.body(world.names[-1])
    last.position = last.position[0] + way * np.cos(angle), last.position[1] + way * np.sin(angle)
    world.step()
    part = twin(world)
    (numbers, found), wanted = solver_jacobian(world, part.rows), jacobian(part.pose, part.joints, part.rows)
    assert numbers
    assert found[numbers] == pytest.approx(wanted[numbers], abs=1e-9 * (1.0 + np.abs(wanted).max()))


@given(linkages(FREE))
@examples(100)
def test_joints_without_bounds_move_as_the_dense_system_says(linkage):
    world = linkage.world()
    for _ in range(4):
        both = step_both(world)
        assume(both is not None)
        wanted, _ = both
        found = twin(world)
        assert found.pose == pytest.approx(wanted.pose, abs=1e-10)
        assert found.velocity == pytest.approx(wanted.velocity, abs=1e-9)
        assert found.before + found.after == pytest.approx(wanted.before + wanted.after, abs=1e-8)


@given(linkages(FREE + BOUND))
@examples(100)
def test_bounds_are_met_where_going_through_all_of_them_says(linkage):
    """The solver stops turning when it knows which bounds are met, before Newton's method has converged."""
    world = linkage.world()
    for _ in range(4):
        both = step_both(world)
        assume(both is not None)
        wanted, miss = both
        found = twin(world)
        assert found.pose == pytest.approx(wanted.pose, abs=SECONDS * (1e-6 + miss))
        assert found.velocity == pytest.approx(wanted.velocity, abs=1e-6 + 4.0 * miss)


@given(linkages(FREE + BOUND))
@examples(100)
def test_after_the_move_every_row_is_on_its_law(linkage):
    """That pass is linear: the impulses of the twin are those of the solver to rounding, also at bounds."""
    bounded = [tuple(bodies) for kind, *bodies in linkage.joints if kind in BOUND]
    assume(len(bounded) == len(set(bounded)))  # no law says how two on the same bodies share what they hold
    world = linkage.world()
    for _ in range(3):
        assume(move_and_relax(world))


def move_and_relax(world: World) -> bool:
    """Step a world, and hold its two passes against the laws; False where the twin knows none for it."""
    part, pull = twin(world), force(world)
    start, before, lines = part.pose, part.velocity, jacobian(part.pose, part.joints, part.rows)
    world.step()
    if not is_plain(world) or world.scratch.solver.free_motions.substep_level.any():
        return False
    part = twin(world)
    part.before = kept_field(world, part.rows, at.IMPULSE)
    moved = before + 0.5 * SECONDS * pull + part.inverse * (lines.T @ part.before)
    assert (part.pose - start) / SECONDS == pytest.approx(moved, abs=1e-9)
    pushes, velocity = after_the_move(part, moved + 0.5 * SECONDS * pull, SECONDS)
    assert kept_field(world, part.rows, at.RELAXING) == pytest.approx(pushes, abs=1e-8)
    assert part.velocity == pytest.approx(velocity, abs=1e-8)
    return True


def test_a_motor_drives_away_from_a_stop_it_has_been_thrown_at():
    """The impulses of a row that changes from its stop to its motor have to be found anew."""
    still, down, back = (0.0, 0.0, 0.0), (0.0, -1.0, 0.0), (-1.0, 0.3, 0.0)
    places = (0.0, 0.0, 0.0), (1.2, 0.0, 0.0), (2.4, 0.0, 0.0)
    hinges = ("revolute", -1, 0), ("revolute motor stops", 0, 1), ("revolute", 1, 2)
    world = Linkage(places, (down, back, still), (1.0, 1.0, 1.0), hinges).world()
    for _ in range(4):
        both = step_both(world)
        if both is None:
            pytest.fail("the example says nothing")
        wanted, miss = both
        found = twin(world)
        assert found.pose == pytest.approx(wanted.pose, abs=SECONDS * (1e-6 + miss))
        assert found.velocity == pytest.approx(wanted.velocity, abs=1e-6 + 4.0 * miss)


def test_a_motor_between_stops_is_on_its_law_after_the_move():
    """The same in the pass that follows the move: one body is thrown at a rope."""
    still, back = (0.0, 0.0, 0.0), (-1.0, 0.0, 0.0)
    places = (0.0, 0.0, 0.0), (1.2, 0.0, 0.0), (2.4, 0.0, 0.0)
    joints = ("revolute motor stops", 0, 1), ("distance rope", 1, 2)
    world = Linkage(places, (still, back, still), (0.3, 0.3, 0.3), joints).world()
    for _ in range(3):
        if not move_and_relax(world):
            pytest.fail("the example says nothing")


def test_a_gear_between_a_stop_and_a_motor_is_on_its_law_after_the_move():
    """One body spins at a stop, and the gear hands that on to a motor."""
    still, spinning = (0.0, 0.0, 0.0), (0.0, 0.0, 2.0)
    places = (0.0, 0.0, 0.0), (1.2, 0.0, 0.0), (2.4, 0.0, 0.0)
    joints = ("revolute stops", 0, 1), ("revolute motor", 1, 2)
    world = Linkage(places, (spinning, still, still), (0.3, 0.3, 0.3), joints, gear=True).world()
    for _ in range(3):
        if not move_and_relax(world):
            pytest.fail("the example says nothing")

"""Joints that come and go: the tables of the solver are those of a world that is assembled anew."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.pair_filter import JointFilter
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records, plain
from tests.examples import examples

POSTS = [
    {"id": f"post-{k}", "type": "static", "shapes": [{"circle": 0.1}], "position": [40.0 * k, 9]} for k in range(2)
]
COLUMNS: dict[str, tuple[str, ...]] = {
    "members": ("part",),
    "constraints": ("joint", "part", "constraint_1", "constraint_2", "first_row", "row_count", "in_lane"),
    "rows": ("constraint", "slot", "sides"),
    "parts": (
        "first_row", "row_end", "first_constraint", "constraint_end", "direct", "layout", "first_fixed", "anchored",
        "hung", "swept", "first_block", "block_end",
    ),
}  # fmt: skip
"""What does not change as a world is stepped, and does not name members."""
SEATS = {"constraints": ("member_a", "member_b"), "rows": tuple(f"member_{k}" for k in (1, 2, 3, 4))}


def ball(name: str, x: float, y: float) -> dict[str, Any]:
    return {"id": name, "shapes": [{"circle": 0.2}], "position": [x, y]}


def chain(name: str, x: float, links: int, post: str | None) -> tuple[list[Any], list[Any]]:
    """Balls on hinges, some with stops or springs; the first hangs from a post, if there is one."""
    balls = [ball(f"{name}-{k}", x + k, 9.0) for k in range(links)]
    ends = [(post, balls[0]["id"])] if post else []
    ends += [(a["id"], b["id"]) for a, b in pairwise(balls)]
    joints: list[dict[str, Any]] = []
    for k, (a, b) in enumerate(ends):
        more: dict[str, Any] = ({}, {"lower": -30, "upper": 30}, {"hertz": 2})[k % 3]
        joints.append({"id": f"{name}-j{k}", "type": "revolute", "bodies": [a, b], "anchor": [x + k - 0.5, 9], **more})
    return balls, joints


def geared(name: str, x: float, _: int, post: str | None) -> tuple[list[Any], list[Any]]:
    """Two wheels that a gear couples."""
    wheels = [ball(f"{name}-{k}", x + 2.0 * k, 5.0) for k in range(2)]
    joints: list[Any] = [
        {"id": f"{name}-h{k}", "type": "revolute", "bodies": [post, wheels[k]["id"]], "anchor": wheels[k]["position"]}
        for k in range(2)
    ]
    return wheels, [*joints, {"id": f"{name}-gear", "type": "gear", "joints": [f"{name}-h0", f"{name}-h1"]}]


def loose(name: str, x: float, size: int, _: str | None) -> tuple[list[Any], list[Any]]:
    """Balls that nothing holds, until they are tied."""
    return [ball(f"{name}-{k}", x + 2.0 * k, 2.0) for k in range(2 * size)], []


def net(name: str, x: float, size: int, _: str | None) -> tuple[list[Any], list[Any]]:
    """Balls tied to those beside and below them: too dense to be factorised, once there are enough."""
    size *= 3
    balls = [ball(f"{name}-{i}-{k}", x + 0.5 * i, 20.0 + 0.5 * k) for i in range(size) for k in range(size)]
    joints = []
    for i in range(size):
        for k in range(size):
            for a, b in ((i + 1, k), (i, k + 1)):
                if a < size and b < size:
                    anchor = [x + 0.25 * (i + a), 20.0 + 0.25 * (k + b)]
                    both = [f"{name}-{i}-{k}", f"{name}-{a}-{b}"]
                    joints.append({"id": f"{name}-{i}-{k}-{a}", "type": "revolute", "bodies": both, "anchor": anchor})
    return balls, joints


def check(world: sandbox.World) -> None:
    """The solver's tables are those that would be found now."""
    state, scratch = world.state, world.scratch
    joint_filter, work = assemble(state.joints, state.bodies, PartLayouts(), scratch.room.bodies)
    same_bonds(scratch.joint_filter, joint_filter)
    assert (scratch.joints is None) == (work is None)
    if work is not None and scratch.joints is not None:
        same_work(scratch.joints, work)
        layouts = world._stepper._joints.layouts
        assert len(layouts.parts) == len(work.parts)
        assert sorted(layouts.known) == sorted(dict.fromkeys(layouts.parts))


def same_bonds(ours: JointFilter, theirs: JointFilter) -> None:
    assert ours.bonds.tobytes() == theirs.bonds.tobytes()
    assert ours.first.tolist() == theirs.first.tolist()


def same_work(ours: JointWork, theirs: JointWork) -> None:
    assert ours.ties.tobytes() == theirs.ties.tobytes()
    assert ours.part_of.tolist() == theirs.part_of.tolist()
    for table, columns in COLUMNS.items():
        for column in columns:
            assert plain(getattr(ours, table))[column].tolist() == plain(getattr(theirs, table))[column].tolist(), (
                column
            )
    # Members that joints cannot move may be in another order; which row is the world's is told in each step.
    assert sorted(ours.members.body[1:]) == sorted(theirs.members.body[1:])
    for table, names in SEATS.items():
        for name in names:
            assert seated(ours, getattr(ours, table), name) == seated(theirs, getattr(theirs, table), name)
    for name in ("first_member", "member_end"):
        assert plain(ours.parts)[name].tolist() == plain(theirs.parts)[name].tolist()
    same_batches(ours.direct, theirs.direct)
    ours_aside, theirs_aside = ours.side_by_side, theirs.side_by_side
    for name in ("first", "count", "place", "kind", "before", "left"):  # the rest is written in each step
        assert plain(ours_aside.blocks)[name].tolist() == plain(theirs_aside.blocks)[name].tolist(), name
    assert ours_aside.joints.joint.tolist() == theirs_aside.joints.joint.tolist()
    for name in ("member_a", "member_b"):
        assert seated(ours, ours_aside.joints, name) == seated(theirs, theirs_aside.joints, name)
    assert len(ours_aside.lanes) == len(theirs_aside.lanes)


def same_batches(ours: Batches, theirs: Batches) -> None:
    """The same layouts, the same bodies on fixed sides, and at least as much memory."""
    for name in ("layouts", "layout_frames", "equations", "entries", "products", "targets", "fixed"):
        assert getattr(ours, name).tolist() == getattr(theirs, name).tolist(), name
    assert ours.found[3] == theirs.found[3]  # where the memory of batches begins
    for name in ("batches", "open", "parts", "bodies", "memory"):
        assert len(getattr(ours, name)) >= len(getattr(theirs, name)), name


def seated(work: JointWork, table: Records, name: str) -> list[int]:
    """The bodies behind a column of members; -1 for the world."""
    members = plain(table)[name]
    bodies: list[int] = np.where(members == 0, -1, work.members.body[members]).tolist()
    return bodies


KINDS = {"chain": chain, "geared": geared, "loose": loose, "net": net}
comings = st.tuples(
    st.just("spawn"), st.sampled_from(sorted(KINDS)), st.integers(1, 3), st.sampled_from([None, "post-0", "post-1"])
)
goings = st.tuples(st.sampled_from(["delete", "part", "break", "step", "tie"]), st.integers(0, 10**6))


@given(st.lists(st.one_of(comings, goings), min_size=1, max_size=12), st.booleans())
@examples(80)
def test_tables_are_those_of_an_assembly_from_nothing(changes: list[Any], at_once: bool) -> None:
    world = sandbox.World(sandbox.Scene(bodies=POSTS))
    for turn, (what, *how) in enumerate(changes):
        if what == "spawn":
            kind, size, post = how
            held = post if post in world.names else None
            world.spawn(*KINDS[kind](f"{kind}-{turn}", 60.0 * turn, size, held))
        else:
            change(world, what, how[0], turn)
        if not at_once:
            check(world)
    check(world)


def change(world: sandbox.World, what: str, number: int, turn: int) -> None:
    """Take out some bodies or joints, or change one."""
    if what == "step":
        world.step(number % 3)
    elif what == "delete":
        names = sorted({name.rsplit("-", 1)[0] for name in world.names})
        group = names[number % len(names)] if names else ""
        gone = [name for name in world.names if name.startswith(group) and (number % 2 or name != world.names[-1])]
        if gone:
            world.delete(gone)
    elif what == "part" and world.joint_names:
        world.apply(sandbox.DeleteJoint(world.joint_names[number % len(world.joint_names)]))
    elif what == "break" and world.joint_names:
        name = world.joint_names[number % len(world.joint_names)]
        world.apply(sandbox.SetJoint(name, enabled=not world.joint(name).enabled))
    elif what == "tie":
        free = [name for name in world.names if not name.startswith("post")]
        if len(free) > 1:
            both = [free[number % len(free)], free[(number + 1) % len(free)]]
            world.spawn(joints={"id": f"tie-{turn}", "type": "weld", "bodies": both, "anchor": [0, 0]})


def test_all_that_is_done_before_a_step_is_assembled_once(monkeypatch: pytest.MonkeyPatch) -> None:
    world = sandbox.World(sandbox.Scene(bodies=POSTS))
    for number in range(4):
        world.spawn(*chain(f"rope{number}", 20.0 * number, 3, None))
    calls: list[int] = []
    monkeypatch.setattr(
        "sandbox.engine.memory.joint_keeper.assemble", lambda *given: calls.append(1) or assemble(*given)
    )
    for name in world.joint_names:
        world.joint(name).enabled = False
    world.joint(world.joint_names[0]).delete()
    world.joint(world.joint_names[1]).enabled = True
    world.spawn(joints={"id": "tie", "type": "weld", "bodies": ["rope0-0", "rope2-0"], "anchor": [0, 0]})
    assert not calls
    world.step()
    check(world)
    assert len(calls) == 1


@pytest.mark.parametrize("kind", sorted(KINDS.keys() - {"loose"}))
def test_what_comes_by_itself_leaves_the_others_alone(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    world = sandbox.World(sandbox.Scene(bodies=POSTS))
    world.spawn(*chain("first", 0.0, 3, None))
    again: list[int] = []
    monkeypatch.setattr("sandbox.engine.memory.joint_keeper.assemble", lambda *_: again.append(1))
    world.spawn(*KINDS[kind]("second", 100.0, 2, None))
    world.spawn(ball("alone", 200.0, 0.0))
    world.delete("alone")
    world.delete([name for name in world.names if name.startswith("first")])
    assert not again
    monkeypatch.undo()
    check(world)


def test_who_is_tied_last_may_come_before_all_others() -> None:
    world = sandbox.World(sandbox.Scene(bodies=POSTS))
    world.spawn(*loose("loose", 0.0, 1, None))
    world.spawn(*chain("chain", 10.0, 3, None))
    world.spawn(joints={"id": "tie", "type": "weld", "bodies": ["loose-0", "loose-1"], "anchor": [0, 0]})
    check(world)

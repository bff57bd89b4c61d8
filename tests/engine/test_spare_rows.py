"""Tables with spare rows: what comes moves nothing that is there, but seldom, and takes at most as much again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.bench.memory import table_bytes
from sandbox.engine.commands.set_joint import SetJoint
from sandbox.engine.world import World
from sandbox.tables import aligned_zeros, close_up, joined, longer, plain
from sandbox.world.records import BODY, VERTEX
from tests.engine.test_spawn import GROUND, JOINTS, ZOO, make, same

KEPT = ("bodies", "shapes", "vertices")


def address(array: Any) -> int:
    return int(array.ctypes.data)


def ball(k: int) -> dict[str, Any]:
    return {"id": f"ball-{k}", "shapes": [{"circle": 0.4}], "position": [0, 3.0 + k]}


@given(st.lists(st.one_of(st.integers(0, 9), st.lists(st.booleans(), max_size=12)), max_size=20))
def test_rows_come_and_go_as_in_a_list(changes: list[Any]) -> None:
    rows, expected, moves, most = plain(VERTEX.zeros(0)), [], 0, 0
    for what in changes:
        if isinstance(what, int):
            more = plain(VERTEX.zeros(what))
            more["x"] = np.arange(len(expected), len(expected) + what)
            place, rows = address(rows), longer(rows, more)
            moves += place != address(rows)
            expected += more["x"].tolist()
        else:
            left = np.ones(len(rows), np.bool_)
            left[: len(what)] = what[: len(rows)]
            place = address(rows)
            rows = rows[: close_up(rows, left)]
            assert address(rows) == place
            expected = [value for value, kept in zip(expected, left.tolist(), strict=True) if kept]
        most = max(most, len(expected))
        assert rows["x"].tolist() == expected
        assert rows.dtype is VERTEX.dtype
    assert moves <= 1 + np.log2(max(most, 1))


@given(st.lists(st.integers(0, 4), min_size=1, max_size=6))
def test_joined_tables_have_the_rows_of_all(counts: list[int]) -> None:
    parts = [plain(VERTEX.zeros(count)) for count in counts]
    for k, part in enumerate(parts):
        part["x"] = k + np.arange(len(part)) / 8.0
    whole = joined(parts)
    assert whole.dtype is VERTEX.dtype
    assert whole["x"].tolist() == [x for part in parts for x in part["x"].tolist()]


def test_memory_doubles() -> None:
    rows = plain(BODY.zeros(3))
    rows["mass"] = 1.0, 2.0, 3.0
    rows = longer(rows, rows[:1].copy())
    assert rows.base.nbytes == aligned_zeros(8, BODY.dtype).base.nbytes
    assert rows["mass"].tolist() == [1.0, 2.0, 3.0, 1.0]


def test_what_comes_moves_nothing_that_is_there() -> None:
    world = World(sandbox.Scene(bodies=[GROUND]))
    tables: dict[str, set[int]] = {name: set() for name in KEPT}
    motions, most = set(), 300
    for k in range(most):
        world.spawn(ball(k))
        for name, places in tables.items():
            places.add(address(getattr(world.state, name)))
        motions.add(address(world.scratch.solver.motions))
    assert all(len(places) <= 1 + np.log2(most) for places in (*tables.values(), motions))
    full = table_bytes(world)
    for k in range(most):
        world.delete(f"ball-{k}")
        world.spawn(ball(most + k))
    assert table_bytes(world) == full
    written = World(world.flat)
    same(world, written)
    assert full < 2.2 * table_bytes(written)


def test_nobody_is_asked_again_for_one_that_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    world = make(ZOO, JOINTS)
    world.spawn(ball(0))
    world.spawn(ball(1))
    census, calls = world.state.census, world._stepper.calls._calls
    held = (id(census.bodies.items), id(census.bodies.names), dict(calls))
    for name in ("renew", "assemble_joints", "_prepare_calls"):
        monkeypatch.setattr(world._stepper, name, lambda *_: pytest.fail("made anew"))
    monkeypatch.setattr("sandbox.engine.memory.joint_keeper.assemble", lambda *_: pytest.fail("made anew"))
    monkeypatch.setattr("sandbox.engine.events.event_log.find_events", lambda *_: pytest.fail("worked out"))
    monkeypatch.setattr("sandbox.world.patterns.build_patterns", lambda *_: pytest.fail("built again"))
    monkeypatch.setattr("sandbox.world.tiling.find_tiles", lambda *_: pytest.fail("looked for"))
    world.spawn(ball(2))
    now = (id(census.bodies.items), id(census.bodies.names), dict(calls))
    assert now == held
    assert world.names[-1] == "ball-2"
    assert world.body("ball-2").position == (0.0, 5.0)


def test_events_are_those_of_the_last_step_whoever_comes_before_they_are_asked() -> None:
    worlds = [make(ZOO, JOINTS) for _ in range(2)]
    for step in range(60):
        for world in worlds:
            world.step()
        told = worlds[0].events
        for world in worlds:
            goal = {
                "id": f"goal-{step}",
                "type": "static",
                "shapes": [{"circle": 0.4, "sensor": True}],
                "position": [0, 1],
            }
            tie = {"id": f"tie-{step}", "type": "weld", "bodies": ["crate", f"ball-{step}"], "anchor": [0, 1]}
            world.spawn([ball(step), goal], tie if step % 20 == 0 else ())
        late = worlds[1].events
        assert [*late] == [*told]
        assert (late.names, late.joint_names) == (told.names, told.joint_names)
        for world in worlds:
            world.delete([f"ball-{step}", f"goal-{step}"])
    assert worlds[0].digest() == worlds[1].digest()


HOOK = {"id": "hook", "type": "revolute", "bodies": ["hung"], "anchor": [40, 5]}
HUNG = {"id": "hung", "shapes": [{"box": [0.3, 0.3]}], "position": [40, 4.5]}
CHANGES: dict[str, Callable[[World], None]] = {
    "a ball comes": lambda world: world.spawn(ball(2)),
    "a ball goes": lambda world: world.delete("ball-0"),
    "a joint comes": lambda world: world.spawn(HUNG, joints=HOOK),
    "a joint is switched": lambda world: world.apply(SetJoint(JOINTS[0]["id"], enabled=False)),
}


FIELDLESS = [body for body in ZOO if "thrusters" not in body]


def _with_two_balls(bodies: list[dict[str, Any]]) -> World:
    world = make(bodies, JOINTS)
    world.spawn([ball(0), ball(1)])
    world.step(10)
    return world


@pytest.mark.parametrize("bodies", [ZOO, FIELDLESS], ids=["with fields", "without"])
@pytest.mark.parametrize("change", CHANGES)
def test_calls_take_rows_that_are_others_without_being_filled_anew(
    change: str, bodies: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    world, anew = _with_two_balls(bodies), _with_two_balls(bodies)
    with monkeypatch.context() as patch:
        patch.setattr(world._stepper, "_prepare_calls", lambda *_: pytest.fail("all calls filled anew"))
        CHANGES[change](world)
    # Fields have the table of joints by itself.
    assert world._stepper.calls.bound or (bodies is ZOO and change != "a ball comes")
    CHANGES[change](anew)
    anew._stepper._prepare_calls()
    for _ in range(5):
        world.step(10)
        anew.step(10)
        assert world.digest() == anew.digest()

"""A game comes out the same, to the bit: run again, from a snapshot, as a copy, from a recording."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.commands.control import Control
from sandbox.engine.world import World
from sandbox.errors import SnapshotError
from sandbox.replay.golden.rerun import rerun
from sandbox.replay.player import Player
from sandbox.replay.recording.recorder import record
from sandbox.scene import Scene
from sandbox.world.records import TABLES
from sandbox.world.rule_records import SENSING
from tests.examples import examples
from tests.rules.games import BREAKOUT, breakout

STEPS = 150
TABLE_NAMES = {
    "controls": "control", "tallies": "tally", "rules": "rule", "spawners": "spawner", "paths": "path",
    "outcome": "outcome", "sensings": "sensing",
}  # fmt: skip
SCENE = Scene(**BREAKOUT)
places = st.tuples(st.floats(-4, 4), st.floats(-4, 4))
controls = st.builds(
    Control,
    st.sampled_from(["move", "serve", "nudge"]),
    st.sampled_from([0.0, 0.0, 1.0, -1.0, 0.5]),
    st.none() | places,
)
plays = st.lists(st.tuples(st.integers(0, STEPS), controls), max_size=40).map(lambda rows: sorted(rows, key=_step))


def _step(row: tuple[int, Any]) -> int:
    return row[0]


def play(world: World, script: list[tuple[int, Control]], until: int = STEPS) -> list[str]:
    """Go on to a step; the digests after each."""
    digests = []
    while world.step_count < until:
        for step, command in script:
            if step == world.step_count:
                world.apply(command)
        world.step()
        digests.append(world.digest())
    return digests


@given(plays)
@examples(25)
def test_the_same_play_gives_the_same_bits(script: list[tuple[int, Control]]):
    one, two = World(SCENE), World(SCENE)
    assert play(one, script) == play(two, script)
    assert (one.counters, one.outcome, one.controls) == (two.counters, two.outcome, two.controls)
    assert list(one.events) == list(two.events)


@given(plays, st.integers(1, STEPS - 1), st.sampled_from(["snapshot", "copy", "pickle"]))
@examples(40)
def test_a_game_goes_on_to_the_same_bits_from_anywhere(script: list[tuple[int, Control]], middle: int, how: str):
    whole = World(SCENE)
    play(whole, script, middle)
    if how == "snapshot":
        again = World(SCENE)
        play(again, script[::2], middle // 2)  # what it knows of another game is forgotten
        again.restore(whole.snapshot())
    else:
        again = copy.deepcopy(whole) if how == "copy" else pickle.loads(pickle.dumps(whole))
    assert play(again, script) == play(whole, script)
    assert (again.counters, again.outcome, again.names) == (whole.counters, whole.outcome, whole.names)


@given(plays)
@examples(3)
def test_a_recording_of_a_game_holds_what_the_player_did_and_replays(script: list[tuple[int, Control]]):
    recording = record(SCENE, STEPS, script)
    assert [type(command) for _, command in recording.commands] == [Control] * len(script)
    assert rerun(recording, heavy=True).passed


def test_much_happens_in_that_game():
    script = [(5, Control("serve")), (20, Control("serve", 0.0)), (40, Control("serve")), (60, Control("move", -1.0))]
    kinds: set[str] = set()
    world = World(SCENE)
    while world.step_count < 600:
        play(world, script, world.step_count + 1)
        kinds |= {event["event"] for event in world.events}
    assert kinds >= {"hit", "begin", "end", "enter", "counter", "spawn", "delete", "win"}
    assert world.outcome is not None
    assert world.outcome.result == "won"


def test_a_player_goes_back_and_forth():
    script = [(10, Control("serve")), (30, Control("move", 1.0)), (80, Control("move", 0.0))]
    recording = record(SCENE, STEPS, script)
    player = Player(recording)
    player.seek(STEPS)
    end = player.world.digest()
    for step in (120, 15, 31, 79, STEPS):
        player.seek(step)
    assert player.world.digest() == end == recording.digest


def test_workers_make_no_difference():
    one, two = World(SCENE), World(SCENE, workers=2)
    assert play(one, []) == play(two, [])


def test_every_table_of_play_is_in_the_digest_and_the_snapshot():
    world = breakout()
    world.apply(Control("serve"))
    world.step(200)
    fresh = World(SCENE)
    fresh.restore(world.snapshot())
    for name in ("controls", "tallies", "rules", "spawners", "paths", "outcome"):
        table = getattr(world.state, name)
        assert len(table), name
        assert getattr(fresh.state, name).tobytes() == table.tobytes(), name
        for field in table.dtype.names:
            before = table[field][0]
            table[field][0] = before + 1
            assert world.digest() != fresh.digest(), (name, field)
            table[field][0] = before
    assert world.digest() == fresh.digest()


@pytest.mark.parametrize("name", ["controls", "tallies", "rules", "spawners", "paths", "outcome", "sensings"])
def test_a_snapshot_whose_numbers_are_all_it_may_hold_can_be_gone_on_from(name: str):
    world = breakout()
    world.apply(Control("serve"))
    world.step(90)
    world.state.sensings = SENSING.zeros(1)
    table = next(table for table in TABLES if table.name == TABLE_NAMES[name])
    sizes = {each.name: len(array) for each, array in zip(TABLES, world.state.arrays, strict=True)}
    for field in table.fields:
        values, column = field.values, getattr(world.state, name)[field.name]
        kept = column.copy()
        for extreme in (values.low, values.highest(sizes)):
            column[:] = extreme
            fresh = World(SCENE)
            fresh.restore(world.snapshot())
            fresh.step(3)
            assert fresh.outcome is None or isinstance(fresh.outcome.text, str)
            assert len(fresh.controls) == 3
        column[:] = kept


def test_a_snapshot_of_another_game_is_refused():
    other = breakout(counters={"score": 0, "balls": 1, "more": 2})
    with pytest.raises(SnapshotError, match="the snapshot holds 3 tally rows, this world 2"):
        breakout().restore(other.snapshot())

"""A session as it is played: rewinding, other futures, undo and redo, all to the bits of a straight run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox import ApplyImpulse, ArgumentError, Delete, EndDrag, MoveDrag, SetGravity, Spawn, StartDrag
from sandbox.replay.moment import Future, Moment, Past
from sandbox.replay.recording.tape import Tape
from sandbox.replay.timeline import Timeline
from tests.examples import examples

SCENE = sandbox.Scene(
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]},
        {"id": "ball", "shapes": [{"circle": 0.5}], "position": [0.2, 3]},
    ],
)
BALL = {"shapes": [{"circle": 0.3}], "position": [1, 4]}


def straight(timeline: Timeline) -> str:
    """The digest of a fresh world that takes the timeline's run up to where it stands."""
    world = sandbox.World(timeline.scene)
    applied = timeline.run.commands[: timeline._stepper.applied]
    for step in range(timeline.step_count + 1):
        for when, command in applied:
            if when == step:
                world.apply(command)
        if step < timeline.step_count:
            world.step()
    return world.digest()


def play(timeline: Timeline, steps: int) -> None:
    for _ in range(steps):
        timeline.step()


def test_any_step_has_the_bits_of_a_straight_run() -> None:
    timeline, world = Timeline(SCENE), sandbox.World(SCENE)
    digests = [world.digest()]
    for _ in range(60):
        timeline.step()
        world.step()
        digests.append(world.digest())
    for step in (59, 58, 3, 0, 60, 31, 30):
        timeline.seek(step)
        assert timeline.world.digest() == digests[step]
        assert timeline.length == 60


def test_a_step_that_is_not_known_is_refused() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 5)
    for step in (-1, 6):
        with pytest.raises(ArgumentError, match="0 to 5"):
            timeline.seek(step)


def test_an_act_in_the_past_begins_another_future_and_undo_brings_the_old_one_back() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 50)
    last = timeline.world.digest()
    timeline.seek(20)
    timeline.begin_act("Push")
    timeline.apply(ApplyImpulse("crate", (9.0, 2.0)))
    assert timeline.length == 20
    play(timeline, 10)
    pushed = timeline.world.digest()
    assert timeline.undo() == "Push"
    assert (timeline.step_count, timeline.length) == (20, 50)
    timeline.seek(50)
    assert timeline.world.digest() == last
    assert timeline.redo() == "Push"
    assert (timeline.step_count, timeline.length) == (30, 30)
    assert timeline.world.digest() == pushed
    assert timeline.redo() is None


def test_a_refused_command_costs_no_future() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 30)
    timeline.seek(10)
    with pytest.raises(sandbox.UnknownBodyError):
        timeline.apply(Delete("crtae"))
    assert timeline.length == 30


def test_an_act_of_which_nothing_came_is_none_and_costs_no_redo() -> None:
    timeline = Timeline(SCENE)
    timeline.begin_act("Push")
    timeline.apply(ApplyImpulse("ball", (3.0, 0.0)))
    timeline.end_act()
    assert timeline.undo_label == "Push"
    timeline.undo()
    timeline.begin_act("Delete")
    with pytest.raises(sandbox.UnknownBodyError):
        timeline.apply(Delete("nobody"))
    timeline.end_act()
    assert (timeline.undo_label, timeline.redo_label) == (None, "Push")


def test_a_restart_can_be_undone() -> None:
    timeline = Timeline(SCENE)
    timeline.begin_act("Push")
    timeline.apply(ApplyImpulse("ball", (3.0, 0.0)))
    play(timeline, 25)
    pushed = timeline.world.digest()
    timeline.begin_again()
    assert (timeline.step_count, timeline.length) == (0, 0)
    assert timeline.world.digest() == sandbox.World(SCENE).digest()
    assert timeline.undo() == "Restart"
    assert timeline.world.digest() == pushed


def test_acts_at_one_step_are_undone_one_by_one() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 3)
    digests = [timeline.world.digest()]
    for n in range(3):
        timeline.begin_act(f"Spawn {n}")
        timeline.apply(Spawn({"id": f"new-{n}", **BALL, "position": [n, 6]}))
        digests.append(timeline.world.digest())
    for n in (2, 1, 0):
        assert timeline.undo() == f"Spawn {n}"
        assert timeline.world.digest() == digests[n]
    assert timeline.undo_label is None
    for n in (0, 1, 2):
        assert timeline.redo() == f"Spawn {n}"
        assert timeline.world.digest() == digests[n + 1]


def test_redo_after_playing_on_from_the_undone_moment() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 20)
    timeline.begin_act("Push")
    timeline.apply(ApplyImpulse("ball", (3.0, 0.0)))
    play(timeline, 30)
    pushed = timeline.world.digest()
    timeline.undo()
    play(timeline, 15)  # past the act, not as far as the moment that redo leads to
    timeline.redo()
    assert timeline.step_count == 50
    assert timeline.world.digest() == pushed


def test_what_is_adjusted_while_time_stands_is_one_command() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 4)
    timeline.begin_act("Gravity")
    mark = timeline.mark()
    for strength in (1.0, 2.0, 3.0, 4.0):
        timeline.amend(mark, SetGravity((0.0, -strength)))
    assert timeline.run.commands == ((4, SetGravity((0.0, -4.0))),)
    assert timeline.world.digest() == straight(timeline)


def test_what_the_last_step_told_stays_while_something_is_adjusted() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 1)
    while not len(timeline.world.events.begin):
        play(timeline, 1)
    told, impulses = timeline.world.events.begin.tolist(), timeline.world.contact_impulses.tolist()
    assert max(impulses) > 0.0
    timeline.begin_act("Gravity")
    mark = timeline.mark()
    for strength in (1.0, 2.0):
        timeline.amend(mark, SetGravity((0.0, -strength)))
        assert timeline.world.events.begin.tolist() == told
        assert timeline.world.contact_impulses.tolist() == impulses


def test_a_drag_that_the_lost_future_would_have_ended_ends() -> None:
    timeline = Timeline(SCENE)
    timeline.apply(StartDrag("ball", (0.2, 3.0)))
    play(timeline, 10)
    timeline.apply(MoveDrag("ball", (2.0, 5.0)))
    play(timeline, 10)
    timeline.apply(EndDrag("ball"))
    play(timeline, 10)
    timeline.seek(15)
    timeline.apply(SetGravity((0.0, 0.0)))
    assert not [drag for drag in timeline.world.state.drags if drag.body >= 0]
    play(timeline, 5)
    assert timeline.world.digest() == straight(timeline)
    assert sandbox.rerun(timeline.recording()).passed


def test_a_rewound_session_saves_all_that_is_known_and_stays_where_it_is() -> None:
    timeline = Timeline(SCENE)
    timeline.apply(ApplyImpulse("ball", (1.0, 0.0)))
    play(timeline, 40)
    timeline.seek(12)
    here = timeline.world.digest()
    recording = timeline.recording()
    assert (recording.steps, timeline.step_count, timeline.world.digest()) == (40, 12, here)
    assert sandbox.rerun(recording).passed


def test_a_future_that_was_left_is_kept_and_led_to_with_all_that_was_done_in_it() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 10)
    timeline.begin_act("Push ball")
    timeline.apply(ApplyImpulse("ball", (3.0, 0.0)))
    play(timeline, 20)
    pushed = timeline.world.digest()
    timeline.seek(15)
    timeline.begin_act("Delete crate")
    timeline.apply(Delete("crate"))
    play(timeline, 5)
    deleted = timeline.world.digest()
    timeline.seek(4)
    timeline.begin_act("Push crate")
    timeline.apply(ApplyImpulse("crate", (0.0, 3.0)))
    play(timeline, 30)

    def told() -> list[tuple[str, int | None, int]]:
        return [(branch.label, timeline.parts_from(branch), branch.length) for branch in timeline.branches]

    assert told() == [("Push ball", 4, 30), ("Delete crate", 4, 20)]
    timeline.switch(0)
    assert (timeline.step_count, timeline.length) == (4, 30)
    timeline.seek(30)
    assert timeline.world.digest() == pushed
    assert told() == [("Delete crate", 15, 20), ("Push crate", 4, 34)]
    timeline.switch(0)
    assert timeline.step_count == 15
    timeline.seek(20)
    assert timeline.world.digest() == deleted
    assert sandbox.rerun(timeline.recording()).passed
    while timeline.undo_label != "Push ball":
        timeline.undo()
    assert (told(), timeline.length) == ([], 30)
    with pytest.raises(ArgumentError, match="branch 0 is not one of the 0"):
        timeline.switch(0)


def test_a_restart_keeps_what_was_done_and_nothing_else() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 5)
    timeline.begin_again()
    assert timeline.branches == ()  # it comes out the same
    play(timeline, 5)
    timeline.begin_act("Push ball")
    timeline.apply(ApplyImpulse("ball", (3.0, 0.0)))
    play(timeline, 5)
    pushed = timeline.world.digest()
    timeline.begin_again()
    ((label, length),) = [(branch.label, branch.length) for branch in timeline.branches]
    assert (label, length) == ("Push ball", 10)
    timeline.switch(0)
    timeline.seek(10)
    assert timeline.world.digest() == pushed


def test_a_recording_of_a_run_that_begins_again_has_no_more_than_was_done_by_then() -> None:
    timeline = Timeline(SCENE, [(3, ApplyImpulse("ball", (3.0, 0.0)))], 9)
    play(timeline, 5)
    timeline.begin_again(timeline.commands)
    for steps, commands in ((1, 0), (3, 1)):
        play(timeline, steps)
        recording = timeline.recording()
        assert (recording.steps, len(recording.commands)) == (timeline.step_count, commands)
        assert sandbox.rerun(recording).passed


def test_a_future_that_ends_before_the_other_parts_from_it_is_gone_to_at_its_end() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 3)
    timeline.begin_act("Push ball")
    timeline.apply(ApplyImpulse("ball", (3.0, 0.0)))
    timeline.begin_again()
    timeline.switch(0)
    timeline.switch(0)
    assert (timeline.step_count, timeline.length, timeline.commands) == (0, 0, [])


def test_what_was_seen_before_a_restart_holds_no_more_once_something_is_done() -> None:
    timeline = Timeline(SCENE)
    play(timeline, 20)
    timeline.begin_again()
    timeline.begin_act("Push ball")
    timeline.apply(ApplyImpulse("ball", (3.0, 0.0)))
    assert list(timeline.cuts) == [0]
    play(timeline, 20)
    for step in (9, 20):
        timeline.seek(step)
        assert timeline.world.digest() == straight(timeline)
    assert sandbox.rerun(timeline.recording()).passed


ACTS = st.lists(
    st.one_of(
        st.tuples(st.just("step"), st.integers(1, 12)),
        st.tuples(st.just("seek"), st.floats(0.0, 1.0)),
        st.tuples(st.just("push"), st.sampled_from(["crate", "ball"])),
        st.tuples(st.just("spawn"), st.integers(0, 3)),
        st.tuples(st.just("delete"), st.integers(0, 3)),
        st.tuples(st.just("undo"), st.just(0)),
        st.tuples(st.just("redo"), st.just(0)),
        st.tuples(st.just("again"), st.just(0)),
        st.tuples(st.just("switch"), st.integers(0, 3)),
        st.tuples(st.just("recording"), st.just(0)),
        st.tuples(st.just("recall"), st.just(0)),
    ),
    max_size=14,
)


def unnoted(past: Past) -> Past:
    """What a timeline knows, as it comes from a file: nothing of what was noted of the steps."""
    known: dict[int, Future] = {}

    def future(one: Future) -> Future:
        return known.setdefault(id(one), replace(one, tape=Tape()))

    def moments(stack: Sequence[Moment]) -> list[Moment]:
        return [replace(one, future=future(one.future), branches=tuple(map(future, one.branches))) for one in stack]

    return Past(moments(past.undo), moments(past.redo), tuple(map(future, past.branches)), list(past.deeds))


def act(timeline: Timeline, what: str, value: float | str) -> None:
    match what:
        case "step":
            play(timeline, int(value))
        case "seek":
            timeline.seek(int(float(value) * timeline.length))
        case "undo":
            timeline.undo()
        case "redo":
            timeline.redo()
        case "switch" if int(value) < len(timeline.branches):
            wanted = timeline.branches[int(value)]
            timeline.switch(int(value))
            assert (list(timeline.commands), timeline.length) == (wanted.script(), wanted.length)
        case "again":
            timeline.begin_again()
        case "recall":
            timeline.recall(unnoted(timeline.past))
        case "recording" if timeline.length:
            assert sandbox.rerun(timeline.recording()).passed
        case "push":
            timeline.begin_act("push")
            timeline.apply(ApplyImpulse(str(value), (1.0, 2.0)))
        case "spawn" if f"new-{value}" not in timeline.world.names:
            timeline.begin_act("spawn")
            timeline.apply(Spawn({"id": f"new-{value}", **BALL}))
        case "delete" if f"new-{value}" in timeline.world.names:
            timeline.begin_act("delete")
            timeline.apply(Delete(f"new-{value}"))


@examples(400)
@given(acts=ACTS, budget=st.sampled_from([1 << 14, 1 << 17, 1 << 24]))
def test_whatever_is_done_the_world_is_that_of_a_straight_run(acts: list[tuple[str, float | str]], budget: int) -> None:
    timeline = Timeline(SCENE, budget=budget)
    for what, value in acts:
        act(timeline, what, value)
        assert timeline.world.digest() == straight(timeline)
        assert timeline.step_count <= len(timeline._tape) <= timeline.length
    timeline.seek(timeline.length)
    assert len(timeline._tape) == timeline.length


def test_cuts_say_what_is_no_longer_so() -> None:
    """Whoever keeps the digest of each step, and forgets those after a cut, never holds a wrong one."""
    timeline, kept, seen = Timeline(SCENE), {0: Timeline(SCENE).world.digest()}, 0

    def run(steps: int) -> None:
        nonlocal seen
        for _ in range(steps):
            timeline.step()
            last = min(timeline.cuts[seen:], default=None)
            for step in [] if last is None else [step for step in kept if step > last]:
                del kept[step]
            seen = len(timeline.cuts)
            assert kept.setdefault(timeline.step_count, timeline.world.digest()) == timeline.world.digest()

    run(40)
    timeline.seek(20)
    assert list(timeline.cuts) == []
    timeline.begin_act("Push")
    timeline.apply(ApplyImpulse("crate", (3.0, 0.0)))
    assert list(timeline.cuts) == [20]
    run(15)
    assert 40 not in kept
    timeline.undo()
    run(30)
    timeline.redo()
    run(20)
    timeline.begin_again()
    run(60)
    assert len(kept) == 61

"""Every kind of expectation: a state in which it holds, one in which it does not, and what is said then."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.replay.conditions import Condition
from sandbox.replay.expectation_conditions import conditions
from sandbox.scene import expect
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape
from sandbox.scene.flat_rules import FlatCounter
from sandbox.world.build import build_state
from sandbox.world.state import State

BOX = (FlatShape("box", ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))),)


@pytest.fixture
def state() -> State:
    """A ground and two crates at x = 0 and x = 3, at rest, no contacts."""
    ground = FlatBody("ground", "static", BOX, position=(0.0, -1.0))
    crates = (FlatBody("crate-1", "dynamic", BOX), FlatBody("crate-2", "dynamic", BOX, position=(3.0, 0.0)))
    return build_state(FlatScene((ground, *crates), counters=(FlatCounter("score", 3.0),)))


def fault(wanted: expect.Expectation, state: State, start: State | None = None) -> str | None:
    """The first fault of any condition of `wanted`."""
    faults = [condition.fault(state) for condition in conditions(wanted, start or state)]
    return next((got for got in faults if got is not None), None)


def add_contact(state: State, a: int, b: int, separation: float, impulse: float = 0.0) -> None:
    row = state.contacts[state.counters[0].contact_count]
    row.body_a, row.body_b, row.point_count = a, b, 1
    row.separation1, row.normal_impulse1 = separation, impulse
    state.counters[0].contact_count += 1


def test_rests(state: State) -> None:
    wanted = expect.Rests(at=0, rests="crate-*")
    assert fault(wanted, state) is None
    state.bodies[2].velocity_x, state.bodies[2].velocity_y = 3.0, -4.0
    assert fault(wanted, state) == "crate-2 moves at 5 m/s"
    assert fault(expect.Rests(at=0, rests="crate-1"), state) is None
    assert fault(expect.Rests(at=0, rests="crate-2", tolerance=5.0), state) is None


def test_a_turning_body_does_not_rest(state: State) -> None:
    state.bodies[1].angular_velocity = -0.06
    assert fault(expect.Rests(at=0, rests="crate-1"), state) == "crate-1 turns at 0.06 rad/s"


def test_stands(state: State) -> None:
    wanted = expect.Stands(at=0, stands="crate-1", turned=1.0)
    (moved, turned) = conditions(wanted, state)
    state.bodies[1].position_x = 0.05
    assert moved.fault(state) is None
    state.bodies[1].position_y = 0.05
    assert moved.fault(state) == "crate-1 moved 0.07071 m"
    state.bodies[1].angle = -math.radians(2)
    assert turned.fault(state) == "crate-1 turned 2°"


def test_inside_judges_all_dynamic_bodies_by_default(state: State) -> None:
    assert fault(expect.Inside(always=True, inside=(-1, -0.5, 4, 1)), state) is None
    assert fault(expect.Inside(always=True, inside=(-1, -0.5, 2, 1)), state) == "crate-2 is 1 m outside"
    assert fault(expect.Inside(always=True, inside=(-1, -0.5, 2, 1), of="crate-1"), state) is None
    assert (
        fault(expect.Inside(always=True, inside=(-1, -0.5, 4, 1), of=("ground",)), state) == "ground is 0.5 m outside"
    )


def test_the_worst_body_is_named_and_the_others_counted(state: State) -> None:
    state.bodies.position_y[1:] = [-5.0, -7.0]
    assert fault(expect.Above(at=0, above=-1), state) == "crate-2 is at y = -7 m (and 1 more)"


def test_above_and_below(state: State) -> None:
    assert fault(expect.Above(at=0, above=0), state) is None
    assert fault(expect.Below(at=0, below=0), state) is None
    assert fault(expect.Above(at=0, above=0.1, of="crate-1"), state) == "crate-1 is at y = 0 m"
    assert fault(expect.Below(at=0, below=-0.1, of="crate-1"), state) == "crate-1 is at y = 0 m"


def test_touches_and_apart_need_real_contact(state: State) -> None:
    touches = expect.Touches(at=0, touches=("crate-1", "ground"))
    apart = expect.Apart(at=0, apart=("ground", "crate-1"))
    add_contact(state, 0, 1, separation=0.01)
    assert fault(touches, state) == "they are apart"
    assert fault(apart, state) is None
    state.contacts[0].separation1 = -0.001
    assert fault(touches, state) is None
    assert fault(apart, state) == "1 contacts between them"


def test_a_push_counts_as_touch_even_if_the_gap_opened_again(state: State) -> None:
    add_contact(state, 1, 2, separation=0.02, impulse=0.5)
    assert fault(expect.Touches(at=0, touches=("crate-1", "crate-2")), state) is None
    assert fault(expect.Touches(at=0, touches=("crate-1", "ground")), state) is not None


def test_a_second_point_counts_only_if_it_is_there(state: State) -> None:
    add_contact(state, 0, 1, separation=0.1)
    state.contacts[0].separation2 = -1.0
    wanted = expect.Touches(at=0, touches=("*", "ground"))
    assert fault(wanted, state) is not None
    state.contacts[0].point_count = 2
    assert fault(wanted, state) is None


def test_spare_contact_rows_are_not_contacts(state: State) -> None:
    add_contact(state, 0, 1, separation=-0.1)
    state.counters[0].contact_count = 0
    assert fault(expect.Apart(at=0, apart=("ground", "crate-*")), state) is None


def test_asleep(state: State) -> None:
    wanted = expect.Asleep(at=0, asleep="crate-2")
    assert fault(wanted, state) == "crate-2 is awake"
    state.bodies[2].awake = 0
    assert fault(wanted, state) is None


def test_near(state: State) -> None:
    assert fault(expect.Near(at=0, near=(3.0, 0.04), of="crate-2"), state) is None
    assert fault(expect.Near(at=0, near=(3.0, 2.0), of="crate-2"), state) == "crate-2 is 2 m away"


def test_speed(state: State) -> None:
    state.bodies[1].velocity_x = -2.0
    assert fault(expect.Speeding(at=0, speed=(1.5, 2.0), of="crate-1"), state) is None
    assert fault(expect.Speeding(at=0, speed=(2.5, 3.0), of="crate-1"), state) == "crate-1 moves at 2 m/s"
    assert fault(expect.Speeding(at=0, speed=(0.0, 1.0), of="crate-1"), state) == "crate-1 moves at 2 m/s"


def test_angle_counts_full_turns(state: State) -> None:
    state.bodies[1].angle = 2 * math.pi
    assert fault(expect.Turned(at=0, angle=(359, 361), of="crate-1"), state) is None
    assert fault(expect.Turned(at=0, angle=(-1, 1), of="crate-1"), state) == "crate-1 is at 360°"


def test_counters(state: State) -> None:
    assert fault(expect.CounterIs(at=0, counter="score", equals=3.0), state) is None
    assert fault(expect.CounterIs(at=0, counter="score", least=1.0, most=3.0), state) is None
    for limits, told in [({"equals": 4.0}, "4"), ({"least": 4.0}, "at least 4"), ({"most": 2.0}, "at most 2"),
                         ({"least": 0.0, "most": 2.0}, "in [0, 2]")]:  # fmt: skip
        wanted = expect.CounterIs(at=0, counter="score", **limits)
        assert fault(wanted, state) == "score is 3"
        assert conditions(wanted, state)[0].expected == f"score is {told}"


def test_outcome(state: State) -> None:
    assert fault(expect.Ended(at=0, outcome="open"), state) is None
    assert fault(expect.Ended(at=0, outcome="won"), state) == "it is open"
    state.outcome[0].result = 2
    assert fault(expect.Ended(at=0, outcome="lost"), state) is None
    assert fault(expect.Ended(at=0, outcome="won"), state) == "it is lost"
    assert conditions(expect.Ended(at=0, outcome="won"), state)[0].expected == "the game is won"


@pytest.mark.parametrize("kind", list(expect.CONDITIONS))
def test_every_kind_of_expectation_can_be_judged(kind: str, state: State) -> None:
    values = {
        "inside": (-9, -9, 9, 9),
        "near": (0, 0),
        "speed": (0, 1),
        "angle": (0, 1),
        "above": 0,
        "below": 0,
    }
    others = {"counter": {"counter": "score", "equals": 1.0}, "outcome": {"outcome": "won"}}
    pair = ("crate-1", "ground")
    value = values.get(kind, pair if kind in ("touches", "apart", "senses") else "crate-1")
    subject = {"of": "crate-1"} if kind in values else {}
    fields = others.get(kind, {kind: value, **subject})
    model = expect.CONDITIONS[kind](at=0, **fields)
    assert all(condition.expected for condition in conditions(model, state))  # type: ignore[arg-type]


def test_nan_is_a_fault_of_every_measured_condition(state: State) -> None:
    state.bodies.position_x[1] = np.nan
    for wanted in (
        expect.Inside(at=0, inside=(-9, -9, 9, 9)),
        expect.Stands(at=0, stands="crate-1"),
        expect.Near(at=0, near=(0.0, 0.0), of="crate-1", tolerance=10.0),
    ):
        assert "crate-1" in (fault(wanted, state) or "")


@given(st.lists(st.floats(-10, 10) | st.just(math.nan), min_size=1), st.floats(-5, 0), st.floats(0, 5))
def test_a_condition_agrees_with_its_naive_twin(values: list[float], low: float, high: float) -> None:
    labels = [f"v{k}" for k in range(len(values))]
    condition = Condition(labels, lambda _: np.array(values), "in range", "{name} {value}", low, high)
    bad = [label for label, value in zip(labels, values, strict=True) if not low <= value <= high]
    found = condition.fault(None)  # type: ignore[arg-type]
    assert (found is None) == (not bad)
    if found is not None:
        assert found.split()[0] in bad
        assert ("more" in found) == (len(bad) > 1)

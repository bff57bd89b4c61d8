"""What each kind of expectation demands, one function a kind: its conditions, which must all hold."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox.replay import measures
from sandbox.replay.conditions import Condition
from sandbox.replay.measures import Rows, Values
from sandbox.scene import expect
from sandbox.scene.body_refs import BODY_FIELDS, unmatched
from sandbox.world.records import DYNAMIC
from sandbox.world.state import State


def conditions(wanted: expect.Expectation, start: State) -> list[Condition]:
    """The conditions of `wanted`. `start` is the state that "has not moved" compares with.

    The first of them is that the bodies it names are there: of a deleted one nothing holds.
    """
    return [*_missing(wanted, start), *_CONDITIONS[type(wanted)](wanted, start)]


def _missing(wanted: expect.Expectation, state: State) -> list[Condition]:
    """A condition that cannot hold for each id or pattern that means no body of now."""
    given = [ids for field in BODY_FIELDS if (ids := getattr(wanted, field, None)) is not None]
    names = [name for ids in given for name in unmatched(ids, state.names)]
    return [Condition([name], _nothing, f"{name} is there", _gone(name)) for name in names]


def _gone(name: str) -> str:
    return "no body matches {name} any more" if expect.is_pattern(name) else "{name} has been deleted"


def _nothing(state: State) -> Values:
    return np.array([np.nan])


@dataclass(frozen=True)
class _Bodies:
    """The bodies an expectation speaks of: their rows and, in the same order, their ids."""

    rows: Rows
    labels: Sequence[str]


def _bodies(ids: str | Sequence[str] | None, state: State) -> _Bodies:
    if ids is None:
        rows = np.flatnonzero(state.bodies.type == DYNAMIC)
    else:
        wanted = set(expect.matching_ids(ids, state.names))
        rows = np.array([row for row, name in enumerate(state.names) if name in wanted], dtype=np.int64)
    return _Bodies(rows, [state.names[row] for row in rows])


def _rests(wanted: expect.Rests, start: State) -> list[Condition]:
    them, limit = _bodies(wanted.rests, start), wanted.tolerance
    speed, turning = measures.speed(them.rows), measures.turning(them.rows)
    return [
        Condition(them.labels, speed, f"speed at most {limit:g} m/s", "{name} moves at {value:.4g} m/s", high=limit),
        Condition(
            them.labels,
            turning,
            f"turning at most {limit:g} rad/s",
            "{name} turns at {value:.4g} rad/s",
            high=limit,
        ),
    ]


def _stands(wanted: expect.Stands, start: State) -> list[Condition]:
    them, limit = _bodies(wanted.stands, start), wanted.moved
    x, y = start.bodies.position_x[them.rows], start.bodies.position_y[them.rows]
    moved, text = measures.distance_from(them.rows, x, y), f"moved at most {limit:g} m"
    found = [Condition(them.labels, moved, text, "{name} moved {value:.4g} m", high=limit)]
    if wanted.turned is not None:
        turned, text = (
            measures.turned_from(them.rows, start.bodies.angle[them.rows]),
            f"turned at most {wanted.turned:g}°",
        )
        found.append(Condition(them.labels, turned, text, "{name} turned {value:.4g}°", high=wanted.turned))
    return found


def _inside(wanted: expect.Inside, start: State) -> list[Condition]:
    them = _bodies(wanted.of, start)
    text = "inside [" + ", ".join(f"{side:g}" for side in wanted.inside) + "]"
    measure = measures.outside(them.rows, wanted.inside)
    return [Condition(them.labels, measure, text, "{name} is {value:.4g} m outside", high=0.0)]


def _above(wanted: expect.Above, start: State) -> list[Condition]:
    them, low = _bodies(wanted.of, start), wanted.above
    return [Condition(them.labels, measures.height(them.rows), f"y at least {low:g} m", _AT_HEIGHT, low=low)]


def _below(wanted: expect.Below, start: State) -> list[Condition]:
    them, high = _bodies(wanted.of, start), wanted.below
    return [Condition(them.labels, measures.height(them.rows), f"y at most {high:g} m", _AT_HEIGHT, high=high)]


def _touches(wanted: expect.Touches, start: State) -> list[Condition]:
    first, second = wanted.touches
    return [_contact(first, second, start, f"{first} touches {second}", "they are apart", low=1.0)]


def _apart(wanted: expect.Apart, start: State) -> list[Condition]:
    first, second = wanted.apart
    return [
        _contact(first, second, start, f"{first} and {second} apart", "{value:.0f} contacts between them", high=0.0)
    ]


def _contact(first: str, second: str, start: State, expected: str, got: str, **limits: float) -> Condition:
    measure = measures.touch_count(_bodies(first, start).rows, _bodies(second, start).rows)
    return Condition([f"{first}, {second}"], measure, expected, got, **limits)


def _senses(wanted: expect.Senses, start: State) -> list[Condition]:
    carrier, other = wanted.senses
    measure = measures.sensed_count(_bodies(carrier, start).rows, _bodies(other, start).rows)
    return [Condition([f"{carrier}, {other}"], measure, f"{carrier} senses {other}", "it does not", low=1.0)]


def _asleep(wanted: expect.Asleep, start: State) -> list[Condition]:
    them = _bodies(wanted.asleep, start)
    return [Condition(them.labels, measures.awake(them.rows), "asleep", "{name} is awake", high=0.0)]


def _near(wanted: expect.Near, start: State) -> list[Condition]:
    them, (x, y), limit = _bodies(wanted.of, start), wanted.near, wanted.tolerance
    measure = measures.distance_from(them.rows, x, y)
    text = f"within {limit:g} m of ({x:g}, {y:g})"
    return [Condition(them.labels, measure, text, "{name} is {value:.4g} m away", high=limit)]


def _speed(wanted: expect.Speeding, start: State) -> list[Condition]:
    them, (low, high) = _bodies(wanted.of, start), wanted.speed
    text = f"speed in [{low:g}, {high:g}] m/s"
    return [Condition(them.labels, measures.speed(them.rows), text, "{name} moves at {value:.4g} m/s", low, high)]


def _angle(wanted: expect.Turned, start: State) -> list[Condition]:
    them, (low, high) = _bodies(wanted.of, start), wanted.angle
    text = f"angle in [{low:g}°, {high:g}°]"
    return [Condition(them.labels, measures.angle(them.rows), text, "{name} is at {value:.4g}°", low, high)]


def _counter(wanted: expect.CounterIs, start: State) -> list[Condition]:
    row = [counter.id for counter in start.census.scene.counters].index(wanted.counter)
    low, high = (wanted.least, wanted.most) if wanted.equals is None else (wanted.equals, wanted.equals)
    limits = {} if low is None else {"low": low}
    limits |= {} if high is None else {"high": high}
    text = f"{wanted.counter} is {_range_words(low, high)}"
    return [Condition([wanted.counter], measures.counter(row), text, "{name} is {value:g}", **limits)]


def _range_words(low: float | None, high: float | None) -> str:
    if low is None or high is None:
        return f"at most {high:g}" if low is None else f"at least {low:g}"
    return f"{low:g}" if low == high else f"in [{low:g}, {high:g}]"


def _outcome(wanted: expect.Ended, start: State) -> list[Condition]:
    number = _RESULTS.index(wanted.outcome)
    return [_Outcome([""], measures.outcome, f"the game is {wanted.outcome}", "", float(number), float(number))]


class _Outcome(Condition):
    """A condition on how the game ended, which is told in words."""

    def _describe(self, values: Values, good: Any) -> str:
        return f"it is {_RESULTS[int(values[0])]}"


_RESULTS = ("open", "won", "lost")
_AT_HEIGHT = "{name} is at y = {value:.4g} m"
_CONDITIONS: dict[type[expect.Expectation], Callable[[Any, State], list[Condition]]] = {
    expect.Rests: _rests,
    expect.Stands: _stands,
    expect.Inside: _inside,
    expect.Above: _above,
    expect.Below: _below,
    expect.Touches: _touches,
    expect.Apart: _apart,
    expect.Senses: _senses,
    expect.Asleep: _asleep,
    expect.Near: _near,
    expect.Speeding: _speed,
    expect.Turned: _angle,
    expect.CounterIs: _counter,
    expect.Ended: _outcome,
}

"""What happened during the last step: arrays in a fixed order, worked out only when somebody asks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np

from sandbox.engine.events.happening import HAPPENINGS, Happening
from sandbox.engine.events.pair_keys import differences, pair_keys
from sandbox.engine.events.pending import DeletedPair, PendingEvents, RowLookup
from sandbox.engine.events.records import CONTACT_EVENT, SENSOR_EVENT
from sandbox.tables import Integers, Records, Table, as_table, plain
from sandbox.world.state import State

_NO_CONTACTS, _NO_SENSORS, _NO_BODIES = CONTACT_EVENT.zeros(0), SENSOR_EVENT.zeros(0), np.zeros(0, np.int64)
HIT_SPEED = 1.0
"""Slower contacts are no hits, in m/s, where a unit of length is a metre."""


@dataclass(frozen=True)
class Events:
    """The events of one step, each array sorted by its rows' shapes or bodies.

    `begin` and `end`: shapes began to push or overlap, or came apart by more than the contact margin (2 cm, less for
    small bodies). `hit`: points that did not push before struck at `HIT_SPEED` or more. All three are `CONTACT_EVENT`
    rows; an `end` has neither impulse nor speed. `enter` and `leave`: a sensor has, or no longer has, a shape in
    it (`SENSOR_EVENT` rows). `sleep`, `wake` and `freeze` are body indices,
    `joint_break` are rows of joints: `joint_names[row]`. `happenings` is what rules and controls did, in that order.

    Contacts and sensings of bodies that were deleted before the step come last in `end` and `leave`. `names` are the
    ids of the bodies, and after them those of deleted ones of which these rows speak.
    """

    step: int
    names: tuple[str, ...]
    begin: Records
    end: Records
    hit: Records
    enter: Records
    leave: Records
    sleep: Integers
    wake: Integers
    freeze: Integers
    joint_break: Integers
    joint_names: tuple[str, ...] = ()
    happenings: tuple[Happening, ...] = ()

    @property
    def counts(self) -> dict[str, int]:
        """How many there are of each kind."""
        did = [happening.event for happening in self.happenings]
        return {kind: did.count(kind) if kind in HAPPENINGS else len(getattr(self, kind)) for kind in KINDS}

    def __len__(self) -> int:
        return sum(self.counts.values())

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Every event as plain data: its `event` kind, its `step`, body ids and figures."""
        for kind in _OF_STEPS:
            for words in self._plain(kind):
                yield {"event": kind, "step": self.step, **words}
        for happening in self.happenings:
            yield {"event": happening.event, "step": self.step, **happening.plain()}

    def _plain(self, kind: str) -> Iterator[dict[str, Any]]:
        """The events of a kind of steps as plain data. A whole table is made numbers of Python at once: one by one, the
        fields of its rows take 19 us an event."""
        table, names = getattr(self, kind), self.names
        rows = table.tolist()
        if kind == "joint_break":
            yield from ({"joint": self.joint_names[row]} for row in rows)
        elif table.dtype == CONTACT_EVENT.dtype:
            for a, b, _, _, x, y, *normal, impulse, speed in rows:
                place = {"point": [x, y], "normal": normal, "impulse": impulse, "speed": speed}
                yield {"a": names[a], "b": names[b], **place}
        elif table.dtype == SENSOR_EVENT.dtype:
            yield from ({"sensor": names[sensor], "body": names[body]} for sensor, body, *_ in rows)
        else:
            yield from ({"body": names[row]} for row in rows)


_OF_STEPS = tuple(field.name for field in fields(Events))[2:-2]
KINDS = (*_OF_STEPS, *HAPPENINGS)
"""The kinds of events: those of steps in the order in which they are told, then those of rules."""


class LastStep(NamedTuple):
    """What a step leaves for its events: the contacts of the step `before` it, the `reports` of its own, and what
    sensors overlapped before and after it. `in_doubt` are the rows of both contacts that may differ, if that is known:
    those of sleepers do not."""

    before: Records
    reports: Records
    sensed: tuple[Records, Records]
    in_doubt: tuple[Integers, Integers] | None


def no_events(step: int, names: tuple[str, ...]) -> Events:
    """The events of a step in which nothing happened."""
    contact, sensor, body = _NO_CONTACTS, _NO_SENSORS, _NO_BODIES
    return Events(step, names, contact, contact, contact, sensor, sensor, body, body, body, body)


def find_events(
    state: State,
    rows: tuple[int, tuple[str, ...]],
    last_step: LastStep,
    pending: PendingEvents,
) -> Events:
    """The events of the step that led to `state`.

    `rows` are how many bodies there were after that step, and the ids of the joints; `pending` tells what was deleted
    before the step, and who was put elsewhere since. Of the ids of bodies it has those of deleted ones only.
    """
    counter, bodies = plain(state.counters)[0], plain(state.bodies)
    step = int(counter["step_count"])
    centers, lookup = _centers(bodies, pending), RowLookup(state, rows[0])
    enter, leave = _entered_and_left(*last_step.sensed)
    now: Any = plain(state.contacts)[: int(counter["contact_count"])]
    old: Any = plain(last_step.before)[: int(counter["old_contact_count"])]
    did: Any = plain(last_step.reports)[: len(now)]
    before, after = last_step.in_doubt or (None, None)
    touched, touches = _where(old["touching"], 1, before), _where(now["touching"], 1, after)
    old_keys, keys = _keys(old, touched), _keys(now, touches)
    struck = _where(did["hit_speed"], HIT_SPEED * float(plain(state.settings)["units_per_meter"][0]), after)
    began, went = differences(keys, old_keys)
    fresh, ended = touches[began], touched[went]
    stirred = np.flatnonzero(bodies["stirred"])
    end = _followed_by(_contact_rows(old, ended, None, centers), pending.ends, CONTACT_EVENT, lookup)
    leave = _followed_by(leave, pending.leaves, SENSOR_EVENT, lookup)
    return Events(
        step,
        lookup.names,
        _contact_rows(now, fresh, did, centers),
        end,
        _contact_rows(now, struck, did, centers),
        enter,
        leave,
        stirred[bodies["stirred"][stirred] == -1],
        stirred[bodies["stirred"][stirred] == 1],
        np.flatnonzero(bodies["frozen_step"] == step - 1) if counter["frozen_count"] else _NO_BODIES,
        np.flatnonzero(plain(state.joints)["broken_step"] == step - 1) if counter["broken_count"] else _NO_BODIES,
        rows[1],
    )


def _where(column: Any, least: float, rows: Integers | None) -> Integers:
    """The rows in which a column is no less than that, of some or of all; these need not be picked out first."""
    return np.flatnonzero(column >= least) if rows is None else rows[column[rows] >= least]


def _entered_and_left(before: Any, after: Any) -> tuple[Records, Records]:
    """`SENSOR_EVENT` rows that are new, and those that are gone."""
    if len(before) == len(after) == 0:  # as in most scenes
        return _NO_SENSORS, _NO_SENSORS
    entered, left = differences(_pair_keys(after), _pair_keys(before))
    return as_table(plain(after).take(entered)), as_table(plain(before).take(left))


def _centers(bodies: Any, pending: PendingEvents) -> dict[str, Any]:
    """The centres of mass at the end of the step, whatever commands have moved since."""
    centers: dict[str, Any] = {"x": bodies["center_x"], "y": bodies["center_y"]}
    if pending.places:
        rows = list(pending.places)
        for k, axis in enumerate("xy"):
            centers[axis] = centers[axis].copy()
            centers[axis][rows] = [place[k] for place in pending.places.values()]
    return centers


def _followed_by(rows: Records, pairs: list[DeletedPair], table: Table, lookup: RowLookup) -> Records:
    """The rows of an event table, and after them those of pairs that were deleted, whose names `lookup` learns.

    Such tables begin with two bodies and two shapes; a contact goes on with its place and normal.
    """
    if not pairs:
        return rows
    more = table.zeros(len(pairs))
    figures = zip(*(pair.figures for pair in pairs), strict=True)
    for name, column in zip(table.dtype.names or (), (*lookup.rows(pairs), *figures), strict=False):
        plain(more)[name] = column
    return np.concatenate([rows, more]).view(np.recarray)


def _contact_rows(contacts: Any, which: Integers, did: Any, centers: dict[str, Any]) -> Records:
    if not len(which):
        return _NO_CONTACTS
    contacts = contacts.take(which)
    table = CONTACT_EVENT.zeros(len(contacts))
    rows = plain(table)
    for name in ("body_a", "body_b", "shape_a", "shape_b", "normal_x", "normal_y"):
        rows[name] = contacts[name]
    two = contacts["point_count"] == 2
    for axis in "xy":
        first, second = contacts[f"anchor_a{axis}1"], contacts[f"anchor_a{axis}2"]
        rows[axis] = centers[axis][contacts["body_a"]] + np.where(two, 0.5 * (first + second), first)
    if did is not None:
        rows["impulse"], rows["speed"] = did["total_impulse"][which], did["hit_speed"][which]
    return table


def _keys(contacts: Any, rows: Integers) -> Integers:
    return pair_keys(contacts["shape_a"][rows], contacts["shape_b"][rows])


def _pair_keys(rows: Records) -> Integers:
    return pair_keys(plain(rows)["sensor"], plain(rows)["shape_index"])

"""What one world keeps for its events: those of the last step once they were asked for, and what they are made of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.events.events import Events, LastStep, find_events, no_events
from sandbox.engine.events.happening import Happening
from sandbox.engine.events.pending import DeletedPairs, PendingEvents
from sandbox.engine.events.records import SENSOR_EVENT
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.narrow_phase.kept_runs import rows_in_doubt
from sandbox.tables import Records, plain
from sandbox.world.rows import Added, Moved
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.events.sensors import SensorOverlaps

Vec = tuple[float, float]
_NOBODY = SENSOR_EVENT.zeros(0)


class KeptEvents(NamedTuple):
    """What a copy of a world has to know of the last step, which no snapshot holds."""

    events: Events
    sensed: Records | None
    deleted: DeletedPairs


class EventLog:
    """The events of the last step of a state. Whoever steps or changes the state tells it so."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._events: Events | None = None
        self._quiet = True
        """Whether nothing happened in the last step, which takes no looking."""
        self._counts: tuple[int, int] | None = None
        """How many bodies and joints there were after the last step, if some have come since."""
        self._sensors: SensorOverlaps | None = None
        self.clear(rows_moved=True)

    def events(self, scratch: Scratch) -> Events:
        """The events of the last step, worked out when they are asked for; `scratch` is what that step left."""
        if self._events is None:
            self._events = self._quiet_step() if self._quiet else self._found(scratch)
        return self._events

    @property
    def sensed(self) -> Records | None:
        """What the sensors overlap now: `SENSOR_EVENT` rows; None in a world without sensors."""
        return None if self._sensors is None else self._sensors.now

    def note_step(self) -> None:
        """A step was taken."""
        self._forget(quiet=False)
        self._pending.begin_step()
        if self._sensors is not None:
            self._sensors.update()

    def note_quiet_steps(self) -> None:
        """Steps were taken in which everybody slept."""
        self._forget(quiet=True)

    def note_happenings(self, scratch: Scratch, happenings: Sequence[Happening]) -> None:
        """Rules and controls have done something in the last step, or before it."""
        self._events = replace(self.events(scratch), happenings=tuple(happenings))

    def note_displaced(self, row: int, center: Vec) -> None:
        """A command has put the body of that row elsewhere; `center` is where its centre of mass was (m)."""
        self._pending.note_displaced(row, center)

    def note_added(self, added: Added) -> None:
        """Rows have come after all others."""
        if self._counts is None:
            self._counts = added.bodies, added.joints
        if self._sensors is None and plain(self._state.shapes)["sensor"][added.shapes :].any():
            self._sensors = self._find_sensors()

    def note_going(self, scratch: Scratch, bodies: NDArray[np.bool_]) -> None:
        """Marked bodies will be deleted, with whatever knows of them."""
        self.events(scratch)
        self._pending.note_going(self._state, bodies, self.sensed)

    def note_moved(self, moved: Moved) -> None:
        """Rows have gone."""
        self._pending.note_rows()
        if self._sensors is not None:
            self._sensors.move_rows(moved)
            self._sensors = self._sensors if self._has_sensors() else None

    def clear(self, rows_moved: bool) -> None:
        """Begin anew: the state is a new one, or was restored."""
        self._forget(quiet=True)
        self._pending = PendingEvents()
        if rows_moved:
            self._sensors = self._find_sensors()
        if self._sensors is not None:
            self._sensors.reset()

    def kept(self, scratch: Scratch) -> KeptEvents:
        """What `recall` takes, for a log of a state with the same rows."""
        return KeptEvents(self.events(scratch), self.sensed, self._pending.deleted)

    def recall(self, kept: KeptEvents) -> None:
        """The last step was one of another world, from which the state was restored."""
        self._events, self._pending.deleted = kept.events, kept.deleted
        if self._sensors is not None and kept.sensed is not None:
            self._sensors.now = self._sensors.before = kept.sensed

    def _forget(self, quiet: bool) -> None:
        """The last step is another one; in a `quiet` one nothing happened."""
        self._events = self._counts = None
        self._quiet = quiet

    def _quiet_step(self) -> Events:
        return no_events(int(self._state.counters[0].step_count), self._ids()[0])

    def _found(self, scratch: Scratch) -> Events:
        sensors, contacts = self._sensors, scratch.contacts
        sensed = (sensors.before, sensors.now) if sensors is not None else (_NOBODY, _NOBODY)
        counter = plain(self._state.counters)[0]
        counts = int(counter["old_contact_count"]), int(counter["contact_count"])
        last_step = LastStep(contacts.now, contacts.reports, sensed, rows_in_doubt(scratch.active, contacts, *counts))
        return find_events(self._state, self._ids(), last_step, self._pending)

    def _ids(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Of bodies and of joints, as they were after the last step."""
        ids = self._state.names, self._state.joint_names
        return ids if self._counts is None else (ids[0][: self._counts[0]], ids[1][: self._counts[1]])

    def _find_sensors(self) -> SensorOverlaps | None:
        if not self._has_sensors():
            return None
        from sandbox.engine.events.sensors import SensorOverlaps  # worlds without sensors pay nothing

        return SensorOverlaps(self._state)

    def _has_sensors(self) -> bool:
        return bool(plain(self._state.shapes)["sensor"].any())

"""What one world keeps for its events: those of the last step once they were asked for, and what they are made of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sandbox.engine.events.events import Events, find_events, no_events
from sandbox.engine.events.pending import PendingEvents, TouchingPairs
from sandbox.engine.events.records import SENSOR_EVENT
from sandbox.engine.memory.scratch import Scratch
from sandbox.tables import Records
from sandbox.world.rows import Moved
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.events.sensors import SensorOverlaps

Vec = tuple[float, float]


class EventLog:
    """The events of the last step of a state. Whoever steps or changes the state tells it so."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._events: Events | None = None
        self._sensors: SensorOverlaps | None = None
        self.clear(rows_moved=True)

    def events(self, scratch: Scratch) -> Events:
        """The events of the last step, worked out when they are asked for; `scratch` is what that step left."""
        if self._events is None:
            sensors, nobody = self._sensors, SENSOR_EVENT.zeros(0)
            sensed = (sensors.before, sensors.now) if sensors is not None else (nobody, nobody)
            contacts = scratch.contacts
            self._events = find_events(self._state, contacts.now, contacts.reports, sensed, self._pending)
        return self._events

    @property
    def sensed(self) -> Records | None:
        """What the sensors overlap now: `SENSOR_EVENT` rows; None in a world without sensors."""
        return None if self._sensors is None else self._sensors.now

    def touching(self) -> TouchingPairs:
        """What touches and is sensed now, to be kept until rows have moved."""
        return TouchingPairs.of(self._state, self.sensed)

    def note_step(self) -> None:
        """A step was taken."""
        self._events = None
        self._pending.begin_step()
        if self._sensors is not None:
            self._sensors.update()

    def note_quiet_steps(self) -> None:
        """Steps were taken in which everybody slept."""
        self._events = self._no_events()

    def note_displaced(self, row: int, center: Vec) -> None:
        """A command has put the body of that row elsewhere; `center` is where its centre of mass was (m)."""
        self._pending.note_displaced(row, center)

    def note_rows(self, before: TouchingPairs, moved: Moved) -> None:
        """Rows have come or gone."""
        self._pending.note_rows(before, moved)
        earlier, self._sensors = self._sensors, self._find_sensors()
        if self._sensors is not None and earlier is not None:
            self._sensors.move_rows(earlier, moved)

    def clear(self, rows_moved: bool) -> None:
        """Begin anew: the state is a new one, or was restored."""
        self._events, self._pending = self._no_events(), PendingEvents()
        if rows_moved:
            self._sensors = self._find_sensors()
        if self._sensors is not None:
            self._sensors.reset()

    def _no_events(self) -> Events:
        return no_events(int(self._state.counters[0].step_count), self._state.names)

    def _find_sensors(self) -> SensorOverlaps | None:
        if not self._state.shapes.sensor.any():
            return None
        from sandbox.engine.events.sensors import SensorOverlaps  # worlds without sensors pay nothing

        return SensorOverlaps(self._state)

"""What one world keeps for its events: those of the last step once they were asked for, and what they are made of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

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


class Untold(NamedTuple):
    """What the events of the next step have to know of the time before it, and no snapshot holds: what sensors had in
    them, and what was deleted since."""

    sensed: Records | None
    deleted: DeletedPairs


class KeptEvents(NamedTuple):
    """What a copy of a world has to know of the last step, which no snapshot holds."""

    events: Events
    untold: Untold


def _put_back(names: list[str], rows: list[int], gone: list[str]) -> list[str]:
    """Names as they were before some were taken out of those rows."""
    before: list[str] = []
    first = 0
    for row, name in zip(rows, gone, strict=True):
        end = first + row - len(before)
        before += names[first:end]
        before.append(name)
        first = end
    return before + names[first:]


class EventLog:
    """The events of the last step of a state. Whoever steps or changes the state tells it so."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._events: Events | None = None
        self._unnamed: Events | None = None
        """The same before anybody has asked who is behind the rows: all names take long where there are many bodies."""
        self._bodies = 0
        """How many bodies there were then."""
        self._gone: list[tuple[list[int], list[str]]] = []
        """Which rows have gone since, and who was behind them."""
        self._quiet = True
        """Whether nothing happened in the last step, which takes no looking."""
        self._counts: tuple[int, int] | None = None
        """How many bodies and joints there were after the last step, if some have come since."""
        self._sensors: SensorOverlaps | None = None
        self.clear(rows_moved=True)

    def events(self, scratch: Scratch) -> Events:
        """The events of the last step, worked out when they are asked for; `scratch` is what that step left."""
        if self._events is None:
            found = self.work_out(scratch)
            self._events = replace(found, names=(*self._names(), *found.names))
        return self._events

    def work_out(self, scratch: Scratch) -> Events:
        """Work them out now, as the state is about to change; of the names only those of who had gone before."""
        if self._unnamed is None:
            counts = self._counts or (len(self._state.bodies), len(self._state.joints))
            self._bodies = counts[0]
            joint_names = self._state.joint_names[: counts[1]]
            self._unnamed = self._quiet_step() if self._quiet else self._found(scratch, joint_names)
        return self._unnamed

    @property
    def sensed(self) -> Records | None:
        """What the sensors overlap now: `SENSOR_EVENT` rows; None in a world without sensors."""
        return None if self._sensors is None else self._sensors.now

    def note_steps(self, count: int) -> None:
        """So many steps were taken, no more than one at a time in a world with sensors."""
        if count == 0:
            return
        self._forget(quiet=False)
        self._pending.begin_step()
        if count > 1:  # what commands did before them is no news to the last one
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

    def note_going(self, scratch: Scratch, going: Sequence[tuple[int, ...]]) -> None:
        """Bodies will be deleted, with whatever knows of them; `going` are their rows, command by command."""
        self.work_out(scratch)
        rows = sorted(row for some in going for row in some)
        names = self._state.census.bodies.names
        self._gone.append((rows, [names[row] for row in rows]))
        self._pending.note_going(self._state, going, self.sensed)

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
        return KeptEvents(self.events(scratch), self.untold)

    def recall(self, kept: KeptEvents) -> None:
        """The last step was one of another world, from which the state was restored."""
        self._events = kept.events
        self.take_up(kept.untold)

    @property
    def untold(self) -> Untold:
        """What `take_up` takes, for a log of a state with the same rows."""
        return Untold(self.sensed, self._pending.deleted)

    def take_up(self, untold: Untold) -> None:
        """Go on from where another log was whose state was restored."""
        self._pending.deleted = untold.deleted
        if self._sensors is not None and untold.sensed is not None:
            self._sensors.now = self._sensors.before = untold.sensed

    def _forget(self, quiet: bool) -> None:
        """The last step is another one; in a `quiet` one nothing happened."""
        self._events = self._unnamed = self._counts = None
        self._gone = []
        self._quiet = quiet

    def _quiet_step(self) -> Events:
        return no_events(int(self._state.counters[0].step_count), ())

    def _found(self, scratch: Scratch, joint_names: tuple[str, ...]) -> Events:
        sensors, contacts = self._sensors, scratch.contacts
        sensed = (sensors.before, sensors.now) if sensors is not None else (_NOBODY, _NOBODY)
        counter = plain(self._state.counters)[0]
        counts = int(counter["old_contact_count"]), int(counter["contact_count"])
        last_step = LastStep(contacts.now, contacts.reports, sensed, rows_in_doubt(scratch.active, contacts, *counts))
        return find_events(self._state, (self._bodies, joint_names), last_step, self._pending)

    def _names(self) -> Sequence[str]:
        """The ids of the bodies as they were after the last step."""
        now = self._state.names
        if not self._gone:
            return now[: self._bodies]
        names = list(now)
        for rows, gone in reversed(self._gone):
            names = _put_back(names, rows, gone)
        return names[: self._bodies]

    def _find_sensors(self) -> SensorOverlaps | None:
        if not self._has_sensors():
            return None
        from sandbox.engine.events.sensors import SensorOverlaps  # worlds without sensors pay nothing

        return SensorOverlaps(self._state)

    def _has_sensors(self) -> bool:
        return bool(plain(self._state.shapes)["sensor"].any())

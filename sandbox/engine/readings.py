"""What a world tells of itself: everything that only reads its tables and what the last step left."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from sandbox.engine.commands.deferred import Deferred
from sandbox.engine.events.event_log import EventLog
from sandbox.engine.events.events import Events
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.stepper import Stepper
from sandbox.scene.flat import FlatScene
from sandbox.tables import Floats
from sandbox.world.digest import digest
from sandbox.world.directory import Directory
from sandbox.world.records import DYNAMIC, CounterPlace
from sandbox.world.snapshot import snapshot
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.views.game import ControlState, Ending


class Readings:
    """The part of `World` that changes nothing."""

    __slots__ = ()

    state: State
    _deferred: Deferred
    _changes: int
    _moves: int
    _directory: Directory
    _events: EventLog
    _stepper: Stepper

    @property
    def changes(self) -> int:
        """Counts steps, commands and restores: while it stays the same, nothing is another than it was."""
        return self._changes

    @property
    def moves(self) -> int:
        """The same without the commands that only push what is awake: while it stays the same, all is where it was."""
        self._deferred.apply()
        return self._moves

    @property
    def directory(self) -> Directory:
        """From ids to rows, as they are now."""
        self._deferred.apply()
        return self._directory

    @property
    def time(self) -> float:
        """Seconds since the start."""
        return self.step_count * float(self.state.settings[0].step_seconds)

    @property
    def step_count(self) -> int:
        """Steps taken since the start."""
        return self._stepper.counters[CounterPlace.STEPS]

    @property
    def names(self) -> tuple[str, ...]:
        """Body ids in the order of `bodies`."""
        return self.state.names

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Joint ids in the order of the scene, then those that were spawned."""
        return self.state.joint_names

    @property
    def flat(self) -> FlatScene:
        """The scene with the bodies and joints that are there now, row by row, as they came into the world."""
        return self.state.roster.flat

    @property
    def layout(self) -> int:
        """Counts how often rows have moved: while it stays the same, row `i` of `bodies` is the same body."""
        return self.state.layout

    @property
    def awake_count(self) -> int:
        """How many dynamic bodies are awake now."""
        bodies = self.state.bodies
        return int(np.count_nonzero((bodies.type == DYNAMIC) & (bodies.awake == 1)))

    @property
    def contacts(self) -> Any:
        """The contacts of the last step: `records.CONTACT` rows, sorted by shape. A view; copy what you keep."""
        return self.state.contacts[: int(self.state.counters[0].contact_count)]

    @property
    def contact_impulses(self) -> Floats:
        """Normal impulse (N s) of each of `contacts` over the whole last step, impacts included. A copy."""
        impulses: Floats = self.scratch.contacts.reports.total_impulse[: len(self.contacts)].copy()
        return impulses

    @property
    def events(self) -> Events:
        """What happened during the last step: contacts that began, ended or struck, sensors, sleep. Ask every step."""
        self._deferred.apply()
        return self._events.events(self.scratch)

    @property
    def sensed(self) -> tuple[tuple[str, str], ...]:
        """(sensor's body, other body) for everything that a sensor has in it now, each pair once, in scene order."""
        self._deferred.apply()
        rows = self._events.sensed
        if rows is None:
            return ()
        names = self.names
        pairs = np.unique(rows.sensor_body.astype(np.int64) * len(names) + rows.body)
        of, inside = np.divmod(pairs, len(names))
        return tuple((names[a], names[b]) for a, b in zip(of.tolist(), inside.tolist(), strict=True))

    @property
    def controls(self) -> tuple[ControlState, ...]:
        """What a player can hold, and how it is held now, in the order of the scene: `Control` changes it."""
        from sandbox.engine.views.game import control_states

        return control_states(self.state)

    @property
    def counters(self) -> dict[str, float]:
        """The counters of the scene's rules by name. A copy."""
        from sandbox.engine.views.game import counter_values

        return counter_values(self.state)

    @property
    def outcome(self) -> Ending | None:
        """How the game ended; None while it is neither won nor lost."""
        from sandbox.engine.views.game import ending

        return ending(self.state)

    @property
    def scratch(self) -> Scratch:
        """What the last step left in its memory (boxes, proposed pairs), for tools that look into it; read only."""
        self._deferred.apply()
        self._stepper.settle_joints()
        return self._stepper.scratch

    @property
    def frozen(self) -> list[tuple[str, int]]:
        """(body id, step) of every body that bad numbers froze."""
        rows = self.state.bodies.frozen_step
        return [(self.names[i], int(rows[i])) for i in np.flatnonzero(rows >= 0).tolist()]

    def digest(self) -> str:
        """Fingerprint of the whole state, 16 hex digits: equal bits, equal digest."""
        return digest(self.state)

    def snapshot(self) -> bytes:
        """The whole state as bytes, for `restore`."""
        return snapshot(self.state)

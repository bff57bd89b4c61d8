"""The worlds of a batch: most are rows of memory that lanes step, some are worlds of their own."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox._jit import Call, jit_enabled
from sandbox.batch.likeness import are_alike
from sandbox.engine.commands.base import Command
from sandbox.engine.fields.records import last_switch
from sandbox.engine.lanes.advance import APART, EACH, NEXT, REDO, Rows
from sandbox.engine.lanes.lane_world import LaneWorld, room_for_contacts
from sandbox.engine.lanes.row_layout import RowLayout
from sandbox.engine.run_steps import DONE
from sandbox.engine.world import World
from sandbox.scene import Scene
from sandbox.tables import Integers
from sandbox.world.build import build_state

_WORTH_A_THREAD = 32
"""Rows from which on another thread is sooner done."""


@dataclass(frozen=True)
class Saved:
    """All worlds at one moment: rows, and snapshots of those that are apart."""

    words: Integers
    contacts: Integers
    last_switches: Integers
    apart: dict[int, bytes]


class Fleet:
    """The worlds of a batch.

    A world is `apart`, a `World` of its own, where rows do not do: rules, controls and paths are played in Python; what
    a command or a step has changed in what hangs together, or in who is there, needs other scratch memory.
    """

    def __init__(self, scenes: Sequence[Scene], threads: int | None) -> None:
        self.scenes = scenes
        first = LaneWorld(scenes[0])
        self.layout = RowLayout.of(first.state)
        count = len(scenes)
        self.rows = Rows(
            np.tile(first.words, (count, 1)),
            np.zeros((count, room_for_contacts(first.state)), np.int64),
            np.full(count, first.last_switch),
            np.full(count, DONE),
        )
        self.apart: dict[int, World] = {}
        self.ragged: set[int] = set()
        """Worlds that have other bodies than at first, which columns cannot show."""
        wanted = self.threads = min(threads or os.cpu_count() or 1, 1 + count // _WORTH_A_THREAD)
        self._lanes = [first, *(LaneWorld(scenes[0]) for _ in range(wanted - 1))]
        self._calls: list[Call | None] = [None] * wanted
        self._pool = ThreadPoolExecutor(wanted - 1, "sandbox-batch") if wanted > 1 else None
        self._queue: Integers = np.zeros(2, np.int64)
        self._place_others(first.plays)

    def step(self, steps: int) -> None:
        """Step all worlds."""
        apart = sorted(self.apart)  # those of now: a row that comes to be apart in this step has been stepped
        if len(apart) < len(self.scenes):
            self._lanes[0].compile()
            if jit_enabled():
                self._step_rows(steps)
            else:
                self.rows.verdicts[self.rows.verdicts == DONE] = REDO
            for world in np.flatnonzero(self.rows.verdicts == REDO).tolist():
                self.rows.verdicts[world] = DONE
                self.change(world, lambda one: one.step(steps))
        for world in apart:
            self.change(world, lambda one: one.step(steps))

    def change(self, world: int, do: Callable[[World], Any]) -> None:
        """Do something to one world, as a `World`. What raises leaves a row as it was."""
        if world in self.apart:
            do(self.apart[world])
            self._publish(world)
            return
        lane = self._loaded(world)
        do(lane)
        if lane.alike:
            self._save(world, lane)
        else:
            self._set_apart(world, self._own(world, lane.snapshot()))
            self._lanes[0] = LaneWorld(self.scenes[0])

    def apply(self, world: int, command: Command) -> None:
        """Apply a command to one world."""
        self.change(world, lambda one: one.apply(command))

    def look(self, world: int) -> World:
        """One world to be read, and not kept: the next call puts another one in its place."""
        return self.apart[world] if world in self.apart else self._loaded(world)

    def own(self, world: int) -> World:
        """A world by itself that goes on from where that one is."""
        return self._own(world, self.look(world).snapshot())

    def saved(self) -> Saved:
        """All worlds as they are now."""
        apart = {world: own.snapshot() for world, own in self.apart.items()}
        rows = self.rows
        return Saved(rows.words.copy(), rows.contacts.copy(), rows.last_switches.copy(), apart)

    def restore(self, saved: Saved, worlds: Integers) -> None:
        """Put some worlds back."""
        self._make_room(saved.contacts.shape[1])
        self.rows.words[worlds] = saved.words[worlds]
        self.rows.contacts[worlds, : saved.contacts.shape[1]] = saved.contacts[worlds]
        self.rows.last_switches[worlds] = saved.last_switches[worlds]
        for world in self._apart_of(worlds, saved):
            if world in saved.apart:
                own = self.apart.get(world)
                if own is None:
                    own = self.apart[world] = World(self.scenes[world])
                own.restore(saved.apart[world])
                self._set_apart(world, own)
            else:
                del self.apart[world]
                self.ragged.discard(world)
                self.rows.verdicts[world] = DONE

    def _apart_of(self, worlds: Integers, saved: Saved) -> Iterable[int]:
        if not self.apart and not saved.apart:
            return ()
        return [world for world in worlds.tolist() if world in self.apart or world in saved.apart]

    def _place_others(self, plays: bool) -> None:
        """Bring in the worlds whose scene is not that of the first."""
        first = self._lanes[0]
        for world, scene in enumerate(self.scenes):
            if not plays and scene is self.scenes[0]:
                continue
            state = None if plays else build_state(scene.flatten())
            if state is not None and are_alike(state, first.state):
                self.layout.write(self.rows.words[world], state)
                self.rows.last_switches[world] = last_switch(state)
            else:
                self._set_apart(world, World(scene))

    def _step_rows(self, steps: int) -> None:
        self._queue[NEXT], self._queue[EACH] = 0, steps
        calls = [self._call(number) for number in range(len(self._lanes))]
        others = [self._pool.submit(call) for call in calls[1:]] if self._pool is not None else []
        calls[0]()
        for other in others:
            other.result()

    def _call(self, number: int) -> Call:
        """The call of a lane, made anew where it was used for something else since."""
        call = self._calls[number]
        if call is None:
            call = self._calls[number] = self._lanes[number].call(self.rows, self._queue)
            call.bind()
        return call

    def _loaded(self, world: int) -> LaneWorld:
        lane, rows = self._lanes[0], self.rows
        self._calls[0] = None
        lane.load(rows.words[world], rows.contacts[world], int(rows.last_switches[world]))
        return lane

    def _save(self, world: int, lane: LaneWorld) -> None:
        contacts = lane.contact_words
        self._make_room(len(contacts))
        self.rows.words[world] = lane.words
        self.rows.contacts[world, : len(contacts)] = contacts
        self.rows.last_switches[world] = lane.last_switch

    def _make_room(self, words: int) -> None:
        """Have room for contacts of so many words in every row, and for half as many more."""
        before = self.rows.contacts
        if words <= before.shape[1]:
            return
        contacts = np.zeros((len(before), words + words // 2), np.int64)
        contacts[:, : before.shape[1]] = before
        self.rows = self.rows._replace(contacts=contacts)
        self._calls = [None] * len(self._lanes)

    def _own(self, world: int, snapshot: bytes) -> World:
        own = World(self.scenes[world])
        own.restore(snapshot)
        return own

    def _set_apart(self, world: int, own: World) -> None:
        self.apart[world] = own
        self.rows.verdicts[world] = APART
        self._publish(world)

    def _publish(self, world: int) -> None:
        """Show a world that is apart in the columns of all, if it has the same bodies."""
        state = self.apart[world].state
        if self.layout.fits_columns(state):
            self.ragged.discard(world)
            self.layout.write_columns(self.rows.words[world], state)
        else:
            self.ragged.add(world)

"""A world whose tables lie in one row of memory, so that other worlds of its scene can be put in its place."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox._jit import Call, kernel_argument
from sandbox.engine.lanes.advance import Lane, Rows, Words, advance_rows
from sandbox.engine.lanes.row_layout import CONTACT_WORDS, WORD, RowLayout
from sandbox.engine.records.active_set import ACTIVE_SET
from sandbox.engine.run_steps import ORDER_WORDS, CounterWords
from sandbox.engine.world import World
from sandbox.scene import Scene
from sandbox.scene.flat import FlatScene
from sandbox.tables import Integers, plain
from sandbox.world.state import State


class LaneWorld(World):
    """Takes the place of one world after another: `load`, what a world can do, `save`.

    A world that has other rows, or whose joints hang together in another way than at first, cannot be saved: it is not
    `alike` any longer. Then a lane is used up.
    """

    __slots__ = ("_begins", "_first_wiring", "_tables", "_words")

    def __init__(self, scene: Scene | FlatScene) -> None:
        super().__init__(scene)
        self._words: Integers
        layout = RowLayout.of(self.state)
        self._words = layout.new_row()
        layout.write(self._words, self.state)
        self._tables = layout.views(self._words)
        for array, table in self._tables.items():
            setattr(self.state, array, table)
        self._stepper.renew()
        self._first_wiring = self._stepper.wiring()
        self._begins = self.layout

    @property
    def plays(self) -> bool:
        """Whether controls, rules or paths do something around a step, in Python."""
        return self._game is not None or self._paths is not None

    def compile(self) -> None:
        """Compile what a step needs, if it has not been on this machine: seconds."""
        self._stepper.compile()

    @property
    def words(self) -> Integers:
        """All its tables but the contacts, as `RowLayout` says. A view."""
        return self._words

    @property
    def contact_words(self) -> Integers:
        """The contacts that are in use. A view."""
        return _flat(self.state.contacts)[: len(self.contacts) * CONTACT_WORDS]

    @property
    def last_switch(self) -> int:
        """The last step in which a region or a thruster begins or ceases to act."""
        return self._last_switch

    @property
    def alike(self) -> bool:
        """Whether it still has the tables, and joints that hang together, of its beginning."""
        tables = all(getattr(self.state, array) is table for array, table in self._tables.items())
        return tables and self.layout == self._begins and self._stepper.wiring() == self._first_wiring

    def load(self, words: Integers, contacts: Integers, last_switch: int) -> None:
        """Be the world of that row, as after `restore`."""
        self._changes += 1
        self._words[:] = words
        self.state.tiling = None  # tiles may lie elsewhere
        count = int(plain(self.state.counters)[0]["contact_count"]) * CONTACT_WORDS
        _flat(self.state.contacts)[:count] = contacts[:count]
        self._last_switch = last_switch
        plain(self.scratch.contacts.reports)["total_impulse"] = 0.0
        self._stepper.follow_restore(self._first_wiring)
        self._events.clear(rows_moved=False)

    def call(self, rows: Rows, queue: Integers) -> Call:
        """The call that steps worlds from a queue through this one's memory, for as long as `rows` stay where they are
        and nothing else is done with this world."""
        even, odd = (_flat(table) for table in self._stepper.contact_tables)
        active = plain(kernel_argument(self.scratch.active.info)).view(np.int64)
        lane = Lane(self._words, even, odd, active, self._stepper.machine(), np.zeros(ORDER_WORDS, np.int64))
        arguments = rows, lane, _words(RowLayout.of(self.state)), queue, self._stepper.turn
        return Call(advance_rows, arguments, unlocked=True)


def room_for_contacts(state: State) -> int:
    """Words for as many contacts as a state has rows for."""
    return len(state.contacts) * CONTACT_WORDS


def _flat(table: Any) -> Integers:
    words: Integers = plain(table).view(np.int64)
    return words


def _words(layout: RowLayout) -> Words:
    stale = int(ACTIVE_SET.dtype.fields["stale"][1]) // WORD  # type: ignore[index]
    counters = CounterWords(*map(layout.counter, CounterWords._fields))
    return Words(counters, stale=stale, contact=CONTACT_WORDS)

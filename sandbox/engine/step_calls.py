"""The calls of the parts of a step: for even and for odd steps, as the tables of contacts swap places between them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np

from sandbox._argument_words import Bundle
from sandbox._jit import Call, kernel_argument
from sandbox.engine.compile_step import PARTS, Part
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.fields.apply import apply_fields
from sandbox.engine.fields.records import has_fields
from sandbox.engine.joints.nets import has_nets
from sandbox.engine.memory.binding import (
    contact_arguments,
    joint_arguments,
    parameters,
    scratch_arguments,
    state_arguments,
)
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.records.calls import (
    BEGIN,
    COLLIDE,
    CONTINUOUS,
    FIELDS,
    IMPACTS,
    JOINT_IMPACTS,
    JOINTS,
    NETS,
    ROWS,
)
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.run_steps import ORDER_WORDS, CounterWords, run_steps
from sandbox.engine.workers.serve import serve
from sandbox.tables import Integers, plain
from sandbox.world.records import CounterPlace
from sandbox.world.state import State

PARTS_OF_STEP: tuple[Part, ...] = (apply_fields, *PARTS)
"""What the rows of a table of calls are (`records/calls.py`)."""
COUNTER_WORDS = CounterWords(
    CounterPlace.STEPS,
    CounterPlace.CONTACTS,
    CounterPlace.AWAKE,
    CounterPlace.STILL,
    CounterPlace.BROKEN,
    CounterPlace.FROZEN,
)
"""Those of a row of counters."""


class StepCalls:
    """Calls of the parts of a step with the tables of one world.

    A call is made once, and then filled with other tables where some have been replaced.
    """

    def __init__(self, workers: int) -> None:
        self._workers = workers
        self._calls: dict[tuple[Any, int, int], Call] = {}
        self._bundles: dict[tuple[str, int], Bundle] = {}
        self.parts: Integers = np.zeros((2, CONTINUOUS + 1, 2), np.int64)
        """The tables of parts for even and for odd steps (`run_steps`), once they are `bound`."""
        self._called: Integers = np.zeros((2, workers, ROWS, 2), np.int64)
        """For even and for odd steps what the parts call as each worker (`Contacts.calls`), and for the other workers
        the parts themselves (`serve`)."""
        self.bound = False
        """Whether the parts are compiled, and called with the tables there are."""
        self.has_fields = self._jointed = self._nets = False
        self._continuous = self._strikes = False
        self.order: Integers = np.zeros(ORDER_WORDS, np.int64)
        """What `run` is to do (`run_steps`), and what is left of that."""
        self._run_call: Call | None = None
        self.run: Callable[[], int]
        """Runs steps as `order` says (`run_steps`), once the parts are `bound`."""

    def fill(self, state: State, scratch: Scratch, contacts: tuple[Contacts, Contacts]) -> None:
        """Call the parts with these tables; `contacts` are those of even and of odd steps."""
        self.bound = False
        self._words = plain(state.counters).view(np.int64)
        self.has_fields = has_fields(state)
        self._jointed, self._nets = _joined(scratch)
        parts = [PARTS_OF_STEP[row] for row in range(COLLIDE, ROWS) if self._may_need(row)]
        named = self._bundled(state_arguments(state) | scratch_arguments(scratch))
        for turn, tables in enumerate(contacts):
            named |= self._bundled(contact_arguments(tables._replace(calls=self._called[turn])), turn)
            if self.has_fields:
                self._call(apply_fields, turn, named)
            for worker in range(self._workers):
                own = self._named_for(worker, named, scratch) | {"parts": self._called[turn, worker]}
                for part in (*parts, serve):
                    self._call(part, turn, own, worker)

    def fits(self, state: State, scratch: Scratch) -> bool:
        """Whether these parts are those that such a world needs: it still has fields, joints and nets, or has none."""
        return (has_fields(state), *_joined(scratch)) == (self.has_fields, self._jointed, self._nets)

    def exchange_rows(self, state: State, scratch: Scratch, joints: bool) -> None:
        """Call the parts, which it `fits`, with other tables of the state, and the same scratch memory but for its
        fields and, with `joints`, what it has of those."""
        named = self._bundled(state_arguments(state) | (joint_arguments(scratch) if joints else {}))
        if self.has_fields:
            self._bundled({"fields": kernel_argument(scratch.fields)})
            for turn in (0, 1):  # they alone ask for a table of the state by itself
                if self._calls[apply_fields, 0, turn].exchange(parameters(apply_fields), named):
                    self.bound = False

    @property
    def needs(self) -> frozenset[int]:
        """The rows of what each step needs, or is to have ready."""
        return frozenset(row for row in range(ROWS) if self._needs(row))

    @property
    def of_impacts(self) -> list[Part]:
        """What resolves the impacts of this world."""
        return [PARTS_OF_STEP[row] for row in (IMPACTS, JOINT_IMPACTS) if self._may_need(row)]

    def lacking(self, impacts: bool) -> tuple[dict[Part, int], list[Part]]:
        """The parts that are needed and not compiled yet, with their weights; and if there are some, those that few
        steps need, first what resolves impacts if there may be some."""
        needed = [PARTS_OF_STEP[row] for row in sorted(self.needs - {FIELDS})]
        found = {part: weight for part in needed if (weight := self._weight_lacking(part)) > 0}
        few = [*self.of_impacts, solve_continuous] if impacts else [solve_continuous, *self.of_impacts]
        return found, [part for part in few if found and part not in needed and self._weight_lacking(part) > 0]

    def bind(self) -> None:
        """Compile what is needed and is not yet, each in turn."""
        needed = sorted(self.needs)
        self.parts[:] = 0
        self._called[:] = 0
        for turn, row in product((0, 1), needed):
            if row <= CONTINUOUS:
                self.parts[turn, row] = self._machine(row, turn)
            for worker in range(1 if row <= CONTINUOUS else 0, self._workers):
                if row not in (FIELDS, BEGIN, CONTINUOUS):  # which no other worker has a part of
                    self._called[turn, worker, row] = self._calls[PARTS_OF_STEP[row], worker, turn].machine()
        self.run = self._bound_run(self._words)
        self.bound = True

    def bind_made(self, impacts: bool) -> None:
        """Bind what few steps need, if it is compiled already: to load it takes some milliseconds, which a step in the
        midst of a run would wait for. What resolves impacts if there may be some."""
        if self._weight_lacking(solve_continuous) == 0:
            self.bind_continuous()
        if impacts and not any(map(self._weight_lacking, self.of_impacts)):
            self.bind_impacts()

    def bind_continuous(self) -> None:
        """Compile the last part as well, from now on."""
        self._continuous = True
        self.bind()

    def bind_impacts(self) -> None:
        """Compile what resolves impacts as well, from now on."""
        self._strikes = True
        self.bind()

    def bind_workers(self, turn: int) -> Sequence[Callable[[], Any]]:
        """What the other workers run in an even (0) or odd (1) step, compiled if need be."""
        return [self._calls[serve, worker, turn].bind() for worker in range(1, self._workers)]

    def _may_need(self, row: int) -> bool:
        """Whether some step of this world may need a row of the tables of calls."""
        if row == FIELDS:
            return self.has_fields
        if row == NETS:
            return self._nets
        return self._jointed or row not in (JOINTS, JOINT_IMPACTS)

    def _needs(self, row: int) -> bool:
        """Whether each step needs it, or is to have it ready."""
        if row == CONTINUOUS:
            return self._continuous
        return self._may_need(row) and (self._strikes or row not in (IMPACTS, JOINT_IMPACTS))

    def _weight_lacking(self, part: Part) -> int:
        """The weight of a part that is to be compiled; 0 if it is there."""
        return self._calls[part, 0, 0].weight_lacking()

    def _machine(self, row: int, turn: int) -> tuple[int, int]:
        """Where the machine code of a part of `run_steps` and its arguments are, compiled if need be."""
        return self._calls[PARTS_OF_STEP[row], 0, turn].machine()

    def _bound_run(self, words: Integers) -> Callable[[], int]:
        """What runs the steps of a world with those counters."""
        if self._run_call is None:
            self._run_call = Call(run_steps, (self.parts, words, COUNTER_WORDS, self.order), self._workers > 1)
        self._run_call.exchange(parameters(run_steps), {"words": words})
        return self._run_call.bind()

    def _call(self, part: Any, turn: int, named: Mapping[str, Any], worker: int = 0) -> Call:
        """The call of an entry point with what is `named` now, by a worker."""
        names, key = parameters(part), (part, worker, turn)
        if key not in self._calls:
            self._calls[key] = Call(part, tuple(named[name] for name in names), self._workers > 1)
        self._calls[key].exchange(names, named)
        return self._calls[key]

    def _named_for(self, worker: int, named: Mapping[str, Any], scratch: Scratch) -> dict[str, Any]:
        """What is `named` now, for a worker, whose number is in a bundle of its own."""
        own = kernel_argument(scratch.workers._replace(number=worker))
        return {**named, **self._bundled({"workers": own}, worker)}

    def _bundled(self, named: Mapping[str, Any], turn: int = 0) -> dict[str, Any]:
        """What is named, tuples as the bundles that all calls share; contacts have one for each turn, and workers one
        each."""
        found = dict(named)
        for name, value in named.items():
            if isinstance(value, tuple):
                if (name, turn) not in self._bundles:
                    self._bundles[name, turn] = Bundle(value)
                found[name] = self._bundles[name, turn]
                found[name].fill(value)
        return found


def _joined(scratch: Scratch) -> tuple[bool, bool]:
    """Whether joints hold something, and whether some of it is a net."""
    return scratch.joints is not None, scratch.joints is not None and has_nets(scratch.joints)

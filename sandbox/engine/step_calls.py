"""The calls of the parts of a step: for even and for odd steps, as the tables of contacts swap places between them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from sandbox._argument_words import Bundle
from sandbox._jit import Call, kernel_argument
from sandbox.engine.compile_step import PARTS
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.fields.apply import apply_fields
from sandbox.engine.fields.records import has_fields
from sandbox.engine.memory.binding import contact_arguments, parameters, scratch_arguments, state_arguments
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.restitution.strike_batch import strike_batch
from sandbox.engine.run_step import BEGIN, COLLIDE, CONTINUOUS, FIELDS, FINISH, SOLVE, run_step
from sandbox.engine.workers.serve import serve
from sandbox.tables import Integers
from sandbox.world.state import State

PARTS_OF_STEP: tuple[Callable[..., Any], ...] = (apply_fields, *PARTS)
"""What the rows of a table of parts are, for `run_step`."""


class StepCalls:
    """Calls of the parts of a step with the tables of one world.

    A call is made once, and then filled with other tables where some have been replaced.
    """

    def __init__(self, workers: int) -> None:
        self._workers = workers
        self._jointed = False
        self._last = FINISH
        self._calls: dict[tuple[Any, int, int], Call] = {}
        self._bundles: dict[tuple[str, int], Bundle] = {}
        self.parts: Integers = np.zeros((2, len(PARTS_OF_STEP), 2), np.int64)
        """The tables of parts for even and for odd steps (`run_step`), once they are `bound`."""
        self.bound = False
        """Whether the parts are compiled, and called with the tables there are."""
        self._strikes = False
        self._impact_calls: Integers = np.zeros((2, workers, 2), np.int64)
        """`Contacts.impact_calls` of even and of odd steps."""
        self._helping: Integers = np.zeros((2, workers, len(PARTS_OF_STEP), 2), np.int64)
        """Tables of parts for even and for odd steps, as each of the other workers calls them (`serve`)."""
        self.has_fields = False
        self._runs: dict[tuple[int, int], Callable[[], int]] = {}
        self._run_calls = {
            (turn, first): Call(run_step, (parts, first), workers > 1)
            for turn, parts in enumerate(self.parts)
            for first in (FIELDS, COLLIDE, SOLVE, CONTINUOUS)
        }

    def fill(self, state: State, scratch: Scratch, contacts: tuple[Contacts, Contacts]) -> None:
        """Call the parts with these tables; `contacts` are those of even and of odd steps."""
        if (scratch.joints is not None) != self._jointed:
            self._jointed = not self._jointed  # other types, hence other versions of the machine code
            self._calls.clear()
            self._bundles.clear()
        self.bound = False
        self.has_fields = has_fields(state)
        named = self._bundled(state_arguments(state) | scratch_arguments(scratch))
        for turn, tables in enumerate(contacts):
            named |= self._bundled(contact_arguments(tables._replace(impact_calls=self._impact_calls[turn])), turn)
            if self.has_fields:
                self._call(apply_fields, turn, named)
            for worker in range(self._workers):
                own = self._named_for(worker, named, scratch) | {"parts": self._helping[turn, worker]}
                for part in (*PARTS, strike_batch, serve):
                    self._call(part, turn, own, worker)

    def fill_state(self, state: State, scratch: Scratch) -> None:
        """Call the parts with other tables of the state, which still has fields or still has none, and the same scratch
        memory but for its fields."""
        self.bound = False
        named = self._bundled(state_arguments(state))
        if self.has_fields:
            self._bundled({"fields": kernel_argument(scratch.fields)})
            for turn in (0, 1):  # they alone ask for a table of the state by itself
                self._calls[apply_fields, 0, turn].exchange(parameters(apply_fields), named)

    def lacking(self) -> dict[Callable[..., Any], int]:
        """The parts that are not compiled yet, and their weights; those that few steps need only beside others."""
        found: dict[Callable[..., Any], int] = {}
        for part in (*PARTS, strike_batch):
            if found or part in PARTS[:-1]:
                weight = self._calls[part, 0, 0].weight_lacking()
                if weight > 0:
                    found[part] = weight
        return found

    def bind(self) -> None:
        """Compile the parts that are not yet, each in turn, but for the last one, which few steps need."""
        for turn, parts in enumerate(self.parts):
            for row in range(self._last + 1):
                parts[row] = self._machine(row, turn)
            for worker in range(self._workers):
                if self._strikes:
                    self._impact_calls[turn, worker] = self._calls[strike_batch, worker, turn].machine()
                for row in (COLLIDE, BEGIN, SOLVE, FINISH) if worker > 0 else ():
                    self._helping[turn, worker, row] = self._calls[PARTS_OF_STEP[row], worker, turn].machine()
        self._runs = {key: call.bind() for key, call in self._run_calls.items()}
        self.bound = True

    def bind_made(self, impacts: bool) -> None:
        """Bind what few steps need, if it is compiled already: to load it takes some milliseconds, which a step in the
        midst of a run would wait for. What resolves impacts if there may be some."""
        if self._calls[solve_continuous, 0, 0].weight_lacking() == 0:
            self.bind_continuous()
        if impacts and self._calls[strike_batch, 0, 0].weight_lacking() == 0:
            self.bind_impacts()

    def bind_continuous(self) -> None:
        """Compile the last part as well, from now on."""
        self._last = CONTINUOUS
        self.bind()

    def bind_impacts(self) -> None:
        """Compile what resolves impacts as well, from now on."""
        self._strikes = True
        self.bind()

    def bind_workers(self, turn: int) -> Sequence[Callable[[], Any]]:
        """What the other workers run in an even (0) or odd (1) step, compiled if need be."""
        return [self._calls[serve, worker, turn].bind() for worker in range(1, self._workers)]

    def run(self, turn: int, first: int) -> int:
        """Run the parts of a step from the `first` one on: `run_step`."""
        return self._runs[turn, first]()

    def _machine(self, row: int, turn: int) -> tuple[int, int]:
        """Where the machine code of a part and its arguments are, compiled if need be; zeros for fields if there are
        none."""
        return (0, 0) if row == FIELDS and not self.has_fields else self._calls[PARTS_OF_STEP[row], 0, turn].machine()

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

"""What steps one world: the calls of the compiled parts of the step, and the scratch memory they share."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from sandbox._argument_words import Bundle
from sandbox._jit import Call, jit_enabled, kernel_argument
from sandbox.engine.compile_step import PARTS, compile_continuous, compile_step
from sandbox.engine.fields.apply import apply_fields
from sandbox.engine.fields.records import has_fields
from sandbox.engine.joints.assembly import assemble, assemble_more
from sandbox.engine.joints.fewer_parts import going_parts, without_parts
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.wiring import wiring
from sandbox.engine.memory.binding import contact_arguments, parameters, scratch_arguments, state_arguments
from sandbox.engine.memory.bundles import Room
from sandbox.engine.memory.limit import room_for
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.run_step import COLLIDE, CONTINUOUS, DONE, FIELDS, FINISH, TO_COMPILE, run_step
from sandbox.engine.workers.serve import serve
from sandbox.engine.workers.threads import WorkerThreads
from sandbox.errors import CapacityError
from sandbox.tables import Integers, Records, close_up, copy_rows, plain
from sandbox.world.records import CONTACT, CounterPlace
from sandbox.world.rows import Added, Moved
from sandbox.world.state import State

PARTS_OF_STEP: tuple[Callable[..., Any], ...] = (apply_fields, *PARTS)
"""What the rows of a table of parts are, for `run_step`."""
_FEW = 1000
"""So many shapes never make too many pairs."""
_WORTH_SHARING = 8000
"""Awake bodies, their contacts and joints from which on several workers are sooner done: with half as many, fetching
what the other one has written takes as long as is saved."""


class Stepper:
    """Steps a state. Whoever adds or removes rows calls `add_rows` or `move_rows`, whoever replaces its arrays `renew`,
    whoever switches a joint `assemble_joints`."""

    scratch: Scratch
    counters: memoryview
    """The row of counters as whole numbers, by the places in `CounterPlace`, which is five times faster to ask."""

    def __init__(self, state: State, workers: int = 1) -> None:
        self._state = state
        self.workers = workers if jit_enabled() else 1
        self._threads = WorkerThreads(self.workers - 1) if self.workers > 1 else None
        self._turn = self._lost = 0
        self._jointed = self._compiled = False
        self._last = FINISH
        self._room = Room.of(state)
        self._calls: dict[tuple[Any, int], Call] = {}
        self._bundles: dict[tuple[str, int], Bundle] = {}
        self._layouts = PartLayouts(self.workers)
        self._parts: Integers = np.zeros((2, len(PARTS_OF_STEP), 2), np.int64)
        self._runs: dict[tuple[int, int], Callable[[], int]] = {}
        self._run_calls = {
            (turn, first): Call(run_step, (parts, first), self.workers > 1)
            for turn, parts in enumerate(self._parts)
            for first in (FIELDS, COLLIDE, CONTINUOUS)
        }
        self.renew()

    def compile(self) -> None:
        """Compile what the step needs, if it has not been on this machine: seconds."""
        if self._compiled:
            return
        compile_step(self.scratch.joints is not None)
        if len(self._state.bodies) + len(self._state.joints) >= _WORTH_SHARING // 4:  # else it may never be needed
            self.bind_workers()
        for turn, parts in enumerate(self._parts):
            for row in range(self._last + 1):
                parts[row] = self._machine(row, turn)
        self._runs = {key: call.bind() for key, call in self._run_calls.items()}
        self._compiled = True

    def machine(self) -> Integers:
        """The table of parts for even and for odd steps (`run_step`), none of which is to be compiled any more."""
        self._compile_continuous()
        return self._parts

    @property
    def turn(self) -> int:
        """0 before an even step, 1 before an odd one."""
        return self._turn

    @property
    def contact_tables(self) -> tuple[Records, Records]:
        """The tables that an even and an odd step find the contacts of the step before in."""
        even, odd = self._contacts
        return even.before, odd.before

    def bind_workers(self) -> Sequence[Callable[[], Any]]:
        """What the other workers run in the next step, compiled if need be."""
        return [call.bind() for call in self._served[self._turn]]

    def step(self) -> None:
        """Take one step. Then `state.contacts` are those of it, `scratch.contacts.now` those of the step before.

        Raises `CapacityError`, and leaves the state as it was, if there are too many pairs.
        """
        self.compile()
        before = self._state.bodies.tobytes() if self._crowded and self._has_fields else None
        try:
            self._advance()
        except CapacityError:
            if before is not None:  # of what the state has only fields have changed something by then
                self._state.bodies[:] = np.frombuffer(before, self._state.bodies.dtype)
            self.forget()
            raise
        # A step reads the contacts of the last one while it writes the new ones.
        self._turn = 1 - self._turn
        self._state.contacts = self.scratch.contacts.now
        self.scratch.contacts = self._contacts[self._turn]
        if self._lost != self.counters[CounterPlace.BROKEN] + self.counters[CounterPlace.FROZEN]:
            self.assemble_joints()

    def renew(self) -> None:
        """Take new scratch memory, for as many pairs as the state has rows for contacts."""
        self.scratch = Scratch.for_state(
            self._state, len(self._state.contacts), self._layouts, self._room, self.workers
        )
        self._room = self.scratch.room
        self._turn = 0
        self._prepare_calls()

    def add_rows(self, added: Added) -> None:
        """Rows have come after all others."""
        state, scratch = self._state, self.scratch
        grown = scratch.follow_rows(state, added.bodies, added.shapes)
        if grown:
            self._room = scratch.room
            scratch.make_room_for_joints()
        if len(state.joints) > added.joints:
            known = scratch.joint_filter, scratch.joints
            more = assemble_more(state.joints, state.bodies, self._layouts, known, added.joints)
            if more is None:
                self.assemble_joints()
                return
            scratch.joint_filter, scratch.joints = more
        elif not grown:
            self._exchange_state()
            return
        self._prepare_calls()

    def move_rows(self, moved: Moved) -> None:
        """Rows have gone, and others have moved into their places."""
        self.scratch.follow_rows(self._state, moved.first_body, moved.first_shape)
        plain(self.scratch.grid.cache.info)["valid"] = 0  # shapes have other rows
        close_up(plain(self.scratch.contacts.reports)[: len(moved.contacts)], moved.contacts)
        scratch, joints = self.scratch, self.scratch.joints
        if joints is None and len(moved.joints) == 0:
            self._exchange_state()
            return
        going = None if joints is None else going_parts(joints, moved.joints)
        if joints is None or going is None or going.all():
            self.assemble_joints()
            return
        scratch.joint_filter, scratch.joints = without_parts(
            scratch.joint_filter, joints, self._layouts, going, moved, self._state.joints
        )
        self._prepare_calls()

    def follow_regions(self) -> None:
        """Regions have gone, or have other sides."""
        self.scratch.follow_fields(self._state)
        self._exchange_state()

    def forget(self) -> None:
        """Look anew at who may move: something was changed from outside."""
        plain(self.scratch.active.info)["stale"] = 1

    def assemble_joints(self) -> None:
        """Find out anew what hangs together by joints, after one of them broke or was switched."""
        state, scratch = self._state, self.scratch
        room = scratch.room.bodies
        scratch.joint_filter, scratch.joints = assemble(state.joints, state.bodies, self._layouts, room)
        self._prepare_calls()

    def wiring(self) -> bytes:
        """What decides how joints hang together now."""
        return wiring(self._state.joints, self._state.bodies)

    def follow_restore(self, wiring: bytes | None) -> None:
        """The state was restored. `wiring` is what it was before, or None where rows have moved."""
        if wiring is None or len(self._state.contacts) != len(self.scratch.contacts.now):
            self.renew()
        elif wiring != self.wiring():
            self.assemble_joints()
        if self.scratch.fields.edges is not self._state.edges:
            self.follow_regions()
        self._count_lost()
        self.forget()

    def _count_lost(self) -> None:
        """Note how many joints have broken, and bodies been frozen: what hangs together has changed where there are
        more."""
        self._lost = self.counters[CounterPlace.BROKEN] + self.counters[CounterPlace.FROZEN]

    def _advance(self) -> None:
        """Run the parts of a step."""
        first = FIELDS
        while True:
            if self._threads is None or not self._is_worth_sharing():
                came = self._run(first)
            else:
                with self._threads.serving(self.scratch.workers, self.bind_workers()):
                    came = self._run(first)
            if came == DONE:
                return
            first = self._provide(came)

    def _provide(self, lacking: int) -> int:
        """See to what the parts of a step lack; returns which one to go on from."""
        if lacking == TO_COMPILE:
            self._compile_continuous()
            return CONTINUOUS
        self._make_room(lacking)
        self.compile()
        return COLLIDE

    def _run(self, first: int) -> int:
        """Run the parts of this step from the `first` one on: `run_step`."""
        came: int = self._runs[self._turn, first]()
        return came

    def _compile_continuous(self) -> None:
        """Compile the last part of a step, which few steps need."""
        compile_continuous()
        self._last = CONTINUOUS
        self._compiled = False
        self.compile()

    def _is_worth_sharing(self) -> bool:
        """Whether so much was awake in the last step that this one is sooner done by several workers."""
        contacts = int(plain(self.scratch.contacts.active)["contact"][0])
        awake = self.counters[CounterPlace.AWAKE] + len(self._state.joints)
        return contacts + awake >= _WORTH_SHARING

    def _make_room(self, pairs: int) -> None:
        """Grow scratch memory to that many pairs, and half as many more if there is room for that."""
        room, contacts = room_for(pairs), self._state.contacts
        count = self.counters[CounterPlace.CONTACTS]
        self._state.contacts = CONTACT.zeros(room)
        copy_rows(plain(self._state.contacts), plain(contacts)[:count])
        self.scratch.make_room_for_pairs(self._state, room, self.workers)
        self._prepare_calls()

    def _prepare_calls(self) -> None:
        """The calls of a step: some for even and some for odd steps, as the contact tables swap places."""
        state, scratch = self._state, self.scratch
        plain(scratch.grid.cache.info)["valid"] = 0
        self._crowded = len(state.shapes) > _FEW
        self.counters = plain(state.counters).view(np.int64).data
        self._compiled = False
        self._count_lost()
        here = scratch.contacts._replace(before=state.contacts)
        there = here._replace(now=here.before, before=here.now)
        self._contacts = (here, there) if self._turn == 0 else (there, here)
        if (scratch.joints is not None) != self._jointed:
            self._jointed = not self._jointed  # other types, hence other versions of the machine code
            self._calls.clear()
            self._bundles.clear()
        named = self._bundled(state_arguments(state) | scratch_arguments(scratch))
        self._has_fields = has_fields(state)
        self._served = []
        for turn, contacts in enumerate(self._contacts):
            named |= self._bundled(contact_arguments(contacts), turn)
            for part in PARTS:
                self._call(part, turn, named)
            if self._has_fields:
                self._call(apply_fields, turn, named)
            self._served.append([self._serving(worker, turn, named) for worker in range(1, self.workers)])

    def _call(self, part: Any, turn: int, named: Mapping[str, Any], worker: int = 0) -> Call:
        """The call of an entry point with what is `named` now, by a worker."""
        names, key = parameters(part), (worker or part, turn)
        if key not in self._calls:
            self._calls[key] = Call(part, tuple(named[name] for name in names), self.workers > 1)
        self._calls[key].exchange(names, named)
        return self._calls[key]

    def _serving(self, worker: int, turn: int, named: Mapping[str, Any]) -> Call:
        """A call of `serve` with what is `named` now, for a worker."""
        number = {"workers": kernel_argument(self.scratch.workers._replace(number=worker))}
        return self._call(serve, turn, {**named, **self._bundled(number, worker)}, worker)

    def _machine(self, row: int, turn: int) -> tuple[int, int]:
        """Where the machine code of a part and its arguments are, compiled if need be; zeros for fields if there are
        none."""
        return (0, 0) if row == FIELDS and not self._has_fields else self._calls[PARTS_OF_STEP[row], turn].machine()

    def _bundled(self, named: Mapping[str, Any], turn: int = 0) -> dict[str, Any]:
        """What is named, tuples as the bundles that all calls share; contacts have one for each turn."""
        found = dict(named)
        for name, value in named.items():
            if isinstance(value, tuple):
                if (name, turn) not in self._bundles:
                    self._bundles[name, turn] = Bundle(value)
                found[name] = self._bundles[name, turn]
                found[name].fill(value)
        return found

    def _exchange_state(self) -> None:
        """Other rows of the state, and nothing else, for the calls of a step."""
        state = self._state
        self._crowded = len(state.shapes) > _FEW
        self._compiled = False
        if has_fields(state) != self._has_fields:
            self._prepare_calls()
            return
        named = self._bundled(state_arguments(state))
        if has_fields(state):
            self._bundled({"fields": kernel_argument(self.scratch.fields)})
            for turn in (0, 1):  # they alone ask for a table of the state by itself
                self._calls[apply_fields, turn].exchange(parameters(apply_fields), named)

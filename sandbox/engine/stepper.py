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
from sandbox.engine.workers.serve import serve
from sandbox.engine.workers.threads import WorkerThreads
from sandbox.errors import CapacityError
from sandbox.tables import Records, close_up, copy_rows, plain
from sandbox.world.records import CONTACT, CounterPlace
from sandbox.world.rows import Added, Moved
from sandbox.world.state import State

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
        self._room = Room.of(state)
        self._calls: dict[tuple[Any, int], tuple[Call, Callable[[], Any]]] = {}
        self._bundles: dict[tuple[str, int], Bundle] = {}
        self._layouts = PartLayouts(self.workers)
        self.renew()

    def compile(self) -> None:
        """Compile what the step needs, if it has not been on this machine: seconds."""
        if self._compiled:
            return
        compile_step(self.scratch.joints is not None)
        if len(self._state.bodies) + len(self._state.joints) >= _WORTH_SHARING // 4:  # else it may never be needed
            self.bind_workers()
        self._compiled = True

    def machine(self) -> list[list[tuple[int, int]]]:
        """Where the machine code of fields and of the `PARTS` of a step is, and the arguments of each (`Call.machine`),
        for even and for odd steps; zeros for fields that there are none of."""
        parts = (apply_fields, *PARTS)
        calls = [[self._calls.get((part, turn)) for part in parts] for turn in (0, 1)]
        return [[(0, 0) if call is None else call[0].machine() for call in row] for row in calls]

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
        before = self._state.bodies.tobytes() if self._crowded and self._fields[0] else None
        for apply in self._fields[self._turn]:
            apply()
        try:
            while not self._advance():
                pass
        except CapacityError:
            if before is not None:  # of what the state has only fields have changed something by then
                self._state.bodies[:] = np.frombuffer(before, self._state.bodies.dtype)
            self.forget()
            raise
        # A step reads the contacts of the last one while it writes the new ones.
        self._turn = 1 - self._turn
        self._state.contacts = self.scratch.contacts.now
        self.scratch.contacts = self._contacts[self._turn]
        if self._lost != self._count_lost():
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
        self._lost = self._count_lost()
        self.forget()

    def _count_lost(self) -> int:
        """How many joints have broken, and bodies been frozen: what hangs together has changed where there are more."""
        return self.counters[CounterPlace.BROKEN] + self.counters[CounterPlace.FROZEN]

    def _advance(self) -> bool:
        """Take a step; False if it lacked scratch memory, which it has now: then nothing else has changed."""
        collide, begin, solve, finish, solve_continuous = self._parts[self._turn]
        fast = False
        if self._threads is None or not self._is_worth_sharing():
            lacking_pairs = collide()
            if not lacking_pairs:
                begin()
                solve()
                fast = finish()
        else:
            with self._threads.serving(self.scratch.workers, self.bind_workers()):
                lacking_pairs = collide()
                if not lacking_pairs:
                    begin()
                    solve()
                    fast = finish()
        if lacking_pairs:
            self._make_room(lacking_pairs)
            return False
        if fast:
            compile_continuous()
            solve_continuous()
        return True

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
        self._lost = self._count_lost()
        here = scratch.contacts._replace(before=state.contacts)
        there = here._replace(now=here.before, before=here.now)
        self._contacts = (here, there) if self._turn == 0 else (there, here)
        if (scratch.joints is not None) != self._jointed:
            self._jointed = not self._jointed  # other types, hence other versions of the machine code
            self._calls.clear()
            self._bundles.clear()
        named = self._bundled(state_arguments(state) | scratch_arguments(scratch))
        self._parts, self._fields, self._served = [], [], []
        for turn, contacts in enumerate(self._contacts):
            named |= self._bundled(contact_arguments(contacts), turn)
            self._parts.append([self._bound(part, turn, named) for part in PARTS])
            self._served.append([self._serving(worker, turn, named) for worker in range(1, self.workers)])
            self._fields.append([self._bound(apply_fields, turn, named)] if has_fields(state) else [])

    def _bound(self, part: Any, turn: int, named: Mapping[str, Any]) -> Callable[[], Any]:
        """A call of an entry point with what is `named` now."""
        names = parameters(part)
        if (part, turn) not in self._calls:
            call = Call(part, tuple(named[name] for name in names), self.workers > 1)
            self._calls[part, turn] = call, self._watched(part, call)
        call, run = self._calls[part, turn]
        call.exchange(names, named)
        return run

    def _serving(self, worker: int, turn: int, named: Mapping[str, Any]) -> Call:
        """A call of `serve` with what is `named` now, for a worker."""
        names = parameters(serve)
        number = {"workers": kernel_argument(self.scratch.workers._replace(number=worker))}
        named = {**named, **self._bundled(number, worker)}
        if (worker, turn) not in self._calls:
            call = Call(serve, tuple(named[name] for name in names), unlocked=True)
            self._calls[worker, turn] = call, call
        call, _ = self._calls[worker, turn]
        call.exchange(names, named)
        return call

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
        if has_fields(state) != bool(self._fields[0]):
            self._prepare_calls()
            return
        named = self._bundled(state_arguments(state))
        if has_fields(state):
            self._bundled({"fields": kernel_argument(self.scratch.fields)})
            for turn in (0, 1):  # they alone ask for a table of the state by itself
                self._calls[apply_fields, turn][0].exchange(parameters(apply_fields), named)

    def _watched(self, part: Any, call: Call) -> Callable[[], Any]:
        """What to run for a call of an entry point."""
        return call

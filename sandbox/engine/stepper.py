"""What steps one world: the calls of the compiled parts of the step, and the scratch memory they share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sandbox._jit import Call, kernel_argument
from sandbox.engine.compile_step import compile_continuous, compile_step
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.fields.apply import apply_fields
from sandbox.engine.fields.records import has_fields
from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.memory.binding import bind
from sandbox.engine.memory.limit import room_for
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.step import collide, solve
from sandbox.errors import CapacityError
from sandbox.tables import Records
from sandbox.world.records import CONTACT
from sandbox.world.state import State

_FEW = 1000
"""So many shapes never make too many pairs."""


class Stepper:
    """Steps a state. Whoever replaces its arrays calls `renew`, whoever switches a joint `assemble_joints`."""

    scratch: Scratch
    counters: Any
    """The row of counters as a plain array, which is ten times faster to ask."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._turn = self._broken = 0
        self._layouts = PartLayouts()
        self.renew()

    def compile(self) -> None:
        """Compile what the step needs, if it has not been on this machine: seconds."""
        compile_step(self.scratch.joints is not None)

    def step(self) -> None:
        """Take one step. Then `state.contacts` are those of it, `scratch.contacts.now` those of the step before.

        Raises `CapacityError`, and leaves the state as it was, if there are too many pairs.
        """
        before = self._copies() if self._crowded else ()
        if self._fields:
            self._fields[self._turn]()
        try:
            while not self._advance():
                pass
        except CapacityError:
            for table, copy in before:
                table[:] = copy
            self.forget()
            raise
        # A step reads the contacts of the last one while it writes the new ones.
        self._turn = 1 - self._turn
        self._state.contacts = self.scratch.contacts.now
        self.scratch.contacts = self._contacts[self._turn]
        if self.counters["broken_count"][0] != self._broken:
            self.assemble_joints()

    def renew(self) -> None:
        """Take new scratch memory, for as many pairs as the state has rows for contacts."""
        self.scratch = Scratch.for_state(self._state, len(self._state.contacts), self._layouts)
        self._prepare_calls()

    def forget(self) -> None:
        """Look anew at who may move: something was changed from outside."""
        self.scratch.active.info.stale = 1

    def assemble_joints(self) -> None:
        """Find out anew what hangs together by joints, after one of them broke or was switched."""
        self.scratch.joint_filter, self.scratch.joints = assemble(self._state.joints, self._state.bodies, self._layouts)
        self._prepare_calls()

    def _copies(self) -> Sequence[tuple[Records, Records]]:
        """What a step has changed by the time that it may be refused, with copies."""
        tables = (self._state.counters, *((self._state.bodies,) if self._fields else ()))
        return [(table, table.copy()) for table in tables]

    def _advance(self) -> bool:
        """Take a step; False if it lacked scratch memory, which it has now: then nothing else has changed."""
        collide, solve, solve_continuous = self._parts[self._turn]
        lacking_pairs = collide()
        if lacking_pairs:
            self._make_room(lacking_pairs)
            return False
        if solve():
            compile_continuous()
            solve_continuous()
        return True

    def _make_room(self, pairs: int) -> None:
        """Grow scratch memory to that many pairs, and half as many more if there is room for that."""
        old, contacts = self.scratch, self._state.contacts
        count = int(self.counters["contact_count"][0])
        self._state.contacts = CONTACT.zeros(room_for(pairs))
        self._state.contacts[:count] = contacts[:count]
        self.renew()
        self.scratch.solver.free_motions.buoyed = (
            old.solver.free_motions.buoyed
        )  # the fields of this step have been applied

    def _prepare_calls(self) -> None:
        """The calls of a step: some for even and some for odd steps, as the contact tables swap places."""
        state, scratch = self._state, self.scratch
        self._turn = 0
        self._crowded = len(state.shapes) > _FEW
        self.counters = kernel_argument(state.counters)
        self._broken = int(self.counters["broken_count"][0])
        self._parts: list[tuple[Call, ...]] = []
        self._fields: list[Call] = []
        first = scratch.contacts._replace(before=state.contacts)
        second = first._replace(now=first.before, before=first.now)
        self._contacts = (first, second)
        for scratch.contacts in (second, first):
            state.contacts = scratch.contacts.before
            self._parts.insert(0, tuple(self._call(part) for part in (collide, solve, solve_continuous)))
            if has_fields(state):
                self._fields.insert(0, self._call(apply_fields))

    def _call(self, part: Any) -> Call:
        return Call(part, bind(part, self._state, self.scratch))

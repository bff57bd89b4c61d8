"""What steps one world: the scratch memory of its steps, kept in order as rows come and go, and their calls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from sandbox._jit import jit_enabled
from sandbox.engine.active.changes import forget, keep_what_stays, touch
from sandbox.engine.compile_step import compile_step, wait_for_others
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.wiring import wiring
from sandbox.engine.memory.bundles import Room
from sandbox.engine.memory.joint_keeper import JointKeeper
from sandbox.engine.memory.limit import room_for
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.narrow_phase.kept_runs import keep_runs
from sandbox.engine.narrow_phase.resting import AtRest
from sandbox.engine.records.calls import COLLIDE, CONTINUOUS, FIELDS, SOLVE
from sandbox.engine.run_steps import (
    ASLEEP,
    DONE,
    FIRST,
    LACKS_CONTINUOUS,
    LACKS_IMPACTS,
    LAST_SWITCH,
    LOST,
    STEPS,
    TURN,
    WORK,
)
from sandbox.engine.step_calls import StepCalls
from sandbox.engine.workers.threads import WorkerThreads
from sandbox.errors import CapacityError
from sandbox.tables import Integers, Records, close_up, copy_rows, plain
from sandbox.world.records import CONTACT, CounterPlace
from sandbox.world.rows import Added, Moved
from sandbox.world.state import State, apply_deferred

_FEW = 1000
"""So many shapes never make too many pairs."""
_AT_ONCE = 4096
"""Awake bodies and contacts of all steps that are taken in one call: some 2 ms, in which nobody can interrupt it."""
_WORTH_SHARING = 8000
"""Awake bodies, their contacts and joints from which on several workers are sooner done: with half as many, fetching
what the other one has written takes as long as is saved."""

_ROWS, _JOINTS = 1, 2
"""What the calls of a step do not know yet: other tables of the state, and what is known of joints."""


class Stepper:
    """Steps a state. Whoever adds or removes rows calls `add_rows` or `move_rows`, whoever replaces its arrays `renew`,
    whoever switches a joint `assemble_joints`."""

    scratch: Scratch
    """What it has of joints may be due: `settle_joints`."""
    counters: memoryview
    """The row of counters as whole numbers, by the places in `CounterPlace`, which is five times faster to ask."""

    def __init__(self, state: State, workers: int = 1, calls: StepCalls | None = None) -> None:
        self._state = state
        self.workers = workers if jit_enabled() else 1
        self._threads = WorkerThreads(self.workers - 1) if self.workers > 1 else None
        self._lost = 0
        self._room = Room.of(state)
        self._compiled: set[frozenset[int]] = set()
        """What steps have needed until now."""
        self._joints = JointKeeper(PartLayouts(self.workers, float(state.settings[0].units_per_meter)))
        self.calls = calls or StepCalls(self.workers)
        self._order = self.calls.order.data  # which is asked five times faster
        self.renew()

    def compile(self) -> None:
        """Compile what the step needs, if it has not been on this machine: seconds."""
        apply_deferred(self._state)  # which may exchange more than has been already
        if self._exchanged:
            self._exchange()
        if self.calls.bound:
            return
        needs = self.calls.needs
        first = needs not in self._compiled
        impacts = first and bool((plain(self._state.shapes)["restitution"] > 0.0).any())
        if first:
            compile_step(*self.calls.lacking(impacts))
            self._compiled.add(needs)
        if len(self._state.bodies) + len(self._state.joints) >= _WORTH_SHARING // 4:  # else it may never be needed
            self.bind_workers()
        self.calls.bind()
        if first:
            self.calls.bind_made(impacts)

    def machine(self) -> Integers:
        """The table of parts for even and for odd steps (`run_steps`), none of which is to be compiled any more."""
        self._compile_continuous()
        return self.calls.parts

    @property
    def turn(self) -> int:
        """0 before an even step, 1 before an odd one."""
        return self._order[TURN]

    @property
    def contact_tables(self) -> tuple[Records, Records]:
        """The tables that an even and an odd step find the contacts of the step before in."""
        even, odd = self._contacts
        return even.before, odd.before

    def bind_workers(self) -> Sequence[Callable[[], Any]]:
        """What the other workers run in the next step, compiled if need be."""
        return self.calls.bind_workers(self.turn)

    def advance(self, steps: int, last_switch: int, singly: bool) -> tuple[int, int]:
        """Take so many steps, or some of them, at least one, if they take long or each is to be seen `singly`. Regions
        and thrusters begin or cease to act in the step `last_switch`, or earlier.

        Returns how many were taken, and how many were only counted after these, as everybody slept. Then
        `state.contacts` are those of the last one, `scratch.contacts.now` those of the one before.

        Raises `CapacityError`, and leaves the state as it was before the step that has too many pairs.
        """
        self.compile()
        before = self._state.bodies.tobytes() if self._crowded and self.calls.has_fields else None
        order = self._order
        order[STEPS], order[LAST_SWITCH], order[FIRST] = steps, last_switch, FIELDS
        order[WORK] = 0 if singly or before is not None or self._threads is not None else _AT_ONCE
        try:
            came = self._run()
        except CapacityError:
            if before is not None:  # of what the state has only fields have changed something by then
                self._state.bodies[:] = np.frombuffer(before, self._state.bodies.dtype)
            self.forget()
            raise
        if self._lost != self.counters[CounterPlace.BROKEN] + self.counters[CounterPlace.FROZEN]:
            self.assemble_joints()
        left = order[STEPS]
        return steps - left, left if came == ASLEEP else 0

    def renew(self) -> None:
        """Take new scratch memory, for as many pairs as the state has rows for contacts."""
        self.scratch = Scratch.for_state(
            self._state, len(self._state.contacts), self._joints.layouts, self._room, self.workers
        )
        self._room = self.scratch.room
        self._order[TURN] = 0
        self._prepare_calls()

    def add_rows(self, added: Added) -> None:
        """Rows have come after all others."""
        state, scratch = self._state, self.scratch
        grown = scratch.follow_rows(state, added.bodies, added.shapes)
        if grown:
            self._room = scratch.room
            scratch.make_room_for_joints()
        if len(state.joints) > added.joints:
            self._joints.add(state, scratch, added.joints)
        if grown:
            self._prepare_calls()
        else:
            self._exchanged |= _ROWS | (_JOINTS if len(state.joints) > added.joints else 0)

    def move_rows(self, moved: Moved) -> None:
        """Rows have gone, and others have moved into their places."""
        self.scratch.follow_rows(self._state, moved.bodies.first, moved.shapes.first)
        keep_what_stays(self.scratch.active, self.scratch.grid, moved)
        keep_runs(self.scratch.active, self.scratch.contacts, moved)
        close_up(plain(self.scratch.contacts.reports)[: len(moved.contacts)], moved.contacts)
        of_joints = self._joints.move(self._state, self.scratch, moved)
        self._exchanged |= _ROWS | (_JOINTS if of_joints else 0)

    def follow_regions(self) -> None:
        """Regions have gone, or have other sides."""
        self.scratch.follow_fields(self._state)
        self._exchanged |= _ROWS

    def forget(self) -> None:
        """Look anew at who may move: anything may have been changed from outside."""
        forget(self.scratch.active)

    def touch(self, rows: Sequence[int]) -> None:
        """Look anew at the bodies that may move, and at others in those rows: they were changed from outside."""
        touch(self.scratch.active, rows)

    def assemble_joints(self) -> None:
        """Find out anew what hangs together by joints, before somebody asks: one of them broke or was switched."""
        self._joints.forget()
        self._exchanged |= _ROWS | _JOINTS

    def settle_joints(self) -> None:
        """Find out what hangs together by joints, where that was put off."""
        self._joints.settle(self._state, self.scratch)

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

    def _run(self) -> int:
        """Run the steps that are ordered: `DONE` or `ASLEEP`."""
        order = self._order
        while True:
            order[LOST] = self._lost
            if self._threads is None or not self._is_worth_sharing():
                came = self.calls.run()
            else:
                with self._threads.serving(self.scratch.workers, self.bind_workers()):
                    came = self.calls.run()
            here = self._contacts[order[TURN]]  # a step reads the contacts of the last one while it writes the new ones
            self._state.contacts, self.scratch.contacts = here.before, here
            if came in (DONE, ASLEEP):
                return came
            order[FIRST] = self._provide(came)

    def _provide(self, lacking: int) -> int:
        """See to what the parts of a step lack; returns which one to go on from."""
        if lacking == LACKS_CONTINUOUS:
            self._compile_continuous()
            return CONTINUOUS
        if lacking == LACKS_IMPACTS:
            for part in self.calls.of_impacts:
                wait_for_others(part)
            self.calls.bind_impacts()
            return SOLVE
        self._make_room(lacking)
        self.compile()
        return COLLIDE

    def _compile_continuous(self) -> None:
        """Compile the last part of a step, which few steps need."""
        self.compile()
        wait_for_others(solve_continuous)
        self.calls.bind_continuous()

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
        """Other tables for the calls of a step."""
        state, scratch = self._state, self.scratch
        self.settle_joints()
        self._crowded = len(state.shapes) > _FEW
        self._exchanged = 0
        self.counters = plain(state.counters).view(np.int64).data
        self._count_lost()
        here = scratch.contacts._replace(before=state.contacts)
        there = here._replace(now=here.before, before=here.now)
        state.resting = AtRest(scratch.active, here)
        self._contacts = (here, there) if self.turn == 0 else (there, here)
        self.calls.fill(state, scratch, self._contacts)

    def _exchange(self) -> None:
        """Other rows of the state for the calls of a step, and what is known of its joints if those are others."""
        state, joints = self._state, bool(self._exchanged & _JOINTS)
        self.settle_joints()
        if not self.calls.fits(state, self.scratch):
            self._prepare_calls()
            return
        self._crowded = len(state.shapes) > _FEW
        if joints:
            self._count_lost()
        self.calls.exchange_rows(state, self.scratch, joints)
        self._exchanged = 0

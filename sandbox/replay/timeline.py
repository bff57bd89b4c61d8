"""A session as it is played: every step of it at will, other futures from there, and undo of all that was done."""

from __future__ import annotations

import time
from collections.abc import Sequence

from sandbox.attributes import FixedAttributes
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.drags import EndDrag
from sandbox.engine.world import World
from sandbox.errors import ArgumentError, SandboxError
from sandbox.replay.deeds import Deeds
from sandbox.replay.golden.run import Run, RunStepper
from sandbox.replay.keyframes import Keyframes
from sandbox.replay.moment import Future, Mark, Moment, common_prefix, parting
from sandbox.replay.playhead import Playhead
from sandbox.replay.recording.command_words import TimedCommand, plain_command
from sandbox.replay.recording.limits import MAX_STEPS
from sandbox.replay.recording.recorder import recording_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.recording.tape import Tape
from sandbox.scene import Scene

BUDGET = 256 * 1024 * 1024
"""Bytes of keyframes."""
UNDO_LEVELS, MOST_BRANCHES = 500, 30


class Timeline(FixedAttributes):
    """A live run of `scene`: `step` takes the known future first and then goes on, `apply` begins another one.

    A future whose place another one takes becomes one of the `branches`, to which `switch` leads. Acts are groups of
    commands that are undone as one: `begin_act` says where one begins. `script` is what a recording did; it is known
    from the start, up to `length` steps.
    """

    __slots__ = (
        "_branches",
        "_cost",
        "_cuts",
        "_deeds",
        "_head",
        "_length",
        "_redo",
        "_stepper",
        "_tape",
        "_undo",
        "scene",
    )

    def __init__(
        self, scene: Scene, script: Sequence[TimedCommand] = (), length: int = 0, workers: int = 1, budget: int = BUDGET
    ) -> None:
        self.scene = scene
        self._stepper = RunStepper(scene, script, workers)
        self._head = Playhead(self._stepper, Keyframes(budget))
        self._tape = Tape()
        self._length = length
        self._undo: list[Moment] = []
        self._redo: list[Moment] = []
        self._branches: tuple[Future, ...] = ()
        self._deeds = Deeds()
        self._cost = 0.0
        self._cuts: list[int] = []

    @property
    def world(self) -> World:
        """The world at this step: look at it, but step and change it through the timeline."""
        return self._stepper.world

    @property
    def step_count(self) -> int:
        """The step at which the timeline stands."""
        return self._stepper.step

    @property
    def length(self) -> int:
        """The last step that is known."""
        return max(self._length, self.step_count)

    @property
    def cost(self) -> float:
        """Seconds that the last step took the world."""
        return self._cost

    @property
    def cuts(self) -> Sequence[int]:
        """The steps after which another future began, in the order of the user's time; what was seen of the old future
        holds no more. It only grows: who keeps something for each step compares its length with what it was."""
        return self._cuts

    @property
    def at_end(self) -> bool:
        """Whether what comes next is not known yet."""
        return self.step_count >= self._length and self._stepper.applied >= len(self._stepper.commands)

    @property
    def tape(self) -> Tape:
        """What was noted of the steps taken: look at it only."""
        return self._tape

    @property
    def run(self) -> Run:
        """All that is known, as data."""
        return Run(self.scene, self.length, tuple(self._stepper.commands))

    @property
    def commands(self) -> list[TimedCommand]:
        """All that is known to be done, with the steps it comes after. Another list once a future was forgotten."""
        return self._stepper.commands

    @property
    def act_steps(self) -> list[int]:
        """The steps after which something was done, in order, each once."""
        return list(dict.fromkeys(step for step, _ in self._stepper.commands))

    @property
    def undo_label(self) -> str | None:
        """What `undo` would take back; None if there is nothing."""
        return self._undo[-1].label if self._undo else None

    @property
    def redo_label(self) -> str | None:
        """What `redo` would bring back; None if there is nothing."""
        return self._redo[-1].label if self._redo else None

    @property
    def branches(self) -> Sequence[Future]:
        """The other futures, the latest one last. Undo brings back those of its time."""
        return self._branches

    def parts_from(self, branch: Future) -> int | None:
        """The step after which another future goes its own way; None if it only is longer or shorter."""
        return parting(self.commands, branch.script())[1]

    def step(self) -> None:
        """Take a step. Raises what a known command raises that cannot be applied: it and all after it are forgotten."""
        self._head.keep()
        try:
            self._stepper.apply_due()
        except SandboxError:
            self._forget_coming()
            raise
        begin = time.perf_counter()
        self.world.step()
        self._cost = time.perf_counter() - begin
        self._length = max(self._length, self.step_count)
        if self.step_count <= MAX_STEPS:
            self._tape.note(self.world)

    def seek(self, step: int) -> None:
        """Go to a step from 0 to `length`; at the last one, with all that was done after it.

        The step itself is taken, so that its events are known as well. Raises `ArgumentError` for other steps.
        """
        if not 0 <= step <= self.length:
            raise ArgumentError(f"step {step} is not one of 0 to {self.length}")
        self._head.go(step, self.step)
        if step >= self._length:
            self._stepper.apply_due()

    def begin_act(self, label: str) -> None:
        """What is applied from now on is undone as one; `label` says what it is, such as "Delete crate"."""
        self._undo.append(self._moment(label))
        self._deeds.begin(label)
        del self._undo[:-UNDO_LEVELS]

    def end_act(self) -> None:
        """Forget the last act if nothing came of it."""
        if self._undo and self._undo[-1] == self._moment(self._undo[-1].label):
            self._undo.pop()

    def begin_again(self, commands: Sequence[TimedCommand] = ()) -> None:
        """Go to the start and know nothing but `commands` of what comes; an act of its own, to be undone."""
        self.begin_act("Restart")
        self._redo.clear()
        script = list(commands)
        lost = len(self.commands) > common_prefix(self.commands, script)
        branches = self._with_mine() if lost else self._branches
        self._resume(Moment("Restart", Future("", script, len(script), Tape(), 0), 0, 0, branches))

    def switch(self, number: int) -> None:
        """Know that one of the `branches` instead of this future, which becomes one of them; an act of its own.

        Goes to the step after which they part. Raises `ArgumentError` if there is no such branch.
        """
        if not 0 <= number < len(self._branches):
            raise ArgumentError(f"branch {number} is not one of the {len(self._branches)} that there are")
        wanted = self._branches[number]
        self.begin_act("Other future")
        self._redo.clear()
        common, step = parting(self.commands, wanted.script())
        step = min(self.step_count, wanted.length) if step is None else step
        branches = tuple(branch for branch in self._with_mine() if branch is not wanted)
        applied = common if step < wanted.length else wanted.known
        self._resume(Moment(wanted.label, wanted, step, applied, branches))

    def apply(self, command: Command) -> None:
        """Apply a command; a future that was known is forgotten. Raises what `World.apply` raises, and forgets nothing.

        Drags that the forgotten future would have ended end here.
        """
        self._apply(command, frozenset() if self.at_end else self._held())

    def mark(self) -> Mark:
        """This place in the run, for `amend`."""
        held = frozenset() if self.at_end else self._held()
        return Mark(self.step_count, self._stepper.applied, self.world.snapshot(), held)

    def amend(self, mark: Mark, *commands: Command) -> None:
        """Apply commands instead of those that were applied since `mark`, for what is adjusted by hand.

        If steps have been taken since, nothing is taken back. Raises what `World.apply` raises.
        """
        if self.step_count == mark.step and self._stepper.applied > mark.applied:
            self._stepper.take_back(mark.snapshot, mark.applied)
        for command in commands:
            self._apply(command, mark.held)

    def undo(self) -> str | None:
        """Go to where the last act began, as if it had never been; gives its label, None if there is none."""
        return self._swap(self._undo, self._redo)

    def redo(self) -> str | None:
        """Go to where the last `undo` came from; gives the label of the act, None if there is none."""
        return self._swap(self._redo, self._undo)

    def recording(self) -> Recording:
        """All that is known as a recording, also what comes after this step.

        Raises `RecordingError` before the first step and after the millionth.
        """
        here, applied = self.step_count, self._stepper.applied
        self.seek(self.length)
        try:
            return recording_of(self.world, self._stepper.commands, self._tape)
        finally:
            self._place(here, applied)

    def _apply(self, command: Command, ending: frozenset[str]) -> None:
        command, stepper = plain_command(command), self._stepper
        self.world.apply(command)
        self._redo.clear()
        if not self.at_end:
            if self.length > self.step_count:
                self._branches = self._with_mine()
            self._forget_coming()
        stepper.note(command)
        self._deeds.note(stepper.commands[stepper.applied - 1])
        for name in sorted(ending & self._held() - {getattr(command, "body", None)}):
            stepper.add(EndDrag(name))

    def _held(self) -> frozenset[str]:
        """The bodies that hands hold."""
        return frozenset(self.world.names[drag.body] for drag in self.world.state.drags if drag.body >= 0)

    def _place(self, step: int, applied: int, anew: bool = False) -> None:
        """To a step at which just so many commands have been applied."""
        if anew or (step, applied) != (self.step_count, self._stepper.applied):
            self._head.go(step, self.step, anew)
            self._stepper.apply_due(applied)

    def _forget_coming(self) -> None:
        """Cut the run off here; moments that know more of it keep their own lists."""
        self._cuts.append(self.step_count)
        self._stepper.forget_coming()
        self._tape = self._tape.up_to(self.step_count)
        self._head.part(self.step_count)
        self._length = self.step_count

    def _moment(self, label: str) -> Moment:
        return Moment(label, self._future(label), self.step_count, self._stepper.applied, self._branches)

    def _future(self, label: str) -> Future:
        commands = self._stepper.commands
        return Future(label, commands, len(commands), self._tape, self.length)

    def _with_mine(self) -> tuple[Future, ...]:
        """The branches, and this future as one of them."""
        return (*self._branches, self._future(self._deeds.label(self.commands)))[-MOST_BRANCHES:]

    def _swap(self, from_stack: list[Moment], to_stack: list[Moment]) -> str | None:
        if not from_stack:
            return None
        moment = from_stack.pop()
        to_stack.append(self._moment(moment.label))
        self._resume(moment)
        return moment.label

    def _resume(self, moment: Moment) -> None:
        """Be at a moment again, and know what was known then."""
        stepper, future, theirs = self._stepper, moment.future, moment.future.script()
        common, parted = parting(stepper.commands, theirs)
        if parted is not None:
            self._cuts.append(parted)
            self._head.part(parted)
        stepper.commands, self._tape, self._length = theirs, future.tape.up_to(future.length), future.length
        self._branches = moment.branches
        self._place(moment.step, moment.applied, anew=stepper.applied > common or _past(self.step_count, parted))


def _past(step: int, parted: int | None) -> bool:
    """Whether a step has been taken after two runs parted."""
    return parted is not None and step > parted

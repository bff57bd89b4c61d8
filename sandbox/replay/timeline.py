"""A session as it is played: every step of it at will, other futures from there, and undo of all that was done."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass

from sandbox.attributes import FixedAttributes
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.drags import EndDrag
from sandbox.engine.world import World
from sandbox.errors import ArgumentError, SandboxError
from sandbox.replay.golden.run import Run, RunStepper
from sandbox.replay.keyframes import Keyframe, Keyframes
from sandbox.replay.recording.command_words import TimedCommand, plain_command
from sandbox.replay.recording.limits import MAX_STEPS
from sandbox.replay.recording.recorder import recording_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.recording.tape import Tape
from sandbox.scene import Scene

BUDGET = 256 * 1024 * 1024
"""Bytes of keyframes."""
UNDO_LEVELS = 500


@dataclass(frozen=True)
class Moment:
    """A place in a run: after `step` steps and `applied` commands, of a run known up to `length` steps.

    The lists are those of that time; what is appended to them later is not part of the moment, so counts go with them.
    """

    label: str
    commands: list[TimedCommand]
    known: int
    tape: Tape
    length: int
    step: int
    applied: int


@dataclass(frozen=True)
class Mark:
    """A place in a run to which commands can be taken back; `held` are drags of a future that they will replace."""

    step: int
    applied: int
    snapshot: bytes
    held: frozenset[str]


class Timeline(FixedAttributes):
    """A live run of `scene`: `step` takes the known future first and then goes on, `apply` begins another one.

    Acts are groups of commands that are undone as one: `begin_act` says where one begins. `script` is what a recording
    did; it is known from the start, up to `length` steps.
    """

    __slots__ = ("_cost", "_cuts", "_frames", "_length", "_redo", "_stepper", "_tape", "_undo", "scene")

    def __init__(
        self, scene: Scene, script: Sequence[TimedCommand] = (), length: int = 0, workers: int = 1, budget: int = BUDGET
    ) -> None:
        self.scene = scene
        self._stepper = RunStepper(scene, script, workers)
        self._frames = Keyframes(budget)
        self._tape = Tape()
        self._length = length
        self._undo: list[Moment] = []
        self._redo: list[Moment] = []
        self._cost = 0.0
        self._cuts: list[int] = []
        self._keep()

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

    def step(self) -> None:
        """Take a step. Raises what a known command raises that cannot be applied: it and all after it are forgotten."""
        self._keep()
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
        self._go(step)
        if step >= self._length:
            self._stepper.apply_due()

    def begin_act(self, label: str) -> None:
        """What is applied from now on is undone as one; `label` says what it is, such as "Delete crate"."""
        self._undo.append(self._moment(label))
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
        self._resume(Moment("Restart", script, len(script), Tape(), 0, 0, 0))

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
            self._forget_coming()
        stepper.note(command)
        for name in sorted(ending & self._held() - {getattr(command, "body", None)}):
            stepper.add(EndDrag(name))

    def _held(self) -> frozenset[str]:
        """The bodies that hands hold."""
        return frozenset(self.world.names[drag.body] for drag in self.world.state.drags if drag.body >= 0)

    def _go(self, step: int, anew: bool = False) -> None:
        """To a step, the commands after it not yet applied; `anew` if the world does not belong to this run."""
        frame = self._frames.before(max(step, 1))
        if anew or step <= self.step_count or frame.step > self.step_count:
            self._stepper.restore(frame.snapshot, frame.applied)
        while self.step_count < step:
            self.step()

    def _place(self, step: int, applied: int, anew: bool = False) -> None:
        """To a step at which just so many commands have been applied."""
        if anew or (step, applied) != (self.step_count, self._stepper.applied):
            self._go(step, anew)
            self._stepper.apply_due(applied)

    def _forget_coming(self) -> None:
        """Cut the run off here; moments that know more of it keep their own lists."""
        self._cuts.append(self.step_count)
        self._stepper.forget_coming()
        self._tape = self._tape.up_to(self.step_count)
        self._frames = self._frames.up_to(self.step_count)
        self._length = self.step_count

    def _moment(self, label: str) -> Moment:
        stepper = self._stepper
        known = len(stepper.commands)
        return Moment(label, stepper.commands, known, self._tape, self.length, self.step_count, stepper.applied)

    def _swap(self, from_stack: list[Moment], to_stack: list[Moment]) -> str | None:
        if not from_stack:
            return None
        moment = from_stack.pop()
        to_stack.append(self._moment(moment.label))
        self._resume(moment)
        return moment.label

    def _resume(self, moment: Moment) -> None:
        """Be at a moment again, and know what was known then."""
        stepper = self._stepper
        mine, theirs = stepper.commands, moment.commands[: moment.known]
        common = common_prefix(mine, theirs)
        parting = min((step for step, _ in (*mine[common : common + 1], *theirs[common : common + 1])), default=None)
        if parting is not None:
            self._cuts.append(parting)
            self._frames = self._frames.up_to(parting)
        stepper.commands, self._tape, self._length = theirs, moment.tape.up_to(moment.length), moment.length
        self._place(moment.step, moment.applied, anew=stepper.applied > common or _past(self.step_count, parting))

    def _keep(self) -> None:
        """Keep a keyframe of this step if one is due."""
        if self._frames.wants(self.step_count):
            self._frames.add(Keyframe(self.step_count, self._stepper.applied, self.world.snapshot()))


def common_prefix(a: Sequence[TimedCommand], b: Sequence[TimedCommand]) -> int:
    """How many commands two runs begin with in common."""
    return next((i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x is not y), min(len(a), len(b)))


def _past(step: int, parting: int | None) -> bool:
    """Whether a step has been taken after two runs parted."""
    return parting is not None and step > parting

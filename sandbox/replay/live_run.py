"""A run that goes on as it is played: what is known of it at will, and another future from wherever it stands."""

from __future__ import annotations

import time
from collections.abc import Sequence

from sandbox.attributes import FixedAttributes
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.drags import EndDrag
from sandbox.engine.world import World
from sandbox.errors import ArgumentError, SandboxError
from sandbox.replay.golden.run import Run, RunStepper
from sandbox.replay.keyframes import Keyframes
from sandbox.replay.moment import Future, Mark, parting
from sandbox.replay.playhead import Playhead
from sandbox.replay.recording.command_words import TimedCommand, plain_command
from sandbox.replay.recording.limits import MAX_STEPS
from sandbox.replay.recording.recorder import recording_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.recording.tape import Tape
from sandbox.scene import Scene

BUDGET = 256 * 1024 * 1024
"""Bytes of keyframes."""


class LiveRun(FixedAttributes):
    """A live run of `scene`: `step` takes the known future first and then goes on, `apply` begins another one.

    `script` is what a recording did; it is known from the start, up to `length` steps.
    """

    __slots__ = ("_cost", "_cuts", "_head", "_length", "_reached", "_stepper", "_tape", "scene")

    def __init__(
        self, scene: Scene, script: Sequence[TimedCommand] = (), length: int = 0, workers: int = 1, budget: int = BUDGET
    ) -> None:
        self.scene = scene
        self._stepper = RunStepper(scene, script, workers)
        self._head = Playhead(self._stepper, Keyframes(budget))
        self._tape = Tape()
        self._length = length
        self._reached = 0
        """The last step that was seen of this run, which may be known no more: keyframes reach so far."""
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

    def step(self) -> None:
        """Take a step. Raises `RefusedCommandError` for a known command: it and all after it are forgotten."""
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
        self._reached = max(self._reached, self.step_count)
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

    def apply(self, command: Command) -> None:
        """Apply a command; a future that was known is forgotten. Raises what `World.apply` raises, and forgets nothing.

        Drags that the forgotten future would have ended end here.
        """
        self._apply(command, frozenset() if self.at_end else self._held())

    def mark(self) -> Mark:
        """This place in the run, for `amend`."""
        held = frozenset() if self.at_end else self._held()
        return Mark(self.step_count, self._stepper.applied, self.world.snapshot(), self.world.last_step, held)

    def amend(self, mark: Mark, *commands: Command) -> None:
        """Apply commands instead of those that were applied since `mark`, for what is adjusted by hand.

        If steps have been taken since, nothing is taken back. Raises what `World.apply` raises.
        """
        if self.step_count == mark.step and self._stepper.applied > mark.applied:
            self._stepper.take_back(mark.snapshot, mark.applied, mark.last_step)
        for command in commands:
            self._apply(command, mark.held)

    def recording(self) -> Recording:
        """All that is known as a recording, also what comes after this step.

        Raises `RecordingError` before the first step and after the millionth.
        """
        here, applied = self.step_count, self._stepper.applied
        self.seek(self.length)
        try:
            done = self._stepper.commands[: self._stepper.applied]  # others are known of a run that begins again
            return recording_of(self.world, done, self._tape)
        finally:
            self._place(here, applied)

    def _apply(self, command: Command, ending: frozenset[str]) -> None:
        command, stepper = plain_command(command), self._stepper
        self.world.apply(command)
        if not self.at_end or self.step_count < self._reached:
            self._forget_coming()
        stepper.note(command)
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
        self._part(self.step_count)
        self._stepper.forget_coming()
        self._tape = self._tape.up_to(self.step_count)
        self._length = self.step_count

    def _part(self, step: int) -> None:
        """The run goes another way after a step: what was seen of it from there on holds no more."""
        self._cuts.append(step)
        self._head.part(step)
        self._reached = min(self._reached, step)

    def _future(self, label: str) -> Future:
        """All that is known, under a name."""
        commands = self._stepper.commands
        return Future(label, commands, len(commands), self._tape, self.length)

    def _know(self, future: Future, step: int, applied: int) -> None:
        """Be at a place of a future, and know that one instead of this."""
        stepper, theirs = self._stepper, future.script()
        common, parted = parting(stepper.commands, theirs)
        if parted is not None:
            self._part(parted)
        past = parted is not None and self.step_count > parted
        stepper.commands, self._tape, self._length = theirs, self._tape_of(future, parted), future.length
        self._place(step, applied, anew=stepper.applied > common or past)

    def _tape_of(self, future: Future, parted: int | None) -> Tape:
        """What was noted of a future; of one that was read from a file, as far as it is the same run as this.

        What is noted next follows on that, so no keyframe may lie beyond it.
        """
        if len(future.tape) >= future.length:
            return future.tape.up_to(future.length)
        same = future.length if parted is None else min(parted, future.length)
        tape = max(self._tape.up_to(same), future.tape, key=len)
        self._head.part(len(tape) + 1)
        return tape

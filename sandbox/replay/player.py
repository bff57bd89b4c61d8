"""A player: any step of a run at will, forwards and backwards, and other futures from there."""

from __future__ import annotations

import copy

from sandbox.arguments import checked_count, checked_number
from sandbox.attributes import FixedAttributes
from sandbox.engine.commands.base import Command
from sandbox.engine.world import World
from sandbox.errors import ArgumentError, CommandError
from sandbox.replay.golden.run import Run, RunStepper, run_of
from sandbox.replay.keyframes import Keyframes
from sandbox.replay.playhead import Playhead
from sandbox.replay.recording.command_words import plain_command
from sandbox.replay.recording.recording import Recording
from sandbox.scene import Scene

BUDGET = 64 * 1024 * 1024
"""Bytes of keyframes that a player keeps if it is not told otherwise."""


class Player(FixedAttributes):
    """Plays a run in a `world` of its own; `seek` gives the bits of a straight run, whatever came before.

    `length` is the last step known; `step` goes on past it, `apply` adds a command at the end, and `branch` begins
    another future in the middle. Keyframes take at most `budget` bytes: with a longer run they stand farther apart.
    Raises `ArgumentError` for what is no run, and `SceneError` if the scene of a recording cannot be used.
    """

    __slots__ = ("_head", "_length", "_run", "_stepper")

    def __init__(self, run: Run | Recording | Scene, budget: int = BUDGET) -> None:
        known = run_of(run, "Player")
        self._begin(known, Keyframes(checked_number("Player", "the budget of bytes", budget, 0)))
        self._length = known.steps

    def __copy__(self) -> Player:
        """One that goes its own way, as a copy of a `World` does."""
        return copy.deepcopy(self)

    @property
    def world(self) -> World:
        """The world as it is at this step: look at it, but step and change it through the player."""
        return self._stepper.world

    @property
    def length(self) -> int:
        """The last step that is known."""
        return self._length

    @property
    def step_count(self) -> int:
        """The step at which the player stands."""
        return self._stepper.step

    @property
    def run(self) -> Run:
        """What has been played and is known, as data."""
        return Run(self._run.scene, self.length, tuple(self._stepper.commands))

    def step(self, n: int = 1) -> None:
        """Go on by `n` steps, past the end if need be. Raises `RefusedCommandError` and `CapacityError`."""
        for _ in range(checked_count("Player.step", n)):
            self._advance()
        self._length = max(self.length, self.step_count)

    def seek(self, step: int) -> None:
        """Go to a step from 0 to `length`. Its own step is taken, so that its events are known as well.

        The commands that come after `step` steps have not been applied then.
        """
        if checked_count("Player.seek", step) > self.length:
            raise ArgumentError(f"step {step} is not one of 0 to {self.length}")
        self._head.go(step, self._advance)

    def apply(self, command: Command) -> None:
        """Apply a command at the end of what is known; elsewhere `branch` first. Raises what `World.apply` does."""
        if self.step_count != self.length:
            raise CommandError(f"the run is known up to step {self.length}: branch() begins another one here")
        self._stepper.apply_due()
        self._stepper.add(plain_command(command))

    def branch(self) -> Player:
        """Another player that stands where this one does and knows nothing of what came later."""
        player = Player.__new__(Player)
        here = self.step_count
        commands = [row for row in self._stepper.commands if row[0] < here] + self._stepper.commands_done_at(here)
        player._begin(Run(self._run.scene, here, tuple(commands)), self._head.frames.up_to(here))
        player._length = here
        player._stepper.restore(self.world.snapshot(), self._stepper.applied, self.world.untold)
        return player

    def _begin(self, run: Run, frames: Keyframes) -> None:
        self._run = run
        self._stepper = RunStepper(run.scene, run.commands)
        self._head = Playhead(self._stepper, frames)

    def _advance(self) -> None:
        self._head.keep()
        self._stepper.advance()

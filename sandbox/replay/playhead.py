"""Where a run is played: a world that goes to any step of it, forwards from the nearest keyframe."""

from __future__ import annotations

from collections.abc import Callable

from sandbox.attributes import FixedAttributes
from sandbox.engine.world import World
from sandbox.replay.golden.run import RunStepper
from sandbox.replay.keyframes import Keyframe, Keyframes


class Playhead(FixedAttributes):
    """`stepper` takes the run, `frames` are kept of it on the way: whoever steps says `keep` before."""

    __slots__ = ("_frames", "stepper")

    def __init__(self, stepper: RunStepper, frames: Keyframes) -> None:
        self.stepper = stepper
        self._frames = frames
        self.keep()

    @property
    def world(self) -> World:
        """The world at this step."""
        return self.stepper.world

    @property
    def step(self) -> int:
        """Steps taken since the start."""
        return self.stepper.step

    @property
    def frames(self) -> Keyframes:
        """The keyframes of the run: look at them only."""
        return self._frames

    def keep(self) -> None:
        """Keep a keyframe of this step if one is due."""
        if self._frames.wants(self.step):
            self._frames.add(Keyframe(self.step, self.stepper.applied, self.world.snapshot(), self.world.untold))

    def go(self, step: int, advance: Callable[[], None], anew: bool = False) -> None:
        """To a step, the commands after it not yet applied; `advance` takes one, `anew` if the world is of another run.

        The step itself is taken, so that its events are known as well.
        """
        frame = self._frames.before(max(step, 1))
        # Forwards from here, unless a keyframe lies between or the way leads back.
        if anew or step <= self.step or frame.step > self.step:
            self.stepper.restore(frame.snapshot, frame.applied, frame.untold)
        while self.step < step:
            advance()

    def part(self, step: int) -> None:
        """The run goes another way after a step: forget the keyframes from there on."""
        self._frames = self._frames.up_to(step)

"""What a recording notes of a run while it goes on: a fingerprint after each step, figures now and then."""

from __future__ import annotations

from collections.abc import Sequence

from sandbox.engine.world import World
from sandbox.errors import Problem, RecordingError
from sandbox.replay.recording.checkpoint import EVERY, Checkpoint, checkpoint
from sandbox.replay.recording.fingerprint import fingerprint


class Tape:
    """Fingerprints of the steps from 1 on, and the checkpoints among them."""

    __slots__ = ("_checkpoints", "_digests")

    def __init__(self, digests: list[str] | None = None, checkpoints: list[Checkpoint] | None = None) -> None:
        self._digests = digests if digests is not None else []
        self._checkpoints = checkpoints if checkpoints is not None else []

    def __len__(self) -> int:
        return len(self._digests)

    @property
    def checkpoints(self) -> Sequence[Checkpoint]:
        """The figures noted up to now, in the order of their steps."""
        return self._checkpoints

    def digest(self, step: int) -> str | None:
        """The fingerprint after a step; None if it was not noted."""
        return self._digests[step - 1] if 0 < step <= len(self._digests) else None

    def note(self, world: World) -> None:
        """Note the step that `world` has just taken, unless it is one that was noted before."""
        if world.step_count <= len(self._digests):
            return
        self._digests.append(fingerprint(world.state))
        if world.step_count % EVERY == 0:
            self._checkpoints.append(checkpoint(world))

    def up_to(self, step: int) -> Tape:
        """A copy of the first `step` steps."""
        return Tape(self._digests[:step], [one for one in self._checkpoints if one.step <= step])

    def ended_by(self, world: World) -> tuple[tuple[str, ...], tuple[Checkpoint, ...]]:
        """All fingerprints and checkpoints, with one of the last step, where `world` stands.

        Raises `RecordingError` before the first step, and if the world has taken others than those that were noted.
        """
        steps = len(self._digests)
        if world.step_count != steps or steps == 0:
            missed = "has not taken a step yet" if steps == 0 else f"was stepped past the recorder after step {steps}"
            raise RecordingError("the world", [Problem(missed)])
        last = [] if steps % EVERY == 0 else [checkpoint(world)]
        return tuple(self._digests), (*self._checkpoints, *last)

"""Running a recording again and comparing: the one judge behind every way to replay."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

from sandbox.arguments import check_callback, check_kind
from sandbox.engine.arithmetic_version import ARITHMETIC, changes_since
from sandbox.errors import RefusedCommandError, SandboxError
from sandbox.replay.golden.divergence import Divergence, Drift
from sandbox.replay.golden.heavy import Twin
from sandbox.replay.golden.run import RunStepper
from sandbox.replay.golden.tolerance import Tolerance, compare_checkpoints, compare_poses, drifts_of
from sandbox.replay.recording.checkpoint import Checkpoint, checkpoint
from sandbox.replay.recording.fingerprint import fingerprint, first_difference
from sandbox.replay.recording.meaning import meaning_of
from sandbox.replay.recording.recorder import final_poses
from sandbox.replay.recording.recording import Recording
from sandbox.scene import Scene

Verdict = Literal["passed", "diverged", "stale"]
_REPORT_EVERY = 16
_WORST = 10


@dataclass(frozen=True)
class Outcome:
    """What came of running a recording again.

    `verdict`: "passed"; "diverged"; or "stale" if the scene was edited since (`edits` say what), whatever the run gave.
    `divergence` is where the two parted, None if they did not. `drifts` are the bodies that ended farthest from where
    they should, at most ten. `notes` say what else a person should know; `seconds` is the time it took.
    """

    verdict: Verdict
    steps: int
    seconds: float
    divergence: Divergence | None = None
    drifts: tuple[Drift, ...] = ()
    edits: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether all is as it was recorded."""
        return self.verdict == "passed"


def rerun(
    recording: Recording,
    *,
    tolerance: Tolerance | None = None,
    heavy: bool = False,
    on_steps: Callable[[int], None] | None = None,
) -> Outcome:
    """Run a recording again and compare: bit for bit, or by figures if a `tolerance` is given.

    With `heavy`, every step is also taken from a restored snapshot, and must come out the same. `on_steps` hears now
    and then how many steps are done. Raises `SceneError` if the scene cannot be used, and `ArgumentError`.
    """
    check_kind("rerun", "a Recording", recording, Recording)
    if tolerance is not None:
        check_kind("rerun", "a Tolerance", tolerance, Tolerance)
    check_callback("rerun", on_steps)
    begin = time.perf_counter()
    scene = recording.load_scene()
    edits = _edits(recording, scene)
    rerunning = _Rerun(recording, scene, tolerance, heavy)
    rerunning.run(on_steps)
    drifts = (
        () if rerunning.refused else tuple(drifts_of(recording.final, final_poses(rerunning.stepper.world)))[:_WORST]
    )
    parted = rerunning.parted or rerunning.judge_the_end(drifts)
    notes = ((rerunning.refused,) if rerunning.refused else ()) + (version_notes(recording) if parted else ())
    verdict: Verdict = "stale" if edits else "diverged" if parted else "passed"
    seconds = time.perf_counter() - begin
    shown = drifts if parted else ()
    return Outcome(verdict, rerunning.stepper.step, seconds, parted, shown, edits, notes)


@dataclass
class _Rerun:
    """The run under way; `parted` is where it left the recording."""

    recording: Recording
    scene: Scene
    tolerance: Tolerance | None
    heavy: bool
    parted: Divergence | None = None
    refused: str = ""
    figures: list[Checkpoint] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.stepper = RunStepper(self.scene, self.recording.commands)
        self.twin = Twin(self.scene, self.recording.commands) if self.heavy else None

    def run(self, on_steps: Callable[[int], None] | None) -> None:
        """Take all steps, or stop at a command that is refused."""
        wanted = {row.step for row in self.recording.checkpoints}
        try:
            for step in range(1, self.recording.steps + 1):
                self._step()
                if step in wanted:
                    self.figures.append(checkpoint(self.stepper.world))
                if on_steps is not None and step % _REPORT_EVERY == 0:
                    on_steps(step)
            self.stepper.apply_due()
        except RefusedCommandError as error:
            told = f"commands[{error.index}], {error.command}: {error.reason}"
            self.refused = f"the run ended after step {error.step}, for a command was refused: {told}"
            self._part("command", "a command that can be applied", told)
        except SandboxError as error:
            self.refused = f"the run ended after step {self.stepper.step}: {error}"
            self._part("command", "a step that can be taken", str(error))

    def judge_the_end(self, drifts: tuple[Drift, ...]) -> Divergence | None:
        """The verdict on what is compared only after the last step."""
        recording, rate = self.recording, self.recording.step_rate
        if self.tolerance is not None:
            found = compare_checkpoints(recording.checkpoints, self.figures, rate, self.tolerance)
            return found or compare_poses(drifts, recording.steps, rate, self.tolerance)
        got = self.stepper.world.digest()
        if got != recording.digest:
            return Divergence(recording.steps, recording.steps / rate, "rest", recording.digest, got)
        return None

    def _step(self) -> None:
        expected_by_twin = self.twin.step_from(self.stepper) if self.twin is not None else None
        self.stepper.advance()
        got = fingerprint(self.stepper.world.state)
        if expected_by_twin is not None and expected_by_twin != self.stepper.world.digest():
            self._part("state", "a restored snapshot to go the same way", "another digest after one step")
        if self.tolerance is None:
            differs = first_difference(self.recording.digests[self.stepper.step - 1], got)
            if differs is not None:
                self._part(*differs)

    def _part(self, group: str, expected: str, got: str) -> None:
        """Note where the runs part; only the first place counts."""
        if self.parted is None:
            step = self.stepper.step
            self.parted = Divergence(step, step / self.recording.step_rate, group, expected, got)


def _edits(recording: Recording, scene: Scene) -> tuple[str, ...]:
    now = meaning_of(scene.flatten())
    return () if now.whole == recording.scene.meaning.whole else tuple(recording.scene.meaning.changes(now))


def version_notes(recording: Recording) -> tuple[str, ...]:
    """What is to be known of the version that recorded this, if its arithmetic is not that of this one."""
    if recording.arithmetic == ARITHMETIC:
        return ()
    if recording.arithmetic > ARITHMETIC:
        return (f"recorded by a later version, sandbox {recording.version} (arithmetic {recording.arithmetic})",)
    return (
        f"the engine's arithmetic was changed on purpose since sandbox {recording.version} recorded this:",
        *changes_since(recording.arithmetic),
    )

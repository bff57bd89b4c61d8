"""The run that a recording was made of, found again: a recording holds fingerprints, but no trajectory.

If the scene or a command was edited, the earlier file may be in git. What is found is believed only if running it gives
the recorded fingerprints up to and past the step where the runs part.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sandbox.errors import SandboxError
from sandbox.replay.golden.run import Run, Stage
from sandbox.replay.recording.fingerprint import fingerprint
from sandbox.replay.recording.meaning import meaning_of
from sandbox.replay.recording.read import loads_recording
from sandbox.replay.recording.recording import Recording
from sandbox.report.history import earlier_texts
from sandbox.scene import Scene
from sandbox.scene.load import loads_scene

_PAST = 30
"""Steps after the parting that must agree as well."""


@dataclass(frozen=True)
class Expected:
    """A run that gives what was recorded, and where it was found, in words."""

    run: Run
    origin: str


def expected_run(recording: Recording, parted: int) -> Expected | None:
    """The recorded run, if it can be had; `parted` is the step after which another one differs from it."""
    found = (one for one in _candidates(recording) if _gives(one.run, recording, min(parted + _PAST, recording.steps)))
    return next(found, None)


def _candidates(recording: Recording) -> Iterator[Expected]:
    scene = recording.load_scene()
    wanted = recording.scene.meaning.whole
    if meaning_of(scene.flatten()).whole == wanted:
        yield from _with_other_commands(recording, scene)
    else:
        for revision, old in _earlier_scenes(recording):
            if meaning_of(old.flatten()).whole == wanted:
                origin = f"{recording.scene.path.name if recording.scene.path else 'the scene'} of revision {revision}"
                yield Expected(Run(old, recording.steps, recording.commands), origin)
                return


def _earlier_scenes(recording: Recording) -> Iterator[tuple[str, Scene]]:
    path = recording.scene.path
    for revision, text in earlier_texts(path) if path is not None else ():
        try:
            yield revision, loads_scene(text, str(path))
        except SandboxError:
            continue


def _with_other_commands(recording: Recording, scene: Scene) -> Iterator[Expected]:
    """An earlier version of the recording may have the commands that its fingerprints were made with."""
    path = recording.source
    if path is None:
        return
    for revision, text in earlier_texts(path):
        try:
            old = loads_recording(text, path)
        except SandboxError:
            continue
        same = old.digests == recording.digests and old.scene.meaning.whole == recording.scene.meaning.whole
        if same and old.commands != recording.commands:
            commands = f"the commands of {path.name} of revision {revision}"
            yield Expected(Run(scene, old.steps, old.commands), commands)


def _gives(run: Run, recording: Recording, steps: int) -> bool:
    stage = Stage(run.scene, run.commands)
    try:
        for wanted in recording.digests[:steps]:
            stage.advance()
            if fingerprint(stage.world.state) != wanted:
                return False
    except SandboxError:
        return False
    return True

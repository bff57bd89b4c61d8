"""The run that a recording was made of, found again: a recording holds fingerprints, but no trajectory.

If the scene or a command was edited, the earlier file may be in git, or be the scene of that name that comes with the
package. What is found is believed only if running it gives the recorded fingerprints up to and past the step where the
runs part.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain, islice
from typing import Any, Literal

from sandbox.errors import SandboxError
from sandbox.replay.causes.command_edits import command_edits, located
from sandbox.replay.causes.history import earlier_texts
from sandbox.replay.causes.scene_edits import MOST, edits, edits_in_text
from sandbox.replay.golden.run import Run, RunStepper
from sandbox.replay.golden.source_location import posix
from sandbox.replay.recording.fingerprint import fingerprint
from sandbox.replay.recording.meaning import meaning_of
from sandbox.replay.recording.read import loads_recording
from sandbox.replay.recording.recording import Recording
from sandbox.replay.recording.recording_fields import RecordingFields
from sandbox.resources import shipped_scenes
from sandbox.scene import Scene
from sandbox.scene.load import loads_scene
from sandbox.scene.parse import parse

_PAST = 30
"""Steps after the parting that must agree as well."""


@dataclass(frozen=True)
class Expected:
    """A run that gives what was recorded, where it was found, and what was changed since, in words."""

    run: Run
    origin: str
    kind: Literal["scene", "command"]
    said: tuple[str, ...]


def expected_run(recording: Recording, parted: int) -> Expected | None:
    """The recorded run, if it can be had; `parted` is the step after which another one differs from it."""
    return next((one for one in candidates(recording) if gives(one.run, recording, parted)), None)


def candidates(recording: Recording) -> Iterator[Expected]:
    """Runs that may be the recorded one: with an earlier scene, or earlier commands."""
    scene = recording.load_scene()
    if _means(scene, recording):
        yield from _with_other_commands(recording, scene)
        return
    if recording.scene.path is None:
        yield from _with_other_content(recording, scene)
        return
    for where, old in _earlier_scenes(recording):
        if _means(old, recording):
            said = _file_edits(old, scene)
            yield Expected(Run(old, recording.steps, recording.commands), where, "scene", said)
            return


def _means(scene: Scene, recording: Recording) -> bool:
    return meaning_of(scene.flatten()).whole == recording.scene.meaning.whole


def _earlier_scenes(recording: Recording) -> Iterator[tuple[str, Scene]]:
    path = recording.scene.path
    if path is None:
        return
    texts = ((f"{path.name} of revision {revision}", text) for revision, text in earlier_texts(path))
    shipped = (one for one in shipped_scenes() if one.name == path.name and one.resolve() != path.resolve())
    known = (("the scene of that name that comes with the package", one.read_text(encoding="utf-8")) for one in shipped)
    for source in (texts, known):
        for where, text in source:
            try:
                yield where, loads_scene(text, str(path), recording.scene.set)
            except SandboxError:
                continue


def _file_edits(old: Scene, new: Scene) -> tuple[str, ...]:
    if old.text is None or new.text is None:
        return ()
    before, after = (parse(scene.text or "", scene.source).data for scene in (old, new))
    return edits_in_text(before, after, new.text, posix(new.source))


def _with_other_content(recording: Recording, scene: Scene) -> Iterator[Expected]:
    """The scene stands in the recording itself, and was edited there or in the test that makes it."""
    for where, old in _earlier_recordings(recording):
        content = old.scene.content
        if content is not None and _means(content, recording):
            said = _content_edits(recording, content.to_data(), scene.to_data())
            yield Expected(Run(content, recording.steps, recording.commands), where, "scene", said)
            return


def _content_edits(recording: Recording, old: dict[str, Any], new: dict[str, Any]) -> tuple[str, ...]:
    text = recording.source.read_text(encoding="utf-8") if recording.source is not None else "{}"
    written = parse(text, str(recording.source)).data.get("scene", {}).get("content", {})
    if any(edits(written, new)):  # the scene of now stands somewhere else
        return tuple(str(edit) for edit in islice(edits(old, new), MOST))
    return edits_in_text(old, new, text, posix(recording.source or ""), ("scene", "content"))


def _with_other_commands(recording: Recording, scene: Scene) -> Iterator[Expected]:
    """An earlier version of the recording may have the commands that its fingerprints were made with."""
    for where, old in _earlier_recordings(recording):
        if old.scene.meaning.whole == recording.scene.meaning.whole and old.commands != recording.commands:
            found = command_edits(old.commands, recording.commands)
            file = recording.source
            said = located(found, file.read_text(encoding="utf-8"), posix(file)) if file is not None else ()
            yield Expected(Run(scene, old.steps, old.commands), f"the commands of {where}", "command", said)


def _earlier_recordings(recording: Recording) -> Iterator[tuple[str, RecordingFields]]:
    """The file as it stands, for a test may do something else, and earlier versions with the same fingerprints."""
    path = recording.source
    if path is None:
        return
    texts = ((f"{path.name} of revision {revision}", text) for revision, text in earlier_texts(path))
    for where, text in chain([(f"{path.name} as it stands", path.read_text(encoding="utf-8"))], texts):
        if recording.digest not in text:  # reading all that cannot be it would take seconds
            continue
        try:
            old = loads_recording(text, path)
        except SandboxError:
            continue
        if old.digests == recording.digests:
            yield where, old


def gives(run: Run, recording: Recording, parted: int) -> bool:
    """Whether a run has the recorded fingerprints up to and past step `parted`."""
    stepper = RunStepper(run.scene, run.commands)
    try:
        for wanted in recording.digests[: parted + _PAST]:
            stepper.advance()
            if fingerprint(stepper.world.state) != wanted:
                return False
    except SandboxError:
        return False
    return True

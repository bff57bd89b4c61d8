"""Why a run is not as recorded: the number that differs, and what was changed since."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from sandbox.errors import SandboxError
from sandbox.replay.causes.engine_since import EngineChanges, engine_since
from sandbox.replay.causes.expected import Expected, candidates, gives
from sandbox.replay.causes.history import is_cut, is_kept
from sandbox.replay.golden.divergence import Cause, Divergence
from sandbox.replay.golden.rerun import Outcome
from sandbox.replay.golden.run import run_of
from sandbox.replay.golden.side_by_side import compare_after
from sandbox.replay.golden.source_location import posix
from sandbox.replay.recording.fingerprint import GROUPS
from sandbox.replay.recording.recording import Recording


def explained(recording: Recording, outcome: Outcome, tell: Callable[[str], None] | None = None) -> Outcome:
    """The same outcome, with the number and the cause in its divergence as far as they can be found out.

    `tell` hears what is being done. Raises `SceneError` if the scene cannot be used.
    """
    parted = outcome.divergence
    if parted is None:
        return _with_edits(recording, outcome) if outcome.edits else outcome
    if parted.group == "state":  # a snapshot that goes another way has no past
        return outcome
    if tell is not None:
        tell("looking for the cause")
    known = list(candidates(recording))
    expected = next((one for one in known if gives(one.run, recording, parted.step)), None)
    if expected is not None:
        cause = Cause(expected.kind, _said(expected), expected.origin)
        return replace(outcome, divergence=replace(_with_number(recording, expected, parted), cause=cause))
    cause = _without_run(recording, outcome, known)
    notes = tuple(note for note in outcome.notes if note not in cause.said)
    return replace(outcome, divergence=replace(parted, cause=cause), notes=notes)


def _with_edits(recording: Recording, outcome: Outcome) -> Outcome:
    """Edits of no consequence are told as well, if what was before is known."""
    said = next((one.said for one in candidates(recording) if one.kind == "scene"), ())
    return replace(outcome, notes=(*outcome.notes, *said))


def _with_number(recording: Recording, expected: Expected, parted: Divergence) -> Divergence:
    if parted.group not in (*GROUPS, "rest"):  # of a figure that left its tolerance no number is the first
        return parted
    try:
        return compare_after(expected.run, run_of(recording), parted)
    except SandboxError:  # both runs end at a command that is refused
        return parted


def _said(expected: Expected) -> tuple[str, ...]:
    return expected.said or (f"it was {expected.origin}",)


def _without_run(recording: Recording, outcome: Outcome, known: list[Expected]) -> Cause:
    """What can be said though the recorded run cannot be had again."""
    if outcome.edits:
        return _scene(recording, known)
    changes = engine_since(recording)
    more = (*_commands(recording), *changes.remarks, _how_to_see(recording, changes))
    if changes.said:
        return Cause("engine", (*changes.said, *more))
    return Cause("unknown", (f"the scene is as it was recorded; {changes.same}", *more))


def _how_to_see(recording: Recording, changes: EngineChanges) -> str:
    """The command that names the number."""
    path = posix(recording.source) if recording.source is not None else "FILE"
    revision = changes.revision or "REV --engine CHECKOUT"
    return f"for the first number that differs: sandbox replay {path} --against {revision}"


def _scene(recording: Recording, known: list[Expected]) -> Cause:
    if known:
        also = "with that undone the recorded steps do not come back either: the engine or a command is another as well"
        return Cause("scene", (*_said(known[0]), also))
    file = recording.scene.path or recording.source
    if file is None:
        return Cause("scene", ("how it was before is not known",))
    hint = f"with a copy of the earlier one: sandbox diff EARLIER.scene.json {posix(file)}"
    return Cause("scene", (f"how it was before is not known, for {_why(file)}", hint))


def _why(file: Path) -> str:
    if is_cut(file):
        return "git has only the latest revisions here: git fetch --unshallow (in GitHub Actions, fetch-depth: 0)"
    return "none of its versions in git is the recorded one" if is_kept(file) else "it is not kept in git"


def _commands(recording: Recording) -> list[str]:
    """A recording that git does not know may have been edited."""
    count = len(recording.commands)
    file = recording.source
    if not count or file is None or (is_kept(file) and not is_cut(file)):
        return []
    which = "its command" if count == 1 else f"one of its {count} commands"
    why = _why(file) if is_cut(file) else "the recording is not kept in git"
    return [f"whether {which} was edited is not known, for {why}"]

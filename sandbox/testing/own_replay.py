"""A run that a test has recorded, held against the recording beside the test file."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from sandbox.replay.causes.explain import explained
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.examine import Report, Update
from sandbox.replay.golden.rerun import Outcome, rerun
from sandbox.replay.golden.source_location import divergence_location
from sandbox.replay.recording.recording import Recording


def compare(made: Recording, path: Path, update: Update) -> Report:
    """The verdict of the usual judge, on the scene and the commands of the test; renews the recording if asked.

    Raises `RecordingError` if the recording cannot be used or written.
    """
    case = Case(path)
    if not path.is_file():
        report = Report(case, "missing", scene=f"what the test does ({made.steps} steps)")
        return _written(made, path, report) if update else report
    report = _judged(made, Recording.load(path), case)
    renew = update == "all" or (update == "changed" and not report.fine)
    return _written(made, path, report) if renew else report


def _judged(made: Recording, golden: Recording, case: Case) -> Report:
    source = replace(made.scene, meaning=golden.scene.meaning)
    commands = tuple(row for row in made.commands if row[0] <= golden.steps)
    tried = replace(golden, scene=source, commands=commands)
    outcome = explained(tried, _with_edits(rerun(tried), _edits(made, golden)))
    scene = str(made.scene.path or "")
    return Report(
        case, outcome.verdict, outcome, scene=scene, where=divergence_location(tried, outcome), recording=tried
    )


def _with_edits(outcome: Outcome, edits: tuple[str, ...]) -> Outcome:
    return replace(outcome, verdict="stale", edits=(*outcome.edits, *edits)) if edits else outcome


def _edits(made: Recording, golden: Recording) -> tuple[str, ...]:
    """In what the test does something else than when its recording was written."""
    found = [] if made.steps == golden.steps else [f"the test takes {made.steps} steps, not {golden.steps}"]
    if made.commands != golden.commands:
        pairs = zip(made.commands, golden.commands, strict=False)
        same = next(
            (n for n, (new, old) in enumerate(pairs) if new != old), min(map(len, (made.commands, golden.commands)))
        )
        found.append(f"command {same + 1} of the test was edited, added or taken away")
    return tuple(found)


def _written(made: Recording, path: Path, report: Report) -> Report:
    made.save(path)
    return replace(report, action="written")

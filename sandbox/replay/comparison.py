"""Holding a run against what is expected of it: its own recording, or another one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from sandbox.replay.causes.expected import expected_run
from sandbox.replay.causes.explain import explained
from sandbox.replay.golden.divergence import Divergence, Drift, ulps_between
from sandbox.replay.golden.rerun import rerun
from sandbox.replay.golden.run import Run, run_of
from sandbox.replay.golden.side_by_side import find_divergence
from sandbox.replay.golden.source_location import suspects
from sandbox.replay.golden.tolerance import drifts_of
from sandbox.replay.recording.meaning import meaning_of
from sandbox.replay.recording.recording import Recording
from sandbox.world.records import BODY

OnSteps = Callable[[int], None]
POSE = ("position_x", "position_y", "angle", "velocity_x", "velocity_y", "angular_velocity")
"""The fields of a body that are told whether they differ or not."""
_WORST, _MOST_EDITS = 10, 5


@dataclass(frozen=True)
class Comparison:
    """What came of it.

    `against` is the recording that says what is expected, `expected` the run that gives it, if it can be had, and
    `origin` where it was found. `divergence` is the first step that differs, None if none does. `drifts` are the bodies
    that end farthest off, `edits` what is otherwise in the scene of now, `notes` what else is to be known.
    """

    against: Recording
    divergence: Divergence | None = None
    expected: Run | None = None
    origin: str = ""
    drifts: tuple[Drift, ...] = ()
    edits: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def body(self) -> str | None:
        """The body that explains best why the runs part; None if no body is known to differ."""
        return next(iter(suspects(self.against, self.divergence, self.edits, self.drifts)), None)

    def where(self) -> list[str]:
        """Where the runs part, and the first number that differs, in words; empty if they do not."""
        return replace(self.divergence, cause=None).lines()[:2] if self.divergence is not None else []

    def lines(self) -> list[str]:
        """What was edited, why the runs part and what else is known, in words."""
        cause = self.divergence.cause if self.divergence is not None else None
        told = list(self.edits[:_MOST_EDITS])
        if len(self.edits) > _MOST_EDITS:
            told.append(f"and {len(self.edits) - _MOST_EDITS} more")
        return [*told, *(cause.lines() if cause is not None else ()), *self.notes]


def compare_with_recording(recording: Recording, on_steps: OnSteps | None = None) -> Comparison:
    """Run a recording again and hold it against its own fingerprints.

    Where they part, the recorded run is looked for, as an edited scene may be in git. Raises `SceneError`.
    """
    outcome = explained(recording, rerun(recording, on_steps=on_steps))
    parted = outcome.divergence
    if parted is None:
        return Comparison(
            recording, expected=run_of(recording), origin="the recording", edits=outcome.edits, notes=outcome.notes
        )
    found = expected_run(recording, parted.step)
    run, origin = (found.run, found.origin) if found is not None else (None, "")
    return Comparison(recording, parted, run, origin, outcome.drifts, outcome.edits, outcome.notes)


def compare_two(recording: Recording, other: Recording, on_steps: OnSteps | None = None) -> Comparison:
    """Hold the run of a recording against that of `other`, which says what is expected.

    Raises `SceneError`, and `CommandError` if both refuse the same command.
    """
    got, expected = run_of(recording), run_of(other)
    parted = find_divergence(expected, got, on_steps=on_steps)
    was, now = (meaning_of(one.load_scene().flatten()) for one in (other, recording))
    notes = [] if got.steps == expected.steps else [f"it has {expected.steps:,} steps, this one {got.steps:,}"]
    ended = drifts_of(other.final, recording.final) if parted is not None and got.steps == expected.steps else []
    name = other.source.name if other.source is not None else "the other recording"
    return Comparison(other, parted, expected, name, tuple(ended[:_WORST]), tuple(was.changes(now)), tuple(notes))


@dataclass(frozen=True)
class FieldRow:
    """A field of a body in both runs; None where the body is not there. `ulps` counts the floats in between."""

    field: str
    unit: str
    help: str
    expected: float | None
    got: float | None

    @property
    def difference(self) -> float | None:
        """Got less expected, in the unit of the field; None if the body is not in both."""
        return None if self.expected is None or self.got is None else self.got - self.expected

    @property
    def ulps(self) -> int:
        """How many floats lie between the two."""
        return 0 if self.expected is None or self.got is None else ulps_between(self.expected, self.got)


def field_rows(expected: Any, got: Any) -> list[FieldRow]:
    """The pose and velocity of a body's records in two runs, and whatever else differs in them; either may be None."""
    rows = []
    for field in BODY.fields:
        if field.name not in BODY.hashed_fields:
            continue
        old, new = (None if row is None else float(row[field.name]) for row in (expected, got))
        if field.name in POSE or (old is not None and new is not None and old != new):
            rows.append(FieldRow(field.name, field.unit, field.meaning, old, new))
    return rows

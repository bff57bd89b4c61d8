"""One case that did not pass, with all that a report shows of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sandbox.engine.world import World
from sandbox.replay.causes.expected import expected_run
from sandbox.replay.golden.examine import Report
from sandbox.replay.golden.run import Run, RunStepper, run_of
from sandbox.replay.recording.recording import Recording
from sandbox.report.film import Film
from sandbox.report.filming import MOST_POSES, film_run
from sandbox.report.pairs import Pair, first_pair, pair_at


@dataclass(frozen=True)
class Failure:
    """A run that is not as expected: its film `got`, and the `expected` one if that run could be had again.

    `origin` says where it was found. Without it, `ends` are the recorded places at the end. `parted` is the first step
    that differs. `pair` is the first that differs after it, or else the deepest contact of the body that ended farthest
    off.
    """

    recording: Recording | None
    parted: int
    got: Film
    expected: Film | None = None
    origin: str = ""
    ends: Film | None = None
    pair: Pair | None = None


def failure_of(report: Report, most: int = MOST_POSES) -> Failure | None:
    """The failure behind a report; None if the run did not part from its recording. Raises `SandboxError`."""
    outcome = report.outcome
    if report.fine or outcome is None or outcome.divergence is None:
        return None
    recording = report.recording or Recording.load(report.case.replay)
    got = run_of(recording)
    parted = outcome.divergence
    film = film_run(got, most=most)
    expected = expected_run(recording, parted.step)
    if expected is None:
        subject = outcome.drifts[0].body if outcome.drifts else ""
        pair = pair_at(got, min(parted.step, film.end), subject)
        return Failure(recording, parted.step, film, ends=_ends(film, recording, got), pair=pair)
    pair = first_pair(_stepper(got), _stepper(expected.run), parted)
    return Failure(recording, parted.step, film, film_run(expected.run, most=most), expected.origin, pair=pair)


def _stepper(run: Run) -> RunStepper:
    return RunStepper(run.scene, run.commands)


def _ends(film: Film, recording: Recording, run: Run) -> Film | None:
    """A film of one moment, the last of the recording; bodies of the scene only."""
    world = World(run.scene)
    local = {body.id: _center(world, row) for row, body in enumerate(world.flat.bodies)}
    known = [k for k, body in enumerate(film.bodies) if body.id in recording.final and body.id in local]
    if not known:
        return None
    poses = np.array([[_moved(recording.final[film.bodies[k].id], local[film.bodies[k].id])] for k in known])
    there = np.ones(poses.shape[:2], bool)
    return replace(
        film, start=film.end, end=film.end, bodies=tuple(film.bodies[k] for k in known), poses=poses, awake=there,
        frozen=~there, figures=film.figures[-1:], joints=(), held=np.zeros((0, 1), bool), fields=((0, [[], []]),),
        commands=(), cut="",
    )  # fmt: skip


def _center(world: World, row: int) -> tuple[float, float]:
    """A body's centre in its own frame."""
    body = world.state.bodies[row]
    x, y = float(body.center_x - body.position_x), float(body.center_y - body.position_y)
    c, s = float(body.rotation_cos), float(body.rotation_sin)
    return c * x + s * y, c * y - s * x


def _moved(pose: tuple[float, float, float], center: tuple[float, float]) -> tuple[float, float, float]:
    x, y, angle = pose
    c, s = np.cos(angle), np.sin(angle)
    return x + c * center[0] - s * center[1], y + s * center[0] + c * center[1], angle

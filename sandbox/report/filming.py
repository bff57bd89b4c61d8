"""Filming: a run from its scene, or what a world will do next."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.render.theme import DARK, Theme
from sandbox.replay.golden.run import Run, RunStepper, run_of
from sandbox.replay.recording.command_words import TimedCommand, encode
from sandbox.replay.recording.recording import Recording
from sandbox.report.film import Film
from sandbox.report.film_recorder import FilmRecorder
from sandbox.scene import Scene

MOST_POSES = 400_000
"""Poses of moving bodies in a film; of a longer one only every second step is kept, or every third, ..."""
_REPORT_EVERY = 16


def film_run(
    run: Run | Recording | Scene,
    *,
    skip: int = 0,
    most: int = MOST_POSES,
    on_steps: Callable[[int], None] | None = None,
    stepper: RunStepper | None = None,
    theme: Theme = DARK,
) -> Film:
    """Take a run and film it from step `skip` on; a command that is refused ends it, and the film's `cut` says why.

    `stepper` takes the run instead of a fresh world. `on_steps` hears now and then how many steps are done. Raises
    `SceneError` if the scene cannot be used.
    """
    known = run_of(run)
    stepper = stepper or RunStepper(known.scene, known.commands)
    while stepper.step < min(skip, known.steps):
        stepper.advance()
    recorder = FilmRecorder(stepper.world, known.steps, most, theme)
    cut = ""
    try:
        while stepper.step < known.steps:
            stepper.advance()
            recorder.record()
            if on_steps is not None and stepper.step % _REPORT_EVERY == 0:
                on_steps(stepper.step)
    except SandboxError as error:
        cut = f"ended after step {stepper.step}: {error}"
    return recorder.film(_told(known.commands), cut)


def film_ahead(world: World, steps: int, most: int = MOST_POSES) -> Film:
    """What the next steps of a world will be; they are taken by a copy."""
    copy = World(world.scene)
    copy.restore(world.snapshot())
    recorder = FilmRecorder(copy, copy.step_count + steps, most)
    for _ in range(steps):
        copy.step()
        recorder.record()
    return recorder.film((), "")


def _told(commands: Sequence[TimedCommand]) -> tuple[tuple[int, str], ...]:
    return tuple((step, _words(command)) for step, command in commands)


def _words(command: Any) -> str:
    name, fields = encode(command)
    target = next((str(fields[key]) for key in ("body", "joint", "region", "thruster") if key in fields), "")
    return f"{name} {target}".rstrip()

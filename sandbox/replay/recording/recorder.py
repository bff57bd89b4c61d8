"""Recording while a world runs."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from sandbox.arguments import check_callback, check_kind, checked_count
from sandbox.attributes import FixedAttributes
from sandbox.engine.commands.base import Command
from sandbox.engine.world import World
from sandbox.errors import Problem, RecordingError
from sandbox.replay.recording.command_words import TimedCommand, plain_command
from sandbox.replay.recording.meaning import meaning_of
from sandbox.replay.recording.recording import Recording
from sandbox.replay.recording.recording_fields import SceneSource
from sandbox.replay.recording.refusal import telling_refusal
from sandbox.replay.recording.script import checked_script
from sandbox.replay.recording.tape import Tape
from sandbox.scene import Scene, load_scene
from sandbox.scene.duration import planned_steps

_REPORT_EVERY = 16


class Recorder(FixedAttributes):
    """Stands between a user and a fresh `world`: what goes through `apply` and `step` can be replayed."""

    __slots__ = ("_commands", "_tape", "scene", "world")

    def __init__(self, world: World) -> None:
        check_kind("Recorder", "a World", world, World)
        if world.changes or world.step_count:
            raise RecordingError("the world", [Problem("has been stepped or changed: record it from its start")])
        if not isinstance(world.scene, Scene):
            raise RecordingError("the world", [Problem("was made of a flat scene: only a Scene can be recorded")])
        self.world = world
        self.scene: Scene = world.scene
        self._commands: list[TimedCommand] = []
        self._tape = Tape()

    def apply(self, command: Command) -> None:
        """Apply a command to the world, and note it if the world takes it."""
        command = plain_command(command)
        self.world.apply(command)
        self._commands.append((self.world.step_count, command))

    def step(self, n: int = 1) -> None:
        """Advance the world by `n` steps."""
        for _ in range(checked_count("Recorder.step", n)):
            self.world.step()
            self.note_step()

    def note_step(self) -> None:
        """Note the step that the world has just taken, for who steps it himself."""
        self._tape.note(self.world)

    def recording(self) -> Recording:
        """What was recorded up to now. Raises `RecordingError` if the world was changed past the recorder."""
        return recording_of(self.world, self._commands, self._tape)


def recording_of(world: World, commands: Iterable[TimedCommand], tape: Tape) -> Recording:
    """The recording of a run that has brought `world` of a `Scene` to where it is. Raises what `Tape.ended_by` does."""
    scene = world.scene
    assert isinstance(scene, Scene)
    digests, checkpoints = tape.ended_by(world)
    return Recording(
        scene=_source_of(scene),
        steps=len(digests),
        step_rate=scene.settings.step_rate,
        commands=tuple(commands),
        digests=digests,
        checkpoints=checkpoints,
        final=final_poses(world),
        digest=world.digest(),
    )


def final_poses(world: World) -> dict[str, tuple[float, float, float]]:
    """(x, y, angle) of every body, by id."""
    bodies = world.state.bodies
    rows = zip(bodies.position_x.tolist(), bodies.position_y.tolist(), bodies.angle.tolist(), strict=True)
    return dict(zip(world.names, rows, strict=True))


def record(
    scene: Scene | str | os.PathLike[str],
    steps: int | None = None,
    commands: Iterable[TimedCommand] = (),
    on_steps: Callable[[int], None] | None = None,
    workers: int = 1,
) -> Recording:
    """Run a scene (or the file of one) and record it.

    `commands` are (step, command): each comes after that many steps, those of one step in the given order. Without
    `steps`, the scene's own number. `on_steps` hears now and then how many are done; `workers` threads share a
    step, where that pays. Raises `RecordingError` for steps out of range, `RefusedCommandError` for a command that the
    world refuses, `SceneError` for a file that is no scene, and `ArgumentError`.
    """
    check_kind("record", "a Scene or the path of one", scene, Scene, str, os.PathLike)
    loaded = scene if isinstance(scene, Scene) else load_scene(Path(scene))
    total = planned_steps(loaded) if steps is None else checked_count("record", steps)
    check_callback("record", on_steps)
    script = _in_order(checked_script("record", commands), total)
    recorder = Recorder(World(loaded, workers))
    done = 0
    for step in range(total + 1):
        done = _apply_due(recorder, script, done)
        if step < total:
            recorder.step()
        if on_steps is not None and step % _REPORT_EVERY == 0:
            on_steps(step)
    return recorder.recording()


def _in_order(commands: Iterable[TimedCommand], total: int) -> list[tuple[int, TimedCommand]]:
    """The commands by their steps, each with its index as it was given."""
    script = sorted(enumerate(commands), key=lambda row: row[1][0])
    if script and (script[0][1][0] < 0 or script[-1][1][0] > total):
        raise RecordingError("the commands", [Problem(f"have steps that do not lie in 0 to {total}")])
    return script


def _apply_due(recorder: Recorder, script: Sequence[tuple[int, TimedCommand]], done: int) -> int:
    while done < len(script) and script[done][1][0] == recorder.world.step_count:
        index, (_, command) = script[done]
        with telling_refusal(index, command, recorder.world):
            recorder.apply(command)
        done += 1
    return done


def _source_of(scene: Scene) -> SceneSource:
    path = Path(scene.source) if scene.text is not None and Path(scene.source).is_file() else None
    return SceneSource(meaning_of(scene.flatten()), path.resolve() if path else None, scene, scene.set_values)

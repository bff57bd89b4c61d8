"""`sandbox record`: run a scene and keep what it did, for `sandbox replay`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox._atomic_write import check_writable
from sandbox._printable import told
from sandbox.cli.document import JSON, print_document
from sandbox.cli.options import SET, WORKERS, takes, values_set
from sandbox.cli.output import check_not_source
from sandbox.errors import RefusedCommandError, SandboxError
from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.replay.recording.recording import Recording

_SCENE = typer.Argument(metavar="SCENE", help="A scene file, or the name of one that comes with the package.")
_OUTPUT = typer.Option("-o", "--output", metavar="FILE", show_default=False, help="Where to write: NAME.replay.json.")
_STEPS = typer.Option(
    min=1, max=1_000_000, metavar="N", show_default=False, help="Steps to run instead of the scene's own number."
)
_COMMANDS = typer.Option(
    metavar="FILE", show_default=False, help='What to do to it: a JSON list of \\[step, "NAME", {...}], or a recording.'
)
_EMBED = typer.Option("--embed", help="Put the whole scene into the file instead of its path and hash.")
_FORCE = typer.Option("--force", help="Write over a file that is there.")


@dataclass(frozen=True)
class RecordOptions:
    """What `sandbox record` was asked for."""

    scene: Annotated[Path, _SCENE]
    output: Annotated[Path, _OUTPUT]
    steps: Annotated[int | None, _STEPS] = None
    commands: Annotated[Path | None, _COMMANDS] = None
    embed: Annotated[bool, _EMBED] = False
    force: Annotated[bool, _FORCE] = False
    set: Annotated[list[str] | None, SET] = None
    workers: Annotated[int, WORKERS] = 1
    json: Annotated[bool, JSON] = False


@takes(RecordOptions)
def record(options: RecordOptions) -> None:
    """Run a scene without a window and write down what it did: a test that `sandbox replay` runs again.

    Exit code 0: it was written.
    Exit code 2: a file could not be used, or there is one of that name already.
    """
    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.opening import open_any
    from sandbox.replay.recording.command_file import read_commands
    from sandbox.replay.recording.recorder import record as run
    from sandbox.scene.duration import planned_steps

    output = options.output
    file = find_scene(options.scene)
    _check_output(output, options.force, file)
    loaded = open_any(file, values_set(options.set))
    total = planned_steps(loaded) if options.steps is None else options.steps
    script = read_commands(options.commands, total) if options.commands is not None else None
    commands = script.commands if script is not None else ()
    announce_compilation()
    try:
        recording = _with_progress(file.name, total, lambda done: run(loaded, total, commands, done, options.workers))
    except RefusedCommandError as error:
        raise script.refused(error) if script is not None else error from None
    recording.save(output, True if options.embed else None, over=options.force)
    _tell(output, recording, options.json)


def _check_output(output: Path, force: bool, scene: Path) -> None:
    """Refuse at once what cannot be written, or should not be, before anything is run."""
    from sandbox.replay.recording.limits import SUFFIX

    if not output.name.endswith(SUFFIX):
        raise SandboxError(f"{told(output)}: recordings are named NAME{SUFFIX}, so that sandbox replay finds them")
    if os.path.lexists(output) and not force:
        mend = "--force writes over it, sandbox replay --update renews it with its own commands"
        raise SandboxError(f"{told(output)}: there is a file of that name already; {mend}")
    check_not_source(output, [scene])
    check_writable(output)


def _with_progress(name: str, total: int, run: Any) -> Recording:
    from rich.console import Console

    from sandbox.cli.progress import SceneProgress

    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin(name, total)
        recording: Recording = run(progress.done)
    return recording


def _tell(output: Path, recording: Recording, as_json: bool) -> None:
    count = len(recording.commands)
    facts = {"path": output.as_posix(), "steps": recording.steps, "commands": count, "digest": recording.digest}
    if as_json:
        print_document(facts)
    else:
        plural = "" if count == 1 else "s"
        print(f"{told(output)}: {recording.steps} steps, {count} command{plural}, digest {recording.digest}")
